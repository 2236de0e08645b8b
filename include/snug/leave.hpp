// Getting out: the fewest direction changes from where the car is parked.
#pragma once

#include "snug/car.hpp"
#include "snug/fewest.hpp"
#include "snug/geometry.hpp"
#include "snug/park.hpp"
#include "snug/slot.hpp"

namespace snug {

/// Where a parked car stands, by what is left around it.
struct ParkedGaps {
    double front = 0.0;    ///< from the car's foremost point to the front neighbour [m]
    double curb = 0.0;     ///< from the car's lowest point to the curb [m]
    double heading = 0.0;  ///< measured from the parallel heading, positive with the nose away from the curb [rad]

    friend bool operator==(const ParkedGaps&, const ParkedGaps&) = default;
};

/// Its pose in the world.
Pose parked_pose(const Car& car, const Slot& slot, const ParkedGaps& gaps);

/// The smallest number of direction changes with which a car parked at `pose` (world frame) can leave the slot, with
/// proof as for fewest(). The maneuver starts at the pose and ends in a forward move (`options.driving.enter` forward: backward)
/// where the frame's corner is level with the slot's and the way on is free.
/// Throws Error when an option is impossible, when the car is not inside the slot or not `options.driving.clearance` away from
/// the neighbours and the curb, and when it is more than 1.2 rad off parallel.
Answer leave(const Car& car, const Slot& slot, const Pose& pose, const FewestOptions& options = {});

/// The street as a place in which the car is to stand on the road: all of it beyond the entry side, its heading at most 0.1 rad off
/// the street's.
Place road_place(const Street& street);

/// The smallest number of direction changes with which a car at `pose` in the bay gets out onto the road, with what bounds
/// it: park() into road_place(), whose conditions and exceptions hold. Driven the other way round it is parking.
ParkAnswer leave(const Car& car, const Street& street, const Pose& pose, const ParkOptions& options = {});

}  // namespace snug
