// Which entry headings park with how many direction changes, exactly (Problems 1 and 2 for the paper's strategy).
#pragma once

#include <vector>

#include "full_steering.hpp"

namespace snug::detail {

/// A closed range of headings. [rad]
struct Headings {
    double min = 0.0;
    double max = 0.0;
};

/// A closed range of headings that all park with the same number of changes.
struct CountedHeadings {
    double min = 0.0;
    double max = 0.0;
    int changes = 0;
};

/// Headings in [0, pi/2] at which the frame, its corner on the slot's front corner, overlaps nothing and the first move
/// can start: at most two ranges, because the rear end may hit the rear neighbour at middle headings only.
std::vector<Headings> possible_headings(const Problem& problem);

/// All ranges that need at most `max_changes`; with `only_fewest`, those with the smallest count there is.
std::vector<CountedHeadings> heading_ranges(const FullSteering& steering, int max_changes, bool only_fewest);

}  // namespace snug::detail
