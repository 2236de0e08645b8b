// Trajectory: a maneuver over time, as fast as the car and its passengers allow.
#pragma once

#include <vector>

#include "snug/geometry.hpp"
#include "snug/maneuver.hpp"

namespace snug {

/// What the car and its passengers allow. The usual values are a walk among parked cars; public benchmarks of planners take
/// 2.5 m/s, 1 m/s2 and 0.5 rad/s.
struct MotionLimits {
    double speed = 1.0;          ///< [m/s]
    double acceleration = 0.5;   ///< while the car gains speed [m/s2]
    double deceleration = 0.5;   ///< while it loses speed [m/s2]
    double steering_rate = 0.5;  ///< of the steering angle, at the road wheels [rad/s]

    friend bool operator==(const MotionLimits&, const MotionLimits&) = default;
};

/// The car at one time, and how it moves on from there.
struct TrajectoryPoint {
    double time = 0.0;  ///< [s]
    Pose pose;          ///< in the world frame; headings run on over a half turn
    Direction direction = Direction::backward;
    double speed = 0.0;           ///< negative backward [m/s]
    double acceleration = 0.0;    ///< of that speed [m/s2]
    double steering_angle = 0.0;  ///< positive to the left [rad]
    double steering_rate = 0.0;   ///< [rad/s]
    double curvature = 0.0;       ///< of the steering, positive to the left [1/m]
    double distance = 0.0;        ///< driven so far, never falling [m]
    double sharpness = 0.0;       ///< what the curvature gains in every metre driven [1/m2]

    friend bool operator==(const TrajectoryPoint&, const TrajectoryPoint&) = default;
};

/// A maneuver over time. From each of its points to the next the acceleration is constant; while the car stands the steering
/// rate is, too, and while it rolls the sharpness: of a Maneuver that is 0, its steering turns only while the car stands, so that
/// the path is the maneuver's; for one that steers while it rolls see rolling.hpp.
struct Trajectory {
    Car car;
    MotionLimits limits;
    std::vector<TrajectoryPoint> points;  ///< the last one is the end: the car stands. Empty without a maneuver.
    int standing_steers = 0;              ///< how often the steering turns while the car stands

    /// How long it takes. [s]
    [[nodiscard]] double seconds() const { return points.empty() ? 0.0 : points.back().time; }
    /// The car at that time; before the start where it starts, after the end where it ends. There must be a point.
    [[nodiscard]] TrajectoryPoint at(double time) const;

    friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

/// The quickest way to drive a maneuver within the limits when the steering turns at standstill only: pieces of one direction
/// and steering angle are driven from rest to rest, accelerating, at full speed if they are long enough, and braking; between
/// them the steering turns at its rate. `steering_angle` [rad] is that of the wheels at the start. Moves without length are
/// left out. Where the maneuver's pieces do not end where the next begin, each begins at its own start.
/// Throws Error when a limit is not between 0.001 and 1000, or the steering angle is no number.
Trajectory trajectory(const Maneuver& maneuver, const MotionLimits& limits = {}, double steering_angle = 0.0);

/// The trajectory at times 0, `period`, 2 `period`, ... [s] and at its end. Nothing without a maneuver.
/// Throws Error when the period is less than 1e-6 s or no number, or so small that there were more than a million points.
std::vector<TrajectoryPoint> sampled(const Trajectory& trajectory, double period);

}  // namespace snug
