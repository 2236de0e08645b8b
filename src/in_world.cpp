#include "in_world.hpp"

#include <cmath>

#include "model/angles.hpp"

namespace snug::detail {

Maneuver in_world(const Car& car, const Pose& start, const std::vector<Path>& way) {
    Maneuver maneuver{car, {}};
    in_world(car, start, way, maneuver.moves);
    return maneuver;
}

void in_world(const Car& car, const Pose& start, const std::vector<Path>& way, std::vector<Move>& moves) {
    moves.clear();
    Pose at = start;
    for (const Path& piece : way) {
        Move move;
        move.direction = piece.way > 0.0 ? Direction::forward : Direction::backward;
        // Full steering is the car's own angle, to the bit.
        move.steering_angle = piece.curvature == 0.0 ? 0.0 : angles::atan(car.wheelbase() * piece.curvature);
        if (std::abs(std::abs(piece.curvature) * car.turning_radius() - 1.0) < 1e-12)
            move.steering_angle = piece.curvature > 0.0 ? car.max_steer() : -car.max_steer();
        move.length = piece.length;
        move.start = at;
        move.end = at = drive(car, at, move.direction, move.steering_angle, move.length);
        moves.push_back(move);
    }
}

}  // namespace snug::detail
