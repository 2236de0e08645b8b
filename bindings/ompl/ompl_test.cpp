// OMPL agrees: its validity checking accepts every exported maneuver, and reaches the goal where snug says it is.
#include <gtest/gtest.h>

#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"
#include "snug_ompl.hpp"

namespace snug::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// Poses around a slot, with OMPL looking every millimetre.
ob::SpaceInformationPtr space_around(const Car& car, const Slot& slot, double tolerance = 1e-6) {
    const double reach = 3.0 * (car.length() + slot.length() + slot.width());
    const Point p = slot.corner();
    auto space =
        std::make_shared<ob::SpaceInformation>(pose_space(car, {p.x - reach, p.x + reach, p.y - reach, p.y + reach}));
    space->setStateValidityChecker(std::make_shared<FreeOfTheSlot>(space, car, slot, tolerance));
    space->setStateValidityCheckingResolution(1e-3 / space->getStateSpace()->getMaximumExtent());
    space->setup();
    return space;
}

/// A random car and a slot it fits, and how it may be entered.
struct Asked {
    oracle::Case chosen;
    Car car;
    Slot slot;
};

std::vector<Asked> cases(std::uint64_t seed, int count) {
    std::vector<Asked> all;
    for (std::uint64_t i = 0; static_cast<int>(all.size()) < count; ++i) {
        const oracle::Case chosen = oracle::random_case(seed, i);
        if (chosen.kind == "hopeless" || chosen.kind == "exotic") continue;
        all.push_back({chosen, Car(chosen.car), Slot(chosen.slot)});
    }
    return all;
}

void expect_accepted(const Maneuver& maneuver, const ob::SpaceInformationPtr& space) {
    og::PathGeometric path = as_path(maneuver, space);
    EXPECT_TRUE(path.check()) << path.getStateCount() << " states";
    EXPECT_NEAR(path.length(), maneuver.length(), 1e-6 * maneuver.length() + 1e-6);
    EXPECT_EQ(direction_changes(path), maneuver.direction_changes());
    const Pose first = pose_of(path.getState(0));
    const Pose last = pose_of(path.getState(static_cast<unsigned int>(path.getStateCount()) - 1));
    EXPECT_EQ(first.x, maneuver.entry().x);
    EXPECT_EQ(last.y, maneuver.goal().y);
}

TEST(Ompl, AcceptsEveryManeuverOfThePapersStrategy) {
    int parked = 0;
    for (const Asked& asked : cases(1, sample(300, 20000))) {
        SCOPED_TRACE(oracle::command_line(asked.chosen));
        EntryOptions options;
        options.driving.clearance = asked.chosen.driving.clearance;
        options.driving.enter = asked.chosen.driving.enter;
        const Answer answer = entry(asked.car, asked.slot, options);
        if (!answer.maneuver) continue;
        ++parked;
        expect_accepted(*answer.maneuver, space_around(asked.car, asked.slot));
    }
    EXPECT_GT(parked, sample(100, 5000));
}

TEST(Ompl, AcceptsEveryManeuverWithTheFewestChanges) {
    int parked = 0;
    for (const Asked& asked : cases(2, sample(20, 500))) {
        SCOPED_TRACE(oracle::command_line(asked.chosen));
        FewestOptions options;
        options.driving.clearance = asked.chosen.driving.clearance;
        options.driving.enter = asked.chosen.driving.enter;
        options.resolution = asked.car.length() / 500.0;
        options.max_changes = 20;
        const Answer answer = fewest(asked.car, asked.slot, options);
        if (!answer.maneuver) continue;
        ++parked;
        // Between two states a millimetre apart full steering takes the place of less, as OMPL counts it.
        const ob::SpaceInformationPtr space = space_around(asked.car, asked.slot);
        og::PathGeometric path = as_path(*answer.maneuver, space);
        EXPECT_TRUE(path.check()) << path.getStateCount() << " states";
        EXPECT_NEAR(path.length(), answer.maneuver->length(), 1e-3 * answer.maneuver->length());
        // So the curves between the states may sink in by a fraction of a millimetre, and no more.
        const FreeOfTheSlot nearly(space, asked.car, asked.slot, 3e-4);
        path.interpolate(static_cast<unsigned int>(path.getStateCount()) * 4);
        for (const ob::State* state : path.getStates()) EXPECT_TRUE(nearly.isValid(state));
    }
    EXPECT_GT(parked, 0);
}

