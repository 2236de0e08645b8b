#include "snug/fewest.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "all_maneuvers/search.hpp"
#include "contact/entering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "model/angles.hpp"
#include "model/check.hpp"
#include "snug/entry.hpp"
#include "snug/min_slot.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr int few_changes = 32;

/// Nose first, whether the nose stays in the slot (see fewest.hpp).
bool nose_stays_in(const Maneuver& maneuver, const Slot& slot, double clearance) {
    const Car& car = maneuver.car;
    const auto out = [&](const Pose& at) {
        const Pose pose = slot.to_slot(at);
        return pose.y + (car.front() + clearance) * angles::sin(pose.heading) -
                   (car.width() / 2.0 + clearance) * angles::cos(pose.heading) >
               1e-9 * car.length();
    };
    return std::none_of(maneuver.moves.begin(), maneuver.moves.end(), [&](const Move& move) {
        return move.direction == Direction::backward && (out(move.start) || out(move.end));
    });
}

/// Whether there is any room to drive in. Parallel in a slot exactly as long as the car it cannot move, and in one exactly
/// as wide it cannot turn (docs/fewest.md); only in a much wider one a car so long as the slot fits in tilted.
bool has_room(const Car& car, double length, double width, double clearance) {
    const double least_length = car.length() + 2.0 * clearance;
    const double least_width = car.width() + clearance;
    if (length < least_length || width < least_width) return false;
    if (!never_turns(car) || car.length() <= car.width()) return true;
    if (width == least_width) return false;
    if (length > least_length) return true;
    const double tilt =
        2.0 * angles::atan((car.width() + 2.0 * clearance) / least_length);  // least at which it is so short
    const double height = car.length() * angles::sin(tilt) + car.width() * angles::cos(tilt);
    return width >= std::min(height, car.length()) + clearance;
}

LeavingQuestion entering_question(const Car& car, const Slot& slot, Enter enter, double clearance) {
    return {Ground(car, slot, enter, clearance), entering_problem(car, slot, enter, clearance),
            [](Heights& heights) { heights.start_parked(); }};
}

/// The paper's best maneuver with at most so many changes, if there is one and it answers the question.
std::optional<Maneuver> with_full_steering(const LeavingQuestion& question, const Car& car, const Slot& slot,
                                           int most) {
    const std::vector<CountedHeadings> best = heading_ranges(FullSteering(question.problem), most, Find::fewest);
    const auto widest = std::max_element(best.begin(), best.end(), [](const auto& one, const auto& other) {
        return one.max - one.min < other.max - other.min;
    });
    if (widest == best.end()) return std::nullopt;
    const MaxSteerOptions drive = {widest->changes, {question.ground.clearance, {}, question.ground.enter}};
    MaxSteerRun run = max_steer(car, slot, widest->min + (widest->max - widest->min) / 2.0, drive);
    if (run.outcome != Outcome::parked) return std::nullopt;
    if (drive.driving.enter == Enter::forward && !nose_stays_in(run.maneuver, slot, drive.driving.clearance))
        return std::nullopt;
    return std::move(run.maneuver);
}

}  // namespace

Answer fewest(const Car& car, const Slot& slot, const FewestOptions& options) {
    check(options);
    if (!has_room(car, slot.length(), slot.width(), options.driving.clearance)) return impossible(options.max_changes);
    LeavingQuestion question = entering_question(car, slot, options.driving.enter, options.driving.clearance);
    question.max_changes = options.max_changes;
    question.resolution = options.resolution;
    LeavingBounds bounds;
    const Watch watch = watch_of(options, bounds);
    std::optional<Maneuver> full_steering;
    const auto ask_full_steering = [&](int most) {
        std::optional<Maneuver> found = with_full_steering(question, car, slot, most);
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
        const int depth = bounds.upper ? *bounds.upper : sensible_depth(question, watch);
        if (!bounds.upper && depth > few_changes) ask_full_steering(depth);
        narrow(question, depth, bounds, watch);
        if (const int most = bounds.upper.value_or(options.max_changes + 1) - 1; !bounds.meet() && most > depth)
            ask_full_steering(most);
        make_drivable(question, bounds, options.roomiest, watch);
    } catch (const GivenUp&) {  // the bounds are what is known
    }
    Answer answer = answer_of(question, std::move(bounds), car, slot, true);
    if (answer.direction_changes && !answer.maneuver) answer.maneuver = std::move(full_steering);
    return answer;
}

