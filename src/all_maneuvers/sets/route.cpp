#include "all_maneuvers/sets/route.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "all_maneuvers/sets/steps.hpp"
#include "model/angles.hpp"
#include "snug/limits.hpp"

namespace snug::detail::sets {

namespace {

using limits::touching;

}  // namespace

std::vector<Path> way_by_steps(const InnerLattice& lattice, const InnerChain& chain, const ChartPlace& place) {
    std::vector<Path> way;
    Pose pose = place.start;
    At at = {0, 0, place.start.y};
    for (std::size_t k = chain.reaches.size(); k-- > 0;) {
        const Direction leaving = chain.direction(k);
        const Direction direction = leaving == Direction::forward ? Direction::backward : Direction::forward;
        const Stepper stepper(lattice, leaving);
        const InnerSet &begins = chain.begins(k), &reaches = chain.reaches[k];
        for (;;) {
            // Where the next move can begin this one may end; it goes on as long as that gives more room.
            const double room_here = begins.at(at.row, at.column).room(at.y);
            const InnerSet& towards = room_here < 0.0 ? reaches : begins;
            const auto room_at = [&](const At& next) { return towards.at(next.row, next.column).room(next.y); };
            const At to_left = stepper.from(at, left), to_right = stepper.from(at, right);
            const double left_room = room_at(to_left), right_room = room_at(to_right);
            // Across the cell, turning off after a part of the first arc: what that gains depends on where. At the chart's edge
            // there is no cell to go across.
            const bool in_chart = std::abs(lattice.sine(to_left.column)) <= steepest_sine &&
                                  std::abs(lattice.sine(to_right.column)) <= steepest_sine;
            At across = {at.row + 2 * stepper.way, at.column, at.y};
            double across_room = -1.0;
            const double one = 2.0 * (to_left.y - at.y), other = 2.0 * (to_right.y - at.y);
            for (const Interval& interval : in_chart ? towards.at(across.row, across.column) : InnerSet::Range{}) {
                const double from = std::max(at.y + std::min(one, other), interval.low);
                const double to = std::min(at.y + std::max(one, other), interval.high);
                if (from > to) continue;
                const double y = std::clamp((interval.low + interval.high) / 2.0, from, to);
                const double room = std::min(y - interval.low, interval.high - y);
                if (room > across_room) {
                    across_room = room;
                    across.y = y;
                }
            }
            const double most = std::max({left_room, right_room, across_room});
            if (room_here >= 0.0 && (room_here > enough_room || most <= room_here + worth_a_step)) break;
            if (most <= -1.0 && room_here > -1.0) break;
            if (most <= -1.0) return {};
            if (left_room >= right_room && left_room >= across_room) {
                add_step(lattice, way, pose, at.column, left, direction);
                at = to_left;
            } else if (right_room >= across_room) {
                add_step(lattice, way, pose, at.column, right, direction);
                at = to_right;
            } else {
                add_turn_off(lattice, way, pose, at.column, across.y - at.y, direction);
                at = across;
            }
        }
    }
    return way;
}

namespace {

/// The most of normal . p along the path of the rear axle's middle.
double farthest_along(const Path& path, const Point& normal) {
    const Pose end = path.at(path.length);
    double most = std::max(normal.x * path.start.x + normal.y * path.start.y, normal.x * end.x + normal.y * end.y);
    if (path.curvature == 0.0) return most;
    // On the circle it is where the heading is at a right angle to the normal.
    const double change = path.way * path.length * path.curvature;
    for (const double quarter : {1.0, -1.0}) {
        const double heading = angles::atan2(normal.y, normal.x) + quarter * 1.5707963267948966;
        double turned = std::remainder(heading - path.start.heading, 6.283185307179586);
        if (change > 0.0 && turned < 0.0) turned += 6.283185307179586;
        if (change < 0.0 && turned > 0.0) turned -= 6.283185307179586;
        if (std::abs(turned) > std::abs(change)) continue;
        const Pose there = path.at(turned / (path.way * path.curvature));
        most = std::max(most, normal.x * there.x + normal.y * there.y);
    }
    return most;
}

/// Whether a box around everything the car can come to is apart from a box around the solid.
bool is_out_of_reach(const std::vector<Point>& shape, const Path& piece, const std::vector<Point>& solid) {
    double size = 0.0;
    for (const Point& p : shape) size = std::max(size, std::abs(p.x) + std::abs(p.y));
    const double reach = piece.length + size + 0.01;
    double left = solid[0].x, right = left, below = solid[0].y, above = below;
    for (const Point& p : solid) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        below = std::min(below, p.y), above = std::max(above, p.y);
    }
    return piece.start.x + reach < left || piece.start.x - reach > right || piece.start.y + reach < below ||
           piece.start.y - reach > above;
}

}  // namespace

