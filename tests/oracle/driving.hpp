// What one move meets: positions from sines and cosines, overlap by separating axes, and steps that cannot miss anything.
//
// A car and an obstacle are apart while some axis separates them. Along an axis every corner keeps its distance at least
// as far as its speed towards the obstacle now, and the most its path can bend, allow: that far the car may safely go,
// and then it is asked again. Where it gets no further, halving finds the contact. Nothing here solves for a contact.
#pragma once

#include "polygon.hpp"
#include "snug/driving.hpp"
#include "snug/max_steer.hpp"

namespace oracle {

enum Block { front_block, rear_block, curb_block };

/// What is asked, in the slot frame: the slot is [-length, 0] x [-width, 0] with the road above it.
template <class Real>
struct Problem {
    Polygon<Real> car;      // must be inside to be parked
    Polygon<Real> body;     // stops at the neighbours
    Polygon<Real> at_curb;  // stops at the curb
    Real length, width;
    Real front_setback, rear_setback;  // the neighbours begin that much below y = 0
    Real radius;                       // at full steering
    snug::Enter enter;
    Real parked_heading, parked_curb;  // most to be off parallel, and from the curb, when parked
    /// Rounding: overlaps smaller than this are none. [m]
    Real forgiven = Real(sizeof(Real) > 8 ? 1e-15L : 1e-12L);
    /// And so are moves shorter than this, as where the car sets off at a flat angle rounding is long.
    Real no_move() const { return 1000 * forgiven; }

    Vec<Real> front_corner() const { return {0, -front_setback}; }
    Vec<Real> rear_corner() const { return {-length, -rear_setback}; }
};

/// The shortest push that separates the car from each block; negative when they are apart.
template <class Real>
std::array<Real, 3> depths(const Problem<Real>& problem, const Standing<Real>& car) {
    const Vec<Real> p = problem.front_corner(), q = problem.rear_corner();
    constexpr Real far = std::numeric_limits<Real>::infinity();
    Real left = far, right = -far, low = far, lowest = far;
    for (const Vec<Real>& own : problem.body.corners) {
        const Vec<Real> corner = car.at(own);
        left = std::min(left, corner.x), right = std::max(right, corner.x), low = std::min(low, corner.y);
    }
    for (const Vec<Real>& own : problem.at_curb.corners) lowest = std::min(lowest, car.at(own).y);
    Real front = std::min(right - p.x, p.y - low), rear = std::min(q.x - left, q.y - low);
    for (std::size_t i = 0; i < problem.body.size(); ++i) {
        const Vec<Real> n = car.turned(problem.body.normals[i]);
        // Only an edge that looks at the block from outside can separate; the block's nearest point is its corner.
        if (n.y > 0) continue;
        const Vec<Real> on_edge = car.at(problem.body.corners[i]);
        if (n.x >= 0) front = std::min(front, dot(n, on_edge - p));
        if (n.x <= 0) rear = std::min(rear, dot(n, on_edge - q));
    }
    return {front, rear, -problem.width - lowest};
}

template <class Real>
std::array<Real, 3> depths(const Problem<Real>& problem, const Place<Real>& place) {
    return depths(problem, Standing<Real>(place));
}

template <class Real>
Real depth(const Problem<Real>& problem, const Standing<Real>& car) {
    const std::array<Real, 3> all = depths(problem, car);
    return std::max({all[0], all[1], all[2]});
}
template <class Real>
Real depth(const Problem<Real>& problem, const Place<Real>& place) {
    return depth(problem, Standing<Real>(place));
}

/// How far the car is from being parked by the worst of all conditions, a radian counting as a metre; not above zero
/// when it is parked, provided that it is free.
template <class Real>
Real short_of_parked(const Problem<Real>& problem, const Standing<Real>& car) {
    Real worst = std::abs(car.heading) - problem.parked_heading;
    Real low = std::numeric_limits<Real>::infinity();
    for (const Vec<Real>& own : problem.car.corners) {
        const Vec<Real> p = car.at(own);
        worst = std::max({worst, p.y, p.x, -problem.length - p.x});
        low = std::min(low, p.y);
    }
    return std::max(worst, low + problem.width - problem.parked_curb);
}
template <class Real>
Real short_of_parked(const Problem<Real>& problem, const Place<Real>& place) {
    return short_of_parked(problem, Standing<Real>(place));
}

/// How far the worst corner sticks out of the slot on the road's side or over an end, and the wheels over the curb.
template <class Real>
Real outside(const Problem<Real>& problem, const Place<Real>& place) {
    Problem<Real> anyhow = problem;
    anyhow.parked_heading = anyhow.parked_curb = std::numeric_limits<Real>::infinity();
    return std::max(short_of_parked(anyhow, place), depths(problem, place)[curb_block]);
}

/// A quantity along a path: its value and slope here, and the most its slope changes per metre.
template <class Real>
struct Quantity {
    Real value, slope, bend;

