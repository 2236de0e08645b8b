// Laws of `park`: what makes parking easier never makes it proved to be harder; mirrored and moved worlds agree; with an open
// road it agrees with `fewest`.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/fewest.hpp"
#include "snug/leave.hpp"
#include "snug/park.hpp"

namespace {

using namespace park_test;

snug::ParkOptions quick() {
    snug::ParkOptions options;
    options.resolution = 0.04;
    options.max_changes = 8;
    options.roomiest = false;
    return options;
}

/// A bay in a road that the start does not collide in; empty if there is none.
struct Bay {
    Car car;
    Street street;
    Pose start;
};
std::optional<Bay> random_bay(std::uint64_t index) {
    Random random(index);
    const Car car = random_car(random);
    const Street street = random_street(random, car);
    Pose start = standard_start(street, car);
    start.x += random.between(-0.5, 0.5);
    start.y += random.between(-0.2, 0.2);
    start.heading += random.between(-0.1, 0.1);
    const Place place = street_place(street);
    if (depth_in_place(car, place, start) > -1e-3 || outside_region(place, start) > -1e-3) return std::nullopt;
    return Bay{car, street, start};
}

TEST(ParkLaws, MoreRoadSmallerCarsAndLongerSlotsAreNoHarder) {
    const int count = snug::test::sample(16, 300);
    for (int i = 0; i < count; ++i) {
        const auto bay = random_bay(200000 + static_cast<std::uint64_t>(i));
        if (!bay) continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(bay->car, bay->street, bay->start));
        const auto hard = park(bay->car, street_place(bay->street), bay->start, quick());
        if (!hard.direction_changes) continue;
        Random random(300000 + static_cast<std::uint64_t>(i));
        Street easier = bay->street;
        if (easier.road) *easier.road += random.between(0.0, 1.0);
        easier.stretch += random.between(0.0, 1.0);
        auto dimensions = bay->car.dimensions();
        dimensions.width -= random.between(0.0, 0.2);
        dimensions.front -= random.between(0.0, 0.2);
        dimensions.rear -= random.between(0.0, 0.2);
        const auto easy = park(Car(dimensions), street_place(easier), bay->start, quick());
        EXPECT_LE(easy.lower_bound, *hard.direction_changes);
        // Later on the same way no more changes are left.
        const auto& moves = hard.maneuver->moves;
        const std::size_t at = static_cast<std::size_t>(random.whole(0, static_cast<int>(moves.size()) - 1));
        int left = 0;
        for (std::size_t k = at + 1; k < moves.size(); ++k) left += moves[k].direction != moves[k - 1].direction;
        const Pose there =
            drive(bay->car, moves[at].start, moves[at].direction, moves[at].steering_angle, 0.5 * moves[at].length);
        if (depth_in_place(bay->car, street_place(bay->street), there) > -1e-6) continue;
        EXPECT_LE(park(bay->car, street_place(bay->street), there, quick()).lower_bound, left)
            << "from the middle of move " << at;
    }
}

/// Driven the other way round, a maneuver in leads out with as many changes, and one out leads in.
TEST(ParkLaws, LeavingIsParkingDrivenTheOtherWayRound) {
    const int count = snug::test::sample(12, 200);
    for (int i = 0; i < count; ++i) {
        const auto bay = random_bay(500000 + static_cast<std::uint64_t>(i));
        if (!bay) continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(bay->car, bay->street, bay->start));
        Street street = bay->street;
        Pose start = standard_start(street, bay->car);  // along the street, as the car is to leave
        if (depth_in_place(bay->car, street_place(street), start) > -1e-3) continue;
        const auto in = park(bay->car, street_place(street), start, quick());
        if (!in.maneuver || in.maneuver->moves.empty()) continue;
        const Pose goal = in.maneuver->goal();
        if (depth_in_place(bay->car, street_place(street), goal) > -1e-6) continue;
        const auto out = leave(bay->car, street, goal, quick());
        EXPECT_LE(out.lower_bound, *in.direction_changes);
        if (!out.maneuver || out.maneuver->moves.empty()) continue;
        EXPECT_EQ(verdict(bay->car, road_place(street), goal, out), "");
        const Pose road = out.maneuver->goal();
        if (depth_in_place(bay->car, street_place(street), road) > -1e-6) continue;
        EXPECT_LE(park(bay->car, street_place(street), road, quick()).lower_bound, *out.direction_changes);
    }
}

