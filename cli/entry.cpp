// snug entry: from which headings can the car enter the slot, and how does it go on from there.
#include "cli/entry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/trajectory.hpp"
#include "cli/way_out.hpp"
#include "cli/waypoints.hpp"
#include "cli/words.hpp"
#include "io/csv.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"
#include "snug/start_tolerance.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "From where to enter a parallel parking slot with the fewest direction changes,\n"
    "how exactly, and what to do move by move.";

constexpr const char* examples =
    "Lengths are in metres, angles in radians. An entry heading is measured from the\n"
    "parallel heading; positive turns the nose (with --enter forward, the tail) away\n"
    "from the slot.\n\n"
    "Examples:\n"
    "  snug entry --car renault-zoe --length 4.5 --width 2.0\n"
    "  snug entry --car mid-size --extra-length 0.6 --extra-width 0.3 --side left\n"
    "  snug entry --car my-car.json --length 5 --width 2 --draw parking.svg\n"
    "  snug entry --car opel-corsa --length 4.6 --width 2 --max-changes 9\n"
    "  snug entry --car mid-size --length 5 --width 2 --strategy fewest --curb low\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot park; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.";

enum class View { maneuver, entries };

/// The options of `snug entry`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : car(options),
          slot(options),
          neighbours(options),
          parked(options),
          driving(options),
          max_changes(
              options.group("Question")
                  .whole_number(
                      "--max-changes", "N",
                      "All headings with at most that many direction\nchanges, instead of the fewest up to 200.", 0,
                      limits::most_changes)),
          min_range(options.number("--min-range", "RAD", "Leave out narrower ranges of headings [rad] (0).",
                                   {" rad", 0.0, limits::quarter_turn})),
          planner(options.group("Strategy")
                      .choice<Planner>(
                          "--strategy", "NAME",
                          "max-steer (default): full steering until contact,\nexactly; fewest: over all maneuvers, "
                          "with proof;\n"
                          "stepping: max-steer in small steps;\nreversed-trials, parallel-trials: from a goal, as\n"
                          "the planners the paper compares itself with.",
                          {{"max-steer", Planner::max_steer},
                           {"stepping", Planner::stepping},
                           {"reversed-trials", Planner::reversed_trials},
                           {"parallel-trials", Planner::parallel_trials},
                           {"fewest", Planner::fewest}})),
          resolution(resolution_option(options, "ten-thousandth")),
          time_limit(time_limit_option(options)),
          stepping(options),
          goal(options.declared<Pose>(
              "--goal", "X,Y,HEADING",
              "trials: where the rear axle ends up, in the world\n[m, rad] (reversed-trials: at the entry side "
              "and\nthe rear neighbour; parallel-trials: anywhere).",
              pose)),
          output(options),
          draw(draw_option(options)),
          view(options.choice<View>(
              "--view", "VIEW",
              "What to draw: maneuver (default), or entries: all\nentry positions. With --format csv what to write:\n"
              "entries (default), or maneuver: its moves.",
              {{"maneuver", View::maneuver}, {"entries", View::entries}})),
          waypoints(options),
          trajectory(options),
          threads(threads_option(options)) {}

    CarOptions car;
    SlotOptions slot;
    NeighbourOptions neighbours;
    ParkedOptions parked;
    DrivingOptions driving;
    Option<int> max_changes;
    Option<double> min_range;
    Option<Planner> planner;
    Option<double> resolution;
    Option<double> time_limit;
    SteppingOptions stepping;
    Option<Pose> goal;
    OutputOptions output;
    Option<std::string> draw;
    Option<View> view;
    WaypointsOptions waypoints;
    TrajectoryOptions trajectory;
    Option<int> threads;  ///< accepted for all commands alike: one heading after the other is fast enough
};

bool from_a_goal(Planner planner) { return planner == Planner::reversed_trials || planner == Planner::parallel_trials; }

/// The baseline asked for, if one is; each option is given only with its strategy.
std::optional<Baseline> baseline(const Asked& asked, Planner planner) {
    const Stepping stepping = asked.stepping.stepping(planner == Planner::stepping);
    belongs_to(asked.resolution, planner == Planner::fewest, "fewest");
    belongs_to(asked.time_limit, planner == Planner::fewest, "fewest");
    belongs_to(asked.goal, from_a_goal(planner), "reversed-trials or parallel-trials");
    const std::optional<Pose> goal = asked.goal ? std::optional<Pose>(*asked.goal) : std::nullopt;
    switch (planner) {
        case Planner::stepping: return stepping;
        case Planner::reversed_trials: return ReversedTrials{.goal = goal};
        case Planner::parallel_trials: return ParallelTrials{.goal = goal};
        case Planner::max_steer:
        case Planner::fewest: break;
    }
    return std::nullopt;
}

