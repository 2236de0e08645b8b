// The paper's strategy written the plainest way: explicit angles, every corner against every line, no cleverness.
//
// One move is a rotation about a fixed centre (or a straight line). Whether the frame overlaps a block can change only
// where a car corner crosses one of the lines x = 0, x = -L, y = -W, y = 0, or a slot corner crosses the line of a car
// edge. So all these moments are listed and sorted; between two neighbours nothing changes and the middle decides.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "overlap.hpp"
#include "snug/max_steer.hpp"

namespace oracle {

/// What is asked: real frame, grown frame, slot, turning radius at full steering, and which end goes in first.
template <class Real>
struct Problem {
    Body<Real> car;
    Body<Real> grown;
    Gap<Real> gap;
    Real radius;
    snug::Enter enter = snug::Enter::backward;
    /// Rounding: overlaps and moves smaller than this are none. [m]
    Real forgiven = Real(sizeof(Real) > 8 ? 1e-15L : 1e-12L);
};

template <class Real>
Problem<Real> make_problem(const snug::CarDimensions& car, double length, double width, double clearance = 0.0,
                           snug::Enter enter = snug::Enter::backward) {
    const Body<Real> body{Real(car.front), Real(car.rear), Real(car.width) / 2};
    Problem<Real> problem{body, body.grown(Real(clearance)), {Real(length), Real(width)}, 0, enter};
    problem.radius = Real(car.wheelbase) / std::tan(Real(car.max_steer));
    return problem;
}

/// Constant steering: the centre lies `radius` to the left (negative: to the right); infinite when straight.
template <class Real>
struct Path {
    Place<Real> start;
    Real radius;
    int direction;  // +1 forward, -1 backward

    bool straight() const { return std::isinf(radius); }
    /// +1 when the heading rises along the path.
    int sense() const { return radius > 0 ? direction : -direction; }
    Place<Real> at(Real distance) const {
        if (straight()) {
            const Real d = Real(direction) * distance;
            return {start.x + d * std::cos(start.heading), start.y + d * std::sin(start.heading), start.heading};
        }
        const Real heading = start.heading + Real(sense()) * distance / std::abs(radius);
        return {start.x + radius * (std::sin(heading) - std::sin(start.heading)),
                start.y - radius * (std::cos(heading) - std::cos(start.heading)), heading};
    }
};

/// A moment on a path at which something lines up. `kind` names what, for telling itineraries apart.
template <class Real>
struct Moment {
    Real distance;
    int kind;
};

enum : int {
    kind_start = 0,
    kind_corner = 1,   // + 4 * line + corner
    kind_edge = 20,    // + 4 * slot corner + edge
    kind_extreme = 40  // + corner: lowest or level, only for the depth
};

namespace detail {

template <class Real>
struct Moments {
    std::array<Moment<Real>, 96> list;
    std::size_t count = 0;

    void add(Real distance, int kind) {
        if (distance >= 0 && std::isfinite(distance)) list[count++] = {distance, kind};
    }
};

/// Moments at which a point that starts at `p` and moves with the path has the given coordinate (x or y).
/// The path is seen in a frame where its centre is `centre` or its unit direction of travel is `along`.
template <class Real>
struct Circle {
    Real radius, angle, turn, scale;  // scale: metres of path per radian
    Vec<Real> centre;

    Circle(Vec<Real> p, Vec<Real> c, int sense, Real path_radius)
        : radius(std::hypot(p.x - c.x, p.y - c.y)),
          angle(std::atan2(p.y - c.y, p.x - c.x)),
          turn(Real(sense)),
          scale(path_radius),
          centre(c) {}

