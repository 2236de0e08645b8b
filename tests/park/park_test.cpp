// Maneuvers of `park` are what they say they are.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "park/drive_out.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/park.hpp"

namespace {

using namespace park_test;

TEST(Park, EveryManeuverParksWithoutTouchingAnything) {
    const int count = snug::test::sample(30, 2000);
    int found = 0, proved = 0, refused = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        snug::ParkOptions options;
        options.resolution = snug::test::is_set("SNUG_SMALL") ? 0.08 : 0.04;
        options.max_changes = 12;
        if (depth_in_place(asked.car, asked.place, asked.start) > -1e-6 ||
            outside_region(asked.place, asked.start) > 0) {
            EXPECT_THROW(park(asked.car, asked.place, asked.start, options), snug::Error);
            ++refused;
            continue;
        }
        const snug::ParkAnswer answer = park(asked.car, asked.place, asked.start, options);
        proved += answer.proved;
        if (!answer.maneuver) continue;
        ++found;
        EXPECT_EQ(verdict(asked.car, asked.place, asked.start, answer), "");
        EXPECT_GE(*answer.direction_changes, answer.lower_bound);
    }
    RecordProperty("found", found);
    std::printf("%d of %d found, %d proved, %d starts refused\n", found, count, proved, refused);
    EXPECT_GE(found, count / 3);
}

