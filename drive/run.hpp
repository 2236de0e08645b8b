// One run of a car that errs.
#pragma once

#include <cstdint>

#include "drive/slots.hpp"
#include "snug/drive.hpp"

namespace snug {

/// From the start until parked, stuck or in contact, in the assistant's place. `number` and the seed make the run what it is.
/// `slots`: what is planned with while the slot is seen with errors, none where it is seen as it is. `plan`: where its steering
/// turns only while it rolls, what it drives from the start.
DriveRun drive_run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options,
                   std::uint64_t number, const RollingManeuver* plan = nullptr);

/// From there to where the car is parked, with wheels that have that steering angle; it stands to steer only where no way is found
/// without. It ends where coming to rest a little off leaves the car parked most often. Nothing where no way is known.
std::optional<RollingManeuver> rolling_plan(const ParkMap& map, const Pose& from, double steering_angle,
                                            const DriveOptions& options, int most_work);

/// Is a car that stands there parked, to 1e-9 m?
bool stands_parked(const Car& car, const Place& place, const Pose& pose);

/// How near the car is to anything; negative when it overlaps something. [m]
double nearest_distance(const Car& car, const Place& place, const Pose& pose);

}  // namespace snug
