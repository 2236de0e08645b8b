// One run of a car that errs.
#pragma once

#include <cstdint>

#include "drive/slots.hpp"
#include "snug/drive.hpp"

namespace snug {

/// From the start until parked, stuck or in contact, in the assistant's place. `number` and the seed make the run what it is.
/// `slots`: what is planned with while the slot is seen with errors, none where it is seen as it is.
DriveRun drive_run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options,
                   std::uint64_t number);

/// Is a car that stands there parked, to 1e-9 m?
bool stands_parked(const Car& car, const Place& place, const Pose& pose);

/// How near the car is to anything; negative when it overlaps something. [m]
double nearest_distance(const Car& car, const Place& place, const Pose& pose);

}  // namespace snug