FewestLength min_length_fewest(const Car& car, double width, const FewestLengthOptions& options) {
    check_between("slot width", width, 1e-6, 1e6, " m");
    check_between("extra length to search", options.longest, 0.0, 1e6, " m");
    check_between("precision", options.precision, 1e-9, 1e6, " m");
    FewestOptions of_each;
    of_each.max_changes = options.max_changes;
    of_each.driving.clearance = options.driving.clearance;
    of_each.resolution = options.resolution;
    check(of_each);

    const double shortest = car.length() + 2.0 * options.driving.clearance;
    const double longest = car.length() + options.longest;
    FewestLength answer;
    answer.length_lower = shortest;
    if (!has_room(car, longest, width, options.driving.clearance)) {
        answer.length_lower = std::max(shortest, longest);
        return answer;
    }
    double open = longest;  // not known to be impossible
    const auto halvings = [&](double from) { return std::log2(std::max(1.0, from / options.precision)); };
    const Watch watch = [&] {
        const double left = halvings(open - answer.length_lower) / std::max(1.0, halvings(longest - shortest));
        if (options.progress && !options.progress(1.0 - left)) throw GivenUp{};
    };
    enum class Verdict { parks, impossible, undecided };
    const auto verdict = [&](double length) {
        LeavingQuestion question = entering_question(car, Slot({.length = length, .width = width}),
                                                     options.driving.enter, options.driving.clearance);
        question.max_changes = options.max_changes;
        question.resolution = options.resolution > 0.0 ? options.resolution : 5e-4 * car.length();
        question.any_upper_will_do = true;
        LeavingBounds bounds;
        bounds.upper = options.max_changes + 1;
        narrow(question, options.max_changes, bounds, watch);
        if (!bounds.moves.empty()) return Verdict::parks;
        return bounds.lower > options.max_changes ? Verdict::impossible : Verdict::undecided;
    };
    try {
        if (options.driving.enter == Enter::backward) {  // the paper's strategy is a start
            const std::optional<MinSlot> full_steering = min_length(
                car, width,
                {.max_changes = options.max_changes, .driving = options.driving, .longest = options.longest});
            if (full_steering) answer.length = full_steering->length;
        }
        open = answer.length.value_or(longest);
        if (!answer.length) {
            switch (verdict(longest)) {
                case Verdict::parks: answer.length = longest; break;
                case Verdict::impossible: answer.length_lower = longest; return answer;
                case Verdict::undecided: break;
            }
        }
        // Monotone: a longer slot holds the shorter one's maneuvers. First where it is surely impossible, then, above what
        // stays undecided, where it is sure to work.
        double undecided = shortest;
        // What the paper's strategy needs is often all there is: look just below first, then farther and farther.
        for (double below = 4.0 * options.precision; open - below > shortest; below *= 4.0) {
            const double length = open - below;
            const Verdict found = verdict(length);
            if (found == Verdict::impossible) {
                answer.length_lower = length;
                break;
            }
            if (found == Verdict::parks) answer.length = length;
            if (found == Verdict::undecided) undecided = std::max(undecided, length);
            open = length;
        }
        while (open - answer.length_lower > options.precision) {
            const double middle = (answer.length_lower + open) / 2.0;
            switch (verdict(middle)) {
                case Verdict::parks: answer.length = open = middle; break;
                case Verdict::impossible: answer.length_lower = middle; break;
                case Verdict::undecided:
                    undecided = std::max(undecided, middle);
                    open = middle;
                    break;
            }
        }
        while (answer.length && *answer.length - std::max(undecided, answer.length_lower) > options.precision) {
            const double middle = (*answer.length + std::max(undecided, answer.length_lower)) / 2.0;
            if (verdict(middle) == Verdict::parks) {
                answer.length = middle;
            } else {
                undecided = middle;
            }
        }
    } catch (const GivenUp&) {  // as far as it got
    }
    return answer;
}

}  // namespace snug
