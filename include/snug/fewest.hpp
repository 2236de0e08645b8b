// The fewest direction changes over all maneuvers a car can drive, with proof.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

/// How far a search has got.
struct FewestProgress {
    int lower_bound = 0;                   ///< proved so far
    std::optional<int> direction_changes;  ///< demonstrated so far
    double spacing = 0.0;                  ///< of the finest lattice finished [m]; 0 if none is
    double part = 0.0;                     ///< of the time limit gone, 0 to 1

    friend bool operator==(const FewestProgress&, const FewestProgress&) = default;
};

struct FewestOptions {
    int max_changes = 200;  ///< direction changes allowed, 0 to 1000
    Driving driving = {};
    Parked parked = {};  ///< what counts as parked; leave() takes the car as it stands
    /// Spacing of the finest lattice the bounds are computed on [m]; 0: a ten-thousandth of the car's length. Coarser ones
    /// are tried first, and the search ends where the bounds meet.
    double resolution = 0.0;
    double time_limit = std::numeric_limits<double>::infinity();  ///< ends with the bounds found so far [s]
    bool roomiest =
        true;  ///< look for a maneuver that ends well, the roomiest; otherwise any with that many changes will do
    /// Told from time to time; returning false ends with the bounds found so far.
    std::function<bool(const FewestProgress&)> progress = {};
};

/// The smallest number of direction changes with which the car can enter the slot, whatever way it is steered within its
/// limit and wherever it stops. The road is as wide as need be, and the first move goes backward. Nose first it goes
/// forward, and once the nose's corner on the curb side has crossed the entry side it stays in; otherwise stopping and
/// reversing in would answer the question. docs/fewest.md has the proof.
///
/// The maneuver has few arcs and straight lines with exact contacts. Of all with that many changes it is one that ends well, if the
/// lattices find one: parallel, then near the curb, then in the middle between the neighbours; and of those the roomiest, which
/// keeps the greatest distance from the neighbours and the curb. It begins with the corner of the frame at the slot's corner
/// wherever such a one is found, else above it.
/// Throws Error when an option is impossible, or when the resolution would take more than 2 GB of memory.
Answer fewest(const Car& car, const Slot& slot, const FewestOptions& options = {});

}  // namespace snug
