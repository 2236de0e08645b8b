// Slots too short or too narrow for the parallel car, in which it can stand aslant.
#pragma once

#include <algorithm>
#include <cmath>

#include "random_cases.hpp"
#include "random_outlines.hpp"

namespace oracle {

/// Little larger than what the car takes at some heading.
inline Case aslant_case(std::uint64_t seed, std::uint64_t index) {
    Case chosen = index % 2 == 0 ? random_outline_case(seed, index) : random_case(seed, index);
    Random random(seed * 31337 + index);
    const bool slightly = index % 4 < 2;
    const double heading =
        (random.chance(0.5) ? 1 : -1) * (slightly ? random.between(0.0, 0.2) : random.between(0.5, 1.4));
    chosen.slot.front_setback = chosen.slot.rear_setback = 0.0;
    const Problem<double> problem = make_problem<double>(chosen);
    const Standing<double> standing({0.0, 0.0, heading});
    double left = 1e9, right = -1e9, low = 1e9, top = -1e9;
    for (const Vec<double>& corner : problem.body.corners) {
        left = std::min(left, standing.at(corner).x);
        right = std::max(right, standing.at(corner).x);
    }
    for (const Vec<double>& corner : problem.car.corners) top = std::max(top, standing.at(corner).y);
    for (const Vec<double>& corner : problem.at_curb.corners) low = std::min(low, standing.at(corner).y);
    chosen.slot.length = (right - left) * (1.0 + random.unit() * random.between(0.0, 0.3));
    chosen.slot.width = (top - low) * (1.0 + random.unit() * random.between(0.0, 0.3));
    chosen.kind = slightly ? "slightly aslant" : "aslant";
    return chosen;
}

}  // namespace oracle
