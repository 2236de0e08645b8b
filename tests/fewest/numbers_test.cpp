// Memory that is used again: rows keep what is written into them, whatever is taken and given back in between.
#include "all_maneuvers/numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <thread>
#include <utility>
#include <vector>

namespace {

using snug::detail::Numbers;
using snug::detail::NumberStore;

struct Row {
    Numbers<double> numbers;
    double mark;
};

bool is_whole(const Row& row) {
    return std::all_of(row.numbers.begin(), row.numbers.end(), [&](double number) { return number == row.mark; });
}

void keep_rows(const std::shared_ptr<NumberStore>& store, std::uint64_t begin) {
    std::mt19937_64 random(begin);
    const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    std::vector<Row> rows;
    for (int step = 0; step < 3000; ++step) {
        const double mark = step;
        if (rows.size() < 2 || below(5) < 2) {
            // Now and then longer than the store's longest piece.
            const std::size_t count = below(500) == 0 ? (std::size_t{3} << 20) + below(100) : 1 + below(20000);
            Numbers<double> fresh(store);
            if (below(2) == 0) fresh.push_back(mark);
            fresh.resize(count, mark);
            fresh.shrink_to_fit();
            rows.push_back({std::move(fresh), mark});
        } else if (below(3) == 0) {
            const Row copy = rows[below(rows.size())];
            rows[below(rows.size())] = copy;
        } else {
            const std::size_t gone = below(rows.size());
            ASSERT_TRUE(is_whole(rows[gone])) << "step " << step;
            std::swap(rows[gone], rows.back());
            rows.pop_back();
        }
        for (std::size_t i = 0; i < rows.size() && i < 3; ++i) ASSERT_TRUE(is_whole(rows[i])) << "step " << step;
    }
    for (const Row& row : rows) ASSERT_TRUE(is_whole(row));
}

TEST(Numbers, RowsKeepWhatIsWrittenIntoThem) { keep_rows(std::make_shared<NumberStore>(), 1); }

TEST(NumbersOnThreads, RowsKeepWhatIsWrittenIntoThem) {
    const auto store = std::make_shared<NumberStore>();
    std::thread other([&] { keep_rows(store, 2); });
    keep_rows(store, 3);
    other.join();
}

TEST(Numbers, MemoryGivenBackIsUsedAgain) {
    const auto store = std::make_shared<NumberStore>();
    const double* first = nullptr;
    for (int i = 0; i < 3; ++i) {
        const Numbers<double> one(store, 1000), other(store, 3000);
        if (i == 0) first = one.data();
        EXPECT_EQ(one.data(), first);
    }
    // Side by side they were one gap again.
    EXPECT_EQ(Numbers<double>(store, 4000).data(), first);
}

TEST(Numbers, WithoutAStoreComeFromTheSystem) {
    Numbers<int> numbers;
    for (int i = 0; i < 1000; ++i) numbers.push_back(i);
    const Numbers<int> copy = numbers;
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(copy[static_cast<std::size_t>(i)], i);
}

}  // namespace
