// Can the answers to Problems 1 and 2 be trusted? Random cars and slots, every answer judged by the oracle.
//
// SNUG_SOAK=1 runs thousands; SNUG_SEED, SNUG_FIRST and SNUG_CASES choose which, to go on where a soak ended or to look
// at one case again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "contact/entering.hpp"
#include "contact/standing_room.hpp"
#include "oracle/aslant_cases.hpp"
#include "oracle/judged_cases.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

TEST(EntrySoak, TheOracleFindsNothingBetterNothingMoreAndNothingWrong) {
    JudgeOptions options;
    options.heading_step = snug::test::is_set("SNUG_SOAK") ? 1e-5 : 1e-4;  // and finer where contacts change
    judge_all(random_case, snug::test::sample(25, 2400), options);
}

/// Where the parallel car has no room it may park all the same.
TEST(EntrySoak, NorInSlotsThatHoldTheCarAslantOnly) {
    JudgeOptions options;
    options.heading_step = snug::test::is_set("SNUG_SMALL") ? 2e-3 : 1e-4;
    judge_all(aslant_case, snug::test::sample(6, 1200, 6), options);
}

/// Looked at in small steps the car takes no less room at any heading.
TEST(StandingRoom, IsTheLeastOverAllHeadings) {
    const int cases = snug::test::sample(40, 2000), steps = 4000;
    int narrower = 0;
    for (int i = 0; i < cases; ++i) {
        const Case asked = i % 2 == 0 ? random_outline_case(81, std::uint64_t(i)) : aslant_case(81, std::uint64_t(i));
        SCOPED_TRACE(command_line(asked));
        const auto entering =
            snug::detail::entering_problem(asked.made_car(), asked.made_slot(), asked.driving, asked.parked);
        const double least_width = snug::detail::least_width(entering, entering.length);
        const double least_length = snug::detail::least_length(entering, entering.width);
        // Entering backward or forward, it is the same car in the same slot.
        const Problem<double> problem = make_problem<double>(asked);
        const double most = std::min(asked.parked.heading, std::numbers::pi / 2);
        double width = std::numeric_limits<double>::infinity(), length = width, parallel = 0.0;
        for (int k = -steps; k <= steps; ++k) {
            const Standing<double> standing({0.0, 0.0, most * k / steps});
            double top = -1e9, low = 1e9, right = -1e9, left = 1e9;
            for (const Vec<double>& corner : problem.car.corners) {
                const Vec<double> p = standing.at(corner);
                top = std::max(top, p.y), right = std::max(right, p.x), left = std::min(left, p.x);
            }
            for (const Vec<double>& corner : problem.at_curb.corners) low = std::min(low, standing.at(corner).y);
            for (const Vec<double>& corner : problem.body.corners) {
                const Vec<double> p = standing.at(corner);
                if (p.y < top - problem.front_setback - 1e-9) right = std::max(right, p.x);
                if (p.y < top - problem.rear_setback - 1e-9) left = std::min(left, p.x);
            }
            if (right - left <= problem.length) width = std::min(width, top - low);
            if (top - low <= problem.width) length = std::min(length, right - left);
            if (k == 0) parallel = top - low;
        }
        narrower += least_width < parallel - 1e-3;
        EXPECT_LE(least_width, width + 1e-9);
        EXPECT_LE(least_length, length + 1e-9);
        // Nor much less, but where a corner comes beside a neighbour only just.
        if (asked.driving.clearance == 0.0 && std::isfinite(width)) {
            EXPECT_GT(least_width, width - 0.01);
        }
    }
    EXPECT_GT(narrower, 0);
}

}  // namespace
}  // namespace oracle
