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

EntryShape::EntryShape(const Problem& problem) : corner(entry_corner(problem)) {
    const std::vector<Point>& corners = problem.body.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& next = corners[(i + 1) % corners.size()];
        edges.push_back({{corners[i].x - corner.x, corners[i].y - corner.y}, outward(direction(corners[i], next))});
        if (next == corner) before = edges.back().normal;
        if (corners[i] == corner) after = edges.back().normal;
    }
    for (const Point& own : problem.at_curb.corners()) at_curb.push_back({own.x - corner.x, own.y - corner.y});
}

double EntryShape::clears(const Problem& problem, double c, double s) const {
    const auto turned_x = [&](const Point& p) { return p.x * c - p.y * s; };
    const auto turned_y = [&](const Point& p) { return p.x * s + p.y * c; };
    const double size = problem.length + problem.body.front() + problem.body.rear() + problem.radius;

    // The front neighbour lies beyond a line through the corner that the body does not cross.
    double least = std::min(first_move_clears(problem, corner, c, s), -turned_y(before) * size);
    if (turned_y(after) <= 0.0) least = std::min(least, turned_x(after) * size);

    for (const Point& own : at_curb) least = std::min(least, turned_y(own) + problem.width - problem.front_setback);

    const Point rear = rear_corner(problem);
    double left = std::numeric_limits<double>::infinity();
    double low = left;
    double apart = -left;
    for (const Edge& edge : edges) {
        const double x = turned_x(edge.corner);
        const double y = turned_y(edge.corner);
        left = std::min(left, x);
        low = std::min(low, y);
        const Point normal = {turned_x(edge.normal), turned_y(edge.normal)};
        if (normal.x > 0.0 || normal.y > 0.0) continue;
        apart = std::max(apart, normal.x * (rear.x - x) + normal.y * (rear.y - y));
    }
    return std::min(least, std::max({apart, left - rear.x, low - rear.y}));
}

bool is_possible(const Problem& problem, const EntryShape& shape, double heading, double c, double s) {
    if (!(c >= 0.0 && s >= 0.0)) return false;
    const double size = problem.length + problem.body.front() + problem.body.rear() + problem.radius;
    double clears = shape.clears(problem, c, s);
    if (problem.front_setback == 0.0 && problem.rear_setback == 0.0)
        clears = std::min(clears, problem.length - problem.body.front() - problem.body.rear());
    if (std::abs(clears) > 1e-9 * size) return clears > 0.0;
    return lies_in(possible_headings(problem, shape), heading);
}

std::vector<Headings> possible_headings(const Problem& problem) {
    return possible_headings(problem, EntryShape(problem));
}

std::vector<Headings> possible_headings(const Problem& problem, const EntryShape& shape) {
    const bool open = problem.front_setback > 0.0 || problem.rear_setback > 0.0;
    if (!open && problem.body.front() + problem.body.rear() > problem.length) return {};
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
    for (const Point& own : shape.at_curb) roots(own.y, own.x, problem.front_setback - problem.width, cut);
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
