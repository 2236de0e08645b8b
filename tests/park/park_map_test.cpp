// What a map says of poses: never beaten by real maneuvers, in accord with park() and fewest(), and its maneuvers are right.
#include "snug/park_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "park/drive_out.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/fewest.hpp"
#include "snug/park.hpp"

namespace {

using namespace park_test;
using snug::MapBounds;
using snug::ParkMap;
using snug::ParkMapOptions;

constexpr double half_turn = 3.14159265358979323846;

/// Around where the car starts and the slot.
Pose random_pose(Random& random, const Case& asked) {
    Pose pose = asked.start;
    pose.x += random.between(-4.0, 4.0);
    pose.y += random.between(-4.0, 4.0);
    pose.heading += random.between(-1.0, 1.0) * random.between(0.0, 1.0);
    return pose;
}

std::string spelled(const Pose& pose) {
    std::ostringstream text;
    text.precision(17);
    text << "at " << pose.x << " " << pose.y << " " << pose.heading;
    return text.str();
}

ParkMapOptions with_heading(double heading, double spacing) {
    ParkMapOptions options;
    options.heading = heading;
    options.spacing = spacing;
    options.max_changes = 12;
    return options;
}

TEST(ParkMap, NoRandomManeuverBeatsItsLowerBounds) {
    const int count = snug::test::sample(16, 400);
    const int maneuvers = snug::test::sample(200, 4000);
    long long states = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i) + 2000000);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(static_cast<std::uint64_t>(i) + 2100000);
        const double spacing = asked.car.turning_radius() / (random.chance(0.5) ? 32.0 : 80.0);
        const ParkMap map(asked.car, asked.place, with_heading(asked.start.heading, spacing));
        snug::detail::sets::Chart chart;
        static_cast<void>(snug::detail::sets::chart_place(asked.car, asked.place, asked.start, 0.0, chart));
        ASSERT_NEAR(std::remainder(chart.turned - map.middle_heading(), 2 * half_turn), 0.0, 1e-12);
        for (int n = 0; n < maneuvers; ++n) {
            drive_out(asked, chart, random, 5, [&](const Pose& pose, const Pose&, int k, bool) {
                ++states;
                const MapBounds bounds = map.at(pose);
                EXPECT_EQ(bounds.where, MapBounds::free) << spelled(pose);
                EXPECT_LE(bounds.lower_bound, k) << "maneuver " << n << ", " << spelled(pose);
                EXPECT_FALSE(bounds.impossible) << "maneuver " << n << ", " << spelled(pose);
                if (bounds.direction_changes) {
                    EXPECT_LE(bounds.lower_bound, *bounds.direction_changes) << spelled(pose);
                }
                return !testing::Test::HasFailure();
            });
            if (HasFailure()) return;
        }
    }
    std::printf("%lld states\n", states);
    EXPECT_GT(states, count * 1000);
}

TEST(ParkMap, ManeuversParkWithoutTouchingAnythingAndWithAsManyChangesAsSaid) {
    const int count = snug::test::sample(24, 1000);
    int found = 0, exact = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i) + 2200000);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(static_cast<std::uint64_t>(i) + 2300000);
        const ParkMap map(asked.car, asked.place, with_heading(asked.start.heading, 0.0));
        for (int n = 0; n < 60; ++n) {
            const Pose pose = random_pose(random, asked);
            const MapBounds bounds = map.at(pose);
            if (bounds.where == MapBounds::outside) continue;
            // What it says of where the car is, by separating axes.
            const double deep = depth_in_place(asked.car, asked.place, pose);
            if (std::abs(deep) > 1e-8) {
                EXPECT_EQ(bounds.where == MapBounds::blocked, deep > 0.0) << spelled(pose);
            }
            if (!bounds.direction_changes) continue;
            EXPECT_GE(*bounds.direction_changes, bounds.lower_bound) << spelled(pose);
            if (!bounds.first) {
                EXPECT_LE(short_of_parked(asked.car, asked.place, pose), 1e-8) << spelled(pose);
                continue;
            }
            const std::optional<snug::Maneuver> maneuver = map.maneuver(pose);
            ASSERT_TRUE(maneuver.has_value()) << spelled(pose);
            ++found;
            snug::ParkAnswer answer;
            answer.maneuver = maneuver;
            answer.direction_changes = maneuver->direction_changes();
            EXPECT_LE(*answer.direction_changes, *bounds.direction_changes) << spelled(pose);
            exact += *answer.direction_changes == bounds.lower_bound;
            EXPECT_EQ(maneuver->moves.front().direction, *bounds.first) << spelled(pose);
            EXPECT_EQ(verdict(asked.car, asked.place, pose, answer), "") << spelled(pose);
        }
        if (HasFailure()) return;
    }
    std::printf("%d maneuvers, %d with the fewest changes\n", found, exact);
    EXPECT_GT(found, 5 * count);
}

