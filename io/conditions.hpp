// What a question was asked with, in its answer: only what is not as usual.
#pragma once

#include "snug/driving.hpp"
#include "snug/io.hpp"

namespace snug {

/// Adds `driving` (`enter`, `clearance`, `curb_clearance`) and `parked` (`heading` [rad], `curb`) to an answer.
void add_conditions(Json& json, const Driving& driving, const Parked& parked);

}  // namespace snug
