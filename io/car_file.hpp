// A car as somebody describes it, in a JSON file or a line of CSV: which keys there are, how they go together, and which
// values are a slip rather than a car. A Car by itself takes far odder ones, for whoever knows what they do.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/car.hpp"
#include "snug/error.hpp"

namespace snug {

/// The lengths a description may give [m]: width, front and rear, wheelbase, and what data sheets print beside it.
inline const std::vector<std::string> car_lengths = {"width",  "front",          "rear",         "wheelbase",
                                                     "length", "front_overhang", "rear_overhang"};

/// The names under which the largest steering angle may be given: radians, degrees, metres, metres, metres.
inline const std::vector<std::string> steerings = {"max_steer", "max_steer_deg", "turning_radius", "curb_to_curb",
                                                   "wall_to_wall"};

inline constexpr double degree = std::numbers::pi / 180.0;  // [rad]

/// What a key is measured in.
std::string unit_of(const std::string& key);

/// How sharp the corners of a rectangle are. [m]
struct CornerRadius {
    double front = 0.0;
    double rear = 0.0;
};

struct CarDescription {
    std::map<std::string, double> numbers;  ///< by the names of lengths and steerings
    std::optional<std::vector<Point>> outline;
    std::optional<CornerRadius> corner_radius;
    std::string name;

    [[nodiscard]] bool has(const std::string& key) const { return numbers.count(key) != 0; }
};

/// An Error about a key, whose sentence goes on with `what` ("is 7 m, but ..."); about the whole when there is no key.
using Complaint = std::function<Error(const std::string& key, const std::string& what)>;

/// The car described. Throws what `complaint` makes of whatever is missing, contradictory or no car.
Car described(const CarDescription& description, const Complaint& complaint);

/// Throws Error, beginning with `what`, unless it can be the name of a car.
void check_name(const std::string& what, const std::string& name);

/// What a file says, but at most one byte more than `largest`. Throws Error, ending with what to do `instead`, when it
/// cannot be read.
std::string read_text(const std::string& path, std::size_t largest, const std::string& instead);

}  // namespace snug
