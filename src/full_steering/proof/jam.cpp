#include "full_steering/proof/jam.hpp"

namespace snug::detail::proof {

namespace {

/// Where the cars are, but for how far any of them is from the one in the middle.
struct Cars {
    double left_x, left_y;    ///< turning centre backward
    double right_x, right_y;  ///< and forward
    double c, s, angle;
    double apart;  ///< of the rear axle's middles, |x| + |y|
    double wide;   ///< of the headings
};

/// A condition of an obstacle, and its rates with the turn of the car.
struct Rates {
    bool is_edge = false;
    double lacks = 0.0;     ///< at most [m]
    double backward = 0.0;  ///< what it lacks more for every radian
    double forward = 0.0;
    double reach = 0.0;

    /// How much the rates may change while the cars turn by so much.
    [[nodiscard]] double unsure(const Cars& cars, double turn, double radius) const {
        return reach * (cars.wide + turn) + (is_edge ? cars.apart + 2.0 * radius * turn : 0.0) + 1e-12 * reach;
    }
    [[nodiscard]] bool comes_to_hold() const { return backward < 0.0 && forward < 0.0; }
};

/// What blocks one way.
struct Blocker {
    bool usable = false;
    Rates last;              ///< the condition that blocks
    bool has_other = false;  ///< one more that may not hold yet
    Rates other;
    double holds_by = infinity;  ///< the rest, at least: no smaller turn can end them
    double until = 0.0;          ///< the stage's end

    /// After so much turning it blocks.
    [[nodiscard]] double blocks_after(const Cars& cars, double turn, double radius) const {
        if (!has_other) return 0.0;
        const double rate = -std::max(other.backward, other.forward) - other.unsure(cars, turn, radius);
        return rate > 0.0 ? other.lacks / rate * (1.0 + 1e-12) : infinity;
    }
};

Blocker blocker_of(const State& state, const Obstacle& backward, const Obstacle& forward, const Cars& cars,
                   double radius) {
    Blocker blocker;
    std::size_t index = 0;
    const std::vector<Stage>& stages = backward.stages;
    if (!(cars.angle < stages[0].angle)) return blocker;
    while (index + 1 < stages.size() && cars.angle <= stages[index + 1].angle) ++index;
    if (index + 1 == stages.size()) return blocker;
    const Stage& stage = stages[index];
    if (!(cars.angle + cars.wide + angle_error < stage.angle)) return blocker;
    blocker.until = stages[index + 1].angle + angle_error;
    for (std::size_t i = stage.first; i < stage.last; ++i) {
        const Condition& of = backward.conditions[i];
        const Crossing<double> one = crossing_of(of, cars.left_x, cars.left_y);
        const Crossing<double> other = crossing_of(forward.conditions[i], cars.right_x, cars.right_y);
        Rates rates;
        rates.reach = std::max(std::abs(one.a) + std::abs(one.b), std::abs(other.a) + std::abs(other.b)) + 2.0 * radius;
        const Rough now(state.backward ? of : forward.conditions[i], state.backward ? one : other, state, state.start);
        const double value = now.value;
        const double error = now.value_error;
        if (value > error) {
            blocker.holds_by = std::min(blocker.holds_by, (value - error) / (2.0 * radius + rates.reach));
            continue;
        }
        rates.is_edge = of.kind == Condition::inside;
        rates.lacks = std::max(error - value, 0.0);
        rates.backward = one.b * cars.c - one.a * cars.s;
        rates.forward = other.b * cars.c - other.a * cars.s;
        if (!blocker.usable) {
            blocker.usable = true;
            blocker.last = rates;
            continue;
        }
        if (blocker.has_other || !(blocker.last.comes_to_hold() || rates.comes_to_hold())) return {};
        blocker.has_other = true;
        blocker.other = rates;
        if (!rates.comes_to_hold()) std::swap(blocker.last, blocker.other);
    }
    return blocker;
}

/// No more than this can all turning to come be, if it is less than `turn`: infinite where nothing is known.
double turning(const Blocker& behind, const Blocker& ahead, const Cars& cars, double turn, double radius) {
    const double behind_unsure = behind.last.unsure(cars, turn, radius);
    const double ahead_unsure = ahead.last.unsure(cars, turn, radius);
    const double uses_behind = -behind.last.backward - behind_unsure;
    const double uses_ahead = -ahead.last.forward - ahead_unsure;
    if (!(uses_behind > 0.0 && uses_ahead > 0.0)) return infinity;
    const double k = std::max(ahead.last.backward + ahead_unsure, 1e-3 * uses_ahead) / uses_ahead;
    const double m = std::max(behind.last.forward + behind_unsure, 1e-3 * uses_behind) / uses_behind;
    const double both = k * m * (1.0 + 1e-12);
    if (!(both < 0.99)) return infinity;
    const double weight = std::sqrt(m / k);
    // What they lack when both block.
    const double free = std::max(behind.blocks_after(cars, turn, radius), ahead.blocks_after(cars, turn, radius));
    const double behind_lacks = behind.last.lacks + free * (behind.last.reach + radius);
    const double ahead_lacks = ahead.last.lacks + free * (ahead.last.reach + radius);
    const double potential = behind_lacks / uses_behind + weight * ahead_lacks / uses_ahead;
    return (free + potential * std::max(1.0, 1.0 / weight) / (1.0 - std::sqrt(both))) * (1.0 + 1e-12);
}

}  // namespace

bool Jam::jams(const State& state, const Steering& backward, const Steering& forward) const {
    Cars cars{};
    cars.c = state.start.c;
    cars.s = state.start.s;
    cars.angle = state.start.angle;
    cars.wide = state.start.off.size();
    cars.apart = state.x.span() + state.y.span() + 2.0 * radius_ * cars.wide;
    const double across = state.backward ? backward.across : forward.across;
    const double other_x = state.x.mid + across * cars.s;
    const double other_y = state.y.mid - across * cars.c;
    cars.left_x = state.backward ? state.x.mid : other_x;
    cars.left_y = state.backward ? state.y.mid : other_y;
    cars.right_x = state.backward ? other_x : state.x.mid;
    cars.right_y = state.backward ? other_y : state.y.mid;
    // By how much it is not parked, in headings: no point moves by more than this for every radian.
    const double speed = 2.0 * radius_ + size_;
    double height = -infinity;
    for (const Point& corner : frame_) height = std::max(height, corner.x * cars.s + (corner.y - radius_) * cars.c);
    const double far = (cars.left_y + height - cars.apart - speed * cars.wide) / speed - 1e-12;
    if (!(far > 0.0)) return false;
    std::array<Blocker, 3> blockers;
    for (const Met met : {front, rear, curb})
        blockers[met] = blocker_of(state, backward.of[met], forward.of[met], cars, radius_);
    for (const Blocker& behind : blockers) {
        if (!behind.usable || !(behind.last.backward < 0.0)) continue;
        for (const Blocker& ahead : blockers) {
            if (!ahead.usable || &ahead == &behind || !(ahead.last.forward < 0.0)) continue;
            const double turn = 2.0 * turning(behind, ahead, cars, 0.0, radius_) + 1e-15;
            if (!(turn < std::min({far, behind.holds_by, ahead.holds_by}))) continue;
            if (!(cars.angle - cars.wide - turn > std::max(behind.until, ahead.until))) continue;
            if (turning(behind, ahead, cars, turn, radius_) < turn) return true;
        }
    }
    return false;
}

}  // namespace snug::detail::proof
