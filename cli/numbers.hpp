// Numbers as people type them on the command line: a list `a,b,c` of numbers and of ranges `from:to:step`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snug::cli {

/// What an option measures: its unit with a space (" m"), or empty for a whole number, and its limits.
struct Quantity {
    std::string_view unit;
    double low;
    double high;
};

// Each reads all of `text` or throws Error with one sentence that begins with the option. Numbers are plain decimals: no
// hexadecimals, no NaN, no infinity, and no units but an angle's, deg or rad. An angle without one that is too large but
// would do in degrees is told in radians.
double number(const std::string& option, const std::string& text, const Quantity& quantity);
int whole_number(const std::string& option, const std::string& text, int low, int high);

/// "a,b,c", each a number or "from:to:step" with both ends; a last step that would pass `to` ends there. At most ten
/// million numbers.
std::vector<double> numbers(const std::string& option, const std::string& text, const Quantity& quantity);

/// The parts of the text between the separators, empty ones too.
std::vector<std::string> split(const std::string& text, char at);

/// The position among the words of the one that was typed.
std::size_t choice(const std::string& option, const std::string& text, const std::vector<std::string>& words);

}  // namespace snug::cli