    /// It certainly stays at or below zero that far, at most `most`.
    Real stays_below(Real most) const {
        if (value > 0) return 0;
        if (value + slope * most + bend * most * most / 2 <= 0) return most;
        const Real root = std::sqrt(std::max(slope * slope - 2 * bend * value, Real(0)));
        const Real distance = slope > 0 ? -2 * value / (slope + root) : (root - slope) / bend;
        return std::min(distance, most);
    }
    /// It certainly stays at or above zero that far.
    Real stays_above(Real most) const { return Quantity{-value, -slope, bend}.stays_below(most); }
};

/// A car on a path among its obstacles.
template <class Real>
class Moving {
public:
    Moving(const Problem<Real>& problem, const Path<Real>& path)
        : problem_(problem), way_(path), direction_(Real(path.direction)), turn_(path.turn()) {
        const auto bends_of = [&](const Polygon<Real>& polygon) {
            std::vector<Real> bends;
            for (const Vec<Real>& p : polygon.corners)
                bends.push_back(path.straight() ? Real(0) : bend(p, {0, path.radius}));
            return bends;
        };
        body_ = bends_of(problem.body);
        at_curb_ = bends_of(problem.at_curb);
        car_ = bends_of(problem.car);
        const Vec<Real> centre{path.start.x - path.radius * std::sin(path.start.heading),
                               path.start.y + path.radius * std::cos(path.start.heading)};
        if (!path.straight())
            front_corner_ = bend(problem.front_corner(), centre), rear_corner_ = bend(problem.rear_corner(), centre);
    }

