// The public question, which is proved unless it says otherwise.
#include "snug/entry.hpp"

#include <gtest/gtest.h>

#include "snug/max_steer.hpp"

namespace snug {
namespace {

Answer proved(const CarDimensions& car, double length, double width, std::optional<int> most = {},
              double clearance = 0.0) {
    EntryOptions options;
    options.max_changes = most;
    options.driving.clearance = clearance;
    return entry(Car(car, ""), Slot({.length = length, .width = width}), options);
}

TEST(ProvedEntry, OfRangesThatAQuickSearchMissed) {
    const Answer nine =
        proved({1.6966474020276665, 4.2402365169053038, 0.88159571123864877, 3.3376308396997216, 0.55338414573502426},
               5.4677352067547744, 3.4450439909676072);
    EXPECT_TRUE(nine.proved);
    EXPECT_EQ(nine.direction_changes, 9);
    const Answer eleven =
        proved({1.6583475745325489, 1.1038735380480147, 0.022468896530309673, 0.96990573304500127, 0.83846274154652822},
               1.9331919065846606, 1.979006323047134);
    EXPECT_TRUE(eleven.proved);
    EXPECT_EQ(eleven.direction_changes, 11);
    const Answer twelve =
        proved({2.046231289248821, 2.4339476763744257, 2.561157263571463, 2.4762755379543098, 0.51788495371386445},
               5.5432260074639812, 4.2031541170433613, 12, 0.014278330291301534);
    EXPECT_TRUE(twelve.proved);
    ASSERT_EQ(twelve.ranges.size(), 2U);
    EXPECT_NEAR(twelve.ranges[1].min, 0.92067, 1e-5);
    EXPECT_NEAR(twelve.ranges[1].max, 0.92312, 1e-5);
}

TEST(ProvedEntry, ClaimsNothingThatRoundingDecides) {
    const Answer tangent =
        proved({2.3407496286221248, 1.6296087239970856, 0.25579434428378178, 1.1524775538288863, 0.8189386842086086},
               3.1454425525267018, 2.6626856784916404);
    EXPECT_FALSE(tangent.parkable());
    EXPECT_TRUE(tangent.ranges.empty());
}

/// A single heading, as good as: 8e-13 rad wide.
TEST(ProvedEntry, ListsWhatIsTooNarrowToClaim) {
    const Car car({1.370913965386644, 3.594917688255497, 1.0983338683615604, 3.235742146367956, 0.8112025073762099});
    const Slot slot({.length = 5.491881517462855, .width = 1.5548834607640432});
    const double heading = 0.3376831163222257;
    EXPECT_EQ(max_steer(car, slot, heading).maneuver.direction_changes(), 13);
    for (const bool prove : {false, true}) {
        EntryOptions options;
        options.max_changes = 14;
        options.prove = prove;
        const Answer answer = entry(car, slot, options);
        EXPECT_FALSE(answer.parkable());
        ASSERT_EQ(answer.undecided.size(), 1U) << prove;
        EXPECT_LT(answer.undecided[0].min, heading);
        EXPECT_GT(answer.undecided[0].max, heading);
        EXPECT_LT(answer.undecided[0].max - answer.undecided[0].min, 5e-12);
    }
}

TEST(ProvedEntry, OfACarThatCannotParkLeavesOutOnlySlivers) {
    const Answer none = proved({1.771, 3.427, 0.657, 2.588, 0.5759586531581288}, 4.8, 1.84, 50);
    EXPECT_TRUE(none.proved);
    EXPECT_FALSE(none.parkable());
    EXPECT_EQ(none.lower_bound, 51);
    double open = 0.0;
    for (const Headings& part : none.undecided) open += part.max - part.min;
    EXPECT_LT(open, 1e-9);
}

/// Its frame is inside after one change, but with the nose to the back.
TEST(ProvedEntry, ACarThatHasTurnedAwayDoesNotPark) {
    const Answer away =
        proved({1.5792432338673024, 1.3979861666891027, 1.6197356658764881, 1.1943719313804786, 1.0870284839916595},
               3.896762195001338, 2.5063651388410038, {}, 0.033556534256964803);
    EXPECT_TRUE(away.proved);
    EXPECT_FALSE(away.parkable());
    EXPECT_EQ(away.lower_bound, 201);
}

}  // namespace
}  // namespace snug
