#include "contact/standing_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/angles.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;

/// How far one corner is from another, along the slot or across it: a wave over the heading.
struct Wave {
    double cosine = 0.0, sine = 0.0;

    [[nodiscard]] double at(double heading) const {
        const auto [s, c] = angles::sine_cosine(heading);
        return cosine * c + sine * s;
    }
};

/// Takes the headings at which it has a value.
template <class Take>
void headings_at(const Wave& wave, double value, const Take& take) {
    const double most = angles::hypot(wave.cosine, wave.sine);
    if (!(most > 0.0) || std::abs(value) > most) return;
    const double peak = angles::atan2(wave.sine, wave.cosine);
    const double off = angles::acos(value / most);
    for (const double heading : {peak - off, peak + off}) take(std::remainder(heading, 2.0 * limits::half_turn));
}

Wave along(const Point& corner) { return {corner.x, -corner.y}; }
Wave across(const Point& corner) { return {corner.y, corner.x}; }
Wave operator-(const Wave& one, const Wave& other) { return {one.cosine - other.cosine, one.sine - other.sine}; }

/// Of the waves that count at a heading the highest.
class Highest {
public:
    explicit Highest(double heading) : heading_(heading) {}

    void consider(const Wave& wave) {
        const double here = wave.at(heading_);
        if (here <= value_) return;
        value_ = here;
        wave_ = wave;
    }
    [[nodiscard]] const Wave& wave() const { return wave_; }
    [[nodiscard]] double value() const { return value_; }

private:
    double heading_, value_ = -infinity;
    Wave wave_;
};

/// Headings between which the same corners reach farthest and lie deep enough to be beside the neighbours.
std::vector<double> heading_borders(const Problem& problem) {
    const double most = std::min(problem.parked.heading, limits::quarter_turn);
    std::vector<double> found = {-most, most};
    const auto add = [&](double heading) {
        if (std::abs(heading) < most) found.push_back(heading);
    };
    for (const Outline* outline : {&problem.frame, &problem.body, &problem.at_curb}) {
        const std::vector<Point>& corners = outline->corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point &from = corners[i], &to = corners[(i + 1) % corners.size()];
            for (const bool level : {true, false}) {
                const Point edge = {to.x - from.x, to.y - from.y};
                headings_at(level ? across(edge) : along(edge), 0.0, add);
            }
        }
    }
    if (!(problem.body == problem.frame))
        for (const Point& corner : problem.body.corners())
            for (const Point& top : problem.frame.corners())
                for (const double setback : {problem.front_setback, problem.rear_setback})
                    headings_at(across(top) - across(corner), setback, add);
    std::sort(found.begin(), found.end());
    return found;
}

/// The least of one extent where the other is no more than a limit. Between two borders both are waves that are positive, so the
/// least is at an end of where that is so.
double least(const Problem& problem, double limit, bool of_length) {
    double least = infinity;
    const std::vector<double> all = heading_borders(problem);
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const double middle = (all[i] + all[i + 1]) / 2.0;
        Highest front(middle), rear(middle), top(middle), low(middle);
        const Wave nothing;
        for (const Point& corner : problem.frame.corners()) {
            front.consider(along(corner));
            rear.consider(nothing - along(corner));
            top.consider(across(corner));
        }
        // The frame lies below the entry side, so that much of the body does, too.
        for (const Point& corner : problem.body.corners()) {
            const double below = top.value() - across(corner).at(middle);
            if (below >= problem.front_setback) front.consider(along(corner));
            if (below >= problem.rear_setback) rear.consider(nothing - along(corner));
        }
        for (const Point& corner : problem.at_curb.corners()) low.consider(nothing - across(corner));
        const Wave lengthwise = front.wave() - (nothing - rear.wave());
        const Wave crosswise = top.wave() - (nothing - low.wave());
        const Wave& sought = of_length ? lengthwise : crosswise;
        const Wave& other = of_length ? crosswise : lengthwise;
        const auto consider = [&](double heading) {
            if (heading < all[i] || heading > all[i + 1] || other.at(heading) > limit * (1.0 + rounding)) return;
            least = std::min(least, sought.at(heading) * (1.0 - rounding));
        };
        consider(all[i]);
        consider(all[i + 1]);
        headings_at(other, limit, consider);
    }
    return least;
}

}  // namespace

double least_length(const Problem& problem, double width) { return least(problem, width, true); }

double least_width(const Problem& problem, double length) { return least(problem, length, false); }

}  // namespace snug::detail
