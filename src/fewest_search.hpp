// Both bounds on the number of direction changes for leaving the slot, on finer and finer lattices.
#pragma once

#include <optional>
#include <vector>

#include "fewest_path.hpp"

namespace snug::detail {

/// From where to leave, and how long to look. All in the entering frame.
struct LeavingQuestion {
    Ground ground;
    Problem problem;
    Enter enter = Enter::backward;
    Start start;
    Anchor anchor;
    int max_changes = 200;
    double resolution = 0.0;  ///< as asked for: 0 for the usual one [m]
};

/// What is known. It only ever gets better, so that it can be used whenever the search is given up.
struct LeavingBounds {
    int lower = 0;             ///< no way out has fewer
    std::optional<int> upper;  ///< as `moves` has
    std::vector<Move> moves;   ///< entering, in the entering frame; empty when the upper bound came from elsewhere
    double spacing = 0.0;      ///< of the finest lattice [m]

    [[nodiscard]] bool meet() const { return upper && *upper == lower; }
};

/// Narrows the bounds until they meet.
/// Throws GivenUp, and Error when the resolution asked for takes too much memory.
void narrow(const LeavingQuestion& question, LeavingBounds& bounds, const Watch& watch);

/// Replaces the moves by roomier ones with as many changes, if it finds some. Throws GivenUp.
void make_roomier(const LeavingQuestion& question, LeavingBounds& bounds, const Watch& watch);

}  // namespace snug::detail