TEST(ParkLaws, MirroredAndMovedWorldsAgree) {
    const int count = snug::test::sample(10, 200);
    for (int i = 0; i < count; ++i) {
        const auto bay = random_bay(400000 + static_cast<std::uint64_t>(i));
        if (!bay) continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(bay->car, bay->street, bay->start));
        const auto here = park(bay->car, street_place(bay->street), bay->start, quick());
        Street other = bay->street;
        other.side = bay->street.side == snug::Side::right ? snug::Side::left : snug::Side::right;
        other.corner = {100000.0, -200000.0};  // as map projections have them
        other.heading = 2.0;
        const snug::Slot from({.length = 1,
                               .width = 1,
                               .side = bay->street.side,
                               .corner = bay->street.corner,
                               .heading = bay->street.heading});
        const snug::Slot to(
            {.length = 1, .width = 1, .side = other.side, .corner = other.corner, .heading = other.heading});
        const auto there = park(bay->car, street_place(other), to.to_world(from.to_slot(bay->start)), quick());
        // Bounds are rounded in the chart, so they may differ only where they do not prove anything.
        if (here.direction_changes) {
            EXPECT_GE(*here.direction_changes, there.lower_bound);
        }
        if (there.direction_changes) {
            EXPECT_GE(*there.direction_changes, here.lower_bound);
        }
        if (here.proved && there.proved) {
            EXPECT_EQ(here.lower_bound, there.lower_bound);
        }
    }
}

/// The fewest changes into the slot, entered in one way; more than `most` where there are none.
struct Bounds {
    int lower, upper;
};
Bounds fewest_changes(const Car& car, const snug::Slot& slot, snug::Enter enter, int most) {
    snug::FewestOptions options;
    options.driving.enter = enter;
    options.max_changes = most;
    options.roomiest = false;
    const auto answer = snug::fewest(car, slot, options);
    return {answer.lower_bound, answer.direction_changes.value_or(most + 1)};
}

/// From far ahead and well out in an open road a car comes to any entry position driving backward, and with a change more to any
/// where it enters nose first.
TEST(ParkLaws, OnAnOpenRoadTheAnswersAreThoseOfFewest) {
    const int count = snug::test::sample(8, 200, 3);
    constexpr int most = 20;
    int asked = 0, same = 0;
    for (int i = 0; i < count; ++i) {
        Random random(500000 + static_cast<std::uint64_t>(i));
        const Car car = random_car(random);
        Street street;
        street.length = car.length() * random.between(1.08, 1.4);
        street.width = car.width() * random.between(1.04, 1.4);
        street.stretch = 12.0;
        const Pose start{8.0, 4.0, 0.0};
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(car, street, start));
        const snug::Slot slot({.length = street.length, .width = street.width});
        const Bounds tail = fewest_changes(car, slot, snug::Enter::backward, most);
        const Bounds nose = fewest_changes(car, slot, snug::Enter::forward, most - 1);
        const Bounds expected = {std::min(tail.lower, nose.lower + 1), std::min(tail.upper, nose.upper + 1)};
        snug::ParkOptions options;
        options.max_changes = most;
        options.roomiest = false;
        const auto parked = park(car, street_place(street), start, options);
        EXPECT_LE(parked.lower_bound, expected.upper);
        EXPECT_LE(expected.lower, parked.direction_changes.value_or(most + 1));
        ++asked;
        const bool is_same =
            parked.lower_bound == expected.lower && parked.direction_changes.value_or(most + 1) == expected.upper;
        same += is_same;
        if (!is_same)
            std::printf("case %d: %d to %d, but %d to %d\n", i, parked.lower_bound,
                        parked.direction_changes.value_or(most + 1), expected.lower, expected.upper);
    }
    EXPECT_GE(same, 0.95 * asked);
}

}  // namespace
