// The entry position: where the paper's strategy begins, and at which headings it can.
//
// The point of the body ahead of the rear axle that is farthest from the first move's centre touches the front neighbour's
// corner (of a rectangle the front-right corner): what turns outside everything else just passes it.
#pragma once

#include <vector>

#include "contact/entering.hpp"
#include "snug/answer.hpp"

namespace snug::detail {

/// That point, seen from the rear axle's middle.
Point entry_corner(const Problem& problem);

/// The entry position with this heading and that corner, in the entering frame.
Pose entry_pose(const Problem& problem, const Point& corner, double heading);

/// Headings in [0, pi/2] at which the body there overlaps nothing and the first move can start.
std::vector<Headings> possible_headings(const Problem& problem);
inline bool lies_in(const std::vector<Headings>& ranges, double heading) {
    for (const Headings& range : ranges)
        if (range.min <= heading && heading <= range.max) return true;
    return false;
}

/// By how much the body clears what it could overlap at the heading with this direction, and the entry corner the front
/// neighbour on the first move; negative if it does not [m].
double entry_clears(const Problem& problem, const Point& corner, double c, double s);

}  // namespace snug::detail
