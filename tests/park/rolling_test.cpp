// Ways that steer only while the car rolls: integrated with the bicycle model in small steps they touch nothing and park.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/rolling.hpp"

namespace {

using namespace park_test;

constexpr double steering_rate = 0.5;

enum Kind { parallel, slanted, perpendicular };

struct RoomyCase : Case {
    Kind kind;
};

/// A street or a bay at least 0.6 m longer than the car, and its usual start.
RoomyCase roomy_case(std::uint64_t index) {
    Random random(index + 500000);
    const Car car = random_car(random);
    Street street = random_street(random, car);
    street.length = car.length() + random.between(0.6, 1.5);
    const Pose start = standard_start(street, car);
    const Kind kind = street.angle == 0.0 ? parallel : street.angle < 1.57 ? slanted : perpendicular;
    return {{car, street_place(street), start, described(car, street, start)}, kind};
}

/// What is wrong with a rolling maneuver; empty when nothing is. Curvatures are summed up from the sharpness alone, poses from
/// the curvatures in steps of 1 mm.
std::string verdict(const Case& asked, const snug::RollingManeuver& way, double creep, double curvature = 0.0,
                    bool parks = true) {
    std::ostringstream wrong;
    wrong.precision(17);
    Pose at = asked.start;
    const double fullest = std::tan(asked.car.max_steer()) / asked.car.wheelbase();
    for (std::size_t i = 0; i < way.pieces.size(); ++i) {
        const snug::RollingPiece& piece = way.pieces[i];
        if (std::abs(piece.curvature - curvature) > 1e-9) wrong << "the curvature jumps at piece " << i << "; ";
        if (std::abs(piece.sharpness) * asked.car.wheelbase() * creep > steering_rate * (1.0 + 1e-9))
            wrong << "piece " << i << " is too sharp; ";
        const double way_of = piece.direction == snug::Direction::forward ? 1.0 : -1.0;
        const int steps = 1 + static_cast<int>(piece.length / 1e-3);
        const double h = piece.length / steps;
        for (int k = 0; k < steps; ++k) {
            const double bend = curvature + piece.sharpness * h / 2.0;
            const double middle = at.heading + way_of * bend * h / 2.0;
            at = {at.x + way_of * h * std::cos(middle), at.y + way_of * h * std::sin(middle),
                  at.heading + way_of * bend * h};
            curvature += piece.sharpness * h;
            if (std::abs(curvature) > fullest * (1.0 + 1e-9)) wrong << "piece " << i << " turns too tightly; ";
            if (const double deep = depth_in_place(asked.car, asked.place, at); deep > 0.0)
                return wrong.str() + "piece " + std::to_string(i) + " touches something";
            if (outside_region(asked.place, at) > 1e-6) wrong << "piece " << i << " leaves the region; ";
        }
        if (std::hypot(at.x - piece.end.x, at.y - piece.end.y) > 1e-5 ||
            std::abs(at.heading - piece.end.heading) > 1e-9)
            wrong << "piece " << i << " does not end where it says; ";
        at = piece.end;
    }
    if (!parks) return wrong.str();
    if (const double by = short_of_parked(asked.car, asked.place, at); by > 1e-8) wrong << "not parked, by " << by;
    return wrong.str();
}

/// What is wrong with a way that may turn its steering at standstill: it is driven move by move.
std::string standing_verdict(const Case& asked, const snug::RollingManeuver& way, double creep) {
    std::string wrong;
    Case from = asked;
    std::vector<std::size_t> starts = {0};
    for (const snug::StandingSteer& steer : way.standing_steers())
        if (steer.piece > 0) starts.push_back(steer.piece);
    starts.push_back(way.pieces.size());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        const snug::RollingManeuver part = {
            way.car,
            {way.pieces.begin() + std::ptrdiff_t(starts[i]), way.pieces.begin() + std::ptrdiff_t(starts[i + 1])}};
        wrong += verdict(from, part, creep, part.pieces[0].curvature, i + 2 == starts.size());
        from.start = part.pieces.back().end;
    }
    return wrong;
}

