// Numbers as people write them: lengths in a unit that suits the car, angles in degrees, counts with their word.
#pragma once

#include <string>
#include <string_view>

namespace snug::drawing {

/// A unit of length.
struct Unit {
    std::string_view name = "m";
    double metres = 1.0;
    int decimals = 2;  ///< for dimensions; paths get one more
};

/// The unit that suits things of the given size [m].
Unit unit_for(double size);
/// Fixed decimals, whatever the locale; far too large or small numbers in exponent form.
std::string number(double value, int decimals);
/// "4.50 m": at least the unit's decimals, one more where the value has it; a smaller unit for what would round to 0.
std::string length_label(double metres, const Unit& unit);
/// "4.50 m × 2.00 m"
std::string size_label(double length, double width, const Unit& unit);
/// "0.034 m": one decimal more than dimensions.
std::string path_label(double metres, const Unit& unit);
/// "27.86°"
std::string degrees_label(double radians, int decimals = 2);
/// "1 direction change", "18 direction changes"
std::string changes_label(int direction_changes);
/// The largest of 1, 2, 5, 10, ... [m] that is no longer than `metres`, and its label.
struct RoundLength {
    double metres = 1.0;
    std::string label;
};
RoundLength round_length(double metres);

}  // namespace snug::drawing
