// Entry positions for many slots, and direction changes for many headings, a few of them at a time on each core.
#include <algorithm>
#include <cstddef>
#include <functional>

#include "sentences/check.hpp"
#include "snug/sweep.hpp"
#include "tasks.hpp"

namespace snug {

namespace {

/// Calls `answer_some(first, last, go_on)` for all of them in pieces; false when the asker gave up. `go_on` asks him.
template <class AnswerSome>
bool in_pieces(std::size_t all, std::size_t piece, const SweepOptions& sweep, const AnswerSome& answer_some) {
    Progress progress(sweep, all);
    on_all_cores((all + piece - 1) / piece, sweep, progress, [&](std::size_t task) {
        const std::size_t first = task * piece;
        const std::size_t last = std::min(first + piece, all);
        answer_some(first, last, [&] { return progress.finished(0); });
        progress.finished(last - first);
    });
    return !progress.given_up();
}

std::vector<int> changes_in_pieces(std::size_t all, const MaxSteerOptions& options, const SweepOptions& sweep,
                                   const std::function<std::vector<int>(std::size_t, std::size_t)>& answer) {
    constexpr double moves_in_a_piece = 1e6;  // 40 ms at most
    const auto piece =
        static_cast<std::size_t>(std::clamp(moves_in_a_piece / (options.max_changes + 1.0), 64.0, 4096.0));
    std::vector<int> changes(all);
    const bool finished = in_pieces(all, piece, sweep, [&](std::size_t first, std::size_t last, const auto&) {
        const std::vector<int> some = answer(first, last);
        std::copy(some.begin(), some.end(), changes.begin() + static_cast<std::ptrdiff_t>(first));
    });
    if (!finished) changes.clear();
    return changes;
}

template <class T>
std::vector<T> slice(const std::vector<T>& all, std::size_t first, std::size_t last) {
    return {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace

std::vector<EntryRow> entries(const Car& car, const std::vector<Slot>& slots, const EntryOptions& options,
                              const SweepOptions& sweep, const std::optional<Baseline>& baseline) {
    std::vector<EntryRow> rows(slots.size());
    const bool finished =
        in_pieces(slots.size(), 8, sweep, [&](std::size_t first, std::size_t last, const auto& go_on) {
            EntryOptions each = options;
            each.prove = false;
            each.progress = [&](double) { return go_on(); };
            for (std::size_t i = first; i < last; ++i) {
                const Answer answer = baseline ? entry(car, slots[i], each, *baseline) : entry(car, slots[i], each);
                if (answer.cancelled) return;
                if (!answer.direction_changes) continue;
                rows[i].direction_changes = answer.direction_changes;
                if (const HeadingRange* widest = widest_range(answer.ranges, *answer.direction_changes))
                    rows[i].widest = *widest;
            }
        });
    if (!finished) rows.clear();
    return rows;
}

std::vector<int> direction_changes(const Car& car, const Slot& slot, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep) {
    check_headings(headings);
    return changes_in_pieces(headings.size(), options, sweep, [&](std::size_t first, std::size_t last) {
        return direction_changes(car, slot, slice(headings, first, last), options);
    });
}

std::vector<int> direction_changes(const Car& car, const std::vector<Slot>& slots, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep) {
    check_as_many(slots.size(), headings.size());
    check_headings(headings);
    return changes_in_pieces(headings.size(), options, sweep, [&](std::size_t first, std::size_t last) {
        return direction_changes(car, slice(slots, first, last), slice(headings, first, last), options);
    });
}

}  // namespace snug
