// Which options were typed, and the cars, slots and strategies they stand for.
#include "cli/options.hpp"

#include <unistd.h>

#include <numbers>
#include <optional>

#include "cli/command.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "model/check.hpp"
#include "model/spelling.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr double shortest = 1e-6;  // [m], what a Slot accepts
constexpr double longest = 1e6;
constexpr double farthest = 1e9;
constexpr double full_turn = 6.2832;  // as people round it; larger angles are degrees, or mistakes
constexpr Quantity where = {" m", -farthest, farthest};
constexpr double quarter_turn = std::numbers::pi / 2.0;

/// The first argument that is no option of the app's, and what it could have been.
Error unknown(const CLI::App& app, const std::string& argument) {
    if (argument.size() < 2 || argument[0] != '-') {
        return Error("unexpected argument " + in_quotes(argument) + "; see " + app.get_name() + " --help");
    }
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    const std::string name = argument.substr(0, argument.find('='));
    return Error("unknown option " + in_quotes(name) + "; " +
                 did_you_mean(nearest_word(name, names), app.get_name() + " --help lists those there are"));
}

double side_of_slot(const Options& options, const std::string& name, double car_size) {
    const std::string direct = "--" + name;
    const std::string extra = "--extra-" + name;
    if (options.typed(direct) != nullptr && options.typed(extra) != nullptr) {
        throw Error(direct + " and " + extra + " exclude each other; give one of them");
    }
    if (options.typed(direct) != nullptr) {
        return options.number(direct, 0.0, shortest, longest, " m");
    }
    if (options.typed(extra) == nullptr) {
        throw Error(direct + " is missing; give " + direct + " or " + extra + " in metres");
    }
    return car_size + options.number(extra, 0.0, shortest - car_size, longest - car_size, " m");
}

std::optional<Pose> goal(const Options& options) {
    const std::string* text = options.typed("--goal");
    if (text == nullptr) return std::nullopt;
    const std::vector<std::string> parts = split(*text, ',');
    if (parts.size() != 3) {
        throw Error("--goal: " + in_quotes(*text) +
                    " is no pose; write X,Y,HEADING in metres and radians, for example -3.4,-0.9,0");
    }
    return Pose{number("--goal", parts[0], where), number("--goal", parts[1], where),
                number("--goal", parts[2], {" rad", -full_turn, full_turn})};
}

Point corner(const Options& options) {
    const std::string* text = options.typed("--corner");
    if (text == nullptr) {
        return {};
    }
    const std::vector<std::string> parts = split(*text, ',');
    if (parts.size() != 2) {
        throw Error("--corner: " + in_quotes(*text) + " is no point; write X,Y in metres, for example 12.5,-3");
    }
    return {number("--corner", parts[0], where), number("--corner", parts[1], where)};
}

}  // namespace

Options::Options(const std::string& command, const std::string& purpose, const std::string& examples)
    : app_(purpose + "\n", command) {
    app_.set_help_flag("-h,--help", "This text.");
    app_.footer(examples);
    app_.allow_extras();  // so that the sentence about them is ours
    app_.get_formatter()->column_width(26);
    app_.get_formatter()->label("OPTIONS", "options");
    app_.get_formatter()->label("Positionals", "Arguments");
}

void Options::add(const std::string& names, const std::string& value, const std::string& help) {
    const std::string key = names.substr(names.find("--"));
    const auto keep = [this, key](const CLI::results_t& results) {
        typed_[key] = results.front();
        return true;
    };
    app_.add_option(names, keep, help)->type_name(value)->group(group_);
}

void Options::add_argument(const std::string& name, const std::string& help) {
    const auto keep = [this, name](const CLI::results_t& results) {
        typed_[name] = results.front();
        return true;
    };
    app_.add_option(name, keep, help);
}

