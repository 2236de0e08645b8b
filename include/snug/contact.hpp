// First contact: how far a car can drive with one steering angle before its frame touches something.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/maneuver.hpp"
#include "snug/place.hpp"
#include "snug/slot.hpp"

namespace snug {

/// A stretch of a move, as distances from its start. [m]
struct Stretch {
    double from = 0.0;
    double to = 0.0;

    friend bool operator==(const Stretch&, const Stretch&) = default;
};

/// What happens on one move with constant steering.
struct FirstContact {
    /// Path of the rear axle centre until contact [m]; 0 when the car touches and would move in, infinity when it never
    /// touches anything (a full circle, or straight away).
    double distance = std::numeric_limits<double>::infinity();
    std::optional<Contact> contact;
    /// The first stretch of the move, up to the contact, over which the whole frame is inside the slot.
    std::optional<Stretch> inside;
};

/// Where a car at `pose` (world frame) that drives one way with `steering_angle` (|angle| <= max_steer, positive to the
/// left, 0 straight) [rad] first touches the curb or a neighbour. In closed form (theory: every contact is a point
/// crossing a line while moving on a circle). Touching is no contact while the car moves away; a pose that overlaps an
/// obstacle by more than 1e-9 of the car's length is in contact at distance 0. Clearances grow the frame for contacts, not
/// for being inside; which end goes first makes no difference. Exact to rounding at the size of the turning circle: 1e-14 m
/// at full steering, 1e-9 m at a steering angle of 1e-6 rad, whose circle is thousands of kilometres wide.
FirstContact first_contact(const Car& car, const Slot& slot, const Pose& pose, Direction direction,
                           double steering_angle, const Driving& driving = {});

/// How far a car at a pose (world frame) is from what it could touch; the clearances are taken off. Negative: the shortest
/// way out. [m]
struct Gaps {
    double front = 0.0;  ///< to the front neighbour
    double rear = 0.0;   ///< to the rear neighbour
    double curb = 0.0;   ///< to the curb; where it is low, of the wheels

    friend bool operator==(const Gaps&, const Gaps&) = default;
};
Gaps gaps(const Car& car, const Slot& slot, const Pose& pose, const Driving& driving = {});

/// How far a car at a pose is from an obstacle of a place, and which part of the car is nearest to it.
struct PlaceGap {
    double distance = 0.0;  ///< what the obstacle asks to be kept is taken off; negative: the shortest way out [m]
    CarPart part = CarPart::front_left_corner;
    std::size_t part_index = 0;  ///< as in Contact

    friend bool operator==(const PlaceGap&, const PlaceGap&) = default;
};
/// One for every obstacle, in the place's order; to low ones those of the wheels.
std::vector<PlaceGap> gaps(const Car& car, const Place& place, const Pose& pose, double clearance = 0.0);

/// Does the car overlap nothing at a pose? Touching, to 1e-9 of its length, is allowed.
bool is_free(const Car& car, const Slot& slot, const Pose& pose, const Driving& driving = {});

/// Is a car that overlaps nothing parked at a pose, to 1e-9 of its length? The whole frame is inside the slot, but over a
/// low curb, and whatever else counts as parked.
bool is_inside(const Car& car, const Slot& slot, const Pose& pose, const Parked& parked = {});

}  // namespace snug
