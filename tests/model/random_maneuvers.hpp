// Seeded random cars, poses and maneuvers, anywhere and with any steering: nothing here knows of obstacles.
#pragma once

#include <utility>

#include "oracle/random_cases.hpp"
#include "snug/snug.hpp"

namespace model {

using oracle::Random;

inline snug::Car random_car(Random& random) {
    return snug::Car({random.between(0.5, 3.0), random.between(0.5, 8.0), random.between(0.1, 4.0),
                      random.between(1.0, 6.0), random.between(0.2, 1.2)});
}

inline snug::Pose random_pose(Random& random) {
    return {random.between(-20.0, 20.0), random.between(-20.0, 20.0), random.between(-7.0, 7.0)};
}

inline snug::Slot random_slot(Random& random) {
    const auto side = random.chance(0.5) ? snug::Side::left : snug::Side::right;
    const double length = random.between(1.0, 10.0);
    const double width = random.between(1.0, 4.0);
    const snug::Pose at = random_pose(random);
    return snug::Slot({length, width, side, {at.x, at.y}, at.heading});
}

/// Full lock, anything between, or straight.
inline double random_steering(Random& random, const snug::Car& car) {
    const double kind = random.unit();
    if (kind < 0.2) {
        return 0.0;
    }
    return kind < 0.5 ? (kind < 0.35 ? -1.0 : 1.0) * car.max_steer() : random.between(-1.0, 1.0) * car.max_steer();
}

/// A few moves one after another, some of them more than a full circle long and some of no length.
inline snug::Maneuver random_maneuver(Random& random) {
    snug::Maneuver maneuver{random_car(random), {}};
    const snug::Car& car = maneuver.car;
    snug::Pose at = random_pose(random);
    const int count = 1 + random.below(5);
    for (int i = 0; i < count; ++i) {
        snug::Move move;
        move.direction = random.chance(0.5) ? snug::Direction::forward : snug::Direction::backward;
        move.steering_angle = random_steering(random, car);
        move.length = random.chance(0.1) ? 0.0 : random.between(0.0, random.chance(0.1) ? 60.0 : 5.0);
        move.start = at;
        move.end = at = drive(car, move.start, move.direction, move.steering_angle, move.length);
        maneuver.moves.push_back(move);
    }
    return maneuver;
}

}  // namespace model
