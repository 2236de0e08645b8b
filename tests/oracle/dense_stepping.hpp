// Tiny exact-arc steps and an overlap test by clipping: slow, and plain enough to check the closed form against.
#pragma once

#include "simulation.hpp"

namespace oracle {

template <class Real>
struct Stepped {
    Real contact = std::numeric_limits<Real>::infinity();      // the first step found overlapping
    Real inside_from = std::numeric_limits<Real>::infinity();  // the first step found inside
    Real inside_to = std::numeric_limits<Real>::infinity();    // the last step of that stretch
};

/// Steps along the path until the grown frame sinks more than `tolerance` into a block, at most `farthest`.
template <class Real>
Stepped<Real> step_along(const Problem<Real>& problem, const Path<Real>& path, Real farthest, Real step,
                         Real tolerance = Real(1e-12L)) {
    Stepped<Real> result;
    bool stretch_over = false;
    for (long i = 0; Real(i) * step <= farthest; ++i) {
        const Real distance = Real(i) * step;
        const Place<Real> place = path.at(distance);
        const std::array<Real, 3> below = sunk(problem.grown, place, problem.gap);
        if (std::max({below[0], below[1], below[2]}) > tolerance) {
            // The clipped depth is measured downward only; a wall touched from the side counts by its own depth.
            const Real deep = depth(problem.grown, place, problem.gap);
            if (deep > tolerance) {
                result.contact = distance;
                return result;
            }
        }
        if (stretch_over) continue;
        if (outside(problem.car, place, problem.gap) <= tolerance) {
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
    if (depth(problem.grown, place, problem.gap) > Real(1e-12L)) return -1;
    for (int changes = 0; changes <= max_changes; ++changes) {
        const Path<Real> path{place, radius, direction};
        const Real full = 2 * std::numbers::pi_v<Real> * problem.radius;
        const Stepped<Real> found = step_along(problem, path, full, step, Real(1e-13L));
        if (std::isfinite(found.inside_from)) return changes;
        if (std::isinf(found.contact)) return -1;
        // Halve down to the contact between the last free step and the first overlapping one.
        Real free = std::max(found.contact - step, Real(0)), blocked = found.contact;
        if (found.contact <= 0) return -1;
        for (int i = 0; i < 60; ++i) {
            const Real middle = (free + blocked) / 2;
            (depth(problem.grown, path.at(middle), problem.gap) > Real(1e-15L) ? blocked : free) = middle;
        }
        if (free <= Real(1e-12L)) return -1;
        place = path.at(free);
        direction = -direction;
        radius = -radius;
    }
    return -1;
}

}  // namespace oracle
