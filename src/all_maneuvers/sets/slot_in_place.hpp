// The paper's slot in a place, whatever else stands there. Over an open road one number for each cell of the lattice is enough
// (lattice.hpp), so its cells can be much smaller than those of sets, and both bounds closer in slots that take many changes:
//   - from below, as what else stands there only stands in the way,
//   - from above, where the way out of the slot goes on to the start and meets nothing.
#pragma once

#include <optional>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "contact/place_contact.hpp"
#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/place.hpp"
#include "snug/slot.hpp"

namespace snug::detail::sets {

struct SlotInPlace {
    Car car;
    Slot slot;
    Driving driving;
    Parked parked;
    Pose start;  ///< in the world
    Chart chart;

    /// No maneuver from the start that stays in the chart has fewer changes than that. It looks no further than at `most`, and
    /// then says one more, and its lattices have at most so many cells.
    [[nodiscard]] int lower(int most, double most_cells, const Watch& watch) const;
    /// A way from the slot's mouth with at most so many changes, in the chart, whatever stands there; empty if none is found.
    [[nodiscard]] std::vector<Path> from_mouth(int most, const Watch& watch) const;
};

/// A way from the start that goes on as one from the mouth does, with at most so many changes; empty if none is found.
std::vector<Path> from_start(const ChartPlace& place, const std::vector<Path>& from_mouth, int most,
                             const Watch& watch);

/// If the car is to park in a rectangle, parallel to a curb behind it and beside a neighbour, both as long as the region.
std::optional<SlotInPlace> slot_in(const Car& car, const Place& place, const Pose& start, double clearance,
                                   const Chart& chart);

}  // namespace snug::detail::sets
