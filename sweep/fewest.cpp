// Shortest slots over all maneuvers, for many widths and counts at once. All counts of a width are one task, from the
// smallest on: a slot that is long enough for few changes is long enough for more.
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>

#include "snug/sweep.hpp"

namespace snug {

std::vector<FewestLengthRow> min_lengths_fewest(const Car& car, const std::vector<double>& widths,
                                                const std::vector<int>& max_changes, const FewestLengthOptions& options,
                                                const SweepOptions& sweep) {
    std::vector<std::size_t> rising(max_changes.size());
    std::iota(rising.begin(), rising.end(), std::size_t{0});
    std::stable_sort(rising.begin(), rising.end(),
                     [&](std::size_t a, std::size_t b) { return max_changes[a] < max_changes[b]; });
    std::vector<FewestLengthRow> rows(widths.size() * max_changes.size());
    std::mutex telling;
    std::size_t finished = 0;
    std::atomic<bool> given_up = false;
    const auto tell = [&](std::size_t more) {
        const std::lock_guard lock(telling);
        finished += more;
        const double part = static_cast<double>(finished) / static_cast<double>(rows.size());
        if (sweep.progress && !given_up && !sweep.progress(part)) given_up = true;
        return !given_up;
    };
    const auto answer_one = [&](std::size_t i) {
        FewestLengthOptions each = options;
        each.progress = [&](double) { return tell(0); };
        for (const std::size_t k : rising) {
            each.max_changes = max_changes[k];
            const FewestLength found = min_length_fewest(car, widths[i], each);
            rows[i * max_changes.size() + k] = {max_changes[k], widths[i], found};
            if (found.length) each.longest = std::min(each.longest, *found.length - car.length());
            if (!tell(1)) return;
        }
    };
    tbb::task_arena arena(sweep.threads > 0 ? sweep.threads : tbb::task_arena::automatic);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, widths.size(), answer_one); });
    if (given_up) rows.clear();
    return rows;
}

}  // namespace snug
