// The slots that Problem 3 looks at: one dimension given, the other tried.
#pragma once

#include "snug/min_slot.hpp"

namespace snug::detail {

/// Throws Error unless the options and what is given are possible.
void check(const MinSlotOptions& options, double given);
/// The slot of that size.
Slot slot_of(const MinSlotOptions& options, double given, double size);
/// Where a search begins, and how far it goes.
struct SizeRange {
    double least = 0.0;     ///< no smaller slot holds the car, however it stands; infinite where none does [m]
    double parallel = 0.0;  ///< and none the parallel car [m]
    double most = 0.0;      ///< [m]
};
SizeRange sizes_to_search(const Car& car, double given, const MinSlotOptions& options);

}  // namespace snug::detail
