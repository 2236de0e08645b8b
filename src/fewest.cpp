#include "snug/fewest.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "check.hpp"
#include "entering.hpp"
#include "fewest_search.hpp"
#include "snug/entry.hpp"

namespace snug {

namespace {

using namespace detail;

/// Nose first, whether the nose stays in the slot (see fewest.hpp).
bool nose_stays_in(const Maneuver& maneuver, const Slot& slot, double clearance) {
    const Car& car = maneuver.car;
    const auto out = [&](const Pose& at) {
        const Pose pose = slot.to_slot(at);
        return pose.y + (car.front() + clearance) * std::sin(pose.heading) -
                   (car.width() / 2.0 + clearance) * std::cos(pose.heading) >
               1e-9 * car.length();
    };
    return std::none_of(maneuver.moves.begin(), maneuver.moves.end(), [&](const Move& move) {
        return move.direction == Direction::backward && (out(move.start) || out(move.end));
    });
}

}  // namespace

FewestAnswer fewest(const Car& car, const Slot& slot, const FewestOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, 1000.0, "");
    check_between("clearance", options.clearance, 0.0, 1e6, " m");
    check_between("resolution", options.resolution, 0.0, 1e6, " m");
    check_between("time limit", options.time_limit, 0.0, std::numeric_limits<double>::infinity(), " s");

    FewestAnswer answer;
    const Shortfall lacks = shortfall(car, slot, options.clearance);
    if (lacks.length > 0.0 || lacks.width > 0.0) {
        answer.lower_bound = options.max_changes + 1;
        answer.proved = true;
        return answer;
    }
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const Watch watch = [&] {
        if (std::chrono::duration<double>(Clock::now() - begin).count() > options.time_limit) throw GivenUp{};
        if (options.progress && !options.progress(0.0)) throw GivenUp{};
    };

    LeavingQuestion question{Ground(car, slot, options.enter, options.clearance),
                             entering_problem(car, slot, options.enter, options.clearance),
                             options.enter,
                             [](Heights& heights) { heights.start_parked(); },
                             {},
                             options.max_changes,
                             options.resolution};
    LeavingBounds bounds;
    // The paper's strategy is exact where it is best.
    EntryOptions with_full_steering;
    with_full_steering.clearance = options.clearance;
    with_full_steering.enter = options.enter;
    EntryAnswer max_steer = entry(car, slot, with_full_steering);
    if (max_steer.parkable && *max_steer.direction_changes <= options.max_changes &&
        (options.enter == Enter::backward || nose_stays_in(*max_steer.maneuver, slot, options.clearance)))
        bounds.upper = max_steer.direction_changes;
    try {
        narrow(question, bounds, watch);
        if (options.roomiest) make_roomier(question, bounds, watch);
    } catch (const GivenUp&) {  // the bounds are what is known
    }

    answer.direction_changes = bounds.upper;
    answer.lower_bound = bounds.lower;
    answer.proved = bounds.meet() || bounds.lower > options.max_changes;
    answer.spacing = bounds.spacing;
    if (bounds.upper && bounds.moves.empty()) {
        answer.maneuver = std::move(max_steer.maneuver);
    } else if (bounds.upper) {
        for (Move& move : bounds.moves) {
            move.direction = entering_direction(options.enter, move.direction);
            move.steering_angle = slot.mirrored(move.steering_angle);
            move.start = to_world(slot, options.enter, move.start);
            move.end = to_world(slot, options.enter, move.end);
            if (move.contact) move.contact = to_world(slot, options.enter, *move.contact);
        }
        answer.maneuver = Maneuver{car, std::move(bounds.moves)};
    }
    return answer;
}

}  // namespace snug
