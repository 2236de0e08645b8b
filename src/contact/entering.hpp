// One solver for both ways in: nose first is tail first for the mirrored slot and the car with front and rear swapped.
//
// Strategies work in the entering frame: the slot frame (see slot.hpp) entering backward, its mirror image in x entering
// forward. Left stays left in that mirror, because the car's own direction turns round as well.
#pragma once

#include "contact/turning.hpp"
#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// The car and the slot in the entering frame.
Problem entering_problem(const Car& car, const Slot& slot, Enter enter, double clearance);

/// From the entering frame to the world.
Pose to_world(const Slot& slot, Enter enter, const Pose& pose);
Contact to_world(const Slot& slot, Enter enter, const Contact& contact);

inline Direction reverse_of(Direction direction) {
    return direction == Direction::forward ? Direction::backward : Direction::forward;
}

/// The way a car drives that would go in this direction, were it entering backward.
inline Direction entering_direction(Enter enter, Direction backward_in) {
    return enter == Enter::backward ? backward_in : reverse_of(backward_in);
}

/// Throws Error unless the options are possible.
void check(const MaxSteerOptions& options);
/// Throws Error unless the heading lies in [0, pi/2].
void check_entry_heading(double heading);

}  // namespace snug::detail
