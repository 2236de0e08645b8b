// snug leave: with how few direction changes does a parked car get out, and how.
#include "snug/leave.hpp"

#include "cli/command.hpp"
#include "cli/entry.hpp"
#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/waypoints.hpp"
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
    "  snug leave --car renault-zoe --length 5 --width 2 --gap-front 0.3 --gap-curb 0.1\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot leave; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.";

/// The options of `snug leave`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : car(options),
          slot(options),
          neighbours(options),
          gap_front(options.group("Where it is parked")
                        .number("--gap-front", "M", "From its foremost point to the front neighbour [m].", gap)),
          gap_curb(options.number("--gap-curb", "M", "From its point nearest the curb to the curb [m].", gap)),
          heading(options.number("--car-heading", "RAD",
                                 "Off parallel, positive with the nose away from the\ncurb [rad] (0).",
                                 {" rad", -1.2, 1.2})),
          clearance(clearance_option(options.group("Driving"))),
          max_changes(options.group("Question")
                          .whole_number("--max-changes", "N", "At most that many direction changes (200).", 0,
                                        limits::most_changes_fewest)),
          resolution(resolution_option(options, "ten-thousandth")),
          time_limit(time_limit_option(options)),
          output(options),
          draw(draw_option(options)),
          waypoints(options) {}

    static constexpr Quantity gap = {" m", 0.0, limits::longest};

    CarOptions car;
    SlotOptions slot;
    NeighbourOptions neighbours;
    Option<double> gap_front;
    Option<double> gap_curb;
    Option<double> heading;
    Option<double> clearance;
    Option<int> max_changes;
    Option<double> resolution;
    Option<double> time_limit;
    OutputOptions output;
    Option<std::string> draw;
    WaypointsOptions waypoints;
};

double needed(const Option<double>& gap) {
    if (!gap) throw Error(gap.name() + " is missing; give it in metres");
    return *gap;
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
    limited.driving.clearance = asked.clearance.value_or(0.0);
    if (asked.neighbours.curb_clearance) limited.driving.curb_clearance = *asked.neighbours.curb_clearance;
    limited.resolution = asked.resolution.value_or(0.0);
    limited.time_limit = asked.time_limit.value_or(limited.time_limit);
    limited.progress = show_bounds();
    question.options.driving = limited.driving;
    ParkedGaps gaps;
    gaps.front = needed(asked.gap_front);
    gaps.curb = needed(asked.gap_curb);
    gaps.heading = asked.heading.value_or(0.0);
    const Format format = asked.output.format_without_csv("csv has rows of ranges, but leave has none");
    const std::optional<PictureFile> picture = picture_file(asked.draw, asked.output);
    const std::optional<WaypointsFile> route = waypoints_file(asked.waypoints, asked.draw, asked.output.file);
    return [question, limited, gaps, format, picture, route, path = asked.output.path()] {
        const Answer answer =
            leave(question.car, question.slot, parked_pose(question.car, question.slot, gaps), limited);
        if (limited.progress) wipe_progress();
        if (route) write_file("--waypoints", route->path, written(*route, answer.maneuver));
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
