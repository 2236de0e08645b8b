#include "snug/fewest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// How far the outline reaches at a heading, along the slot and across it, from what touches the curb to its highest point.
struct Reach {
    double along, across;

    Reach(const Problem& problem, double sine, double cosine) {
        double front = -1e9, rear = -1e9, top = -1e9, below = -1e9;
        for (const Point& corner : problem.frame.corners()) {
            front = std::max(front, corner.x * cosine - corner.y * sine);
            rear = std::max(rear, corner.y * sine - corner.x * cosine);
            top = std::max(top, corner.x * sine + corner.y * cosine);
        }
        for (const Point& corner : problem.at_curb.corners())
            below = std::max(below, -(corner.x * sine + corner.y * cosine));
        along = front + rear;
        across = top + below;
    }
};

/// Whether the slot may hold the car at another heading than parallel. Between two headings at which a lower or an upper edge
/// lies level, how far the car reaches across is a cosine, greater than at one of the two: so only those are looked at.
bool may_stand_tilted(const Problem& problem, double width) {
    const auto fits = [&](double sine, double cosine) {
        return std::abs(sine) > 1e-12 && Reach(problem, sine, cosine).across <= width;
    };
    if (fits(1.0, 0.0) || fits(-1.0, 0.0)) return true;
    for (const Outline* outline : {&problem.frame, &problem.at_curb}) {
        const std::vector<Point>& corners = outline->corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point& from = corners[i];
            const Point& to = corners[(i + 1) % corners.size()];
            const double edge = angles::hypot(to.x - from.x, to.y - from.y);
            const double sign = to.x >= from.x ? 1.0 : -1.0;  // at most a quarter turn
            if (fits(-sign * (to.y - from.y) / edge, sign * (to.x - from.x) / edge)) return true;
        }
    }
    return false;
}

bool is_rectangle(const Car& car) {
    return car.outline() == Outline::rectangle(car.front(), car.rear(), car.width() / 2.0);
}

/// Neighbours as in the paper.
bool is_plain(const Problem& problem) { return problem.front_setback == 0.0 && problem.rear_setback == 0.0; }

/// Whether there is any room to drive in, as far as that is plain to see. Parallel in a slot exactly as long as the car it
/// cannot move, and in one exactly as wide it cannot turn (docs/fewest.md); only in a much wider one a car so long as the
/// slot fits in tilted. The lattices see to the rest.
bool has_room(const Ground& ground, double length, double width) {
    const Problem& problem = ground.problem;
    const Reach parallel(problem, 0.0, 1.0);
    const Car& car = ground.car;
    if (width < parallel.across || (width == parallel.across && never_turns(problem)))
        return may_stand_tilted(problem, width);
    if (!is_rectangle(car) || !is_plain(problem)) return true;
    const double least_length = problem.body.front() + problem.body.rear();
    if (length > least_length || (length == least_length && (!never_turns(problem) || car.length() <= car.width())))
        return true;
    // Least heading at which it is so short.
    const double tilt = 2.0 * angles::atan((problem.body.left() + problem.body.right()) / least_length);
    const double height = car.length() * angles::sin(tilt) + car.width() * angles::cos(tilt);
    return width >= std::min(height, car.length()) + (parallel.across - car.width());
}

/// No slot shorter than this can hold the car.
double shorter_than_any(const Ground& ground, double width) {
    constexpr double least = 1e-6;
    if (!has_room(ground, least, width)) return ground.problem.body.front() + ground.problem.body.rear();
    double narrowest = ground.car.length();  // of all directions from which the outline is looked at
    const std::vector<Point>& corners = ground.problem.frame.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        const double edge = angles::hypot(to.x - from.x, to.y - from.y);
        narrowest = std::min(narrowest, Reach(ground.problem, (to.x - from.x) / edge, (to.y - from.y) / edge).along);
    }
    return std::max(least, narrowest * (1.0 - 1e-12));
}

LeavingQuestion entering_question(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked) {
    return {Ground(car, slot, driving, parked), [](Heights& heights) { heights.start_parked(); }};
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

FewestLength min_length_fewest(const Car& car, double width, const FewestLengthOptions& options) {
    check_between("slot width", width, 1e-6, 1e6, " m");
    check_between("extra length to search", options.longest, 0.0, 1e6, " m");
    check_between("precision", options.precision, 1e-9, 1e6, " m");
    FewestOptions of_each;
    of_each.max_changes = options.max_changes;
    of_each.driving = options.driving;
    of_each.parked = options.parked;
    of_each.resolution = options.resolution;
    check(of_each);

    const auto slot_of = [&](double length) {
        return Slot({.length = length,
                     .width = width,
                     .front_setback = options.front_setback,
                     .rear_setback = options.rear_setback,
                     .curb = options.curb});
    };
    const double longest = car.length() + options.longest;
    const Ground ground(car, slot_of(longest), options.driving, options.parked);
    const double shortest = shorter_than_any(ground, width);
    FewestLength answer;
    answer.length_lower = shortest;
    if (!has_room(ground, longest, width)) {
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
        LeavingQuestion question = entering_question(car, slot_of(length), options.driving, options.parked);
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
        const bool paper = is_rectangle(car) && is_plain(ground.problem) && options.curb == Curb::high;
        if (options.driving.enter == Enter::backward && paper) {  // the paper's strategy is a start
            const std::optional<MinSlot> full_steering = min_length(car, width,
                                                                    {.max_changes = options.max_changes,
                                                                     .driving = options.driving,
                                                                     .parked = options.parked,
                                                                     .longest = options.longest});
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
