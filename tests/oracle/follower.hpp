// Follows a maneuver pose by pose and says everything that is wrong with it, with formulas of its own.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "random_cases.hpp"
#include "snug/maneuver.hpp"

namespace oracle {

/// From the world to the slot frame: the slot's corner to the origin, its heading to x, a left slot mirrored.
inline Place<double> into_slot(const snug::SlotDimensions& slot, const snug::Pose& pose) {
    const double c = std::cos(slot.heading), s = std::sin(slot.heading);
    const double dx = pose.x - slot.corner.x, dy = pose.y - slot.corner.y;
    const double mirror = slot.side == snug::Side::left ? -1.0 : 1.0;
    return {c * dx + s * dy, mirror * (-s * dx + c * dy), mirror * (pose.heading - slot.heading)};
}

/// The path of a move in the slot frame; an infinite radius when it goes straight.
inline Path<double> path_of(const snug::SlotDimensions& slot, const snug::CarDimensions& car, const snug::Move& move) {
    const double mirror = slot.side == snug::Side::left ? -1.0 : 1.0;
    const double radius = move.steering_angle == 0 ? std::numeric_limits<double>::infinity()
                                                   : mirror * car.wheelbase / std::tan(move.steering_angle);
    return {into_slot(slot, move.start), radius, move.direction == snug::Direction::forward ? 1 : -1};
}

/// Distance between the named part of the frame and the named obstacle, both as the finite segments or points they are.
inline double gap_between(const Body<double>& body, const Place<double>& place, const Gap<double>& gap,
                          snug::Contact contact) {
    const std::array<Vec<double>, 4> at = corners_at(body, place);
    const auto part = static_cast<std::size_t>(contact.part);
    if (part < 4) {  // front-left, rear-left, rear-right, front-right corner
        const Vec<double> p = at[part];
        switch (contact.obstacle) {
            case snug::Obstacle::front_side:
                return p.x >= 0 ? std::abs(std::min(p.x, -p.y)) : std::hypot(p.x, std::max(p.y, 0.0));
            case snug::Obstacle::rear_side: {
                const double beyond = -gap.length - p.x;
                return beyond >= 0 ? std::abs(std::min(beyond, -p.y)) : std::hypot(beyond, std::max(p.y, 0.0));
            }
            case snug::Obstacle::curb: return std::abs(p.y + gap.width);
            case snug::Obstacle::front_corner: return std::hypot(p.x, p.y);
            case snug::Obstacle::rear_corner: return std::hypot(p.x + gap.length, p.y);
        }
    }
    // Front, left, rear, right edge.
    const std::size_t from[] = {3, 0, 1, 2}, to[] = {0, 1, 2, 3};
    const Vec<double> a = at[from[part - 4]], b = at[to[part - 4]];
    const auto from_edge = [&](double x, double y) {
        const double length2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
        const double t = std::clamp(((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / length2, 0.0, 1.0);
        return std::hypot(a.x + t * (b.x - a.x) - x, a.y + t * (b.y - a.y) - y);
    };
    if (contact.obstacle == snug::Obstacle::front_corner) return from_edge(0, 0);
    if (contact.obstacle == snug::Obstacle::rear_corner) return from_edge(-gap.length, 0);
    // A whole edge against a side: they lie on each other.
    snug::Contact end = contact;
    end.part = static_cast<snug::CarPart>(from[part - 4]);
    const double first = gap_between(body, place, gap, end);
    end.part = static_cast<snug::CarPart>(to[part - 4]);
    return std::max(first, gap_between(body, place, gap, end));
}

/// The deepest overlap along a path: sampled, and every local maximum narrowed down.
inline double deepest(const Body<double>& body, const Gap<double>& gap, const Path<double>& path, double length,
                      double spacing = 2e-3) {
    const auto at = [&](double distance) { return depth(body, path.at(distance), gap); };
    const int steps = std::max(2, int(std::ceil(length / spacing)));
    double worst = std::max(at(0), at(length));
    double before = at(0), here = at(length / steps);
    for (int i = 1; i < steps; ++i) {
        const double after = at(length * (i + 1) / steps);
        if (here >= before && here >= after && here > -spacing) {
            double a = length * (i - 1) / steps, b = length * (i + 1) / steps;
            for (int k = 0; k < 60; ++k) {
                const double left = a + (b - a) / 3, right = b - (b - a) / 3;
                (at(left) < at(right) ? a : b) = at(left) < at(right) ? left : right;
            }
            worst = std::max(worst, at((a + b) / 2));
        }
        worst = std::max(worst, here);
        before = here;
        here = after;
    }
    return worst;
}

/// Everything wrong with a parking maneuver, a sentence each; `changes` is how often it should change direction.
inline std::vector<std::string> faults(const Case& asked, const snug::Maneuver& maneuver, int changes) {
    std::vector<std::string> found;
    const auto fault = [&](auto&&... words) {
        std::ostringstream sentence;
        sentence.precision(17);
        (sentence << ... << words);
        found.push_back(sentence.str());
    };
    if (maneuver.moves.empty()) {
        fault("the maneuver has no moves");
        return found;
    }
    const auto problem = make_problem<double>(asked.car, asked.slot.length, asked.slot.width, asked.driving.clearance,
                                              asked.driving.enter);
    const double near = 1e-9;
    const bool backward = asked.driving.enter == snug::Enter::backward;
    const double mirror = asked.slot.side == snug::Side::left ? -1.0 : 1.0;

    const snug::Move& first = maneuver.moves.front();
    const Place<double> entry = into_slot(asked.slot, first.start);
    const double heading = backward ? entry.heading : -entry.heading;
    if (!(heading >= -near && heading <= std::numbers::pi / 2 + near)) fault("entry heading ", heading);
    const std::array<Vec<double>, 4> corners = corners_at(problem.grown, entry);
    const Vec<double> touching = backward ? corners[3] : corners[2];
    const double off = std::hypot(touching.x + (backward ? 0.0 : asked.slot.length), touching.y);
    if (off > near) fault("the entry position is ", off, " m off the slot's corner");
    if ((first.direction == snug::Direction::backward) != backward) fault("the first move goes the wrong way");
    if (std::abs(first.steering_angle * mirror - asked.car.max_steer) > 1e-12)
        fault("the first move steers ", first.steering_angle);

    int counted = 0;
    double driven = 0;
    snug::Box world{1e300, -1e300, 1e300, -1e300}, road = world;
    for (std::size_t i = 0; i < maneuver.moves.size(); ++i) {
        const snug::Move& move = maneuver.moves[i];
        if (i > 0) {
            const snug::Move& last = maneuver.moves[i - 1];
            if (last.direction != move.direction) ++counted;
            if (std::hypot(last.end.x - move.start.x, last.end.y - move.start.y) > near ||
                std::abs(last.end.heading - move.start.heading) > near)
                fault("move ", i, " does not start where the last one ended");
        }
        if (!(std::abs(move.steering_angle) <= asked.car.max_steer)) fault("move ", i, " steers ", move.steering_angle);
        if (!(move.length >= 0) || !std::isfinite(move.length)) fault("move ", i, " has length ", move.length);
        driven += move.length;
        const Path<double> path = path_of(asked.slot, asked.car, move);
        const Place<double> end = path.at(move.length), stated = into_slot(asked.slot, move.end);
        const double miss = std::hypot(end.x - stated.x, end.y - stated.y);
        if (miss > near || std::abs(end.heading - stated.heading) > near)
            fault("move ", i, " ends ", miss, " m and ", end.heading - stated.heading, " rad from where it says");
        const double overlap = deepest(problem.grown, problem.gap, path, move.length);
        if (overlap > near) fault("move ", i, " overlaps an obstacle by ", overlap, " m");
        if (move.contact) {
            snug::Contact contact = *move.contact;
            // In a mirrored slot left and right parts swap; the slot frame sees a right-hand slot.
            if (mirror < 0) {
                constexpr std::array<int, 8> swapped = {3, 2, 1, 0, 4, 7, 6, 5};
                contact.part = static_cast<snug::CarPart>(swapped[static_cast<std::size_t>(contact.part)]);
            }
            const double apart = gap_between(problem.grown, stated, problem.gap, contact);
            if (apart > near)
                fault("move ", i, " says ", snug::to_string(contact.part), " meets ", snug::to_string(contact.obstacle),
                      " but they are ", apart, " m apart");
        }
        const int samples = std::max(2, int(std::ceil(move.length / 2e-3)));
        for (int k = 0; k <= samples; ++k) {
            const Place<double> place = path.at(move.length * k / samples);
            for (const Vec<double>& p : corners_at(problem.car, place)) {
                road.x_min = std::min(road.x_min, p.x), road.x_max = std::max(road.x_max, p.x);
                road.y_min = std::min(road.y_min, p.y), road.y_max = std::max(road.y_max, p.y);
                const double c = std::cos(asked.slot.heading), s = std::sin(asked.slot.heading), y = mirror * p.y;
                const Vec<double> q{asked.slot.corner.x + c * p.x - s * y, asked.slot.corner.y + s * p.x + c * y};
                world.x_min = std::min(world.x_min, q.x), world.x_max = std::max(world.x_max, q.x);
                world.y_min = std::min(world.y_min, q.y), world.y_max = std::max(world.y_max, q.y);
            }
        }
    }
    if (counted != changes || maneuver.direction_changes() != changes)
        fault("the maneuver changes direction ", counted, " times, says ", maneuver.direction_changes(), " and should ",
              changes);
    if (std::abs(driven - maneuver.length()) > near) fault("its length is ", driven, " but says ", maneuver.length());
    const double out = outside(problem.car, into_slot(asked.slot, maneuver.moves.back().end), problem.gap);
    if (out > near) fault("the goal sticks out of the slot by ", out, " m");

    const auto compare = [&](const snug::Box& stated, const snug::Box& seen, const char* name) {
        // Samples 2 mm apart miss an extreme by less than a micrometre, always on the inside.
        const std::array<double, 4> beyond = {seen.x_min - stated.x_min, stated.x_max - seen.x_max,
                                              seen.y_min - stated.y_min, stated.y_max - seen.y_max};
        for (const double b : beyond)
            if (!(b >= -near && b <= 5e-6)) fault("the swept box in the ", name, " is off by ", b, " m");
    };
    compare(snug::swept(maneuver), world, "world");
    compare(snug::swept(maneuver, snug::Slot(asked.slot)), road, "slot frame");
    return found;
}

}  // namespace oracle
