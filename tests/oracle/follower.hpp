// Follows a maneuver from end to end and says everything that is wrong with it, with formulas of its own.
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

/// Distance of a point from the segment between two others.
inline double from_segment(Vec<double> p, Vec<double> a, Vec<double> b) {
    const Vec<double> along = b - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    return length(p - (a + t * along));
}

/// Distance of a corner of the car from an obstacle's edge. What lands on a neighbour from the road touches its side.
inline double from_obstacle(Vec<double> p, const Problem<double>& problem, snug::Obstacle obstacle) {
    const Vec<double> front = problem.front_corner(), rear = problem.rear_corner();
    const auto from_side = [](double beyond, double below) {
        return beyond >= 0 ? std::abs(std::min(beyond, below)) : std::hypot(beyond, std::min(below, 0.0));
    };
    switch (obstacle) {
        case snug::Obstacle::front_side: return from_side(p.x - front.x, front.y - p.y);
        case snug::Obstacle::rear_side: return from_side(rear.x - p.x, rear.y - p.y);
        case snug::Obstacle::curb: return std::abs(p.y + problem.width);
        case snug::Obstacle::front_corner: return length(p - front);
        default: return length(p - rear);
    }
}

/// Distance between the named part of a rectangle, or of any other outline its nearest part, and the named obstacle.
inline double gap_between(const Problem<double>& problem, const Place<double>& place, snug::Contact contact,
                          bool rectangle) {
    const Polygon<double>& touching = contact.obstacle == snug::Obstacle::curb ? problem.at_curb : problem.body;
    const std::vector<Vec<double>> body = at(touching, place);
    const auto from_corner = [&](std::size_t i) {
        return from_obstacle(body[i % body.size()], problem, contact.obstacle);
    };
    const bool at_corner =
        contact.obstacle == snug::Obstacle::front_corner || contact.obstacle == snug::Obstacle::rear_corner;
    const Vec<double> corner =
        contact.obstacle == snug::Obstacle::front_corner ? problem.front_corner() : problem.rear_corner();
    const auto from_edge = [&](std::size_t i) {
        // A whole edge against a side: they lie on each other.
        return at_corner ? from_segment(corner, body[i], body[(i + 1) % body.size()])
                         : std::max(from_corner(i), from_corner(i + 1));
    };
    if (rectangle) {
        // Corners front-left, rear-left, rear-right, front-right; then edges front, left, rear, right.
        const auto part = static_cast<std::size_t>(contact.part);
        return part < 4 ? from_corner(part) : from_edge((part + 3) % 4);
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < body.size(); ++i) least = std::min({least, from_corner(i), from_edge(i)});
    return least;
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
    const auto problem = make_problem<double>(asked);
    const double near = 1e-9;
    const bool backward = asked.driving.enter == snug::Enter::backward;
    const double mirror = asked.slot.side == snug::Side::left ? -1.0 : 1.0;

    const snug::Move& first = maneuver.moves.front();
    const Place<double> entry = into_slot(asked.slot, first.start);
    const double heading = backward ? entry.heading : -entry.heading;
    if (!(heading >= -near && heading <= std::numbers::pi / 2 + near)) fault("entry heading ", heading);
    const double off = length(Standing<double>(entry).at(touching_corner(problem)) -
                              (backward ? problem.front_corner() : problem.rear_corner()));
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
        const double sinks = first_contact(problem, path, move.length, near);
        if (std::isfinite(sinks)) fault("move ", i, " sinks into an obstacle after ", sinks, " m");
        if (move.contact) {
            snug::Contact contact = *move.contact;
            // In a mirrored slot left and right parts swap; the slot frame sees a right-hand slot.
            if (mirror < 0) {
                constexpr std::array<int, 8> swapped = {3, 2, 1, 0, 4, 7, 6, 5};
                contact.part = static_cast<snug::CarPart>(swapped[static_cast<std::size_t>(contact.part)]);
            }
            const double apart = gap_between(problem, stated, contact, asked.outline.empty());
            if (apart > near)
                fault("move ", i, " says ", snug::to_string(contact.part), " meets ", snug::to_string(contact.obstacle),
                      " but they are ", apart, " m apart");
        }
        const int samples = std::max(2, int(std::ceil(move.length / 2e-3)));
        for (int k = 0; k <= samples; ++k) {
            const Place<double> place = path.at(move.length * k / samples);
            for (const Vec<double>& p : at(problem.car, place)) {
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
    const double out = short_of_parked(problem, into_slot(asked.slot, maneuver.moves.back().end));
    if (out > near) fault("the goal is short of parked by ", out, " m or rad");

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
