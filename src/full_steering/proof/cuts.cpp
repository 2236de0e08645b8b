#include "full_steering/proof/cuts.hpp"

namespace snug::detail::proof {

namespace {

constexpr double narrowest = 1e-13;     ///< boxes are not cut further [rad]
constexpr double end_of_range = 4e-12;  ///< that need not be known better [rad]

bool straight(const State& state, double ratio, double radius) {
    const double noise = state.x_noise + state.y_noise + radius * state.start.off.noise();
    const double along = std::abs(state.x.along) + std::abs(state.y.along) + radius * std::abs(state.start.off.along);
    return noise < 0.05 * ratio * along;
}

/// Over the t that are shift + ratio * (another), both known but for three roundings.
Form restricted(const Form& whole, double shift, double ratio) {
    Form part = whole;
    part.mid += whole.along * shift;
    part.along *= ratio;
    return part.with_rest(unit * (std::abs(part.mid) + 8.0 * std::abs(whole.along) * (std::abs(shift) + ratio)) +
                          underflow);
}

/// A part of a box. It need not be driven again up to where the whole was hardly more than straight lines, even for
/// this part.
void add_part(const Box& whole, double min, double max, int failed, const Driver& driver, double radius,
              std::vector<Box>& boxes) {
    Box& part = boxes.emplace_back(min, max);
    if (whole.doubtful) return;
    const double ratio = part.half / whole.half;
    for (int n = failed; n > 0 && n >= whole.driven; --n) {
        const State& state = driver.before(n);
        if (!straight(state, ratio, radius)) continue;
        part.driven = n;
        part.state = state;
        const double shift = (part.middle - whole.middle) / whole.half;
        part.state.x = restricted(state.x, shift, ratio);
        part.state.y = restricted(state.y, shift, ratio);
        part.state.start.off = restricted(state.start.off, shift, ratio);
        part.state.x_noise = part.state.x.noise();
        part.state.y_noise = part.state.y.noise();
        return;
    }
}

}  // namespace

void cut(const Box& box, const Outcome& outcome, const Driver& driver, double radius, std::vector<Box>& boxes) {
    const auto add = [&](double min, double max) { add_part(box, min, max, outcome.move, driver, radius, boxes); };
    const Failure& failure = outcome.failure;
    const double half = box.half;
    const double middle = box.middle;
    const Form& q = failure.quantity;
    if (failure.kind == Failure::at_root && q.along != 0.0 && q.noise() < infinity) {
        const double root = -q.mid / q.along;
        const double wide = 1.01 * q.noise() / std::abs(q.along) + 0.3 * narrowest / half;
        if (wide < 0.3 && std::abs(root) < 1.0 + wide) {
            const double at = std::clamp(root, -1.0, 1.0);
            const double a = middle + half * (at - wide);
            const double b = middle + half * (at + wide);
            if (b < box.max) add(b, box.max);
            add(std::max(a, box.min), std::min(b, box.max));
            if (failure.parking && changes_sign(q) && b - a < end_of_range) boxes.back().ends_in = outcome.move;
            if (a > box.min) add(box.min, a);
            return;
        }
    }
    double at = 0.5 * (box.min + box.max);
    if (failure.kind == Failure::beside_graze) {
        const double left = q.mid - q.along;
        const double right = q.mid + q.along;
        if (left * right > 0.0 && (left / right > 3.0 || right / left > 3.0)) {
            const double between = std::copysign(std::sqrt(left * right), left);
            at = middle + half * (between - q.mid) / q.along;
        }
    }
    if (!(at > box.min && at < box.max)) at = 0.5 * (box.min + box.max);
    add(at, box.max);
    add(box.min, at);
}

bool hopeless(const Box& box, const Failure& failure) {
    if (box.max - box.min <= narrowest) return true;
    // The end of a range, most likely: it need not be known better.
    if (failure.kind == Failure::at_root && box.max - box.min < end_of_range) return true;
    const Form& quantity = failure.quantity;
    const double noise = quantity.noise();
    return (box.max - box.min < end_of_range && std::abs(quantity.along) < 2.0 * noise) ||
           (box.max - box.min < 5e-11 && std::abs(quantity.along) < 0.1 * noise && std::abs(quantity.mid) < noise);
}

}  // namespace snug::detail::proof
