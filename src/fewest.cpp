#include "snug/fewest.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "all_maneuvers/room.hpp"
#include "all_maneuvers/search.hpp"
#include "contact/entering.hpp"
#include "full_steering/heading_ranges.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr int few_changes = 32;
constexpr int most_looks = 4;  ///< at how far full steering has got

/// Nose first, whether the nose stays in the slot (see fewest.hpp).
bool nose_stays_in(const Ground& ground, const Maneuver& maneuver, const Slot& slot) {
    std::vector<Move> entering = maneuver.moves;
    for (Move& move : entering) {
        move.direction = reverse_of(move.direction);
        move.steering_angle = slot.mirrored(move.steering_angle);
        for (Pose* pose : {&move.start, &move.end}) {
            const Pose in_slot = slot.to_slot(*pose);
            *pose = {-slot.length() - in_slot.x, in_slot.y, -in_slot.heading};
        }
    }
    return nose_comes_out_once(ground, turned_round(entering));
}

/// The paper's best maneuver with at most so many changes, if there is one and it answers the question.
std::optional<Maneuver> with_full_steering(const LeavingQuestion& question, const Car& car, const Slot& slot, int most,
                                           const Watch& watch) {
    // It is a start, not the answer: where it takes long, the lattices are faster.
    int looks = 0;
    const std::vector<CountedHeadings> best =
        heading_ranges(FullSteering(question.ground.problem), most, Find::fewest, [&](double) {
            watch();
            return ++looks < most_looks;
        });
    const auto widest = std::max_element(best.begin(), best.end(), [](const auto& one, const auto& other) {
        return one.max - one.min < other.max - other.min;
    });
    if (widest == best.end()) return std::nullopt;
    const Driving& driving = question.ground.driving;
    const MaxSteerOptions drive = {widest->changes, driving, question.ground.problem.parked};
    MaxSteerRun run = max_steer(car, slot, widest->min + (widest->max - widest->min) / 2.0, drive);
    if (run.outcome != Outcome::parked) return std::nullopt;
    if (driving.enter == Enter::forward && !nose_stays_in(question.ground, run.maneuver, slot)) return std::nullopt;
    return std::move(run.maneuver);
}

}  // namespace

Answer fewest(const Car& car, const Slot& slot, const FewestOptions& options) {
    check(options);
    LeavingQuestion question = entering_question(car, slot, options.driving, options.parked);
    if (!has_room(question.ground, slot.length(), slot.width())) return impossible(options.max_changes);
    question.max_changes = options.max_changes;
    question.resolution = options.resolution;
    LeavingBounds bounds;
    const Watch watch = watch_of(options, bounds);
    std::optional<Maneuver> full_steering;
    std::vector<Move> at_hand;
    const auto ask_full_steering = [&](int most) {
        std::optional<Maneuver> found = with_full_steering(question, car, slot, most, watch);
        if (!found) return;
        bounds.upper = found->direction_changes();
        full_steering = std::move(found);
        bounds.moves.clear();
        bounds.path.reset();
    };
    try {
        // The paper's strategy is often best. Slots in which it goes to and fro for long without parking take longest, so
        // it is asked only for as many changes as the lattices may need.
        ask_full_steering(std::min(options.max_changes, few_changes));
        if (!bounds.upper && options.time_limit < std::numeric_limits<double>::infinity())
            at_hand = moves_at_hand(question, watch);
        const int depth = bounds.upper ? *bounds.upper : sensible_depth(question, watch);
        if (!bounds.upper && depth > few_changes) ask_full_steering(depth);
        narrow(question, depth, bounds, watch);
        if (const int most = bounds.upper.value_or(options.max_changes + 1) - 1; !bounds.meet() && most > depth)
            ask_full_steering(most);
        make_drivable(question, bounds, options.roomiest, watch);
    } catch (const GivenUp&) {  // the bounds are what is known
    }
    fall_back_on(std::move(at_hand), car, bounds);
    Answer answer = answer_of(question, std::move(bounds), car, slot, true);
    if (answer.direction_changes && !answer.maneuver) answer.maneuver = std::move(full_steering);
    return answer;
}

}  // namespace snug
