// snug park: from where the car stands into the slot, with the fewest direction changes.
#include "cli/park.hpp"

#include <chrono>
#include <numbers>

#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/way_out.hpp"
#include "sentences/check.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"
#include "snug/limits.hpp"
#include "snug/park_map.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "From where the car stands into a slot at a street, or into any place in a scene\n"
    "file, with the fewest direction changes over all maneuvers, with proof.";

constexpr const char* examples =
    "Lengths are in metres, angles in radians unless they are said to be degrees.\n\n"
    "What is proved holds for all maneuvers that keep the rear axle's middle in the\n"
    "region (of a street: --stretch and --road, from the curb on) and the heading\n"
    "within 80 degrees of the middle between the first heading and the parked one.\n\n"
    "Examples:\n"
    "  snug park --car renault-zoe --length 5.2 --width 2 --road 3.5\n"
    "  snug park --car renault-zoe --length 5 --width 2.5 --angle 90 --road 6\n"
    "  snug park --car opel-corsa --length 5 --width 2 --from 2,1.5,0 --draw way.svg\n"
    "  snug park --car renault-zoe --scene yard.json --waypoints way.csv\n"
    "  snug park --car renault-zoe --length 5.2 --width 2 --road 3.5 --view map \\\n"
    "      --draw street.svg\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot park; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given. Ctrl-C\n"
    "ends with the bounds found so far.";

/// The options of `snug park`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : where(options),
          search(options, "eight-hundredth"),
          steer(steer_option(options)),
          files(options),
          view(options.choice<ParkView>("--view", "VIEW",
                                        "What to draw: maneuver (default), or map: from where\nin the place how many "
                                        "changes are needed, at the\nheading of --from.",
                                        {{"maneuver", ParkView::maneuver}, {"map", ParkView::map}})) {}

    WhereOptions where;
    SearchOptions search;
    Option<Steer> steer;
    ParkFileOptions files;
    Option<ParkView> view;
};

/// Throws Error where an option is given that a scene file speaks of itself.
void refuse_beside_scene(const WhereOptions& asked) {
    const auto refuse = [&](const auto& option) {
        if (option)
            throw Error(option.name() + " describes a slot, but " + asked.scene.name() +
                        " gives the whole place; leave out one of them");
    };
    refuse(asked.bay.slot.length);
    refuse(asked.bay.slot.width);
    refuse(asked.bay.slot.extra_length);
    refuse(asked.bay.slot.extra_width);
    refuse(asked.bay.slot.side);
    refuse(asked.bay.slot.corner);
    refuse(asked.bay.slot.heading);
    refuse(asked.bay.street.angle);
    refuse(asked.bay.street.road);
    refuse(asked.bay.street.stretch);
    refuse(asked.bay.neighbours.front_setback);
    refuse(asked.bay.neighbours.rear_setback);
    refuse(asked.bay.neighbours.curb);
    refuse(asked.bay.neighbours.curb_clearance);
    refuse(asked.parked.heading);
    refuse(asked.parked.curb);
    refuse(asked.driving.enter);
}

std::string written(Format format, const ParkQuestion& question, const ParkAnswer& answer) {
    switch (format) {
        case Format::json: return park_json(question, answer);
        case Format::csv: return park_as_csv(question.scene.place, answer);
        case Format::text: break;
    }
    return park_text(question, answer);
}

std::string drawn_map(const PictureFile& picture, const ParkQuestion& question) {
    ParkMapOptions options;
    options.clearance = question.options.clearance;
    options.heading = question.street ? question.street->heading : question.scene.start.heading;
    options.progress = [] { return interruption() == 0; };
    const ParkMap map(question.car, question.scene.place, options);
    if (question.street) return draw_map(map, *question.street, question.scene.start, picture.format);
    return draw_map(map, question.scene, picture.format);
}

std::string drawn(const PictureFile& picture, const ParkQuestion& question, const ParkAnswer& answer) {
    PictureOptions options;
    options.driving.clearance = question.options.clearance;
    if (question.street)
        return draw_park(question.car, *question.street, question.scene.start, answer, picture.format, options);
    return draw_park(question.car, question.scene, answer, picture.format, options);
}

}  // namespace

