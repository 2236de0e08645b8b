// What must hold at once for a car to be in a neighbour, in the curb, or parked.
//
// A convex car overlaps a neighbour exactly when no axis separates them: its rightmost corner is past the neighbour's side,
// its lowest corner below the neighbour's top, and the neighbour's corner inside every edge of the chain between the two.
// So each obstacle is a set of conditions g > 0 that must hold at once, each a sinusoid of the heading; contact is the
// latest of their onsets, and the first obstacle the one whose contact has the greatest heading. Being parked is one more
// such set. Which corner is lowest, and so on, changes where an edge is parallel to an axis: between these headings, a
// quarter turn apart at most, lies a stage, and in a stage a condition holds during one spell, or during two when it holds
// at its beginning, ends and returns.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "full_steering/proof/enclosure.hpp"
#include "full_steering/proof/proof.hpp"

namespace snug::detail::proof {

/// One condition g > 0. Corners and edges are seen from the turning centre.
struct Condition {
    enum Kind : unsigned char {
        right_of,  ///< a corner of the car right of x = level
        left_of,   ///< left of x = level
        below,     ///< below y = level
        inside     ///< the point (kx, ky) inside an edge of the car with normal (x, y) at distance level
    };
    Kind kind = below;
    double x = 0.0, y = 0.0;
    double level = 0.0;
    double kx = 0.0, ky = 0.0;
    std::size_t edge = 0;  ///< which
    double error = 0.0;    ///< of g and of its slope, by rounding in the making and in the use of the above [m]
    double a = 0.0, b = 0.0, px = 0.0, py = 0.0, k = 0.0;  ///< of a corner: g = a c + b s + px X + py Y + k
    double radius = 0.0, per_square = 0.0;                 ///< and sqrt(a^2 + b^2), 1 / (a^2 + b^2)

    void make_linear() {
        switch (kind) {
            case right_of: a = x, b = -y, px = 1.0, k = -level; break;
            case left_of: a = -x, b = y, px = -1.0, k = level; break;
            case below: a = -y, b = -x, py = -1.0, k = level; break;
            case inside: break;
        }
        radius = std::sqrt(a * a + b * b);
        per_square = 1.0 / (a * a + b * b);
    }
};

/// Between two neighbouring headings at which an edge is parallel to an axis; headings fall from (c, s) on.
struct Stage {
    double c = 1.0, s = 0.0, angle = 0.0;  ///< its beginning
    std::size_t first = 0, last = 0;       ///< its conditions
    int entry_condition = -1;  ///< of the front neighbour: this and the one before it are zero at the entry position
    bool possible = true;      ///< false: cannot be met here
    mutable int likely = 0;    ///< the condition that failed when last asked: it is asked first
};

struct Obstacle {
    std::vector<Stage> stages;  ///< falling; after the last comes the first, a turn later
    std::vector<Condition> conditions;
    bool one_condition = false;

    [[nodiscard]] std::size_t next(std::size_t stage) const { return stage + 1 == stages.size() ? 0 : stage + 1; }
};

enum Met : unsigned char { front, rear, curb, goal };

/// Everything about one steering: obstacles seen from its turning centre.
struct Steering {
    double across = 0.0;  ///< twice the radius, negative to the right: from this centre to the next one
    std::array<Obstacle, 4> of;
    double reach = 0.0;         ///< of all corners of the car the farthest from the centre, as |x| + |y|
    double corner_reach = 0.0;  ///< of the slot's corners, from its origin
    double error = 0.0;         ///< of no condition it is greater

    void note_reach() {
        for (const Obstacle& obstacle : of) {
            for (const Condition& condition : obstacle.conditions) {
                error = std::max({error, condition.error, 64.0 * unit * std::abs(condition.level)});
                if (condition.kind == Condition::inside) {
                    corner_reach = std::max(corner_reach, std::abs(condition.kx) + std::abs(condition.ky));
                } else {
                    reach = std::max(reach, std::abs(condition.x) + std::abs(condition.y));
                }
            }
        }
    }
};

/// How far a polygon's corners reach from its origin, as |x| + |y|.
inline double size_of(const std::vector<Point>& corners) {
    double size = 0.0;
    for (const Point& corner : corners) size = std::max(size, std::abs(corner.x) + std::abs(corner.y));
    return size;
}

/// Backward, about the centre on the left, and forward, about the one on the right.
std::array<Steering, 2> steerings(const ProofProblem& problem);

}  // namespace snug::detail::proof
