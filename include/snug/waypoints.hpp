// Waypoints: a maneuver as the list of poses that path followers take, with curvature and driving direction.
#pragma once

#include <vector>

#include "snug/geometry.hpp"
#include "snug/maneuver.hpp"

namespace snug {

/// Where the car is, and how it drives on from there.
struct Waypoint {
    Pose pose;  ///< in the world frame; headings run on over a half turn, they are not wrapped
    Direction direction = Direction::backward;
    double curvature =
        0.0;                ///< of the steering, positive to the left: forward the heading rises by it each metre [1/m]
    double distance = 0.0;  ///< driven so far, never falling [m]

    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// A maneuver as waypoints, at most `spacing` [m] apart along the path and evenly spaced within a move.
///
/// Both ends of every move are among them. Where the direction changes there are two waypoints with one pose: the first
/// ends the stretch driven so far, the second begins the next. So each run of equal directions is a stretch of its own
/// with both its ends, as followers want it that split a path where the sign of its speed changes; followers that look
/// for a sharp turn between three poses should be given the first waypoint of such a pair only.
///
/// Direction and curvature hold from a waypoint to the next one; at the last one of a stretch they are those it was
/// reached with. Moves without length are left out. Empty for a maneuver that has no moves.
/// Throws Error when the spacing is less than 1e-9 m or no number, or so small that there were more than a million
/// waypoints.
std::vector<Waypoint> waypoints(const Maneuver& maneuver, double spacing);

}  // namespace snug
