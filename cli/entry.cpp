// snug entry: from which headings can the car enter the slot, and how does it go on from there.
#include "cli/entry.hpp"

#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "cli/command.hpp"
#include "cli/numbers.hpp"
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

constexpr int most_changes = 100000;

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
    "  snug entry --car opel-corsa --length 4.6 --width 2 --max-changes 9\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot park; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.";

struct Picture {
    std::string path;
    PictureFormat format = PictureFormat::svg;
    bool entries = false;
};

std::optional<Picture> picture(const Options& options) {
    const std::string* path = options.typed("--draw");
    if (path == nullptr) {
        if (options.typed("--view") != nullptr) {
            throw Error("--view belongs to --draw; leave it out or give --draw FILE");
        }
        return std::nullopt;
    }
    const std::optional<PictureFormat> format = picture_format(*path);
    if (!format) {
        throw Error("--draw: " + in_quotes(*path) + " has no known extension; end it with .svg, .pdf or .png");
    }
    const std::string* output = options.typed("--output");
    if (output != nullptr && *output == *path) {
        throw Error("--draw and --output are the same file; give them different names");
    }
    check_writable("--draw", *path);
    return Picture{*path, *format, options.choice("--view", {"maneuver", "entries"}) == 1};
}

EntryOptions entry_options(const Options& options) {
    EntryOptions entry_options;
    if (const std::string* text = options.typed("--max-changes")) {
        entry_options.max_changes = whole_number("--max-changes", *text, 0, most_changes);
    }
    entry_options.min_range = options.number("--min-range", 0.0, 0.0, std::numbers::pi / 2.0, " rad");
    entry_options.driving.clearance = clearance(options);
    entry_options.driving.enter = enter(options);
    entry_options.strategy = strategy(options);
    const bool trials = std::holds_alternative<ReversedTrials>(entry_options.strategy) ||
                        std::holds_alternative<ParallelTrials>(entry_options.strategy);
    if (trials && options.typed("--min-range") != nullptr) {
        throw Error("--min-range asks for ranges of headings, but trials have none; leave it out or change --strategy");
    }
    if (std::holds_alternative<Stepping>(entry_options.strategy)) {
        entry_options.progress = show_progress();
    }
    return entry_options;
}

std::string drawn(const Picture& picture, const EntryQuestion& question, const Answer& answer) {
    const PictureOptions options = {question.options.driving};
    const auto draw = picture.entries
                          ? draw_entries
                          : static_cast<std::string (*)(const Car&, const Slot&, const Answer&, PictureFormat,
                                                        const PictureOptions&)>(draw_maneuver);
    return draw(question.car, question.slot, answer, picture.format, options);
}

std::string written(Format format, const EntryQuestion& question, const Answer& answer) {
    switch (format) {
        case Format::json: return write(as_json(question.car, question.slot, question.options, answer));
        case Format::csv: return entry_csv(answer);
        case Format::text: break;
    }
    return entry_text(question, answer);
}

/// --strategy fewest: another question, with a maneuver and no ranges of headings.
Action fewest_action(const Options& options, const EntryQuestion& question) {
    if (options.typed("--min-range") != nullptr)
        throw Error("--min-range asks for ranges of headings, but fewest has none; leave it out or change --strategy");
    FewestOptions asked = fewest_options(options);
    asked.progress = show_bounds();
    const Format chosen = format(options);
    if (chosen == Format::csv)
        throw Error("--format: csv lists ranges of headings, but fewest has none; write text or json");
    const std::optional<WaypointsFile> route = waypoints_file(options);
    return [question, asked, chosen, route, picture = picture(options), path = output(options)] {
        const Answer answer = fewest(question.car, question.slot, asked);
        if (asked.progress) wipe_progress();
        if (route) write_file("--waypoints", route->path, written(*route, answer.maneuver));
        if (picture) {
            Answer as_entry;
            as_entry.direction_changes = answer.direction_changes;
            as_entry.maneuver = answer.maneuver;
            write_file("--draw", picture->path, drawn(*picture, question, as_entry));
        }
        put_out(path, chosen == Format::json
                          ? write(as_json(question.car, question.slot, question.options.max_changes, answer))
                          : fewest_text(question, asked.max_changes, answer));
        return exit_code(answer);
    };
}

}  // namespace

std::string entry_csv(const Answer& answer) {
    std::string text = "heading_min,heading_max,direction_changes,subrange\n";
    for (const HeadingRange& range : answer.ranges) {
        text += write(range.min) + ',' + write(range.max) + ',' + std::to_string(range.direction_changes) + ',' +
                std::to_string(range.subrange) + '\n';
    }
    return text;
}

Action parse_entry(const Arguments& arguments) {
    Options options("snug entry", purpose, examples);
    add_car(options);
    add_slot(options);
    add_driving(options);
    options.group("Question");
    options.add("--max-changes", "N",
                "All headings with at most that many direction\nchanges, instead of the fewest up to 200.");
    options.add("--min-range", "RAD", "Leave out narrower stretches of headings [rad] (0).");
    add_strategy(options);
    add_output(options);
    options.add("--draw", "FILE", "Draw a picture: FILE ends with .svg, .pdf or .png.");
    options.add("--view", "VIEW", "What to draw: maneuver (default), or entries: all\nentry positions.");
    add_waypoints(options);
    add_threads(options);
    if (!options.read(arguments)) {
        return say(options.help());
    }
    const Car the_car = car(options);
    const EntryQuestion question = {the_car, slot(options, the_car), entry_options(options)};
    if (const std::string* name = options.typed("--strategy"); name != nullptr && *name == "fewest")
        return fewest_action(options, question);
    static_cast<void>(threads(options));  // one heading after the other is fast enough
    const std::optional<WaypointsFile> route = waypoints_file(options);
    return [question, route, picture = picture(options), format = format(options), path = output(options)] {
        const Answer answer = entry(question.car, question.slot, question.options);
        if (question.options.progress) {
            wipe_progress();
        }
        if (route) write_file("--waypoints", route->path, written(*route, answer.maneuver));
        if (picture && !answer.cancelled) {
            write_file("--draw", picture->path, drawn(*picture, question, answer));
        }
        put_out(path, written(format, question, answer));
        return answer.cancelled ? undecided : answer.parkable() ? solved : cannot_park;
    };
}

}  // namespace snug::cli
