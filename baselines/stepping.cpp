// Algorithm 1 of the paper, step by step: which sampled headings park, after how many direction changes.
//
// Every Euler step of equation 1 is computed and none is jumped over (a jump in closed form would be the exact solver).
// What makes it fast is what it leaves out between the steps:
//
//   - Both kinds of move turn the car clockwise by the same angle in each step, so (cos theta, sin theta) is rotated by
//     a constant instead of asking for a cosine and a sine.
//   - A frame d away from the sides of the slot cannot intersect them in the next d / reach steps, `reach` being the most
//     any point of it moves in one. Those steps are driven without looking, which changes no answer.
//
// What limits it then is the chain of rotations, each waiting for the last, and the dozen or so looks of a move.
//
// Everything happens in the slot frame (see slot.hpp); entering nose first is the mirrored slot and the swapped car.
#include "snug/stepping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "baselines/plain.hpp"
#include "baselines/stepping_entry.hpp"
#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {
namespace {

using limits::quarter_turn;
constexpr double most_steps_in_a_turn = 1e9;

/// Position of the rear axle centre and heading vector.
struct State {
    double x, y, c, s;
};

/// The frame around the rear axle centre.
struct Frame {
    double front, rear, half_width;

    // How far it reaches along an axis on which the heading vector is `along` and its normal has the size `across`.
    [[nodiscard]] double ahead(double along, double across) const {
        return std::max(front * along, -rear * along) + half_width * across;
    }
    [[nodiscard]] double behind(double along, double across) const {
        return std::max(rear * along, -front * along) + half_width * across;
    }
};

/// The non-entry sides of the slot.
enum Wall : std::size_t { front_side, curb, rear_side };

/// The ways in which the frame can be apart from a wall: all of it on one side of the wall's line, or all of the wall
/// beyond one edge of the frame. One of them holds whenever the two do not intersect (separating axes).
enum Way : std::size_t { whole_frame, front_edge, rear_edge, left_edge, right_edge };
using Gaps = std::array<double, 5>;

enum class MoveEnd { contact, parked, full_turn };

struct Driven {
    MoveEnd end;
    std::int64_t steps;
};

/// Algorithm 1 for one car and slot, the car entering backward.
class Algorithm {
public:
    Algorithm(const Car& car, const Slot& slot, Enter enter, double clearance, const Stepping& steps)
        : length_(slot.length()), width_(slot.width()), step_(steps.step), stop_(steps.stop) {
        parked_ = {car.front(), car.rear(), car.width() / 2.0};
        if (enter == Enter::forward) {
            std::swap(parked_.front, parked_.rear);
        }
        touching_ = {parked_.front + clearance, parked_.rear + clearance, parked_.half_width + clearance};
        turn_ = steps.step / car.turning_radius();
        turn_c_ = angles::cos(turn_);
        turn_s_ = angles::sin(turn_);
        turn2_c_ = angles::cos(2.0 * turn_);
        turn2_s_ = angles::sin(2.0 * turn_);
        // A step rotates the frame about a point Delta / 2 from the axle's line and Delta / (2 tan(turn / 2)) to its side;
        // `reach` is the rotation times the distance of the farthest corner, rounded up.
        const double reach = angles::hypot(turn_ * (std::max(touching_.front, touching_.rear) + step_ / 2.0),
                                           step_ + turn_ * touching_.half_width);
        steps_per_metre_ = 1.0 / reach;
        full_turn_ = static_cast<std::int64_t>(std::ceil(2.0 * std::numbers::pi / turn_));
    }

    /// Delta / r: how far the heading falls in one step. [rad]
    [[nodiscard]] double turn() const { return turn_; }

    /// C_E^P: front-right corner at p.
    [[nodiscard]] State entry_position(double heading) const {
        const auto [s, c] = angles::sine_cosine(heading);
        return {-touching_.front * c - touching_.half_width * s, -touching_.front * s + touching_.half_width * c, c, s};
    }

