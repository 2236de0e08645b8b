// Many slots on all cores: the same answers for any number of threads, and nothing shared between them. The thread
// sanitizer runs these tests.
#include <gtest/gtest.h>

#include <atomic>
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

void expect_same(const std::vector<MinSlotRow>& a, const std::vector<MinSlotRow>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].max_changes, b[i].max_changes);
        EXPECT_EQ(a[i].given, b[i].given);
        ASSERT_EQ(a[i].slot.has_value(), b[i].slot.has_value());
        if (!a[i].slot) continue;
        EXPECT_EQ(a[i].slot->length, b[i].slot->length);
        EXPECT_EQ(a[i].slot->width, b[i].slot->width);
        EXPECT_EQ(a[i].slot->entry_heading, b[i].slot->entry_heading);
    }
}

TEST(Sweep, AnswersAreTheSameForAnyNumberOfThreads) {
    const auto alone = min_lengths(car, widths, counts, {}, on(1));
    for (const int threads : {0, 2, 4}) expect_same(min_lengths(car, widths, counts, {}, on(threads)), alone);
    EXPECT_FALSE(alone.front().slot);
    EXPECT_TRUE(alone.back().slot);
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
    EXPECT_FALSE(min_lengths(car, widths, counts, {}, sweep).empty());
    EXPECT_GT(told, 0);
}

TEST(Sweep, GivesUpWhenTold) {
    SweepOptions sweep = on(4);
    sweep.progress = [](double) { return false; };
    EXPECT_TRUE(min_lengths(car, widths, counts, {}, sweep).empty());
}

TEST(Core, AnswersAnyNumberOfThreadsAtOnce) {
    const Slot slot({.length = 4.6, .width = 2.0});
    const EntryAnswer alone = entry(car, slot);
    ASSERT_TRUE(alone.parkable);
    std::atomic<int> same{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int k = 0; k < 20; ++k) {
                const EntryAnswer got = entry(car, slot);
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
