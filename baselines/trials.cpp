#include "snug/trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "baselines/plain.hpp"
#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"
#include "snug/entry.hpp"
#include "snug/entry_position.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

using namespace detail;

using limits::quarter_turn;
constexpr double negligible = 5e-10;  ///< moves shorter than this are left out [m]
constexpr double rounding = 1e-10;    ///< what rounding may do to a position, amply [m]
constexpr double touching = 1e-9;     ///< of the car's length: a goal may stick out that far

/// The question in the entering frame (entering.hpp), where every car enters backward into a slot on the right.
struct Ground {
    Car car;
    Slot slot;
    double clearance;
    double radius;  ///< of the rear axle centre's circle [m]
    double front;   ///< of the grown frame [m]
    double side;    ///< of the grown frame [m]

    Ground(const Car& asked, const Slot& asked_slot, const MaxSteerOptions& options)
        : car(asked),
          slot({.length = asked_slot.length(), .width = asked_slot.width()}),
          clearance(options.driving.clearance),
          radius(asked.turning_radius()) {
        CarDimensions dimensions = asked.dimensions();
        if (options.driving.enter == Enter::forward) std::swap(dimensions.front, dimensions.rear);
        car = Car(dimensions);
        front = car.front() + clearance;
        side = car.width() / 2.0 + clearance;
    }

    [[nodiscard]] FirstContact meets(const Pose& pose, Direction direction, double steering_angle) const {
        return first_contact(car, slot, pose, direction, steering_angle, {.clearance = clearance});
    }
    [[nodiscard]] bool free(const Pose& pose, Direction direction, double steering_angle, double distance) const {
        return meets(pose, direction, steering_angle).distance >= distance;
    }
    /// How far the frame sticks out of the slot, or the grown one into its neighbours or the curb. [m]
    [[nodiscard]] double sticks_out(const Pose& pose) const {
        double out = 0.0;
        for (const Point& corner : frame(car, pose))
            out = std::max({out, corner.x, -slot.length() - corner.x, corner.y, -slot.width() - corner.y});
        CarDimensions grown = car.dimensions();
        grown.front += clearance;
        grown.rear += clearance;
        grown.width += 2.0 * clearance;
        const std::vector<Point> corners = frame(Car(grown), pose);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point& from = corners[i];
            const Point& to = corners[(i + 1) % corners.size()];
            out = std::max(out, -slot.width() - from.y);
            if (from.y > 0.0 && to.y > 0.0) continue;  // over the road it may reach beyond the slot's ends
            const auto clipped = [](const Point& at, const Point& other) {
                return at.y <= 0.0 ? at.x : at.x + (other.x - at.x) * (at.y / (at.y - other.y));
            };
            for (const double x : {clipped(from, to), clipped(to, from)}) out = std::max({out, x, -slot.length() - x});
        }
        return out;
    }
};

Move driven(const Ground& ground, const Pose& start, Direction direction, double steering_angle, double length) {
    Move move;
    move.direction = direction;
    move.steering_angle = steering_angle;
    move.length = length;
    move.start = start;
    move.end = drive(ground.car, start, direction, steering_angle, length);
    return move;
}

Maneuver to_world(const Car& car, const Slot& slot, Enter enter, std::vector<Move> moves) {
    for (Move& move : moves) {
        move.direction = entering_direction(enter, move.direction);
        move.steering_angle = slot.mirrored(move.steering_angle);
        move.start = detail::to_world(slot, enter, move.start);
        move.end = detail::to_world(slot, enter, move.end);
        if (move.contact) move.contact = detail::to_world(car, slot, enter, *move.contact);
    }
    return {car, std::move(moves)};
}

/// The number next to `works` for which `true_there` holds, on the way from `fails`, to the last bit.
template <class Predicate>
double last_that_works(double works, double fails, Predicate true_there) {
    for (;;) {
        const double middle = works + (fails - works) / 2.0;
        if (middle == works || middle == fails) return works;
        (true_there(middle) ? works : fails) = middle;
    }
}

// Goals.

std::string named(const Pose& pose) {
    return "goal (" + spelled(pose.x) + " m, " + spelled(pose.y) + " m, " + spelled(pose.heading) + " rad)";
}

