// Minimum slots for many widths (or lengths) and counts at once, every one a task of its own. Tasks share nothing, so
// answers do not depend on the number of threads.
#include "snug/sweep.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <cstddef>
#include <mutex>

namespace snug {

namespace {

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

using Question = std::optional<MinSlot> (*)(const Car&, double, const MinSlotOptions&);

std::vector<MinSlotRow> sweep_over(Question question, const Car& car, const std::vector<double>& given,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                   const SweepOptions& sweep) {
    std::vector<MinSlotRow> rows(given.size() * max_changes.size());
    tbb::task_group_context work;
    Progress progress(sweep.progress, rows.size(), work);
    const auto answer = [&](std::size_t i) {
        MinSlotOptions one = options;
        one.max_changes = max_changes[i / given.size()];
        rows[i] = {one.max_changes, given[i % given.size()], question(car, given[i % given.size()], one)};
        progress.finished_one();
    };
    tbb::task_arena arena(sweep.threads > 0 ? sweep.threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, rows.size(), answer, tbb::simple_partitioner{}, work); });
    if (progress.cancelled()) rows.clear();
    return rows;
}

}  // namespace

std::vector<MinSlotRow> min_lengths(const Car& car, const std::vector<double>& widths,
                                    const std::vector<int>& max_changes, const MinSlotOptions& options,
                                    const SweepOptions& sweep) {
    return sweep_over(min_length, car, widths, max_changes, options, sweep);
}

std::vector<MinSlotRow> min_widths(const Car& car, const std::vector<double>& lengths,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options,
                                   const SweepOptions& sweep) {
    return sweep_over(min_width, car, lengths, max_changes, options, sweep);
}

}  // namespace snug
