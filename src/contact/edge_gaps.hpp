// How far two convex polygons are apart in the direction of each of their edges.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "contact/few.hpp"
#include "model/angles.hpp"
#include "snug/geometry.hpp"

namespace snug::detail {

/// Of the edge that begins at each corner, of a polygon that is counter-clockwise.
inline std::vector<Point> outward_normals(const std::vector<Point>& corners) {
    std::vector<Point> normals;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const double length = angles::hypot(b.x - a.x, b.y - a.y);
        normals.push_back({(b.y - a.y) / length, (a.x - b.x) / length});
    }
    return normals;
}

/// Tells `each` the gap along every edge of a solid, then of a shape about the rear axle at the pose; negative where they overlap
/// as seen along it. The widest is no more than their distance, and how far they do not have to be moved apart.
template <class Each>
void for_each_edge_gap(const std::vector<Point>& shape, const std::vector<Point>& shape_normals,
                       const std::vector<Point>& solid, const std::vector<Point>& solid_normals, const Pose& pose,
                       double sine, double cosine, Each&& each) {
    // Few polygons have more corners: these lie in place.
    Few<Point, 64> there, seen;
    for (const Point& p : shape)
        there.push_back({pose.x + cosine * p.x - sine * p.y, pose.y + sine * p.x + cosine * p.y});
    for (const Point& p : solid) {
        const double x = p.x - pose.x, y = p.y - pose.y;
        seen.push_back({cosine * x + sine * y, cosine * y - sine * x});
    }
    const auto along = [&each](const std::vector<Point>& edges, const std::vector<Point>& normals,
                               const Few<Point, 64>& points) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Point n = normals[i], from = edges[i];
            double nearest = std::numeric_limits<double>::infinity();
            for (const Point& p : points) nearest = std::min(nearest, n.x * (p.x - from.x) + n.y * (p.y - from.y));
            each(nearest);
        }
    };
    along(solid, solid_normals, there);
    along(shape, shape_normals, seen);
}

}  // namespace snug::detail
