// Problem 3 for the paper's strategy, one width (or length) and several counts: each answer is where the search for the
// next begins.
#pragma once

#include <vector>

#include "snug/min_slot.hpp"

namespace snug::detail {

/// The smallest slots for these maximums of direction changes, in rising order; `options.max_changes` is not looked at.
/// The answers for another width (or length) nearby, if given, save time: their headings are tried first.
std::vector<MinSlot> smallest_slots(const Car& car, double given, const std::vector<int>& max_changes,
                                    const MinSlotOptions& options, const std::vector<MinSlot>& neighbours = {});

}  // namespace snug::detail
