// What any maneuver can do where the paper's strategy cannot, told quickly.
#pragma once

#include <optional>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/limits.hpp"
#include "snug/slot.hpp"

namespace snug {

/// The fewest changes, however the car is steered, as far as a lattice of a five-hundredth of its length and two seconds tell:
/// fewest(), coarse enough to stand beside another answer. Empty where the question is beyond that search.
std::optional<Answer> any_maneuver(const Car& car, const Slot& slot, const Driving& driving = {},
                                   const Parked& parked = {}, int max_changes = limits::usual_changes);

}  // namespace snug
