// An edge of an outline: which way it leads and which way it faces.
#pragma once

#include <cmath>

#include "model/angles.hpp"
#include "snug/geometry.hpp"

namespace snug::detail {

/// The unit vector from one corner to the next.
inline Point direction(const Point& from, const Point& to) {
    const double x = to.x - from.x;
    const double y = to.y - from.y;
    const double length = x == 0.0 ? std::abs(y) : y == 0.0 ? std::abs(x) : angles::hypot(x, y);
    return {x / length, y / length};
}

/// The outward normal of an edge that leads this way, counter-clockwise around its outline.
inline Point outward(const Point& way) { return {way.y, -way.x}; }

}  // namespace snug::detail
