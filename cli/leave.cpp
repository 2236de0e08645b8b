// snug leave: with how few direction changes does a parked car get out, and how.
#include "snug/leave.hpp"

#include "cli/entry.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/park.hpp"
#include "cli/progress.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "With how few direction changes a parked car gets out of its slot, over all\n"
    "maneuvers, with proof, and what to do move by move.";

constexpr const char* examples =
    "Lengths are in metres, angles in radians.\n\n"
    "Examples:\n"
    "  snug leave --car mid-size --length 5 --width 2 --gap-front 0.3 --gap-curb 0.1\n"
    "  snug leave --car renault-zoe --length 5 --width 2.5 --angle 90 --road 5 \\\n"
    "      --from -1.25,-4,1.5708\n\n"
    "On an open road the car is out when its corner is level with the slot's and the\n"
    "way on is free; with --angle, --road or --stretch when all of it stands on the\n"
    "road, along the street, as for snug park, whose reverse it is.\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot leave; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.";

/// The options of `snug leave`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : car(options),
          slot(options),
          street(options),
          neighbours(options),
          gap_front(options.group("Where it is parked")
                        .number("--gap-front", "M", "From its foremost point to the front neighbour [m].", gap)),
          gap_curb(options.number("--gap-curb", "M", "From its point nearest the curb to the curb [m].", gap)),
          heading(options.number("--car-heading", "RAD",
                                 "Off parallel, positive with the nose away from the\ncurb [rad] (0).",
                                 {" rad", -1.2, 1.2})),
          from(options.declared<Pose>("--from", "X,Y,HEADING",
                                      "Or where the rear axle's middle stands, in the\nworld [m, rad].", pose)),
          driving(options),
          max_changes(options.group("Question")
                          .whole_number("--max-changes", "N", "At most that many direction changes (200).", 0,
                                        limits::most_changes_fewest)),
          resolution(resolution_option(options, "ten-thousandth", "Finest")),
          time_limit(time_limit_option(options, "End")),
          output(options),
          draw(draw_option(options)),
          waypoints(options),
          trajectory(options) {}

    static constexpr Quantity gap = {" m", 0.0, limits::longest};

    CarOptions car;
    SlotOptions slot;
    StreetOptions street;
    NeighbourOptions neighbours;
    Option<double> gap_front;
    Option<double> gap_curb;
    Option<double> heading;
    Option<Pose> from;
    DrivingOptions driving;
    Option<int> max_changes;
    Option<double> resolution;
    Option<double> time_limit;
    OutputOptions output;
    Option<std::string> draw;
    WaypointsOptions waypoints;
    TrajectoryOptions trajectory;
};

double needed(const Option<double>& gap) {
    if (!gap) throw Error(gap.name() + " is missing; give it in metres");
    return *gap;
}

/// Where it is parked, by the gaps or by its pose.
Pose parked(const Asked& asked, const Car& car, const Slot& slot) {
    if (asked.from) {
        for (const Option<double>& gap : {asked.gap_front, asked.gap_curb, asked.heading})
            if (gap)
                throw Error(gap.name() + " and " + asked.from.name() +
                            " exclude each other; give the gaps or the pose");
        return *asked.from;
    }
    if (asked.street.angle && *asked.street.angle > 0.0)
        throw Error(asked.from.name() + " is missing; at an angle give the pose of the parked car as X,Y,HEADING");
    ParkedGaps gaps;
    gaps.front = needed(asked.gap_front);
    gaps.curb = needed(asked.gap_curb);
    gaps.heading = asked.heading.value_or(0.0);
    return parked_pose(car, slot, gaps);
}

/// Out of a bay in a street whose road and stretch are known.
Action leave_street(const Asked& asked, const Car& car, const SlotDimensions& slot, const Pose& pose,
                    const FewestOptions& limited, const ParkFiles& files) {
    Street street = asked.street.street(slot);
    street.enter = limited.driving.enter;
    street.curb_clearance = limited.driving.curb_clearance;
    ParkOptions options;
    options.max_changes = limited.max_changes;
    options.clearance = limited.driving.clearance;
    options.resolution = limited.resolution;
    options.time_limit = limited.time_limit;
    return park_action({car, {road_place(street), pose}, street, options, true}, files);
}

}  // namespace

Action parse_leave(const Arguments& arguments) {
    Options options("snug leave", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    const Car car = asked.car.car();
    SlotDimensions slot = asked.slot.dimensions(car);
    asked.neighbours.describe(slot);
    EntryQuestion question = {car, Slot(slot), {}};
    FewestOptions limited;
    limited.max_changes = asked.max_changes.value_or(limited.max_changes);
    limited.driving = asked.driving.driving(asked.neighbours);
    limited.resolution = asked.resolution.value_or(0.0);
    limited.time_limit = asked.time_limit.value_or(limited.time_limit);
    limited.progress = show_bounds();
    question.options.driving = limited.driving;
    const Pose pose = parked(asked, car, question.slot);
    const Format format = asked.output.format_without_csv("csv has rows of ranges, but leave has none");
    const std::optional<PictureFile> picture = picture_file(asked.draw, asked.output);
    const std::optional<WaypointsFile> route = waypoints_file(asked.waypoints, asked.draw, asked.output.file);
    const std::optional<TrajectoryFile> timed =
        trajectory_file(asked.trajectory, asked.waypoints.file, asked.draw, asked.output.file);
    if (asked.street.angle || asked.street.road || asked.street.stretch)
        return leave_street(asked, car, slot, pose, limited, {format, picture, route, timed, asked.output.path()});
    return [question, limited, pose, format, picture, route, timed, path = asked.output.path()] {
        const Answer answer = leave(question.car, question.slot, pose, limited);
        if (limited.progress) wipe_progress();
        if (route) write_file("--waypoints", route->path, written(*route, answer.maneuver));
        if (timed) write_file("--trajectory", timed->path, written(*timed, question.car, answer.maneuver));
        if (picture && answer.maneuver) {
            const PictureOptions drawn = {limited.driving};
            write_file("--draw", picture->path, draw_maneuver(question.slot, *answer.maneuver, picture->format, drawn));
        }
        put_out(path, format == Format::json ? leave_json(question, answer)
                                             : leave_text(question, limited.max_changes, answer));
        return exit_code(answer);
    };
}

}  // namespace snug::cli
