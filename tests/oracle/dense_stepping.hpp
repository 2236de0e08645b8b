// Tiny steps and an overlap test by clipping: slow, and plain enough to check the safe steps against.
#pragma once

#include "strategy.hpp"

namespace oracle {

/// The same question as depths() > 0 answered another way, by clipping the car to each block's column: how far it
/// reaches below the top of the block there. Zero when it does not reach in at all.
template <class Real>
std::array<Real, 3> sunk(const Problem<Real>& problem, const Place<Real>& place) {
    const std::vector<Vec<Real>> body = at(problem.body, place);
    const Vec<Real> front = problem.front_corner(), rear = problem.rear_corner();
    std::array<Real, 3> below = {0, 0, 0};
    const auto sinks = [&](Block block, Real by) { below[block] = std::max(below[block], by); };
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Vec<Real> p = body[i], q = body[(i + 1) % body.size()];
        if (p.x > front.x) sinks(front_block, front.y - p.y);
        if (p.x < rear.x) sinks(rear_block, rear.y - p.y);
        for (const auto& [corner, block] : {std::pair{front, front_block}, std::pair{rear, rear_block}}) {
            if ((p.x < corner.x) == (q.x < corner.x)) continue;
            sinks(block, corner.y - (p.y + (q.y - p.y) * ((corner.x - p.x) / (q.x - p.x))));
        }
    }
    for (const Vec<Real>& p : at(problem.at_curb, place)) sinks(curb_block, -problem.width - p.y);
    return below;
}

template <class Real>
struct Stepped {
    Real contact = std::numeric_limits<Real>::infinity();      // the first step found overlapping
    Real inside_from = std::numeric_limits<Real>::infinity();  // the first step found parked
    Real inside_to = std::numeric_limits<Real>::infinity();    // the last step of that stretch
};

/// Steps along the path until the car sinks more than `tolerance` into something, at most `farthest`.
template <class Real>
Stepped<Real> step_along(const Problem<Real>& problem, const Path<Real>& path, Real farthest, Real step,
                         Real tolerance = Real(1e-12L)) {
    Stepped<Real> result;
    bool stretch_over = false;
    for (long i = 0; Real(i) * step <= farthest; ++i) {
        const Real distance = Real(i) * step;
        const Place<Real> place = path.at(distance);
        const std::array<Real, 3> below = sunk(problem, place);
        // The clipped depth is measured downward only; a wall touched from the side counts by its own depth.
        if (std::max({below[0], below[1], below[2]}) > tolerance && depth(problem, place) > tolerance) {
            result.contact = distance;
            return result;
        }
        if (stretch_over) continue;
        if (short_of_parked(problem, place) <= tolerance) {
            result.inside_from = std::min(result.inside_from, distance);
            result.inside_to = distance;
        } else if (std::isfinite(result.inside_from)) {
            stretch_over = true;
        }
    }
    return result;
}

/// Direction changes of the strategy from one heading, every move stepped; -1 when it does not park.
template <class Real>
int stepped_changes(const Problem<Real>& problem, Real heading, int max_changes, Real step) {
    Place<Real> place = entry_place(problem, heading);
    int direction = problem.enter == snug::Enter::backward ? -1 : 1;
    Real radius = problem.radius;
    if (depth(problem, place) > Real(1e-12L)) return -1;
    for (int changes = 0; changes <= max_changes; ++changes) {
        const Path<Real> path{place, radius, direction};
        const Stepped<Real> found = step_along(problem, path, until_turned_away(problem, place), step, Real(1e-13L));
        if (std::isfinite(found.inside_from) && (changes > 0 || found.contact > step)) return changes;
        if (std::isinf(found.contact)) return -1;
        // Halve down to the contact between the last free step and the first overlapping one.
        Real free = std::max(found.contact - step, Real(0)), blocked = found.contact;
        if (found.contact <= 0) return -1;
        for (int i = 0; i < 60; ++i) {
            const Real middle = (free + blocked) / 2;
            (depth(problem, path.at(middle)) > Real(1e-15L) ? blocked : free) = middle;
        }
        if (free <= Real(1e-12L)) return -1;
        place = path.at(free);
        direction = -direction;
        radius = -radius;
    }
    return -1;
}

}  // namespace oracle