Action parse_park(const Arguments& arguments) {
    Options options("snug park", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    ParkQuestion whole = asked.where.question();
    asked.search.limit(whole.options);
    ParkFiles files = asked.files.files(asked.files.output.format());
    refuse_without(asked.files.draw, asked.view);
    files.view = asked.view.value_or(files.view);
    return asked.steer.value_or(Steer::standing) == Steer::moving ? rolling_action(whole, files)
                                                                  : park_action(whole, files);
}

WhereOptions::WhereOptions(Options& options)
    : bay(options),
      parked(options),
      driving(options),
      scene(options.group("Any place")
                .text("--scene", "FILE",
                      "Obstacles, goal and start from a JSON file, or from\na .csv file of "
                      "the TPCAP benchmark: no slot then.")),
      from(options.group("Question")
               .declared<Pose>("--from", "X,Y,HEADING",
                               "Where the rear axle's middle stands, in the world\n[m, rad] (beside the front "
                               "neighbour; past a bay).",
                               pose)) {}

ParkQuestion WhereOptions::question() const {
    const Car car = bay.car.car();
    ParkOptions options;
    options.clearance = driving.clearance.value_or(0.0);
    if (scene) {
        refuse_beside_scene(*this);
        try {
            Scene place = read_scene(*scene);
            if (from) place.start = *from;
            return {car, std::move(place), std::nullopt, options};
        } catch (const Error& error) {
            throw Error(scene.name() + ": " + error.what());
        }
    }
    if (!bay.slot.length && !bay.slot.extra_length)
        throw Error("no place is given; give a slot with --length and --width, or a file with --scene");
    Street street = bay.bay(car, driving.driving(bay.neighbours));
    street.parked = parked.parked();
    const Pose start = from ? *from : standard_start(street, car);
    return {car, {street_place(street), start}, street, options};
}

Option<Steer> steer_option(Options& options) {
    return options.choice<Steer>("--steer", "STEER",
                                 "standing (default), or moving: the steering turns only\nwhile the car rolls, which "
                                 "may take more changes.",
                                 {{"standing", Steer::standing}, {"moving", Steer::moving}});
}

SearchOptions::SearchOptions(Options& options, const std::string& finest)
    : max_changes(options.whole_number("--max-changes", "N", "At most that many direction changes (200).", 0,
                                       limits::most_changes_fewest)),
      resolution(resolution_option(options, finest, "Finest")),
      time_limit(time_limit_option(options, "End")),
      threads(threads_option(options, " (all cores)")) {}

ParkFileOptions::ParkFileOptions(Options& options)
    : output(options), draw(draw_option(options)), waypoints(options), trajectory(options) {}

ParkFiles ParkFileOptions::files(Format format) const {
    ParkFiles files;
    files.format = format;
    files.picture = picture_file(draw, output);
    files.route = waypoints_file(waypoints, draw, output.file);
    files.timed = trajectory_file(trajectory, waypoints.file, draw, output.file);
    files.path = output.path();
    return files;
}

Action rolling_action(const ParkQuestion& question, const ParkFiles& files) {
    return [question, files] {
        RollingOptions options;
        options.clearance = question.options.clearance;
        options.spacing = question.options.resolution;
        options.max_changes = question.options.max_changes;
        if (files.timed) options.steering_rate = files.timed->limits.steering_rate;
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(question.options.time_limit);
        options.progress = [&] { return interruption() == 0 && std::chrono::steady_clock::now() < end; };
        RollingAnswer answer;
        {
            const Interruptible interruptible;
            answer = park_rolling(question.car, question.scene.place, question.scene.start, options);
        }
        const std::optional<Maneuver> arcs = answer.maneuver ? std::optional(answer.maneuver->in_arcs()) : std::nullopt;
        if (files.route) write_file("--waypoints", files.route->path, written(*files.route, arcs));
        if (files.timed) {
            const RollingManeuver way = answer.maneuver.value_or(RollingManeuver{question.car, {}});
            write_file("--trajectory", files.timed->path,
                       written(*files.timed, rolling_trajectory(way, files.timed->limits)));
        }
        if (files.picture) {
            ParkAnswer shown;
            shown.maneuver = arcs;
            if (arcs) shown.direction_changes = arcs->direction_changes();
            shown.lower_bound = answer.lower_bound;
            write_file("--draw", files.picture->path,
                       files.view == ParkView::map ? drawn_map(*files.picture, question)
                                                   : drawn(*files.picture, question, shown));
        }
        put_out(files.path, files.format == Format::json  ? park_json(question, answer)
                            : files.format == Format::csv ? park_as_csv(answer)
                                                          : park_text(question, answer));
        if (interruption() != 0) return interruption();
        return answer.maneuver ? 0 : 3;
    };
}

Action park_action(const ParkQuestion& question, const ParkFiles& files) {
    return [question, files] {
        ParkOptions options = question.options;
        const auto show = show_bounds();
        options.progress = [&](const ParkProgress& so_far) {
            if (show) show(so_far);
            return interruption() == 0;
        };
        ParkAnswer answer;
        {
            const Interruptible interruptible;
            answer = park(question.car, question.scene.place, question.scene.start, options);
        }
        if (show) wipe_progress();
        if (files.route) write_file("--waypoints", files.route->path, written(*files.route, answer.maneuver));
        if (files.timed)
            write_file("--trajectory", files.timed->path, written(*files.timed, question.car, answer.maneuver));
        if (files.picture)
            write_file("--draw", files.picture->path,
                       files.view == ParkView::map ? drawn_map(*files.picture, question)
                                                   : drawn(*files.picture, question, answer));
        std::string text = written(files.format, question, answer);
        if (files.format == Format::text && !answer.maneuver && interruption() == 0) text += way_out_text(question);
        put_out(files.path, text);
        return interruption() != 0 ? interruption() : exit_code(answer);
    };
}

}  // namespace snug::cli