void check_finite(const std::optional<Pose>& goal) {
    if (!goal) return;
    for (const double value : {goal->x, goal->y, goal->heading})
        check_between(named(*goal), value, -limits::farthest, limits::farthest, "");
}

/// A goal of the world in the entering frame, its heading between -pi and pi. Throws Error when it is no goal.
Pose checked_goal(const Ground& ground, const Slot& slot, Enter enter, const Pose& goal, double most_tilted,
                  const char* tilt) {
    Pose inside = slot.to_slot(goal);
    inside.heading = std::remainder(inside.heading, 4.0 * quarter_turn);
    if (enter == Enter::forward) inside = {-slot.length() - inside.x, inside.y, -inside.heading};
    if (!(std::abs(inside.heading) <= most_tilted))
        throw Error("the " + named(goal) + " is " + spelled(std::abs(inside.heading)) +
                    " rad off the slot's heading, but must be " + tilt);
    const double out = ground.sticks_out(inside);
    if (out > touching * ground.car.length())
        throw Error("at the " + named(goal) + " the car sticks " + spelled(out) + " m out of the slot" +
                    (ground.clearance > 0.0 ? " or into its clearance" : "") + ", but must be inside");
    return inside;
}

/// The goal brought below the entry side by more than rounding. Exactly at it, a corner of the car and one of the slot
/// may coincide, and which of them is above the other would be left to chance.
Pose below_entry_side(const Ground& ground, Pose goal) {
    double top = goal.y;
    for (const Point& corner : frame(ground.car, goal)) top = std::max(top, corner.y);
    goal.y -= std::max(0.0, top + rounding);
    return goal;
}

bool fits(const Car& car, const Slot& slot, double clearance) {
    const Shortfall lacks = shortfall(car, slot, {.clearance = clearance});
    return lacks.length <= 0.0 && lacks.width <= 0.0;
}

// Reversed trials.

/// How the car gets out from where it stands.
struct WayOut {
    double left = 0.0;      ///< forward with full left steering [m]
    double straight = 0.0;  ///< and then straight on [m]
};

/// If full left steering takes the front-right corner up to the entry side, behind p and without contact: that far,
/// and straight on until the corner is above p. A nose that still points at the curb is brought up to parallel first.
std::optional<WayOut> way_out(const Ground& ground, const Pose& pose) {
    const double across = ground.side + ground.radius;  // of the corner, seen from the turning centre
    const double s = angles::sin(pose.heading);
    const double c = angles::cos(pose.heading);
    double rises = pose.heading;  // heading at which the corner comes up to the entry side
    if (pose.y + ground.front * s - ground.side * c < 0.0) {
        const double below = -(pose.y + ground.radius * c);  // height of the entry side above the centre
        const double reach = angles::hypot(ground.front, across);
        if (!(std::abs(below) <= reach)) return std::nullopt;
        rises =
            angles::atan2(below, std::sqrt((reach - below) * (reach + below))) + angles::atan2(across, ground.front);
    }
    const double heading = std::max({rises, pose.heading, 0.0});
    if (!(heading < quarter_turn)) return std::nullopt;
    const WayOut turn{ground.radius * (heading - pose.heading), 0.0};
    const auto corner_x = [&](double at) {
        return pose.x - ground.radius * s + across * angles::sin(at) + ground.front * angles::cos(at);
    };
    // The way back from an entry position passes p: rounding must not stop it there.
    if (corner_x(rises) > rounding) return std::nullopt;
    if (!ground.free(pose, Direction::forward, ground.car.max_steer(), turn.left - rounding)) return std::nullopt;
    return WayOut{turn.left, std::max(0.0, -corner_x(heading) / angles::cos(heading))};
}

