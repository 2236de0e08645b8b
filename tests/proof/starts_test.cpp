// By how much a start may be off, held against the oracle: whatever is said to park parks, and a little farther does not.
#include "snug/start_tolerance.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "oracle/random_cases.hpp"
#include "oracle/random_outlines.hpp"
#include "sample.hpp"
#include "snug/contact.hpp"
#include "snug/entry.hpp"
#include "snug/entry_position.hpp"
#include "snug/error.hpp"

namespace oracle {
namespace {

using snug::StartTolerance;

snug::MaxSteerOptions options_of(const Case& asked, int max_changes) {
    return {max_changes, asked.driving, asked.parked};
}

/// Does the oracle park from this far off the entry position?
bool parks(const Problem<long double>& problem, const StartTolerance& tolerance, long double along, long double out) {
    Place<long double> place = entry_place(problem, static_cast<long double>(tolerance.heading));
    place.x += problem.enter == snug::Enter::backward ? -along : along;
    place.y += out;
    Run<long double> run;
    run_from(problem, place, tolerance.direction_changes, run);
    return run.parked();
}

struct Tally {
    int cases = 0, ends = 0, open_ends = 0, boxes = 0;
    long starts = 0;
};

void attack(const Case& asked, Random& random, Tally& tally) {
    const snug::Car car = asked.made_car();
    const snug::Slot slot = asked.made_slot();
    snug::EntryOptions quick;
    quick.driving = asked.driving;
    quick.parked = asked.parked;
    quick.prove = false;
    const snug::Answer answer = snug::entry(car, slot, quick);
    if (!answer.parkable() || *answer.direction_changes > 40) return;
    const double heading = snug::middle(*snug::widest_range(answer.ranges, *answer.direction_changes));
    const auto found = snug::start_tolerance(car, slot, heading, options_of(asked, *answer.direction_changes));
    ASSERT_TRUE(found) << command_line(asked);
    const StartTolerance& tolerance = *found;
    ++tally.cases;
    tally.boxes += tolerance.both_along > 0.0 ? 1 : 0;
    const Problem<long double> problem = make_problem<long double>(asked);
    const auto expect_parks = [&](double along, double out) {
        ++tally.starts;
        if (parks(problem, tolerance, along, out)) return;
        ADD_FAILURE() << "does not park from " << along << " along and " << out << " out in " << command_line(asked);
    };
    for (int i = 0; i < 12; ++i) {
        const double part = i < 4 ? 1.0 - 1e-9 * i : random.unit();
        const double other = i < 4 ? 1.0 - 1e-9 * i : random.unit();
        expect_parks(part * tolerance.along, 0.0);
        expect_parks(0.0, part * tolerance.out);
        expect_parks(part * tolerance.both_along, other * tolerance.both_out);
    }
    // Where it ends, unless at what was not asked about: beside the other neighbour, or out by the depth of the slot.
    const snug::Gaps room =
        snug::gaps(car, slot, snug::entry_position(car, slot, heading, asked.driving), asked.driving);
    const bool backward = asked.driving.enter == snug::Enter::backward;
    for (const bool along : {true, false}) {
        const double end = along ? tolerance.along : tolerance.out;
        if (end == (along ? (backward ? room.rear : room.front) : slot.width())) continue;
        ++tally.ends;
        if (parks(problem, tolerance, along ? end + 3e-9 : 0.0, along ? 0.0 : end + 3e-9)) ++tally.open_ends;
    }
}

TEST(StartTolerance, OfRandomCasesHoldsForTheOracle) {
    Tally tally;
    Random random(20);
    const int cases = snug::test::sample(60, 5000);
    for (int i = 0; i < cases && !testing::Test::HasFailure(); ++i) {
        attack(random_case(9201, std::uint64_t(i)), random, tally);
        if (i % 3 == 0) attack(random_outline_case(9202, std::uint64_t(i)), random, tally);
    }
    std::printf("%d tolerances, %ld starts; %d of %d ends not sharp; %d boxes\n", tally.cases, tally.starts,
                tally.open_ends, tally.ends, tally.boxes);
    EXPECT_GT(tally.cases, cases / 4);
    EXPECT_LE(tally.open_ends, 1 + tally.ends / 20);
}

TEST(StartTolerance, OfThePapersSlots) {
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 4.5, .width = 2.0});
    const auto tolerance = snug::start_tolerance(zoe, slot, 0.48598674329835956, {.max_changes = 18});
    ASSERT_TRUE(tolerance);
    EXPECT_EQ(tolerance->direction_changes, 18);
    EXPECT_GT(tolerance->both_along, tolerance->along / 2.0);
}

TEST(StartTolerance, IsNoneWhereTheEntryPositionDoesNotPark) {
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 4.5, .width = 2.0});
    EXPECT_FALSE(snug::start_tolerance(zoe, slot, 0.48598674329835956, {.max_changes = 17}));
    EXPECT_FALSE(snug::start_tolerance(zoe, slot, 0.1));
    EXPECT_THROW(snug::start_tolerance(zoe, slot, -0.1), snug::Error);
}

/// The same to the left and nose first with a car turned about.
TEST(StartTolerance, IsTheSameForTheMirrorImage) {
    const snug::CarDimensions car = snug::find_car("opel-corsa")->dimensions();
    const snug::CarDimensions turned = {car.width, car.rear, car.front, car.wheelbase, car.max_steer};
    const snug::Slot right({.length = 4.6, .width = 2.0});
    const snug::Slot left({.length = 4.6, .width = 2.0, .side = snug::Side::left});
    const snug::Answer answer = snug::entry(snug::Car(car), right);
    const double heading = snug::middle(answer.ranges.front());
    snug::MaxSteerOptions options{*answer.direction_changes};
    const auto tolerance = snug::start_tolerance(snug::Car(car), right, heading, options);
    ASSERT_TRUE(tolerance);
    EXPECT_EQ(tolerance, snug::start_tolerance(snug::Car(car), left, heading, options));
    options.driving.enter = snug::Enter::forward;
    EXPECT_EQ(tolerance, snug::start_tolerance(snug::Car(turned), right, heading, options));
}

}  // namespace
}  // namespace oracle
