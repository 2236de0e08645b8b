// Random real maneuvers out of a slot, in code that the solver does not share.
#pragma once

#include <cmath>

#include "all_maneuvers/sets/chart.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"

namespace park_test {

inline snug::Pose driven(const snug::Pose& from, double curvature, double on) {
    const double turned = on * curvature;
    if (std::abs(turned) < 1e-9)
        return {from.x + on * std::cos(from.heading + turned / 2), from.y + on * std::sin(from.heading + turned / 2),
                from.heading + turned};
    return {from.x + (std::sin(from.heading + turned) - std::sin(from.heading)) / curvature,
            from.y - (std::cos(from.heading + turned) - std::cos(from.heading)) / curvature, from.heading + turned};
}

/// A random maneuver that begins parked, with up to so many direction changes; `at` is told every place of it, in the world
/// and in the chart, with the changes so far and the direction, and says whether to go on.
template <class At>
void drive_out(const Case& asked, const snug::detail::sets::Chart& chart, Random& random, int deepest, const At& at) {
    constexpr double half_turn = 3.14159265358979323846;
    const auto& inside = std::get<snug::ParkedInside>(asked.place.parked());
    snug::Point middle{0, 0};
    for (const snug::Point& p : inside.corners) middle.x += p.x / 4, middle.y += p.y / 4;
    snug::Pose pose;
    bool parked = false;
    for (int attempt = 0; attempt < 60 && !parked; ++attempt) {
        pose.heading = inside.heading + random.between(-0.2, 0.2) * random.between(0.0, 1.0);
        const double back = (asked.car.front() - asked.car.rear()) / 2;
        pose.x = middle.x - back * std::cos(pose.heading) + random.between(-0.6, 0.6);
        pose.y = middle.y - back * std::sin(pose.heading) + random.between(-0.6, 0.6);
        parked = short_of_parked(asked.car, asked.place, pose) <= -1e-9 &&
                 depth_in_place(asked.car, asked.place, pose) < -1e-9 && outside_region(asked.place, pose) < -1e-9;
    }
    if (!parked) return;
    const double most = std::tan(asked.car.max_steer()) / asked.car.wheelbase();
    bool is_forward = random.chance(0.5);
    for (int k = 0; k <= deepest; ++k, is_forward = !is_forward) {
        // Pieces of steering until something is met, or the driver has had enough.
        bool go_on = true;
        for (int piece = random.whole(1, 4); piece > 0 && go_on; --piece) {
            const double curvature =
                random.chance(0.6) ? (random.chance(0.5) ? most : -most) : random.between(-most, most);
            for (int steps = random.whole(1, 150); steps > 0 && go_on; --steps) {
                const snug::Pose next = driven(pose, curvature, is_forward ? 0.02 : -0.02);
                snug::Pose in_chart = chart.to_chart(next);
                in_chart.heading = std::remainder(in_chart.heading, 2 * half_turn);
                go_on = depth_in_place(asked.car, asked.place, next) < -1e-9 &&
                        outside_region(asked.place, next) < -1e-9 &&
                        std::abs(in_chart.heading) < 79.9 * half_turn / 180;
                if (!go_on) break;
                pose = next;
                if (!at(pose, in_chart, k, is_forward)) return;
            }
        }
    }
}

/// Driven out at random, and where the car gets to is the start: it parks from there with as many changes, which are returned;
/// -1 where it gets nowhere. It stops where its heading is farther off than is covered from every start.
inline int start_where_driven(Case& asked, Random& random) {
    snug::detail::sets::Chart chart;
    static_cast<void>(snug::detail::sets::chart_place(asked.car, asked.place, asked.start, 0.0, chart));
    const double parked = std::get<snug::ParkedInside>(asked.place.parked()).heading;
    int changes = -1;
    drive_out(asked, chart, random, random.whole(1, 8), [&](const snug::Pose& pose, const snug::Pose&, int k, bool) {
        if (std::abs(std::remainder(pose.heading - parked, 6.283185307179586)) > 1.0) return false;
        asked.start = pose;
        changes = k;
        return true;
    });
    return changes;
}

}  // namespace park_test
