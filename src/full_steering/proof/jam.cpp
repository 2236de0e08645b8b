#include "full_steering/proof/jam.hpp"

#include "model/angles.hpp"

namespace snug::detail::proof {

namespace {

/// Where the cars are, and where they may come to be with a turn of at most `turn`.
struct Cars {
    double left_x, left_y;    ///< turning centre backward, of the car in the middle
    double right_x, right_y;  ///< and forward
    double radius;
    double apart;        ///< of the rear axle's middles now, |x| + |y|, from that of the car in the middle
    double most, least;  ///< headings, all the time
    double turn;
    std::array<Point, 2> ends;  ///< cosine and sine of the two

    /// How far a sinusoid of the heading can be from its chord.
    [[nodiscard]] double bent(double reach) const { return reach * (0.125 * (most - least) * (most - least) + 1e-12); }
};

struct Range {
    double least, most;
};

/// What a condition lacks now, at most, and how that changes with the turn.
struct Rates {
    double lacks = 0.0;
    Range backward{}, forward{};
    [[nodiscard]] bool comes_to_hold() const { return backward.most < 0.0 && forward.most < 0.0; }
};

Range rate(const Condition& of, const Crossing<double>& crossing, const Cars& cars) {
    const double one = crossing.b * cars.ends[0].x - crossing.a * cars.ends[0].y;
    const double other = crossing.b * cars.ends[1].x - crossing.a * cars.ends[1].y;
    double unsure = cars.bent(std::abs(crossing.a) + std::abs(crossing.b)) + of.error;
    // That of an edge depends on where the centre is: the axle moves by no more than the turn times the radius.
    if (of.kind == Condition::inside) unsure += cars.apart + 4.0 * cars.radius * (cars.turn + (cars.most - cars.least));
    return {std::min(one, other) - unsure, std::max(one, other) + unsure};
}

/// What blocks one way.
struct Blocker {
    bool usable = false;
    Rates last;                 ///< the condition that blocks
    double blocks_after = 0.0;  ///< so much turning, when the other one has come to hold
};

Blocker blocker_of(const State& state, const Obstacle& backward, const Obstacle& forward, const Cars& cars) {
    const std::vector<Stage>& stages = backward.stages;
    std::size_t index = 0;
    while (index + 1 < stages.size() && cars.most <= stages[index + 1].angle + angle_error) ++index;
    if (index + 1 == stages.size()) return {};
    const Stage& stage = stages[index];
    if (!(cars.most + angle_error < stage.angle && cars.least - angle_error > stages[index + 1].angle)) return {};
    Blocker blocker;
    bool has_other = false;
    Rates other;
    for (std::size_t i = stage.first; i < stage.last; ++i) {
        const Condition& seen_left = backward.conditions[i];
        const Condition& seen_right = forward.conditions[i];
        const Crossing<double> from_left = crossing_of(seen_left, cars.left_x, cars.left_y);
        const Crossing<double> from_right = crossing_of(seen_right, cars.right_x, cars.right_y);
        const Rough now(state.backward ? seen_left : seen_right, state.backward ? from_left : from_right, state,
                        state.start);
        Rates rates;
        rates.backward = rate(seen_left, from_left, cars);
        rates.forward = rate(seen_right, from_right, cars);
        rates.lacks = std::max(now.value_error - now.value, 0.0);
        if (now.value - now.value_error > cars.turn * std::max(rates.backward.most, rates.forward.most) && now.holds())
            continue;  // and goes on holding
        if (!blocker.usable) {
            blocker.usable = true;
            blocker.last = rates;
            continue;
        }
        if (has_other) return {};
        has_other = true;
        other = rates;
    }
    if (!has_other) return blocker;
    if (!other.comes_to_hold()) std::swap(other, blocker.last);
    if (!other.comes_to_hold()) return {};
    blocker.blocks_after = other.lacks / -std::max(other.backward.most, other.forward.most) * (1.0 + 1e-12);
    return blocker;
}

/// At most so much turning is to come in `moves` moves, or in any number: if it is less than the turn the rates are for.
struct Turning {
    double soon, ever;
};
Turning turning(const Blocker& behind, const Blocker& ahead, double enough, bool backward_first, int moves) {
    const double uses_behind = -behind.last.backward.most;
    const double uses_ahead = -ahead.last.forward.most;
    if (!(uses_behind > 0.0 && uses_ahead > 0.0)) return {infinity, infinity};
    const double k = std::max(ahead.last.backward.most, 1e-3 * uses_ahead) / uses_ahead * (1.0 + 1e-12);
    const double m = std::max(behind.last.forward.most, 1e-3 * uses_behind) / uses_behind * (1.0 + 1e-12);
    // What they lack when both block.
    const double free = std::max(behind.blocks_after, ahead.blocks_after);
    const auto lacks = [&](const Rates& rates) {
        const double fastest = std::max({std::abs(rates.backward.least), std::abs(rates.backward.most),
                                         std::abs(rates.forward.least), std::abs(rates.forward.most)});
        return rates.lacks + free * fastest;
    };
    const double p = lacks(behind.last) / uses_behind;
    const double q = lacks(ahead.last) / uses_ahead;
    Turning most{free, infinity};
    double back = p;
    double forth = q;
    bool backward = backward_first;
    if (free > 0.0) ++moves;  // so that either way may come first
    for (int i = 0; i < moves && most.soon < enough; ++i, backward = !backward) {
        double& used = backward ? back : forth;
        most.soon += used;
        (backward ? forth : back) += used * (backward ? k : m);
        used = 0.0;
    }
    most.soon *= 1.0 + 1e-12;
    if (k * m < 0.99) {
        const double weight = std::sqrt(m / k);
        const double all = (p + weight * q) * std::max(1.0, 1.0 / weight) / (1.0 - std::sqrt(k * m));
        most.ever = (free + all) * (1.0 + 1e-12);
    }
    return most;
}

/// Is it worth asking? The last turns, and how they shrink or grow, say roughly how much turning is to come.
bool promising(const State& state, double far, int moves) {
    const auto [last, before, earlier] = state.turned;
    if (before == infinity) return last == infinity || last < 0.06 * far;
    const double ratio = earlier < infinity ? last / earlier : 0.5;
    const double enough = (ratio < 1.0 ? 0.7 : 0.1) * far;
    double pair = last + before;
    double all = 0.0;
    for (int i = 0; i < moves && all < enough && pair > 1e-3 * far; i += 2) all += pair *= ratio;
    return all < enough;
}

}  // namespace

Jam::Jam(const ProofProblem& problem)
    : frame_(problem.frame), radius_(problem.radius), size_(size_of(frame_)), least_(steepest_parked(problem, true)) {}

Jammed Jam::jams(const State& state, const Steering& backward, const Steering& forward, int moves, bool anyway) const {
    const double c = state.start.c;
    const double s = state.start.s;
    const double wide = state.start.off.size();
    const double across = state.backward ? backward.across : forward.across;
    const double other_x = state.x.mid + across * s;
    const double other_y = state.y.mid - across * c;
    Cars cars{};
    cars.radius = radius_;
    cars.apart = state.x.span() + state.y.span() + 2.0 * radius_ * wide;
    cars.left_x = state.backward ? state.x.mid : other_x;
    cars.left_y = state.backward ? state.y.mid : other_y;
    cars.right_x = state.backward ? other_x : state.x.mid;
    cars.right_y = state.backward ? other_y : state.y.mid;
    // How far it is from being parked, in headings: no point moves by more than this for every radian.
    const double speed = 2.0 * radius_ + size_;
    double height = -infinity;
    for (const Point& corner : frame_) height = std::max(height, corner.x * s + (corner.y - radius_) * c);
    const double far =
        std::max((cars.left_y + height - cars.apart - speed * wide) / speed, state.start.angle - wide - least_) - 1e-12;
    if (!(far > 0.0) || !(anyway || promising(state, far, moves))) return Jammed::no;
    cars.most = state.start.angle + wide + angle_error;
    const auto try_turn = [&](double turn) {
        cars.turn = turn;
        cars.least = state.start.angle - wide - turn - angle_error;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto [sine, cosine] = angles::sine_cosine(i == 0 ? cars.most : cars.least);
            cars.ends[i] = {cosine, sine};
        }
        std::array<Blocker, 3> blockers;
        for (const Met met : {front, rear, curb})
            blockers[met] = blocker_of(state, backward.of[met], forward.of[met], cars);
        Turning least{infinity, infinity};
        for (const Blocker& behind : blockers) {
            if (!behind.usable) continue;
            for (const Blocker& ahead : blockers) {
                if (!ahead.usable || &ahead == &behind) continue;
                const Turning found = turning(behind, ahead, far, state.backward, moves);
                least.soon = std::min(least.soon, found.soon);
                least.ever = std::min(least.ever, found.ever);
            }
        }
        return least;
    };
    double turn = 1e-15;
    for (int i = 0; i < 3; ++i) {
        const Turning most = try_turn(turn);
        if (most.ever < turn) return Jammed::for_good;
        if (most.soon < turn) return Jammed::for_now;
        const double next = 1.3 * std::min(most.ever < far ? most.ever : infinity, most.soon) + 1e-15;
        if (!(next < far)) return Jammed::no;
        turn = next;
    }
    return Jammed::no;
}

}  // namespace snug::detail::proof
