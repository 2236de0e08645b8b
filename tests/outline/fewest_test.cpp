// The fewest changes of any outline among any neighbours: no plain search beats them, and their maneuvers can be driven.
#include <gtest/gtest.h>

#include "oracle/follower.hpp"
#include "oracle/plain_search.hpp"
#include "oracle/random_outlines.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

/// What the follower finds wrong. The first move need not be full left, as the paper's is, and where the car passes
/// above the neighbour's corner the entry position is there.
std::vector<std::string> faults_of(const Case& asked, const snug::Answer& answer) {
    std::vector<std::string> found = faults(asked, *answer.maneuver, *answer.direction_changes);
    std::erase_if(found, [](const std::string& fault) {
        return fault.find("the first move steers") != std::string::npos ||
               fault.find("off the slot's corner") != std::string::npos;
    });
    return found;
}

snug::Answer fewest_of(const Case& asked, int max_changes, double resolution) {
    snug::FewestOptions options;
    options.max_changes = max_changes;
    options.driving = asked.driving;
    options.parked = asked.parked;
    options.resolution = resolution;
    return snug::fewest(asked.made_car(), asked.made_slot(), options);
}

TEST(OutlineFewest, BoundsAgreeWithTheirManeuversAndWithFullSteering) {
    const int count = snug::test::sample(10, 2000);
    int proved = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_outline_case(71, std::uint64_t(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + command_line(asked));
        const double resolution = snug::test::is_set("SNUG_SOAK") ? 0.0 : 1e-3 * asked.car_length();
        const snug::Answer answer = fewest_of(asked, 15, resolution);
        proved += answer.proved;
        EXPECT_EQ(answer.maneuver.has_value(), answer.direction_changes.has_value());
        if (answer.direction_changes) {
            EXPECT_LE(answer.lower_bound, *answer.direction_changes);
            EXPECT_EQ(faults_of(asked, answer), std::vector<std::string>{});
        }
        if (asked.driving.enter == snug::Enter::forward) continue;
        snug::EntryOptions full_steering;
        full_steering.prove = false;
        full_steering.driving = asked.driving;
        full_steering.parked = asked.parked;
        const snug::Answer entries = snug::entry(asked.made_car(), asked.made_slot(), full_steering);
        if (entries.direction_changes) {
            EXPECT_LE(answer.lower_bound, *entries.direction_changes);
        }
    }
    std::printf("%d of %d proved\n", proved, count);
    if (count >= 40) {
        EXPECT_GE(proved, count * 3 / 4);
    }
}

/// Slots most of which need few changes.
Case coarse_case(std::uint64_t index) {
    Random random = random_of(72, index);
    Case chosen;
    choose_car(random, chosen);
    choose_outline(random, chosen);
    if (random.chance(0.2)) chosen.driving.clearance = random.between(0.005, 0.1);
    chosen.slot.length = chosen.car_length() * random.between(1.06, 1.4) + 2 * chosen.driving.clearance;
    chosen.slot.width = chosen.car.width * random.between(1.03, 1.35) + chosen.driving.clearance;
    choose_neighbours(random, chosen);
    return chosen;
}

TEST(OutlineFewest, APlainSearchNeverBeatsThemAndOftenComesWithinOneChange) {
    constexpr int most_changes = 5;
    const int count = snug::test::sample(20, 1000);
    int easy = 0, close = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = coarse_case(std::uint64_t(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + command_line(asked));
        const snug::Answer claimed = fewest_of(asked, most_changes, 1e-3 * asked.car_length());
        PlainSearch search(asked, most_changes);
        const std::optional<int> found = search.changes();
        if (found) {
            EXPECT_GE(*found, claimed.lower_bound) << "the way out, backward in time:\n" << search.way_out();
        }
        if (claimed.proved && claimed.lower_bound <= 3) {
            ++easy;
            if (found && *found <= claimed.lower_bound + 1) ++close;
        }
    }
    // A search that finds nothing proves nothing.
    std::printf("%d of %d easy ones within one change\n", close, easy);
    if (easy >= 10) {
        EXPECT_GE(close, easy / 2) << "of " << easy;
    }
}

}  // namespace
}  // namespace oracle
