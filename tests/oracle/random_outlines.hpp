// Seeded random outlines of 4 to 32 corners, neighbours set back, low curbs, and what counts as parked.
#pragma once

#include "random_cases.hpp"

namespace oracle {

namespace outlines {

using Points = std::vector<snug::Point>;

/// A quarter of an ellipse or a straight cut at each corner of a rectangle, in one or more pieces, counter-clockwise
/// from the front left.
inline Points trimmed(Random& random, const snug::CarDimensions& car, bool alike, int most_pieces) {
    const double side = car.width / 2;
    const double along_front = car.front - std::min(car.front * 0.9, std::max(0.0, car.wheelbase)) + 0.3;
    Points points;
    const int pieces = 1 + random.below(most_pieces);
    double along[4], across[4];
    for (int i = 0; i < 4; ++i) {
        const bool at_front = i == 0 || i == 3;
        along[i] = random.between(0.02, at_front ? along_front : 0.9 * car.rear);
        across[i] = random.between(0.02, 0.9 * side);
    }
    if (alike) along[3] = along[0], across[3] = across[0], along[2] = along[1], across[2] = across[1];
    const double turn = std::numbers::pi / 2 / pieces;
    for (int i = 0; i < 4; ++i) {
        const double x = i == 0 || i == 3 ? car.front - along[i] : -car.rear + along[i];
        const double y = i < 2 ? side - across[i] : -side + across[i];
        for (int k = 0; k <= pieces; ++k) {
            const double angle = i * std::numbers::pi / 2 + k * turn;
            points.push_back({x + along[i] * std::cos(angle), y + across[i] * std::sin(angle)});
        }
    }
    return points;
}

/// Anything round an egg: points at random angles, made convex by their nature.
inline Points egg(Random& random, const snug::CarDimensions& car, int corners) {
    std::vector<double> angles;
    const double offset = random.unit();
    for (int i = 0; i < corners; ++i)
        angles.push_back((i + offset + random.between(-0.4, 0.4)) * 2 * std::numbers::pi / corners);
    const double middle = (car.front - car.rear) / 2, half = (car.front + car.rear) / 2,
                 power = random.between(0.35, 1.0);
    const double skew = random.between(-0.3, 0.3);
    Points points;
    for (const double angle : angles) {
        const double c = std::cos(angle), s = std::sin(angle);
        const double y = car.width / 2 * std::copysign(std::pow(std::abs(s), power), s);
        points.push_back({middle + half * std::copysign(std::pow(std::abs(c), power), c) + skew * y, y});
    }
    return points;
}

/// Four corners, no two edges parallel: a wedge or a kite.
inline Points wedge(Random& random, const snug::CarDimensions& car) {
    const double side = car.width / 2;
    Points points = {{car.front, side}, {-car.rear, side}, {-car.rear, -side}, {car.front, -side}};
    for (snug::Point& p : points) p.x *= random.between(0.85, 1.15), p.y *= random.between(0.6, 1.15);
    return points;
}

/// The convex hull without corners that are hardly any, counter-clockwise.
inline Points hull(Points points) {
    std::sort(points.begin(), points.end(),
              [](const snug::Point& a, const snug::Point& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    Points chain;
    const auto wrap = [&](const snug::Point& p, std::size_t least) {
        const auto bent = [&] {
            const snug::Point a = chain[chain.size() - 2], b = chain.back();
            const Vec<double> in{b.x - a.x, b.y - a.y}, out{p.x - b.x, p.y - b.y};
            return length(out) > 0.01 && length(in) > 0.01 && cross(in, out) > 1e-3 * length(in) * length(out);
        };
        while (chain.size() >= least && !bent()) chain.pop_back();
        chain.push_back(p);
    };
    for (const snug::Point& p : points) wrap(p, 2);
    const std::size_t turned = chain.size() + 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) wrap(*p, turned);
    chain.pop_back();
    return chain;
}

/// Convex, with the rear axle's middle well inside and the front axle's inside.
inline bool is_a_car(const Points& points, double wheelbase) {
    if (points.size() < 4 || points.size() > 32) return false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto vec = [&](std::size_t k) {
            const snug::Point& p = points[k % points.size()];
            return Vec<double>{p.x, p.y};
        };
        const Vec<double> p = vec(i), in = p - vec(i + points.size() - 1), out = vec(i + 1) - p;
        if (cross(in, out) < 1e-3 * length(in) * length(out) || length(out) < 0.01) return false;
        if (cross(out, Vec<double>{0, 0} - p) < 0.02 * length(out)) return false;
        if (cross(out, Vec<double>{wheelbase, 0} - p) < 0.02 * length(out)) return false;
    }
    return true;
}

}  // namespace outlines

/// An outline about the dimensions the case has, which become how far it reaches.
inline void choose_outline(Random& random, Case& chosen) {
    snug::CarDimensions& car = chosen.car;
    if (car.front < car.wheelbase) std::swap(car.front, car.rear);
    car.front = std::max(car.front, car.wheelbase + 0.1);
    outlines::Points points;
    do {
        switch (random.below(6)) {
            case 0: points = outlines::trimmed(random, car, true, 7); break;
            case 1: points = outlines::trimmed(random, car, false, 7); break;
            case 2: points = outlines::trimmed(random, car, true, 1); break;
            case 3: points = outlines::trimmed(random, car, false, 1); break;
            case 4: points = outlines::egg(random, car, 5 + random.below(27)); break;
            default: points = outlines::wedge(random, car); break;
        }
        points = outlines::hull(points);
    } while (!outlines::is_a_car(points, car.wheelbase));
    double left = 0, right = 0;
    car.front = car.rear = 0;
    for (const snug::Point& p : points) {
        car.front = std::max(car.front, p.x), car.rear = std::max(car.rear, -p.x);
        left = std::max(left, p.y), right = std::max(right, -p.y);
    }
    car.width = left + right;
    chosen.car_name.clear();
    chosen.outline = points;
}

/// Neighbours set back, a low curb, a clearance of its own there, and what counts as parked: each now and then.
inline void choose_neighbours(Random& random, Case& chosen) {
    if (random.chance(0.2)) chosen.driving.curb_clearance = random.between(0, 0.15);
    const auto setback = [&] {
        const double kind = random.unit();
        return kind < 0.55 ? 0.0 : chosen.slot.width * (kind < 0.95 ? random.between(0, 0.4) : random.between(0, 1));
    };
    chosen.slot.front_setback = setback();
    chosen.slot.rear_setback = setback();
    if (random.chance(0.3)) chosen.slot.curb = snug::Curb::low;
    if (random.chance(0.25)) chosen.parked.heading = std::pow(10.0, random.between(-3.0, -0.7));
    if (random.chance(0.25)) chosen.parked.curb = random.between(0.02, 0.8);
}

/// Case number `index` of a seed: any convex outline between any neighbours.
inline Case random_outline_case(std::uint64_t seed, std::uint64_t index) {
    Random random = random_of(seed + 0x5A17, index);
    Case chosen;
    choose_car(random, chosen);
    choose_outline(random, chosen);
    if (random.chance(0.2)) chosen.driving.enter = snug::Enter::forward;
    if (random.chance(0.15)) chosen.driving.clearance = random.between(0.005, 0.1);
    choose_slot(random, chosen);
    choose_neighbours(random, chosen);
    choose_surroundings(random, chosen);
    return chosen;
}

}  // namespace oracle
