// The stops of a maneuver: what is numbered in the picture and in the table.
#pragma once

#include <string>
#include <vector>

#include "snug/maneuver.hpp"

namespace snug::drawing {

/// One move in the picture. Moves of one direction share a number; pieces of it are 3a, 3b, ...
struct Leg {
    const Move* move = nullptr;
    int number = 1;
    std::string label;          ///< "3", or "3a"
    bool turns_at_end = false;  ///< the direction changes where the move ends
};

std::vector<Leg> legs_of(const Maneuver& maneuver);

}  // namespace snug::drawing
