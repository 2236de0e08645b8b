// How deep a car frame is inside the curb or a neighbour, in the slot frame: shared by everything the oracle does.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace oracle {

template <class Real>
struct Vec {
    Real x, y;
};

/// Rear axle centre and heading in the slot frame.
template <class Real>
struct Place {
    Real x, y, heading;
};

/// A frame about its rear axle centre; `front`, `rear` and `side` are distances to its edges.
template <class Real>
struct Body {
    Real front, rear, side;

    /// Front-left, rear-left, rear-right, front-right.
    std::array<Vec<Real>, 4> corners() const {
        return {Vec<Real>{front, side}, Vec<Real>{-rear, side}, Vec<Real>{-rear, -side}, Vec<Real>{front, -side}};
    }
    Body grown(Real by) const { return {front + by, rear + by, side + by}; }
};

/// [-length, 0] x [-width, 0], the neighbours below y = 0 on both sides of it, the curb below y = -width.
template <class Real>
struct Gap {
    Real length, width;
};

enum Block { front_block, rear_block, curb_block };

template <class Real>
std::array<Vec<Real>, 4> corners_at(const Body<Real>& body, const Place<Real>& place) {
    const Real c = std::cos(place.heading), s = std::sin(place.heading);
    std::array<Vec<Real>, 4> corners = body.corners();
    for (Vec<Real>& p : corners) p = {place.x + c * p.x - s * p.y, place.y + s * p.x + c * p.y};
    return corners;
}

/// The shortest push that separates the frame from each block, by separating axes; negative when they are apart.
template <class Real>
std::array<Real, 3> depths(const Body<Real>& body, const Place<Real>& place, const Gap<Real>& gap) {
    const Real c = std::cos(place.heading), s = std::sin(place.heading);
    const std::array<Vec<Real>, 4> at = corners_at(body, place);
    const auto [left, right] = std::minmax({at[0].x, at[1].x, at[2].x, at[3].x});
    const Real low = std::min({at[0].y, at[1].y, at[2].y, at[3].y});
    Real front = std::min(right, -low);
    Real rear = std::min(-gap.length - left, -low);
    // Outward normals of the front, left, rear and right edge with their distances from the rear axle centre.
    const std::array<Vec<Real>, 4> normals = {Vec<Real>{c, s}, Vec<Real>{-s, c}, Vec<Real>{-c, -s}, Vec<Real>{s, -c}};
    const std::array<Real, 4> reach = {body.front, body.side, body.rear, body.side};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec<Real> n = normals[i];
        // Only an edge that looks at the block from outside can separate; the block's nearest point is its corner.
        if (n.y <= 0 && n.x >= 0) front = std::min(front, reach[i] + n.x * place.x + n.y * place.y);
        if (n.y <= 0 && n.x <= 0) rear = std::min(rear, reach[i] + n.x * (place.x + gap.length) + n.y * place.y);
    }
    return {front, rear, -gap.width - low};
}

template <class Real>
Real depth(const Body<Real>& body, const Place<Real>& place, const Gap<Real>& gap) {
    const std::array<Real, 3> all = depths(body, place, gap);
    return std::max({all[0], all[1], all[2]});
}

/// Height of the highest corner: the whole frame is inside the slot when it is free and this is not positive.
template <class Real>
Real top(const Body<Real>& body, const Place<Real>& place) {
    const std::array<Vec<Real>, 4> at = corners_at(body, place);
    return std::max({at[0].y, at[1].y, at[2].y, at[3].y});
}

/// How far the worst corner sticks out of the slot, in any direction.
template <class Real>
Real outside(const Body<Real>& body, const Place<Real>& place, const Gap<Real>& gap) {
    Real worst = -gap.length - gap.width;
    for (const Vec<Real>& p : corners_at(body, place))
        worst = std::max({worst, p.y, p.x, -gap.length - p.x, -gap.width - p.y});
    return worst;
}

/// The same question as depths() > 0 answered another way, by clipping the frame to each block's column: how far it
/// reaches below the top of the block there. Zero when it does not reach in at all.
template <class Real>
std::array<Real, 3> sunk(const Body<Real>& body, const Place<Real>& place, const Gap<Real>& gap) {
    const std::array<Vec<Real>, 4> at = corners_at(body, place);
    std::array<Real, 3> below = {0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec<Real> p = at[i], q = at[(i + 1) % 4];
        if (p.x > 0) below[front_block] = std::max(below[front_block], -p.y);
        if (p.x < -gap.length) below[rear_block] = std::max(below[rear_block], -p.y);
        below[curb_block] = std::max(below[curb_block], -gap.width - p.y);
        for (const auto& [wall, block] : {std::pair{Real(0), front_block}, std::pair{-gap.length, rear_block}}) {
            if ((p.x < wall) == (q.x < wall)) continue;
            below[block] = std::max(below[block], -(p.y + (q.y - p.y) * ((wall - p.x) / (q.x - p.x))));
        }
    }
    return below;
}

}  // namespace oracle
