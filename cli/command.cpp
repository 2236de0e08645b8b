// Which subcommand is meant, and what becomes of errors.
#include "cli/command.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <new>

#include "cli/output.hpp"
#include "snug/error.hpp"
#include "snug/version.hpp"
#include "spelling.hpp"

namespace snug::cli {
namespace {

struct Subcommand {
    const char* name;
    const char* purpose;
    Action (*parse)(const Arguments&);
};

constexpr Subcommand subcommands[] = {
    {"entry", "From where to enter a slot, and what to do move by move.", parse_entry},
    {"min-slot", "How small a slot may be, for so many direction changes.", parse_min_slot},
    {"leave", "How a parked car gets out with the fewest direction changes.", parse_leave},
    {"cars", "The cars snug knows, and what a car file says.", parse_cars},
    {"paper", "The paper's figures and claims again, beside the exact answers.", parse_paper},
};

const Subcommand* find(const std::string& name) {
    const auto* found = std::find_if(std::begin(subcommands), std::end(subcommands),
                                     [&](const Subcommand& subcommand) { return subcommand.name == name; });
    return found == std::end(subcommands) ? nullptr : found;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Subcommand& subcommand : subcommands) {
        all.emplace_back(subcommand.name);
    }
    return all;
}

std::string help() {
    std::string text = "snug: an exact solver for parallel parking\n\nUsage: snug COMMAND [options]\n\nCommands:\n";
    for (const Subcommand& subcommand : subcommands) {
        std::string name = subcommand.name;
        name.resize(10, ' ');
        text += "  " + name + subcommand.purpose + '\n';
    }
    return text +
           "\n  snug COMMAND --help   options, units and examples of a command\n"
           "  snug --version        the version\n\n"
           "Example:\n"
           "  snug entry --car renault-zoe --length 4.5 --width 2.0 --draw zoe.svg\n\n"
           "Exit codes: 0 solved; 1 understood, and the car cannot park; 2 bad input, with\n"
           "one line that says what is wrong; 3 undecided within the limits given.\n";
}

}  // namespace

Action say(const std::string& text) {
    return [text] {
        print(text);
        return solved;
    };
}

Action parse(const Arguments& arguments) {
    if (arguments.empty()) {
        throw Error("no command is given; write " + either(names()) + ", or --help");
    }
    const std::string& word = arguments.front();
    if (const Subcommand* subcommand = find(word)) {
        return subcommand->parse(Arguments(arguments.begin() + 1, arguments.end()));
    }
    if (arguments.size() == 1 && (word == "--help" || word == "-h")) {
        return say(help());
    }
    if (arguments.size() == 1 && word == "--version") {
        return say("snug " SNUG_VERSION "\n");
    }
    std::vector<std::string> known = names();
    known.insert(known.end(), {"--help", "--version"});
    if (std::find(known.begin(), known.end(), word) != known.end()) {
        throw Error(word + " stands alone, but " + in_quotes(arguments[1]) + " follows; leave that out");
    }
    throw Error(in_quotes(word) + " is no command; " +
                did_you_mean(nearest_word(word, known), "write " + either(names()) + ", or --help"));
}

int run(const Arguments& arguments) {
    const bool known = !arguments.empty() && find(arguments.front()) != nullptr;
    const std::string prefix = known ? "snug " + arguments.front() + ": " : "snug: ";
    try {
        return parse(arguments)();
    } catch (const std::bad_alloc&) {
        complain(prefix + "not enough memory for this question; ask for less at once");
    } catch (const std::exception& error) {
        complain(prefix + error.what());
    }
    return bad_input;
}

}  // namespace snug::cli
