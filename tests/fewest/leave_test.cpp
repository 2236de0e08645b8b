// Getting out, and how short a slot may be, over all maneuvers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace {

using snug::Answer;
using snug::Car;
using snug::FewestOptions;
using snug::Pose;
using snug::Slot;

TEST(Leave, FromTheGoalOfAnOptimalManeuverItTakesNoMoreChanges) {
    int asked_for = 0;
    for (std::uint64_t i = 0; asked_for < snug::test::sample(8, 500); ++i) {
        const oracle::Case asked = oracle::random_case(23, i);
        const Car car(asked.car);
        const Slot slot(asked.slot);
        FewestOptions options;
        options.max_changes = 15;
        options.driving = asked.driving;
        options.resolution = 1e-3 * asked.car_length();
        const Answer best = fewest(car, slot, options);
        if (!best.direction_changes || std::abs(slot.to_slot(best.maneuver->goal()).heading) > 1.2) continue;
        ++asked_for;
        SCOPED_TRACE(oracle::command_line(asked));
        const Answer out = leave(car, slot, best.maneuver->goal(), options);
        EXPECT_LE(out.lower_bound, *best.direction_changes);
        if (!out.direction_changes) continue;
        EXPECT_GE(*out.direction_changes, best.lower_bound);
        const snug::Maneuver& maneuver = *out.maneuver;
        EXPECT_EQ(maneuver.direction_changes(), *out.direction_changes);
        EXPECT_NEAR(maneuver.entry().x, best.maneuver->goal().x, 1e-8 * asked.car_length());
        EXPECT_NEAR(maneuver.entry().y, best.maneuver->goal().y, 1e-8 * asked.car_length());
        const auto problem = oracle::make_problem<double>(asked);
        for (const snug::Move& move : maneuver.moves) {
            const auto path = oracle::path_of(asked.slot, asked.car, move);
            EXPECT_TRUE(oracle::is_free(problem, path, move.length, 1e-8 * asked.car_length()));
        }
    }
}

TEST(Leave, ParkedWithRoomItTakesFewChanges) {
    const Car zoe = *snug::find_car("renault-zoe");
    const Slot slot({.length = 5.0, .width = 2.0});
    const Answer out = leave(zoe, slot, parked_pose(zoe, slot, {.front = 0.3, .curb = 0.1}));
    EXPECT_EQ(out.direction_changes, 5);
    EXPECT_TRUE(out.proved);
}

TEST(Leave, FlushWithTheCurbThereIsNoWayOut) {
    const Car zoe = *snug::find_car("renault-zoe");
    const Slot slot({.length = 5.0, .width = 2.0, .corner = {3.0, -7.0}, .heading = 0.7});
    const Answer flush = leave(zoe, slot, parked_pose(zoe, slot, {.front = 0.3, .curb = 0.0}));
    EXPECT_FALSE(flush.direction_changes);
    EXPECT_TRUE(flush.proved);
    const Answer nearly = leave(zoe, slot, parked_pose(zoe, slot, {.front = 0.3, .curb = 0.01}));
    EXPECT_TRUE(nearly.direction_changes);
}

TEST(Leave, GapsSayWhereTheCarStands) {
    const Car zoe = *snug::find_car("renault-zoe");
    const Slot slot({.length = 5.0, .width = 2.0, .side = snug::Side::left, .corner = {3.0, 4.0}, .heading = 0.7});
    for (const double heading : {0.0, 0.02, -0.02}) {
        const Pose pose = slot.to_slot(parked_pose(zoe, slot, {.front = 0.3, .curb = 0.05, .heading = heading}));
        EXPECT_NEAR(pose.heading, heading, 1e-12);
        double foremost = -1e9, lowest = 1e9;
        for (const snug::Point& corner : frame(zoe, pose)) {
            foremost = std::max(foremost, corner.x);
            lowest = std::min(lowest, corner.y);
        }
        EXPECT_NEAR(foremost, -0.3, 1e-12);
        EXPECT_NEAR(lowest, -1.95, 1e-12);
    }
}

TEST(Leave, ACarThatIsNotParkedIsRefused) {
    const Car zoe = *snug::find_car("renault-zoe");
    const Slot slot({.length = 5.0, .width = 2.0});
    EXPECT_THROW(leave(zoe, slot, Pose{0.0, 0.0, 0.0}), snug::Error);
    EXPECT_THROW(leave(zoe, slot, parked_pose(zoe, slot, {.front = 2.0, .curb = 0.1})), snug::Error);
    EXPECT_THROW(leave(zoe, slot, Pose{-3.8, -1.0, 3.14159}), snug::Error);
    EXPECT_THROW(leave(zoe, slot, Pose{std::nan(""), -1.0, 0.0}), snug::Error);
    FewestOptions careful;
    careful.driving.clearance = 0.2;
    EXPECT_THROW(leave(zoe, slot, parked_pose(zoe, slot, {.front = 0.3, .curb = 0.1}), careful), snug::Error);
}

TEST(MinLength, IsDemonstratedAboveAndImpossibleBelow) {
    const Car zoe = *snug::find_car("renault-zoe");
    double last_length = 1e9;
    for (const int changes : {0, 2, 4}) {
        snug::MinSlotOptions options;
        options.strategy = snug::Strategy::fewest;
        options.max_changes = changes;
        options.resolution = 4e-3;
        const snug::MinSlot found = min_slot(zoe, 1.9, options);
        ASSERT_TRUE(found.length);
        EXPECT_LT(found.lower, *found.length);
        EXPECT_LT(*found.length - found.lower, 0.03);
        EXPECT_LT(*found.length, last_length);
        last_length = *found.length;
        const snug::MinSlot full_steering = min_slot(zoe, 1.9, {.max_changes = changes});
        EXPECT_LE(*found.length, *full_steering.length);
        EXPECT_GE(*full_steering.length, found.lower);
        FewestOptions there;
        there.max_changes = changes;
        const Answer parks = fewest(zoe, Slot({.length = *found.length + 1e-9, .width = 1.9}), there);
        EXPECT_TRUE(parks.direction_changes);
    }
}

TEST(MinLength, IsEmptyWhereTheCarIsTooWide) {
    const snug::MinSlot found = min_slot(*snug::find_car("renault-zoe"), 1.7, {.strategy = snug::Strategy::fewest});
    EXPECT_FALSE(found.length);
}

}  // namespace