    /// How far the car certainly goes on from `distance` without sinking deeper than `allowed` into anything.
    Real free_for(Real distance, Real most, Real allowed) const {
        const Seen seen(*this, distance);
        const Vec<Real> p = problem_.front_corner(), q = problem_.rear_corner();
        const auto rounded = [&](Real value) { return value > 0 && value <= problem_.forgiven ? Real(0) : value; };
        const auto limit = [&](Real& safe, Real value, Real slope, Real bend) {
            safe = Quantity<Real>{rounded(value - allowed), slope, bend}.stays_below(safe);
        };
        for (std::size_t i = 0; i < at_curb_.size() && most > 0; ++i) {
            const auto [point, speed] = seen.corner(problem_.at_curb.corners[i]);
            limit(most, -problem_.width - point.y, -speed.y, at_curb_[i]);
        }
        if (most <= 0) return 0;
        // One axis is enough for each block: across the road, along it, or across an edge of the car.
        Real front = most, above_front = most, rear = most, above_rear = most;
        for (std::size_t i = 0; i < body_.size(); ++i) {
            const auto [point, speed] = seen.corner(problem_.body.corners[i]);
            if (front > 0) limit(front, point.x - p.x, speed.x, body_[i]);
            if (above_front > 0) limit(above_front, p.y - point.y, -speed.y, body_[i]);
            if (rear > 0) limit(rear, q.x - point.x, -speed.x, body_[i]);
            if (above_rear > 0) limit(above_rear, q.y - point.y, -speed.y, body_[i]);
        }
        front = std::max(front, above_front), rear = std::max(rear, above_rear);
        for (std::size_t i = 0; i < body_.size() && std::min(front, rear) < most; ++i) {
            const Vec<Real> n = seen.car.turned(problem_.body.normals[i]);
            if (n.y > 0) continue;
            const Vec<Real> edge = seen.corner(problem_.body.corners[i]).point, n_slope = turn_ * left_of(n);
            // Only as long as the edge looks at the block.
            const auto beside = [&](Vec<Real> corner, Real towards, Real bend) {
                Real safe = most;
                limit(safe, dot(n, edge - corner), dot(n_slope, seen.car.axle - corner) + dot(n, seen.travel), bend);
                safe = Quantity<Real>{n.y, n_slope.y, turn_ * turn_}.stays_below(safe);
                return Quantity<Real>{-towards * n.x, -towards * n_slope.x, turn_ * turn_}.stays_below(safe);
            };
            if (n.x >= 0 && front < most) front = std::max(front, beside(p, 1, front_corner_));
            if (n.x <= 0 && rear < most) rear = std::max(rear, beside(q, -1, rear_corner_));
        }
        return std::min({most, front, rear});
    }

    /// How far the car certainly goes on with one of the conditions of being parked short by `level` or more.
    Real short_for(Real distance, Real most, Real level) const {
        const Seen seen(*this, distance);
        const Real heading = seen.car.heading;
        Real far = 0, near_curb = most;
        const auto holds = [&](Real value, Real slope, Real bend) {
            if (far < most && value > level)
                far = std::max(far, Quantity<Real>{value - level, slope, bend}.stays_above(most));
        };
        holds(heading - problem_.parked_heading, turn_, 0);
        holds(-heading - problem_.parked_heading, -turn_, 0);
        for (std::size_t i = 0; i < car_.size() && far < most; ++i) {
            const auto [point, speed] = seen.corner(problem_.car.corners[i]);
            holds(point.y, speed.y, car_[i]);
            holds(point.x, speed.x, car_[i]);
            holds(-problem_.length - point.x, -speed.x, car_[i]);
            const Quantity<Real> above{point.y + problem_.width - problem_.parked_curb - level, speed.y, car_[i]};
            near_curb = above.value > 0 ? above.stays_above(near_curb) : 0;
        }
        return std::max(far, near_curb);
    }

    /// How far the car certainly goes on parked, as far as nothing stops it.
    Real parked_for(Real distance, Real most) const {
        const Seen seen(*this, distance);
        Real near_curb = std::isinf(problem_.parked_curb) ? most : 0;
        const auto limit = [&](Real value, Real slope, Real bend) {
            most = Quantity<Real>{value > 0 && value <= problem_.forgiven ? 0 : value, slope, bend}.stays_below(most);
        };
        const Real whole = most;
        limit(seen.car.heading - problem_.parked_heading, turn_, 0);
        limit(-seen.car.heading - problem_.parked_heading, -turn_, 0);
        for (std::size_t i = 0; i < car_.size(); ++i) {
            const auto [point, speed] = seen.corner(problem_.car.corners[i]);
            limit(point.y, speed.y, car_[i]);
            limit(point.x, speed.x, car_[i]);
            limit(-problem_.length - point.x, -speed.x, car_[i]);
            const Quantity<Real> above{point.y + problem_.width - problem_.parked_curb, speed.y, car_[i]};
            near_curb = std::max(near_curb, above.stays_below(whole));
        }
        return std::min(most, near_curb);
    }

private:
    struct Corner {
        Vec<Real> point, speed;
    };

