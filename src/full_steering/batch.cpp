#include "snug/batch.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/entering.hpp"
#include "contact/entry_corner.hpp"
#include "full_steering/cases.hpp"
#include "sentences/check.hpp"

namespace snug {

namespace detail {

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

Cases::Cases(FullSteering& steering, Enter enter, const std::vector<double>& headings, const std::vector<Slot>* slots,
             int max_changes)
    : steering_(steering),
      enter_(enter),
      headings_(headings),
      slots_(slots),
      max_changes_(max_changes),
      changes_(headings.size()) {
    if (slots == nullptr) possible_ = possible_headings(steering.problem, steering.entry);
}

void Cases::prepare() {
    taken_ = prepared_ = 0;
    for (; next_ < headings_.size() && prepared_ < starts_.size(); ++next_) {
        enter_slot(next_);
        const FullSteeringRun run(steering_, headings_[next_]);
        const QuarterHeading& direction = run.heading();
        if (is_entry(headings_[next_], direction)) {
            starts_[prepared_++] = {next_,
                                    run.x(),
                                    run.y(),
                                    direction.c,
                                    direction.s,
                                    steering_.problem.length,
                                    steering_.problem.width,
                                    steering_.problem.front_setback,
                                    steering_.problem.rear_setback};
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
    const Slot& slot = (*slots_)[index];
    Problem& problem = steering_.problem;
    problem.length = slot.length();
    problem.width = slot.width();
    problem.front_setback = enter_ == Enter::backward ? slot.front_setback() : slot.rear_setback();
    problem.rear_setback = enter_ == Enter::backward ? slot.rear_setback() : slot.front_setback();
    steering_.height_decides = by_height_alone(problem);
}

bool Cases::in_vectors() const {
    const auto is_plain = [](const Slot& slot) { return slot.front_setback() == 0.0 && slot.rear_setback() == 0.0; };
    const Problem& problem = steering_.problem;
    return steering_.backward.rectangle && problem.at_curb == problem.body && steering_.height_decides &&
           (slots_ == nullptr || std::all_of(slots_->begin(), slots_->end(), is_plain));
}

bool Cases::is_entry(double heading, const QuarterHeading& direction) const {
    if (slots_ == nullptr) return lies_in(possible_, heading);
    return is_possible(steering_.problem, steering_.entry, heading, direction.c, direction.s);
}

}  // namespace detail

namespace {

using namespace detail;

/// The cases of one outline in the entering frame.
std::vector<int> drive_all(const Car& car, const Slot& first, const std::vector<Slot>* slots,
                           const std::vector<double>& headings, const MaxSteerOptions& options) {
    FullSteering steering(entering_problem(car, first, options.driving, options.parked));
    Cases cases(steering, options.driving.enter, headings, slots, options.max_changes);
    if (cases.in_vectors()) {
        detail::drive_all(cases);
    } else {
        while (const Cases::Start* start = cases.next()) cases.answer_alone(start->index);
    }
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
    // The outlines of an odd car, and those that a low curb stops, are others for other slots.
    const bool even = car.outline() == car.outline().mirrored();
    const auto kind = [even](const Slot& slot) { return std::pair(slot.curb(), even ? Side::right : slot.side()); };
    if (std::all_of(slots.begin(), slots.end(), [&](const Slot& slot) { return kind(slot) == kind(slots.front()); }))
        return slots.empty() ? std::vector<int>() : drive_all(car, slots.front(), &slots, headings, options);
    std::vector<int> changes(slots.size(), -1);
    std::vector<bool> done(slots.size(), false);
    for (std::size_t next = 0; next < slots.size(); ++next) {
        if (done[next]) continue;
        std::vector<Slot> alike;
        std::vector<double> their_headings;
        std::vector<std::size_t> indices;
        for (std::size_t i = next; i < slots.size(); ++i) {
            if (done[i] || kind(slots[i]) != kind(slots[next])) continue;
            done[i] = true;
            indices.push_back(i);
            alike.push_back(slots[i]);
            their_headings.push_back(headings[i]);
        }
        const std::vector<int> found = drive_all(car, slots[next], &alike, their_headings, options);
        for (std::size_t i = 0; i < indices.size(); ++i) changes[indices[i]] = found[i];
    }
    return changes;
}

}  // namespace snug
