#include "full_steering/proof/sinking.hpp"

#include "full_steering/proof/conditions.hpp"
#include "model/angles.hpp"

namespace snug::detail::proof {

Sinking::Sinking(const ProofProblem& problem, double steepest) : radius_(problem.radius) {
    const auto [s, c] = angles::sine_cosine(steepest);
    // Every number below is found with fewer than 64 roundings of sizes like these.
    error_ = 64.0 * unit * (size_of(problem.frame) + problem.radius);
    for (const Point& corner : problem.frame) {
        const double above = problem.radius - corner.y;
        const double below = problem.radius + corner.y;
        if (!(above > 0.0 && below > 0.0)) continue;
        const double x = corner.x;
        // Below parallel down to -s: x sin u - (r + y) cos u, where it rises with u; its least value is -hypot(x, r + y),
        // at the heading at which the corner is level with the centre.
        const double at_steepest = x * s - below * c;
        const bool sinks_below = x >= 0.0 || -x * c < below * s;
        const double least = x >= 0.0 ? -below : -angles::hypot(x, below);
        const double sinks = sinks_below ? std::max(at_steepest - least, 0.0) : 0.0;
        // Above: the corner is lowest under the centre where it is level with it, or at parallel.
        const double lowest = x >= 0.0 ? above : angles::hypot(x, above);
        highest_backward_ = std::min(highest_backward_, lowest + sinks + error_);
        if (x >= 0.0) highest_forward_ = std::min(highest_forward_, at_steepest + error_);
        if (x < 0.0 && (!has_tail_ || corner.y > tail_.y)) {
            has_tail_ = true;
            tail_ = corner;
            tail_below_ = angles::atan2(-x, below) - angle_error;
            tail_above_ = angles::atan2(-x, above) - angle_error;
            tail_sinks_ = sinks;
        }
    }
}

bool Sinking::too_high(const State& state) const {
    const HeadingForm& start = state.start;
    const double wide = start.off.size();
    const double least = start.angle - wide - angle_error;
    const double most = start.angle + wide + angle_error;
    const double height = state.y.mid - state.y.span();
    if (state.backward && least >= 0.0 && height > highest_backward_) return true;
    if (!state.backward && most <= 0.0 && height > highest_forward_) return true;
    if (!has_tail_ || !(most <= tail_above_ && least >= -tail_below_)) return false;
    const double y = tail_.y - (state.backward ? radius_ : -radius_);
    const double ahead = tail_.x * start.c - y * start.s;  // of the turning centre
    const double reach = std::abs(tail_.x) + std::abs(y);
    const double along = std::abs(state.y.along + ahead * start.off.along);
    const double noise = state.y.noise() + std::abs(ahead) * (start.off.noise() + std::abs(start.off.mid)) +
                         reach * wide * wide + error_ + 8.0 * unit * (std::abs(state.y.mid) + reach);
    return state.y.mid + tail_.x * start.s + y * start.c - tail_sinks_ > (along + noise) * (1.0 + 1e-12);
}

}  // namespace snug::detail::proof
