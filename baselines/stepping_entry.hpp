// Problems 1 and 2 answered by Algorithm 1 as printed, from sampled headings.
#pragma once

#include "snug/entry.hpp"

namespace snug {

/// entry() for the strategy Stepping. The ranges are runs of neighbouring sampled headings with the same count, their
/// edges are samples. `options.strategy` is not looked at; throws Error when `steps` are impossible.
Answer stepping_entry(const Car& car, const Slot& slot, const EntryOptions& options, const Stepping& steps);

}  // namespace snug