/// The maneuver a person is given, and the other ways beside it.
TEST(Park, PolishedManeuversAndAlternativesParkWithoutTouchingAnything) {
    const int count = snug::test::sample(16, 1000);
    int found = 0, others = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(600000 + static_cast<std::uint64_t>(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        if (depth_in_place(asked.car, asked.place, asked.start) > -1e-6 || outside_region(asked.place, asked.start) > 0)
            continue;
        snug::ParkOptions options;
        options.resolution = 0.04;
        options.max_changes = 8;
        snug::ParkAnswer answer = park(asked.car, asked.place, asked.start, options);
        if (!answer.maneuver) continue;
        ++found;
        EXPECT_EQ(verdict(asked.car, asked.place, asked.start, answer), "");
        EXPECT_EQ(answer.stops.size(), asked.place.obstacles().empty() ? 0U : answer.maneuver->moves.size());
        int before = *answer.direction_changes;
        for (const snug::Maneuver& other : std::vector<snug::Maneuver>(answer.alternatives)) {
            ++others;
            EXPECT_GT(other.direction_changes(), before);
            before = other.direction_changes();
            answer.maneuver = other;
            answer.direction_changes = before;
            EXPECT_EQ(verdict(asked.car, asked.place, asked.start, answer), "");
        }
    }
    std::printf("%d of %d found, %d other ways\n", found, count, others);
    EXPECT_GE(found, count / 3);
}

/// In nearly all places the bounds meet; those where they do not are listed. SNUG_FIRST and SNUG_CASES choose some of them.
TEST(Park, BoundsMeetInNearlyAllRandomPlaces) {
    const int first = static_cast<int>(snug::test::number("SNUG_FIRST", 0));
    const int count =
        static_cast<int>(snug::test::number("SNUG_CASES", static_cast<std::uint64_t>(snug::test::sample(8, 2000))));
    int asked_about = 0, met = 0, impossible = 0;
    for (int i = first; i < first + count; ++i) {
        const Case asked = random_case(800000 + static_cast<std::uint64_t>(i));
        if (depth_in_place(asked.car, asked.place, asked.start) > -1e-6 || outside_region(asked.place, asked.start) > 0)
            continue;
        snug::ParkOptions options;
        options.roomiest = false;
        options.max_changes = 30;
        const snug::ParkAnswer answer = park(asked.car, asked.place, asked.start, options);
        ++asked_about;
        met += answer.proved;
        impossible += answer.impossible;
        if (!answer.proved)
            std::printf("open: case %d, %d to %d: %s\n", i, answer.lower_bound, answer.direction_changes.value_or(-1),
                        asked.described.c_str());
        std::fflush(stdout);
    }
    std::printf("%d of %d proved, %d of them impossible\n", met, asked_about, impossible);
    EXPECT_GE(met, (count >= 500 ? 0.95 : 0.5) * asked_about);
}

/// Driven out of the slot at random and back the same way, a car parks with the changes it took: the lower bound may not be more,
/// on however fine a lattice it was found.
TEST(Park, NoRealManeuverBeatsTheLowerBound) {
    const int count = snug::test::sample(200, 20000);
    int asked_about = 0, just_met = 0;
    for (int i = 0; i < count; ++i) {
        Case asked = random_case(5'000'000 + static_cast<std::uint64_t>(i));
        Random random(9'000'000 + static_cast<std::uint64_t>(i));
        const int changes = start_where_driven(asked, random);
        if (changes < 0) continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        snug::ParkOptions options;
        options.roomiest = false;
        options.max_changes = changes;
        const snug::ParkAnswer answer = park(asked.car, asked.place, asked.start, options);
        ++asked_about;
        just_met += answer.lower_bound == changes;
        EXPECT_FALSE(answer.impossible);
        EXPECT_LE(answer.lower_bound, changes);
    }
    std::printf("%d asked, %d of the bounds are just met\n", asked_about, just_met);
    EXPECT_GT(just_met, 0);
}

/// To be anywhere in the region, or in a place larger than any slot, is a goal as any other.
TEST(Park, AGoalMayBeOfAnySize) {
    const snug::Car car({.width = 1.8, .front = 3.7, .rear = 1.0, .wheelbase = 2.7, .max_steer = 0.6});
    for (const double size : {20.0, 150.0, 3e6, 1e8}) {
        SCOPED_TRACE(size);
        snug::ParkedInside inside;
        inside.corners = {{3, -2}, {3 + size, -2}, {3 + size, size}, {3, size}};
        const Place place({{{{{-80, -2}, {80, -2}, {80, -90}, {-80, -90}}, false, "curb", {}}},
                           inside,
                           {{-15, -15}, {15, -15}, {15, 15}, {-15, 15}}});
        const snug::ParkAnswer answer = park(car, place, {-5, 5, 0.1});
        EXPECT_EQ(answer.direction_changes, 0);
        EXPECT_TRUE(answer.proved);
    }
}

/// A car that stands parked has nothing to do, wherever and however aslant it stands.
TEST(Park, ACarThatStandsParkedStays) {
    const int count = snug::test::sample(20, 1000);
    int parked = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(620000 + static_cast<std::uint64_t>(i));
        Random random(630000 + static_cast<std::uint64_t>(i));
        const auto& inside = std::get<snug::ParkedInside>(asked.place.parked());
        Pose pose = {0.0, 0.0, inside.heading + random.between(-0.05, 0.05)};
        const double back = (asked.car.front() - asked.car.rear()) / 2;
        for (const Point& corner : inside.corners) {
            pose.x += corner.x / 4;
            pose.y += corner.y / 4;
        }
        pose.x += random.between(-0.1, 0.1) - back * std::cos(pose.heading);
        pose.y += random.between(-0.1, 0.1) - back * std::sin(pose.heading);
        if (depth_in_place(asked.car, asked.place, pose) > -1e-6 || outside_region(asked.place, pose) > 0 ||
            short_of_parked(asked.car, asked.place, pose) > -1e-6)
            continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        ++parked;
        const snug::ParkAnswer answer = park(asked.car, asked.place, pose);
        EXPECT_EQ(answer.direction_changes, 0);
        EXPECT_TRUE(answer.proved);
        ASSERT_TRUE(answer.maneuver);
        EXPECT_TRUE(answer.maneuver->moves.empty());
    }
    EXPECT_GT(parked, count / 10);
}

}  // namespace
