#include "all_maneuvers/to_and_fro.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/angles.hpp"

namespace snug::detail {

namespace {

constexpr double steepest = 1.2;         ///< the nose is not turned farther out [rad]
constexpr int stops = 8;                 ///< on a move forward, from which straight on is tried
constexpr double short_of_contact = 1e-7;  ///< moves end so far from what they would meet, of the turning radius
constexpr double no_move = 1e-6;         ///< of the turning radius: less leads nowhere

/// The ways out that begin with this direction, one after the other.
std::vector<Move> beginning(Direction first, const Ground& ground, Pose pose, int max_changes, const Watch& watch) {
    const double radius = ground.problem.radius;
    const auto characteristic = [&](const Pose& at) {
        const double across = radius * angles::sin(at.heading);
        return Characteristic{at.x - across, at.x + across};
    };
    LatticePath path;
    path.z = pose.y + radius * angles::cos(pose.heading);
    Direction direction = first;
    bool moved = true;
    for (int changes = 0; changes <= max_changes && pose.heading < steepest; ++changes) {
        watch();
        const bool forward = direction == Direction::forward;
        const double steering = forward ? ground.car.max_steer() : -ground.car.max_steer();
        const double room = contact_on(ground, pose, direction, steering).distance - short_of_contact * radius;
        const double length = std::clamp(room, 0.0, (steepest - pose.heading) * radius);
        const auto after = [&](double distance) { return drive(ground.car, pose, direction, steering, distance); };
        LatticePath::Leg& leg = path.legs.emplace_back();
        leg.direction = direction;
        leg.points = {characteristic(pose)};
        for (int stop = 0; forward && stop <= stops; ++stop) {
            const Pose at = after(length * stop / stops);
            if (at.heading < 0.0 || contact_on(ground, at, Direction::forward, 0.0).contact) continue;
            LatticePath out = path;
            std::vector<Characteristic>& points = out.legs.back().points;
            points.push_back(characteristic(at));
            const double on = 2.0 * std::max(0.0, -ground.front_corner(at).x) + radius;
            points.push_back({points.back().a + on, points.back().b + on});
            std::vector<Move> moves = leaving_moves(ground, out, Finish::checked, watch);
            if (!moves.empty()) return moves;
        }
        if (length < no_move * radius && !std::exchange(moved, false)) return {};
        if (length >= no_move * radius) moved = true;
        pose = after(length);
        leg.points.push_back(characteristic(pose));
        direction = reverse_of(direction);
    }
    return {};
}

}  // namespace

std::vector<Move> to_and_fro(const Ground& ground, const Pose& start, int max_changes, const Watch& watch) {
    std::vector<Move> best = beginning(Direction::forward, ground, start, max_changes, watch);
    const auto changes = [&](const std::vector<Move>& moves) { return Maneuver{ground.car, moves}.direction_changes(); };
    const int most = best.empty() ? max_changes : changes(best) - 1;
    std::vector<Move> other = beginning(Direction::backward, ground, start, most, watch);
    return other.empty() ? best : other;
}

}  // namespace snug::detail
