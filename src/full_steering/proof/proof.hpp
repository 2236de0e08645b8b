// Which entry headings park with how many direction changes, proved: every heading is shown to park with the count of its
// range, or not to park with any count asked for, but for slivers that are listed.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "full_steering/heading_ranges.hpp"
#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/geometry.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// What the proof needs to know of a car and a slot, in the entering frame. Polygons are convex, counter-clockwise, about
/// the middle of the rear axle.
struct ProofProblem {
    std::vector<Point> body;       ///< what stops at the neighbours
    std::vector<Point> at_curb;    ///< what stops at the curb
    std::vector<Point> frame;      ///< what must be inside when parked
    std::size_t entry_corner = 0;  ///< of the body: it touches the slot's front corner at the entry position
    double radius = 0.0;           ///< turning radius [m]
    double length = 0.0;           ///< of the slot [m]
    double width = 0.0;            ///< of the slot [m]
    double front_setback = 0.0;    ///< [m]
    double rear_setback = 0.0;     ///< [m]
    double length_error = 0.0;     ///< all slots that are longer or shorter by no more than this [m]
    double width_error = 0.0;      ///< or wider or narrower [m]
    double parked_heading = 0.0;   ///< largest angle off parallel when parked, at most a quarter turn [rad]
    double parked_curb = std::numeric_limits<double>::infinity();  ///< largest distance from the curb when parked [m]
};

/// A stretch of headings the proof leaves out: nothing in it parks before this move.
struct Sliver {
    double min = 0.0;
    double max = 0.0;
    int from_changes = 0;
};

struct ProvedRanges {
    std::vector<CountedHeadings> ranges;  ///< in rising order, each heading in them proved
    std::vector<Sliver> undecided;        ///< in rising order; outside them and the ranges nothing parks
    int proved_changes = 0;               ///< with up to that many direction changes
    bool cancelled = false;
    std::size_t boxes = 0;  ///< looked at
    std::size_t moves = 0;  ///< driven
};

/// What a quick search found.
struct ProofHints {
    int changes = -1;              ///< the fewest changes, -1 if unknown
    std::vector<double> headings;  ///< where to cut first, in rising order [rad]
};

/// Find::all: every range with at most max_changes; Find::fewest: those with the smallest count there is.
ProvedRanges prove_ranges(const ProofProblem& problem, int max_changes, Find find, const ProofHints& hints = {},
                          const Progress& progress = {}, std::size_t most_moves = 20'000'000);

/// As wide may be in all what a proof leaves undecided. [rad]
inline constexpr double most_undecided = 1e-9;

/// Does nothing park with at most max_changes, in any slot within the errors of the problem's dimensions, but for slivers?
/// False where that is not so, or cannot be told with so many moves; they are taken from `moves_left`.
bool none_parks(const ProofProblem& problem, int max_changes, std::size_t& moves_left);

/// How far below parallel, or above, a car can be parked, at most: where the frame fits between entry side and curb, up to
/// parked_heading. Headings only fall, so a car that comes to rest steeper below than this parks no more. [rad]
double steepest_parked(const ProofProblem& problem, bool above = false);

/// In the entering frame (contact/entering.hpp).
ProofProblem proof_problem(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked);

}  // namespace snug::detail
