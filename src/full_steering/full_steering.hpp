// The paper's strategy as a machine: full steering until contact, then the other way round, move after move.
//
// State is the turning centre and the heading. A move keeps the centre and lowers the heading; at its end the centre
// jumps across the car to the other side. With Slope, the derivatives with respect to the entry heading come along.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/turning.hpp"
#include "model/angles.hpp"

namespace snug::detail {

/// Car and slot with everything that can be computed once.
struct FullSteering {
    Problem problem;
    TurningFrame backward;  ///< turning about the left centre
    TurningFrame forward;   ///< turning about the right centre

    explicit FullSteering(const Problem& of)
        : problem(of),
          backward(turning_frame(of.body, of.frame, of.radius)),
          forward(turning_frame(of.body, of.frame, -of.radius)) {}
};

/// What one move did.
struct FullMove {
    Meets meets = Meets::nothing;
    int quarter = 0;           ///< in which quarter turn the move ended
    unsigned ahead = 0;        ///< see QuarterContact
    bool stuck = false;        ///< it had no length
    double depth = 0.0;        ///< D_n: the least height of the frame's highest corner during the move [m]
    double depth_slope = 0.0;  ///< d depth / d entry heading
    /// How high above the curb the lowest corner's circle ends, in the first and the second quarter turn (negative: the
    /// corner meets the curb) [m]; NaN where the move does not sweep that point.
    std::array<double, 2> graze = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    double graze_slope = 0.0;  ///< d graze / d entry heading, for both
    /// Backward in the second quarter turn, tail up: how high the leftmost corner crosses the rear side, and how far
    /// behind the front corner of the slot the lowest corner sinks below the entry side [m]; NaN where it does not.
    double tail_clears = std::numeric_limits<double>::quiet_NaN();
    double nose_clears = std::numeric_limits<double>::quiet_NaN();
    double tail_slope = 0.0;  ///< their slopes
    double nose_slope = 0.0;
};

/// The car between two moves (or at its entry position).
class FullSteeringRun {
public:
    /// At the entry position with this heading in [0, pi/2].
    FullSteeringRun(const FullSteering& steering, double entry_heading) : steering_(&steering) {
        const auto [sine, cosine] = angles::sine_cosine(entry_heading);
        heading_ = {cosine, sine, 0};
        const double front = steering.problem.body.front();
        const double side = steering.problem.body.right() + steering.problem.radius;
        x_ = -front * heading_.c - side * heading_.s;
        y_ = -front * heading_.s + side * heading_.c;
        x_slope_ = -y_;
        y_slope_ = x_;
    }

    [[nodiscard]] const QuarterHeading& heading() const { return heading_; }
    [[nodiscard]] bool backward() const { return backward_; }
    /// Turning centre of the next move. [m]
    [[nodiscard]] double x() const { return x_; }
    [[nodiscard]] double y() const { return y_; }

    /// Drives the next move to its contact. A move without contact (a full circle) leaves the car where it was.
    template <bool Slope>
    FullMove drive() {
        const TurningFrame& frames = backward_ ? steering_->backward : steering_->forward;
        FullMove move;
        QuarterHeading now = heading_;
        const QuarterFrame& first_frame = frames[static_cast<std::size_t>(now.quarter & 3)];
        move.depth = top_height(first_frame, y_, now.c, now.s);
        if constexpr (Slope) move.depth_slope = y_slope_ + slope_of_height(first_frame.top, now) * heading_slope_;
        QuarterContact contact;
        for (int quarters = 0; quarters <= 4; ++quarters) {
            const QuarterFrame& frame = frames[static_cast<std::size_t>(now.quarter & 3)];
            contact = first_contact_in_quarter(frame, x_, y_, steering_->problem, now.c, now.s);
            // A full circle ends where it began, whatever rounding makes of touching there.
            if (quarters == 4 && contact.order < heading_.order() + 1e-4) contact.meets = Meets::nothing;
            if constexpr (Slope) note_graze(frame, now, contact, move);
            if (contact.meets != Meets::nothing) break;
            if (y_ + frame.top.y < move.depth) {
                move.depth = y_ + frame.top.y;
                move.depth_slope = y_slope_;
            }
            now = {0.0, 1.0, now.quarter + 1};
        }
        move.meets = contact.meets;
        move.ahead = contact.ahead;
        move.quarter = now.quarter;
        if (contact.meets == Meets::nothing) return move;

        const QuarterFrame& frame = frames[static_cast<std::size_t>(now.quarter & 3)];
        const bool same_quarter = now.quarter == heading_.quarter;
        if (same_quarter && contact.order == heading_.order()) {
            move.stuck = true;  // and the heading stays as it is
        } else {
            now.c = contact.c;
            now.s = contact.s;
            if constexpr (Slope) heading_slope_ = heading_slope_at(contact);
        }
        const double height = top_height(frame, y_, now.c, now.s);
        if (height < move.depth) {
            move.depth = height;
            if constexpr (Slope) move.depth_slope = y_slope_ + slope_of_height(frame.top, now) * heading_slope_;
        }
        if constexpr (Slope) {
            move.graze_slope = y_slope_;
            if (backward_ && now.quarter == 1) note_clearings(frame, move);
        }
        turn_over(now);
        return move;
    }

private:
    static double slope_of_height(const TurningCorner& corner, const QuarterHeading& at) {
        return corner.x * at.c - corner.y * at.s;
    }

