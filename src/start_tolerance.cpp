#include "snug/start_tolerance.hpp"

#include <algorithm>

#include "contact/entering.hpp"
#include "full_steering/full_steering.hpp"
#include "full_steering/proof/proof.hpp"
#include "full_steering/proof/starts.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"
#include "snug/driving.hpp"

namespace snug {

std::optional<StartTolerance> start_tolerance(const Car& car, const Slot& slot, double heading,
                                              const MaxSteerOptions& options) {
    const MaxSteerRun run = max_steer(car, slot, heading, options);
    if (run.outcome != Outcome::parked) return std::nullopt;
    StartTolerance tolerance;
    tolerance.heading = heading;
    tolerance.direction_changes = run.maneuver.direction_changes();
    // The other end must not reach the other neighbour.
    const Gaps room = gaps(car, slot, run.maneuver.entry(), options.driving);
    const double along = options.driving.enter == Enter::backward ? room.rear : room.front;
    detail::prove_starts(detail::proof_problem(car, slot, options.driving, options.parked), std::max(along, 0.0),
                         tolerance);
    return tolerance;
}

std::optional<StartTolerance> start_tolerance(const Car& car, const Slot& slot, const Answer& answer,
                                              const EntryOptions& options) {
    if (!answer.direction_changes) return std::nullopt;
    const HeadingRange* range = widest_range(answer.ranges, *answer.direction_changes);
    if (range == nullptr) return std::nullopt;
    return start_tolerance(car, slot, middle(*range), {*answer.direction_changes, options.driving, options.parked});
}

}  // namespace snug