/// The moves out of the slot; none when there is no way out.
std::vector<Move> moves_out(const Ground& ground, const Pose& goal, Direction first, int max_changes) {
    const double full = ground.car.max_steer();
    std::vector<Move> moves;
    Pose pose = goal;
    Direction direction = first;
    bool blocked = false;
    while (static_cast<int>(moves.size()) <= max_changes) {
        const bool forward = direction == Direction::forward;
        if (forward && way_out(ground, pose)) break;
        const FirstContact met = ground.meets(pose, direction, forward ? full : -full);
        if (!met.contact) return {};  // it circles
        if (met.distance > negligible) {
            moves.push_back(driven(ground, pose, direction, forward ? full : -full, met.distance));
            moves.back().contact = met.contact;
            pose = moves.back().end;
            blocked = false;
        } else if (blocked || !moves.empty()) {
            return {};  // stuck
        } else {
            blocked = true;
        }
        direction = reverse_of(direction);
    }
    if (static_cast<int>(moves.size()) > max_changes) return {};

    if (!moves.empty()) {
        const Move last = moves.back();
        const double length = last_that_works(last.length, 0.0, [&](double shorter) {
            return way_out(ground, drive(ground.car, last.start, last.direction, last.steering_angle, shorter))
                .has_value();
        });
        moves.pop_back();
        pose = last.start;
        if (length > 0.0) {
            moves.push_back(driven(ground, pose, last.direction, last.steering_angle, length));
            pose = moves.back().end;
        }
    }
    const WayOut out = way_out(ground, pose).value();
    if (out.left > 0.0) moves.push_back(driven(ground, pose, Direction::forward, full, out.left));
    if (!moves.empty()) pose = moves.back().end;
    if (out.straight > negligible) moves.push_back(driven(ground, pose, Direction::forward, 0.0, out.straight));
    return moves;
}

/// The same path the other way round: a move ends in contact where the one before it did on the way out.
std::vector<Move> in_reverse(const std::vector<Move>& out) {
    std::vector<Move> in;
    for (std::size_t i = out.size(); i-- > 0;) {
        Move move = out[i];
        move.direction = reverse_of(move.direction);
        std::swap(move.start, move.end);
        move.contact = i > 0 ? out[i - 1].contact : std::nullopt;
        in.push_back(move);
    }
    return in;
}

// Parallel trials.

/// Backing from a possible entry position with full left steering until parallel: as deep as the slot allows, but with
/// the rear axle no deeper than `goal_y`.
Move first_trial(const Ground& ground, double goal_y) {
    const double across = ground.side + ground.radius;
    const auto from = [&](double heading) {
        const auto [s, c] = angles::sine_cosine(heading);
        return Pose{-ground.front * c - ground.side * s, -ground.front * s + ground.side * c, heading};
    };
    // Steeper entries take every heading further back and deeper, so all that are shallower than a free one are free.
    const std::vector<Headings> possible = possible_headings(ground.car, ground.slot, {.clearance = ground.clearance});
    const double steepest = possible.empty() || possible.front().min > 0.0 ? 0.0 : possible.front().max;
    const double heading = last_that_works(0.0, steepest, [&](double at) {
        const bool too_deep = -ground.front * angles::sin(at) + across * angles::cos(at) - ground.radius < goal_y;
        return !too_deep && ground.free(from(at), Direction::backward, ground.car.max_steer(), ground.radius * at);
    });
    Move move = driven(ground, from(heading), Direction::backward, ground.car.max_steer(), ground.radius * heading);
    move.end.heading = 0.0;
    return move;
}

/// One trial: the moves that shift a parallel car at `pose` towards the curb, `goal_y` at most, and on to the contact.
/// None when it cannot move.
std::vector<Move> next_trial(const Ground& ground, const Pose& pose, Direction direction, double goal_y) {
    const double full = ground.car.max_steer();
    const double off = direction == Direction::forward ? -1.0 : 1.0;  // which way the heading leaves parallel
    const auto free = [&](double angle) {
        const double arc = ground.radius * angle;
        if (!ground.free(pose, direction, -full, arc)) return false;
        return ground.free(drive(ground.car, pose, direction, -full, arc), direction, full, arc);
    };
    const double to_goal = 2.0 * angles::asin(std::sqrt(std::min(0.5, (pose.y - goal_y) / (4.0 * ground.radius))));
    const bool reaches = to_goal < quarter_turn && free(to_goal);
    const double angle = reaches ? to_goal : last_that_works(0.0, to_goal, free);

    std::vector<Move> moves;
    Pose at = pose;
    if (ground.radius * angle > negligible) {
        moves.push_back(driven(ground, at, direction, -full, ground.radius * angle));
        moves.back().end.heading = off * angle;
        moves.push_back(driven(ground, moves.back().end, direction, full, ground.radius * angle));
        moves.back().end.heading = 0.0;
        at = moves.back().end;
    }
    if (reaches) return moves;
    const FirstContact met = ground.meets(at, direction, 0.0);
    if (met.contact && met.distance > negligible) moves.push_back(driven(ground, at, direction, 0.0, met.distance));
    if (!moves.empty()) moves.back().contact = met.contact;
    return moves;
}

}  // namespace

