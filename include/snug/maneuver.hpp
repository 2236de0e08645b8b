// Maneuver: what the car drives, move by move, and where it is along the way.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "snug/car.hpp"
#include "snug/geometry.hpp"
#include "snug/slot.hpp"

namespace snug {

enum class Direction { backward = -1, forward = 1 };

/// A part of the car's outline, named by where it is. A corner is what lies in that quarter of the car's length and width,
/// slanting edges there included.
enum class CarPart {
    front_left_corner,
    rear_left_corner,
    rear_right_corner,
    front_right_corner,
    front_edge,
    left_edge,
    rear_edge,
    right_edge,
    front_left_wheel,  // at a low curb
    rear_left_wheel,
    rear_right_wheel,
    front_right_wheel,
};

/// What a car can touch: the three non-entry sides of the slot and its two corners at the road. A corner of the car that
/// lands on a neighbour from the road side touches that neighbour's side.
enum class Obstacle { front_side, rear_side, curb, front_corner, rear_corner };

/// Which part of the car meets what.
struct Contact {
    CarPart part;
    Obstacle obstacle;
    /// Which one of the car's outline (of its wheels): the corner's index; an edge's is that of the corner it follows.
    std::size_t part_index = 0;

    friend bool operator==(const Contact&, const Contact&) = default;
};

/// "rear-right corner", "left edge", ...
std::string_view to_string(CarPart part);
/// "front side", "curb", "rear corner", ...
std::string_view to_string(Obstacle obstacle);
/// "backward", "forward"
std::string_view to_string(Direction direction);
/// The same part or steering angle seen in a mirror (for slots on the left).
CarPart mirrored(CarPart part);

/// Driving one way with one steering angle.
struct Move {
    Direction direction = Direction::backward;
    double steering_angle = 0.0;  ///< positive to the left [rad]
    double length = 0.0;          ///< path of the rear axle centre, never negative [m]
    Pose start;
    Pose end;
    std::optional<Contact> contact;  ///< what ends the move; empty when the driver stops by choice

    friend bool operator==(const Move&, const Move&) = default;
};

/// Pose after driving `distance` [m] (not negative) from `start` with the steering angle [rad]: an exact arc or line.
Pose drive(const Car& car, const Pose& start, Direction direction, double steering_angle, double distance);

/// A car and its moves, the end of each being the start of the next. Poses are in the world frame.
struct Maneuver {
    Car car;
    std::vector<Move> moves;

    /// First and last pose. The maneuver must have a move.
    [[nodiscard]] Pose entry() const { return moves.front().start; }
    [[nodiscard]] Pose goal() const { return moves.back().end; }
    /// How often the driving direction changes between one move and the next.
    [[nodiscard]] int direction_changes() const;
    /// Path of the rear axle centre. [m]
    [[nodiscard]] double length() const;
    /// Poses along the way, at most `spacing` [m] apart, with both ends of every move.
    /// Throws Error when the spacing is less than 1e-9 m or no number.
    [[nodiscard]] std::vector<Pose> poses(double spacing) const;

    friend bool operator==(const Maneuver&, const Maneuver&) = default;
};

/// The smallest box around everything the car frame covers, exactly (all zero without a move): in the world frame,
Box swept(const Maneuver& maneuver);
/// and in the frame of a slot, where y_max is how far the car swings out into the road.
Box swept(const Maneuver& maneuver, const Slot& slot);

}  // namespace snug
