// Which outlines can exist, and what can be made of one.
#include "snug/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {
namespace {

constexpr std::size_t most_outline_corners = 256;
constexpr double on_a_line = 1e-9;  // of the outline's size
constexpr int corners_of_an_arc = 6;
using limits::quarter_turn;

/// Twice the area of the triangle, positive where a, b, c turn left.
double turn(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

double distance(const Point& a, const Point& b) { return angles::hypot(b.x - a.x, b.y - a.y); }

std::string at(const Point& point) { return "(" + spelled(point.x) + ", " + spelled(point.y) + ")"; }

void check_numbers(const std::vector<Point>& corners) {
    if (corners.size() < 3 || corners.size() > most_outline_corners)
        throw Error("the outline has " + std::to_string(corners.size()) + " corners, but must have 3 to " +
                    std::to_string(most_outline_corners));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::string name = "outline corner [" + std::to_string(i) + "] ";
        check_between(name + "x", corners[i].x, -limits::longest, limits::longest, " m");
        check_between(name + "y", corners[i].y, -limits::longest, limits::longest, " m");
    }
}

double size_of(const std::vector<Point>& corners) {
    double size = 0.0;
    for (const Point& corner : corners) size = std::max(size, distance(corners.front(), corner));
    return size;
}

double twice_the_area(const std::vector<Point>& corners) {
    double area = 0.0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += (corners[i].x - corners[0].x) * (corners[i + 1].y - corners[0].y) -
                (corners[i].y - corners[0].y) * (corners[i + 1].x - corners[0].x);
    return area;
}

/// Without the corners that are none, because they lie on the line between their neighbours or on one of them.
std::vector<Point> without_flat_corners(std::vector<Point> corners, double near) {
    for (std::size_t i = 0; corners.size() >= 3 && i < corners.size();) {
        const Point& before = corners[(i + corners.size() - 1) % corners.size()];
        const Point& after = corners[(i + 1) % corners.size()];
        const double span = distance(before, after);
        const bool flat = std::abs(turn(before, corners[i], after)) <= near * span ||
                          distance(before, corners[i]) <= near || distance(corners[i], after) <= near;
        const bool between = distance(before, corners[i]) <= span + near && distance(corners[i], after) <= span + near;
        if (flat && between) {
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        } else {
            ++i;
        }
    }
    return corners;
}

/// Every corner turns left, and the edges turn round once in all: each does so by less than half a turn, so their directions
/// cross the positive x axis once.
void check_convex(const std::vector<Point>& corners) {
    int rounds = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& a = corners[i];
        const Point& b = corners[(i + 1) % corners.size()];
        const Point& c = corners[(i + 2) % corners.size()];
        if (!(turn(a, b, c) > 0.0)) throw Error("the outline is not convex at " + at(b) + ", but must be");
        if (b.y - a.y < 0.0 && c.y - b.y >= 0.0) ++rounds;
    }
    if (rounds != 1) throw Error("the outline goes round " + std::to_string(rounds) + " times, but must go round once");
}

std::vector<Point> foremost_first(std::vector<Point> corners) {
    const auto first = std::max_element(corners.begin(), corners.end(), [](const Point& a, const Point& b) {
        return a.x != b.x ? a.x < b.x : a.y < b.y;
    });
    std::rotate(corners.begin(), first, corners.end());
    return corners;
}

std::vector<Point> checked(std::vector<Point> corners) {
    check_numbers(corners);
    const double size = size_of(corners);
    const double area = twice_the_area(corners);
    if (!(std::abs(area) > on_a_line * size * size))
        throw Error("the outline's corners lie on a line, but must hold an area");
    if (area < 0.0) std::reverse(corners.begin(), corners.end());
    corners = without_flat_corners(std::move(corners), on_a_line * size);
    if (corners.size() < 3) throw Error("the outline's corners lie on a line, but must hold an area");
    check_convex(corners);
    return foremost_first(std::move(corners));
}

}  // namespace

