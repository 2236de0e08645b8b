// Algorithm 1 the plain way: cosines and sines from the standard library, every edge of the frame against every side of
// the slot after each step. What the fast one in src/ must agree with, step for step.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "snug/car.hpp"
#include "snug/slot.hpp"
#include "snug/stepping.hpp"

namespace snug::test {

using Corners = std::array<Point, 4>;

inline Corners corners(double front, double rear, double width, const Pose& pose) {
    const double c = std::cos(pose.heading);
    const double s = std::sin(pose.heading);
    const auto at = [&](double u, double v) { return Point{pose.x + u * c - v * s, pose.y + u * s + v * c}; };
    return {at(front, width / 2), at(-rear, width / 2), at(-rear, -width / 2), at(front, -width / 2)};
}

/// The frame of a car grown by the clearance.
inline Corners grown_frame(const Car& car, double clearance, const Pose& pose) {
    return corners(car.front() + clearance, car.rear() + clearance, car.width() + 2 * clearance, pose);
}

/// Twice the area of the triangle, positive when c lies to the left of the line from a to b.
inline double left_of(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The inside of the counter-clockwise rectangle meets the segment: an end lies in it, or the segment crosses an edge.
inline bool intersects(const Corners& rectangle, const Point& a, const Point& b) {
    bool a_inside = true;
    bool b_inside = true;
    for (std::size_t i = 0; i < 4; ++i) {
        const Point& from = rectangle[i];
        const Point& to = rectangle[(i + 1) % 4];
        a_inside = a_inside && left_of(from, to, a) > 0;
        b_inside = b_inside && left_of(from, to, b) > 0;
        if (left_of(from, to, a) * left_of(from, to, b) < 0 && left_of(a, b, from) * left_of(a, b, to) < 0) {
            return true;
        }
    }
    return a_inside || b_inside;
}

inline bool hits_front_side(const Corners& f, const Slot& slot) { return intersects(f, {0, 0}, {0, -slot.width()}); }
inline bool hits_curb(const Corners& f, const Slot& slot) {
    return intersects(f, {0, -slot.width()}, {-slot.length(), -slot.width()});
}
inline bool hits_rear_side(const Corners& f, const Slot& slot) {
    return intersects(f, {-slot.length(), -slot.width()}, {-slot.length(), 0});
}
inline bool hits(const Corners& f, const Slot& slot) {
    return hits_front_side(f, slot) || hits_curb(f, slot) || hits_rear_side(f, slot);
}

inline bool inside(const Corners& f, const Slot& slot) {
    for (const Point& corner : f) {
        if (!(corner.x >= -slot.length() && corner.x <= 0 && corner.y >= -slot.width() && corner.y <= 0)) {
            return false;
        }
    }
    return true;
}

/// Equation 1.
inline Pose euler_step(const Car& car, const Pose& pose, int direction, double steering_angle, double step) {
    const double path = direction * step;
    return {pose.x + path * std::cos(pose.heading), pose.y + path * std::sin(pose.heading),
            pose.heading + path / car.wheelbase() * std::tan(steering_angle)};
}

struct LiteralRun {
    Outcome outcome = Outcome::no_entry;
    std::vector<long> steps;  ///< of each move
    Pose goal;                ///< in the slot frame
};

/// From one entry heading, backward, into a slot whose frame is taken for the world.
inline LiteralRun literal_run(const Car& car, const Slot& slot, double heading, const Stepping& options,
                              int max_changes, double clearance) {
    LiteralRun run;
    const Point corner = grown_frame(car, clearance, {0, 0, heading})[3];
    Pose pose{-corner.x, -corner.y, heading};
    // Touching p at the start is no intersection, and the front side can only be touched there.
    const Corners at_entry = grown_frame(car, clearance, pose);
    if (hits_curb(at_entry, slot) || hits_rear_side(at_entry, slot)) {
        return run;
    }
    int direction = -1;
    for (int changes = 0; changes <= max_changes; ++changes, direction = -direction) {
        const double steering_angle = -direction * car.max_steer();
        const double start_heading = pose.heading;
        long steps = 0;
        for (;;) {
            const Pose next = euler_step(car, pose, direction, steering_angle, options.step);
            if (hits(grown_frame(car, clearance, next), slot)) {
                break;
            }
            pose = next;
            ++steps;
            run.outcome = Outcome::too_many_changes;
            if (options.stop == StopRule::inside && inside(grown_frame(car, 0, pose), slot)) {
                run.outcome = Outcome::parked;
                break;
            }
            if (start_heading - pose.heading > 2 * std::numbers::pi - 1e-9) {
                run.outcome = Outcome::never_touches;
                break;
            }
        }
        run.goal = pose;
        if (steps == 0) {
            run.outcome = changes == 0 ? Outcome::no_entry : Outcome::stuck;
            break;
        }
        run.steps.push_back(steps);
        if (run.outcome != Outcome::too_many_changes) {
            break;
        }
        if (options.stop == StopRule::contact && inside(grown_frame(car, 0, pose), slot)) {
            run.outcome = Outcome::parked;
            break;
        }
    }
    return run;
}

}  // namespace snug::test
