#include "snug/max_steer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "contact/entering.hpp"
#include "full_steering/full_steering.hpp"
#include "full_steering/heading_ranges.hpp"

namespace snug {

namespace {

using namespace detail;

/// Where a parking move about a centre at height y stops: as parallel to the slot as it can while the frame is inside.
/// In the first quarter turn that is as late as possible, at the parallel heading or at the contact; later it is the
/// moment the frame comes in, when its highest corner sinks through the entry side.
QuarterHeading goal_heading(const TurningFrame& frames, double y, const QuarterHeading& start,
                            const QuarterHeading& contact) {
    QuarterHeading from = start;
    for (; from.quarter < contact.quarter; from = {0.0, 1.0, from.quarter + 1}) {
        if (top_height(frames[static_cast<std::size_t>(from.quarter & 3)], y, 1.0, 0.0) <= 0.0) break;
    }
    const QuarterHeading last = from.quarter < contact.quarter ? QuarterHeading{1.0, 0.0, from.quarter} : contact;
    const QuarterFrame& frame = frames[static_cast<std::size_t>(from.quarter & 3)];
    if (top_height(frame, y, last.c, last.s) > 0.0 || top_height(frame, y, from.c, from.s) <= 0.0) return from;
    if (from.quarter == 0) return last;
    const TurningCorner& top = frame.top;
    const double along = std::sqrt((top.radius - y) * (top.radius + y));
    return {(along * top.x - y * top.y) * top.per_square, (-y * top.x - along * top.y) * top.per_square, from.quarter};
}

}  // namespace

MaxSteerRun max_steer(const Car& car, const Slot& slot, double heading, const MaxSteerOptions& options) {
    check(options);
    check_entry_heading(heading);
    MaxSteerRun run{Outcome::no_entry, {car, {}}};
    const FullSteering steering(entering_problem(car, slot, options.driving.enter, options.driving.clearance));
    const std::vector<Headings> possible = possible_headings(steering.problem);
    if (std::none_of(possible.begin(), possible.end(),
                     [heading](const Headings& range) { return range.min <= heading && heading <= range.max; }))
        return run;

    FullSteeringRun driven(steering, heading);
    const double radius = steering.problem.radius;
    Pose pose{driven.x() + radius * driven.heading().s, driven.y() - radius * driven.heading().c, heading};
    run.outcome = Outcome::too_many_changes;
    for (int changes = 0; changes <= options.max_changes; ++changes) {
        const bool backward = driven.backward();
        const double centre_x = driven.x();
        const double centre_y = driven.y();
        const QuarterHeading start = driven.heading();
        const FullMove full = driven.drive<false>();
        if (full.stuck) {
            run.outcome = changes == 0 ? Outcome::no_entry : Outcome::stuck;
            break;
        }
        QuarterHeading end = driven.heading();
        bool touches = full.meets != Meets::nothing;
        const bool parked = full.depth <= 0.0;
        if (parked) {
            const QuarterHeading contact = touches ? end : QuarterHeading{start.c, start.s, start.quarter + 4};
            end = goal_heading(backward ? steering.backward : steering.forward, centre_y, start, contact);
            touches = touches && end.quarter == contact.quarter && end.order() == contact.order();
        } else if (!touches) {
            run.outcome = Outcome::never_touches;
            break;
        }

        const double offset = backward ? radius : -radius;
        Move move;
        move.direction = entering_direction(options.driving.enter, backward ? Direction::backward : Direction::forward);
        move.steering_angle = slot.mirrored(backward ? car.max_steer() : -car.max_steer());
        move.start = to_world(slot, options.driving.enter, pose);
        const double turned_to = end.angle();
        move.length = radius * (pose.heading - turned_to);
        pose = {centre_x + offset * end.sine(), centre_y - offset * end.cosine(), turned_to};
        move.end = to_world(slot, options.driving.enter, pose);
        if (touches) move.contact = to_world(slot, options.driving.enter, contact_of(full.meets, full.quarter));
        run.maneuver.moves.push_back(move);
        if (parked) {
            run.outcome = Outcome::parked;
            break;
        }
    }
    return run;
}

}  // namespace snug