    /// The frame intersects neither curb nor rear side. With headings in [0, pi/2] it only touches the front side, at p.
    [[nodiscard]] bool is_possible_entry(const State& at) const {
        return distance_to(curb, at) >= 0.0 && distance_to(rear_side, at) >= 0.0;
    }

    /// Steps in one direction until the next one would intersect, leaving the car where that one would start.
    [[nodiscard]] Driven drive(State& at, Direction direction) const {
        const double path = direction == Direction::forward ? step_ : -step_;
        std::int64_t driven = 0;
        double free = 0.0;  // nothing can happen on this much of any point's way
        while (driven < full_turn_) {
            const auto unwatched =
                std::min(static_cast<std::int64_t>(free * steps_per_metre_), full_turn_ - 1 - driven);
            step_on(at, path, unwatched);
            driven += unwatched;
            const State next = stepped(at, path);
            free = distance(next);
            if (free < 0.0) {
                // With a clearance the real frame can be inside at a steep entry position already; that is no parking.
                const bool parked = stop_ == StopRule::contact && driven > 0 && is_parked(at);
                return {parked ? MoveEnd::parked : MoveEnd::contact, driven};
            }
            at = normalised(next);
            ++driven;
            if (stop_ == StopRule::inside) {
                const double above = at.y + parked_.ahead(at.s, std::abs(at.c));
                if (above <= 0.0 && is_parked(at)) {
                    return {MoveEnd::parked, driven};
                }
                free = std::min(free, std::max(above, 0.0));
            }
        }
        return {MoveEnd::full_turn, driven};
    }

    /// What the step from `at` hits first.
    [[nodiscard]] Contact contact(const State& at, Direction direction) const {
        const State hit = stepped(at, direction == Direction::forward ? step_ : -step_);
        double first = std::numeric_limits<double>::infinity();
        Contact contact{};
        for (const Wall wall : {front_side, curb, rear_side}) {
            const Gaps before = gaps(wall, at);
            const Gaps after = gaps(wall, hit);
            const double overlap = *std::max_element(after.begin(), after.end());
            const auto last_gap = std::max_element(before.begin(), before.end());
            const double when = *last_gap / (*last_gap - overlap);
            if (overlap < 0.0 && when < first) {
                first = when;
                contact = what_meets(wall, static_cast<Way>(last_gap - before.begin()), at);
            }
        }
        return contact;
    }

private:
    [[nodiscard]] State stepped(const State& at, double path) const {
        return {at.x + path * at.c, at.y + path * at.s, at.c * turn_c_ + at.s * turn_s_,
                at.s * turn_c_ - at.c * turn_s_};
    }

    /// The same, `count` times. The even and the odd steps' headings are two chains, each rotated by two steps at once, so
    /// that a step need not wait for the heading of the one before it.
    void step_on(State& at, double path, std::int64_t count) const {
        auto [x, y, c0, s0] = at;
        double c1 = c0 * turn_c_ + s0 * turn_s_;
        double s1 = s0 * turn_c_ - c0 * turn_s_;
        for (std::int64_t pairs = count / 2; pairs > 0; --pairs) {
            x += path * c0;
            y += path * s0;
            x += path * c1;
            y += path * s1;
            const double c2 = c0 * turn2_c_ + s0 * turn2_s_;
            const double s2 = s0 * turn2_c_ - c0 * turn2_s_;
            const double c3 = c1 * turn2_c_ + s1 * turn2_s_;
            const double s3 = s1 * turn2_c_ - c1 * turn2_s_;
            c0 = c2;
            s0 = s2;
            c1 = c3;
            s1 = s3;
        }
        at = count % 2 == 0 ? State{x, y, c0, s0} : State{x + path * c0, y + path * s0, c1, s1};
    }