bool is_parked(const ChartPlace& place, const Pose& pose) {
    const auto [sine, cosine] = angles::sine_cosine(pose.heading);
    if (sine < place.parked_from - touching || sine > place.parked_to + touching) return false;
    for (const ParkedLimit& limit : place.parked) {
        const Point& n = limit.within.normal;
        double least = std::numeric_limits<double>::infinity(), most = -least;
        if (limit.of == ParkedLimit::axle) {
            least = most = n.x * pose.x + n.y * pose.y;
        } else {
            for (const Point& p : place.frame) {
                const double reach =
                    n.x * (pose.x + p.x * cosine - p.y * sine) + n.y * (pose.y + p.x * sine + p.y * cosine);
                least = std::min(least, reach);
                most = std::max(most, reach);
            }
        }
        const double at = limit.of == ParkedLimit::nearest_point ? least : most;
        if (at > limit.within.offset + touching) return false;
    }
    return true;
}

bool is_clear(const ChartPlace& place, const Pose& pose) {
    const auto [sine, cosine] = angles::sine_cosine(pose.heading);
    for (const ChartPlace::Solid& solid : place.solids) {
        // Apart, or nearly so, along the normal of an edge of one or the other.
        const std::vector<Point>& shape = place.shapes[solid.stops];
        bool apart = false;
        const std::size_t corners = solid.corners.size();
        for (std::size_t i = 0; i < corners && !apart; ++i) {
            const Point &from = solid.corners[i], &to = solid.corners[(i + 1) % corners];
            const Point n = {to.y - from.y, from.x - to.x};
            const Point seen = {n.x * cosine + n.y * sine, n.y * cosine - n.x * sine};
            const double level = n.x * (from.x - pose.x) + n.y * (from.y - pose.y) - touching * angles::hypot(n.x, n.y);
            apart = std::all_of(shape.begin(), shape.end(),
                                [&](const Point& p) { return seen.x * p.x + seen.y * p.y >= level; });
        }
        for (std::size_t i = 0; i < shape.size() && !apart; ++i) {
            const Point &from = shape[i], &to = shape[(i + 1) % shape.size()];
            const Point n = {to.y - from.y, from.x - to.x};
            const Point seen = {n.x * cosine - n.y * sine, n.x * sine + n.y * cosine};
            const double level = n.x * from.x + n.y * from.y - touching * angles::hypot(n.x, n.y);
            apart = std::all_of(solid.corners.begin(), solid.corners.end(), [&](const Point& p) {
                return seen.x * (p.x - pose.x) + seen.y * (p.y - pose.y) >= level;
            });
        }
        if (!apart) return false;
    }
    return true;
}

bool is_free(const ChartPlace& place, const Path& piece) {
    for (const HalfPlane& edge : place.region)
        if (farthest_along(piece, edge.normal) > edge.offset + 1e-6) return false;
    for (const ChartPlace::Solid& solid : place.solids) {
        const std::vector<Point>& shape = place.shapes[solid.stops];
        if (!is_out_of_reach(shape, piece, solid.corners) &&
            first_contact(shape, piece, solid.corners, touching) < piece.length)
            return false;
    }
    return true;
}

bool is_drivable(const ChartPlace& place, const std::vector<Path>& way) {
    for (const ChartPlace::Solid& solid : place.solids)
        if (overlap(placed(place.shapes[solid.stops], place.start), solid.corners) > touching) return false;
    for (const Path& piece : way)
        if (!is_free(place, piece)) return false;
    return is_parked(place, way.empty() ? place.start : way.back().at(way.back().length));
}

}  // namespace snug::detail::sets
