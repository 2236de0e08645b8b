#include "contact/place_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "contact/few.hpp"
#include "model/angles.hpp"

namespace snug::detail {

namespace {

constexpr double full_turn = 6.283185307179586;

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }

/// The outward normal of the edge that begins at `from`, and how long it is.
struct Edge {
    Point from, along, normal;
    double length;

    template <class Polygon>
    Edge(const Polygon& polygon, std::size_t i) : from(polygon[i]) {
        const Point to = polygon[(i + 1) % polygon.size()];
        length = angles::hypot(to.x - from.x, to.y - from.y);
        along = {(to.x - from.x) / length, (to.y - from.y) / length};
        normal = {along.y, -along.x};
    }
    /// Whether a point on the edge's line lies between its ends.
    [[nodiscard]] bool holds(const Point& p, double touch) const {
        const double at = dot(along, minus(p, from));
        return at >= -touch && at <= length + touch;
    }
};

/// The angle, turned in the given sense (1 counter-clockwise) from 0 on, at which p about the origin sinks through
/// normal . p = level; `never` if it does not within a full turn.
double sinking_angle(const Point& p, const Point& normal, double level, double sense) {
    const double a = dot(p, normal), b = p.x * normal.y - p.y * normal.x;
    const double radius = angles::hypot(a, b);
    if (!(std::abs(level) < radius)) return never;
    // normal . p = radius cos(turned - highest) falls on the half turn after the highest place.
    const double highest = angles::atan2(b, a);
    const double across = std::sqrt((radius - level) * (radius + level));
    double turned = sense * highest + angles::atan2(across, level);
    while (turned < 0.0) turned += full_turn;
    while (turned >= full_turn) turned -= full_turn;
    return turned;
}

Point turned_by(const Point& p, double sine, double cosine) {
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
}

/// How far the corners of `moving` drive until one sinks into an edge of `still`: both in one frame, in which the corners
/// turn about `centre`, or, without curvature, move along `ahead`.
template <class Moving, class Still>
double corners_into_edges(const Moving& moving, const Still& still, bool straight, const Point& centre,
                          const Point& ahead, double sense, double radius, double length, double touch) {
    double first = never;
    for (std::size_t i = 0; i < still.size(); ++i) {
        const Edge edge(still, i);
        const double level = dot(edge.normal, edge.from) - touch;
        for (const Point& corner : moving) {
            if (straight) {
                const double speed = dot(edge.normal, ahead);
                if (!(speed < 0.0)) continue;
                const double distance = (level - dot(edge.normal, corner)) / speed;
                if (distance < 0.0 || distance > std::min(first, length)) continue;
                if (edge.holds({corner.x + distance * ahead.x, corner.y + distance * ahead.y}, touch)) first = distance;
            } else {
                const Point arm = minus(corner, centre);
                const double turned = sinking_angle(arm, edge.normal, level - dot(edge.normal, centre), sense);
                const double distance = turned * radius;
                if (!(distance <= std::min(first, length))) continue;
                const auto [s, c] = angles::sine_cosine(sense * turned);
                const Point there = turned_by(arm, s, c);
                if (edge.holds({centre.x + there.x, centre.y + there.y}, touch)) first = distance;
            }
        }
    }
    return first;
}

}  // namespace

Pose Path::at(double distance) const {
    const auto [s, c] = angles::sine_cosine(start.heading);
    const double on = way * distance;
    if (curvature == 0.0) return {start.x + on * c, start.y + on * s, start.heading};
    const double heading = start.heading + on * curvature;
    const auto [s2, c2] = angles::sine_cosine(heading);
    return {start.x + (s2 - s) / curvature, start.y - (c2 - c) / curvature, heading};
}

std::vector<Point> placed(const std::vector<Point>& shape, const Pose& pose) {
    const auto [s, c] = angles::sine_cosine(pose.heading);
    std::vector<Point> there;
    there.reserve(shape.size());
    for (const Point& p : shape) there.push_back({pose.x + p.x * c - p.y * s, pose.y + p.x * s + p.y * c});
    return there;
}

namespace {

/// So many corners, wherever they lie.
struct Corners {
    const Point* first;
    std::size_t count;

    [[nodiscard]] std::size_t size() const { return count; }
    const Point& operator[](std::size_t i) const { return first[i]; }
    [[nodiscard]] const Point* begin() const { return first; }
    [[nodiscard]] const Point* end() const { return first + count; }
};

}  // namespace

double overlap(const Point* one, std::size_t corners, const Point* other, std::size_t other_corners) {
    double least = never;
    const auto along_edges = [&](const Corners& a, const Corners& b) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Edge edge(a, i);
            double deepest = -never;
            for (const Point& p : b) deepest = std::max(deepest, dot(edge.normal, minus(edge.from, p)));
            least = std::min(least, deepest);
        }
    };
    along_edges({one, corners}, {other, other_corners});
    along_edges({other, other_corners}, {one, corners});
    return least;
}

double overlap(const std::vector<Point>& one, const std::vector<Point>& other) {
    return overlap(one.data(), one.size(), other.data(), other.size());
}

double distance(const Point* one, std::size_t corners, const Point* other, std::size_t other_corners) {
    const double deep = overlap(one, corners, other, other_corners);
    if (deep > 0.0) return -deep;
    double least = never;
    const auto corners_from_edges = [&](const Corners& of, const Corners& edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Point &from = edges[i], &to = edges[(i + 1) % edges.size()];
            const Point along = minus(to, from);
            for (const Point& p : of) {
                const double part = std::clamp(dot(minus(p, from), along) / dot(along, along), 0.0, 1.0);
                least = std::min(least, angles::hypot(p.x - from.x - part * along.x, p.y - from.y - part * along.y));
            }
        }
    };
    corners_from_edges({one, corners}, {other, other_corners});
    corners_from_edges({other, other_corners}, {one, corners});
    return least;
}

double first_contact(const std::vector<Point>& shape, const Path& path, const std::vector<Point>& solid, double touch) {
    const auto [s, c] = angles::sine_cosine(path.start.heading);
    const bool straight = path.curvature == 0.0;
    const double radius = straight ? 0.0 : 1.0 / std::abs(path.curvature);
    const double sense = path.way * (path.curvature < 0.0 ? -1.0 : 1.0);
    const Point ahead = {path.way * c, path.way * s};
    Point centre{};
    if (!straight) centre = {path.start.x - s / path.curvature, path.start.y + c / path.curvature};
    // Few shapes have more corners: these lie in place.
    Few<Point, 64> there, seen;
    for (const Point& p : shape) there.push_back({path.start.x + p.x * c - p.y * s, path.start.y + p.x * s + p.y * c});
    double first = corners_into_edges(there, solid, straight, centre, ahead, sense, radius, path.length, touch);
    // The same seen from the car: the solid's corners come towards it, turning the other way.
    for (const Point& p : solid) {
        const double x = p.x - path.start.x, y = p.y - path.start.y;
        seen.push_back({x * c + y * s, y * c - x * s});
    }
    const Point centre_seen = straight ? Point{} : Point{0.0, 1.0 / path.curvature};
    return std::min(first, corners_into_edges(seen, shape, straight, centre_seen, {-path.way, 0.0}, -sense, radius,
                                              path.length, touch));
}

}  // namespace snug::detail
