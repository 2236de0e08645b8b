// The paper's strategy for many cases at a time: as many side by side as the processor's vectors hold.
#pragma once

#include <vector>

#include "snug/car.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

/// For each entry heading [rad] in [0, pi/2] the number of direction changes after which max_steer() parks, or -1 where
/// it does not. Exactly the same counts, whatever the processor.
/// Throws Error when a heading (named by its index) or an option is impossible.
std::vector<int> direction_changes(const Car& car, const Slot& slot, const std::vector<double>& headings,
                                   const MaxSteerOptions& options = {});

/// The same for many slots, entering each with its own heading: `headings[i]` goes with `slots[i]`.
/// Throws Error also when there are not as many headings as slots.
std::vector<int> direction_changes(const Car& car, const std::vector<Slot>& slots, const std::vector<double>& headings,
                                   const MaxSteerOptions& options = {});

}  // namespace snug
