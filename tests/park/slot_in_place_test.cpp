// What the slot alone tells of a place: bounds that no real maneuver beats, and ways that can be driven.
#include "all_maneuvers/sets/slot_in_place.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

#include "all_maneuvers/sets/few_pieces.hpp"
#include "all_maneuvers/sets/route.hpp"
#include "park/drive_out.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"

namespace park_test {
namespace {

using namespace snug::detail::sets;

/// Driven out of the slot at random and back the same way, a car parks with the changes it took.
TEST(SlotInPlace, NoRealManeuverBeatsItsLowerBound) {
    const int count = snug::test::sample(40, 20000, 40);
    int asked_about = 0, just_met = 0;
    for (int i = 0; i < count; ++i) {
        Case asked = random_case(6'000'000 + static_cast<std::uint64_t>(i));
        Random random(7'000'000 + static_cast<std::uint64_t>(i));
        Chart chart;
        static_cast<void>(chart_place(asked.car, asked.place, asked.start, 0.0, chart));
        if (!slot_in(asked.car, asked.place, asked.start, 0.0, chart)) continue;
        const int changes = start_where_driven(asked, random);
        if (changes < 0) continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        static_cast<void>(chart_place(asked.car, asked.place, asked.start, 0.0, chart));
        const std::optional<SlotInPlace> slot = slot_in(asked.car, asked.place, asked.start, 0.0, chart);
        ASSERT_TRUE(slot);
        const int lower = slot->lower(changes, 16e6, [] {});
        ++asked_about;
        just_met += lower == changes;
        EXPECT_LE(lower, changes);
    }
    std::printf("%d asked, %d of the bounds are just met\n", asked_about, just_met);
    EXPECT_GT(just_met, 0);
}

TEST(SlotInPlace, ItsWaysCanBeDriven) {
    const int count = snug::test::sample(40, 2000, 40);
    int slots = 0, ways = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(8'000'000 + static_cast<std::uint64_t>(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        Chart chart;
        const ChartPlace place = chart_place(asked.car, asked.place, asked.start, 0.0, chart);
        const std::optional<SlotInPlace> slot = slot_in(asked.car, asked.place, asked.start, 0.0, chart);
        if (!slot) continue;
        ++slots;
        const std::vector<snug::detail::Path> from_mouth = slot->from_mouth(12, [] {});
        if (from_mouth.empty()) continue;
        const std::vector<snug::detail::Path> way = from_start(place, from_mouth, 12, [] {});
        if (way.empty()) continue;
        ++ways;
        EXPECT_TRUE(is_drivable(place, way));
        EXPECT_LE(changes_of(way), 12);
        EXPECT_LE(slot->lower(changes_of(way), 1e6, [] {}), changes_of(way));
        EXPECT_NEAR(way.front().start.x, place.start.x, 1e-12);
        EXPECT_NEAR(way.front().start.y, place.start.y, 1e-12);
    }
    std::printf("%d slots, %d ways\n", slots, ways);
    EXPECT_GT(ways, slots / 10);
}

}  // namespace
}  // namespace park_test
