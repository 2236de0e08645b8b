// Problem 3 of the paper for every kind of bay: how narrow may the road be, how narrow or short the bay.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "snug/car.hpp"
#include "snug/place.hpp"

namespace snug {

/// Which dimension of a street is sought; the others are given.
enum class StreetSize { road, width, length };

struct MinStreetOptions {
    int max_changes = 0;  ///< direction changes allowed, 0 to 1000
    StreetSize sought = StreetSize::road;
    double clearance = 0.0;  ///< grows the frame for contacts [m]
    double largest =
        0.0;  ///< nothing larger is looked at [m]; 0: a road of 20 m, a bay 4 m wider or longer than the car
    double precision = 0.01;  ///< to which both sizes are found [m], as far as the resolution lets them
    double resolution = 0.0;  ///< spacing of the finest lattice [m]; 0: a two-hundredth of the car's length
    /// Told the part done (0 to 1) from time to time; returning false ends with what is known so far.
    std::function<bool(double)> progress = {};
};

/// A street that is just large enough, as far as it is known.
struct MinStreet {
    int max_changes = 0;         ///< as asked for
    std::optional<double> size;  ///< the car parks there; empty where nothing within the limits is found to do [m]
    double lower = 0.0;          ///< proved: in none smaller does it park [m]
    bool cancelled = false;      ///< given up by the progress callback: as far as it had come

    friend bool operator==(const MinStreet&, const MinStreet&) = default;
};

/// The smallest road, width or length (of which `street` need not tell) with which the car parks from standard_start() with at
/// most `max_changes` direction changes. What is claimed of maneuvers is what park() claims.
///
/// In a street of that size a maneuver was found, checked as park() checks its own. That none smaller than `lower` will do does not
/// rest on a smaller street being harder, for where the car starts may depend on the street: sizes are proved impossible by whole
/// ranges (docs/min-slot.md). Throws Error when an option is impossible, or where park() would.
MinStreet min_street(const Car& car, const Street& street, const MinStreetOptions& options = {});

/// The size that is sought, in a street.
std::optional<double> size_of(const Street& street, StreetSize which);
Street with_size(Street street, StreetSize which, double size);

/// "road", "width", "length"
std::string_view to_string(StreetSize sought);

}  // namespace snug
