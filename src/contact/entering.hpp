// One solver for both ways in: nose first is tail first for the mirrored slot and the car with front and rear swapped.
//
// Strategies work in the entering frame: the slot frame (see slot.hpp) entering backward, its mirror image in x entering
// forward. Left stays left in that mirror, because the car's own direction turns round as well.
#pragma once

#include <cstddef>

#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// A car and a slot in the entering frame.
struct Problem {
    Outline body;     ///< what stops at the neighbours: the outline grown by the clearance
    Outline at_curb;  ///< what stops at the curb: grown by the clearance kept there; the wheels where the curb is low
    Outline frame;    ///< what must be inside to be parked: the outline itself
    double radius = 0.0;         ///< turning radius [m]
    double length = 0.0;         ///< of the slot [m]
    double width = 0.0;          ///< of the slot [m]
    double front_setback = 0.0;  ///< the front neighbour is {x > 0, y < -front_setback} [m]
    double rear_setback = 0.0;   ///< the rear neighbour is {x < -length, y < -rear_setback} [m]
    Parked parked;               ///< what counts as parked, besides the frame between 0 and -length below y = 0
    double touch = 0.0;          ///< closer than this is touching: what rounding may do to a position [m]
};
Problem entering_problem(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked = {});

/// Whatever is shorter or narrower cannot hold the parallel car, with the clearance it keeps from neighbours and curb (none
/// where a neighbour is set back). Of the slot only its side, setbacks and curb are looked at. [m]
struct LeastSlot {
    double length = 0.0;
    double width = 0.0;
};
LeastSlot least_slot(const Car& car, const Slot& slot, const Driving& driving);

/// From the entering frame to the world and back.
Pose to_world(const Slot& slot, Enter enter, const Pose& pose);
Pose to_entering(const Slot& slot, Enter enter, const Pose& pose);
Contact to_world(const Car& car, const Slot& slot, Enter enter, const Contact& contact);
/// Which corner of the car's own outline, or of its wheels, that corner of their image in the entering frame is; of an edge
/// the one it follows.
std::size_t own_part(const Outline& own, const Slot& slot, Enter enter, bool edge, std::size_t part);
/// The obstacle in the place of this one, were the front the rear.
Obstacle other_end(Obstacle obstacle);

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
