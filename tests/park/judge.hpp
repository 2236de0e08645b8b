// Whether a maneuver parks in a place, decided pose by pose by separating axes: shares no code with the solver.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "snug/park.hpp"

namespace park_test {

struct Corner {
    double x, y;
};

inline std::array<Corner, 4> car_at(const snug::Car& car, const snug::Pose& pose, bool wheels) {
    const double front = wheels ? car.wheelbase() : car.front(), rear = wheels ? 0.0 : car.rear(),
                 side = car.width() / 2;
    const double c = std::cos(pose.heading), s = std::sin(pose.heading);
    const auto there = [&](double x, double y) { return Corner{pose.x + c * x - s * y, pose.y + s * x + c * y}; };
    return {there(front, side), there(-rear, side), there(-rear, -side), there(front, -side)};
}

/// How far two convex polygons overlap across an edge of the first, at least; negative when they are apart there.
template <typename One, typename Other>
double depth_across_edges(const One& one, const Other& other) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < one.size(); ++i) {
        const auto &a = one[i], &b = one[(i + 1) % one.size()];
        const double x = b.y - a.y, y = a.x - b.x;
        double low_one = 1e300, high_one = -1e300, low_other = 1e300, high_other = -1e300;
        for (const auto& p : one) {
            low_one = std::min(low_one, x * p.x + y * p.y);
            high_one = std::max(high_one, x * p.x + y * p.y);
        }
        for (const auto& p : other) {
            low_other = std::min(low_other, x * p.x + y * p.y);
            high_other = std::max(high_other, x * p.x + y * p.y);
        }
        least = std::min(least, std::min(high_one - low_other, high_other - low_one) / std::sqrt(x * x + y * y));
    }
    return least;
}

/// How deep two convex polygons overlap at least; negative when they are apart.
template <typename One, typename Other>
double depth(const One& one, const Other& other) {
    return std::min(depth_across_edges(one, other), depth_across_edges(other, one));
}

/// How far a corner of the second polygon, which is apart, is from an edge of the first.
template <typename One, typename Other>
double distance_of_corners(const One& one, const Other& other) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < one.size(); ++i) {
        const auto &a = one[i], &b = one[(i + 1) % one.size()];
        const double x = b.x - a.x, y = b.y - a.y;
        for (const auto& p : other) {
            const double part = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
            least = std::min(least, std::hypot(p.x - a.x - part * x, p.y - a.y - part * y));
        }
    }
    return least;
}

inline double distance_in_place(const snug::Car& car, const snug::Place& place, const snug::Pose& pose) {
    double least = std::numeric_limits<double>::infinity();
    const auto body = car_at(car, pose, false), wheels = car_at(car, pose, true);
    for (const auto& piece : place.pieces()) {
        const auto& shape = piece.low ? wheels : body;
        least = std::min({least, distance_of_corners(shape, piece.corners), distance_of_corners(piece.corners, shape)});
    }
    return least;
}

inline double depth_in_place(const snug::Car& car, const snug::Place& place, const snug::Pose& pose) {
    double deepest = -std::numeric_limits<double>::infinity();
    const auto body = car_at(car, pose, false), wheels = car_at(car, pose, true);
    for (const auto& piece : place.pieces())
        deepest = std::max(deepest, depth(piece.low ? wheels : body, piece.corners));
    return deepest;
}

/// How far p is outside a convex, counter-clockwise polygon.
inline double outside(const std::vector<snug::Point>& polygon, const Corner& p) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const snug::Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        most =
            std::max(most, ((b.y - a.y) * (p.x - a.x) - (b.x - a.x) * (p.y - a.y)) / std::hypot(b.x - a.x, b.y - a.y));
    }
    return most;
}

inline double outside_region(const snug::Place& place, const snug::Pose& pose) {
    return outside(place.region(), {pose.x, pose.y});
}

