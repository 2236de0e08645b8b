// Is a value within its limits? If not, the sentence a person can act on.
#pragma once

#include <locale>
#include <sstream>
#include <string>
#include <string_view>

#include "snug/error.hpp"

namespace snug {

/// A number as people write it, in any locale: 12 digits at most, no trailing zeros.
inline std::string spelled(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(12);
    text << value;
    return text.str();
}

/// Throws Error unless low <= value <= high; NaN lies nowhere. `what` reads as the start of a sentence ("car width"),
/// `unit` with its space (" m"), or empty for a count.
inline void check_between(std::string_view what, double value, double low, double high, std::string_view unit) {
    if (value >= low && value <= high) {
        return;
    }
    std::string sentence(what);
    sentence.append(" is ").append(spelled(value)).append(unit);
    sentence.append(", but must lie between ").append(spelled(low));
    sentence.append(" and ").append(spelled(high)).append(unit);
    throw Error(sentence);
}

}  // namespace snug
