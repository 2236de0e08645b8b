#include "contact/entry_corner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contact/crossing.hpp"
#include "contact/edge.hpp"
#include "model/angles.hpp"

namespace snug::detail {

namespace {

constexpr double plainly = 1e-9;  ///< by this part of the size it is not a matter of rounding

/// Of the rear neighbour, seen from the front one's corner.
Point rear_corner(const Problem& problem) { return {-problem.length, problem.front_setback - problem.rear_setback}; }

/// How far the first move starts away from the front side; negative: into it. [m]
double first_move_clears(const Problem& problem, const Point& corner, double c, double s) {
    return (problem.radius - corner.y) * c - corner.x * s;
}

}  // namespace

Point entry_corner(const Problem& problem) {
    Point farthest;
    double most = -1.0;
    for (const Point& corner : problem.body.corners()) {
        const double across = problem.radius - corner.y;
        const double square = corner.x * corner.x + across * across;
        if (!(corner.x > 0.0) || square <= most) continue;
        most = square;
        farthest = corner;
    }
    return farthest;
}

Pose entry_pose(const Problem& problem, const Point& corner, double heading) {
    const auto [s, c] = angles::sine_cosine(heading);
    return {corner.y * s - corner.x * c, -corner.x * s - corner.y * c - problem.front_setback, heading};
}

EntryShape::EntryShape(const Problem& problem) : EntryShape(problem, directions(problem.body)) {}

EntryShape::EntryShape(const Problem& problem, const Few<Point, 4>& ways) : corner(entry_corner(problem)) {
    const std::vector<Point>& corners = problem.body.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& next = corners[i + 1 == corners.size() ? 0 : i + 1];
        edges.push_back({{corners[i].x - corner.x, corners[i].y - corner.y}, outward(ways[i])});
        if (next == corner) before = edges.back().normal;
        if (corners[i] == corner) after = edges.back().normal;
    }
    if (problem.at_curb == problem.body) return;
    for (const Point& own : problem.at_curb.corners()) at_curb.push_back({own.x - corner.x, own.y - corner.y});
}

double EntryShape::clears(const Problem& problem, double c, double s) const {
    const auto turned_x = [&](const Point& p) { return p.x * c - p.y * s; };
    const auto turned_y = [&](const Point& p) { return p.x * s + p.y * c; };
    const double size = problem.length + problem.body.front() + problem.body.rear() + problem.radius;

    // The front neighbour lies beyond a line through the corner that the body does not cross.
    double least = std::min(first_move_clears(problem, corner, c, s), -turned_y(before) * size);
    if (turned_y(after) <= 0.0) least = std::min(least, turned_x(after) * size);

    const Point rear = rear_corner(problem);
    double left = std::numeric_limits<double>::infinity();
    double low = left;
    for (const Edge& edge : edges) {
        left = std::min(left, turned_x(edge.corner));
        low = std::min(low, turned_y(edge.corner));
    }
    double lowest_at_curb = at_curb.empty() ? low : std::numeric_limits<double>::infinity();
    for (const Point& own : at_curb) lowest_at_curb = std::min(lowest_at_curb, turned_y(own));
    least = std::min(least, lowest_at_curb + problem.width - problem.front_setback);

    double apart = std::max(left - rear.x, low - rear.y);
    if (apart > plainly * size) return std::min(least, apart);
    for (const Edge& edge : edges) {
        const Point normal = {turned_x(edge.normal), turned_y(edge.normal)};
        if (normal.x > 0.0 || normal.y > 0.0) continue;
        const Point at = {turned_x(edge.corner), turned_y(edge.corner)};
        apart = std::max(apart, normal.x * (rear.x - at.x) + normal.y * (rear.y - at.y));
    }
    return std::min(least, apart);
}

bool is_possible(const Problem& problem, const EntryShape& shape, double heading, double c, double s) {
    if (!(c >= 0.0 && s >= 0.0)) return false;
    const double size = problem.length + problem.body.front() + problem.body.rear() + problem.radius;
    const double clears = shape.clears(problem, c, s);
    if (std::abs(clears) > plainly * size) return clears > 0.0;
    return lies_in(possible_headings(problem, shape), heading);
}

std::vector<Headings> possible_headings(const Problem& problem) {
    return possible_headings(problem, EntryShape(problem));
}

std::vector<Headings> possible_headings(const Problem& problem, const EntryShape& shape) {
    const Point& corner = shape.corner;
    const Point rear = rear_corner(problem);
    Few<Bearing, 48> cuts;
    cuts.push_back({1.0, 0.0});
    const auto cut = [&](const Bearing& at) {
        if (at.c > 0.0 && at.s > 0.0) cuts.push_back(at);
    };
    roots(shape.before.y, shape.before.x, 0.0, cut);
    roots(shape.after.x, -shape.after.y, 0.0, cut);
    roots(problem.radius - corner.y, -corner.x, 0.0, cut);
    const auto meets_curb = [&](const Point& own) { roots(own.y, own.x, problem.front_setback - problem.width, cut); };
    for (const Point& own : shape.at_curb) meets_curb(own);
    if (shape.at_curb.empty())
        for (const EntryShape::Edge& edge : shape.edges) meets_curb(edge.corner);
    for (const EntryShape::Edge& edge : shape.edges) {
        roots(edge.corner.x, -edge.corner.y, rear.x, cut);
        roots(edge.corner.y, edge.corner.x, rear.y, cut);
        roots(rear.x * edge.normal.x + rear.y * edge.normal.y, rear.y * edge.normal.x - rear.x * edge.normal.y,
              edge.normal.x * edge.corner.x + edge.normal.y * edge.corner.y, cut);
    }
    std::sort(cuts.begin() + 1, cuts.end(), [](const Bearing& a, const Bearing& b) { return a.order() < b.order(); });
    cuts.push_back({0.0, 1.0});

    const auto is_possible = [&](double c, double s) { return shape.clears(problem, c, s) >= -problem.touch; };
    std::vector<Headings> possible;
    bool before = is_possible(1.0, 0.0);
    if (before) possible.push_back({0.0, 0.0});
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double c = cuts[i].c + cuts[i + 1].c;
        const double s = cuts[i].s + cuts[i + 1].s;
        const double length = std::sqrt(c * c + s * s);
        const bool here = is_possible(c / length, s / length);
        if (here) {
            const double max = angles::atan2(cuts[i + 1].s, cuts[i + 1].c);
            if (before) {
                possible.back().max = max;
            } else {
                possible.push_back({angles::atan2(cuts[i].s, cuts[i].c), max});
            }
        }
        before = here;
    }
    return possible;
}

}  // namespace snug::detail
