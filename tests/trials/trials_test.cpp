// The planners that the paper compares itself with: their maneuvers can be driven, and never beat the law they obey.
#include "snug/trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/refusals.hpp"
#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/entry.hpp"
#include "snug/min_slot.hpp"

namespace snug {
namespace {

using model::refusal;
using oracle::random_case;
using test::sample;

const Car zoe = find_car("renault-zoe").value();

Slot slot_of(double length, double width) { return Slot({.length = length, .width = width}); }

/// Everything wrong with a maneuver. One that backs in straight starts above the slot's corner, not at it.
std::vector<std::string> faults(const oracle::Case& asked, const Maneuver& maneuver) {
    std::vector<std::string> found = oracle::faults(asked, maneuver, maneuver.direction_changes());
    if (!maneuver.moves.empty() && maneuver.moves.front().steering_angle == 0.0) {
        std::erase_if(found, [](const std::string& fault) {
            return fault.find("off the slot's corner") != fault.npos || fault.find("first move steers") != fault.npos;
        });
    }
    return found;
}

/// A random question.
struct Asked {
    oracle::Case random;
    Car car;
    Slot slot;
    MaxSteerOptions options;
};

template <class Test>
void for_each_case(std::uint64_t seed, int count, Test check) {
    for (int i = 0; i < count; ++i) {
        const oracle::Case random = random_case(seed, static_cast<std::uint64_t>(i));
        SCOPED_TRACE(oracle::command_line(random));
        check(Asked{random, Car(random.car), Slot(random.slot), {200, random.driving}});
    }
}

Answer exact(const Asked& asked) {
    EntryOptions options;
    options.driving.clearance = asked.options.driving.clearance;
    options.driving.enter = asked.options.driving.enter;
    return entry(asked.car, asked.slot, options);
}

/// The first move out that undoes the maneuver's last one, in the words of ReversedTrials.
Direction against_last_move(const Maneuver& maneuver) {
    const bool goes_in = maneuver.moves.back().direction == maneuver.moves.front().direction;
    return goes_in ? Direction::forward : Direction::backward;
}

TEST(ReversedTrials, CanBeDrivenAndNeverNeedFewerChangesThanTheBestEntry) {
    int parked = 0;
    for_each_case(31, sample(100, 5000), [&](const Asked& asked) {
        const std::optional<Maneuver> maneuver = reversed_trials(asked.car, asked.slot, {}, asked.options);
        if (!maneuver) return;
        ++parked;
        EXPECT_EQ(faults(asked.random, *maneuver), std::vector<std::string>());
        const Answer best = exact(asked);
        // From above p the car may park where no possible entry position does.
        if (maneuver->moves.front().steering_angle == 0.0 && !best.parkable()) return;
        ASSERT_TRUE(best.parkable());
        EXPECT_GE(maneuver->direction_changes(), best.direction_changes);
    });
    EXPECT_GT(parked, sample(100, 5000) / 4);
}

TEST(ReversedTrials, FromTheBestManeuversGoalAreItsTimeReversal) {
    int parked = 0;
    int longer = 0;
    for_each_case(32, sample(100, 5000), [&](const Asked& asked) {
        const Answer best = exact(asked);
        if (!best.parkable()) return;
        ++parked;
        const ReversedTrials back{best.maneuver->goal(), against_last_move(*best.maneuver)};
        const std::optional<Maneuver> again = reversed_trials(asked.car, asked.slot, back, asked.options);
        if (!again) {
            ++longer;
            return;
        }
        EXPECT_EQ(faults(asked.random, *again), std::vector<std::string>());
        EXPECT_GE(again->direction_changes(), *best.direction_changes);
        if (again->direction_changes() > *best.direction_changes) ++longer;
    });
    EXPECT_GT(parked, sample(100, 5000) / 4);
    // Contacts that hang on rounding can come out differently on the way back.
    EXPECT_LE(longer, parked / 100);
}

TEST(ReversedTrials, FromTheGoalsFoundNeedNoMoreChangesThanFromTheGoalDeduced) {
    bool fewer = false;
    for (double length = 4.5; length < 5.801; length += 0.05) {
        SCOPED_TRACE(length);
        const Slot slot = slot_of(length, 2.0);
        const ReversedTrialsByGoal changes = reversed_trials_by_goal(zoe, slot);
        ASSERT_TRUE(changes.found && changes.deduced);
        EXPECT_EQ(changes.found, entry(zoe, slot).direction_changes);
        EXPECT_LE(*changes.found, *changes.deduced);
        fewer = fewer || *changes.found < *changes.deduced;
    }
    EXPECT_TRUE(fewer);
}

TEST(ReversedTrials, EndAtTheirGoalAndEnterAtTheSlotsCornerOrStraightAboveIt) {
    for (const double length : {5.0, 5.6, 5.8, 9.0}) {
        SCOPED_TRACE(length);
        const Slot slot = slot_of(length, 2.0);
        const Pose goal{0.7 - length, -1.0, 0.02};
        const std::optional<Maneuver> maneuver = reversed_trials(zoe, slot, {.goal = goal});
        ASSERT_TRUE(maneuver);
        EXPECT_EQ(maneuver->goal().x, goal.x);
        EXPECT_EQ(maneuver->goal().y, goal.y);
        EXPECT_EQ(maneuver->goal().heading, goal.heading);
        const Point corner = frame(zoe, maneuver->entry())[3];
        EXPECT_NEAR(corner.x, 0.0, 1e-9);
        EXPECT_GT(corner.y, -1e-9);
        if (maneuver->direction_changes() > 0) {
            EXPECT_LT(corner.y, 1e-9);
        }
    }
}

TEST(ParallelTrials, CanBeDrivenAndAreParallelAtEveryDirectionChange) {
    int parked = 0;
    for_each_case(33, sample(50, 3000), [&](const Asked& asked) {
        const std::optional<Maneuver> maneuver = parallel_trials(asked.car, asked.slot, {}, asked.options);
        if (!maneuver) return;
        ++parked;
        EXPECT_EQ(faults(asked.random, *maneuver), std::vector<std::string>());
        for (std::size_t i = 0; i + 1 < maneuver->moves.size(); ++i) {
            if (maneuver->moves[i].direction == maneuver->moves[i + 1].direction) continue;
            EXPECT_NEAR(maneuver->moves[i].end.heading, asked.slot.heading(), 1e-12);
        }
    });
    EXPECT_GT(parked, sample(50, 3000) / 4);
}

TEST(ParallelTrials, FarFromTheCurbAdvanceByTheWholeExtraLength) {
    const double extra = 0.5;
    const double radius = zoe.turning_radius();
    const std::optional<Maneuver> maneuver = parallel_trials(zoe, slot_of(zoe.length() + extra, 5.0));
    ASSERT_TRUE(maneuver);
    ASSERT_GT(maneuver->direction_changes(), 3);
    // Two arcs a trial, after the first arc, and a shorter last trial.
    ASSERT_EQ(maneuver->moves.size(), 1U + 2U * static_cast<unsigned>(maneuver->direction_changes()));
    for (std::size_t i = 1; i + 2 < maneuver->moves.size(); i += 2) {
        const double across = maneuver->moves[i].start.y - maneuver->moves[i + 1].end.y;
        EXPECT_NEAR(across, 2.0 * radius - std::sqrt(4.0 * radius * radius - extra * extra), 1e-8);
    }
}

TEST(ParallelTrials, EndAtTheirGoal) {
    for (const double x : {-4.7, -4.2, -3.6}) {
        const Pose goal{x, -1.05, 0.0};
        const std::optional<Maneuver> maneuver = parallel_trials(zoe, slot_of(5.4, 2.0), {goal});
        ASSERT_TRUE(maneuver);
        EXPECT_NEAR(maneuver->goal().x, goal.x, 1e-9);
        EXPECT_NEAR(maneuver->goal().y, goal.y, 1e-9);
        EXPECT_EQ(maneuver->goal().heading, 0.0);
    }
}

/// Shortest slot out of which the car gets at its first move, from a parallel goal at the rear neighbour with its right
/// side so far below the entry side.
double shortest_for_one_move(const Car& car, double depth) {
    const double width = depth + 0.2;  // room for the rear-right corner to swing out
    const auto parks = [&](double length) {
        const Pose goal{car.rear() - length, car.width() / 2.0 - depth, 0.0};
        return reversed_trials(car, slot_of(length, width), {.goal = goal}, {.max_changes = 0}).has_value();
    };
    double fails = car.length();
    double works = car.length() + 4.0;
    while (works - fails > 1e-9) {
        const double middle = (works + fails) / 2.0;
        (parks(middle) ? works : fails) = middle;
    }
    return works;
}

TEST(Blackburn, IsTheShortestSlotForOneMoveToAParallelGoalAtTheRearNeighbour) {
    for (const Car& car : catalogue()) {
        SCOPED_TRACE(car.name());
        for (const double depth : {car.width(), car.width() + 0.3})
            EXPECT_NEAR(car.length() + blackburn_extra_length(car, depth), shortest_for_one_move(car, depth), 1e-7);
    }
}

TEST(Blackburn, IsALittleMoreThanTheSolverNeedsInANarrowSlotAndMuchMoreThanInAWideOne) {
    // The solver parks at an angle, as soon as the car is inside: a few degrees where the slot leaves 0.2 m across, so
    // far from parallel in a wide slot that more than half a metre is saved.
    for (const Car& car : catalogue()) {
        SCOPED_TRACE(car.name());
        const double formula = car.length() + blackburn_extra_length(car, car.width());
        const std::optional<double> narrow = min_slot(car, car.width() + 0.2).length;
        const std::optional<double> wide = min_slot(car, car.width() + 2.0).length;
        ASSERT_TRUE(narrow && wide);
        EXPECT_LT(*narrow, formula);
        EXPECT_GT(*narrow, formula - 0.1);
        EXPECT_LT(*wide, formula - 0.5);
    }
}

TEST(Trials, MirrorWithTheSlot) {
    for (const double length : {4.6, 5.0, 5.4}) {
        const Slot right({.length = length, .width = 2.0});
        const Slot left({.length = length, .width = 2.0, .side = Side::left});
        const auto reversed = [](const Slot& slot) { return reversed_trials(zoe, slot)->direction_changes(); };
        const auto parallel = [](const Slot& slot) { return parallel_trials(zoe, slot)->direction_changes(); };
        EXPECT_EQ(reversed(right), reversed(left));
        EXPECT_EQ(parallel(right), parallel(left));
        EXPECT_EQ(reversed_trials(zoe, right)->entry().heading, -reversed_trials(zoe, left)->entry().heading);
    }
}

TEST(Trials, AnswerEntryWithAManeuverAndNoRanges) {
    for (const Baseline& trials : {Baseline(ReversedTrials{}), Baseline(ParallelTrials{})}) {
        EntryOptions options;
        const Answer answer = entry(zoe, slot_of(5.0, 2.0), options, trials);
        EXPECT_TRUE(answer.parkable());
        EXPECT_TRUE(answer.ranges.empty());
        ASSERT_TRUE(answer.maneuver);
        EXPECT_EQ(answer.direction_changes, answer.maneuver->direction_changes());
        options.max_changes = *answer.direction_changes - 1;
        EXPECT_FALSE(entry(zoe, slot_of(5.0, 2.0), options, trials).parkable());
        EXPECT_FALSE(entry(zoe, slot_of(4.0, 2.0), options, trials).parkable());
    }
}

TEST(Trials, RefuseImpossibleGoalsByName) {
    const Slot slot = slot_of(5.0, 2.0);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Pose> bad = {
        {nan, -1.0, 0.0},  {-4.0, nan, 0.0},  {-4.0, -1.0, nan}, {-4.0, 1e300, 0.0}, {-4.0, 0.0, 0.0},
        {-4.0, -1.2, 0.0}, {-3.0, -1.0, 0.0}, {-4.6, -1.0, 0.0}, {-4.0, -1.0, 0.2},  {-1.0, -1.0, 3.14159265358979}};
    for (const Pose& goal : bad) {
        SCOPED_TRACE(testing::Message() << goal.x << ' ' << goal.y << ' ' << goal.heading);
        const std::string reversed = refusal([&] { static_cast<void>(reversed_trials(zoe, slot, {.goal = goal})); });
        const std::string parallel = refusal([&] { static_cast<void>(parallel_trials(zoe, slot, {.goal = goal})); });
        EXPECT_NE(reversed.find("goal ("), reversed.npos) << reversed;
        EXPECT_NE(parallel.find("goal ("), parallel.npos) << parallel;
    }
    const MaxSteerOptions clear = {200, {.clearance = 0.1}};
    const Pose at_rear{zoe.rear() - 5.0, -1.0, 0.0};
    EXPECT_EQ(refusal([&] { static_cast<void>(reversed_trials(zoe, slot, {.goal = at_rear})); }), "");
    EXPECT_NE(refusal([&] { static_cast<void>(reversed_trials(zoe, slot, {.goal = at_rear}, clear)); }), "");
    EXPECT_NE(refusal([] { static_cast<void>(blackburn_extra_length(zoe, 40.0)); }), "");
}

TEST(Trials, RefuseWhatTheyWouldLeaveOut) {
    const auto ask = [](const Car& car, const SlotDimensions& slot, const MaxSteerOptions& options) {
        std::string reversed = refusal([&] { static_cast<void>(reversed_trials(car, Slot(slot), {}, options)); });
        const std::string parallel = refusal([&] { static_cast<void>(parallel_trials(car, Slot(slot), {}, options)); });
        EXPECT_EQ(reversed, parallel);
        return reversed;
    };
    const Car rounded(Outline::rounded(3.4, 0.7, 0.9, 0.4, 0.25), 2.6, 0.5, "rounded");
    EXPECT_EQ(ask(zoe, {5.0, 2.0}, {}), "");
    EXPECT_NE(ask(rounded, {5.0, 2.0}, {}).find("rectangle"), std::string::npos);
    EXPECT_NE(ask(zoe, {.length = 5.0, .width = 2.0, .rear_setback = 0.1}, {}).find("set-back"), std::string::npos);
    EXPECT_NE(ask(zoe, {.length = 5.0, .width = 2.0, .curb = Curb::low}, {}).find("low curb"), std::string::npos);
    EXPECT_NE(ask(zoe, {5.0, 2.0}, {200, {.curb_clearance = 0.1}, {}}).find("curb clearance"), std::string::npos);
    EXPECT_NE(ask(zoe, {5.0, 2.0}, {200, {}, {.heading = 0.1}}).find("parallel"), std::string::npos);
}

}  // namespace
}  // namespace snug
