// How far a car is from the obstacles of a place, and with which of its parts.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/place_contact.hpp"
#include "contact/turning.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"

namespace snug {

namespace {

using namespace detail;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }

/// How far a point is from the edge between two corners, and where along it, 0 to 1.
struct FromEdge {
    double distance, part;

    FromEdge(const Point& p, const Point& from, const Point& to) {
        const Point along = minus(to, from);
        part = std::clamp(dot(minus(p, from), along) / dot(along, along), 0.0, 1.0);
        distance = angles::hypot(p.x - from.x - part * along.x, p.y - from.y - part * along.y);
    }
};

/// The gap between a shape at a pose and a solid. A corner is named before an edge.
PlaceGap gap(const Outline& outline, const std::vector<Point>& car, const std::vector<Point>& solid) {
    PlaceGap nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    const auto name = [&](std::size_t index, bool edge) {
        const std::vector<Point>& corners = outline.corners();
        nearest.part_index = index;
        nearest.part = edge ? edge_at(outline, corners[index], corners[(index + 1) % corners.size()])
                            : corner_at(outline, corners[index]);
    };
    for (std::size_t i = 0; i < car.size(); ++i) {
        const Point& next = car[(i + 1) % car.size()];
        for (std::size_t k = 0; k < solid.size(); ++k) {
            const FromEdge corner(car[i], solid[k], solid[(k + 1) % solid.size()]);
            if (corner.distance < nearest.distance) {
                nearest.distance = corner.distance;
                name(i, false);
            }
            const FromEdge edge(solid[k], car[i], next);
            if (edge.distance < nearest.distance && edge.part > 0.0 && edge.part < 1.0) {
                nearest.distance = edge.distance;
                name(i, true);
            }
        }
    }
    const double deep = overlap(car, solid);
    if (deep > 0.0) nearest.distance = -deep;
    return nearest;
}

}  // namespace

std::vector<PlaceGap> gaps(const Car& car, const Place& place, const Pose& pose, double clearance) {
    check_between("clearance", clearance, 0.0, 1e6, " m");
    std::vector<PlaceGap> all(place.obstacles().size());
    for (PlaceGap& of : all) of.distance = std::numeric_limits<double>::infinity();
    for (const Place::Piece& piece : place.pieces()) {
        const double keeps = piece.low ? 0.0 : place.obstacles()[piece.obstacle].clearance.value_or(clearance);
        const Outline outline = piece.low ? car.wheels() : car.outline().grown(keeps);
        // About the car's own place, where numbers stay small even if the place lies far out in the world.
        std::vector<Point> solid;
        for (const Point& corner : piece.corners) solid.push_back({corner.x - pose.x, corner.y - pose.y});
        PlaceGap of = gap(outline, placed(outline.corners(), {0.0, 0.0, pose.heading}), solid);
        if (piece.low) of.part = wheel(of.part);
        if (of.distance < all[piece.obstacle].distance) all[piece.obstacle] = of;
    }
    return all;
}

}  // namespace snug
