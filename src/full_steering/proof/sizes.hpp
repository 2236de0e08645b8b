// Problem 3, proved: in no slot smaller than the one found does the car park, but for sizes that are listed.
#pragma once

#include "snug/min_slot.hpp"

namespace snug::detail {

/// Fills in `lower` and `open` of an answer for full steering: strips of sizes from what holds the car up to the answer, each
/// shown not to park for all its sizes and headings at once.
void prove_smaller(const Car& car, double given, const MinSlotOptions& options, MinSlot& slot);

}  // namespace snug::detail
