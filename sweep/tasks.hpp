// Tasks on all cores, and what the asker says to their progress.
#pragma once

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

#include "snug/sweep.hpp"
#include "sweep/cores.hpp"

namespace snug {

/// Counts what is finished of so many parts, and tells the asker.
class Progress {
public:
    Progress(const SweepOptions& sweep, std::size_t parts) : tell_(sweep.progress), parts_(parts) {}

    /// False when there is no need to go on.
    bool finished(std::size_t more) {
        const std::lock_guard lock(mutex_);
        finished_ += more;
        const double part = static_cast<double>(finished_) / static_cast<double>(parts_);
        if (tell_ && !given_up_ && !tell_(part)) given_up_ = true;
        return !given_up_;
    }
    [[nodiscard]] bool given_up() const { return given_up_; }

private:
    const std::function<bool(double)>& tell_;
    std::size_t parts_;
    std::mutex mutex_;
    std::size_t finished_ = 0;
    std::atomic<bool> given_up_ = false;
};

/// Calls `answer(task)` for all tasks from 0 on, each a task of its own; none begins once the asker has given up.
template <class Answer>
void on_all_cores(std::size_t tasks, const SweepOptions& sweep, const Progress& progress, const Answer& answer) {
    tbb::task_arena arena(threads_at_once(sweep.threads));
    arena.execute([&] {
        tbb::parallel_for(
            std::size_t{0}, tasks,
            [&](std::size_t task) {
                if (!progress.given_up()) answer(task);
            },
            tbb::simple_partitioner{});
    });
}

}  // namespace snug
