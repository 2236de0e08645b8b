// By how much the start may be off the entry position and still park with as few direction changes.
#pragma once

#include <optional>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

/// How far off the entry position the car may stand when full steering begins, its heading as it should be. At the entry
/// position it touches the neighbour's corner, so it can be off only away from that: along the slot towards the other
/// neighbour, and out into the road. All values are proved: every start from 0 to them parks with no more changes.
struct StartTolerance {
    double heading = 0.0;       ///< as asked [rad]
    int direction_changes = 0;  ///< from the entry position
    double along = 0.0;         ///< farther along by at most this, no farther out [m]
    double out = 0.0;           ///< farther out by at most this, no farther along [m]
    double both_along = 0.0;    ///< farther along by at most this [m]
    double both_out = 0.0;      ///< and at once farther out by at most this [m]

    friend bool operator==(const StartTolerance&, const StartTolerance&) = default;
};

/// For the entry position at this heading in [0, pi/2], measured like that of max_steer(). `along` and `out` are
/// found to 2e-9 m and rounded inward: from beyond the car does not park with as few changes, it comes to where its other end
/// is as near to the other neighbour as it may be (`out`: it is out by the depth of the slot), or it cannot be told. `both` is the
/// largest box with these proportions, in steps of a 64th, that is proved within a bound on work; 0 if none is. Empty: from
/// the entry position itself the car does not park with at most options.max_changes.
/// Throws Error when an option is impossible.
std::optional<StartTolerance> start_tolerance(const Car& car, const Slot& slot, double heading,
                                              const MaxSteerOptions& options = {});

/// That of the maneuver entry() answers with, for its count; empty where the car does not park.
std::optional<StartTolerance> start_tolerance(const Car& car, const Slot& slot, const Answer& answer,
                                              const EntryOptions& options = {});

}  // namespace snug
