// The one equation behind every contact, for numbers of one kind: see crossing.inl.
#pragma once

#include <cmath>

namespace snug::detail {

/// What the equations need to know of a number type; here of plain numbers. A mask of one is a bool.
template <class Number>
struct Plain {
    using Real = Number;
    using Mask = bool;
    static constexpr bool alone = true;

    static Real set(double value) { return Real(value); }
    static Real sqrt(const Real& value) { return std::sqrt(value); }
    static Real minus(const Real& value) { return -value; }
    static Real abs(const Real& value) { return std::abs(value); }
    static Real least(const Real& a, const Real& b) { return b < a ? b : a; }
    static Real select(bool mask, const Real& yes, const Real& no) { return mask ? yes : no; }
    static bool both(bool a, bool b) { return a && b; }
    static bool either(bool a, bool b) { return a || b; }
    static bool opposite(bool a) { return !a; }
    static bool never() { return false; }
    /// Is there nothing left to look at? Leaving early pays.
    static bool none(bool mask) { return !mask; }
    static bool rarely(bool mask) { return mask; }
};

#define SNUG_INLINE inline
#define SNUG_LAMBDA
#include "contact/crossing.inl"
#undef SNUG_INLINE
#undef SNUG_LAMBDA

/// The direction of a heading.
struct Bearing {
    double c, s;
    [[nodiscard]] double order() const { return s - c; }
};

/// Takes both directions at which a c + b s = d; none where they do not exist.
template <class Take>
void roots(double a, double b, double d, Take take) {
    const double whole = a * a + b * b;
    const double radius = std::sqrt(whole);
    const double square = (radius - d) * (radius + d);
    if (!(square >= 0.0) || whole == 0.0) return;
    const Root<double> inward = root<Plain<double>>({a, b, d, square, 1.0 / whole});
    take(Bearing{inward.c, inward.s});
    const Root<double> outward = root<Plain<double>>({a, -b, d, square, 1.0 / whole});
    take(Bearing{outward.c, -outward.s});
}

}  // namespace snug::detail
