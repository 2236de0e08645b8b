// Baselines: what the paper compares itself with, asked as entry() is. They share nothing with the solver but the model.
#pragma once

#include <string_view>
#include <variant>

#include "snug/answer.hpp"
#include "snug/entry.hpp"
#include "snug/stepping.hpp"
#include "snug/trials.hpp"

namespace snug {

/// How the car is driven between entry and goal, were it not by the solver.
using Baseline = std::variant<Stepping, ReversedTrials, ParallelTrials>;

/// entry() as a baseline answers it. Stepping samples headings: its ranges are runs of neighbouring samples with the same
/// count, their edges are samples. Trials start from a goal: they answer with a maneuver and no ranges. Nothing is proved;
/// of the callbacks stepping alone tells how far it is.
/// Throws Error when an option is impossible, and where a baseline would have to leave something out: it knows the paper's
/// rectangular car and slot.
Answer entry(const Car& car, const Slot& slot, const EntryOptions& options, const Baseline& baseline);

/// "stepping", "reversed-trials", "parallel-trials"
std::string_view to_string(const Baseline& baseline);

}  // namespace snug
