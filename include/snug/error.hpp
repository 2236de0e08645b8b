// The one exception of the library.
#pragma once

#include <stdexcept>

#include "snug/version.hpp"

namespace snug {

/// Thrown when a value cannot exist: an impossible car, slot or option. The message is one sentence that names the
/// value, says what is wrong with it and what would be right. Questions about valid values never throw.
class Error : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

}  // namespace snug
