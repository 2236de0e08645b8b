// Trajectories: driven step by step with the bicycle model they follow the maneuver, and they keep every limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "numbers.hpp"
#include "random_maneuvers.hpp"
#include "refusals.hpp"
#include "sample.hpp"
#include "snug/io.hpp"

namespace model {
namespace {

using snug::MotionLimits;
using snug::Trajectory;
using snug::TrajectoryPoint;

MotionLimits random_limits(Random& random) {
    return {random.between(0.2, 3.0), random.between(0.2, 2.0), random.between(0.2, 2.0), random.between(0.2, 2.0)};
}

/// What a simulator makes of the commands alone: speed, heading and position by small steps, with a constant acceleration and
/// steering rate until the next command.
struct Simulated {
    double x, y, heading, speed, steering, wheelbase;

    void go(double acceleration, double steering_rate, double seconds) {
        const int steps = std::max(1, static_cast<int>(std::ceil(seconds / 1e-3)));
        const double h = seconds / steps;
        for (int i = 0; i < steps; ++i) {
            const double v = speed + acceleration * h / 2.0;
            const double turn = v * std::tan(steering + steering_rate * h / 2.0) / wheelbase * h;
            x += v * h * std::cos(heading + turn / 2.0);
            y += v * h * std::sin(heading + turn / 2.0);
            heading += turn;
            speed += acceleration * h;
            steering += steering_rate * h;
        }
    }
};

TEST(Trajectory, IntegratedStepByStepDrivesTheManeuver) {
    Random random(1);
    for (int i = 0; i < snug::test::sample(100, 1000); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = random_maneuver(random);
        const double steering = random.between(-0.5, 0.5);
        const Trajectory timed = trajectory(maneuver, random_limits(random), steering);
        const snug::Pose start = maneuver.entry();
        Simulated car = {start.x, start.y, start.heading, 0.0, steering, maneuver.car.wheelbase()};
        for (std::size_t k = 0; k + 1 < timed.points.size(); ++k) {
            const TrajectoryPoint& now = timed.points[k];
            ASSERT_NEAR(car.x, now.pose.x, 1e-3);
            ASSERT_NEAR(car.y, now.pose.y, 1e-3);
            ASSERT_NEAR(car.heading, now.pose.heading, 1e-5);
            ASSERT_NEAR(car.speed, now.speed, 1e-9);
            ASSERT_NEAR(car.steering, now.steering_angle, 1e-9);
            ASSERT_NEAR(std::tan(car.steering) / car.wheelbase, now.curvature, 1e-8);
            car.go(now.acceleration, now.steering_rate, timed.points[k + 1].time - now.time);
        }
        const snug::Pose goal = maneuver.goal();
        EXPECT_NEAR(car.x, goal.x, 1e-3);
        EXPECT_NEAR(car.y, goal.y, 1e-3);
        EXPECT_NEAR(car.heading, goal.heading, 1e-5);
        EXPECT_NEAR(car.speed, 0.0, 1e-9);
        EXPECT_NEAR(timed.points.back().distance, maneuver.length(), 1e-9);
    }
}

TEST(Trajectory, KeepsEveryLimitAndSteersAtStandstillOnly) {
    Random random(2);
    for (int i = 0; i < snug::test::sample(100, 1000); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = random_maneuver(random);
        const MotionLimits limits = random_limits(random);
        const Trajectory timed = trajectory(maneuver, limits);
        const std::vector<TrajectoryPoint> all = sampled(timed, random.between(0.01, 0.5));
        double before = -1.0;
        for (const TrajectoryPoint& point : all) {
            const double sign = static_cast<double>(static_cast<int>(point.direction));
            EXPECT_GT(point.time, before);
            before = point.time;
            EXPECT_GE(sign * point.speed, -1e-12);
            EXPECT_LE(std::abs(point.speed), limits.speed * (1.0 + 1e-12));
            EXPECT_LE(sign * point.acceleration, limits.acceleration);
            EXPECT_GE(sign * point.acceleration, -limits.deceleration);
            EXPECT_LE(std::abs(point.steering_rate), limits.steering_rate);
            if (point.steering_rate != 0.0) {
                EXPECT_EQ(point.speed, 0.0);
                EXPECT_EQ(point.acceleration, 0.0);
            }
        }
        EXPECT_EQ(all.back().time, timed.seconds());
    }
}

TEST(Trajectory, StaysOnTheManeuverBetweenItsPointsToo) {
    Random random(3);
    for (int i = 0; i < snug::test::sample(100, 1000); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = random_maneuver(random);
        const Trajectory timed = trajectory(maneuver);
        double before = 0.0;
        std::size_t move = 0;
        for (const TrajectoryPoint& point : sampled(timed, 0.07)) {
            const auto& moves = maneuver.moves;
            while (move + 1 < moves.size() && point.distance > before + moves[move].length + 1e-9)
                before += moves[move++].length;
            const snug::Move& on = moves[move];
            const snug::Pose pose =
                drive(maneuver.car, on.start, on.direction, on.steering_angle, std::max(0.0, point.distance - before));
            EXPECT_NEAR(pose.x, point.pose.x, 1e-9);
            EXPECT_NEAR(pose.y, point.pose.y, 1e-9);
            EXPECT_NEAR(pose.heading, point.pose.heading, 1e-9);
        }
    }
}

/// The least time for one piece by dynamic programming over a fine grid of squared speeds: forward as fast as acceleration
/// allows, backward as fast as braking allows, the lesser of both, and time by the trapezoid of 1/v.
double plain_seconds(double length, const MotionLimits& limits) {
    constexpr int steps = 200000;
    const double h = length / steps;
    double seconds = 0.0;
    double last = 0.0;
    for (int i = 1; i <= steps; ++i) {
        const double s = i * h;
        const double speed = std::sqrt(std::min({limits.speed * limits.speed, 2.0 * limits.acceleration * s,
                                                 2.0 * limits.deceleration * std::max(0.0, length - s)}));
        seconds += 2.0 * h / (last + speed);
        last = speed;
    }
    return seconds;
}

TEST(Trajectory, IsAsQuickAsAPlainSearchOverSpeeds) {
    Random random(4);
    for (int i = 0; i < snug::test::sample(50, 500); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = random_maneuver(random);
        const MotionLimits limits = random_limits(random);
        double seconds = 0.0;
        double steering = 0.0;
        double piece = 0.0;
        const snug::Move* last = nullptr;
        const auto stop = [&] {
            if (piece > 0.0) seconds += plain_seconds(piece, limits);
            piece = 0.0;
        };
        for (const snug::Move& move : maneuver.moves) {
            if (move.length == 0.0) continue;
            if (last == nullptr || last->direction != move.direction || last->steering_angle != move.steering_angle)
                stop();
            seconds += std::abs(move.steering_angle - steering) / limits.steering_rate;
            steering = move.steering_angle;
            piece += move.length;
            last = &move;
        }
        stop();
        EXPECT_NEAR(trajectory(maneuver, limits).seconds(), seconds, 1e-3 * seconds);
    }
}

TEST(Trajectory, OfWhatDoesNotMoveTakesNoTime) {
    const snug::Car car = *snug::find_car("renault-zoe");
    EXPECT_TRUE(snug::trajectory({car, {}}).points.empty());
    EXPECT_TRUE(snug::sampled(snug::trajectory({car, {}}), 0.1).empty());
    snug::Move standing;
    standing.start = standing.end = {1.0, 2.0, 3.0};
    standing.steering_angle = 0.3;
    const Trajectory stays = snug::trajectory({car, {standing}});
    EXPECT_EQ(stays.seconds(), 0.0);
    EXPECT_EQ(stays.at(7.0).pose, standing.start);
    EXPECT_EQ(snug::sampled(stays, 0.1).size(), 1U);
}

TEST(Trajectory, WithImpossibleLimitsIsRefused) {
    Random random(5);
    const snug::Maneuver maneuver = random_maneuver(random);
    for (const double bad : {0.0, -1.0, 1e-4, 1e4, nan}) {
        EXPECT_EQ(refusal([&] { (void)trajectory(maneuver, {.speed = bad}); }).find("greatest speed is "), 0U);
        EXPECT_EQ(refusal([&] { (void)trajectory(maneuver, {.acceleration = bad}); }).find("acceleration is "), 0U);
        EXPECT_EQ(refusal([&] { (void)trajectory(maneuver, {.deceleration = bad}); }).find("deceleration is "), 0U);
        EXPECT_EQ(refusal([&] { (void)trajectory(maneuver, {.steering_rate = bad}); }).find("steering rate is "), 0U);
    }
    for (const double bad : {nan, 2.0, -2.0})
        EXPECT_NE(refusal([&] { (void)trajectory(maneuver, {}, bad); }).find("steering angle at the start"),
                  std::string::npos);
    const Trajectory timed = trajectory(maneuver);
    for (const double bad : {0.0, -1.0, 1e-7, nan})
        EXPECT_EQ(refusal([&] { (void)sampled(timed, bad); }).find("period of a trajectory is "), 0U);
    snug::Maneuver far = maneuver;
    far.moves.front().length = 1e5;
    EXPECT_NE(refusal([&] { (void)sampled(trajectory(far), 1e-6); }).find("take a longer period"), std::string::npos);
}

TEST(Trajectory, ReadsBackFromJsonAndCsvAsTheSameNumbers) {
    Random random(6);
    for (int i = 0; i < snug::test::sample(20, 500); ++i) {
        SCOPED_TRACE(i);
        const Trajectory timed = trajectory(random_maneuver(random), random_limits(random));
        const double period = random.between(0.05, 2.0);
        const std::vector<TrajectoryPoint> all = sampled(timed, period);
        const snug::Json json = snug::Json::parse(snug::write(as_json(timed, period)));
        EXPECT_EQ(json["seconds"].get<double>(), timed.seconds());
        EXPECT_EQ(json["standing_steers"].get<int>(), timed.standing_steers);
        ASSERT_EQ(json["trajectory"].size(), all.size());
        std::istringstream csv(as_csv(timed, period));
        std::string line;
        std::getline(csv, line);
        EXPECT_EQ(line,
                  "time,x,y,heading,direction,speed,acceleration,steering_angle,steering_rate,curvature,distance");
        for (std::size_t k = 0; k < all.size(); ++k) {
            const TrajectoryPoint& one = all[k];
            const double values[] = {one.time,
                                     one.pose.x,
                                     one.pose.y,
                                     one.pose.heading,
                                     static_cast<double>(one.direction),
                                     one.speed,
                                     one.acceleration,
                                     one.steering_angle,
                                     one.steering_rate,
                                     one.curvature,
                                     one.distance};
            const char* names[] = {
                "time",          "x",         "y",       "heading", "", "speed", "acceleration", "steering_angle",
                "steering_rate", "curvature", "distance"};
            ASSERT_TRUE(std::getline(csv, line));
            std::istringstream cells(line);
            std::string cell;
            for (std::size_t c = 0; c < std::size(values); ++c) {
                ASSERT_TRUE(std::getline(cells, cell, ','));
                EXPECT_EQ(std::stod(cell), values[c]) << line;
                if (c != 4) {
                    EXPECT_EQ(json["trajectory"][k][names[c]].get<double>(), values[c]);
                }
            }
        }
    }
}

}  // namespace
}  // namespace model
