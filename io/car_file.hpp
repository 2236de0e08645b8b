// What files say of a car, whatever their format.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "snug/car.hpp"

namespace snug {

/// A length under its name.
struct NamedLength {
    const char* name;
    double CarDimensions::*value;
};
inline constexpr NamedLength car_lengths[] = {{"width", &CarDimensions::width},
                                              {"front", &CarDimensions::front},
                                              {"rear", &CarDimensions::rear},
                                              {"wheelbase", &CarDimensions::wheelbase}};

/// The names under which the largest steering angle may be given: radians, degrees, metres, metres.
inline const std::vector<std::string> steerings = {"max_steer", "max_steer_deg", "turning_radius", "curb_to_curb"};

/// The largest steering angle [rad] given as `value` under one of those names, for a car whose lengths are possible.
/// Throws Error, beginning with `what`, when no car of these lengths steers so.
double steering_angle(const std::string& what, const std::string& name, double value, CarDimensions dimensions);

/// Throws Error, beginning with `what`, unless it can be the name of a car.
void check_name(const std::string& what, const std::string& name);

/// What a file says, but at most one byte more than `largest`. Throws Error, ending with what to do `instead`, when it
/// cannot be read.
std::string read_text(const std::string& path, std::size_t largest, const std::string& instead);

}  // namespace snug
