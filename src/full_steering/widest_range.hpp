// Where to enter from: small errors in the heading do the least harm in the middle of the widest range.
#pragma once

#include <vector>

#include "snug/entry.hpp"

namespace snug {

/// The widest range with so many direction changes, the first of several; null when there is none.
inline const HeadingRange* widest_range(const std::vector<HeadingRange>& ranges, int direction_changes) {
    const HeadingRange* widest = nullptr;
    for (const HeadingRange& range : ranges) {
        if (range.direction_changes != direction_changes) continue;
        if (widest == nullptr || range.max - range.min > widest->max - widest->min) widest = &range;
    }
    return widest;
}

inline double middle(const HeadingRange& range) { return range.min + (range.max - range.min) / 2.0; }

}  // namespace snug
