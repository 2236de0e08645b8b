// The two corners at the ends of a car's right side: where they are, the car is in or out.
#pragma once

#include <algorithm>
#include <cmath>

#include "snug/outline.hpp"

namespace snug::detail {

/// The foremost and the rearmost of the corners farthest to the right: one and the same where the outline is pointed there.
struct RightSide {
    Point front, rear;

    explicit RightSide(const Outline& outline) {
        // Growing an outline may leave one end of an edge a rounding farther out than the other.
        const double near = 1e-12 * (outline.left() + outline.right() + outline.front() + outline.rear());
        bool first = true;
        for (const Point& corner : outline.corners()) {
            if (corner.y > near - outline.right()) continue;
            if (first || corner.x > front.x) front = corner;
            if (first || corner.x < rear.x) rear = corner;
            first = false;
        }
    }
};

}  // namespace snug::detail
