// snug leave: with how few direction changes does a parked car get out, and how.
#include "snug/leave.hpp"

#include <nlohmann/json.hpp>

#include "cli/command.hpp"
#include "cli/entry.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/waypoints.hpp"
#include "model/spelling.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

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

double gap(const Options& options, const std::string& option) {
    if (options.typed(option) == nullptr) throw Error(option + " is missing; give it in metres");
    return options.number(option, 0.0, 0.0, 1e6, " m");
}

}  // namespace

Action parse_leave(const Arguments& arguments) {
    Options options("snug leave", purpose, examples);
    add_car(options);
    add_slot(options);
    options.group("Where it is parked");
    options.add("--gap-front", "M", "From its foremost point to the front neighbour [m].");
    options.add("--gap-curb", "M", "From its point nearest the curb to the curb [m].");
    options.add("--car-heading", "RAD", "Off parallel, positive with the nose away from the\ncurb [rad] (0).");
    options.group("Driving");
    options.add("--clearance", "M", "Distance to keep from everything while driving\n[m] (0).");
    options.group("Question");
    options.add("--max-changes", "N", "At most that many direction changes (200).");
    add_fewest(options);
    add_output(options);
    options.add("--draw", "FILE", "Draw a picture: FILE ends with .svg, .pdf or .png.");
    add_waypoints(options);
    if (!options.read(arguments)) return say(options.help());
    const Car the_car = car(options);
    EntryQuestion question = {the_car, slot(options, the_car), {}};
    FewestOptions asked = fewest_options(options);
    question.options.driving.clearance = asked.driving.clearance;
    asked.progress = show_bounds();
    ParkedGaps gaps;
    gaps.front = gap(options, "--gap-front");
    gaps.curb = gap(options, "--gap-curb");
    gaps.heading = options.number("--car-heading", 0.0, -1.2, 1.2, " rad");
    const Format chosen = format(options);
    if (chosen == Format::csv) throw Error("--format: csv has rows of ranges, but leave has none; write text or json");
    std::string picture;
    std::optional<PictureFormat> picture_as;
    if (const std::string* file = options.typed("--draw")) {
        picture = *file;
        picture_as = picture_format(picture);
        if (!picture_as)
            throw Error("--draw: " + in_quotes(picture) + " has no known extension; end it with .svg, .pdf or .png");
        check_writable("--draw", picture);
    }
    const std::optional<WaypointsFile> route = waypoints_file(options);
    return [question, asked, gaps, chosen, picture, picture_as, route, path = output(options)] {
        const Answer answer = leave(question.car, question.slot, parked_pose(question.car, question.slot, gaps), asked);
        if (asked.progress) wipe_progress();
        if (route) write_file("--waypoints", route->path, written(*route, answer.maneuver));
        if (picture_as && answer.maneuver) {
            const PictureOptions drawn = {asked.driving};
            write_file("--draw", picture, draw_maneuver(question.slot, *answer.maneuver, *picture_as, drawn));
        }
        put_out(path, chosen == Format::json ? write(leave_as_json(question.car, question.slot, answer))
                                             : leave_text(question, asked.max_changes, answer));
        return exit_code(answer);
    };
}

}  // namespace snug::cli
