// From sets of y to a way to drive, from the very start, each step checked by exact contact.
#pragma once

#include <vector>

#include "all_maneuvers/sets/inner_sets.hpp"
#include "contact/place_contact.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

/// The sets of one alternation of moves, outward from the parked poses: the last one holds the start.
struct InnerChain {
    InnerSet parked;
    std::vector<InnerSet> reaches;
    Direction last = Direction::forward;  ///< of the last one, leaving

    /// Where move k begins to leave: at the parked poses, then where the move before leads.
    [[nodiscard]] const InnerSet& begins(std::size_t k) const { return k == 0 ? parked : reaches[k - 1]; }
    [[nodiscard]] Direction direction(std::size_t k) const {
        const bool same = (reaches.size() - 1 - k) % 2 == 0;
        return same == (last == Direction::forward) ? Direction::forward : Direction::backward;
    }
};

/// A way in the chart, as driven when parking, with pieces of constant steering for every step: through the middle of the
/// sets. It may meet something between the nodes.
std::vector<Path> way_by_steps(const InnerLattice& lattice, const InnerChain& chain, const ChartPlace& place);

/// Whether the car is parked at a pose that is free. Nothing is allocated.
bool is_parked(const ChartPlace& place, const Pose& pose);
/// Whether the car meets nothing at a pose. Nothing is allocated.
bool is_clear(const ChartPlace& place, const Pose& pose);
/// Whether a piece meets nothing and stays in the region.
bool is_free(const ChartPlace& place, const Path& piece);
/// Whether nothing is met, the region is not left and the car is parked at the end.
bool is_drivable(const ChartPlace& place, const std::vector<Path>& way);

}  // namespace snug::detail::sets
