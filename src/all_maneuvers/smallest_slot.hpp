// Problem 3 over all maneuvers: between two sizes, both proved.
#pragma once

#include <optional>

#include "snug/min_slot.hpp"

namespace snug::detail {

/// The smallest slot; it parks in one of size `known`, if that is given.
MinSlot smallest_slot(const Car& car, double given, const MinSlotOptions& options, std::optional<double> known);

/// Whether the question is the paper's, so that its strategy's answer is worth asking for first.
bool is_plain(const Car& car, double given, const MinSlotOptions& options);

}  // namespace snug::detail
