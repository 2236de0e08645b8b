// How far a car can still sink: what is too high to be parked by any turning needs no more driving.
//
// Backward to the left and forward to the right alike, headings fall, and a point of the car then sinks by its distance
// ahead of the turning centre for every radian. Between a heading h and the steepest one at which the car can be parked,
// -s, a point (x, y) of the frame sinks no more than if it always took the way that lets it sink faster, which is backward
// while the heading is above parallel and forward below:
//     the integral over headings from -s to h of  max(0, x cos + (r - y) sin)  above,  max(0, x cos + (r + y) |sin|)  below.
// A frame is parked when its highest point is at most on the entry side. So where any of its points lies higher than it can
// sink, no further move parks, whatever is met. Along the faster way that condition does not change: it is one on the height
// of the turning centre alone.
#pragma once

#include "full_steering/proof/box.hpp"
#include "full_steering/proof/proof.hpp"

namespace snug::detail::proof {

class Sinking {
public:
    /// Parked at no heading below -steepest.
    Sinking(const ProofProblem& problem, double steepest);

    /// Can none of these cars be parked any more?
    [[nodiscard]] bool too_high(const State& state) const;

private:
    double highest_backward_ =
        infinity;  ///< heading 0 or more: of a turning centre from which the car can still park [m]
    double highest_forward_ = infinity;  ///< heading 0 or less
    /// A corner behind the rear axle sinks only at headings outside (-below, above): between them it must not be higher
    /// than what it sinks below.
    bool has_tail_ = false;
    Point tail_;
    double radius_ = 0.0;
    double tail_below_ = 0.0, tail_above_ = 0.0, tail_sinks_ = 0.0;
    double error_ = 0.0;
};

}  // namespace snug::detail::proof
