// The paper's section 4.1: what Vorobieva's several reversed trials cost, from their goal position and from ours.
#pragma once

#include <vector>

#include "paper/work.hpp"
#include "snug/trials.hpp"

namespace snug::paper {

struct TrialsInSlot {
    double length = 0.0;           ///< of the slot [m]
    ReversedTrialsByGoal trials;   ///< direction changes from both goals
    std::optional<int> max_steer;  ///< the fewest of the paper's strategy
};

/// Renault ZOE in slots 2.0 m wide and up to 5.8 m long.
std::vector<TrialsInSlot> trials_over_length(Work& work);

File trials_file(const std::vector<TrialsInSlot>& all);

}  // namespace snug::paper
