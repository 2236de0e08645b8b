#include "contact/rolling_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/edge_gaps.hpp"
#include "model/angles.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

RollingContact::Shape RollingContact::shape_of(const std::vector<Point>& corners) {
    Shape shape;
    shape.corners = corners;
    shape.normals = outward_normals(corners);
    for (const Point& p : corners) shape.reach = std::max(shape.reach, angles::hypot(p.x, p.y));
    return shape;
}

RollingContact::RollingContact(const Car& car, const Place& place, double clearance)
    : region_(shape_of(place.region())) {
    std::vector<double> keeps;
    for (const Place::Piece& piece : place.pieces()) {
        Solid solid;
        solid.shape = shape_of(piece.corners);
        solid.x_min = solid.y_min = std::numeric_limits<double>::infinity();
        solid.x_max = solid.y_max = -solid.x_min;
        for (const Point& p : piece.corners) {
            solid.x_min = std::min(solid.x_min, p.x);
            solid.x_max = std::max(solid.x_max, p.x);
            solid.y_min = std::min(solid.y_min, p.y);
            solid.y_max = std::max(solid.y_max, p.y);
        }
        // -1 stands for the wheels.
        const double keep = piece.low ? -1.0 : place.obstacles()[piece.obstacle].clearance.value_or(clearance);
        solid.stops = static_cast<std::size_t>(std::find(keeps.begin(), keeps.end(), keep) - keeps.begin());
        if (solid.stops == keeps.size()) {
            keeps.push_back(keep);
            shapes_.push_back(shape_of(keep < 0.0 ? car.wheels().corners() : car.outline().grown(keep).corners()));
        }
        solids_.push_back(std::move(solid));
    }
}

/// The widest gap in the direction of an edge of either.
double RollingContact::apart(const Shape& car, const Shape& solid, const Pose& pose, double sine, double cosine) const {
    double most = -std::numeric_limits<double>::infinity();
    for_each_edge_gap(car.corners, car.normals, solid.corners, solid.normals, pose, sine, cosine,
                      [&most](double gap) { most = std::max(most, gap); });
    return most;
}

double RollingContact::room(const Pose& pose, double enough) const {
    const auto [sine, cosine] = angles::sine_cosine(pose.heading);
    double least = enough;
    for (const Solid& solid : solids_) {
        const Shape& car = shapes_[solid.stops];
        const double beyond =
            std::max({solid.x_min - pose.x, pose.x - solid.x_max, solid.y_min - pose.y, pose.y - solid.y_max});
        if (beyond - car.reach >= least) continue;
        least = std::min(least, apart(car, solid.shape, pose, sine, cosine));
    }
    return least;
}

bool RollingContact::keeps(const RollingPiece& piece, double least) const {
    double quickest = 0.0;
    for (const Shape& shape : shapes_)
        for (const Point& p : shape.corners)
            for (const double bend : {piece.curvature, piece.curvature_at(piece.length)})
                quickest = std::max(quickest, angles::hypot(1.0 - bend * p.y, bend * p.x));
    const double bend = std::max(std::abs(piece.curvature), std::abs(piece.curvature_at(piece.length)));
    return stays_in_region(piece, bend) && keeps(piece, 0.0, piece.length, quickest, least);
}

/// How far a point is beyond an edge changes along the piece with a second derivative of at most the curvature: on either half it
/// is at most what a straight line between the ends has, and curvature u (h - u) / 2 at u of its length h. So it is enough that
/// the middle lies within by curvature h^2 / 2, and the ends lie within.
bool RollingContact::stays_in_region(const RollingPiece& piece, double bend) const {
    const Pose middle = piece.at(piece.length / 2.0), end = piece.at(piece.length);
    const double bulge = bend * piece.length * piece.length / 8.0;
    for (std::size_t i = 0; i < region_.corners.size(); ++i) {
        const Point n = region_.normals[i], from = region_.corners[i];
        if (n.x * (middle.x - from.x) + n.y * (middle.y - from.y) > limits::touching - bulge) return false;
        if (n.x * (end.x - from.x) + n.y * (end.y - from.y) > limits::touching) return false;
    }
    return true;
}

bool RollingContact::keeps(const RollingPiece& piece, double from, double to, double quickest, double least) const {
    constexpr double rounding = 1e-9;  // of poses far out in the world
    const double middle = (from + to) / 2.0;
    const double needed = least + quickest * (to - from) / 2.0 + rounding;
    const double room_here = room(piece.at(middle), needed);
    if (room_here >= needed) return true;
    if (room_here <= least + 2.0 * rounding) return false;
    return keeps(piece, from, middle, quickest, least) && keeps(piece, middle, to, quickest, least);
}

}  // namespace snug::detail
