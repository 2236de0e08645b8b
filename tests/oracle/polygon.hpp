// Points, convex polygons and where a car stands: the little geometry all of the oracle is made of.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace oracle {

template <class Real>
struct Vec {
    Real x, y;
};

template <class Real>
Vec<Real> operator+(Vec<Real> a, Vec<Real> b) {
    return {a.x + b.x, a.y + b.y};
}
template <class Real>
Vec<Real> operator-(Vec<Real> a, Vec<Real> b) {
    return {a.x - b.x, a.y - b.y};
}
template <class Real>
Vec<Real> operator*(Real factor, Vec<Real> a) {
    return {factor * a.x, factor * a.y};
}
template <class Real>
Real dot(Vec<Real> a, Vec<Real> b) {
    return a.x * b.x + a.y * b.y;
}
template <class Real>
Real cross(Vec<Real> a, Vec<Real> b) {
    return a.x * b.y - a.y * b.x;
}
template <class Real>
Real length(Vec<Real> a) {
    return std::hypot(a.x, a.y);
}
/// A quarter turn to the left.
template <class Real>
Vec<Real> left_of(Vec<Real> a) {
    return {-a.y, a.x};
}

/// A convex polygon: its corners counter-clockwise, and the outward normal of the edge that begins at each.
template <class Real>
struct Polygon {
    std::vector<Vec<Real>> corners, normals;

    Polygon() = default;
    explicit Polygon(std::vector<Vec<Real>> points) : corners(std::move(points)) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec<Real> along = corners[(i + 1) % corners.size()] - corners[i];
            normals.push_back((-1 / length(along)) * left_of(along));
        }
    }
    std::size_t size() const { return corners.size(); }

    /// Every edge moved outward; each corner is where the two edges beside it then meet.
    Polygon grown(Real by) const {
        std::vector<Vec<Real>> result;
        for (std::size_t i = 0; i < size(); ++i) {
            const Vec<Real> before = normals[(i + size() - 1) % size()], after = normals[i];
            result.push_back(corners[i] + (by / (1 + dot(before, after))) * (before + after));
        }
        return Polygon(result);
    }
    /// Left and right exchanged.
    Polygon mirrored() const {
        std::vector<Vec<Real>> result(corners.rbegin(), corners.rend());
        for (Vec<Real>& p : result) p.y = -p.y;
        return Polygon(result);
    }
};

/// Corners front-left, rear-left, rear-right, front-right.
template <class Real>
Polygon<Real> rectangle(Real front, Real rear, Real half_width) {
    return Polygon<Real>({{front, half_width}, {-rear, half_width}, {-rear, -half_width}, {front, -half_width}});
}

/// The lowest and the highest y of a polygon at some x, the nearest of its own where it does not reach so far.
template <class Real>
std::array<Real, 2> across(const Polygon<Real>& polygon, Real x) {
    Real foremost = polygon.corners[0].x, hindmost = foremost;
    for (const Vec<Real>& p : polygon.corners) foremost = std::max(foremost, p.x), hindmost = std::min(hindmost, p.x);
    x = std::clamp(x, hindmost, foremost);
    std::array<Real, 2> range = {std::numeric_limits<Real>::infinity(), -std::numeric_limits<Real>::infinity()};
    const auto include = [&](Real y) { range = {std::min(range[0], y), std::max(range[1], y)}; };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec<Real> p = polygon.corners[i], q = polygon.corners[(i + 1) % polygon.size()];
        if (p.x == x) include(p.y);
        if ((p.x < x) != (q.x < x)) include(p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x)));
    }
    return range;
}

/// Rear axle centre and heading in the slot frame.
template <class Real>
struct Place {
    Real x, y, heading;
};

/// Directions and points seen from a car, turned and moved to where it stands.
template <class Real>
struct Standing {
    Vec<Real> axle, ahead;
    Real heading;

    explicit Standing(const Place<Real>& place)
        : Standing({place.x, place.y}, {std::cos(place.heading), std::sin(place.heading)}, place.heading) {}
    Standing(Vec<Real> axle_at, Vec<Real> towards, Real angle) : axle(axle_at), ahead(towards), heading(angle) {}
    Vec<Real> turned(Vec<Real> p) const { return p.x * ahead + p.y * left_of(ahead); }
    Vec<Real> at(Vec<Real> p) const { return axle + turned(p); }
};

template <class Real>
std::vector<Vec<Real>> at(const Polygon<Real>& polygon, const Place<Real>& place) {
    const Standing<Real> car(place);
    std::vector<Vec<Real>> result;
    for (const Vec<Real>& p : polygon.corners) result.push_back(car.at(p));
    return result;
}

/// Constant steering: the centre lies `radius` to the left (negative: to the right); infinite when straight.
template <class Real>
struct Path {
    Place<Real> start;
    Real radius;
    int direction;  // +1 forward, -1 backward

    bool straight() const { return std::isinf(radius); }
    /// How much the heading rises per metre.
    Real turn() const { return straight() ? Real(0) : Real(direction) / radius; }
    Place<Real> at(Real distance) const {
        if (straight()) {
            const Real d = Real(direction) * distance;
            return {start.x + d * std::cos(start.heading), start.y + d * std::sin(start.heading), start.heading};
        }
        const Real heading = start.heading + Real(direction) * distance / radius;
        return {start.x + radius * (std::sin(heading) - std::sin(start.heading)),
                start.y - radius * (std::cos(heading) - std::cos(start.heading)), heading};
    }
};

/// The same places as Path::at(), for many of them: sine and cosine are found once for each.
template <class Real>
class Way {
public:
    explicit Way(const Path<Real>& path) : path_(path), start_(path.start) {}
    Standing<Real> at(Real distance) const {
        if (path_.straight()) {
            const Real d = Real(path_.direction) * distance;
            return {
                {start_.axle.x + d * start_.ahead.x, start_.axle.y + d * start_.ahead.y}, start_.ahead, start_.heading};
        }
        const Real heading = start_.heading + Real(path_.direction) * distance / path_.radius;
        const Vec<Real> ahead{std::cos(heading), std::sin(heading)};
        return {{start_.axle.x + path_.radius * (ahead.y - start_.ahead.y),
                 start_.axle.y - path_.radius * (ahead.x - start_.ahead.x)},
                ahead,
                heading};
    }

private:
    Path<Real> path_;
    Standing<Real> start_;
};

}  // namespace oracle
