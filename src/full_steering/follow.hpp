// Runs of the paper's strategy from many headings, each of their moves kept: what the search for ranges looks at.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "full_steering/full_steering.hpp"

namespace snug::detail {

/// As the count of a run that does not park.
inline constexpr int never = std::numeric_limits<int>::max();

/// One run of the strategy: `count` moves from `first` among all that are kept.
struct Run {
    double heading = 0.0;
    int last = 0;              ///< no moves beyond this one, counted from 0
    bool past_parked = false;  ///< drives on where it is parked
    std::size_t first = 0;
    std::size_t count = 0;
    int changes = never;  ///< with which it parks
};

/// Can vectors drive with this car in this slot? They know rectangles, which have four sectors, and look at nothing but the
/// height.
bool in_vectors(const FullSteering& steering);

/// Drives runs and keeps their moves.
struct Follow {
    const FullSteering& steering;
    bool vectors;  ///< see in_vectors()
    int limit;     ///< parking with more changes does not interest
    bool fewest;   ///< nor with more than any run so far
    std::vector<FullMove> moves = {};
    std::size_t driven = 0;  ///< moves, in all

    /// Drives all these runs, several side by side where that is quicker. How they are driven shows nowhere: what interests
    /// afterwards, moves up to the limit, is there in any case.
    void drive(std::vector<Run>& runs);
};

/// Nothing new can come after this move, the one before having been stuck or not: the car has turned away, or is stuck both
/// ways.
inline bool ends(const FullMove& move, bool stuck_before) {
    return move.meets == Meets::nothing || (move.stuck && stuck_before);
}

/// Drives runs, no farther than `limit`, and keeps their moves; with `fewest`, the limit falls with every run that parks.
void follow_one_by_one(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest,
                       std::vector<FullMove>& moves);
/// In vectors.
void follow_in_lanes(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest,
                     std::vector<FullMove>& moves);

}  // namespace snug::detail
