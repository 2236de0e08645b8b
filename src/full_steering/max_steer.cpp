#include "snug/max_steer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/entering.hpp"
#include "contact/parking.hpp"
#include "full_steering/full_steering.hpp"
#include "snug/contact.hpp"
#include "snug/entry_position.hpp"

namespace snug {

namespace {

using namespace detail;

/// Where a parking move stops: as parallel to the slot as it can while the car is parked, from the first moment it is.
QuarterHeading goal_heading(const Turn& turn, const QuarterHeading& start, const QuarterHeading& end) {
    std::optional<ParkedTurn> parked = first_parked(turn, start, end, 0.0);
    const auto same = [](const QuarterHeading& a, const QuarterHeading& b) {
        return a.quarter == b.quarter && a.order() == b.order();
    };
    // Where it is parked for a moment only, rounding may have cut the rest off.
    if (!parked || same(parked->from, parked->to)) parked = first_parked(turn, start, end, turn.problem->touch);
    if (!parked) return end;  // only rounding knows
    if (parked->to.quarter <= 0) return parked->to;
    if (parked->from.quarter > 0) return parked->from;
    return {1.0, 0.0, 0};
}

/// `pose`: the first, in the entering frame, `around` whole turns from where it is told.
MaxSteerRun drive(const Car& car, const Slot& slot, const FullSteering& steering, FullSteeringRun driven, Pose pose,
                  double around, bool may_be_parked, const MaxSteerOptions& options) {
    MaxSteerRun run{Outcome::too_many_changes, {car, {}}};
    const double radius = steering.problem.radius;
    const auto told = [&](const Pose& at) {
        return to_world(slot, options.driving.enter, {at.x, at.y, at.heading + around});
    };
    run.maneuver.moves.reserve(8);
    for (int changes = 0; changes <= options.max_changes; ++changes) {
        const bool backward = driven.backward();
        const double centre_x = driven.x();
        const double centre_y = driven.y();
        const QuarterHeading start = driven.heading();
        const FullMove full = driven.drive<false>();
        // With a clearance the car can be inside at a steep entry position whose first move cannot start.
        if (full.stuck && !(may_be_parked && full.depth <= 0.0)) {
            run.outcome = changes == 0 ? Outcome::no_entry : Outcome::stuck;
            break;
        }
        QuarterHeading end = driven.heading();
        bool touches = full.meets != Meets::nothing;
        const bool parked = full.depth <= 0.0;
        if (parked) {
            const QuarterHeading contact = touches ? end : turned_away;
            const TurningFrame& frame = backward ? steering.backward : steering.forward;
            end = goal_heading({&frame, &steering.problem, centre_x, centre_y}, start, contact);
            touches = touches && end.quarter == contact.quarter && end.order() == contact.order();
        } else if (!touches) {
            run.outcome = Outcome::never_touches;
            break;
        }

        const double offset = backward ? radius : -radius;
        Move move;
        move.direction = entering_direction(options.driving.enter, backward ? Direction::backward : Direction::forward);
        move.steering_angle = slot.mirrored(backward ? car.max_steer() : -car.max_steer());
        move.start = told(pose);
        const double turned_to = end.angle();
        move.length = std::max(0.0, radius * (pose.heading - turned_to));
        pose = {centre_x + offset * end.sine(), centre_y - offset * end.cosine(), turned_to};
        move.end = told(pose);
        if (touches) move.contact = contact_of(car, slot, options.driving.enter, full.meets, full.part);
        run.maneuver.moves.push_back(move);
        if (parked) {
            run.outcome = Outcome::parked;
            break;
        }
    }
    return run;
}

}  // namespace

MaxSteerRun detail::max_steer(const Car& car, const Slot& slot, const FullSteering& steering, double heading,
                              const MaxSteerOptions& options) {
    const FullSteeringRun at_entry(steering, heading);
    const QuarterHeading& way = at_entry.heading();
    if (!is_possible(steering.problem, steering.entry, heading, way.c, way.s)) return {Outcome::no_entry, {car, {}}};
    const double radius = steering.problem.radius;
    return drive(car, slot, steering, at_entry, {at_entry.x() + radius * way.s, at_entry.y() - radius * way.c, heading},
                 0.0, false, options);
}

MaxSteerRun max_steer(const Car& car, const Slot& slot, double heading, const MaxSteerOptions& options) {
    check(options);
    check_entry_heading(heading);
    const FullSteering steering(entering_problem(car, slot, options.driving, options.parked));
    return detail::max_steer(car, slot, steering, heading, options);
}

MaxSteerRun max_steer(const Car& car, const Slot& slot, const Pose& pose, Direction direction,
                      const MaxSteerOptions& options) {
    check(options);
    if (!is_free(car, slot, pose, options.driving)) return {Outcome::no_entry, {car, {}}};
    const Enter enter = options.driving.enter;
    Pose seen = to_entering(slot, enter, pose);
    const QuarterHeading told = in_quarters(seen.heading);
    const int quarter = before_turned_away(told).quarter;
    const double around = (quarter - told.quarter) * limits::quarter_turn;
    seen.heading -= around;
    const FullSteering steering(entering_problem(car, slot, options.driving, options.parked), quarter);
    const bool backward = entering_direction(enter, direction) == Direction::backward;
    return drive(car, slot, steering, FullSteeringRun(steering, seen, backward), seen, around, true, options);
}

std::string_view to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::parked: return "parked";
        case Outcome::no_entry: return "no entry";
        case Outcome::stuck: return "stuck";
        case Outcome::never_touches: return "never touches";
        case Outcome::too_many_changes: return "too many changes";
    }
    return "";
}

Pose entry_position(const Car& car, const Slot& slot, double heading, const Driving& driving) {
    check(driving);
    check_entry_heading(heading);
    const Problem problem = entering_problem(car, slot, driving);
    return to_world(slot, driving.enter, entry_pose(problem, entry_corner(problem), heading));
}

std::vector<Headings> possible_headings(const Car& car, const Slot& slot, const Driving& driving) {
    check(driving);
    return detail::possible_headings(entering_problem(car, slot, driving));
}

}  // namespace snug