    /// From the contact's equation by implicit differentiation.
    [[nodiscard]] double heading_slope_at(const QuarterContact& contact) const {
        switch (contact.meets) {
            case Meets::front_side:
            case Meets::rear_side: return x_slope_ / contact.across;
            case Meets::front_corner: return (x_slope_ * contact.s - y_slope_ * contact.c) / contact.across;
            case Meets::rear_corner: return (x_slope_ * contact.c + y_slope_ * contact.s) / contact.across;
            default: return -y_slope_ / contact.across;
        }
    }

    /// The lowest corner's circle reaches down to y - radius; note it where the move sweeps that point or meets the curb.
    void note_graze(const QuarterFrame& frame, const QuarterHeading& from, const QuarterContact& contact,
                    FullMove& move) const {
        if (from.quarter > 1 || frame.graze_order > from.order()) return;
        const bool stopped = contact.meets != Meets::nothing && contact.meets != Meets::curb;
        if (stopped && contact.order > frame.graze_order) return;
        move.graze[static_cast<std::size_t>(from.quarter)] = y_ + steering_->problem.width - frame.lowest.radius;
    }

    void note_clearings(const QuarterFrame& frame, FullMove& move) const {
        const TurningCorner& tail = frame.leftmost;
        const double along = -steering_->problem.length - x_;
        const double tail_across = -std::sqrt((tail.radius - along) * (tail.radius + along));
        const double tail_s = (tail_across * tail.x - along * tail.y) * tail.per_square;
        const double tail_c = (along * tail.x + tail_across * tail.y) * tail.per_square;
        if (tail_s >= 0.0 && tail_c >= 0.0) {
            move.tail_clears = y_ + tail_across;
            move.tail_slope = y_slope_ + x_slope_ * along / tail_across;
        }
        const TurningCorner& nose = frame.lowest;
        const double nose_along = std::sqrt((nose.radius - y_) * (nose.radius + y_));
        const double nose_s = (-y_ * nose.x - nose_along * nose.y) * nose.per_square;
        const double nose_c = (nose_along * nose.x - y_ * nose.y) * nose.per_square;
        if (nose_s >= 0.0 && nose_c >= 0.0) {
            move.nose_clears = x_ + nose_along;
            move.nose_slope = x_slope_ - y_slope_ * y_ / nose_along;
        }
    }

    void turn_over(const QuarterHeading& now) {
        heading_ = now;
        const double across = backward_ ? 2.0 * steering_->problem.radius : -2.0 * steering_->problem.radius;
        x_ += across * now.sine();
        y_ -= across * now.cosine();
        x_slope_ += across * now.cosine() * heading_slope_;
        y_slope_ += across * now.sine() * heading_slope_;
        backward_ = !backward_;
    }

    const FullSteering* steering_;
    QuarterHeading heading_;
    double x_ = 0.0;
    double y_ = 0.0;
    double x_slope_ = 0.0;
    double y_slope_ = 0.0;
    double heading_slope_ = 1.0;
    bool backward_ = true;
};

}  // namespace snug::detail
