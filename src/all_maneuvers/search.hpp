// Both bounds on the number of direction changes for leaving the slot, on finer and finer lattices.
#pragma once

#include <optional>
#include <vector>

#include "all_maneuvers/pieces.hpp"
#include "snug/fewest.hpp"

namespace snug::detail {

/// From where to leave, and how closely to look. All in the entering frame.
struct LeavingQuestion {
    Ground ground;
    Start start;
    Anchor anchor = {};
    int max_changes = 200;
    double resolution = 0.0;         ///< as asked for; 0 for the usual one [m]
    Finish finish = Finish::at_p;    ///< what is made of the moves
    bool any_upper_will_do = false;  ///< ends with the first moves found
};

/// What is known. It only ever gets better, so that it can be used whenever the search is given up.
struct LeavingBounds {
    int lower = 0;                    ///< no way out has fewer
    std::optional<int> upper;         ///< as `moves` has
    std::vector<Move> moves;          ///< out, in the entering frame; empty when the upper bound came from elsewhere
    std::optional<LatticePath> path;  ///< they were made from
    double spacing = 0.0;             ///< of the finest lattice [m]

    [[nodiscard]] bool meet() const { return upper && *upper == lower; }
};

/// The spacing of the coarsest lattice that makes sense: there the headings next to upright, which it leaves out, are few. [m]
double coarsest_sensible(const Problem& problem, const Car& car);

/// A way out as the coarsest lattice there can be shows it: found in a millisecond or so, and seldom the best; empty if it
/// shows none.
std::vector<Move> moves_at_hand(const LeavingQuestion& question, const Watch& watch);

/// Makes those the upper bound where nothing better was found.
void fall_back_on(std::vector<Move> at_hand, const Car& car, LeavingBounds& bounds);

/// How many changes to look at first: what the coarsest lattice says, and some more.
int sensible_depth(const LeavingQuestion& question, const Watch& watch);

/// Narrows the bounds until they meet. Without an upper bound it looks only so deep at first, because each change more
/// costs two sweeps. The moves are free of contact, in pieces as they come. Throws GivenUp, and Error
/// when the resolution asked for takes too much memory.
void narrow(const LeavingQuestion& question, int depth, LeavingBounds& bounds, const Watch& watch);

/// Replaces the moves by few pieces with as many changes, roomier ones if it finds some and they are asked for. Throws
/// GivenUp.
void make_drivable(const LeavingQuestion& question, LeavingBounds& bounds, bool roomiest, const Watch& watch);

/// Throws Error unless the options are possible.
void check(const FewestOptions& options);
/// Whether the car, flush with the curb or with what it keeps from it, can only go straight on: what touches there reaches
/// ahead of the rear axle and behind it (docs/fewest.md).
inline bool never_turns(const Problem& problem) {
    const RightSide side(problem.at_curb);
    return side.front.x > 0.0 && side.rear.x < 0.0;
}
/// Proved impossible without a search.
Answer impossible(int max_changes);
/// The bounds as an answer; `from_entry` when the moves are to be driven in.
Answer answer_of(const LeavingQuestion& question, LeavingBounds bounds, const Car& car, const Slot& slot,
                 bool driven_in);
/// Looks at the clock, whether so many times the limit are gone, and tells the callback; both must outlive it.
Watch watch_of(const FewestOptions& options, const LeavingBounds& bounds, double times = 1.0);
/// For moves_at_hand(): an answer, if late, is better than none. It takes milliseconds, or the slot is a very large one.
inline constexpr double limits_at_hand = 50.0;

}  // namespace snug::detail
