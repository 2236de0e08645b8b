// Problem 3 of the paper: how small may the slot be.
#pragma once

#include <functional>
#include <optional>

#include "snug/car.hpp"
#include "snug/max_steer.hpp"

namespace snug {

struct MinSlotOptions {
    int max_changes = 0;     ///< direction changes allowed, 0 to 100000
    double min_range = 0.0;  ///< headings must park over a stretch at least this wide [rad], 0 to pi/2
    Driving driving = {};
    Parked parked = {};    ///< what counts as parked
    double longest = 4.0;  ///< give up where even this much more than the car's length is too short [m]
    double widest = 4.0;   ///< likewise for the width [m]
};

/// A slot that is just large enough, and an entry heading from which the car parks in it.
struct MinSlot {
    double length = 0.0;         ///< [m]
    double width = 0.0;          ///< [m]
    double entry_heading = 0.0;  ///< [rad]

    friend bool operator==(const MinSlot&, const MinSlot&) = default;
};

/// The shortest slot of the given width [m] in which the car parks with full steering and at most `max_changes` direction
/// changes: the car parks in `length`, and in no shorter slot, to 1e-7 m, with dozens of changes to 1e-6 m. Empty when no
/// length will do. A longer slot can be harder for some cars (docs/min-slot.md): then lengths that park may have gaps, and
/// the shortest is found if they park over a hundredth of a metre or so.
/// Throws Error when an option is impossible.
std::optional<MinSlot> min_length(const Car& car, double width, const MinSlotOptions& options);

/// The narrowest slot of the given length [m], likewise.
std::optional<MinSlot> min_width(const Car& car, double length, const MinSlotOptions& options);

}  // namespace snug
