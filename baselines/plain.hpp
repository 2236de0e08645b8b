// What the baselines can be asked: a rectangular car between three straight sides.
#pragma once

#include <string>

#include "snug/car.hpp"
#include "snug/error.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// Throws Error where a baseline, named as a sentence begins, would have to leave something out.
inline void check_plain(const std::string& baseline, const Car& car, const Slot& slot, const Driving& driving,
                        const Parked& parked) {
    const auto refuse = [&](const std::string& what) { throw Error(baseline + " cannot " + what); };
    if (!car.is_rectangle()) refuse("drive a car that is no rectangle; give its width, front and rear alone");
    if (slot.front_setback() != 0.0 || slot.rear_setback() != 0.0)
        refuse("take set-back neighbours into account; leave the setbacks at 0");
    if (slot.curb() != Curb::high) refuse("take a low curb into account; make it high");
    if (driving.curb_clearance && *driving.curb_clearance != driving.clearance)
        refuse("keep a clearance of its own at the curb; leave the curb clearance out");
    if (!(parked == Parked{}))
        refuse("look at how parallel the car is or how near the curb; leave these conditions out");
}

}  // namespace snug::detail