    void reach(Real at_angle, int kind, Moments<Real>& out) const {
        constexpr Real full = 2 * std::numbers::pi_v<Real>;
        Real psi = std::fmod(turn * (at_angle - angle), full);
        if (psi < 0) psi += full;
        out.add(psi * scale, kind);
    }
    void cross_x(Real x, int kind, Moments<Real>& out) const {
        const Real c = (x - centre.x) / radius;
        if (!(c >= -1 && c <= 1)) return;
        const Real a = std::acos(c);
        reach(a, kind, out);
        reach(-a, kind, out);
    }
    void cross_y(Real y, int kind, Moments<Real>& out) const {
        const Real s = (y - centre.y) / radius;
        if (!(s >= -1 && s <= 1)) return;
        const Real a = std::asin(s);
        reach(a, kind, out);
        reach(std::numbers::pi_v<Real> - a, kind, out);
    }
};

}  // namespace detail

/// What one path meets, up to its first contact or (for a circle) once around.
template <class Real>
struct Drive {
    Real contact = std::numeric_limits<Real>::infinity();  // distance
    int kind = -1;                                         // what lined up at the contact
    Block block = front_block;                             // deepest just after the contact
    Real inside_from = std::numeric_limits<Real>::infinity();
    Real inside_to = std::numeric_limits<Real>::infinity();  // end of the first stretch inside
    Real least_top = std::numeric_limits<Real>::infinity();  // least height of the highest corner up to the contact
    Real least_at = 0;
    /// The smallest |overlap| at a turning point of some corner or edge before the contact, the start left out: how
    /// close the path comes to grazing something, or to having grazed it.
    Real graze = std::numeric_limits<Real>::infinity();
};

struct Ask {
    bool stop_inside = false;  // the first moment inside is enough
    bool graze = false;
};

template <class Real>
Drive<Real> drive(const Problem<Real>& problem, const Path<Real>& path, Ask ask = {}) {
    detail::Moments<Real> moments, turns;
    moments.add(0, kind_start);
    const std::array<Vec<Real>, 4> grown = corners_at(problem.grown, path.start);
    const std::array<Vec<Real>, 4> real = corners_at(problem.car, path.start);
    const bool one_frame = problem.grown.front == problem.car.front;
    const Real L = problem.gap.length, W = problem.gap.width;
    const Real c = std::cos(path.start.heading), s = std::sin(path.start.heading);
    Real farthest;
    if (path.straight()) {
        const Vec<Real> along{Real(path.direction) * c, Real(path.direction) * s};
        for (int i = 0; i < 4; ++i) {
            const Vec<Real> g = grown[std::size_t(i)], p = real[std::size_t(i)];
            moments.add((0 - g.x) / along.x, kind_corner + i);
            moments.add((-L - g.x) / along.x, kind_corner + 4 + i);
            moments.add((-W - g.y) / along.y, kind_corner + 8 + i);
            moments.add((0 - p.y) / along.y, kind_corner + 12 + i);
            if (!one_frame) moments.add((0 - g.y) / along.y, kind_corner + 12 + i);
        }
        for (int i = 0; i < 2; ++i) {
            const Real qx = (i == 0 ? 0 : -L) - path.start.x, qy = 0 - path.start.y;
            const Real ahead = c * qx + s * qy;
            moments.add(Real(path.direction) * (ahead - problem.grown.front), kind_edge + 4 * i);
            moments.add(Real(path.direction) * (ahead + problem.grown.rear), kind_edge + 4 * i + 2);
        }
        farthest = 2 * (std::abs(path.start.x) + std::abs(path.start.y) + L + W + problem.grown.front +
                        problem.grown.rear + problem.grown.side);
        for (std::size_t i = 0; i < moments.count; ++i) farthest = std::max(farthest, 2 * moments.list[i].distance);
    } else {
        const Real rho = std::abs(path.radius);
        const Vec<Real> centre{path.start.x - path.radius * s, path.start.y + path.radius * c};
        for (int i = 0; i < 4; ++i) {
            const detail::Circle<Real> circle(grown[std::size_t(i)], centre, path.sense(), rho);
            circle.cross_x(0, kind_corner + i, moments);
            circle.cross_x(-L, kind_corner + 4 + i, moments);
            circle.cross_y(-W, kind_corner + 8 + i, moments);
            circle.cross_y(0, kind_corner + 12 + i, moments);
            constexpr Real quarter = std::numbers::pi_v<Real> / 2;
            if (!one_frame) {
                const detail::Circle<Real> inner(real[std::size_t(i)], centre, path.sense(), rho);
                inner.cross_y(0, kind_corner + 12 + i, moments);
                inner.reach(-quarter, kind_extreme + i, turns);
            } else {
                circle.reach(-quarter, kind_extreme + i, turns);
            }
            if (ask.graze)
                for (const int k : {-1, 0, 1, 2}) circle.reach(Real(k) * quarter, kind_extreme + i, turns);
            // Level headings, where another corner becomes the highest.
            Real psi = std::fmod(Real(path.sense()) * (Real(i) * quarter - path.start.heading), 4 * quarter);
            if (psi < 0) psi += 4 * quarter;
            turns.add(psi * rho, kind_extreme + 4 + i);
        }
        // The slot's corners as the car sees them: its frame stands still and they turn the other way.
        const Vec<Real> own_centre{0, path.radius};
        for (int i = 0; i < 2; ++i) {
            const Real qx = (i == 0 ? 0 : -L) - path.start.x, qy = 0 - path.start.y;
            const detail::Circle<Real> circle({c * qx + s * qy, -s * qx + c * qy}, own_centre, -path.sense(), rho);
            circle.cross_x(problem.grown.front, kind_edge + 4 * i, moments);
            circle.cross_y(problem.grown.side, kind_edge + 4 * i + 1, moments);
            circle.cross_x(-problem.grown.rear, kind_edge + 4 * i + 2, moments);
            circle.cross_y(-problem.grown.side, kind_edge + 4 * i + 3, moments);
            if (ask.graze)
                for (const int k : {-1, 0, 1, 2})
                    circle.reach(Real(k) * std::numbers::pi_v<Real> / 2, kind_extreme + i, turns);
        }
        farthest = 2 * std::numbers::pi_v<Real> * rho;
    }
    const auto first = moments.list.begin(), last = first + std::ptrdiff_t(moments.count);
    std::sort(first, last, [](const Moment<Real>& a, const Moment<Real>& b) { return a.distance < b.distance; });

    Drive<Real> result;
    bool was_inside = false, left_inside = false;
    for (auto m = first; m != last; ++m) {
        const Real next = m + 1 == last ? farthest : (m + 1)->distance;
        if (!(next > m->distance)) continue;
        const Place<Real> middle = path.at((m->distance + next) / 2);
        const std::array<Real, 3> d = depths(problem.grown, middle, problem.gap);
        const auto deepest = std::max_element(d.begin(), d.end());
        if (*deepest > problem.forgiven) {
            result.contact = m->distance;
            result.kind = m->kind;
            result.block = Block(deepest - d.begin());
            break;
        }
        const bool inside = top(problem.car, middle) < 0;
        if (inside && !was_inside && !left_inside) {
            result.inside_from = m->distance;
            if (ask.stop_inside) {
                was_inside = true;
                break;
            }
        }
        if (was_inside && !inside && !left_inside) {
            result.inside_to = m->distance;
            left_inside = true;
        }
        was_inside = inside && !left_inside;
    }
    if (was_inside) result.inside_to = std::min(result.contact, farthest);

    const Real end = ask.stop_inside && was_inside ? result.inside_from : std::min(result.contact, farthest);
    const auto look = [&](Real distance) {
        const Real height = top(problem.car, path.at(distance));
        if (height < result.least_top) result.least_top = height, result.least_at = distance;
    };
    look(0);
    look(end);
    for (std::size_t i = 0; i < turns.count; ++i) {
        const Real at = turns.list[i].distance;
        if (at > end) continue;
        look(at);
        if (ask.graze && at > problem.forgiven)
            for (const Real d : depths(problem.grown, path.at(at), problem.gap))
                result.graze = std::min(result.graze, std::abs(d));
    }
    if (ask.graze)
        for (auto m = first; m != last && m->distance < end - problem.forgiven; ++m)
            if (m->distance > problem.forgiven)
                for (const Real d : depths(problem.grown, path.at(m->distance), problem.gap))
                    result.graze = std::min(result.graze, std::abs(d));
    return result;
}

template <class Real>
struct Leg {
    Path<Real> path;
    Real length;
    Drive<Real> drive;
};

/// The strategy from one heading.
template <class Real>
struct Run {
    snug::Outcome outcome = snug::Outcome::no_entry;
    int changes = 0;                                         // direction changes when parked
    std::uint64_t itinerary = 0;                             // what met what, move after move, in one number
    Real least_top = std::numeric_limits<Real>::infinity();  // D: the least over all moves driven
    int least_move = -1;
    Real graze = std::numeric_limits<Real>::infinity();
    std::vector<Leg<Real>> legs;

