// Can the answers to Problems 1 and 2 be trusted for any outline among any neighbours? Every answer judged by the oracle.
//
// SNUG_SOAK=1 runs more than two thousand; SNUG_SEED, SNUG_FIRST and SNUG_CASES choose which.
#include <gtest/gtest.h>

#include "oracle/judged_cases.hpp"
#include "oracle/random_outlines.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

TEST(OutlineEntry, TheOracleFindsNothingBetterNothingMoreAndNothingWrong) {
    JudgeOptions options;
    options.heading_step = 1e-4;
    judge_all(random_outline_case, snug::test::sample(20, 2400, 1), options);
}

TEST(OutlineEntry, OneRunOfTheStrategyIsWhatTheOracleDrives) {
    int parked = 0, brink = 0;
    const int runs = snug::test::sample(4000, 200000);
    Case asked;
    for (int i = 0; i < runs; ++i) {
        if (i % 20 == 0) asked = random_outline_case(51, std::uint64_t(i / 20));
        Random random(std::uint64_t(i) + 1);
        const double heading = random.chance(0.1) ? random.between(0, 1.57) : random.between(0, 0.7);
        snug::MaxSteerOptions options;
        options.driving = asked.driving;
        options.parked = asked.parked;
        options.max_changes = random.below(25);
        SCOPED_TRACE(command_line(asked) + " from heading " + std::to_string(heading));
        const snug::MaxSteerRun got = snug::max_steer(asked.made_car(), asked.made_slot(), heading, options);
        const Decided exact =
            decide(make_problem<long double>(asked), static_cast<long double>(heading), options.max_changes);
        if (!exact.certain) {
            ++brink;
            continue;
        }
        // A car that twitches less and less is stuck sooner or later: as rounding will have it.
        const auto twitches = [](snug::Outcome outcome) {
            return outcome == snug::Outcome::stuck || outcome == snug::Outcome::too_many_changes;
        };
        if (got.outcome != exact.outcome && twitches(got.outcome) && twitches(exact.outcome) &&
            got.maneuver.moves.back().length < 1e-9) {
            ++brink;
            continue;
        }
        // The solver does not look for an entry where the slot does not hold the car; the oracle drives, in vain.
        const snug::Shortfall lacks = snug::shortfall(asked.made_car(), asked.made_slot(), asked.driving);
        if (got.outcome == snug::Outcome::no_entry && (lacks.length > 0.0 || lacks.width > 0.0)) {
            EXPECT_NE(exact.outcome, snug::Outcome::parked);
            continue;
        }
        EXPECT_EQ(static_cast<int>(got.outcome), static_cast<int>(exact.outcome));
        if (got.outcome != snug::Outcome::parked) continue;
        ++parked;
        EXPECT_EQ(faults(asked, got.maneuver, exact.count), std::vector<std::string>{});
    }
    std::printf("%d runs, %d parked, %d left out within rounding of another outcome\n", runs, parked, brink);
    EXPECT_GT(parked, runs / 100);
    EXPECT_LT(brink, runs / 50 + 2);
}

}  // namespace
}  // namespace oracle