/// How far the pose is from being parked; at most 0 when it is.
inline double short_of_parked(const snug::Car& car, const snug::Place& place, const snug::Pose& pose) {
    if (const auto* inside = std::get_if<snug::ParkedInside>(&place.parked())) {
        double most = std::abs(std::remainder(pose.heading - inside->heading, 2 * 3.14159265358979323846)) -
                      inside->heading_tolerance;
        for (const Corner& p : car_at(car, pose, false)) most = std::max(most, outside(inside->corners, p));
        if (inside->beside) {
            const snug::Point &a = inside->beside->from, &b = inside->beside->to;
            double nearest = 1e300;
            for (const Corner& p : car_at(car, pose, false))
                nearest = std::min(nearest, std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) /
                                                std::hypot(b.x - a.x, b.y - a.y));
            most = std::max(most, nearest - inside->beside->distance);
        }
        return most;
    }
    const auto& at = std::get<snug::ParkedAt>(place.parked());
    const double c = std::cos(at.pose.heading), s = std::sin(at.pose.heading), x = pose.x - at.pose.x,
                 y = pose.y - at.pose.y;
    return std::max(
        {std::abs(x * c + y * s) - at.along, std::abs(y * c - x * s) - at.across,
         std::abs(std::remainder(pose.heading - at.pose.heading, 2 * 3.14159265358979323846)) - at.heading});
}

/// Empty when the maneuver is right; else what is wrong.
inline std::string verdict(const snug::Car& car, const snug::Place& place, const snug::Pose& start,
                           const snug::ParkAnswer& answer, double spacing = 0.01) {
    std::ostringstream wrong;
    wrong.precision(12);
    const auto& moves = answer.maneuver->moves;
    snug::Pose at = start;
    int changes = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const auto& move = moves[i];
        if (std::abs(move.start.x - at.x) + std::abs(move.start.y - at.y) + std::abs(move.start.heading - at.heading) >
            1e-9)
            wrong << "move " << i << " does not start where the last one ended; ";
        if (std::abs(move.steering_angle) > car.max_steer() + 1e-12)
            wrong << "move " << i << " steers beyond the limit; ";
        if (i > 0) changes += move.direction != moves[i - 1].direction;
        const double curvature = std::tan(move.steering_angle) / car.wheelbase();
        const double way = move.direction == snug::Direction::forward ? 1.0 : -1.0;
        const auto pose_at = [&](double distance) {
            const double on = way * distance, turned = on * curvature;
            snug::Pose pose = at;
            if (std::abs(turned) < 1e-12) {
                pose.x += on * std::cos(at.heading);
                pose.y += on * std::sin(at.heading);
            } else {
                pose.x += (std::sin(at.heading + turned) - std::sin(at.heading)) / curvature;
                pose.y -= (std::cos(at.heading + turned) - std::cos(at.heading)) / curvature;
            }
            pose.heading += turned;
            return pose;
        };
        const int steps = static_cast<int>(std::ceil(move.length / spacing));
        for (int k = 0; k <= steps; ++k) {
            const snug::Pose pose = pose_at(move.length * k / std::max(1, steps));
            const double deep = depth_in_place(car, place, pose), out = outside_region(place, pose);
            if (deep > 1e-8) {
                wrong << "move " << i << " is " << deep << " m deep in an obstacle after "
                      << move.length * k / std::max(1, steps) << " m; ";
                break;
            }
            if (out > 2e-6) {
                wrong << "move " << i << " leaves the region by " << out << " m; ";
                break;
            }
        }
        const snug::Pose end = pose_at(move.length);
        if (std::abs(move.end.x - end.x) + std::abs(move.end.y - end.y) + std::abs(move.end.heading - end.heading) >
            1e-9)
            wrong << "move " << i << " does not end where it says; ";
        at = move.end;
    }
    if (changes != *answer.direction_changes)
        wrong << changes << " direction changes, not " << *answer.direction_changes << "; ";
    if (const double by = short_of_parked(car, place, at); by > 1e-8) wrong << "not parked, by " << by << "; ";
    return wrong.str();
}

}  // namespace park_test
