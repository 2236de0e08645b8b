// No random real maneuver leaves the sets that bound the number of changes from below.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "park/drive_out.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"

namespace {

using namespace park_test;
using snug::Direction;

/// A soak follows more than ten million places; SNUG_FIRST and SNUG_CASES choose some of its slots.
TEST(OuterSets, HoldEveryPlaceOfRandomManeuversOutOfTheSlot) {
    const int first = static_cast<int>(snug::test::number("SNUG_FIRST", 0));
    const int count =
        static_cast<int>(snug::test::number("SNUG_CASES", static_cast<std::uint64_t>(snug::test::sample(24, 400))));
    const int maneuvers = snug::test::sample(400, 4000);
    long long states = 0;
    for (int i = first; i < first + count; ++i) {
        const Case asked = random_case(100000 + static_cast<std::uint64_t>(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(7000000 + static_cast<std::uint64_t>(i));
        snug::detail::sets::Chart chart;
        const auto here = snug::detail::sets::chart_place(asked.car, asked.place, asked.start, 0.0, chart);
        if (std::abs(here.start.heading) > 1.3) continue;
        const double spacing = 0.16 / std::pow(2.0, random.whole(0, 2));
        const snug::detail::sets::OuterLattice lattice(here, spacing, 0.16, nullptr, [] {});
        const auto& limits = lattice.free();
        constexpr int deepest = 4;
        std::vector<snug::detail::sets::Pairs> forward, backward;
        for (int k = 0; k <= deepest; ++k) {
            snug::detail::sets::Pairs moves[2];
            for (const Direction direction : snug::detail::sets::both_directions) {
                const bool is_forward = direction == Direction::forward;
                snug::detail::sets::Pairs& pairs = moves[is_forward ? 0 : 1];
                const auto& before = is_forward ? backward : forward;
                lattice.sweep(
                    pairs, limits, direction, [] {},
                    [&](snug::detail::sets::Rows rows) {
                        if (k == 0) {
                            lattice.begin(rows, pairs, limits, direction, lattice.parked());
                        } else {
                            lattice.turn(rows, pairs, limits, direction, before.back());
                        }
                    });
            }
            forward.push_back(std::move(moves[0]));
            backward.push_back(std::move(moves[1]));
        }
        for (int n = 0; n < maneuvers; ++n) {
            drive_out(
                asked, chart, random, deepest, [&](const Pose& pose, const Pose& in_chart, int k, bool is_forward) {
                    ++states;
                    const auto& sets = is_forward ? forward : backward;
                    const Direction direction = is_forward ? Direction::forward : Direction::backward;
                    const bool held = lattice.holds(sets[static_cast<std::size_t>(k)], limits, direction, in_chart);
                    EXPECT_TRUE(held) << "spacing " << spacing << ", maneuver " << n << ", change " << k << ", at "
                                      << pose.x << " " << pose.y << " " << pose.heading;
                    return held;
                });
            if (HasFailure()) return;
        }
    }
    std::printf("%lld states\n", states);
    EXPECT_GT(states, count * 1000);
}

/// The same through all that `park` does: coarse lattices clip the finer ones.
TEST(Park, NeedsNoMoreChangesThanARandomManeuverHad) {
    const int count = snug::test::sample(40, 3000);
    int asked_for = 0;
    for (int i = 0; i < count; ++i) {
        Case asked = random_case(1100000 + static_cast<std::uint64_t>(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Random random(1200000 + static_cast<std::uint64_t>(i));
        snug::detail::sets::Chart chart;
        static_cast<void>(snug::detail::sets::chart_place(asked.car, asked.place, asked.start, 0.0, chart));
        // Headings stay within 80 degrees of the middle between both ends when they stay within 40 of the parked one.
        chart = {chart.origin, std::get<snug::ParkedInside>(asked.place.parked()).heading};
        bool within = true;
        int changes = 0;
        double turned = 0.0;
        drive_out(asked, chart, random, random.whole(0, 4), [&](const Pose& pose, const Pose& in_chart, int k, bool) {
            within = within && std::abs(in_chart.heading) < 0.7;
            if (!within) return false;
            asked.start = pose;
            changes = k;
            turned = in_chart.heading;
            return true;
        });
        if (changes == 0 && turned == 0.0) continue;
        ++asked_for;
        snug::ParkOptions options;
        options.resolution = 0.02;
        options.max_changes = 6;
        options.roomiest = false;
        const auto answer = park(asked.car, asked.place, asked.start, options);
        EXPECT_LE(answer.lower_bound, changes)
            << "from " << asked.start.x << " " << asked.start.y << " " << asked.start.heading;
    }
    std::printf("%d asked for\n", asked_for);
}

}  // namespace
