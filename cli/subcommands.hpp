// Commands by name: of snug itself, and of a command that has commands of its own.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"

namespace snug::cli {

struct Command {
    const char* name;
    const char* purpose;  ///< a line
    Action (*parse)(const Arguments&);
};

struct Subcommands {
    const char* name;     ///< what is typed before the commands
    const char* purpose;  ///< a line
    std::vector<Command> commands;
    const char* rest;  ///< of the help text
};

/// The command of that name; null when there is none.
const Command* find(const Subcommands& subcommands, const std::string& name);

/// Understands the arguments after the subcommands's name. Throws Error when something is wrong with them.
Action choose(const Subcommands& subcommands, const Arguments& arguments);

}  // namespace snug::cli
