// The entry position: where the paper's strategy begins, and at which headings it can.
//
// The point of the body ahead of the rear axle that is farthest from the first move's centre touches the front neighbour's
// corner (of a rectangle the front-right corner): what turns outside everything else just passes it.
#pragma once

#include <vector>

#include "contact/entering.hpp"
#include "contact/few.hpp"
#include "snug/answer.hpp"

namespace snug::detail {

/// That point, seen from the rear axle's middle.
Point entry_corner(const Problem& problem);

/// The entry position with this heading and that corner, in the entering frame.
Pose entry_pose(const Problem& problem, const Point& corner, double heading);

/// Headings in [0, pi/2] at which the body there overlaps nothing and the first move can start.
std::vector<Headings> possible_headings(const Problem& problem);

/// The body as it stands about its entry corner: what the check of an entry position needs, whatever the slot.
struct EntryShape {
    struct Edge {
        Point corner;  ///< where it begins, seen from the entry corner
        Point normal;  ///< outward
    };
    Point corner;         ///< the entry corner
    Point before, after;  ///< outward normals of the edges beside it
    Few<Edge, 4> edges;
    Few<Point, 4> at_curb;  ///< corners of what stops at the curb, seen from the entry corner; none if it is the body

    explicit EntryShape(const Problem& problem);
    /// With the directions of the body's edges.
    EntryShape(const Problem& problem, const Few<Point, 4>& ways);

    /// By how much the body clears what it could overlap at the heading with this direction, and the entry corner the front
    /// neighbour on the first move; negative if it does not [m]. Where it plainly clears something it may clear it by more.
    [[nodiscard]] double clears(const Problem& problem, double c, double s) const;
};

std::vector<Headings> possible_headings(const Problem& problem, const EntryShape& shape);
inline bool lies_in(const std::vector<Headings>& ranges, double heading) {
    for (const Headings& range : ranges)
        if (range.min <= heading && heading <= range.max) return true;
    return false;
}
/// Is this heading, with the direction (c, s), one of them? Mostly told without looking for them all.
bool is_possible(const Problem& problem, const EntryShape& shape, double heading, double c, double s);

}  // namespace snug::detail
