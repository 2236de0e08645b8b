#include "cli/subcommands.hpp"

#include <algorithm>

#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/version.hpp"

namespace snug::cli {
namespace {

std::vector<std::string> names(const Subcommands& subcommands) {
    std::vector<std::string> all;
    for (const Command& command : subcommands.commands) all.emplace_back(command.name);
    return all;
}

std::string help(const Subcommands& subcommands) {
    const std::string snug = subcommands.name;
    std::string text = snug + ": " + subcommands.purpose + "\n\nUsage: " + snug + " COMMAND [options]\n\nCommands:\n";
    for (const Command& command : subcommands.commands) {
        std::string name = command.name;
        name.resize(10, ' ');
        text += "  " + name + command.purpose + '\n';
    }
    return text + "\n  " + snug + " COMMAND --help   options, units and examples of a command\n" + subcommands.rest;
}

}  // namespace

const Command* find(const Subcommands& subcommands, const std::string& name) {
    const auto found = std::find_if(subcommands.commands.begin(), subcommands.commands.end(),
                                    [&](const Command& command) { return command.name == name; });
    return found == subcommands.commands.end() ? nullptr : &*found;
}

Action choose(const Subcommands& subcommands, const Arguments& arguments) {
    const std::string instead = "write " + either(names(subcommands)) + ", or --help";
    if (arguments.empty()) throw Error("no command is given; " + instead);
    const std::string& word = arguments.front();
    if (const Command* command = find(subcommands, word))
        return command->parse(Arguments(arguments.begin() + 1, arguments.end()));
    std::vector<std::string> known = names(subcommands);
    known.insert(known.end(), {"--help", "--version"});
    if (arguments.size() == 1 && (word == "--help" || word == "-h")) return say(help(subcommands));
    if (arguments.size() == 1 && word == "--version") return say("snug " SNUG_VERSION "\n");
    if (std::find(known.begin(), known.end(), word) != known.end())
        throw Error(word + " stands alone, but " + in_quotes(arguments[1]) + " follows; leave that out");
    throw Error(in_quotes(word) + " is no command; " + did_you_mean(nearest_word(word, known), instead));
}

}  // namespace snug::cli