    /// Keeps rounding from stretching the heading vector: one Newton step towards length one.
    [[nodiscard]] static State normalised(const State& at) {
        const double scale = 1.5 - 0.5 * (at.c * at.c + at.s * at.s);
        return {at.x, at.y, at.c * scale, at.s * scale};
    }

    /// Negative when the frame intersects one of the three sides, else no more than its distance from them.
    [[nodiscard]] double distance(const State& at) const {
        return std::min(std::min(distance_to(front_side, at), distance_to(curb, at)), distance_to(rear_side, at));
    }

    /// Inside the slot the wall's line decides, so the other ways are asked only when it does not.
    [[nodiscard]] double distance_to(Wall wall, const State& at) const {
        const double inward = inner_gap(wall, at);
        if (inward >= 0.0) {
            return inward;
        }
        const Gaps all = gaps(wall, at);
        return *std::max_element(all.begin(), all.end());
    }

    /// How far the whole frame is on the slot's side of the wall's line.
    [[nodiscard]] double inner_gap(Wall wall, const State& at) const {
        switch (wall) {
            case front_side: return -at.x - touching_.ahead(at.c, std::abs(at.s));
            case curb: return width_ + at.y - touching_.behind(at.s, std::abs(at.c));
            case rear_side: break;
        }
        return length_ + at.x - touching_.behind(at.c, std::abs(at.s));
    }

    [[nodiscard]] Gaps gaps(Wall wall, const State& at) const {
        const Point a = {wall == front_side ? 0.0 : -length_, wall == curb ? -width_ : 0.0};
        const Point b = {wall == rear_side ? -length_ : 0.0, -width_};
        // The wall seen from the car: u ahead, v to the left.
        const double u_a = (a.x - at.x) * at.c + (a.y - at.y) * at.s;
        const double u_b = (b.x - at.x) * at.c + (b.y - at.y) * at.s;
        const double v_a = (a.y - at.y) * at.c - (a.x - at.x) * at.s;
        const double v_b = (b.y - at.y) * at.c - (b.x - at.x) * at.s;
        const double inner = inner_gap(wall, at);
        const double along = std::abs(wall == curb ? at.s : at.c);
        const double across = std::abs(wall == curb ? at.c : at.s);
        const double extent = (touching_.front + touching_.rear) * along + 2.0 * touching_.half_width * across;
        return {std::max(inner, -inner - extent), std::min(u_a, u_b) - touching_.front,
                -touching_.rear - std::max(u_a, u_b), std::min(v_a, v_b) - touching_.half_width,
                -touching_.half_width - std::max(v_a, v_b)};
    }

    /// Who meets whom, from the way in which they were apart last.
    [[nodiscard]] Contact what_meets(Wall wall, Way apart, const State& at) const {
        constexpr std::array sides = {Obstacle::front_side, Obstacle::curb, Obstacle::rear_side};
        constexpr std::array ends = {Obstacle::front_corner, Obstacle::curb, Obstacle::rear_corner};
        constexpr std::array edges = {CarPart::front_edge, CarPart::rear_edge, CarPart::left_edge, CarPart::right_edge};
        constexpr std::array<std::size_t, 4> followed = {3, 1, 0, 2};  // corners, counted in the order of their names
        if (apart != whole_frame) {
            return {edges[apart - 1], ends[wall], followed[apart - 1]};
        }
        // The corner farthest towards the wall. A car that went round over a neighbour comes to it from the outside.
        const double towards = inner_gap(wall, at) >= 0.0 ? 1.0 : -1.0;
        const double ahead = towards * (wall == curb ? -at.s : wall == front_side ? at.c : -at.c);
        const double to_left = towards * (wall == curb ? -at.c : wall == front_side ? -at.s : at.s);
        const CarPart corner = ahead >= 0.0 ? (to_left > 0.0 ? CarPart::front_left_corner : CarPart::front_right_corner)
                                            : (to_left > 0.0 ? CarPart::rear_left_corner : CarPart::rear_right_corner);
        return {corner, sides[wall], static_cast<std::size_t>(corner)};
    }

