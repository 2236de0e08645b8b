// snug for users of OMPL: the slot as a validity checker, entry positions as a goal, maneuvers as paths.
//
// States are poses of the rear axle centre in the world frame, in OMPL's Reeds-Shepp space with the car's turning radius.
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <vector>

#include "snug/entry.hpp"

namespace snug {

/// The poses of a car whose rear axle centre stays in the box (world frame).
std::shared_ptr<ompl::base::ReedsSheppStateSpace> pose_space(const Car& car, const Box& box);

void set_pose(ompl::base::State* state, const Pose& pose);
Pose pose_of(const ompl::base::State* state);

/// Says which poses are free: the frame may touch the curb and the two neighbours, which fill all the ground beside the
/// road in front of the slot and behind it (see slot.hpp), but sink into none of them deeper than the tolerance.
class FreeOfTheSlot : public ompl::base::StateValidityChecker {
public:
    FreeOfTheSlot(const ompl::base::SpaceInformationPtr& space, const Car& car, const Slot& slot,
                  double tolerance = 1e-6);
    bool isValid(const ompl::base::State* state) const override;

private:
    Car car_;
    Slot slot_;
    double tolerance_;  // [m]
};

/// The positions from which entry() parks: the car at the slot's corner, with a heading in one of the ranges.
class EntryPositions : public ompl::base::GoalSampleableRegion {
public:
    /// `ranges`: what entry() answered, asked with the same clearance and end first (`enter`). Not empty.
    EntryPositions(const ompl::base::SpaceInformationPtr& space, const Car& car, const Slot& slot,
                   std::vector<HeadingRange> ranges, const MaxSteerOptions& options = {});

    /// Headings evenly from all ranges.
    void sampleGoal(ompl::base::State* state) const override;
    unsigned int maxSampleCount() const override;
    /// To the entry position of the nearest heading in the ranges.
    double distanceGoal(const ompl::base::State* state) const override;

    /// From an entry position into the slot.
    [[nodiscard]] Maneuver maneuver(const ompl::base::State* entry) const;

private:
    [[nodiscard]] double nearest_heading(const Pose& pose) const;

    Car car_;
    Slot slot_;
    std::vector<HeadingRange> ranges_;
    MaxSteerOptions options_;
    mutable ompl::RNG random_;
};

/// A maneuver as a path. OMPL joins two states by the shortest Reeds-Shepp curve, full steering or straight: states lie
/// as far apart as that curve is the maneuver (a whole move, mostly), but where it steers less they are `spacing` [m]
/// apart, and the curves between them leave the maneuver by a small part of that.
ompl::geometric::PathGeometric as_path(const Maneuver& maneuver, const ompl::base::SpaceInformationPtr& space,
                                       double spacing = 1e-3);

/// How often the direction changes along a path, driven as OMPL joins its states.
int direction_changes(const ompl::geometric::PathGeometric& path);

}  // namespace snug
