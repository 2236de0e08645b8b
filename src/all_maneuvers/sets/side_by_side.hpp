// Two things done at the same time.
#pragma once

#include <functional>

#include "all_maneuvers/sets/outer_sets.hpp"

namespace snug::detail::sets {

/// Does part 0 on this thread and part 1 on another if they may go side by side, else one after the other. Each watches with what
/// it is given; only this thread asks `watch`, and once that throws, the other one is told to stop.
void side_by_side(bool may, const Watching& watch, const std::function<void(int part, const Watching&)>& act);

}  // namespace snug::detail::sets