TEST(ParkMap, WhatItSaysFirstOfOnePoseIsWhatItSaysInTheEndAndOfOthersNothingWrong) {
    const int count = snug::test::sample(24, 600);
    int fewer_levels = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i) + 2650000);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(static_cast<std::uint64_t>(i) + 2660000);
        ParkMapOptions options = with_heading(asked.start.heading, asked.car.turning_radius() / 32.0);
        const ParkMap whole(asked.car, asked.place, options);
        for (int n = 0; n < 4; ++n) {
            const Pose pose = random_pose(random, asked);
            int told = 0;
            options.first = {pose, [&](const ParkMap& so_far) {
                                 ++told;
                                 EXPECT_EQ(so_far.at(pose), whole.at(pose)) << spelled(pose);
                                 EXPECT_EQ(so_far.maneuver(pose), whole.maneuver(pose)) << spelled(pose);
                                 fewer_levels += so_far.bytes() < whole.bytes();
                                 for (int m = 0; m < 200; ++m) {
                                     const Pose other = random_pose(random, asked);
                                     const MapBounds some = so_far.at(other), all = whole.at(other);
                                     EXPECT_EQ(some.where, all.where) << spelled(other);
                                     EXPECT_LE(some.lower_bound, all.lower_bound) << spelled(other);
                                     EXPECT_LE(some.impossible, all.impossible) << spelled(other);
                                     if (some.direction_changes) {
                                         EXPECT_EQ(some.direction_changes, all.direction_changes) << spelled(other);
                                     }
                                 }
                             }};
            const ParkMap map(asked.car, asked.place, options);
            EXPECT_EQ(told, 1);
            EXPECT_EQ(map.bytes(), whole.bytes());
            for (int m = 0; m < 200; ++m) {
                const Pose other = random_pose(random, asked);
                EXPECT_EQ(map.at(other), whole.at(other)) << spelled(other);
            }
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(fewer_levels, count);
}

TEST(ParkMap, PackedAndUnpackedItSaysTheSame) {
    const int count = snug::test::sample(12, 200);
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i) + 2400000);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(static_cast<std::uint64_t>(i) + 2500000);
        const snug::ParkMapOptions options = with_heading(asked.start.heading, 0.0);
        const ParkMap map(asked.car, asked.place, options);
        std::vector<std::byte> bytes = map.packed();
        const ParkMap again = ParkMap::unpacked(asked.car, asked.place, options, bytes);
        EXPECT_EQ(again.bytes(), map.bytes());
        EXPECT_EQ(again.fingerprint(), map.fingerprint());
        EXPECT_TRUE(ParkMap(asked.car, asked.place, options).packed() == bytes) << "the bytes of one made again";
        for (int n = 0; n < 200; ++n) {
            const Pose pose = random_pose(random, asked);
            EXPECT_EQ(again.at(pose), map.at(pose)) << spelled(pose);
            const std::optional<snug::Maneuver> one = map.maneuver(pose), two = again.maneuver(pose);
            ASSERT_EQ(one.has_value(), two.has_value()) << spelled(pose);
            if (one) {
                EXPECT_EQ(one->moves, two->moves) << spelled(pose);
            }
        }
        // What is damaged, cut, longer, or asked otherwise is refused.
        const auto refused = [&](const snug::ParkMapOptions& how, const std::vector<std::byte>& what) {
            EXPECT_THROW(static_cast<void>(ParkMap::unpacked(asked.car, asked.place, how, what)), snug::Error);
        };
        snug::ParkMapOptions other = options;
        other.max_changes = 7;
        refused(other, bytes);
        refused(options, {});
        const auto at = static_cast<std::size_t>(random.between(0.0, static_cast<double>(bytes.size() - 1)));
        refused(options, {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at)});
        bytes[at] ^= std::byte{16};
        refused(options, bytes);
        bytes[at] ^= std::byte{16};
        bytes.push_back(std::byte{0});
        refused(options, bytes);
        if (HasFailure()) return;
    }
}

/// From the heading the map is made for both claim the same: headings within 80 degrees of the same middle.
TEST(ParkMap, BoundsHoldForTheAnswersOfPark) {
    const int count = snug::test::sample(16, 600);
    int compared = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(static_cast<std::uint64_t>(i) + 2400000);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(static_cast<std::uint64_t>(i) + 2500000);
        const ParkMap map(asked.car, asked.place, with_heading(asked.start.heading, 0.0));
        for (int n = 0; n < 6; ++n) {
            Pose pose = random_pose(random, asked);
            pose.heading = asked.start.heading;
            const MapBounds bounds = map.at(pose);
            if (bounds.where != MapBounds::free) continue;
            snug::ParkOptions options;
            options.resolution = 0.04;
            options.max_changes = 10;
            options.roomiest = false;
            const snug::ParkAnswer answer = park(asked.car, asked.place, pose, options);
            ++compared;
            if (answer.direction_changes) {
                EXPECT_LE(bounds.lower_bound, *answer.direction_changes) << spelled(pose);
                EXPECT_FALSE(bounds.impossible) << spelled(pose);
            }
            if (bounds.direction_changes) {
                EXPECT_GE(*bounds.direction_changes, answer.lower_bound) << spelled(pose);
                EXPECT_FALSE(answer.impossible) << spelled(pose);
            }
        }
    }
    EXPECT_GT(compared, count);
}

