// Both bounds on the number of direction changes for leaving the slot, on finer and finer lattices.
#pragma once

#include <optional>
#include <vector>

#include "fewest_path.hpp"
#include "snug/fewest.hpp"

namespace snug::detail {

/// From where to leave, and how closely to look. All in the entering frame.
struct LeavingQuestion {
    Ground ground;
    Problem problem;
    Start start;
    Anchor anchor = {};
    int max_changes = 200;
    double resolution = 0.0;         ///< as asked for; 0 for the usual one [m]
    Finish finish = Finish::at_p;    ///< what is made of the moves
    bool any_upper_will_do = false;  ///< ends with the first moves found
};

/// What is known. It only ever gets better, so that it can be used whenever the search is given up.
struct LeavingBounds {
    int lower = 0;             ///< no way out has fewer
    std::optional<int> upper;  ///< as `moves` has
    std::vector<Move> moves;   ///< out, in the entering frame; empty when the upper bound came from elsewhere
    double spacing = 0.0;      ///< of the finest lattice [m]

    [[nodiscard]] bool meet() const { return upper && *upper == lower; }
};

/// Narrows the bounds until they meet. Throws GivenUp, and Error when the resolution asked for takes too much memory.
void narrow(const LeavingQuestion& question, LeavingBounds& bounds, const Watch& watch);

/// Replaces the moves by roomier ones with as many changes, if it finds some. Throws GivenUp.
void make_roomier(const LeavingQuestion& question, LeavingBounds& bounds, const Watch& watch);

/// Throws Error unless the options are possible.
void check(const FewestOptions& options);
/// The bounds as an answer; `from_entry` when the moves are to be driven in.
FewestAnswer answer_of(const LeavingQuestion& question, LeavingBounds bounds, const Car& car, const Slot& slot,
                       bool driven_in);
/// Looks at the clock and asks the callback.
Watch watch_of(const FewestOptions& options);

}  // namespace snug::detail
