// Taylor's series, on arguments made small first: sines take away quarter turns, arc tangents the nearest of five angles.
// Whatever that rounds off is kept beside the result and comes back in the last addition.
#include "model/angles.hpp"

#include <array>
#include <cstddef>

namespace snug::angles {
namespace {

/// A number as the sum of two doubles.
struct Exact {
    double value = 0.0;
    double rest = 0.0;
};

constexpr Exact quarter_turn = {1.5707963267948966, 6.123233995736766e-17};

/// sin(r + rest) for r within an eighth of a turn.
double sine_of(Exact angle) {
    const double r = angle.value;
    const double z = r * r;
    const double w = z * z;
    // 1/3!, 1/5!, ...; terms of even and of odd place apart, so that they can be computed at the same time
    const double odd = -1.0 / 6.0 + w * (-1.0 / 5040.0 + w * (-1.0 / 39916800.0 + w * (-1.0 / 1307674368000.0)));
    const double even = 1.0 / 120.0 + w * (1.0 / 362880.0 + w * (1.0 / 6227020800.0 + w * (1.0 / 355687428096000.0)));
    return r + (r * z * (odd + z * even) + angle.rest * (1.0 - 0.5 * z));
}

double cosine_of(Exact angle) {
    const double r = angle.value;
    const double z = r * r;
    const double w = z * z;
    const double even = 1.0 / 24.0 + w * (1.0 / 40320.0 + w * (1.0 / 479001600.0 + w * (1.0 / 20922789888000.0)));
    const double odd = -1.0 / 720.0 + w * (-1.0 / 3628800.0 + w * (-1.0 / 87178291200.0));
    const double near = 1.0 - 0.5 * z;
    return near + (((1.0 - near) - 0.5 * z) + (w * (even + z * odd) - r * angle.rest));
}

/// What is left of an angle without `quarters` quarter turns. Their first two parts have so few digits that 256 times
/// them, and the first difference, are exact.
Exact without_quarters(double angle, double quarters) {
    constexpr double first = 0x1.921fb54442d00p+0;
    constexpr double second = 0x1.8469898cc5000p-48;
    constexpr double third = 0x1.701b839a25205p-92;
    const double coarse = angle - quarters * first;
    const double fine = coarse - quarters * second;
    return {fine, ((coarse - fine) - quarters * second) - quarters * third};
}

}  // namespace

SineCosine sine_cosine(double angle) {
    constexpr double eighth = 0.78539816339744831;
    if (angle == 0.0) return {angle, 1.0};  // most slots
    if (std::abs(angle) <= eighth) return {sine_of({angle, 0.0}), cosine_of({angle, 0.0})};
    if (!(std::abs(angle) < 380.0)) {
        angle = std::remainder(angle, 4.0 * quarter_turn.value);
        if (std::isnan(angle)) return {angle, angle};
    }
    const int quarters = static_cast<int>(angle * (1.0 / quarter_turn.value) + (angle < 0.0 ? -0.5 : 0.5));
    const Exact within = without_quarters(angle, quarters);
    const double s = sine_of(within);
    const double c = cosine_of(within);
    switch (quarters & 3) {
        case 0: return {s, c};
        case 1: return {c, -s};
        case 2: return {-s, -c};
        default: return {-c, s};
    }
}

double tan(double angle) {
    const SineCosine of = sine_cosine(angle);
    return of.sine / of.cosine;
}

double atan2(double y, double x) {
    // atan(i / 4)
    constexpr std::array<Exact, 5> known = {{{0.0, 0.0},
                                             {0.24497866312686414, 1.0698755618734451e-17},
                                             {0.4636476090008061, 2.2698777452961687e-17},
                                             {0.6435011087932844, 1.5834785051444286e-17},
                                             {0.7853981633974483, 3.061616997868383e-17}}};
    const bool steep = std::abs(y) > std::abs(x);
    const double larger = std::abs(steep ? y : x);
    const double smaller = std::abs(steep ? x : y);
    const double eight = 8.0 * smaller;
    const auto i = static_cast<std::size_t>(eight > larger) + static_cast<std::size_t>(eight > 3.0 * larger) +
                   static_cast<std::size_t>(eight > 5.0 * larger) + static_cast<std::size_t>(eight > 7.0 * larger);
    const double tangent = 0.25 * static_cast<double>(i);
    const double t = i != 0          ? (smaller - tangent * larger) / (larger + tangent * smaller)
                     : larger == 0.0 ? 0.0
                                     : smaller / larger;
    const double z = t * t;
    const double w = z * z;
    const double odd = -1.0 / 3.0 + w * (-1.0 / 7.0 + w * (-1.0 / 11.0 + w * (-1.0 / 15.0)));
    const double even = 1.0 / 5.0 + w * (1.0 / 9.0 + w * (1.0 / 13.0 + w * (1.0 / 17.0)));
    const double beyond = known[i].rest + t * z * (odd + z * even) + t;

    // The axis from which that angle is counted, one way or the other.
    const bool back = std::signbit(x);
    const double quarters = steep ? 1.0 : back ? 2.0 : 0.0;
    const double way = steep == back ? 1.0 : -1.0;
    const double axis = quarters * quarter_turn.value;
    const double coarse = axis + way * known[i].value;
    const double rest = (axis - coarse) + way * known[i].value;
    return std::copysign(coarse + (way * beyond + (rest + quarters * quarter_turn.rest)), y);
}

}  // namespace snug::angles
