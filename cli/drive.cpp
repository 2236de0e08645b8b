// snug drive: the plan of `snug park` driven many times by a car that errs and looks again.
#include "cli/drive.hpp"

#include <limits>
#include <utility>

#include "cli/groups.hpp"
#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr const char* purpose =
    "The plan of `snug park` driven many times by a simulated car whose measurements\n"
    "and wheels err, and that looks again: how many runs park, with how many changes.";

constexpr const char* examples =
    "Errors are standard deviations. The car measures its pose every 5 cm on the way\n"
    "(1 cm beside something) and ten times a second at standstill, keeps to its move\n"
    "by small corrections of the steering, and plans anew where the direction changes.\n\n"
    "Examples:\n"
    "  snug drive --car renault-zoe --length 5.2 --width 2 --road 3.5 --from 2,1.75,0\n"
    "  snug drive --car renault-zoe --length 5 --width 2.5 --angle 90 --road 6 \\\n"
    "      --sensing 0.05,0.05,0.02 --runs 200 --draw tracks.svg\n\n"
    "Exit codes: 0 enough runs park; 1 too few, or no plan with a margin; 2 bad input,\n"
    "with one line that says what is wrong. Ctrl-C ends with the runs done so far.";

struct Asked {
    explicit Asked(Options& options)
        : where(options),
          sensing(options.group("Errors").declared<Pose>(
              "--sensing", "X,Y,HEADING", "Of every measured pose [m, m, rad] (0.02,0.02,0.0087).", pose)),
          bias(options.declared<Pose>("--bias", "X,Y,HEADING", "Added to every measured pose [m, m, rad] (0,0,0).",
                                      pose)),
          actuation(options.declared<Point>("--actuation", "M,RAD",
                                            "Of where a move ends, and of its steering angle\n[m, rad] (0.01,0.0175).",
                                            point)),
          lag(options.number("--lag", "S", "Of the wheels behind what they are told on the way\n[s] (0.1).",
                             {" s", 0.0, 10.0})),
          slot_error(options.declared<Point>("--slot-error", "AT,SIZE",
                                             "Of the slot's place and size, seen from the start\n"
                                             "[m, m] (0,0); they shrink as the car comes near.",
                                             point)),
          margin(options.group("Plan").number("--margin", "M",
                                              "How much the car is grown for planning [m]; default:\nof those that "
                                              "park often enough the one with the\nfewest changes.",
                                              {" m", 0.0, 10.0})),
          rate(options.number("--rate", "P", "Share of the runs that must park (0.999).", {"", 0.0, 1.0})),
          spacing(options.number("--resolution", "M", "Spacing of the map the car plans on [m] (0.08).",
                                 {" m", 0.001, 10.0})),
          steer(steer_option(options)),
          blind(options.choice<bool>("--look", "LOOK",
                                     "again (default), or once: the plan is driven to its\nend without looking again.",
                                     {{"again", false}, {"once", true}})),
          runs(options.group("Runs").whole_number("--runs", "N", "How many (1000).", 1, 1'000'000)),
          seed(options.whole_number("--seed", "N", "The same seed, the same runs (1).", 0,
                                    std::numeric_limits<int>::max())),
          threads(threads_option(options)),
          output(options),
          draw(draw_option(options)),
          trajectory(options) {}

    WhereOptions where;
    Option<Pose> sensing;
    Option<Pose> bias;
    Option<Point> actuation;
    Option<double> lag;
    Option<Point> slot_error;
    Option<double> margin;
    Option<double> rate;
    Option<double> spacing;
    Option<Steer> steer;
    Option<bool> blind;
    Option<int> runs;
    Option<int> seed;
    Option<int> threads;
    OutputOptions output;
    Option<std::string> draw;
    TrajectoryOptions trajectory;
};

DriveOptions drive_options(const Asked& asked) {
    DriveOptions options;
    options.errors.sensing = asked.sensing.value_or(options.errors.sensing);
    options.errors.bias = asked.bias.value_or(options.errors.bias);
    if (asked.actuation) {
        options.errors.distance = asked.actuation->x;
        options.errors.steering = asked.actuation->y;
    }
    options.errors.lag = asked.lag.value_or(options.errors.lag);
    if (asked.slot_error) {
        options.errors.slot_place = asked.slot_error->x;
        options.errors.slot_size = asked.slot_error->y;
    }
    if (asked.margin) options.margin = *asked.margin;
    options.rate = asked.rate.value_or(options.rate);
    options.spacing = asked.spacing.value_or(0.0);
    options.blind = asked.blind.value_or(false);
    options.steer = asked.steer.value_or(Steer::standing);
    options.runs = asked.runs.value_or(options.runs);
    options.seed = static_cast<std::uint64_t>(asked.seed.value_or(1));
    options.threads = asked.threads.value_or(0);
    return options;
}

std::string drawn(const PictureFile& picture, const ParkQuestion& question, const DriveAnswer& answer) {
    PictureOptions options;
    options.driving.clearance = answer.margin;
    for (const DriveRun& run : answer.runs) options.tracks.push_back(run.track);
    if (question.street)
        return draw_park(question.car, *question.street, question.scene.start, answer.plan(), picture.format, options);
    return draw_park(question.car, question.scene, answer.plan(), picture.format, options);
}

