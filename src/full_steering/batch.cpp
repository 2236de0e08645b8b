#include "snug/batch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/entering.hpp"
#include "full_steering/cases.hpp"
#include "model/check.hpp"

namespace snug {

namespace detail {

namespace {

bool lies_in(const std::vector<Headings>& ranges, double heading) {
    return std::any_of(ranges.begin(), ranges.end(),
                       [heading](const Headings& range) { return range.min <= heading && heading <= range.max; });
}

/// By how much the frame clears what it could overlap at the entry position, and its corner the front side on the first
/// move: possible_headings() without its inverse functions, so exact but for rounding. [m]
double entry_clears(const Problem& problem, double c, double s) {
    const Extents& car = problem.touching;
    const double length = car.front + car.rear;
    const double width = car.left + car.right;
    const double front_and_curb =
        std::min((problem.radius + car.right) * c - car.front * s, problem.width - length * s);
    const double tail_below = width * c - length * s;  // the entry side
    const double rear = std::max(std::min(problem.length * c - length, tail_below),
                                 std::min(problem.length - length * c - width * s, -tail_below));
    return std::min({front_and_curb, rear, problem.length - length});
}

}  // namespace

int direction_changes_alone(const FullSteering& steering, double heading, int max_changes) {
    FullSteeringRun run(steering, heading);
    for (int changes = 0; changes <= max_changes; ++changes) {
        const FullMove move = run.drive<false>();
        if (move.stuck) return -1;
        if (move.depth <= 0.0) return changes;
        if (move.meets == Meets::nothing) return -1;
    }
    return -1;
}

Cases::Cases(FullSteering& steering, const std::vector<double>& headings, const std::vector<Slot>* slots,
             int max_changes)
    : steering_(steering), headings_(headings), slots_(slots), max_changes_(max_changes), changes_(headings.size()) {
    if (slots == nullptr) possible_ = possible_headings(steering.problem);
}

void Cases::prepare() {
    taken_ = prepared_ = 0;
    for (; next_ < headings_.size() && prepared_ < starts_.size(); ++next_) {
        enter_slot(next_);
        const FullSteeringRun run(steering_, headings_[next_]);
        const QuarterHeading& direction = run.heading();
        if (is_entry(headings_[next_], direction)) {
            starts_[prepared_++] = {
                next_, run.x(), run.y(), direction.c, direction.s, steering_.problem.length, steering_.problem.width};
        } else {
            answer(next_, -1);
        }
    }
}

void Cases::answer_alone(std::size_t index) {
    enter_slot(index);
    answer(index, direction_changes_alone(steering_, headings_[index], max_changes_));
}

void Cases::enter_slot(std::size_t index) {
    if (slots_ == nullptr) return;
    steering_.problem.length = (*slots_)[index].length();
    steering_.problem.width = (*slots_)[index].width();
}

bool Cases::is_entry(double heading, const QuarterHeading& direction) const {
    if (slots_ == nullptr) return lies_in(possible_, heading);
    const Problem& problem = steering_.problem;
    const double clears = entry_clears(problem, direction.c, direction.s);
    const double close = 1e-9 * (problem.length + problem.touching.front + problem.touching.rear + problem.radius);
    if (std::abs(clears) > close) return clears > 0.0;
    return lies_in(possible_headings(problem), heading);
}

}  // namespace detail

namespace {

using namespace detail;

std::vector<int> drive_all(const Car& car, const Slot& first, const std::vector<Slot>* slots,
                           const std::vector<double>& headings, const MaxSteerOptions& options) {
    FullSteering steering(entering_problem(car, first, options.driving.enter, options.driving.clearance));
    Cases cases(steering, headings, slots, options.max_changes);
    detail::drive_all(cases);
    return std::move(cases.answers());
}

}  // namespace

std::vector<int> direction_changes(const Car& car, const Slot& slot, const std::vector<double>& headings,
                                   const MaxSteerOptions& options) {
    check(options);
    check_headings(headings);
    return drive_all(car, slot, nullptr, headings, options);
}

std::vector<int> direction_changes(const Car& car, const std::vector<Slot>& slots, const std::vector<double>& headings,
                                   const MaxSteerOptions& options) {
    check(options);
    check_as_many(slots.size(), headings.size());
    check_headings(headings);
    if (slots.empty()) return {};
    return drive_all(car, slots.front(), &slots, headings, options);
}

}  // namespace snug
