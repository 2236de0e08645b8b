// Whether a car keeps its distance from everything on the whole of a clothoid: bracketed, so that nothing is missed.
#pragma once

#include <cstddef>
#include <vector>

#include "snug/car.hpp"
#include "snug/place.hpp"
#include "snug/rolling.hpp"

namespace snug::detail {

/// A car among the convex solids of a place.
class RollingContact {
public:
    RollingContact(const Car& car, const Place& place, double clearance);

    /// No point of the car is nearer to a solid than this, what is to be kept taken off; at most `enough`, which saves work.
    /// Negative where they overlap: how far they do not have to be moved apart. [m]
    [[nodiscard]] double room(const Pose& pose, double enough) const;

    /// Whether more than `least` [m] of room is left everywhere on the piece, and the rear axle's middle stays in the region.
    ///
    /// A point of the car at (x, y) about the rear axle moves by hypot(1 - curvature y, curvature x) for every metre driven;
    /// that is convex in both the point and the curvature, so it is greatest at a corner and at an end of the piece. Call it q.
    /// Where there is room d in the middle of a stretch of length s, there is at least d - q s / 2 on all of it. So a stretch is
    /// halved until that is enough, or until there is too little in the middle: which happens, for the stretch shrinks.
    [[nodiscard]] bool keeps(const RollingPiece& piece, double least) const;

private:
    struct Shape {
        std::vector<Point> corners, normals;  ///< outward, of the edge that begins at the corner
        double reach = 0.0;                   ///< farthest corner from the rear axle's middle
    };
    struct Solid {
        Shape shape;
        std::size_t stops = 0;  ///< which of the car's shapes
        double x_min = 0.0, x_max = 0.0, y_min = 0.0, y_max = 0.0;
    };
    [[nodiscard]] bool stays_in_region(const RollingPiece& piece, double bend) const;
    static Shape shape_of(const std::vector<Point>& corners);
    [[nodiscard]] double apart(const Shape& car, const Shape& solid, const Pose& pose, double sine,
                               double cosine) const;
    [[nodiscard]] bool keeps(const RollingPiece& piece, double from, double to, double quickest, double least) const;

    std::vector<Shape> shapes_;
    std::vector<Solid> solids_;
    Shape region_;
};

}  // namespace snug::detail