EntryQuestion question(const Asked& asked, Planner planner) {
    const Car car = asked.car.car();
    SlotDimensions slot = asked.slot.dimensions(car);
    asked.neighbours.describe(slot);
    refuse_for_baselines(planner, asked.neighbours, asked.parked);
    EntryOptions options;
    if (asked.max_changes) options.max_changes = *asked.max_changes;
    options.min_range = asked.min_range.value_or(0.0);
    options.prove = planner == Planner::max_steer;
    options.driving = asked.driving.driving(asked.neighbours);
    options.parked = asked.parked.parked();
    if (asked.min_range && (from_a_goal(planner) || planner == Planner::fewest))
        throw Error(asked.min_range.name() + " asks for ranges of headings, but " +
                    (planner == Planner::fewest ? "fewest has" : "trials have") +
                    " none; leave it out or change --strategy");
    if (planner == Planner::stepping) options.progress = show_progress();
    return {car, Slot(slot), options, baseline(asked, planner)};
}

std::string drawn(const PictureFile& picture, View view, const EntryQuestion& question, const Answer& answer) {
    const PictureOptions options = {question.options.driving};
    if (view == View::entries) return draw_entries(question.car, question.slot, answer, picture.format, options);
    return draw_maneuver(question.car, question.slot, answer, picture.format, options);
}

/// Where the strategy cannot park, what can; where it can, and a person reads the answer, whether other maneuvers have fewer
/// changes.
std::string written(Format format, std::optional<View> view, const EntryQuestion& question, const Answer& answer) {
    const bool no = !answer.cancelled && !answer.parkable();
    std::optional<StartTolerance> tolerance;
    if (!question.baseline && format != Format::csv)
        tolerance = start_tolerance(question.car, question.slot, answer, question.options);
    switch (format) {
        case Format::json: return entry_json(question, answer, no ? any_maneuver(question) : std::nullopt, tolerance);
        case Format::csv: return view == View::maneuver ? moves_csv(answer) : entry_csv(answer);
        case Format::text: break;
    }
    std::string text = entry_text(question, answer, tolerance);
    if (answer.cancelled) return text;
    if (no)
        return text + way_out_text(question, way_out(question, Strategy::max_steer,
                                                     question.options.max_changes.value_or(limits::usual_changes)));
    return text + fewer_text(*answer.direction_changes, any_maneuver(question));
}

/// Where all parts of an answer go.
struct Files {
    explicit Files(const Asked& asked)
        : route(waypoints_file(asked.waypoints, asked.draw, asked.output.file)),
          timed(trajectory_file(asked.trajectory, asked.waypoints.file, asked.draw, asked.output.file)),
          picture(picture_file(asked.draw, asked.output)),
          path(asked.output.path()) {
        if (asked.view) view = *asked.view;
        if (asked.output.format() != Format::csv) refuse_without(asked.draw, asked.view);
    }

    void write(const EntryQuestion& question, const Answer& answer, const std::string& text) const {
        if (route) write_file("--waypoints", route->path, cli::written(*route, answer.maneuver));
        if (timed) write_file("--trajectory", timed->path, cli::written(*timed, question.car, answer.maneuver));
        if (picture && !answer.cancelled)
            write_file("--draw", picture->path, drawn(*picture, view.value_or(View::maneuver), question, answer));
        put_out(path, text);
    }

    std::optional<WaypointsFile> route;
    std::optional<TrajectoryFile> timed;
    std::optional<PictureFile> picture;
    std::optional<View> view;
    std::string path;
};