bool enough(const DriveOptions& options, const DriveAnswer& answer) {
    return answer.plannable && !answer.runs.empty() &&
           answer.parked() >= options.rate * static_cast<double>(answer.runs.size());
}

/// How often the wheels turn at standstill.
Rows how_often_it_stands(const DriveOptions& options, const DriveAnswer& answer, const DriveTotals& all) {
    Rows rows = {{"steered", "at standstill " + fixed(all.mean_standing_steers, 2) + " times on average, at most " +
                                 std::to_string(all.most_standing_steers)}};
    if (options.steer == Steer::standing || !answer.rolling) return rows;
    const std::size_t needed = answer.rolling->standing_steers().size();
    const int more = answer.planned_changes - answer.standing_changes.value_or(answer.planned_changes);
    rows.push_back({"", needed > 0 ? "planned " + std::to_string(needed) + " times: no way was found without"
                        : more > 0 ? "planned never, with " + changes(more) + " more than with it"
                                   : "planned never, with no more direction changes than with it"});
    return rows;
}

}  // namespace

std::string drive_text(const ParkQuestion& question, const DriveOptions& options, const DriveAnswer& answer) {
    const std::string car = name(question.car);
    if (!answer.plannable)
        return car + " has no way into the place that keeps " +
               (options.margin ? "a margin of " + metres(*options.margin) : "even 1 cm from everything") +
               ".\nWhether and how it parks without a margin: snug park with the same car and place.\n";
    if (answer.runs.empty()) return "No run was finished.\n";
    const DriveTotals all = answer.totals();
    const double planned = answer.planned ? answer.planned_trajectory(options.limits).seconds() : 0.0;
    Rows rows = {
        {"margin",
         metres(answer.margin) + (options.margin            ? ""
                                  : enough(options, answer) ? ", of those that do the one with the fewest changes"
                                                            : ", the one that fails least")},
        {"planned", changes(answer.planned_changes) + ", " + fixed(planned, 0) + " s"},
        {"driven", fixed(all.mean_changes, 2) + " direction changes on average, at most " +
                       std::to_string(all.most_changes) + ","},
        {"", "in " + fixed(all.mean_seconds, 0) + " s on average, at most " + fixed(all.most_seconds, 0) + " s"}};
    for (std::vector<std::string>& row : how_often_it_stands(options, answer, all)) rows.push_back(std::move(row));
    rows.push_back({"bound", answer.lower_bound == 0
                                 ? "none: without a direction change it may be possible"
                                 : "no plan with this margin has fewer than " + changes(answer.lower_bound)});
    rows.push_back({"nearest", all.smallest_distance < 0.0
                                   ? "in contact"
                                   : metres(all.smallest_distance) + " to anything in all runs"});
    return car + " parks in " + std::to_string(answer.parked()) + " of " + std::to_string(answer.runs.size()) +
           " runs" + (answer.contacts() > 0 ? ", touches something in " + std::to_string(answer.contacts()) : "") +
           ".\n\n" + table(rows, "ll");
}

Action parse_drive(const Arguments& arguments) {
    Options options("snug drive", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    const ParkQuestion question = asked.where.question();
    if (asked.where.driving.clearance)
        throw Error(asked.where.driving.clearance.name() + " is of a plan that nobody disturbs; give --margin instead");
    if (asked.slot_error && !question.street)
        throw Error(asked.slot_error.name() + " is of a slot, but " + asked.where.scene.name() +
                    " gives a place without one; leave out one of them");
    const DriveOptions how = drive_options(asked);
    const Format format = asked.output.format();
    const auto picture = picture_file(asked.draw, asked.output);
    const auto timed = trajectory_file(asked.trajectory, asked.draw, asked.draw, asked.output.file);
    return [question, how, format, picture, timed, path = asked.output.path()] {
        DriveOptions asked_of = how;
        if (timed) asked_of.limits = timed->limits;
        const auto show = show_progress();
        asked_of.progress = [&](double, int runs) {
            if (show) show(static_cast<double>(runs) / asked_of.runs);
            return interruption() == 0;
        };
        DriveAnswer answer;
        {
            const Interruptible interruptible;
            const Pose& start = question.scene.start;
            answer = question.street ? drive_runs(question.car, *question.street, start, asked_of)
                                     : drive_runs(question.car, question.scene.place, start, asked_of);
        }
        if (show) wipe_progress();
        if (timed)
            write_file("--trajectory", timed->path,
                       answer.planned ? written(*timed, answer.planned_trajectory(timed->limits))
                                      : written(*timed, question.car, std::nullopt));
        if (picture) write_file("--draw", picture->path, drawn(*picture, question, answer));
        put_out(path, format == Format::json  ? drive_json(question, asked_of, answer)
                      : format == Format::csv ? drive_as_csv(answer)
                                              : drive_text(question, asked_of, answer));
        if (interruption() != 0) return interruption();
        return enough(asked_of, answer) ? 0 : 1;
    };
}

}  // namespace snug::cli
