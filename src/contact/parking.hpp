// When, during a turn, is the car parked: the frame inside the slot, and what else counts as parked.
//
// Within a sector of headings every condition is of the form a c + b s + e <= 0; between two of their roots nothing changes.
#pragma once

#include <optional>

#include "contact/turning.hpp"

namespace snug::detail {

/// Only the height of the frame's highest corner decides: the slot's ends are guarded by the neighbours.
inline bool by_height_alone(const Problem& problem) {
    return problem.front_setback == 0.0 && problem.rear_setback == 0.0 &&
           problem.parked.heading >= limits::quarter_turn && std::isinf(problem.parked.curb);
}

/// A turning car: its outline, the turning centre, and how both change with the entry heading.
struct Turn {
    const TurningFrame* frame;
    const Problem* problem;
    double x, y;
    double x_slope = 0.0, y_slope = 0.0;
};

/// The least, over a clockwise turn, by which the condition that is missed most is missed [m, or rad for the heading].
struct Miss {
    double excess;
    double slope;  ///< with the entry heading
};
Miss least_miss(const Turn& turn, const QuarterHeading& from, const QuarterHeading& to, double from_slope,
                double to_slope);

/// The first stretch of a clockwise turn over which the car is parked; where it touches the entry side from above, to within
/// `allowed`, it is parked for a moment.
struct ParkedTurn {
    QuarterHeading from, to;
};
std::optional<ParkedTurn> first_parked(const Turn& turn, const QuarterHeading& from, const QuarterHeading& to,
                                       double allowed);

}  // namespace snug::detail
