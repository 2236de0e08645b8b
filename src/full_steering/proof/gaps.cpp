#include "full_steering/proof/gaps.hpp"

namespace snug::detail::proof {

Gap gap_of(const Condition& of, const State& state, double c, double s) {
    Gap gap;
    if (of.kind == Condition::inside) {
        const double nx = of.x * c - of.y * s;
        const double ny = of.x * s + of.y * c;
        const Form x = state.x - of.kx;
        const Form y = state.y - of.ky;
        const Form bend = nx * x + ny * y;
        const Form slope = nx * y - ny * x;
        const double error = of.error + 32.0 * unit * (x.size() + y.size());
        gap.value = (bend + of.level).with_rest(error);
        gap.slope = slope.mid;
        gap.slope_error = slope.span() + error;
        gap.bend = bend.mid;
        gap.bend_error = bend.span() + error;
        return gap;
    }
    const double vx = of.x * c - of.y * s;
    const double vy = of.x * s + of.y * c;
    switch (of.kind) {
        case Condition::right_of:
            gap.value = (state.x + (vx - of.level)).with_rest(of.error);
            gap.slope = -vy;
            gap.bend = vx;
            break;
        case Condition::left_of:
            gap.value = (-state.x + (of.level - vx)).with_rest(of.error);
            gap.slope = vy;
            gap.bend = -vx;
            break;
        default:
            gap.value = (-state.y + (of.level - vy)).with_rest(of.error);
            gap.slope = -vx;
            gap.bend = -vy;
            break;
    }
    gap.slope_error = of.error;
    gap.bend_error = of.error;
    return gap;
}

bool heading_of(const Condition& of, Crossing<double> crossing, bool begins, double& c, double& s) {
    double radius = of.radius;
    crossing.per_square = of.per_square;
    if (of.kind == Condition::inside) {
        const double square = crossing.a * crossing.a + crossing.b * crossing.b;
        radius = std::sqrt(square);
        crossing.per_square = 1.0 / square;
    }
    crossing.square = (radius - crossing.d) * (radius + crossing.d);
    if (!(crossing.square > 0.0)) return false;
    if (!begins) crossing.b = -crossing.b;  // where it ends, its mirror image begins
    const Root<double> at = root<Plain<double>>(crossing);
    c = at.c;
    s = begins ? at.s : -at.s;
    return true;
}

namespace {

/// Where a circle reaches beyond a line by a part of its radius, up to all of it: the angle between crossing the line and the
/// farthest point. But for angle_error.
double angle_beside_peak(double part) { return angles::atan2(std::sqrt(part * (2.0 - part)), 1.0 - part); }

/// The same as root_of() for a corner that reaches not far beyond a line: how far differs many times between the cars, so
/// that a straight line at the middle tells little of the others. The angle is a concave function of the part, which lies
/// above its chord and below its tangents.
bool root_beside_peak(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found) {
    if (of.kind == Condition::inside) return false;
    double c = of.a / of.radius;
    double s = of.b / of.radius;
    if (!make_unit(c, s)) return false;
    const Gap gap = gap_of(of, state, c, s);
    const double bend = std::abs(gap.bend) - gap.bend_error;
    const double aside = (std::abs(gap.slope) + gap.slope_error) / bend * (1.0 + 1e-12);  // of the farthest point
    if (!(bend > 0.0 && aside < 1e-9)) return false;
    const Form part = (1.0 / bend * gap.value).with_rest(aside * aside + 2.0 * gap.bend_error / bend + 8.0 * unit);
    const double least = part.mid - part.span() * (1.0 + 1e-14) - 1e-15 * std::abs(part.mid);
    const double most = part.mid + part.span() * (1.0 + 1e-14) + 1e-15 * std::abs(part.mid);
    if (!(least > 0.0 && most < 1.0 && most > least * 1.01)) return false;
    const double least_angle = angle_beside_peak(least);
    const double most_angle = angle_beside_peak(most);
    if (!(most_angle - least_angle > 1e-7)) return false;  // a straight line does, and angles are not that exact
    const double steep = (most_angle - least_angle) / (most - least);
    // The tangent is as steep as the chord, nearly, where the root is the mean of the two.
    const double root = 0.5 * (std::sqrt(least) + std::sqrt(most));
    const double between = root * root;
    const double tangent = 1.0 / std::sqrt(between * (2.0 - between));
    const double between_angle = angle_beside_peak(between);
    const double bulge = std::max({between_angle - (between - least) * tangent - least_angle,
                                   between_angle + (most - between) * tangent - most_angle, 0.0});
    const double middle = steep * (part.mid - least) + least_angle + 0.5 * bulge;
    const auto [sine, cosine] = angles::sine_cosine(begins ? middle : -middle);
    found.c = c * cosine - s * sine;
    found.s = s * cosine + c * sine;
    if (!make_unit(found.c, found.s)) return false;
    const double error = 0.5 * bulge + 4.0 * angle_error + 64.0 * unit * tangent * most + 2.0 * aside;
    found.off = (begins ? steep : -steep) * Form{0.0, part.along, part.first, part.second, part.rest};
    found.off = found.off.with_rest(error * (1.0 + 1e-12));
    found.angle = near_angle(found.c, found.s, reference);
    return true;
}

}  // namespace

bool root_of(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found) {
    return heading_of(of, crossing_of(of, state), begins, found.c, found.s) &&
           root_at(of, state, begins, reference, found);
}

bool root_at(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found) {
    if (!make_unit(found.c, found.s)) return false;
    const Gap gap = gap_of(of, state, found.c, found.s);
    if (begins != (gap.slope < 0.0)) return false;
    const double wide = gap.value.size();
    const double bend = std::abs(gap.bend) + gap.bend_error;
    const double steep = std::abs(gap.slope) - gap.slope_error;
    const double inner = steep * steep - 4.5 * bend * wide;
    if (!(steep > 0.0 && inner > 0.5 * steep * steep)) {
        if (root_beside_peak(of, state, begins, reference, found)) return true;
        if (!(steep > 0.0 && inner > 0.0)) return false;
    }
    const double far = 2.001 * wide / (steep + std::sqrt(inner));
    if (!(far < 0.5)) return false;
    const double least = steep - bend * far - 0.5 * std::abs(gap.slope) * far * far;
    if (!(least * far > wide * (1.0 + 1e-12))) return false;
    // slope * sin a = bend (1 - cos a) - value
    const double per_slope = 1.0 / gap.slope;
    const double square = 0.25 * far * far;
    const Form right = -gap.value + gap.bend * square;
    const double error = gap.slope_error * far + (std::abs(gap.bend) + 2.0 * gap.bend_error) * square * (1.0 + 1e-12) +
                         std::abs(gap.slope) * far * far * far * (1.0 / 6.0) + 4.0 * unit * right.size();
    found.off = per_slope * right.with_rest(error * (1.0 + 1e-12));
    found.angle = near_angle(found.c, found.s, reference);
    return true;
}

Form extreme_of(const Condition& of, const State& state, bool greatest) {
    const Crossing<double> crossing = crossing_of(of, state);
    const double radius = std::sqrt(crossing.a * crossing.a + crossing.b * crossing.b);
    double c = crossing.a / radius;
    double s = crossing.b / radius;
    if (!greatest) c = -c, s = -s;
    if (!(radius > 0.0) || !make_unit(c, s)) return {0.0, 0.0, 0.0, 0.0, infinity};
    const Gap gap = gap_of(of, state, c, s);
    const double slope = std::abs(gap.slope) + gap.slope_error;
    const double bend = std::abs(gap.bend) - gap.bend_error;
    if (!(bend > 0.0)) return {0.0, 0.0, 0.0, 0.0, infinity};
    const double beyond = slope * slope / (2.0 * bend) * (1.0 + 1e-12);
    return (gap.value + (greatest ? 0.5 : -0.5) * beyond).with_rest(0.5 * beyond * (1.0 + 1e-12));
}

}  // namespace snug::detail::proof