std::optional<Maneuver> reversed_trials(const Car& car, const Slot& slot, const ReversedTrials& trials,
                                        const MaxSteerOptions& options) {
    check(options);
    check_plain("trials", car, slot, options.driving, options.parked);
    check_finite(trials.goal);
    if (!fits(car, slot, options.driving.clearance)) return std::nullopt;
    const Ground ground(car, slot, options);
    const Pose deduced{ground.car.rear() + options.driving.clearance - slot.length(), -car.width() / 2.0, 0.0};
    const Pose goal = trials.goal ? checked_goal(ground, slot, options.driving.enter, *trials.goal, quarter_turn,
                                                 "within a quarter turn of it")
                                  : deduced;
    const std::vector<Move> out = moves_out(ground, below_entry_side(ground, goal), trials.first, options.max_changes);
    if (out.empty()) return std::nullopt;
    return to_world(car, slot, options.driving.enter, in_reverse(out));
}

std::optional<Maneuver> parallel_trials(const Car& car, const Slot& slot, const ParallelTrials& trials,
                                        const MaxSteerOptions& options) {
    check(options);
    check_plain("trials", car, slot, options.driving, options.parked);
    check_finite(trials.goal);
    if (!fits(car, slot, options.driving.clearance)) return std::nullopt;
    const Ground ground(car, slot, options);
    std::optional<Pose> goal;
    if (trials.goal) goal = checked_goal(ground, slot, options.driving.enter, *trials.goal, 1e-9, "parallel to it");
    const double goal_y = goal ? below_entry_side(ground, *goal).y : -car.width() / 2.0 - rounding;

    std::vector<Move> moves = {first_trial(ground, goal_y)};
    const auto here = [&] { return moves.back().end; };
    if (!(moves.back().length > negligible)) return std::nullopt;
    Direction direction = Direction::backward;
    for (int changes = 0; here().y > goal_y + rounding / 2.0; ++changes) {
        direction = reverse_of(direction);
        const std::vector<Move> trial = next_trial(ground, here(), direction, goal_y);
        if (trial.empty() || changes == options.max_changes) return std::nullopt;
        moves.insert(moves.end(), trial.begin(), trial.end());
    }
    if (goal && std::abs(goal->x - here().x) > negligible) {
        const Direction to_goal = goal->x > here().x ? Direction::forward : Direction::backward;
        moves.push_back(driven(ground, here(), to_goal, 0.0, std::abs(goal->x - here().x)));
    }
    Maneuver maneuver = to_world(car, slot, options.driving.enter, std::move(moves));
    if (maneuver.direction_changes() > options.max_changes) return std::nullopt;
    return maneuver;
}

ReversedTrialsByGoal reversed_trials_by_goal(const Car& car, const Slot& slot, int max_changes) {
    const auto changes = [&](const ReversedTrials& trials) -> std::optional<int> {
        const std::optional<Maneuver> maneuver = reversed_trials(car, slot, trials, {.max_changes = max_changes});
        if (!maneuver) return std::nullopt;
        return maneuver->direction_changes();
    };
    ReversedTrialsByGoal by_goal;
    by_goal.deduced = changes({});
    const Answer best = entry(car, slot, {.prove = false});
    if (best.maneuver && best.direction_changes <= max_changes)
        by_goal.found = changes({best.maneuver->goal(), reverse_of(best.maneuver->moves.back().direction)});
    return by_goal;
}

double blackburn_extra_length(const Car& car, double neighbour_width) {
    const double half_circle = car.curb_to_curb() / 2.0;  // R
    const double outer_side = std::sqrt((half_circle - car.wheelbase()) * (half_circle + car.wheelbase()));
    check_between("neighbour's width", neighbour_width, 0.0, outer_side, " m");
    // (R^2 - l^2) - (sqrt(R^2 - l^2) - w)^2 without cancellation, and l + k = d_f.
    const double inward = neighbour_width * (2.0 * outer_side - neighbour_width);
    return std::sqrt(inward + car.front() * car.front()) - car.front();
}

}  // namespace snug
