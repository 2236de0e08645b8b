// Is a value within its limits? If not, the sentence a person can act on.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sentences/decimals.hpp"
#include "snug/error.hpp"

namespace snug {

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

/// Throws Error unless every entry heading lies in [0, pi/2]; names the first that does not by its index.
inline void check_headings(const std::vector<double>& headings) {
    for (std::size_t i = 0; i < headings.size(); ++i) {
        if (!(headings[i] >= 0.0 && headings[i] <= 1.5707963267948966)) {
            check_between("entry heading [" + std::to_string(i) + "]", headings[i], 0.0, 1.5707963267948966, " rad");
        }
    }
}

/// Throws Error unless every slot has its heading.
inline void check_as_many(std::size_t slots, std::size_t headings) {
    if (slots != headings)
        throw Error("there are " + std::to_string(slots) + " slots and " + std::to_string(headings) +
                    " headings, but there must be as many headings as slots");
}

}  // namespace snug
