// Which command is meant, and what becomes of errors.
#include "cli/command.hpp"

#include <exception>
#include <new>

#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/subcommands.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

const Subcommands subcommands = {
    "snug",
    "an exact solver for parallel parking",
    {
        {"entry", "From where to enter a slot, and what to do move by move.", parse_entry},
        {"min-slot", "How small a slot may be, for so many direction changes.", parse_min_slot},
        {"park", "From where the car stands into any slot, and what to do.", parse_park},
        {"leave", "How a parked car gets out with the fewest direction changes.", parse_leave},
        {"drive", "The plan of park, driven by a car that errs.", parse_drive},
        {"atlas", "Answers for many cars and slots, computed beforehand.", parse_atlas},
        {"cars", "The cars snug knows, and what a car file says.", parse_cars},
        {"paper", "The paper's figures and claims again, beside the exact answers.", parse_paper},
    },
    "  snug --version        the version\n\n"
    "Example:\n"
    "  snug entry --car renault-zoe --length 4.5 --width 2.0 --draw zoe.svg\n\n"
    "Exit codes: 0 solved; 1 understood, and the car cannot park; 2 bad input, with\n"
    "one line that says what is wrong; 3 undecided within the limits given.\n",
};

}  // namespace

namespace {

/// A text to print.
struct Say {
    std::string text;

    int operator()() const {
        print(text);
        return solved;
    }
};

/// Which commands have that option, going by their help texts: "snug park or snug leave"; empty when none has.
std::string commands_with(const std::string& option) {
    std::vector<std::string> found;
    if (option.size() < 4 || option.rfind("--", 0) != 0) return "";
    for (const Command& command : subcommands.commands) {
        const Action help = command.parse({"--help"});
        const Say* said = help.target<Say>();
        if (said != nullptr && said->text.find("  " + option + ' ') != said->text.npos)
            found.push_back("snug " + std::string(command.name));
    }
    return found.empty() ? "" : either(found);
}

}  // namespace

Action say(const std::string& text) { return Say{text}; }

Action parse(const Arguments& arguments) {
    try {
        return choose(subcommands, arguments);
    } catch (const UnknownOption& error) {
        const std::string elsewhere = commands_with(error.option);
        if (elsewhere.empty()) throw;
        throw Error("unknown option " + in_quotes(error.option) + ", which belongs to " + elsewhere +
                    "; leave it out here");
    }
}

int run(const Arguments& arguments) {
    std::string prefix = "snug: ";
    if (!arguments.empty() && find(subcommands, arguments.front()) != nullptr)
        prefix = "snug " + arguments.front() + ": ";
    return answered(prefix, [&] { return parse(arguments)(); });
}

int answered(const std::string& prefix, const Action& action) {
    try {
        return action();
    } catch (const std::bad_alloc&) {
        complain(prefix + "not enough memory for this question; ask for less at once");
    } catch (const std::exception& error) {
        complain(prefix + error.what());
    }
    return bad_input;
}

}  // namespace snug::cli
