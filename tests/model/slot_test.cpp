// Slots: which can exist, and the slot frame.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numbers.hpp"
#include "random_maneuvers.hpp"
#include "refusals.hpp"
#include "sample.hpp"

namespace model {
namespace {

snug::SlotDimensions default_slot() { return {5.1, 2.2, snug::Side::right, {0.0, 0.0}, 0.0}; }

TEST(Slot, HasTheDimensionsItWasGiven) {
    const snug::Slot slot({5.1, 2.2, snug::Side::left, {3.0, 4.0}, 0.5});
    EXPECT_EQ(slot.length(), 5.1);
    EXPECT_EQ(slot.width(), 2.2);
    EXPECT_EQ(slot.side(), snug::Side::left);
    EXPECT_EQ(slot.corner().x, 3.0);
    EXPECT_EQ(slot.corner().y, 4.0);
    EXPECT_EQ(slot.heading(), 0.5);
}

TEST(Slot, OfImpossibleDimensionsIsRefusedByName) {
    for (const double bad : {0.0, -5.1, 0.99e-6, 1.01e6, nan, infinity, -infinity}) {
        snug::SlotDimensions dimensions = default_slot();
        dimensions.length = bad;
        EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }).find("slot length is "), 0U) << bad;
        dimensions = default_slot();
        dimensions.width = bad;
        EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }).find("slot width is "), 0U) << bad;
    }
    for (const double bad : {1.01e9, -1.01e9, nan, infinity, -infinity}) {
        snug::SlotDimensions dimensions = default_slot();
        dimensions.corner.x = bad;
        EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }).find("slot corner x is "), 0U) << bad;
        dimensions = default_slot();
        dimensions.corner.y = bad;
        EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }).find("slot corner y is "), 0U) << bad;
        dimensions = default_slot();
        dimensions.heading = bad;
        EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }).find("slot heading is "), 0U) << bad;
    }
}

TEST(Slot, RefusalQuotesTheValue) {
    snug::SlotDimensions dimensions = default_slot();
    dimensions.length = nan;
    EXPECT_EQ(refusal([&] { snug::Slot{dimensions}; }),
              "slot length is nan m, but must lie between 1e-06 and 1000000 m");
}

TEST(Slot, AtTheVeryLimitsExists) {
    EXPECT_NO_THROW(snug::Slot({1e-6, 1e-6, snug::Side::right, {-1e9, 1e9}, 1e9}));
    EXPECT_NO_THROW(snug::Slot({1e6, 1e6, snug::Side::left, {1e9, -1e9}, -1e9}));
}

TEST(Slot, InTheDefaultWorldIsItsOwnFrame) {
    const snug::Slot slot(default_slot());
    const snug::Pose pose = slot.to_world(snug::Pose{-4.0, -1.0, 0.3});
    EXPECT_EQ(pose.x, -4.0);
    EXPECT_EQ(pose.y, -1.0);
    EXPECT_EQ(pose.heading, 0.3);
}

TEST(Slot, LiesBehindItsCornerOnTheSideOfTheRoadItIsOn) {
    Random random(1);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Slot slot = random_slot(random);
        const snug::Point deep = slot.to_world(snug::Point{-slot.length(), -slot.width()});
        const double dx = deep.x - slot.corner().x;
        const double dy = deep.y - slot.corner().y;
        const double ahead = dx * std::cos(slot.heading()) + dy * std::sin(slot.heading());
        const double left = dy * std::cos(slot.heading()) - dx * std::sin(slot.heading());
        EXPECT_NEAR(ahead, -slot.length(), 1e-12);
        EXPECT_NEAR(left, slot.side() == snug::Side::left ? slot.width() : -slot.width(), 1e-12);
    }
}

TEST(Slot, FrameAndWorldRoundTrip) {
    Random random(2);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Slot slot = random_slot(random);
        const snug::Pose pose = random_pose(random);
        const snug::Pose there_and_back = slot.to_slot(slot.to_world(pose));
        const snug::Pose back_and_there = slot.to_world(slot.to_slot(pose));
        for (const snug::Pose& again : {there_and_back, back_and_there}) {
            EXPECT_NEAR(again.x, pose.x, 1e-13 * 50);
            EXPECT_NEAR(again.y, pose.y, 1e-13 * 50);
            EXPECT_NEAR(again.heading, pose.heading, 1e-14);
        }
        const snug::Point point = slot.to_slot(slot.to_world(snug::Point{pose.x, pose.y}));
        EXPECT_NEAR(point.x, pose.x, 1e-13 * 50);
        EXPECT_NEAR(point.y, pose.y, 1e-13 * 50);
    }
}

TEST(Slot, DrivingInTheFrameIsDrivingInTheWorldWithMirroredSteering) {
    Random random(3);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Slot slot = random_slot(random);
        const snug::Car car = random_car(random);
        const snug::Pose start = random_pose(random);
        const auto direction = random.chance(0.5) ? snug::Direction::forward : snug::Direction::backward;
        const double steering = random_steering(random, car);
        const double distance = random.between(0.0, 10.0);
        const snug::Pose driven_in_slot = slot.to_world(drive(car, start, direction, steering, distance));
        const snug::Pose driven_in_world =
            drive(car, slot.to_world(start), direction, slot.mirrored(steering), distance);
        EXPECT_NEAR(driven_in_slot.x, driven_in_world.x, 1e-12);
        EXPECT_NEAR(driven_in_slot.y, driven_in_world.y, 1e-12);
        EXPECT_NEAR(driven_in_slot.heading, driven_in_world.heading, 1e-13);
    }
}

}  // namespace
}  // namespace model
