// The command and its subcommands: arguments in, exit code out.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace snug::cli {

// Exit codes, as documented.
constexpr int solved = 0;
constexpr int cannot_park = 1;
constexpr int bad_input = 2;
constexpr int undecided = 3;

using Arguments = std::vector<std::string>;

/// What was asked for, understood and checked; calling it answers, with the exit code.
using Action = std::function<int()>;

/// Understands the arguments after `snug`, without answering yet. Throws Error when something is wrong with them.
Action parse(const Arguments& arguments);

// One per subcommand, for the arguments after its name.
Action parse_entry(const Arguments& arguments);
Action parse_min_slot(const Arguments& arguments);
Action parse_park(const Arguments& arguments);
Action parse_drive(const Arguments& arguments);
Action parse_leave(const Arguments& arguments);
Action parse_atlas(const Arguments& arguments);
Action parse_cars(const Arguments& arguments);
Action parse_paper(const Arguments& arguments);

/// Prints a text, as help does.
Action say(const std::string& text);

/// Understands and answers; whatever goes wrong is one line on standard error.
int run(const Arguments& arguments);

/// The exit code of an action; whatever goes wrong is one line that begins with the prefix.
int answered(const std::string& prefix, const Action& action);

}  // namespace snug::cli
