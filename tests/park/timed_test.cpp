// Plans over time: integrated step by step with the bicycle model they follow the maneuver, touch nothing and park.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>

#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/park_map.hpp"
#include "snug/trajectory.hpp"

namespace {

using namespace park_test;

constexpr double room = 1e-3;  ///< that a plan keeps, and an integrated pose may be off it [m]

/// The plan that a map of the place has; nothing where it has none.
std::optional<snug::Maneuver> planned(const Case& asked) {
    snug::ParkMapOptions options;
    options.clearance = room;
    options.heading = asked.start.heading;
    try {
        return snug::ParkMap(asked.car, asked.place, options).maneuver(asked.start);
    } catch (const snug::Error&) {
        return std::nullopt;  // too large for a map
    }
}

/// In a soak 1,000 plans in random places. SNUG_FIRST=I begins with the place I and SNUG_CASES=N ends after N plans.
TEST(Timed, PlansDrivenByTheirCommandsTouchNothing) {
    const std::uint64_t wanted = snug::test::number("SNUG_CASES", std::uint64_t(snug::test::sample(30, 1000)));
    std::uint64_t plans = 0, i = snug::test::number("SNUG_FIRST", 0);
    double farthest = 0.0, seconds_in_all = 0.0;
    for (; plans < wanted; ++i) {
        const Case asked = random_case(i);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        const std::optional<snug::Maneuver> maneuver = planned(asked);
        if (!maneuver) continue;
        ++plans;
        Random random(i + 5000);
        const snug::MotionLimits limits = {random.between(0.2, 3.0), random.between(0.2, 2.0), random.between(0.2, 2.0),
                                           random.between(0.2, 2.0)};
        const snug::Trajectory timed = trajectory(*maneuver, limits);
        seconds_in_all += timed.seconds();
        // What a simulator makes of the commands alone.
        Pose at = asked.start;
        double speed = 0.0, steering = 0.0;
        for (std::size_t k = 0; k + 1 < timed.points.size(); ++k) {
            const snug::TrajectoryPoint& now = timed.points[k];
            const double off = std::hypot(at.x - now.pose.x, at.y - now.pose.y);
            farthest = std::max(farthest, off);
            ASSERT_LT(off, room);
            const double sign = static_cast<double>(static_cast<int>(now.direction));
            ASSERT_LE(sign * now.acceleration, limits.acceleration);
            ASSERT_GE(sign * now.acceleration, -limits.deceleration);
            ASSERT_LE(std::abs(now.steering_rate), limits.steering_rate);
            const double seconds = timed.points[k + 1].time - now.time;
            const int steps = 1 + static_cast<int>(seconds / 1e-3);
            const double h = seconds / steps;
            double since_looked = 1.0;
            for (int j = 0; j < steps; ++j) {
                const double v = speed + now.acceleration * h / 2.0;
                const double turn = v * h * std::tan(steering + now.steering_rate * h / 2.0) / asked.car.wheelbase();
                at = {at.x + v * h * std::cos(at.heading + turn / 2.0),
                      at.y + v * h * std::sin(at.heading + turn / 2.0), at.heading + turn};
                speed += now.acceleration * h;
                steering += now.steering_rate * h;
                ASSERT_LE(std::abs(speed), limits.speed * (1.0 + 1e-9));
                since_looked += std::abs(v) * h;
                if (since_looked < 0.005 && j + 1 < steps) continue;
                since_looked = 0.0;
                ASSERT_LE(depth_in_place(asked.car, asked.place, at), 0.0)
                    << "after " << now.time + (j + 1) * h << " s";
            }
        }
        const Pose& goal = maneuver->goal();
        EXPECT_LT(std::hypot(at.x - goal.x, at.y - goal.y), room);
        EXPECT_LT(short_of_parked(asked.car, asked.place, at), room);
        EXPECT_NEAR(speed, 0.0, 1e-9);
    }
    std::cout << plans << " plans among the places up to " << i << ", " << seconds_in_all << " s of driving; at most "
              << 1e3 * farthest << " mm off the maneuver\n";
}

}  // namespace
