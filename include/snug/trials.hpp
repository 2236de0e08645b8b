// Trials: the geometric planners that the paper compares itself with, and a formula for the slot of a single move.
#pragma once

#include <optional>

#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

/// Several reversed trials (Vorobieva, Glaser, Minoiu-Enache, Mammar: Automatic parallel parking in tiny spots, 2015,
/// as the paper retells it): from a goal position the car drives out of the slot, always with full steering until
/// contact, forward to the left (away from the curb), backward to the right, forward to the left, ...; parking is the
/// same path the other way round. Contacts are exact.
///
/// The car is out once its front-right corner rises to the entry side without having met the front neighbour. From
/// there it drives straight on until that corner is level with the slot's front corner p: the entry position. Three
/// things are decided here that the method leaves open:
///   - the last backward move out is shortened as far as the car still gets out. The corner then passes p itself, no
///     straight piece is left, and parking starts at one of the paper's possible entry positions;
///   - where a car gets out at its first move there is nothing to shorten: parking then starts above p and backs
///     straight to where the full steering begins;
///   - a first move that cannot start, because the goal touches what lies ahead, is left out.
struct ReversedTrials {
    /// Rear axle centre and heading in the world, the car inside the slot and within a quarter turn of parallel. Empty:
    /// the goal that the paper deduces, parallel with the left side on the entry side and the rear on the slot's rear
    /// side (entering forward: the front on its front side), off by the clearance if there is one.
    std::optional<Pose> goal = {};
    /// Where the first move out goes, had the car entered backward; the other way round when it enters forward.
    Direction first = Direction::forward;
};

/// Several parallel trials (the same source): the car is parallel to the slot whenever it changes direction. What the
/// paper says of it leaves much open; this is what is done here:
///   - from one of the paper's possible entry positions it backs with full left steering until it is parallel, of all
///     headings from the one that takes it deepest (up to the goal) without contact;
///   - then forward, backward, forward, ... it shifts towards the curb: an arc of full right and an arc of full left
///     steering of the same angle, the largest for which both are free of contact, and straight on until contact, so
///     that the next trial has the whole length of the slot;
///   - the trial that reaches the goal is as short as that takes.
/// A trial with arcs of the angle a advances 2 r sin(a) along and 2 r (1 - cos(a)) across the slot: in a slot with the
/// extra length E, far from the curb, 2 r - sqrt(4 r^2 - E^2).
struct ParallelTrials {
    /// Rear axle centre and heading in the world, the car inside the slot and parallel to it; the last trial is
    /// followed by a straight move to it, whichever way that is. Empty: any parallel position with the frame inside.
    std::optional<Pose> goal = {};
};

/// The parking maneuver of several reversed trials; empty when the car does not get out of the slot within the allowed
/// direction changes. Throws Error when an option or the goal is impossible.
std::optional<Maneuver> reversed_trials(const Car& car, const Slot& slot, const ReversedTrials& trials = {},
                                        const MaxSteerOptions& options = {});

/// The parking maneuver of several parallel trials; empty when the car does not get to its goal within the allowed
/// direction changes. Throws Error when an option or the goal is impossible.
std::optional<Maneuver> parallel_trials(const Car& car, const Slot& slot, const ParallelTrials& trials = {},
                                        const MaxSteerOptions& options = {});

/// Direction changes of several reversed trials from two goals; empty where the car does not get out.
struct ReversedTrialsByGoal {
    std::optional<int> deduced;  ///< from the goal the paper deduces
    /// From the goal of max_steer's best maneuver, setting out against that maneuver's last move. This is its time
    /// reversal: it needs as many changes as the best maneuver, however its last move was straightened.
    std::optional<int> found;
};

/// What the paper's choice of a goal costs in one slot (its section 4.1).
ReversedTrialsByGoal reversed_trials_by_goal(const Car& car, const Slot& slot, int max_changes = 200);

/// Length that a slot must have beyond the car's for the car to back into it in one go, after S. R. Blackburn, The
/// Geometry of Perfect Parking, 2009:
///
///     sqrt((R^2 - l^2) + (l + k)^2 - (sqrt(R^2 - l^2) - w)^2) - l - k    [m]
///
/// with R half the curb-to-curb distance, l the wheelbase, k the overhang in front of the front axle and w the width of
/// the car parked in front: `neighbour_width` [m], 0 to sqrt(R^2 - l^2). It assumes that the car ends parallel, its
/// rear at the rear neighbour and its right side as close to the curb as the front neighbour's, and turns with full
/// steering to the end: the front-right corner, on its circle, must just miss the front neighbour's rear-left corner.
/// In the paper's words w is how far the car's right side ends below the entry side: the slot's width for a car that
/// ends at the curb, the car's own width for one that ends at the entry side. It forgets the rear-right corner, which
/// swings out beyond the car's right side on the way: it cannot end at a curb that its body may not cross. A car that
/// may stop at an angle, as soon as it is inside, needs less. Throws Error when the width is impossible.
double blackburn_extra_length(const Car& car, double neighbour_width);

}  // namespace snug
