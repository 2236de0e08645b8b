// Words that answers share.
#pragma once

#include <numbers>
#include <string>

#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/maneuver.hpp"

namespace snug::cli {

inline constexpr double degree = std::numbers::pi / 180.0;  // [rad]
inline constexpr double millimetre = 1e-3;                  // [m]

/// "no direction change", "1 direction change", "2 direction changes"
std::string changes(int count);

/// The car's name, or "The car".
std::string name(const Car& car);

/// "0.100 m too short and 0.020 m too narrow for the car with its clearance"; empty when nothing is lacking.
std::string words(const Shortfall& lacking, double clearance);

/// "full left", "right 12.5 deg", "straight"
std::string steering(const Car& car, double angle);

/// "1.250 m"
std::string metres(double length);

/// "9.300 m in all, in 31 s at up to 1 m/s; stands to steer 5 times": the way and the time, with the usual limits of motion.
std::string driven(const Maneuver& maneuver);

}  // namespace snug::cli
