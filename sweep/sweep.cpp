// Minimum slots for many widths (or lengths) and counts at once. All counts of a few neighbouring widths are one task: the
// answer for one count is where the search for the next begins, and headings that do for one width are tried for the
// next. Tasks share nothing, so answers do not depend on the number of threads.
#include "snug/sweep.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <set>

#include "smallest_slot.hpp"

namespace snug {

namespace {

constexpr std::size_t per_task = 4;

/// Counts finished tasks and passes on what the asker says to that.
class Progress {
public:
    Progress(const std::function<bool(double)>& tell, std::size_t tasks, tbb::task_group_context& work)
        : tell_(tell), tasks_(tasks), work_(work) {}

    void finished_one() {
        const std::lock_guard lock(mutex_);
        ++finished_;
        if (!tell_ || cancelled_) return;
        cancelled_ = !tell_(static_cast<double>(finished_) / static_cast<double>(tasks_));
        if (cancelled_) work_.cancel_group_execution();
    }
    [[nodiscard]] bool cancelled() const { return cancelled_; }

private:
    const std::function<bool(double)>& tell_;
    std::size_t tasks_;
    tbb::task_group_context& work_;
    std::mutex mutex_;
    std::size_t finished_ = 0;
    bool cancelled_ = false;
};

std::vector<MinSlotRow> sweep_over(detail::Sought sought, const Car& car, const std::vector<double>& given,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                   const SweepOptions& sweep) {
    const std::set<int> counts(max_changes.begin(), max_changes.end());
    const std::vector<int> rising(counts.begin(), counts.end());
    std::vector<std::size_t> columns(given.size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::stable_sort(columns.begin(), columns.end(), [&](std::size_t a, std::size_t b) { return given[a] < given[b]; });

    std::vector<MinSlotRow> rows(given.size() * max_changes.size());
    tbb::task_group_context work;
    Progress progress(sweep.progress, given.size(), work);
    const auto answer_some = [&](std::size_t task) {
        std::vector<std::optional<MinSlot>> slots;
        for (std::size_t i = task * per_task; i < std::min((task + 1) * per_task, columns.size()); ++i) {
            if (work.is_group_execution_cancelled()) return;
            const std::size_t column = columns[i];
            slots = detail::smallest_slots(car, sought, given[column], rising, options, slots);
            for (std::size_t k = 0; k < max_changes.size(); ++k) {
                const auto at = std::lower_bound(rising.begin(), rising.end(), max_changes[k]) - rising.begin();
                rows[k * given.size() + column] = {max_changes[k], given[column], slots[static_cast<std::size_t>(at)]};
            }
            progress.finished_one();
        }
    };
    const std::size_t tasks = (given.size() + per_task - 1) / per_task;
    tbb::task_arena arena(sweep.threads > 0 ? sweep.threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, tasks, answer_some, tbb::simple_partitioner{}, work); });
    if (progress.cancelled()) rows.clear();
    return rows;
}

}  // namespace

std::vector<MinSlotRow> min_lengths(const Car& car, const std::vector<double>& widths,
                                    const std::vector<int>& max_changes, const MinSlotOptions& options,
                                    const SweepOptions& sweep) {
    return sweep_over(detail::Sought::length, car, widths, max_changes, options, sweep);
}

std::vector<MinSlotRow> min_widths(const Car& car, const std::vector<double>& lengths,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                   const SweepOptions& sweep) {
    return sweep_over(detail::Sought::width, car, lengths, max_changes, options, sweep);
}

}  // namespace snug
