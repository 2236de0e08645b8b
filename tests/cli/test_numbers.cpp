// Numbers, lists and ranges as people type them.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "cli/numbers.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

const Quantity metres = {" m", -100.0, 100.0};

TEST(Numbers, ListsAreReadInOrder) {
    EXPECT_EQ(numbers("--width", "3", metres), (std::vector<double>{3.0}));
    EXPECT_EQ(numbers("--width", "3,-1.5,2e1", metres), (std::vector<double>{3.0, -1.5, 20.0}));
}

TEST(Numbers, RangesHoldBothEnds) {
    EXPECT_EQ(numbers("--width", "1:3:1", metres), (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(numbers("--width", "2:2:1", metres), (std::vector<double>{2.0}));
    EXPECT_EQ(numbers("--width", "0:1:0.4", metres), (std::vector<double>{0.0, 0.4, 0.8, 1.0}));
    EXPECT_EQ(numbers("--width", "-1:1:1", metres), (std::vector<double>{-1.0, 0.0, 1.0}));
    EXPECT_EQ(numbers("--width", "0:2:1,5,7:8:1", metres), (std::vector<double>{0.0, 1.0, 2.0, 5.0, 7.0, 8.0}));
}

TEST(Numbers, RangesOfHundredthsAreHundredths) {
    const std::vector<double> widths = numbers("--width", "1.78:2.40:0.01", metres);
    ASSERT_EQ(widths.size(), 63U);
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string typed = std::to_string((178 + i) / 100) + "." + std::to_string((178 + i) % 100 / 10) +
                                  std::to_string((178 + i) % 10);
        EXPECT_EQ(widths[i], std::strtod(typed.c_str(), nullptr));
    }
}

TEST(Numbers, FineRangesKeepTheirSteps) {
    const std::vector<double> all = numbers("--width", "0:1e-9:1e-10", metres);
    ASSERT_EQ(all.size(), 11U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(all[i], 1e-10 * static_cast<double>(i), 1e-15);
    }
}

TEST(Numbers, EverythingElseIsRefusedWithTheOption) {
    for (const char* text : {"",           ",",     "1,",     ",1",      "1,,2",    "1:2",     "1:2:",
                             ":2:1",       "1:2:0", "1:2:-1", "2:1:1",   "1:2:1:3", "1:2:nan", "1:2:1e-300",
                             "0:100:1e-9", "1,2:3", "101",    "1:101:1", "1;2",     "1 2",     " 1"}) {
        try {
            static_cast<void>(numbers("--width", text, metres));
            ADD_FAILURE() << "accepted: " << text;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("--width", 0), 0U) << error.what();
        }
    }
}

}  // namespace
}  // namespace snug::cli
