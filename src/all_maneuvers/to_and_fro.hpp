// A way out that takes no lattice: the nose turned out of the slot to and fro, at full steering. Seldom the best, but
// found in a fraction of a millisecond.
#pragma once

#include <vector>

#include "all_maneuvers/pieces.hpp"

namespace snug::detail {

/// A way out from the pose with at most so many changes; empty where turning to and fro leads nowhere.
std::vector<Move> to_and_fro(const Ground& ground, const Pose& start, int max_changes, const Watch& watch);

}  // namespace snug::detail