bool Options::read(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        if (argument.size() > 3 && argument.substr(0, 2) == "--" && argument.back() == '=') {
            throw Error(in_quotes(argument) + " gives no value; write it after the =");
        }
    }
    try {
        app_.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return false;
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string what = error.what();
        const std::string option = what.substr(0, what.find(':'));
        throw Error(option + (what.find("received") != what.npos
                                  ? " is given twice; give it once"
                                  : " needs a value; see " + app_.get_name() + " --help"));
    } catch (const CLI::ParseError& error) {
        throw Error(std::string(error.what()) + "; see " + app_.get_name() + " --help");
    }
    const std::vector<std::string> rest = app_.remaining();
    if (!rest.empty()) {
        throw unknown(app_, rest.front());
    }
    return true;
}

std::string Options::help() const {
    std::string text = app_.help();
    for (std::size_t gap = 0; (gap = text.find("\n\n\n", gap)) != text.npos;) {
        text.erase(gap, 1);
    }
    return text;
}

const std::string* Options::typed(const std::string& option) const {
    const auto found = typed_.find(option);
    return found == typed_.end() ? nullptr : &found->second;
}

double Options::number(const std::string& option, double otherwise, double low, double high,
                       std::string_view unit) const {
    const std::string* text = typed(option);
    return text == nullptr ? otherwise : cli::number(option, *text, {unit, low, high});
}

std::size_t Options::choice(const std::string& option, const std::vector<std::string>& words) const {
    const std::string* text = typed(option);
    return text == nullptr ? 0 : cli::choice(option, *text, words);
}

void add_car(Options& options) {
    options.group("Car");
    options.add("--car", "NAME|FILE", "A name that `snug cars` lists, or a JSON file\n(see snug cars --help).");
}

void add_slot(Options& options) {
    options.group("Slot");
    options.add("--length", "M", "Along the road, between the neighbours [m].");
    options.add("--width", "M", "From the road to the curb [m].");
    options.add("--extra-length", "M", "Length beyond the car's, instead of --length [m].");
    options.add("--extra-width", "M", "Width beyond the car's, instead of --width [m].");
    options.add("--side", "SIDE", "Side of the road: right (default) or left.");
    options.add("--corner", "X,Y", "Front corner at the road, in the world [m] (0,0).");
    options.add("--heading", "RAD", "Heading of a car parked parallel, in the world\n[rad] (0).");
}

void add_driving(Options& options) {
    options.group("Driving");
    options.add("--enter", "HOW", "backward (default), or forward: nose first.");
    options.add("--clearance", "M", "Distance to keep from everything while driving\n[m] (0).");
}

void add_strategy(Options& options) {
    options.group("Strategy");
    options.add("--strategy", "NAME",
                "max-steer (default): full steering until contact,\nexactly; fewest: over all maneuvers, with proof;\n"
                "stepping: max-steer in small steps;\nreversed-trials, parallel-trials: from a goal, as\n"
                "the planners the paper compares itself with.");
    add_fewest(options);
    options.add("--step", "M", "stepping: path of one step [m] (0.001).");
    options.add("--heading-step", "RAD", "stepping: between entry headings [rad] (0.0001).");
    options.add("--stop", "WHEN",
                "stepping: looks whether the car is parked on\ncontact (default), or after every step: inside.");
    options.add("--goal", "X,Y,HEADING",
                "trials: where the rear axle ends up, in the world\n[m, rad] (reversed-trials: at the entry side "
                "and\nthe rear neighbour; parallel-trials: anywhere).");
}

void add_fewest(Options& options) {
    options.add("--resolution", "M", "fewest: finest lattice [m] (a ten-thousandth of the\ncar's length).");
    options.add("--time-limit", "S", "fewest: end with the bounds found by then [s].");
}

void add_output(Options& options, const std::string& formats) {
    options.group("Output");
    options.add("--format", "FORMAT", formats);
    options.add("-o,--output", "FILE", "Write the answer there, whole or not at all.");
}

void add_threads(Options& options) { options.add("--threads", "N", "At most that many threads, 1 to 1024."); }