    bool parked() const { return outcome == snug::Outcome::parked; }
};

/// The entry position: the grown frame's right corner (front when backing in, rear when nosing in) on the slot's corner.
template <class Real>
Place<Real> entry_place(const Problem<Real>& problem, Real heading) {
    if (problem.enter == snug::Enter::backward) {
        const Real c = std::cos(heading), s = std::sin(heading);
        return {-(c * problem.grown.front + s * problem.grown.side),
                -(s * problem.grown.front - c * problem.grown.side), heading};
    }
    const Real c = std::cos(-heading), s = std::sin(-heading);
    return {-problem.gap.length + c * problem.grown.rear - s * problem.grown.side,
            s * problem.grown.rear + c * problem.grown.side, -heading};
}

/// With `graze` the run also tells how close it comes to another outcome, and looks at all of its last move.
template <class Real>
void run(const Problem<Real>& problem, Real heading, int max_changes, Run<Real>& out, bool graze = false) {
    out.outcome = snug::Outcome::no_entry;
    out.changes = 0;
    out.itinerary = 0;
    out.least_top = std::numeric_limits<Real>::infinity();
    out.least_move = -1;
    out.graze = std::numeric_limits<Real>::infinity();
    out.legs.clear();

    Place<Real> place = entry_place(problem, heading);
    const std::array<Real, 3> start = depths(problem.grown, place, problem.gap);
    // The neighbour whose corner is touched cannot be entered at these headings.
    const Block touched = problem.enter == snug::Enter::backward ? front_block : rear_block;
    for (const Block block : {front_block, rear_block, curb_block}) {
        if (block == touched) continue;
        if (graze) out.graze = std::min(out.graze, std::abs(start[block]));
        if (start[block] > problem.forgiven) return;
    }
    int direction = problem.enter == snug::Enter::backward ? -1 : 1;
    Real radius = problem.radius;
    for (int changes = 0; changes <= max_changes; ++changes) {
        Leg<Real> leg{{place, radius, direction}, 0, {}};
        leg.drive = drive(problem, leg.path, {true, graze});
        out.graze = std::min(out.graze, leg.drive.graze);
        if (graze && std::isfinite(leg.drive.inside_from)) leg.drive = drive(problem, leg.path);  // how deep inside
        if (leg.drive.least_top < out.least_top) out.least_top = leg.drive.least_top, out.least_move = changes;
        out.itinerary = (out.itinerary ^ std::uint64_t(leg.drive.kind + 2)) * 0x9E3779B97F4A7C15ULL;
        // With a clearance the car itself can be inside at a steep entry position whose first move cannot start.
        if (changes == 0 && leg.drive.inside_from <= problem.forgiven &&
            drive(problem, leg.path).contact <= problem.forgiven) {
            return;  // no entry
        }
        if (std::isfinite(leg.drive.inside_from)) {
            leg.length = leg.drive.inside_from;
            out.legs.push_back(leg);
            out.outcome = snug::Outcome::parked;
            out.changes = changes;
            return;
        }
        if (std::isinf(leg.drive.contact)) {
            out.outcome = snug::Outcome::never_touches;
            return;
        }
        if (leg.drive.contact <= problem.forgiven) {
            out.outcome = changes == 0 ? snug::Outcome::no_entry : snug::Outcome::stuck;
            return;
        }
        leg.length = leg.drive.contact;
        place = leg.path.at(leg.length);
        out.legs.push_back(leg);
        direction = -direction;
        radius = -radius;
    }
    out.outcome = snug::Outcome::too_many_changes;
}

template <class Real>
Run<Real> run(const Problem<Real>& problem, Real heading, int max_changes, bool graze = false) {
    Run<Real> result;
    run(problem, heading, max_changes, result, graze);
    return result;
}

}  // namespace oracle