/// In a soak 510 places, in two of which the usual start lies outside the region. SNUG_FIRST=I begins with the place I and SNUG_CASES=N ends after N. The table is that of docs/driving.md.
TEST(Rolling, ParksWithoutSteeringAtStandstillAndTouchesNothing) {
    const std::uint64_t first = snug::test::number("SNUG_FIRST", 0);
    const std::uint64_t last = first + snug::test::number("SNUG_CASES", std::uint64_t(snug::test::sample(6, 510, 3)));
    struct Row {
        int posed = 0, none = 0, stands = 0;
        std::array<int, 4> more = {};  // direction changes than with steering at standstill; 3: and more
        double changes = 0.0, standing_changes = 0.0;
    };
    std::array<Row, 3> rows;
    int most_work = 0;
    for (std::uint64_t i = first; i < last; ++i) {
        const RoomyCase asked = roomy_case(i);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        snug::RollingOptions options;
        options.steering_rate = steering_rate;
        if (outside_region(asked.place, asked.start) > 0.0) {
            EXPECT_THROW(park_rolling(asked.car, asked.place, asked.start, options), snug::Error);
            continue;
        }
        options.most_more = snug::test::sample(1, 6);
        options.most_work = snug::test::sample(300'000, options.most_work);
        const snug::RollingAnswer answer = park_rolling(asked.car, asked.place, asked.start, options);
        if (!answer.standing_changes) continue;
        Row& row = rows[asked.kind];
        ++row.posed;
        most_work = std::max(most_work, answer.work);
        if (!answer.maneuver) {
            ++row.none;
            ASSERT_TRUE(answer.standing);
            EXPECT_FALSE(answer.standing->standing_steers().empty());
            EXPECT_EQ(standing_verdict(asked, *answer.standing, answer.creep), "");
            continue;
        }
        EXPECT_FALSE(answer.standing);
        EXPECT_TRUE(answer.maneuver->standing_steers().empty());
        const int changes = answer.maneuver->direction_changes();
        EXPECT_EQ(verdict(asked, *answer.maneuver, answer.creep), "");
        EXPECT_GE(changes, answer.lower_bound);
        EXPECT_LE(changes, *answer.standing_changes + options.most_more);
        ++row.more[std::size_t(std::clamp(changes - *answer.standing_changes, 0, 3))];
        row.changes += changes;
        row.standing_changes += *answer.standing_changes;
    }
    // Beside the room for one count, what a last piece looks at when the work runs out.
    EXPECT_LE(most_work, 1'400'000);
    int found = 0, posed = 0;
    std::puts("places               with a way  as many  1 more  2 more  more  none found  changes: moving, standing");
    for (const Kind kind : {parallel, slanted, perpendicular}) {
        const Row& row = rows[kind];
        const int ways = row.posed - row.none;
        found += ways;
        posed += row.posed;
        std::printf("%-20s %10d %8d %7d %7d %5d %11d",
                    kind == parallel  ? "parallel"
                    : kind == slanted ? "slanted bays"
                                      : "perpendicular bays",
                    ways, row.more[0], row.more[1], row.more[2], row.more[3], row.none);
        if (ways > 0) std::printf("  %16.2f, %8.2f", row.changes / ways, row.standing_changes / ways);
        std::puts("");
    }
    if (posed >= 5) {  // of fewer the share says nothing
        EXPECT_GT(2 * found, posed);
    }
}

/// A way from wheels that are turned already, on a map made before, begins with them.
TEST(Rolling, BeginsWithTheWheelsAsTheyAre) {
    int found = 0;
    for (std::uint64_t i = 3; i < 3 + std::uint64_t(snug::test::sample(6, 60, 3)); ++i) {
        const RoomyCase asked = roomy_case(i);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        snug::ParkMapOptions how;
        how.heading = asked.start.heading;
        how.clearance = 0.01;
        const snug::ParkMap map(asked.car, asked.place, how);
        snug::RollingOptions options;
        options.most_work = 50'000;
        for (const double part : {-0.7, 0.3, 1.0}) {
            const double angle = part * asked.car.max_steer();
            const snug::RollingAnswer answer = park_rolling(map, asked.start, angle, options);
            if (!answer.maneuver || answer.maneuver->pieces.empty()) continue;
            ++found;
            const double bend = std::tan(angle) / asked.car.wheelbase();
            EXPECT_TRUE(answer.maneuver->standing_steers(bend).empty());
            EXPECT_EQ(verdict(asked, *answer.maneuver, answer.creep, bend), "");
        }
    }
    EXPECT_GT(found, 0);
}

/// The commands of a trajectory in steps of a millisecond: it follows the way to 1 mm, and the steering keeps its rate.
TEST(Rolling, TrajectoriesFollowTheWayAndKeepEveryLimit) {
    Random random(7);
    for (int i = 0; i < snug::test::sample(100, 2000); ++i) {
        SCOPED_TRACE(i);
        const Car car = random_car(random);
        snug::RollingManeuver way{car, {}};
        Pose at = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-3.0, 3.0)};
        const double fullest = 1.0 / car.turning_radius();
        double curvature = 0.0;
        for (int k = random.whole(1, 12); k > 0; --k) {
            snug::RollingPiece piece;
            piece.direction = random.chance(0.5) ? snug::Direction::forward : snug::Direction::backward;
            piece.length = random.between(0.01, 1.0);
            piece.curvature = curvature;
            if (random.chance(0.7)) piece.sharpness = (random.between(-fullest, fullest) - curvature) / piece.length;
            piece.start = at;
            at = piece.end = piece.at(piece.length);
            curvature = piece.curvature_at(piece.length);
            way.pieces.push_back(piece);
        }
        const snug::MotionLimits limits = {random.between(0.2, 3.0), random.between(0.2, 2.0), random.between(0.2, 2.0),
                                           random.between(0.2, 2.0)};
        const snug::Trajectory timed = rolling_trajectory(way, limits);
        EXPECT_EQ(timed.standing_steers, 0);
        EXPECT_NEAR(timed.points.back().distance, way.length(), 1e-9);
        Pose pose = way.pieces[0].start;
        double speed = 0.0, bend = 0.0;
        for (std::size_t k = 0; k + 1 < timed.points.size(); ++k) {
            const snug::TrajectoryPoint& now = timed.points[k];
            ASSERT_LT(std::hypot(pose.x - now.pose.x, pose.y - now.pose.y), 1e-3);
            ASSERT_NEAR(pose.heading, now.pose.heading, 1e-4);
            ASSERT_NEAR(speed, now.speed, 1e-6);
            ASSERT_NEAR(bend, now.curvature, 1e-6);
            const double sign = static_cast<double>(static_cast<int>(now.direction));
            EXPECT_LE(sign * now.acceleration, limits.acceleration);
            EXPECT_GE(sign * now.acceleration, -limits.deceleration);
            const double seconds = timed.points[k + 1].time - now.time;
            const int steps = 1 + static_cast<int>(seconds / 1e-3);
            const double h = seconds / steps;
            for (int j = 0; j < steps; ++j) {
                const double v = speed + now.acceleration * h / 2.0;
                const double ds = std::abs(v) * h;
                const double before = std::atan(bend * car.wheelbase());
                const double mid = bend + now.sharpness * ds / 2.0;
                pose.x += v * h * std::cos(pose.heading + v * h * mid / 2.0);
                pose.y += v * h * std::sin(pose.heading + v * h * mid / 2.0);
                pose.heading += v * h * mid;
                bend += now.sharpness * ds;
                speed += now.acceleration * h;
                ASSERT_LE(std::abs(speed), limits.speed * (1.0 + 1e-9));
                ASSERT_LE(std::abs(std::atan(bend * car.wheelbase()) - before) / h,
                          limits.steering_rate * (1.0 + 1e-6) + 1e-14 / h);
            }
        }
        EXPECT_LT(std::hypot(pose.x - at.x, pose.y - at.y), 1e-3);
        EXPECT_NEAR(speed, 0.0, 1e-6);
        double last = -1.0;
        for (const snug::TrajectoryPoint& point : sampled(timed, 0.05)) {
            EXPECT_LE(std::abs(point.steering_rate), limits.steering_rate * (1.0 + 1e-9));
            EXPECT_GT(point.time, last);
            last = point.time;
        }
    }
}

TEST(Rolling, WithImpossibleOptionsIsRefused) {
    const Case asked = roomy_case(5);
    for (const double bad : {0.0, -1.0, 1e9}) {
        snug::RollingOptions options;
        options.creep = bad;
        EXPECT_THROW((void)park_rolling(asked.car, asked.place, asked.start, options), snug::Error);
        options = {};
        options.steering_rate = bad;
        EXPECT_THROW((void)park_rolling(asked.car, asked.place, asked.start, options), snug::Error);
    }
}

}  // namespace
