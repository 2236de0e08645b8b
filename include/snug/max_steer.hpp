// The paper's strategy: full steering until contact, then the other way round, until parked (section 3.1).
#pragma once

#include <string_view>

#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/maneuver.hpp"
#include "snug/slot.hpp"

namespace snug {

/// How a run of the strategy ended.
enum class Outcome {
    parked,            ///< the frame is inside the slot
    no_entry,          ///< the heading is no possible entry position, or the first move cannot start
    stuck,             ///< in contact both ways: the next move has no length
    never_touches,     ///< the car turns until it stands straight across, nose to the curb, and never gets inside
    too_many_changes,  ///< still not parked after the allowed direction changes
};

struct MaxSteerOptions {
    int max_changes = 200;  ///< direction changes allowed, 0 to 100000
    Driving driving = {};
    Parked parked = {};  ///< what counts as parked
};

struct MaxSteerRun {
    Outcome outcome = Outcome::no_entry;
    Maneuver maneuver;  ///< the moves driven, however the run ended; empty for no_entry
};

/// Drives the strategy from the entry position with the given heading: `heading` [rad] in [0, pi/2] is measured from the
/// parallel heading, positive with the nose (entering forward: the tail) away from the slot. The last move of a parked
/// run is continued or shortened inside the slot to end as parallel to it as it can; this changes no count.
/// Throws Error when an option is impossible.
MaxSteerRun max_steer(const Car& car, const Slot& slot, double heading, const MaxSteerOptions& options = {});

/// Drives the strategy from any pose (world frame), first in this direction: the wheel to the road's side when the end that
/// goes in first leads, towards the slot otherwise. A pose that overlaps something is no entry.
MaxSteerRun max_steer(const Car& car, const Slot& slot, const Pose& pose, Direction direction,
                      const MaxSteerOptions& options = {});

/// "parked", "no entry", "stuck", "never touches", "too many changes"
std::string_view to_string(Outcome outcome);

}  // namespace snug
