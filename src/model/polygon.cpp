#include "model/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace snug::detail {

double area(const std::vector<Point>& corners) {
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) twice += turn(corners[0], corners[i], corners[i + 1]);
    return twice / 2.0;
}

namespace {

bool on_segment(const Point& p, const Point& a, const Point& b) {
    return turn(a, b, p) == 0.0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool touch(const Point& a, const Point& b, const Point& c, const Point& d) {
    const double c_side = turn(a, b, c), d_side = turn(a, b, d), a_side = turn(c, d, a), b_side = turn(c, d, b);
    if (((c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0)) &&
        ((a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0)))
        return true;
    return on_segment(c, a, b) || on_segment(d, a, b) || on_segment(a, c, d) || on_segment(b, c, d);
}

/// Whether the corner b lies on the line between a and c, as far as numbers tell.
bool idle(const Point& a, const Point& b, const Point& c) {
    const double along = std::max(std::abs(c.x - a.x), std::abs(c.y - a.y));
    return std::abs(turn(a, b, c)) <= 1e-12 * std::max(1.0, along) &&
           (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) >= 0.0;
}

}  // namespace

bool crosses_itself(const std::vector<Point>& corners) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const Point &a = corners[i], &b = corners[(i + 1) % n], &c = corners[j], &d = corners[(j + 1) % n];
            if (j == i + 1 ? on_segment(d, a, b) : (j + 1) % n == i ? on_segment(c, a, b) : touch(a, b, c, d))
                return true;
        }
    }
    return false;
}

std::vector<Point> without_idle_corners(const std::vector<Point>& corners) {
    std::vector<Point> kept = corners;
    for (std::size_t i = 0; i < kept.size() && kept.size() > 3;) {
        const std::size_t n = kept.size();
        if (idle(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n])) {
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
            i = i == 0 ? 0 : i - 1;
        } else {
            ++i;
        }
    }
    return kept;
}

bool is_convex(const std::vector<Point>& corners) {
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0.0) return false;
    return true;
}

namespace {

/// Cuts off one ear after the other.
std::vector<std::vector<Point>> triangles(std::vector<Point> rest) {
    std::vector<std::vector<Point>> cut;
    while (rest.size() > 3) {
        const std::size_t n = rest.size();
        std::size_t ear = 0;
        double roundest = -1.0;
        for (std::size_t i = 0; i < n; ++i) {
            const Point &a = rest[(i + n - 1) % n], &b = rest[i], &c = rest[(i + 1) % n];
            if (!(turn(a, b, c) > 0.0)) continue;
            bool empty = true;
            for (std::size_t k = 0; k < n && empty; ++k) {
                if (k == i || k == (i + 1) % n || k == (i + n - 1) % n) continue;
                const Point& p = rest[k];
                empty = turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0;
            }
            const double across = (c.x - a.x) * (c.x - a.x) + (c.y - a.y) * (c.y - a.y);
            if (empty && turn(a, b, c) / across > roundest) {
                roundest = turn(a, b, c) / across;
                ear = i;
            }
        }
        cut.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    cut.push_back(std::move(rest));
    return cut;
}

bool same(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

/// Two pieces with a common edge as one, if that is convex.
std::vector<Point> joined(const std::vector<Point>& one, const std::vector<Point>& other) {
    for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = 0; j < other.size(); ++j) {
            if (!same(one[i], other[(j + 1) % other.size()]) || !same(one[(i + 1) % one.size()], other[j])) continue;
            std::vector<Point> both;
            for (std::size_t k = 1; k <= one.size(); ++k) both.push_back(one[(i + k) % one.size()]);
            for (std::size_t k = 2; k < other.size(); ++k) both.push_back(other[(j + k) % other.size()]);
            if (is_convex(both)) return both;
        }
    }
    return {};
}

}  // namespace

std::vector<std::vector<Point>> convex_pieces(const std::vector<Point>& corners) {
    if (is_convex(corners)) return {corners};
    std::vector<std::vector<Point>> pieces = triangles(corners);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = i + 1; j < pieces.size();) {
            std::vector<Point> both = joined(pieces[i], pieces[j]);
            if (both.empty()) {
                ++j;
                continue;
            }
            pieces[i] = std::move(both);
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(j));
            j = i + 1;
        }
    }
    return pieces;
}

std::vector<Point> grown_polygon(const std::vector<Point>& corners, double by) {
    std::vector<Point> grown;
    const std::size_t n = corners.size();
    const auto normal = [&](std::size_t i) {
        const Point &from = corners[i % n], &to = corners[(i + 1) % n];
        const double x = to.x - from.x, y = to.y - from.y, along = std::sqrt(x * x + y * y);
        return Point{y / along, -x / along};
    };
    for (std::size_t i = 0; i < n; ++i) {
        // Where the two edges that meet here meet then.
        const Point a = normal(i + n - 1), b = normal(i);
        const double share = by / (1.0 + a.x * b.x + a.y * b.y);
        grown.push_back({corners[i].x + share * (a.x + b.x), corners[i].y + share * (a.y + b.y)});
    }
    return grown;
}

}  // namespace snug::detail
