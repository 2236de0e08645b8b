// Many slots on all cores: the same answers for any number of threads, and nothing shared between them. The thread
// sanitizer runs these tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "snug/snug.hpp"
#include "snug/sweep.hpp"

namespace snug {
namespace {

const Car car = *find_car("renault-zoe");
const std::vector<double> widths = {1.75, 1.85, 1.9, 1.95, 2.0, 2.1};
const std::vector<int> counts = {0, 2, 5};

SweepOptions on(int threads) {
    SweepOptions options;
    options.threads = threads;
    return options;
}

void expect_same(const std::vector<MinSlot>& a, const std::vector<MinSlot>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i], b[i]) << i;
}

TEST(Sweep, AnswersAreTheSameForAnyNumberOfThreads) {
    const auto alone = min_slots(car, widths, counts, {}, on(1));
    for (const int threads : {0, 2, 4}) expect_same(min_slots(car, widths, counts, {}, on(threads)), alone);
    EXPECT_FALSE(alone.front().length);
    EXPECT_TRUE(alone.back().length);
}

TEST(Sweep, TellsItsProgressFromOneThreadAtATime) {
    std::atomic<int> inside{0};
    int told = 0;
    double last = 0.0;
    SweepOptions sweep = on(4);
    sweep.progress = [&](double part) {
        EXPECT_EQ(++inside, 1);
        EXPECT_GE(part, last);
        EXPECT_LE(part, 1.0);
        last = part;
        ++told;
        --inside;
        return true;
    };
    EXPECT_FALSE(min_slots(car, widths, counts, {}, sweep).empty());
    EXPECT_GT(told, 0);
}

TEST(Sweep, GivesUpWhenTold) {
    SweepOptions sweep = on(4);
    sweep.progress = [](double) { return false; };
    EXPECT_TRUE(min_slots(car, widths, counts, {}, sweep).empty());
}

TEST(Sweep, EntriesAreThoseOfOneSlotAtATime) {
    std::vector<Slot> slots;
    for (int i = 0; i < 24; ++i) slots.emplace_back(SlotDimensions{.length = 4.4 + 0.05 * i, .width = 1.75 + 0.02 * i});
    const auto alone = entries(car, slots, {}, on(1));
    const auto together = entries(car, slots, {}, on(4));
    ASSERT_EQ(alone.size(), slots.size());
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const Answer one = entry(car, slots[i], {.prove = false});
        EXPECT_EQ(alone[i].direction_changes, one.direction_changes);
        EXPECT_EQ(together[i].direction_changes, one.direction_changes);
        ASSERT_EQ(alone[i].widest.has_value(), one.parkable());
        ASSERT_EQ(together[i].widest.has_value(), one.parkable());
        if (!one.parkable()) continue;
        EXPECT_EQ(slots[i].to_slot(one.maneuver->entry()).heading,
                  alone[i].widest->min + (alone[i].widest->max - alone[i].widest->min) / 2.0);
        EXPECT_EQ(together[i].widest->min, alone[i].widest->min);
        EXPECT_EQ(together[i].widest->max, alone[i].widest->max);
    }
    EXPECT_FALSE(alone.front().direction_changes);
    EXPECT_TRUE(alone.back().direction_changes);
}

TEST(Sweep, CountsAreThoseOfTheBatch) {
    const Slot slot({.length = 4.6, .width = 2.0});
    std::vector<double> headings(9000);
    for (std::size_t i = 0; i < headings.size(); ++i) headings[i] = 0.3 + 4e-5 * static_cast<double>(i);
    const std::vector<Slot> slots(headings.size(), slot);
    const auto counts_alone = direction_changes(car, slot, headings);
    EXPECT_EQ(direction_changes(car, slot, headings, {}, on(4)), counts_alone);
    EXPECT_EQ(direction_changes(car, slots, headings, {}, on(4)), counts_alone);
    EXPECT_GT(*std::max_element(counts_alone.begin(), counts_alone.end()), 0);
    headings[8000] = 2.0;
    try {
        static_cast<void>(direction_changes(car, slot, headings, {}, on(4)));
        FAIL() << "a heading of 2 rad was taken";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("[8000]"), std::string::npos) << error.what();
    }
}

TEST(Sweep, GivesUpInTheMiddleOfARow) {
    const auto when_told = [](int calls) {
        auto left = std::make_shared<int>(calls);
        SweepOptions sweep = on(2);
        sweep.progress = [left](double) { return --*left > 0; };
        return sweep;
    };
    Stepping steps;
    steps.step = 1e-5;  // minutes for a row
    EXPECT_TRUE(min_slots_by_stepping(car, {2.0}, {5}, steps, 1e-3, {}, when_told(3)).empty());
    MinSlotOptions fine;
    fine.strategy = Strategy::fewest;
    fine.resolution = 2e-4;
    EXPECT_TRUE(min_slots(car, {1.8}, {40}, fine, when_told(3)).empty());
    EXPECT_TRUE(entries(car, {Slot({.length = 4.6, .width = 2.0})}, {}, when_told(3), steps).empty());
}

TEST(Core, AnswersAnyNumberOfThreadsAtOnce) {
    const Slot slot({.length = 4.6, .width = 2.0});
    const Answer alone = entry(car, slot);
    ASSERT_TRUE(alone.parkable());
    std::atomic<int> same{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 20; ++k) {
                const Answer got = entry(car, slot);
                same += got.direction_changes == alone.direction_changes && got.ranges.size() == alone.ranges.size() &&
                        got.ranges.front().min == alone.ranges.front().min &&
                        got.maneuver->length() == alone.maneuver->length();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(same, 80);
}

}  // namespace
}  // namespace snug
