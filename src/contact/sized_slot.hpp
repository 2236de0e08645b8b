// The slots that Problem 3 looks at: one dimension given, the other tried.
#pragma once

#include "snug/min_slot.hpp"

namespace snug::detail {

/// Throws Error unless the options and what is given are possible.
void check(const MinSlotOptions& options, double given);
/// The slot of that size.
Slot slot_of(const MinSlotOptions& options, double given, double size);
/// Nothing smaller than this holds the parallel car, with what it keeps from neighbours and curb [m].
double least_size(const Car& car, const MinSlotOptions& options);

}  // namespace snug::detail