TEST(Ompl, RefusesPosesTheOracleFindsOverlapping) {
    oracle::Random random(3);
    int refused = 0;
    const int count = sample(20000, 1000000);
    for (const Asked& asked : cases(3, count / 100)) {
        const ob::SpaceInformationPtr space = space_around(asked.car, asked.slot, 0.0);
        oracle::Case bare = asked.chosen;
        bare.driving = {};
        const auto problem = oracle::make_problem<double>(bare);
        ob::State* state = space->allocState();
        for (int i = 0; i < 100; ++i) {
            const Pose in_slot = {random.between(-1.5 * asked.slot.length(), 5.0),
                                  random.between(-asked.slot.width(), 2.0), random.between(-3.2, 3.2)};
            const Pose pose = asked.slot.to_world(in_slot);
            set_pose(state, pose);
            const double depth = oracle::depth(problem, oracle::into_slot(asked.chosen.slot, pose));
            if (std::abs(depth) < 1e-9) continue;
            refused += depth > 0.0 ? 1 : 0;
            EXPECT_EQ(space->isValid(state), depth < 0.0)
                << oracle::command_line(asked.chosen) << " at " << in_slot.x << ", " << in_slot.y << ", "
                << in_slot.heading << ", depth " << depth;
        }
        space->freeState(state);
    }
    EXPECT_GT(refused, count / 10);
    EXPECT_LT(refused, count * 9 / 10);
}

TEST(Ompl, SamplesEntryPositionsThatPark) {
    for (const Asked& asked : cases(4, sample(50, 2000))) {
        SCOPED_TRACE(oracle::command_line(asked.chosen));
        MaxSteerOptions driven;
        driven.driving.clearance = asked.chosen.driving.clearance;
        driven.driving.enter = asked.chosen.driving.enter;
        EntryOptions options;
        options.driving = driven.driving;
        options.max_changes = 12;
        const Answer answer = entry(asked.car, asked.slot, options);
        if (!answer.parkable()) continue;
        const ob::SpaceInformationPtr space = space_around(asked.car, asked.slot);
        const EntryPositions goal(space, asked.car, asked.slot, answer.ranges, driven);
        const auto problem = oracle::make_problem<double>(asked.chosen);
        const bool backward = driven.driving.enter == Enter::backward;
        ob::State* state = space->allocState();
        for (int i = 0; i < 20; ++i) {
            goal.sampleGoal(state);
            EXPECT_TRUE(space->isValid(state));
            EXPECT_TRUE(goal.isSatisfied(state)) << goal.distanceGoal(state);
            const oracle::Standing<double> standing(oracle::into_slot(asked.chosen.slot, pose_of(state)));
            const auto touched = backward ? problem.front_corner() : problem.rear_corner();
            EXPECT_LT(oracle::length(standing.at(oracle::touching_corner(problem)) - touched), 1e-9);
            EXPECT_LE(goal.maneuver(state).direction_changes(), 12);
            Pose off = pose_of(state);
            off.y += 0.01;
            set_pose(state, off);
            EXPECT_FALSE(goal.isSatisfied(state));
            EXPECT_GE(goal.distanceGoal(state), 1e-3);
        }
        space->freeState(state);
    }
}

TEST(Ompl, GoalWithoutRangesAndPathsWithoutSpacingAreRefused) {
    const Car car = *find_car("renault-zoe");
    const Slot slot({.length = 4.5, .width = 2.0});
    const ob::SpaceInformationPtr space = space_around(car, slot);
    EXPECT_THROW(EntryPositions(space, car, slot, {}), Error);
    const Maneuver maneuver = *entry(car, slot).maneuver;
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW((void)as_path(maneuver, space, bad), Error);
}

}  // namespace
}  // namespace snug::test
