// Numbers that tests of the model are written with.
#pragma once

#include <limits>
#include <numbers>

namespace model {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace model
