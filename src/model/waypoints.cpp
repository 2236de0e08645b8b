// Where the waypoints of a maneuver lie.
#include "snug/waypoints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/angles.hpp"
#include "sentences/check.hpp"

namespace snug {
namespace {

constexpr double most_waypoints = 1e6;

double pieces(const Move& move, double spacing) { return std::max(1.0, std::ceil(move.length / spacing)); }

void check_spacing(const Maneuver& maneuver, double spacing) {
    check_between("spacing of waypoints", spacing, 1e-9, std::numeric_limits<double>::infinity(), " m");
    double count = 0.0;
    for (const Move& move : maneuver.moves) count += pieces(move, spacing) + 1.0;
    if (count > most_waypoints)
        throw Error("spacing of waypoints is " + spelled(spacing) + " m, which makes more than " +
                    spelled(most_waypoints) + " of them on " + spelled(maneuver.length()) +
                    " m; take a larger spacing");
}

}  // namespace

std::vector<Waypoint> waypoints(const Maneuver& maneuver, double spacing) {
    check_spacing(maneuver, spacing);
    std::vector<Waypoint> along;
    double driven = 0.0;
    for (const Move& move : maneuver.moves) {
        if (move.length == 0.0) continue;
        const double curvature = angles::tan(move.steering_angle) / maneuver.car.wheelbase();
        const Waypoint start = {move.start, move.direction, curvature, driven};
        if (along.empty() || along.back().direction != move.direction) {
            along.push_back(start);
        } else {
            along.back() = start;
        }
        const double count = pieces(move, spacing);
        for (double i = 1.0; i < count; ++i) {
            const double distance = move.length * (i / count);
            along.push_back({drive(maneuver.car, move.start, move.direction, move.steering_angle, distance),
                             move.direction, curvature, driven + distance});
        }
        driven += move.length;
        along.push_back({move.end, move.direction, curvature, driven});
    }
    if (along.empty() && !maneuver.moves.empty())
        along.push_back({maneuver.entry(), maneuver.moves.front().direction, 0.0, 0.0});
    return along;
}

}  // namespace snug
