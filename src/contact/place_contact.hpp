// First contact of a convex car among convex solids, exactly: while it drives an arc or a straight line.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "snug/geometry.hpp"

namespace snug::detail {

/// Driving with constant steering.
struct Path {
    Pose start;
    double curvature = 0.0;  ///< positive to the left; 0: straight [1/m]
    double way = 1.0;        ///< 1 forward, -1 backward
    double length = 0.0;     ///< [m]

    [[nodiscard]] Pose at(double distance) const;
};

/// Corners of a shape about the rear axle, at a pose.
std::vector<Point> placed(const std::vector<Point>& shape, const Pose& pose);

/// How far one of two convex polygons, both counter-clockwise, must at least be moved to part them; negative where they are
/// apart: then it is no more than their distance. [m]
double overlap(const std::vector<Point>& one, const std::vector<Point>& other);
/// The same of so many corners each.
double overlap(const Point* one, std::size_t corners, const Point* other, std::size_t other_corners);
/// How far two convex polygons are apart, or, negative, what overlap() says. [m]
double distance(const Point* one, std::size_t corners, const Point* other, std::size_t other_corners);

constexpr double never = std::numeric_limits<double>::infinity();

/// How far the shape, counter-clockwise about the rear axle, drives before it is `touch` [m] deep in the solid (also
/// counter-clockwise); `never` when that is not within the path. What is in it already is no contact. [m]
double first_contact(const std::vector<Point>& shape, const Path& path, const std::vector<Point>& solid, double touch);

}  // namespace snug::detail