    /// The car at one moment.
    struct Seen {
        Seen(const Moving& moving, Real distance)
            : car(moving.way_.at(distance)), travel(moving.direction_ * car.ahead), turn(moving.turn_) {}
        Corner corner(Vec<Real> p) const {
            const Vec<Real> from_axle = car.turned(p);
            return {car.axle + from_axle, travel + turn * left_of(from_axle)};
        }
        Standing<Real> car;
        Vec<Real> travel;
        Real turn;
    };

    /// A point that turns about a centre bends by the square of the turning rate times its distance.
    Real bend(Vec<Real> p, Vec<Real> centre) const {
        const Vec<Real> arm = p - centre;
        return turn_ * turn_ * std::sqrt(dot(arm, arm));
    }

    const Problem<Real>& problem_;
    Way<Real> way_;
    Real direction_, turn_;
    std::vector<Real> body_, at_curb_, car_;  // how much each corner's path bends
    Real front_corner_ = 0, rear_corner_ = 0;
};

/// Goes in safe steps while `safe(distance, most)` lets it, then creeps until `over` says that it is over, and halves to
/// where `holds` last held. Infinity if it is not over by `farthest`.
template <class Real, class Safe, class Over, class Holds>
Real first_end(Real farthest, Real forgiven, const Safe& safe, const Over& over, const Holds& holds) {
    // Between two creeping steps a curve of a metre's radius rises by less than what is forgiven. Fine numbers begin so close
    // that a dip with a kink at its bottom, where the car is parallel, is seen from a hundred-thousandth of that on.
    const Real longest = std::sqrt(forgiven), shortest = longest / (sizeof(Real) > 8 ? Real(1e6L) : Real(1e3L));
    Real distance = 0, creep = shortest, last = 0;
    while (distance < farthest) {
        const Real step = safe(distance, farthest - distance);
        if (step > shortest) {
            distance += step;
            last = distance;
            creep = shortest;
            continue;
        }
        const Real next = std::min(distance + creep, farthest);
        if (over(next)) {
            if (!holds(last)) return last;
            Real low = last, high = next;
            for (int i = 0; i < 80; ++i) {
                const Real middle = low + (high - low) / 2;
                if (middle <= low || middle >= high) break;
                (holds(middle) ? low : high) = middle;
            }
            return high;
        }
        if (holds(next)) last = next;
        distance = next;
        creep = std::min(2 * creep, longest);
    }
    return std::numeric_limits<Real>::infinity();
}

/// Where the car first sinks deeper than `allowed` into something.
template <class Real>
Real first_contact(const Problem<Real>& problem, const Path<Real>& path, Real farthest, Real allowed = 0) {
    const Moving<Real> moving(problem, path);
    const Way<Real> way(path);
    return first_end(
        farthest, problem.forgiven, [&](Real distance, Real most) { return moving.free_for(distance, most, allowed); },
        [&](Real distance) { return depth(problem, way.at(distance)) > allowed + problem.forgiven; },
        [&](Real distance) { return depth(problem, way.at(distance)) <= allowed; });
}

/// Nothing is deeper than `allowed` in anything anywhere on the way.
template <class Real>
bool is_free(const Problem<Real>& problem, const Path<Real>& path, Real length, Real allowed) {
    return depth(problem, path.start) <= allowed && std::isinf(first_contact(problem, path, length, allowed));
}

/// Where the car is first parked.
template <class Real>
Real first_parked(const Problem<Real>& problem, const Path<Real>& path, Real farthest) {
    if (short_of_parked(problem, path.start) <= 0) return 0;
    const Moving<Real> moving(problem, path);
    const Way<Real> way(path);
    const auto parked = [&](Real distance) { return short_of_parked(problem, way.at(distance)) <= 0; };
    return first_end(
        farthest, problem.forgiven, [&](Real distance, Real most) { return moving.short_for(distance, most, 0); },
        parked, [&](Real distance) { return !parked(distance); });
}

/// Where a car that starts parked is so no longer.
template <class Real>
Real last_parked(const Problem<Real>& problem, const Path<Real>& path, Real farthest) {
    const Moving<Real> moving(problem, path);
    const Way<Real> way(path);
    const auto missing = [&](Real distance) { return short_of_parked(problem, way.at(distance)); };
    return std::min(farthest, first_end(
                                  farthest, problem.forgiven,
                                  [&](Real distance, Real most) { return moving.parked_for(distance, most); },
                                  [&](Real distance) { return missing(distance) > problem.forgiven; },
                                  [&](Real distance) { return missing(distance) <= 0; }));
}

/// The least the car is short of being parked along a path: the lowest of samples, and below it by golden section. It
/// says where to look, and decides nothing.
template <class Real>
Real least_short_of_parked(const Problem<Real>& problem, const Path<Real>& path, Real farthest) {
    constexpr int samples = 8;
    const Way<Real> way(path);
    const auto height = [&](Real distance) { return short_of_parked(problem, way.at(distance)); };
    Real best = 0, least = height(0);
    for (int i = 1; i <= samples; ++i) {
        const Real here = height(farthest * Real(i) / samples);
        if (here < least) least = here, best = Real(i);
    }
    Real a = farthest * std::max(best - 1, Real(0)) / samples;
    Real b = farthest * std::min(best + 1, Real(samples)) / samples;
    constexpr Real golden = Real(0.618033988749894848204586834365638118L);
    Real x = b - golden * (b - a), y = a + golden * (b - a), at_x = height(x), at_y = height(y);
    for (int i = 0; i < 60 && b - a > Real(1e-9L); ++i) {
        if (at_x <= at_y) {
            b = y, y = x, at_y = at_x;
            at_x = height(x = b - golden * (b - a));
        } else {
            a = x, x = y, at_x = at_y;
            at_y = height(y = a + golden * (b - a));
        }
    }
    return std::min({least, at_x, at_y});
}

/// What met what: the block, and the axis across which they touch.
struct Meeting {
    Block block = front_block;
    int axis = 0;          // -2 across the road, -1 along it, else the car's edge with that index
    std::size_t part = 0;  // the edge's index, or the corner's
    int number() const { return (axis + 2) * 128 + int(part) * 4 + int(block); }
};

/// What the car, hardly overlapping, touches with what.
template <class Real>
Meeting meeting(const Problem<Real>& problem, const Place<Real>& place) {
    const std::array<Real, 3> deep = depths(problem, place);
    Meeting met;
    met.block = Block(std::max_element(deep.begin(), deep.end()) - deep.begin());
    const Polygon<Real>& touching = met.block == curb_block ? problem.at_curb : problem.body;
    const std::vector<Vec<Real>> body = at(touching, place);
    const Standing<Real> car(place);
    Real least = std::numeric_limits<Real>::infinity();
    const auto across = [&](int axis, Real far, std::size_t part) {
        if (far < least) least = far, met.axis = axis, met.part = part;
    };
    const Real towards = met.block == front_block ? 1 : -1;
    const Vec<Real> corner = met.block == front_block ? problem.front_corner() : problem.rear_corner();
    const auto farthest = [&](auto&& far) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < body.size(); ++i)
            if (far(body[i]) > far(body[best])) best = i;
        return best;
    };
    const std::size_t low = farthest([](Vec<Real> p) { return -p.y; });
    if (met.block == curb_block) {
        across(-2, 0, low);
        return met;
    }
    const std::size_t ahead = farthest([&](Vec<Real> p) { return towards * p.x; });
    across(-2, corner.y - body[low].y, low);
    across(-1, towards * (body[ahead].x - corner.x), ahead);
    for (std::size_t i = 0; i < body.size(); ++i) {
        const Vec<Real> n = car.turned(touching.normals[i]);
        if (n.y <= 0 && towards * n.x >= 0) across(int(i), dot(n, body[i] - corner), i);
    }
    return met;
}

}  // namespace oracle
