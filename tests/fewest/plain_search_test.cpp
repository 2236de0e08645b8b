// A plain search over (x, y, heading), which knows nothing of dominance or lattices, never beats the claimed optimum.
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

#include "oracle/plain_search.hpp"
#include "sample.hpp"
#include "snug/fewest.hpp"

namespace {

using oracle::Case;

constexpr int most_changes = 5;

/// Cars of all kinds, in slots most of which need few changes.
Case coarse_case(std::uint64_t index) {
    oracle::Random random(41 * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL);
    Case chosen;
    choose_car(random, chosen);
    if (random.chance(0.2)) chosen.driving.clearance = random.between(0.005, 0.1);
    chosen.slot.length = chosen.car_length() * random.between(1.06, 1.4) + 2 * chosen.driving.clearance;
    chosen.slot.width = chosen.car.width * random.between(1.03, 1.35) + chosen.driving.clearance;
    return chosen;
}

TEST(PlainSearch, NeverBeatsTheClaimedOptimumAndOftenComesWithinOneChange) {
    const int count = snug::test::sample(40, 1000);
    int easy = 0, close = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = coarse_case(std::uint64_t(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + oracle::command_line(asked));
        snug::FewestOptions options;
        options.max_changes = most_changes;
        options.driving.clearance = asked.driving.clearance;
        options.resolution = 1e-3 * asked.car_length();
        options.roomiest = false;
        const snug::Answer claimed = fewest(snug::Car(asked.car), snug::Slot(asked.slot), options);
        oracle::PlainSearch search(asked, most_changes);
        const std::optional<int> found = search.changes();
        // Where the optimum is proved, this bound is it; a bound above what is allowed says that the car cannot park.
        if (found) {
            EXPECT_GE(*found, claimed.lower_bound) << "the way out, backward in time:\n" << search.way_out();
        }
        if (claimed.proved && claimed.lower_bound <= 3) {
            ++easy;
            if (found && *found <= claimed.lower_bound + 1) ++close;
        }
    }
    // A search that finds nothing proves nothing. It is nine of ten; a small sample says little.
    if (easy >= 10) {
        EXPECT_GE(close, easy * 3 / 4) << "of " << easy;
    }
}

}  // namespace
