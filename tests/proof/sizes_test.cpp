// The proof that no smaller slot will do, attacked: the oracle looks for a heading that parks in sizes it excludes.
#include <gtest/gtest.h>

#include <cstdio>

#include "min_slot/attack.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

snug::MinSlotOptions options_of(const MinSlotCase& asked) {
    snug::MinSlotOptions options;
    options.max_changes = asked.max_changes;
    options.driving = asked.asked.driving;
    options.parked = asked.asked.parked;
    options.front_setback = asked.asked.slot.front_setback;
    options.rear_setback = asked.asked.slot.rear_setback;
    options.curb = asked.asked.slot.curb;
    options.sought = asked.length_sought ? snug::Sought::length : snug::Sought::width;
    options.prove = true;
    return options;
}

/// Does the car end up with its nose the way it entered?
bool nose_first_still(const MinSlotCase& asked, double size, double heading) {
    const Run<double> driven = run(asked.problem<double>(size), heading, asked.max_changes);
    const double sign = asked.asked.driving.enter == snug::Enter::backward ? 1.0 : -1.0;
    return driven.parked() &&
           sign * driven.legs.back().path.at(driven.legs.back().length).heading >= -std::numbers::pi / 2;
}

struct Tried {
    int sizes = 0;
    double between = 0.0, open = 0.0;
};

std::string attack(MinSlotCase asked, std::uint64_t index, Tried& tried) {
    asked.min_range = 0.0;
    asked.max_changes %= 9;
    const snug::MinSlotOptions options = options_of(asked);
    const snug::MinSlot slot = min_slot(asked.asked.made_car(), asked.given(), options);
    const double least = asked.least();
    const double end = slot.size(options.sought).value_or(least + 4.0);
    if (!(slot.lower <= end)) return "lower is above the answer, " + asked.line(end);
    if (slot.open.empty() != (slot.lower == end)) return "lower is not where something is open, " + asked.line(end);
    tried.between += end - least;
    for (const snug::Sizes& open : slot.open) tried.open += open.max - open.min;
    Random random(index * 31 + 5);
    for (int i = 0; i < 12; ++i) {
        // Half of them close below the answer.
        const double away = i % 2 == 0 ? (end - least) * random.unit() : std::pow(10.0, random.between(-7.0, -1.0));
        const double size = end - away;
        bool left_out = size <= least;
        for (const snug::Sizes& open : slot.open) left_out = left_out || (open.min <= size && size <= open.max);
        if (left_out) continue;
        ++tried.sizes;
        const std::optional<double> heading = parking_heading(asked, size, 0.01, random.unit());
        if (!heading || !nose_first_still(asked, size, *heading)) continue;
        std::ostringstream text;
        text.precision(17);
        text << "heading " << *heading << " parks in " << size << ", " << asked.line(size);
        return text.str();
    }
    return {};
}

TEST(ProvedSizes, NothingSmallerParks) {
    Tried tried;
    const int cases = snug::test::sample(5, 1000);
    for (int i = 0; i < cases; ++i) {
        const std::uint64_t index = std::uint64_t(i);
        const MinSlotCase asked =
            i % 4 == 3 ? random_neighbours_case(502, index) : random_min_slot_case(501, index, Cars::any);
        EXPECT_EQ(attack(asked, index, tried), "") << "case " << i;
    }
    std::printf("%d slots, %d smaller sizes tried; %.3g m proved impossible, %.3g m left open\n", cases, tried.sizes,
                tried.between - tried.open, tried.open);
}

/// All sizes below the answer, but for some micrometres.
TEST(ProvedSizes, OfThePapersCar) {
    snug::MinSlotOptions options;
    options.max_changes = 3;
    options.prove = true;
    const snug::Car zoe({1.771, 3.427, 0.657, 2.588, 0.5759586531581288}, "");
    const snug::MinSlot slot = min_slot(zoe, 2.0, options);
    ASSERT_TRUE(slot.length);
    EXPECT_NEAR(*slot.length, 4.7923334, 1e-6);
    double open = 0.0;
    for (const snug::Sizes& sizes : slot.open) open += sizes.max - sizes.min;
    EXPECT_LT(open, 1e-5);
}

TEST(ProvedSizes, AreNotOfSomeHeadingsOnly) {
    snug::MinSlotOptions options;
    options.prove = true;
    options.min_range = 1e-3;
    EXPECT_THROW(min_slot(snug::Car({1.771, 3.427, 0.657, 2.588, 0.5759586531581288}, ""), 2.0, options), snug::Error);
}

}  // namespace
}  // namespace oracle
