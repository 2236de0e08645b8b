// How far a condition is from holding, for all cars of a box, and where it begins and ends to hold.
//
// Three answers to the first question, each cruder and quicker than the one before: Gap, a Form of the heading; Rough, that
// of the car in the middle and how far the others' may be from it; Blunt, the middle's with one error for all conditions.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/crossing.hpp"
#include "full_steering/proof/box.hpp"
#include "full_steering/proof/conditions.hpp"
#include "model/angles.hpp"

namespace snug::detail::proof {

/// The condition as a crossing, for a car with this turning centre, or the one in the middle of the box; it holds where gap() is positive. What a root needs
/// besides comes with heading_of().
inline Crossing<double> crossing_of(const Condition& of, double centre_x, double centre_y) {
    if (of.kind == Condition::inside) {
        const double x = centre_x - of.kx;
        const double y = centre_y - of.ky;
        return {x * of.x + y * of.y, y * of.x - x * of.y, -of.level, 0.0, 0.0};
    }
    return {of.a, of.b, -(of.px * centre_x + of.py * centre_y + of.k), 0.0, 0.0};
}
inline Crossing<double> crossing_of(const Condition& of, const State& state) {
    return crossing_of(of, state.x.mid, state.y.mid);
}

/// What a condition is for all cars of a box, in few plain numbers: that of the car in the middle, and how far from it the
/// others' may be, all that is not a straight line in the heading as one error. Quicker than Forms, and enough for most.
struct Rough {
    double value, pace;  ///< g and d g / d heading
    double value_error, pace_error;

    /// A heading turned by t has the value  value + pace sin t - (a c + b s) (1 - cos t), and one of another centre that
    /// plus normal . (that centre - this one).
    Rough(const Condition& of, const Crossing<double>& crossing, const State& state, const HeadingForm& at)
        : Rough(of, crossing, state, at, at.off.size(), at.off.noise()) {}
    Rough(const Condition& of, const Crossing<double>& crossing, const State& state, const HeadingForm& at, double wide,
          double noise) {
        const double reach = std::abs(crossing.a) + std::abs(crossing.b);
        const double rounding = of.error + 64.0 * unit * (reach + std::abs(crossing.d));
        double along = 0.0;
        double centre_error = 0.0;
        double centre_shift = 0.0;  // where the normal turns
        if (of.kind == Condition::inside) {
            along = (of.x * at.c - of.y * at.s) * state.x.along + (of.x * at.s + of.y * at.c) * state.y.along;
            centre_error = state.x_noise + state.y_noise;
            centre_shift = std::abs(state.x.along) + std::abs(state.y.along) + centre_error;
        } else {
            along = of.px * state.x.along + of.py * state.y.along;
            centre_error = std::abs(of.px) * state.x_noise + std::abs(of.py) * state.y_noise;
        }
        pace = crossing.b * at.c - crossing.a * at.s;
        value = gap(crossing, at.c, at.s) + pace * at.off.mid;
        along += pace * at.off.along;
        const double curved =
            (centre_shift + (0.5 * reach + std::abs(pace) * wide) * wide) * wide;  // |sin t - t| < |t|^3
        value_error = (std::abs(along) + std::abs(pace) * noise + curved + centre_error + rounding) * (1.0 + 1e-12);
        pace_error = (reach * wide + centre_shift + rounding) * (1.0 + 1e-12);
    }
    [[nodiscard]] bool holds() const { return value > value_error; }
    [[nodiscard]] bool fails() const { return -value > value_error; }
    [[nodiscard]] bool falls() const { return pace > pace_error; }  ///< as the car turns on
    [[nodiscard]] bool rises() const { return -pace > pace_error; }
};

/// The same once more for all conditions at one heading: no value and no pace is off by more than this. Quicker still, and
/// enough for most.
struct Blunt {
    double c, s;
    double value_error, pace_error;
};

/// What is the same for all headings of a move.
struct BluntErrors {
    double shift, reach, still;

    BluntErrors(const Steering& steering, const State& state) {
        const double centre = std::abs(state.x.mid) + std::abs(state.y.mid);
        shift = std::abs(state.x.along) + std::abs(state.y.along) + state.x_noise + state.y_noise;
        reach = std::max(steering.reach, 1.5 * (centre + steering.corner_reach));
        still = (shift + (2.0 * steering.error + 64.0 * unit * (reach + centre))) * (1.0 + 1e-12);
    }
    [[nodiscard]] Blunt at(const HeadingForm& heading) const {
        const double wide = heading.off.size();
        return {heading.c, heading.s, (still + (shift + (1.0 + (0.5 + wide) * wide) * reach) * wide) * (1.0 + 1e-12),
                (still + reach * wide) * (1.0 + 1e-12)};
    }
    [[nodiscard]] Blunt at(const Stage& stage) const { return {stage.c, stage.s, still, still}; }
};

/// To a length of one but for four roundings; false if it is not near.
inline bool make_unit(double& c, double& s) {
    const double square = c * c + s * s;
    if (!(std::abs(square - 1.0) < 1e-8)) return false;
    const double factor = 1.5 - 0.5 * square;
    c *= factor;
    s *= factor;
    return true;
}

inline double near_angle(double c, double s, double reference) {
    const double angle = angles::atan2(s, c);
    const double turns = reference - angle;
    return std::abs(turns) < 3.0 ? angle : angle + 2.0 * pi * std::round(turns / (2.0 * pi));
}

/// The condition near a heading, for all cars of the box.
Gap gap_of(const Condition& of, const State& state, double c, double s);

/// The heading at which the condition begins to hold (or ends), for all cars of the box; false unless they all have one
/// near each other. By Newton's way for intervals: where g changes its sign within `far` of the heading in the middle, and
/// its slope does not, there is exactly one root.
bool root_of(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found);
/// The same where that of the car in the middle, from heading_of(), is there already.
bool root_at(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found);

/// For the car in the middle of the box; false if there is none.
bool heading_of(const Condition& of, Crossing<double> crossing, bool begins, double& c, double& s);

/// The greatest value of g over a whole turn (or the least): sqrt(P^2 + Q^2) is between P and P + Q^2 / 2P.
Form extreme_of(const Condition& of, const State& state, bool greatest);

}  // namespace snug::detail::proof