TEST(ParkMap, AMirroredWorldHasTheMirroredMap) {
    const int count = snug::test::sample(8, 200);
    long long compared = 0, differ = 0;
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(i) + 2600000);
        const Car car = random_car(random);
        Street right = random_street(random, car);
        right.side = snug::Side::right;
        right.corner = {0.0, 0.0};
        right.heading = 0.0;
        Street left = right;
        left.side = snug::Side::left;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(car, right, {}));
        ParkMapOptions options;
        options.max_changes = 8;
        const ParkMap one(car, right, options), other(car, left, options);
        EXPECT_NE(one.fingerprint(), other.fingerprint());
        for (int n = 0; n < 2000; ++n) {
            const Pose pose = {random.between(-8.0, 8.0), random.between(-2.0, 5.0), random.between(-1.0, 1.0)};
            const MapBounds here = one.at(pose), there = other.at({pose.x, -pose.y, -pose.heading});
            ++compared;
            differ += here != there;
            if (here.where == MapBounds::free && there.where == MapBounds::free) {
                if (here.direction_changes) {
                    EXPECT_GE(*here.direction_changes, there.lower_bound) << spelled(pose);
                }
                if (there.direction_changes) {
                    EXPECT_GE(*there.direction_changes, here.lower_bound) << spelled(pose);
                }
            }
        }
    }
    std::printf("%lld of %lld differ\n", differ, compared);
    EXPECT_LE(differ, compared / 200);  // where roundings decide
}

/// The paper's entry positions, on an open road: the slice of the map in which the car touches the slot's corner.
TEST(ParkMap, AtTheEntryPositionsItAgreesWithFewest) {
    const int count = snug::test::sample(8, 200);
    int compared = 0;
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(i) + 2700000);
        const Car car = random_car(random);
        Street street;
        street.length = car.length() * random.between(1.08, 1.4);
        street.width = car.width() * random.between(1.04, 1.4);
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(car, street, {}));
        const ParkMap map(car, street);
        snug::FewestOptions options;
        options.max_changes = 8;
        options.roomiest = false;
        options.resolution = 2e-3 * car.length();
        const auto fewest = snug::fewest(car, snug::Slot({.length = street.length, .width = street.width}), options);
        int lower = 1000;
        std::optional<int> upper;
        for (int k = 0; k <= 400; ++k) {
            // The front-right corner at the slot's corner.
            const double heading = k * 1.2 / 400, c = std::cos(heading), s = std::sin(heading);
            const Pose entry = {-car.front() * c - car.width() / 2 * s, -car.front() * s + car.width() / 2 * c,
                                heading};
            const MapBounds bounds = map.at(entry);
            if (bounds.where != MapBounds::free) continue;
            lower = std::min(lower, bounds.lower_bound);
            if (bounds.direction_changes && (!upper || *bounds.direction_changes < *upper))
                upper = bounds.direction_changes;
        }
        if (lower == 1000) continue;
        // Between the headings looked at there may be better ones.
        if (upper) {
            ++compared;
            EXPECT_LE(fewest.lower_bound, *upper);
        }
        if (fewest.direction_changes && lower > *fewest.direction_changes)
            ADD_FAILURE() << "at least " << lower << " changes, but fewest() knows a maneuver with "
                          << *fewest.direction_changes;
    }
    EXPECT_GE(compared, count / 4);
}

TEST(ParkMap, RefusesWhatItIsNotMadeFor) {
    const Car car = snug::find_car("renault-zoe").value(), other = snug::find_car("opel-corsa").value();
    Street street;
    street.length = 5.2;
    street.width = 2.0;
    street.road = 3.5;
    ParkMapOptions options;
    options.max_changes = 3;
    const ParkMap map(car, street, options);
    const Place place = street_place(street);
    EXPECT_NO_THROW(map.expect(car, place));
    EXPECT_THROW(map.expect(other, place), snug::Error);
    EXPECT_THROW(map.expect(car, place, 0.01), snug::Error);
    street.length = 5.2000000001;
    EXPECT_THROW(map.expect(car, street_place(street)), snug::Error);
    EXPECT_EQ(map.at({0.0, 0.0, std::nan("")}).where, MapBounds::outside);
    EXPECT_EQ(map.at({0.0, 1.5, 1.5}).where, MapBounds::outside);
    EXPECT_EQ(map.at({0.0, 100.0, 0.0}).where, MapBounds::outside);
    EXPECT_EQ(map.at({0.0, 0.3, 0.0}).where, MapBounds::blocked);
    options.spacing = 1.0;
    EXPECT_THROW(ParkMap(car, street, options), snug::Error);
    options.spacing = 0.0;
    options.progress = [] { return false; };
    EXPECT_THROW(ParkMap(car, street, options), snug::Error);
    options.progress = {};
    street.stretch = 900.0;
    options.spacing = 0.005;
    EXPECT_THROW(ParkMap(car, street, options), snug::Error);
}

}  // namespace
