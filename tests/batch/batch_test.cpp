// Many cases at a time: the counts of max_steer(), case by case, on every kind of vector the processor has.
#include "snug/batch.hpp"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "model/refusals.hpp"
#include "oracle/random_cases.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

using oracle::Random;

/// Runs `check` once for every kind of vector this processor has.
template <class Check>
void with_every_vector(Check check) {
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        check();
        if (testing::Test::HasFailure()) break;
    }
    hwy::SetSupportedTargetsForTest(0);
}

int one_by_one(const Car& car, const Slot& slot, double heading, const MaxSteerOptions& options) {
    const MaxSteerRun run = max_steer(car, slot, heading, options);
    return run.outcome == Outcome::parked ? run.maneuver.direction_changes() : -1;
}

Car random_car(Random& random) {
    oracle::Case chosen;
    oracle::choose_car(random, chosen);
    return Car(chosen.car);
}

MaxSteerOptions random_options(Random& random) {
    constexpr int limits[] = {200, 200, 200, 0, 1, 2, 3, 30};
    MaxSteerOptions options;
    options.max_changes = limits[random.below(8)];
    if (random.chance(0.2)) options.driving.clearance = random.between(0.0, 0.1);
    if (random.chance(0.3)) options.driving.enter = Enter::forward;
    return options;
}

/// From too small to wide open, most of them tight.
Slot random_slot(Random& random, const Car& car) {
    double longer = random.between(0.3, 1.2);
    double wider = random.between(0.03, 0.5);
    if (random.chance(0.2)) longer = random.between(-0.1, 8.0);
    if (random.chance(0.2)) wider = random.between(-0.1, 8.0);
    const Side side = random.chance(0.2) ? Side::left : Side::right;
    return Slot({.length = car.length() + longer, .width = car.width() + wider, .side = side});
}

double random_heading(Random& random) {
    constexpr double right_angle = 1.5707963267948966;
    const double kind = random.unit();
    if (kind < 0.02) return 0.0;
    if (kind < 0.04) return right_angle;
    if (kind < 0.10) return std::pow(10.0, random.between(-16.0, -1.0));
    return random.between(0.0, kind < 0.3 ? right_angle : 0.7);
}

std::vector<double> random_headings(Random& random, std::size_t count) {
    std::vector<double> headings(count);
    for (double& heading : headings) heading = random_heading(random);
    return headings;
}

TEST(Batch, ManyHeadingsCountAsOneByOne) {
    std::set<int> seen;
    const int problems = test::sample(1500, 100000);
    for (int i = 0; i < problems; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        Random random(40000 + static_cast<std::uint64_t>(i));
        const Car car = random_car(random);
        const Slot slot = random_slot(random, car);
        const MaxSteerOptions options = random_options(random);
        const std::vector<double> headings = random_headings(random, static_cast<std::size_t>(random.below(60)));
        std::vector<int> expected;
        for (const double heading : headings) expected.push_back(one_by_one(car, slot, heading, options));
        seen.insert(expected.begin(), expected.end());
        with_every_vector([&] { EXPECT_EQ(direction_changes(car, slot, headings, options), expected); });
        if (HasFailure()) return;
    }
    EXPECT_GT(seen.size(), 10U) << "the sample parks in many ways";
}

TEST(Batch, ManySlotsCountAsOneByOne) {
    std::set<int> seen;
    const int problems = test::sample(1500, 100000);
    for (int i = 0; i < problems; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        Random random(50000000 + static_cast<std::uint64_t>(i));
        const Car car = random_car(random);
        const MaxSteerOptions options = random_options(random);
        const std::vector<double> headings = random_headings(random, static_cast<std::size_t>(random.below(60)));
        std::vector<Slot> slots;
        std::vector<int> expected;
        for (const double heading : headings) {
            slots.push_back(random_slot(random, car));
            expected.push_back(one_by_one(car, slots.back(), heading, options));
        }
        seen.insert(expected.begin(), expected.end());
        with_every_vector([&] { EXPECT_EQ(direction_changes(car, slots, headings, options), expected); });
        if (HasFailure()) return;
    }
    EXPECT_GT(seen.size(), 10U) << "the sample parks in many ways";
}

const Car zoe = find_car("renault-zoe").value();
const Slot short_slot({.length = 4.5, .width = 2.0});
constexpr double parks = 0.486;

TEST(Batch, EveryLaneIsFilledWhateverTheirNumber) {
    for (std::size_t count = 0; count <= 70; ++count) {
        with_every_vector([&] {
            EXPECT_EQ(direction_changes(zoe, short_slot, std::vector<double>(count, parks)),
                      std::vector<int>(count, 18));
            EXPECT_EQ(direction_changes(zoe, std::vector<Slot>(count, short_slot), std::vector<double>(count, parks)),
                      std::vector<int>(count, 18));
        });
    }
}

TEST(Batch, TheEdgeOfThePossibleHeadingsIsTheSame) {
    for (const double length : {4.0840000001, 4.0841, 4.1, 4.2, 4.3, 4.4515, 4.6}) {
        const Slot slot({.length = length, .width = 2.5});
        std::vector<double> headings;
        std::vector<int> expected;
        // To where the front corner swings out at once, the curb is hit, or the tail meets the rear corner or side.
        const double level = std::atan2(zoe.width(), zoe.length());
        const double diagonal = std::hypot(zoe.width(), zoe.length());
        for (const double edge : {std::acos(zoe.length() / length), level, std::asin(slot.width() / zoe.length()),
                                  level + std::acos(std::min(1.0, length / diagonal))}) {
            for (int i = -20; i <= 20; ++i) {
                headings.push_back(edge * (1.0 + i * std::numeric_limits<double>::epsilon()));
                expected.push_back(one_by_one(zoe, slot, headings.back(), {}));
            }
        }
        with_every_vector([&] {
            EXPECT_EQ(direction_changes(zoe, std::vector<Slot>(headings.size(), slot), headings), expected);
            EXPECT_EQ(direction_changes(zoe, slot, headings), expected);
        });
    }
}

TEST(Batch, ImpossibleHeadingsAreNamedByTheirIndex) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -0.1, 1.6}) {
        const std::vector<double> headings = {0.1, 0.2, bad, 0.3};
        const std::vector<Slot> slots(4, short_slot);
        EXPECT_NE(model::refusal([&] { (void)direction_changes(zoe, short_slot, headings); }).find("[2]"),
                  std::string::npos);
        EXPECT_NE(model::refusal([&] { (void)direction_changes(zoe, slots, headings); }).find("[2]"),
                  std::string::npos);
    }
}

TEST(Batch, ImpossibleOptionsAreRefusedEvenWithoutCases) {
    for (const MaxSteerOptions& bad :
         {MaxSteerOptions{.max_changes = -1}, MaxSteerOptions{.max_changes = 100001},
          MaxSteerOptions{.driving = {.clearance = -0.1}},
          MaxSteerOptions{.driving = {.clearance = std::numeric_limits<double>::quiet_NaN()}}}) {
        EXPECT_THROW((void)direction_changes(zoe, short_slot, {}, bad), Error);
        EXPECT_THROW((void)direction_changes(zoe, std::vector<Slot>{}, {}, bad), Error);
    }
}

TEST(Batch, EverySlotNeedsItsHeading) {
    EXPECT_THROW((void)direction_changes(zoe, std::vector<Slot>(3, short_slot), {0.1, 0.2}), Error);
    EXPECT_THROW((void)direction_changes(zoe, std::vector<Slot>{}, {0.1}), Error);
}

}  // namespace
}  // namespace snug
