// Angles and lengths from + - * / and square roots alone. IEEE 754 rounds these correctly on every machine, which nobody
// promises of the standard library's sines: with functions of its own the core has the same bits everywhere.
//
// Errors are a unit in the last place or little more, for tangents two (tests/model/angles_test.cpp).
#pragma once

#include <cmath>

namespace snug::angles {

struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};

/// Beyond 60 turns the angle first loses its full turns as the double nearest 2 pi counts them, which is to change it by
/// less than its own rounding. NaN for what is not finite.
SineCosine sine_cosine(double angle);

inline double sin(double angle) { return sine_cosine(angle).sine; }
inline double cos(double angle) { return sine_cosine(angle).cosine; }
double tan(double angle);

/// The angle of the direction (x, y), in [-pi, pi]; 0 or pi for (0, 0), as for (x, 0). NaN where both are infinite.
double atan2(double y, double x);

inline double atan(double tangent) { return atan2(tangent, 1.0); }
/// NaN beyond [-1, 1].
inline double asin(double sine) { return atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine))); }
inline double acos(double cosine) { return atan2(std::sqrt((1.0 - cosine) * (1.0 + cosine)), cosine); }

/// For lengths of this world: squares that overflow are infinite.
inline double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

}  // namespace snug::angles
