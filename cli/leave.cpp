// snug leave: with how few direction changes does a parked car get out, and how.
#include "snug/leave.hpp"

#include "cli/entry.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/park.hpp"
#include "cli/progress.hpp"
#include "cli/way_out.hpp"
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
    "road, along the street, as for snug park, whose reverse it is; so it is with\n"
    "--steer moving.\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot leave; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.";

/// The options of `snug leave`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : bay(options),
          gap_front(options.group("Where it is parked")
                        .number("--gap-front", "M", "From its foremost point to the front neighbour [m].", gap)),
          gap_curb(options.number("--gap-curb", "M", "From its point nearest the curb to the curb [m].", gap)),
          heading(options.number("--car-heading", "RAD",
                                 "Off parallel, positive with the nose away from the\ncurb [rad] (0).",
                                 {" rad", -1.2, 1.2})),
          from(options.declared<Pose>("--from", "X,Y,HEADING",
                                      "Or where the rear axle's middle stands, in the\nworld [m, rad].", pose)),
          driving(options),
          search(options.group("Question"), "ten-thousandth"),
          steer(steer_option(options)),
          files(options) {}

    static constexpr Quantity gap = {" m", 0.0, limits::longest};

    BayOptions bay;
    Option<double> gap_front;
    Option<double> gap_curb;
    Option<double> heading;
    Option<Pose> from;
    DrivingOptions driving;
    SearchOptions search;
    Option<Steer> steer;
    ParkFileOptions files;
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
    if (asked.bay.street.angle && *asked.bay.street.angle > 0.0)
        throw Error(asked.from.name() + " is missing; at an angle give the pose of the parked car as X,Y,HEADING");
    ParkedGaps gaps;
    gaps.front = needed(asked.gap_front);
    gaps.curb = needed(asked.gap_curb);
    gaps.heading = asked.heading.value_or(0.0);
    return parked_pose(car, slot, gaps);
}

}  // namespace

Action parse_leave(const Arguments& arguments) {
    Options options("snug leave", purpose, examples);
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    const Car car = asked.bay.car.car();
    const ParkFiles files =
        asked.files.files(asked.files.output.format_without_csv("csv has rows of ranges, but leave has none"));
    EntryQuestion question = {car, Slot(asked.bay.dimensions(car)), {}};
    question.options.driving = asked.driving.driving(asked.bay.neighbours);
    const Pose pose = parked(asked, car, question.slot);
    const StreetOptions& street = asked.bay.street;
    const bool moving = asked.steer.value_or(Steer::standing) == Steer::moving;
    if (street.angle || street.road || street.stretch || moving) {
        // Out of a bay in a street whose road and stretch are known, onto the road.
        const Street bay = asked.bay.bay(car, question.options.driving);
        ParkOptions in_street;
        in_street.clearance = question.options.driving.clearance;
        asked.search.limit(in_street);
        const ParkQuestion out = {car, {road_place(bay), pose}, bay, in_street, true};
        return moving ? rolling_action(out, files) : park_action(out, files);
    }
    FewestOptions limited;
    limited.driving = question.options.driving;
    asked.search.limit(limited);
    limited.progress = show_bounds();
    return [question, limited, pose, files] {
        const Answer answer = leave(question.car, question.slot, pose, limited);
        if (limited.progress) wipe_progress();
        if (files.route) write_file("--waypoints", files.route->path, written(*files.route, answer.maneuver));
        if (files.timed)
            write_file("--trajectory", files.timed->path, written(*files.timed, question.car, answer.maneuver));
        if (files.picture && answer.maneuver) {
            PictureOptions drawn;
            drawn.driving = limited.driving;
            drawn.leaving = true;
            write_file("--draw", files.picture->path,
                       draw_maneuver(question.slot, *answer.maneuver, files.picture->format, drawn));
        }
        std::string text =
            files.format == Format::json ? leave_json(question, answer) : leave_text(question, limited, answer);
        if (files.format == Format::text && !answer.maneuver) text += way_out_text(question, pose, limited);
        put_out(files.path, text);
        return exit_code(answer);
    };
}

}  // namespace snug::cli
