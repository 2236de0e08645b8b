// Problem 3 for one width (or length) and several counts: each answer is where the search for the next begins.
#pragma once

#include <optional>
#include <vector>

#include "snug/min_slot.hpp"

namespace snug::detail {

/// Which of a slot's dimensions is sought; the other is given.
enum class Sought { length, width };

/// The smallest slots for these maximums of direction changes, in rising order; `options.max_changes` is not looked at.
/// The answers for another width (or length) nearby, if given, save time: their headings are tried first.
std::vector<std::optional<MinSlot>> smallest_slots(const Car& car, Sought sought, double given,
                                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                                   const std::vector<std::optional<MinSlot>>& neighbours = {});

}  // namespace snug::detail
