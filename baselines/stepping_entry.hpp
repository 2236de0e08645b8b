// Problems 1 and 2 answered by Algorithm 1 as printed, from sampled headings.
#pragma once

#include "snug/entry.hpp"
#include "snug/stepping.hpp"

namespace snug {

/// entry() for Stepping, in a slot that holds the car. Throws Error when `steps` are impossible.
Answer stepping_entry(const Car& car, const Slot& slot, const EntryOptions& options, const Stepping& steps);

}  // namespace snug