/// What it takes to end parallel and near the curb, where the car ends otherwise; empty where it does, and under a limit of time.
std::string ending_better(const EntryQuestion& question, FewestOptions options, const Answer& answer) {
    constexpr double straight = std::numbers::pi / 180.0, near = 0.15;  // [rad] and [m]
    constexpr int more = 6;
    constexpr double coarse = 1e-3;  // of the car's length
    if (!answer.maneuver || options.time_limit < std::numeric_limits<double>::infinity()) return "";
    const Pose goal = answer.maneuver->goal();
    const double aslant = std::abs(std::remainder(question.slot.to_slot(goal).heading, 2.0 * std::numbers::pi));
    if (aslant <= straight && gaps(question.car, question.slot, goal).curb <= near + 1e-6) return "";
    options.max_changes = *answer.direction_changes + more;
    options.parked.heading = std::min(options.parked.heading, straight);
    options.parked.curb = std::min(options.parked.curb, near);
    options.resolution = std::max(options.resolution, coarse * question.car.length());
    options.roomiest = false;
    options.progress = nullptr;
    const std::string how = "\n(--parked-heading 1 --parked-curb 0.15).\n";
    const Answer better = fewest(question.car, question.slot, options);
    if (better.direction_changes == answer.direction_changes)
        return "\nWith as many it can end within 1 deg of parallel and " + metres(near) + " of the curb" + how;
    const std::string end = "\nTo end within 1 deg of parallel and " + metres(near) + " of the curb ";
    if (better.direction_changes && better.proved) return end + "takes " + changes(*better.direction_changes) + how;
    if (better.direction_changes) return end + "takes at most " + changes(*better.direction_changes) + how;
    return end + "takes more than " + changes(better.lower_bound - 1) + how;
}

/// --strategy fewest: another question, with a maneuver and no ranges of headings.
Action fewest_action(const Asked& asked, const EntryQuestion& question) {
    FewestOptions options;
    if (asked.max_changes) {
        check_between(asked.max_changes.name(), *asked.max_changes, 0.0, limits::most_changes_fewest, "");
        options.max_changes = *asked.max_changes;
    }
    options.driving = question.options.driving;
    options.parked = question.options.parked;
    options.resolution = asked.resolution.value_or(0.0);
    options.time_limit = asked.time_limit.value_or(options.time_limit);
    options.progress = show_bounds();
    const Format format = asked.output.format();
    return [question, options, format, files = Files(asked)] {
        const Answer answer = fewest(question.car, question.slot, options);
        if (options.progress) wipe_progress();
        std::string text;
        if (format == Format::json) {
            text = fewest_json(question, answer);
        } else if (format == Format::csv) {
            text = moves_csv(answer);
        } else {
            text = fewest_text(question, options.max_changes, answer) + ending_better(question, options, answer);
            if (!answer.maneuver && answer.proved)
                text += way_out_text(question, way_out(question, Strategy::fewest, options.max_changes));
        }
        files.write(question, answer, text);
        return exit_code(answer);
    };
}

}  // namespace

std::string entry_csv(const Answer& answer) {
    Csv csv({"heading_min", "heading_max", "direction_changes", "subrange"});
    for (const HeadingRange& range : answer.ranges)
        csv.row(range.min, range.max, range.direction_changes, range.subrange);
    return csv.text();
}

std::string moves_csv(const Answer& answer) {
    Csv csv({"direction", "steering_angle", "length", "start_x", "start_y", "start_heading", "end_x", "end_y",
             "end_heading", "contact_car", "contact_obstacle"});
    if (!answer.maneuver) return csv.text();
    for (const Move& move : answer.maneuver->moves) {
        std::optional<std::string> part, obstacle;
        if (move.contact) {
            part = to_string(move.contact->part);
            obstacle = to_string(move.contact->obstacle);
        }
        csv.row(to_string(move.direction), move.steering_angle, move.length, move.start.x, move.start.y,
                move.start.heading, move.end.x, move.end.y, move.end.heading, part, obstacle);
    }
    return csv.text();
}

Action parse_entry(const Arguments& arguments) {
    Options options("snug entry", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    const Planner planner = asked.planner.value_or(Planner::max_steer);
    const EntryQuestion whole = question(asked, planner);
    if (planner == Planner::fewest) return fewest_action(asked, whole);
    return [whole, format = asked.output.format(), files = Files(asked)] {
        const Answer answer = whole.baseline ? entry(whole.car, whole.slot, whole.options, *whole.baseline)
                                             : entry(whole.car, whole.slot, whole.options);
        if (whole.options.progress) wipe_progress();
        files.write(whole, answer, written(format, files.view, whole, answer));
        return answer.cancelled ? undecided : answer.parkable() ? solved : cannot_park;
    };
}

}  // namespace snug::cli
