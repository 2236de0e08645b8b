// A car that comes to stand straight across, nose to the curb, has turned away and parks no more, however one asks. It takes a
// car about as long as the slot is deep, on a small circle.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>
#include <vector>

#include "oracle/random_cases.hpp"
#include "oracle/strategy.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace oracle {
namespace {

/// A short car with a smaller one's wheels, and a slot in which it could nearly turn round.
Case turning_case(std::uint64_t index) {
    Random random(9000 + index);
    Case chosen;
    chosen.car.wheelbase = random.between(0.6, 1.4);
    chosen.car.width = random.between(0.9, 2.4);
    chosen.car.front = chosen.car.wheelbase + random.between(0.02, 0.8);
    chosen.car.rear = random.between(0.02, 1.5);
    chosen.car.max_steer = random.between(0.4, 1.1);
    const double long_side = chosen.car.front + chosen.car.rear;
    chosen.slot.length = std::max(long_side, chosen.car.width) * random.between(0.98, 1.5);
    chosen.slot.width = std::max(long_side, chosen.car.width) * random.between(0.9, 1.4);
    if (random.chance(0.2)) chosen.driving.enter = snug::Enter::forward;
    if (random.chance(0.2)) chosen.driving.clearance = random.between(0.001, 0.1);
    return chosen;
}

int count_at(const snug::Answer& answer, double heading) {
    for (const snug::HeadingRange& range : answer.ranges)
        if (range.min <= heading && heading <= range.max) return range.direction_changes;
    return -1;
}

TEST(TurnedAway, IsTurnedAwayHoweverOneAsks) {
    constexpr int most = 5;
    const int cases = snug::test::sample(300, 20000);
    int turned_away = 0, parked = 0, brink = 0, sizes = 0;
    for (int i = 0; i < cases; ++i) {
        const Case asked = turning_case(std::uint64_t(i));
        SCOPED_TRACE(command_line(asked) + " --max-changes " + std::to_string(most));
        const snug::Car car(asked.car);
        const snug::Slot slot(asked.slot);
        const auto fast = make_problem<double>(asked);
        const auto fine = make_problem<long double>(asked);
        const snug::Shortfall lacks = snug::shortfall(car, slot, asked.driving);
        if (lacks.length > 0.0 || lacks.width > 0.0) continue;  // nothing is looked for in those
        Random random(std::uint64_t(i) + 1);

        std::vector<double> headings;
        for (int k = 0; k < 40; ++k) headings.push_back(random.between(0.0, std::numbers::pi / 2));
        const snug::MaxSteerOptions drive{most, asked.driving, asked.parked};
        const std::vector<int> counts = snug::direction_changes(car, slot, headings, drive);
        snug::EntryOptions options;
        options.driving = asked.driving;
        options.max_changes = most;
        options.prove = false;
        const snug::Answer quick = snug::entry(car, slot, options);
        for (std::size_t k = 0; k < headings.size(); ++k) {
            const double heading = headings[k];
            const snug::MaxSteerRun run = snug::max_steer(car, slot, heading, drive);
            const int count = run.outcome == snug::Outcome::parked ? run.maneuver.direction_changes() : -1;
            EXPECT_EQ(counts[k], count) << heading;
            const int listed = count_at(quick, heading);
            const oracle::Run<double> driven = oracle::run(fast, heading, most);
            turned_away += driven.outcome == snug::Outcome::never_touches;
            parked += driven.parked();
            const int quickly = driven.parked() ? driven.changes : -1;
            if (count == quickly && listed == quickly) continue;
            const Decided exact = decide(fine, static_cast<long double>(heading), most);
            if (!exact.certain) {
                ++brink;
                continue;
            }
            EXPECT_EQ(count, exact.count) << heading;
            EXPECT_EQ(listed, exact.count) << heading;
        }

        if (i % 10 != 0) continue;
        snug::MinSlotOptions smallest;
        smallest.driving = asked.driving;
        smallest.max_changes = most;
        smallest.prove = false;
        const snug::MinSlot found = snug::min_slot(car, asked.slot.width, smallest);
        if (!found.length) continue;
        ++sizes;
        options.prove = true;
        EXPECT_TRUE(
            snug::entry(car, snug::Slot({.length = *found.length, .width = asked.slot.width}), options).parkable())
            << *found.length;
    }
    std::printf("%d headings park, %d turn away, %d on the brink; %d minimum slots\n", parked, turned_away, brink,
                sizes);
    EXPECT_GT(parked, cases);
    EXPECT_GT(turned_away, 3 * cases);
}

}  // namespace
}  // namespace oracle
