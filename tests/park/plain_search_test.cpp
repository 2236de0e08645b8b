// The plain search never beats a proved count.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <string>

#include "park/plain_search.hpp"
#include "sample.hpp"
#include "snug/park.hpp"

namespace {

using namespace park_test;

TEST(PlainSearch, NeverBeatsTheLowerBoundOfPark) {
    const int count = snug::test::sample(4, 300);
    int close = 0, found = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = random_case(600000 + static_cast<std::uint64_t>(i));
        if (depth_in_place(asked.car, asked.place, asked.start) > -1e-3 ||
            outside_region(asked.place, asked.start) > -1e-3)
            continue;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + asked.described);
        snug::ParkOptions options;
        options.resolution = 0.04;
        options.max_changes = 6;
        options.roomiest = false;
        const auto claimed = park(asked.car, asked.place, asked.start, options);
        const int plain = PlainSearch(asked).changes(3);
        if (plain < 0) continue;
        ++found;
        EXPECT_GE(plain, claimed.lower_bound);
        close += claimed.direction_changes && plain <= *claimed.direction_changes + 1;
    }
    std::printf("found %d, within one change %d\n", found, close);
    if (count >= 40) {
        EXPECT_GT(found, count / 8);
    }
}

}  // namespace
