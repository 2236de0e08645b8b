// Minimum slots for many widths (or lengths) and counts at once. All counts of a few neighbouring widths are one task: the
// answer for one count is where the search for the next begins, and headings that do for one width are tried for the
// next. Tasks share nothing, so answers do not depend on the number of threads.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <set>

#include "contact/sized_slot.hpp"
#include "full_steering/proof/sizes.hpp"
#include "full_steering/smallest_slot.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"
#include "snug/sweep.hpp"
#include "tasks.hpp"

namespace snug {

namespace {

using Slots = std::vector<MinSlot>;

/// The smallest slots for rising counts at one width (or length), given those of a neighbour or none; any, once the
/// progress says not to go on.
using Rows =
    std::function<Slots(double given, const std::vector<int>& rising, const Slots& neighbours, Progress& progress)>;

Slots sweep_over(const std::vector<double>& given, const std::vector<int>& max_changes, std::size_t per_task,
                 const SweepOptions& sweep, const Rows& answer) {
    const std::set<int> counts(max_changes.begin(), max_changes.end());
    const std::vector<int> rising(counts.begin(), counts.end());
    std::vector<std::size_t> columns(given.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::stable_sort(columns.begin(), columns.end(), [&](std::size_t a, std::size_t b) { return given[a] < given[b]; });

    Slots rows(given.size() * max_changes.size());
    Progress progress(sweep, given.size());
    const auto answer_some = [&](std::size_t task) {
        Slots slots;
        for (std::size_t i = task * per_task; i < std::min((task + 1) * per_task, columns.size()); ++i) {
            if (progress.given_up()) return;
            const std::size_t column = columns[i];
            slots = answer(given[column], rising, slots, progress);
            for (std::size_t k = 0; k < max_changes.size(); ++k) {
                const auto at = std::lower_bound(rising.begin(), rising.end(), max_changes[k]) - rising.begin();
                rows[k * given.size() + column] = slots[static_cast<std::size_t>(at)];
            }
            progress.finished(1);
        }
    };
    const std::size_t tasks = (given.size() + per_task - 1) / per_task;
    on_all_cores(tasks, sweep, progress, answer_some);
    if (progress.given_up()) rows.clear();
    return rows;
}

/// Over all maneuvers: a slot that is large enough for few changes is large enough for more.
Slots of_all_maneuvers(const Car& car, double given, const std::vector<int>& rising, const MinSlotOptions& options) {
    Slots slots;
    MinSlotOptions each = options;
    double& most = options.sought == Sought::length ? each.longest : each.widest;
    const double from = detail::sizes_to_search(car, given, options).parallel;
    for (const int changes : rising) {
        each.max_changes = changes;
        slots.push_back(min_slot(car, given, each));
        if (slots.back().cancelled) {
            slots.resize(rising.size(), slots.back());
            return slots;
        }
        if (const auto& size = slots.back().size(options.sought)) most = std::max(0.0, std::min(most, *size - from));
    }
    return slots;
}

/// Algorithm 1 in larger and larger slots, until the smallest count is enough.
Slots by_stepping(const Car& car, double given, const std::vector<int>& rising, const Stepping& stepping, double step,
                  const MinSlotOptions& options, Progress& progress) {
    EntryOptions question;
    question.progress = [&](double) { return progress.finished(0); };
    question.min_range = options.min_range;
    question.driving = options.driving;
    question.parked = options.parked;
    const bool length = options.sought == Sought::length;
    const double least = detail::sizes_to_search(car, given, options).parallel;
    const double most = least + (length ? options.longest : options.widest) + 1e-9;
    Slots slots;
    for (const int changes : rising) {
        slots.emplace_back().max_changes = changes;
        (length ? slots.back().width : slots.back().length) = given;
    }
    std::size_t open = rising.size();  // counts without a slot yet, the smaller ones
    for (double i = 0.0; open > 0 && least + i * step <= most; ++i) {
        const double size = std::round((least + i * step) * 1e12) / 1e12;  // 4.674, not 4.6739999999999995
        question.max_changes = rising[open - 1];
        const Answer found = entry(car, detail::slot_of(options, given, size), question, stepping);
        if (found.cancelled) break;
        if (!found.direction_changes) continue;
        const double heading = middle(*widest_range(found.ranges, *found.direction_changes));
        for (; open > 0 && *found.direction_changes <= rising[open - 1]; --open) {
            (length ? slots[open - 1].length : slots[open - 1].width) = size;
            slots[open - 1].entry_heading = heading;
        }
    }
    return slots;
}

}  // namespace

std::vector<MinSlot> min_slots(const Car& car, const std::vector<double>& given, const std::vector<int>& max_changes,
                               const MinSlotOptions& options, const SweepOptions& sweep) {
    const bool fewest = options.strategy == Strategy::fewest;
    const std::size_t neighbours_in_a_task = fewest ? 1 : 4;
    return sweep_over(given, max_changes, neighbours_in_a_task, sweep,
                      [&](double size, const std::vector<int>& rising, const Slots& neighbours, Progress& progress) {
                          MinSlotOptions each = options;
                          each.progress = [&](double) { return progress.finished(0); };
                          if (fewest) return of_all_maneuvers(car, size, rising, each);
                          Slots slots = detail::smallest_slots(car, size, rising, each, neighbours);
                          for (MinSlot& slot : slots) {
                              each.max_changes = slot.max_changes;
                              if (each.prove && !slot.cancelled) detail::prove_smaller(car, size, each, slot);
                          }
                          return slots;
                      });
}

std::vector<MinSlot> min_slots_by_stepping(const Car& car, const std::vector<double>& given,
                                           const std::vector<int>& max_changes, const Stepping& stepping, double step,
                                           const MinSlotOptions& options, const SweepOptions& sweep) {
    check_between(options.sought == Sought::length ? "length step" : "width step", step, limits::shortest,
                  limits::longest, " m");
    return sweep_over(given, max_changes, 1, sweep,
                      [&](double size, const std::vector<int>& rising, const Slots&, Progress& progress) {
                          return by_stepping(car, size, rising, stepping, step, options, progress);
                      });
}

}  // namespace snug