    [[nodiscard]] bool is_parked(const State& at) const {
        const double across_x = std::abs(at.s);
        const double across_y = std::abs(at.c);
        return at.y + parked_.ahead(at.s, across_y) <= 0.0 && at.y - parked_.behind(at.s, across_y) >= -width_ &&
               at.x + parked_.ahead(at.c, across_x) <= 0.0 && at.x - parked_.behind(at.c, across_x) >= -length_;
    }

    double length_, width_;  // of the slot
    Frame parked_, touching_;
    double step_, turn_, turn_c_, turn_s_, turn2_c_, turn2_s_, steps_per_metre_;
    std::int64_t full_turn_;
    StopRule stop_;
};

Direction other(Direction direction) {
    return direction == Direction::backward ? Direction::forward : Direction::backward;
}

void check_steps(const Car& car, const Stepping& steps) {
    check_between("step", steps.step, 1e-7, 1.0, " m");
    check_between("heading step", steps.heading_step, 1e-6, quarter_turn, " rad");
    check_between("number of steps in the car's full turn", 2.0 * std::numbers::pi * car.turning_radius() / steps.step,
                  0.0, most_steps_in_a_turn, "");
}

/// A sampled heading that is still being driven.
struct Candidate {
    State at;
    std::size_t sample;
};

/// What each sampled heading needs, -1 where it does not park.
using Counts = std::vector<int>;

/// Calls visit(first, last) for each stretch of neighbouring samples that all park and are `min_range` apart at its ends.
template <typename Visit>
void for_each_stretch(const Counts& counts, const Stepping& steps, double min_range, Visit visit) {
    for (std::size_t first = 0; first < counts.size(); ++first) {
        if (counts[first] < 0) {
            continue;
        }
        std::size_t last = first;
        while (last + 1 < counts.size() && counts[last + 1] >= 0) {
            ++last;
        }
        if (static_cast<double>(last - first) * steps.heading_step >= min_range) {
            visit(first, last);
        }
        first = last;
    }
}

std::vector<HeadingRange> ranges_of(const Counts& counts, const Stepping& steps, double min_range) {
    std::vector<HeadingRange> ranges;
    int subrange = 0;
    for_each_stretch(counts, steps, min_range, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i <= last; ++i) {
            const double heading = static_cast<double>(i) * steps.heading_step;
            if (i == first || counts[i] != counts[i - 1]) {
                ranges.push_back({heading, heading, counts[i], subrange});
            }
            ranges.back().max = heading;
        }
        ++subrange;
    });
    return ranges;
}

/// The sampled heading in the middle of the widest range with that count.
double middle_of_widest(const std::vector<HeadingRange>& ranges, int count, const Stepping& steps) {
    const HeadingRange* widest = widest_range(ranges, count);
    const double twice_the_middle = std::round((widest->min + widest->max) / steps.heading_step);
    return std::floor(twice_the_middle / 2.0) * steps.heading_step;
}

}  // namespace

