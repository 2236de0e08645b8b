// Minimum slots for many widths (or lengths) and counts at once. All counts of a few neighbouring widths are one task: the
// answer for one count is where the search for the next begins, and headings that do for one width are tried for the
// next. Tasks share nothing, so answers do not depend on the number of threads.
#include "snug/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>

#include "full_steering/smallest_slot.hpp"
#include "sentences/check.hpp"
#include "snug/entry.hpp"
#include "tasks.hpp"

namespace snug {

namespace {

using Slots = std::vector<std::optional<MinSlot>>;

/// The smallest slots for rising counts at one width (or length), given those of a neighbour or none; any, once the
/// progress says not to go on.
using Rows =
    std::function<Slots(double given, const std::vector<int>& rising, const Slots& neighbours, Progress& progress)>;

std::vector<MinSlotRow> sweep_over(const std::vector<double>& given, const std::vector<int>& max_changes,
                                   std::size_t per_task, const SweepOptions& sweep, const Rows& answer) {
    const std::set<int> counts(max_changes.begin(), max_changes.end());
    const std::vector<int> rising(counts.begin(), counts.end());
    std::vector<std::size_t> columns(given.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::stable_sort(columns.begin(), columns.end(), [&](std::size_t a, std::size_t b) { return given[a] < given[b]; });

    std::vector<MinSlotRow> rows(given.size() * max_changes.size());
    Progress progress(sweep, given.size());
    const auto answer_some = [&](std::size_t task) {
        Slots slots;
        for (std::size_t i = task * per_task; i < std::min((task + 1) * per_task, columns.size()); ++i) {
            if (progress.given_up()) return;
            const std::size_t column = columns[i];
            slots = answer(given[column], rising, slots, progress);
            for (std::size_t k = 0; k < max_changes.size(); ++k) {
                const auto at = std::lower_bound(rising.begin(), rising.end(), max_changes[k]) - rising.begin();
                rows[k * given.size() + column] = {max_changes[k], given[column], slots[static_cast<std::size_t>(at)]};
            }
            progress.finished(1);
        }
    };
    const std::size_t tasks = (given.size() + per_task - 1) / per_task;
    on_all_cores(tasks, sweep, progress, answer_some);
    if (progress.given_up()) rows.clear();
    return rows;
}

std::vector<MinSlotRow> exactly(detail::Sought sought, const Car& car, const std::vector<double>& given,
                                const std::vector<int>& max_changes, const MinSlotOptions& options,
                                const SweepOptions& sweep) {
    constexpr std::size_t neighbours_in_a_task = 4;
    return sweep_over(given, max_changes, neighbours_in_a_task, sweep,
                      [&](double size, const std::vector<int>& rising, const Slots& neighbours, Progress&) {
                          return detail::smallest_slots(car, sought, size, rising, options, neighbours);
                      });
}

/// Algorithm 1 in larger and larger slots, until the smallest count is enough.
Slots slots_by_stepping(detail::Sought sought, const Car& car, double given, const std::vector<int>& rising,
                        const Stepping& stepping, double step, const MinSlotOptions& options, Progress& progress) {
    EntryOptions question;
    question.progress = [&](double) { return progress.finished(0); };
    question.min_range = options.min_range;
    question.driving = options.driving;
    question.parked = options.parked;
    question.strategy = stepping;
    const bool length = sought == detail::Sought::length;
    const double least =
        length ? car.length() + 2.0 * options.driving.clearance : car.width() + options.driving.clearance;
    const double most = least + (length ? options.longest : options.widest) + 1e-9;
    Slots slots(rising.size());
    std::size_t open = rising.size();  // counts without a slot yet, the smaller ones
    for (double i = 0.0; open > 0 && least + i * step <= most; ++i) {
        const double size = std::round((least + i * step) * 1e12) / 1e12;  // 4.674, not 4.6739999999999995
        const Slot slot({.length = length ? size : given, .width = length ? given : size});
        question.max_changes = rising[open - 1];
        const Answer found = entry(car, slot, question);
        if (found.cancelled) break;
        if (!found.direction_changes) continue;
        const double heading = middle(*widest_range(found.ranges, *found.direction_changes));
        for (; open > 0 && *found.direction_changes <= rising[open - 1]; --open)
            slots[open - 1] = MinSlot{slot.length(), slot.width(), heading};
    }
    return slots;
}

std::vector<MinSlotRow> by_stepping(detail::Sought sought, const Car& car, const std::vector<double>& given,
                                    const std::vector<int>& max_changes, const Stepping& stepping, double step,
                                    const MinSlotOptions& options, const SweepOptions& sweep) {
    check_between(sought == detail::Sought::length ? "length step" : "width step", step, 1e-6, 1e6, " m");
    return sweep_over(given, max_changes, 1, sweep,
                      [&](double size, const std::vector<int>& rising, const Slots&, Progress& progress) {
                          return slots_by_stepping(sought, car, size, rising, stepping, step, options, progress);
                      });
}

}  // namespace

std::vector<MinSlotRow> min_lengths(const Car& car, const std::vector<double>& widths,
                                    const std::vector<int>& max_changes, const MinSlotOptions& options,
                                    const SweepOptions& sweep) {
    return exactly(detail::Sought::length, car, widths, max_changes, options, sweep);
}

std::vector<MinSlotRow> min_widths(const Car& car, const std::vector<double>& lengths,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                   const SweepOptions& sweep) {
    return exactly(detail::Sought::width, car, lengths, max_changes, options, sweep);
}

std::vector<MinSlotRow> min_lengths_by_stepping(const Car& car, const std::vector<double>& widths,
                                                const std::vector<int>& max_changes, const Stepping& stepping,
                                                double step, const MinSlotOptions& options, const SweepOptions& sweep) {
    return by_stepping(detail::Sought::length, car, widths, max_changes, stepping, step, options, sweep);
}

std::vector<MinSlotRow> min_widths_by_stepping(const Car& car, const std::vector<double>& lengths,
                                               const std::vector<int>& max_changes, const Stepping& stepping,
                                               double step, const MinSlotOptions& options, const SweepOptions& sweep) {
    return by_stepping(detail::Sought::width, car, lengths, max_changes, stepping, step, options, sweep);
}

}  // namespace snug
