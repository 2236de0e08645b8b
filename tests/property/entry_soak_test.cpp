// Can the answers to Problems 1 and 2 be trusted? Random cars and slots, every answer judged by the oracle.
//
// SNUG_SOAK=1 runs thousands; SNUG_SEED, SNUG_FIRST and SNUG_CASES choose which, to go on where a soak ended or to look
// at one case again.
#include <gtest/gtest.h>

#include "oracle/judged_cases.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

TEST(EntrySoak, TheOracleFindsNothingBetterNothingMoreAndNothingWrong) {
    JudgeOptions options;
    options.heading_step = snug::test::is_set("SNUG_SOAK") ? 1e-5 : 1e-4;  // and finer where contacts change
    judge_all(random_case, snug::test::sample(25, 2400), options);
}

}  // namespace
}  // namespace oracle
