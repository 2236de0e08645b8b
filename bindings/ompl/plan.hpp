// Planning with OMPL's RRTConnect from a pose in the street to a goal, as the example and the comparison do it.
#pragma once

#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

#include <optional>

#include "snug_ompl.hpp"

namespace snug {

/// The street along a slot on the right at the origin: 6 m wide, 10 m to either side. OMPL looks every centimetre.
inline ompl::base::SpaceInformationPtr street(const Car& car, const Slot& slot) {
    const Box box = {-slot.length() - 10.0, 10.0, -slot.width(), 6.0};
    auto space = std::make_shared<ompl::base::SpaceInformation>(pose_space(car, box));
    space->setStateValidityChecker(std::make_shared<FreeOfTheSlot>(space, car, slot));
    space->setStateValidityCheckingResolution(0.01 / space->getStateSpace()->getMaximumExtent());
    space->setup();
    return space;
}

/// Beside the front neighbour, one metre away from it.
inline Pose in_the_street(const Car& car) { return {2.0, car.width() / 2.0 + 1.0, 0.0}; }

/// Parallel, in the middle of the slot.
inline Pose parked_in_the_middle(const Car& car, const Slot& slot) {
    return {-(slot.length() + car.front() - car.rear()) / 2.0, -slot.width() / 2.0, 0.0};
}

struct Plan {
    ompl::geometric::PathGeometric path;
    double seconds;  ///< to the first solution; simplifying it takes at most half a second more
};

inline std::optional<Plan> plan(const ompl::base::SpaceInformationPtr& space, const Pose& start,
                                const ompl::base::GoalPtr& goal, double seconds) {
    ompl::geometric::SimpleSetup setup(space);
    setup.setPlanner(std::make_shared<ompl::geometric::RRTConnect>(space));
    ompl::base::ScopedState<> state(space);
    set_pose(state.get(), start);
    setup.setStartState(state);
    setup.setGoal(goal);
    setup.solve(seconds);
    if (!setup.haveExactSolutionPath()) return std::nullopt;
    const double needed = setup.getLastPlanComputationTime();
    setup.simplifySolution(0.5);
    return Plan{setup.getSolutionPath(), needed};
}

/// To a position from which snug enters the slot, and on with snug's maneuver.
inline std::optional<Plan> plan_to_entry(const ompl::base::SpaceInformationPtr& space, const Pose& start,
                                         const std::shared_ptr<EntryPositions>& entries, double seconds) {
    std::optional<Plan> found = plan(space, start, entries, seconds);
    if (found) found->path.append(as_path(entries->maneuver(found->path.getStates().back()), space));
    return found;
}

/// Straight to one parked pose.
inline std::optional<Plan> plan_to_parked(const ompl::base::SpaceInformationPtr& space, const Pose& start,
                                          const Pose& parked, double seconds) {
    auto goal = std::make_shared<ompl::base::GoalState>(space);
    ompl::base::ScopedState<> state(space);
    set_pose(state.get(), parked);
    goal->setState(state);
    return plan(space, start, goal, seconds);
}

}  // namespace snug
