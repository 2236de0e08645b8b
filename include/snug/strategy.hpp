// Strategy: over which maneuvers a question is asked.
#pragma once

#include <string_view>

#include "snug/version.hpp"

namespace snug {

enum class Strategy {
    max_steer,  ///< the paper's: full steering until contact
    fewest,     ///< all that the car can drive, with proof
};

/// "max-steer", "fewest"
std::string_view to_string(Strategy strategy);

}  // namespace snug
