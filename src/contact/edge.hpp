// An edge of an outline: which way it leads and which way it faces.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/few.hpp"
#include "model/angles.hpp"
#include "snug/geometry.hpp"
#include "snug/outline.hpp"

namespace snug::detail {

/// The unit vector from one corner to the next.
inline Point direction(const Point& from, const Point& to) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length = x == 0.0 ? std::abs(y) : y == 0.0 ? std::abs(x) : angles::hypot(x, y);
    return {x / length, y / length};
}

/// Those of an outline's edges, one after the other.
inline Few<Point, 4> directions(const Outline& outline) {
    const std::vector<Point>& corners = outline.corners();
    Few<Point, 4> ways;
    ways.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
        ways[i] = direction(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
    return ways;
}

/// The outward normal of an edge that leads this way, counter-clockwise around its outline.
inline Point outward(const Point& way) { return {way.y, -way.x}; }

}  // namespace snug::detail