Outline::Outline(std::vector<Point> corners, Checked) : corners_(std::move(corners)) {
    front_ = rear_ = left_ = right_ = -limits::longest;
    for (const Point& corner : corners_) {
        front_ = std::max(front_, corner.x);
        rear_ = std::max(rear_, -corner.x);
        left_ = std::max(left_, corner.y);
        right_ = std::max(right_, -corner.y);
    }
}

Outline::Outline(std::vector<Point> corners) : Outline(checked(std::move(corners)), Checked{}) {}

Outline Outline::rectangle(double front, double rear, double side) {
    return Outline({{front, side}, {-rear, side}, {-rear, -side}, {front, -side}}, Checked{});
}

Outline Outline::rounded(double front, double rear, double side, double front_radius, double rear_radius) {
    check_between("corner radius in front", front_radius, 0.0, side, " m");
    check_between("corner radius behind", rear_radius, 0.0, side, " m");
    if (front_radius + rear_radius > front + rear)
        throw Error("the corner radii are " + spelled(front_radius) + " and " + spelled(rear_radius) +
                    " m, but must fit into the car's length of " + spelled(front + rear) + " m");
    std::vector<Point> corners;
    // The corners between tangents at equal angles, the first and the last of which are the rectangle's sides.
    const double half_step = quarter_turn / (2.0 * corners_of_an_arc);
    for (int quarter = 0; quarter < 4; ++quarter) {
        const bool ahead = quarter == 0 || quarter == 3;
        const bool to_the_left = quarter < 2;
        const double radius = ahead ? front_radius : rear_radius;
        const Point square = {ahead ? front : -rear, to_the_left ? side : -side};
        if (radius == 0.0) {
            corners.push_back(square);
            continue;
        }
        const Point middle = {square.x - (ahead ? radius : -radius), square.y - (to_the_left ? radius : -radius)};
        const double reach = radius / angles::cos(half_step);
        for (int i = 0; i < corners_of_an_arc; ++i) {
            // Symmetric to the bit: every quarter is the first one's image.
            const int step = quarter % 2 == 0 ? i : corners_of_an_arc - 1 - i;
            const auto [s, c] = angles::sine_cosine(half_step * (2 * step + 1));
            // The outermost lie on the sides themselves.
            const double x = step == 0 ? radius : reach * c;
            const double y = step + 1 == corners_of_an_arc ? radius : reach * s;
            corners.push_back({middle.x + (ahead ? x : -x), middle.y + (to_the_left ? y : -y)});
        }
    }
    return Outline(std::move(corners));
}

Outline Outline::grown(double by) const {
    if (by == 0.0) return *this;
    std::vector<Point> grown;
    grown.reserve(corners_.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Point& before = corners_[(i + corners_.size() - 1) % corners_.size()];
        const Point& corner = corners_[i];
        const Point& after = corners_[(i + 1) % corners_.size()];
        const double in = distance(before, corner);
        const double out = distance(corner, after);
        const Point from = {(corner.y - before.y) / in, (before.x - corner.x) / in};  // outward normals
        const Point to = {(after.y - corner.y) / out, (corner.x - after.x) / out};
        const double along = by / (1.0 + from.x * to.x + from.y * to.y);
        grown.push_back({corner.x + along * (from.x + to.x), corner.y + along * (from.y + to.y)});
    }
    return Outline(std::move(grown), Checked{});
}

Outline Outline::mirrored() const {
    std::vector<Point> corners(corners_.rbegin(), corners_.rend());
    for (Point& corner : corners) corner.y = -corner.y;
    return Outline(foremost_first(std::move(corners)), Checked{});
}

Outline Outline::turned_about() const {
    std::vector<Point> corners(corners_.rbegin(), corners_.rend());
    for (Point& corner : corners) corner.x = -corner.x;
    return Outline(foremost_first(std::move(corners)), Checked{});
}

}  // namespace snug