MaxSteerRun stepping(const Car& car, const Slot& slot, double heading, const Stepping& steps,
                     const MaxSteerOptions& options) {
    check_steps(car, steps);
    detail::check_entry_heading(heading);
    detail::check(options);
    detail::check_plain("stepping", car, slot, options.driving, options.parked);

    const Algorithm algorithm(car, slot, options.driving.enter, options.driving.clearance, steps);
    MaxSteerRun run{Outcome::no_entry, {car, {}}};
    State at = algorithm.entry_position(heading);
    if (!algorithm.is_possible_entry(at)) {
        return run;
    }
    Pose pose{at.x, at.y, heading};
    Direction direction = Direction::backward;
    run.outcome = Outcome::too_many_changes;
    for (int changes = 0; changes <= options.max_changes; ++changes) {
        const Driven driven = algorithm.drive(at, direction);
        if (driven.steps == 0 && driven.end == MoveEnd::contact) {
            run.outcome = changes == 0 ? Outcome::no_entry : Outcome::stuck;
            break;
        }
        Move move;
        move.direction = detail::entering_direction(options.driving.enter, direction);
        move.steering_angle = slot.mirrored(direction == Direction::backward ? car.max_steer() : -car.max_steer());
        move.length = static_cast<double>(driven.steps) * steps.step;
        move.start = detail::to_world(slot, options.driving.enter, pose);
        pose = {at.x, at.y, pose.heading - static_cast<double>(driven.steps) * algorithm.turn()};
        move.end = detail::to_world(slot, options.driving.enter, pose);
        if (driven.end == MoveEnd::contact || (driven.end == MoveEnd::parked && steps.stop == StopRule::contact)) {
            move.contact = detail::to_world(car, slot, options.driving.enter, algorithm.contact(at, direction));
        }
        run.maneuver.moves.push_back(move);
        if (driven.end != MoveEnd::contact) {
            run.outcome = driven.end == MoveEnd::parked ? Outcome::parked : Outcome::never_touches;
            break;
        }
        direction = other(direction);
    }
    return run;
}

std::string_view to_string(StopRule stop) { return stop == StopRule::inside ? "inside" : "contact"; }

Answer stepping_entry(const Car& car, const Slot& slot, const EntryOptions& options, const Stepping& steps) {
    check_steps(car, steps);
    detail::check_plain("stepping", car, slot, options.driving, options.parked);
    const Algorithm algorithm(car, slot, options.driving.enter, options.driving.clearance, steps);

    const auto samples = static_cast<std::size_t>(std::floor(quarter_turn / steps.heading_step)) + 1;
    Counts counts(samples, -1);
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < samples; ++i) {
        const State at = algorithm.entry_position(static_cast<double>(i) * steps.heading_step);
        if (algorithm.is_possible_entry(at)) {
            candidates.push_back({at, i});
        }
    }

    // One round per direction change, all headings in each: nothing is driven that Gamma_max would drop later.
    Answer answer;
    const int max_changes = options.max_changes.value_or(MaxSteerOptions{}.max_changes);
    Direction direction = Direction::backward;
    std::int64_t steps_since_report = 0;
    for (int changes = 0; changes <= max_changes && !candidates.empty(); ++changes) {
        std::size_t kept = 0;
        bool found = false;
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            Candidate candidate = candidates[i];
            const Driven driven = algorithm.drive(candidate.at, direction);
            if (driven.end == MoveEnd::parked) {
                counts[candidate.sample] = changes;
                found = true;
            } else if (driven.end == MoveEnd::contact && driven.steps > 0) {
                candidates[kept++] = candidate;
            }
            steps_since_report += driven.steps + 1;
            if (options.progress && steps_since_report > 1'000'000) {
                steps_since_report = 0;
                const double of_round = static_cast<double>(i) / static_cast<double>(candidates.size());
                if (!options.progress((changes + of_round) / (max_changes + 1.0))) {
                    answer.cancelled = true;
                    return answer;
                }
            }
        }
        candidates.resize(kept);
        direction = other(direction);
        if (found && !answer.direction_changes) {
            for_each_stretch(counts, steps, options.min_range,
                             [&](std::size_t, std::size_t) { answer.direction_changes = changes; });
            if (answer.direction_changes && !options.max_changes) {
                break;
            }
        }
    }
    if (!answer.direction_changes) {
        return answer;
    }
    answer.ranges = ranges_of(counts, steps, options.min_range);
    const double heading = middle_of_widest(answer.ranges, *answer.direction_changes, steps);
    const MaxSteerOptions same = {max_changes, options.driving};
    answer.maneuver = stepping(car, slot, heading, steps, same).maneuver;
    return answer;
}

}  // namespace snug