Car find_or_read_car(const std::string& name_or_file) {
    if (const std::optional<Car> known = find_car(name_or_file)) {
        return *known;
    }
    const bool is_file = name_or_file.find('/') != name_or_file.npos ||
                         (name_or_file.size() > 5 && name_or_file.substr(name_or_file.size() - 5) == ".json") ||
                         access(name_or_file.c_str(), F_OK) == 0;
    if (is_file) {
        return read_car(name_or_file);
    }
    throw Error(in_quotes(name_or_file) + " is no known car; " +
                did_you_mean(nearest_car_name(name_or_file),
                             "`snug cars` lists those there are, and a JSON file does as well"));
}

Car car(const Options& options) {
    const std::string* text = options.typed("--car");
    if (text == nullptr) {
        throw Error("--car is missing; give a name that `snug cars` lists, or a JSON file");
    }
    try {
        return find_or_read_car(*text);
    } catch (const Error& error) {
        throw Error(std::string("--car: ") + error.what());
    }
}

Slot slot(const Options& options, const Car& car) {
    SlotDimensions dimensions;
    dimensions.length = side_of_slot(options, "length", car.length());
    dimensions.width = side_of_slot(options, "width", car.width());
    dimensions.side = options.choice("--side", {"right", "left"}) == 0 ? Side::right : Side::left;
    dimensions.corner = corner(options);
    dimensions.heading = options.number("--heading", 0.0, -full_turn, full_turn, " rad");
    return Slot(dimensions);
}

double clearance(const Options& options) { return options.number("--clearance", 0.0, 0.0, longest, " m"); }

Enter enter(const Options& options) {
    return options.choice("--enter", {"backward", "forward"}) == 0 ? Enter::backward : Enter::forward;
}

Strategy strategy(const Options& options) {
    const std::size_t chosen =
        options.choice("--strategy", {"max-steer", "stepping", "reversed-trials", "parallel-trials", "fewest"});
    const auto belongs_to = [&options](const char* option, bool here, const char* strategies) {
        if (!here && options.typed(option) != nullptr)
            throw Error(std::string(option) + " belongs to --strategy " + strategies +
                        "; leave it out or give that strategy");
    };
    for (const char* option : {"--step", "--heading-step", "--stop"}) belongs_to(option, chosen == 1, "stepping");
    for (const char* option : {"--resolution", "--time-limit"}) belongs_to(option, chosen == 4, "fewest");
    belongs_to("--goal", chosen == 2 || chosen == 3, "reversed-trials or parallel-trials");
    if (chosen == 0 || chosen == 4) return MaxSteer{};
    if (chosen == 2) return ReversedTrials{.goal = goal(options)};
    if (chosen == 3) return ParallelTrials{.goal = goal(options)};
    Stepping stepping;
    stepping.step = options.number("--step", stepping.step, 1e-7, 1.0, " m");
    stepping.heading_step = options.number("--heading-step", stepping.heading_step, 1e-6, quarter_turn, " rad");
    stepping.stop = options.choice("--stop", {"contact", "inside"}) == 0 ? StopRule::contact : StopRule::inside;
    return stepping;
}

FewestOptions fewest_options(const Options& options) {
    FewestOptions fewest;
    if (const std::string* text = options.typed("--max-changes"))
        fewest.max_changes = whole_number("--max-changes", *text, 0, 1000);
    fewest.driving.clearance = clearance(options);
    fewest.driving.enter = options.typed("--enter") == nullptr ? Enter::backward : enter(options);
    fewest.resolution = options.number("--resolution", 0.0, 1e-9, longest, " m");
    fewest.time_limit = options.number("--time-limit", fewest.time_limit, 0.0, 1e9, " s");
    return fewest;
}

int exit_code(const Answer& answer) {
    return answer.direction_changes ? solved : answer.proved ? cannot_park : undecided;
}

Format format(const Options& options) {
    return static_cast<Format>(options.choice("--format", {"text", "json", "csv"}));
}

int threads(const Options& options) {
    const std::string* text = options.typed("--threads");
    return text == nullptr ? 1 : whole_number("--threads", *text, 1, 1024);
}

std::string output(const Options& options) {
    const std::string* path = options.typed("--output");
    if (path == nullptr) {
        return {};
    }
    check_writable("--output", *path);
    return *path;
}

}  // namespace snug::cli
