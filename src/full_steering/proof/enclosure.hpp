// What a quantity can be while the entry heading runs through a box: a straight line in the heading, and an error.
//
// A Form stands for every function  mid + t * along + e * first + f * second + r  of t in [-1, 1] (where in the box the
// heading lies), with e and f in [-1, 1] and |r| <= rest. The symbols e and f are the two errors of the turning centre:
// whatever depends on the centre knows of them, so that they cancel where the centre cancels (Lohner's way round the
// wrapping of intervals, in the plane).
//
// Rounding. Doubles are added and multiplied with a relative error of at most 2^-53 of the result, but for products that
// underflow, which are off by less than 1e-300. Every operation here adds `unit` (a little more than 2^-53) times the
// sizes of the coefficients it rounded to `rest`. `rest` itself is a sum of at most eight numbers that are not negative,
// computed with as many roundings: the factor `upward`, 1 + 1e-15 > (1 + 2^-53)^8, makes it an upper bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace snug::detail::proof {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double quarter_turn = 1.57079632679489661923;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double unit = 1.12e-16;       ///< more than what rounding does to a result, relatively
inline constexpr double upward = 1.0 + 1e-15;  ///< more than what eight roundings do
inline constexpr double underflow = 1e-300;    ///< more than what is lost where a product underflows
inline constexpr double angle_error = 4e-15;   ///< of an angle within a few turns that was found as an arc tangent

struct Form {
    double mid = 0.0;
    double along = 0.0;
    double first = 0.0;
    double second = 0.0;
    double rest = 0.0;

    [[nodiscard]] double coefficients() const {
        return std::abs(mid) + std::abs(along) + std::abs(first) + std::abs(second);
    }
    /// How far from the straight line it can be.
    [[nodiscard]] double noise() const { return (std::abs(first) + std::abs(second) + rest) * upward; }
    /// How far from `mid` it can be.
    [[nodiscard]] double span() const { return (std::abs(along) + std::abs(first) + std::abs(second) + rest) * upward; }
    /// How far from zero it can be.
    [[nodiscard]] double size() const { return (std::abs(mid) + span()) * upward; }
    [[nodiscard]] bool positive() const { return mid > span(); }
    [[nodiscard]] bool negative() const { return -mid > span(); }
    [[nodiscard]] Form with_rest(double more) const { return {mid, along, first, second, (rest + more) * upward}; }
};

[[gnu::always_inline]] inline Form operator-(const Form& x) { return {-x.mid, -x.along, -x.first, -x.second, x.rest}; }

[[gnu::always_inline]] inline Form operator+(const Form& x, const Form& y) {
    Form z{x.mid + y.mid, x.along + y.along, x.first + y.first, x.second + y.second, 0.0};
    z.rest = (x.rest + y.rest + unit * z.coefficients()) * upward;
    return z;
}

[[gnu::always_inline]] inline Form operator-(const Form& x, const Form& y) { return x + -y; }

[[gnu::always_inline]] inline Form operator+(const Form& x, double y) {
    Form z = x;
    z.mid += y;
    z.rest = (x.rest + unit * std::abs(z.mid)) * upward;
    return z;
}

[[gnu::always_inline]] inline Form operator-(const Form& x, double y) { return x + -y; }

[[gnu::always_inline]] inline Form operator*(double k, const Form& x) {
    Form z{k * x.mid, k * x.along, k * x.first, k * x.second, 0.0};
    z.rest = (std::abs(k) * x.rest + unit * z.coefficients() + underflow) * upward;
    return z;
}

/// Everything that is x or y.
inline Form hull(const Form& x, const Form& y) {
    const Form apart = 0.5 * (x - y);
    return (0.5 * (x + y)).with_rest(apart.size());
}

/// max(x, y), across the kink: (x + y + |x - y|) / 2, and |h| on [-a, b] lies below its chord by at most 2 a b / (a + b).
inline Form larger(const Form& x, const Form& y) {
    const Form apart = x - y;
    if (!apart.negative() && !apart.positive()) {
        const double span = apart.span();
        const double a = (span - apart.mid) * upward;  // apart lies in [-a, b]
        const double b = (span + apart.mid) * upward;
        if (!(a + b > 0.0)) return x;
        const double steep = (b - a) / (a + b);
        const double lift = a * b / (a + b);
        // The chord is steep * apart + 2 lift; half of it, less half of [0, 2 lift].
        Form z = 0.5 * (x + y) + (0.5 * steep) * apart + 0.5 * lift;
        return z.with_rest(0.5 * lift + 8.0 * unit * (lift + apart.size()));
    }
    return apart.positive() ? x : y;
}

/// A heading: the direction of the vector (c, s), which is no longer or shorter than one by more than four roundings,
/// turned by `off`; `angle` is the angle of (c, s) but for angle_error.
struct HeadingForm {
    double c = 1.0;
    double s = 0.0;
    double angle = 0.0;
    Form off;
};

/// x - y.
[[gnu::always_inline]] inline Form difference(const HeadingForm& x, const HeadingForm& y) {
    return ((x.off - y.off) + (x.angle - y.angle)).with_rest(2.0 * angle_error);
}

/// A condition g > 0 near a heading (c, s): there it is `value`, and turned by a, it is exactly
///     g = value - bend (1 - cos a) + slope sin a,
/// where `slope` and `bend` are known but for slope_error and bend_error.
struct Gap {
    Form value;
    double slope = 0.0;
    double slope_error = 0.0;
    double bend = 0.0;
    double bend_error = 0.0;

    /// 1 - cos a lies in [0, a^2 / 2], and sin a differs from a by at most |a|^3 / 6.
    [[nodiscard]] Form at(const Form& off) const {
        const double far = off.size();
        const double square = 0.25 * far * far;
        Form z = value + slope * off + -bend * square;
        return z.with_rest(slope_error * far + (std::abs(bend) + 2.0 * bend_error + unit * std::abs(bend)) * square +
                           std::abs(slope) * far * far * far * (1.0 / 6.0));
    }
    /// d g / d heading there: slope cos a - bend sin a.
    [[nodiscard]] Form pace(const Form& off) const {
        const double far = off.size();
        return (-bend * off + slope)
            .with_rest(slope_error + bend_error * far + 0.5 * std::abs(slope) * far * far +
                       std::abs(bend) * far * far * far * (1.0 / 6.0));
    }
};

}  // namespace snug::detail::proof
