// The paper's strategy from one heading, driven by the oracle: full steering until contact, then the other way round.
#pragma once

#include <cstdint>

#include "driving.hpp"

namespace oracle {

template <class Real>
struct Leg {
    Path<Real> path;
    Real length;   // up to the contact, or to where the car is parked
    Real contact;  // how far it could go
    Real least;    // least it is short of being parked up to the contact; infinite unless asked for
    int met = -1;  // what met what at the contact
};

template <class Real>
struct Run {
    snug::Outcome outcome = snug::Outcome::no_entry;
    int changes = 0;              // direction changes when parked
    std::uint64_t itinerary = 0;  // what met what, move after move, in one number
    std::vector<Leg<Real>> legs;

    bool parked() const { return outcome == snug::Outcome::parked; }
    Real least() const {
        Real least = std::numeric_limits<Real>::infinity();
        for (const Leg<Real>& leg : legs) least = std::min(least, leg.least);
        return least;
    }
};

/// The corner of the body that touches the neighbour at the entry position: of those ahead of the rear axle the one
/// farthest from the first move's centre, which lies abeam on the left (nose first: of those behind it).
template <class Real>
Vec<Real> touching_corner(const Problem<Real>& problem) {
    const Real ahead = problem.enter == snug::Enter::backward ? 1 : -1;
    const Vec<Real> centre{0, problem.radius};
    const Vec<Real>* farthest = nullptr;
    for (const Vec<Real>& p : problem.body.corners)
        if (ahead * p.x > 0 && (!farthest || length(p - centre) > length(*farthest - centre))) farthest = &p;
    return *farthest;
}

/// The entry position at a heading from 0 to a quarter turn, positive with the end that comes last away from the slot.
template <class Real>
Place<Real> entry_place(const Problem<Real>& problem, Real heading) {
    const bool backward = problem.enter == snug::Enter::backward;
    if (!backward) heading = -heading;
    const Vec<Real> p = touching_corner(problem);
    const Vec<Real> met = backward ? problem.front_corner() : problem.rear_corner();
    const Real c = std::cos(heading), s = std::sin(heading);
    return {met.x - (c * p.x - s * p.y), met.y - (s * p.x + c * p.y), heading};
}

/// How far it is until the car stands straight across, the end that goes in first to the road: beyond that it has turned
/// away and counts as parked no more.
template <class Real>
Real until_turned_away(const Problem<Real>& problem, const Place<Real>& place) {
    const Real heading = problem.enter == snug::Enter::backward ? place.heading : -place.heading;
    return std::max(Real(0), (heading + std::numbers::pi_v<Real> / 2) * problem.radius);
}

enum class Look { at_counts, at_depths_too };

/// From anywhere; whoever overlaps something there has no entry.
template <class Real>
void run_from(const Problem<Real>& problem, Place<Real> place, int max_changes, Run<Real>& out,
              Look look = Look::at_counts) {
    constexpr Real never = std::numeric_limits<Real>::infinity();
    out.outcome = snug::Outcome::no_entry;
    out.changes = 0;
    out.itinerary = 0;
    out.legs.clear();

    if (depth(problem, place) > problem.forgiven) return;
    int direction = problem.enter == snug::Enter::backward ? -1 : 1;
    Real radius = problem.radius;
    for (int changes = 0; changes <= max_changes; ++changes) {
        Leg<Real> leg{{place, radius, direction}, 0, 0, never};
        const Real away = until_turned_away(problem, place);
        leg.contact = first_contact(problem, leg.path, away);
        // With a clearance the car itself can be inside at a steep entry position whose first move cannot start.
        if (changes == 0 && leg.contact <= problem.no_move()) return;
        leg.length = std::min(leg.contact, away);
        const Real inside = first_parked(problem, leg.path, leg.length);
        if (look == Look::at_depths_too) leg.least = least_short_of_parked(problem, leg.path, leg.length);
        if (std::isfinite(inside)) {
            leg.length = inside;
            out.legs.push_back(leg);
            out.outcome = snug::Outcome::parked;
            out.changes = changes;
            return;
        }
        if (std::isinf(leg.contact)) {
            out.outcome = snug::Outcome::never_touches;
            return;
        }
        if (leg.contact <= problem.no_move()) {
            out.outcome = snug::Outcome::stuck;
            return;
        }
        place = leg.path.at(leg.length);
        leg.met = meeting(problem, place).number();
        out.itinerary = (out.itinerary ^ std::uint64_t(leg.met + 2)) * 0x9E3779B97F4A7C15ULL;
        out.legs.push_back(leg);
        direction = -direction;
        radius = -radius;
    }
    out.outcome = snug::Outcome::too_many_changes;
}

template <class Real>
void run(const Problem<Real>& problem, Real heading, int max_changes, Run<Real>& out, Look look = Look::at_counts) {
    run_from(problem, entry_place(problem, heading), max_changes, out, look);
}

template <class Real>
Run<Real> run(const Problem<Real>& problem, Real heading, int max_changes, Look look = Look::at_counts) {
    Run<Real> result;
    run(problem, heading, max_changes, result, look);
    return result;
}

/// The count at a heading when it parks, else -1, unless rounding decides: then nothing.
struct Decided {
    bool certain = true;
    int count = -1;
    snug::Outcome outcome = snug::Outcome::no_entry;
};

/// Whether the first move can start.
inline bool starts(const Problem<long double>& problem, long double heading) {
    const Place<long double> place = entry_place(problem, heading);
    if (depth(problem, place) > problem.forgiven) return false;
    const Path<long double> path{place, problem.radius, problem.enter == snug::Enter::backward ? -1 : 1};
    return first_contact(problem, path, 1e-3L) > 1e-9L;
}

/// Driven again by cars a little larger and a little smaller, in body and in frame: where these fare otherwise, rounding
/// decides. With as many as hundreds of moves a little grows, so it is the question that is that delicate.
inline Decided decide(const Problem<long double>& problem, long double heading, int max_changes,
                      long double little = 1e-12L) {
    Decided decided;
    bool first = true;
    // Where the touching corner sets off along the neighbour's side it sinks in by the square of what the heading is off.
    decided.certain = starts(problem, heading - 1e-7L) == starts(problem, heading + 1e-7L);
    for (const long double body : {0.0L, little, -little}) {
        for (const long double frame : {0.0L, little, -little}) {
            Problem<long double> other = problem;
            other.body = problem.body.grown(body);
            other.at_curb = problem.at_curb.grown(body);
            other.car = problem.car.grown(frame);
            const Run<long double> result = run(other, heading, max_changes);
            const int count = result.parked() ? result.changes : -1;
            if (!first && (count != decided.count || result.outcome != decided.outcome)) decided.certain = false;
            if (first) decided.count = count, decided.outcome = result.outcome;
            first = false;
        }
    }
    return decided;
}

/// Whether the car, beginning a hair beside the heading, gets stuck where a later move begins tangent to what it touches: it
/// sinks in by the square of how far the heading is off, and that is forgiven as rounding. Where next to nothing is forgiven,
/// rounding may let the car creep first.
inline bool stuck_beside(Problem<long double> strict, long double heading, int max_changes) {
    strict.forgiven = 1e-17L;
    for (const long double away : {-1e-7L, 1e-7L}) {
        const Run<long double> beside = run(strict, heading + away, max_changes);
        if (beside.outcome == snug::Outcome::stuck ||
            (beside.outcome == snug::Outcome::too_many_changes && beside.legs.back().length < 1e-12L))
            return true;
    }
    return false;
}

}  // namespace oracle
