// Outline: a car seen from above, a convex polygon about the middle of its rear axle.
#pragma once

#include <vector>

#include "snug/geometry.hpp"

namespace snug {

/// A convex polygon with x ahead and y to the left of the middle of the rear axle. A rectangle is one.
class Outline {
public:
    /// `corners` in either order, 3 to 256 of them [m]. They are kept counter-clockwise, beginning with the foremost (of
    /// several the leftmost); those that lie on the line between their neighbours, to a billionth of the size, are left out.
    /// Throws Error when they are too few or too many, no numbers, farther than 1e6 m away, not convex, or hold no area.
    explicit Outline(std::vector<Point> corners);

    /// The rectangle that reaches so far ahead, behind and to either side. [m]
    static Outline rectangle(double front, double rear, double side);
    /// That rectangle with its corners rounded by two radii [m], 0 to `side`: six corners of a polygon around each arc,
    /// nowhere inside it, at most a hundred-and-sixteenth of the radius outside. Throws Error when they do not fit.
    static Outline rounded(double front, double rear, double side, double front_radius, double rear_radius);

    [[nodiscard]] const std::vector<Point>& corners() const { return corners_; }
    /// How far the outline reaches ahead, behind, to the left and to the right. [m]
    [[nodiscard]] double front() const { return front_; }
    [[nodiscard]] double rear() const { return rear_; }
    [[nodiscard]] double left() const { return left_; }
    [[nodiscard]] double right() const { return right_; }

    /// With every edge moved outward by a distance that is not negative [m]; sharp corners stay sharp and move farther.
    [[nodiscard]] Outline grown(double by) const;
    /// Left and right exchanged.
    [[nodiscard]] Outline mirrored() const;
    /// Front and rear exchanged: the car that drives nose first where this one drives tail first.
    [[nodiscard]] Outline turned_about() const;

    friend bool operator==(const Outline&, const Outline&) = default;

private:
    friend class Car;  // whose wheels may lie nearly on a line
    struct Checked {};
    Outline(std::vector<Point> corners, Checked);

    std::vector<Point> corners_;
    double front_ = 0.0;
    double rear_ = 0.0;
    double left_ = 0.0;
    double right_ = 0.0;
};

}  // namespace snug
