// Polygons: orientation, whether one crosses itself, and cutting it into convex pieces.
#pragma once

#include <vector>

#include "snug/geometry.hpp"

namespace snug::detail {

/// Positive where a, b, c turn left: twice the triangle's area.
inline double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Positive when the corners run counter-clockwise. [m^2]
double area(const std::vector<Point>& corners);

/// Whether two edges that are not neighbours touch, or neighbours lie on one another.
bool crosses_itself(const std::vector<Point>& corners);

/// Without repeated corners, and corners on a line between their neighbours.
std::vector<Point> without_idle_corners(const std::vector<Point>& corners);

/// Whether no corner of a counter-clockwise polygon turns right.
bool is_convex(const std::vector<Point>& corners);

/// Convex pieces that together are the simple, counter-clockwise polygon.
std::vector<std::vector<Point>> convex_pieces(const std::vector<Point>& corners);

/// A convex, counter-clockwise polygon with every edge moved outward.
std::vector<Point> grown_polygon(const std::vector<Point>& corners, double by);

}  // namespace snug::detail
