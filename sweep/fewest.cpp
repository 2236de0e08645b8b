// Shortest slots over all maneuvers, for many widths and counts at once. All counts of a width are one task, from the
// smallest on: a slot that is long enough for few changes is long enough for more.
#include <algorithm>
#include <numeric>

#include "snug/sweep.hpp"
#include "tasks.hpp"

namespace snug {

std::vector<FewestLengthRow> min_lengths_fewest(const Car& car, const std::vector<double>& widths,
                                                const std::vector<int>& max_changes, const FewestLengthOptions& options,
                                                const SweepOptions& sweep) {
    std::vector<std::size_t> rising(max_changes.size());
    std::iota(rising.begin(), rising.end(), std::size_t{0});
    std::stable_sort(rising.begin(), rising.end(),
                     [&](std::size_t a, std::size_t b) { return max_changes[a] < max_changes[b]; });
    std::vector<FewestLengthRow> rows(widths.size() * max_changes.size());
    Progress progress(sweep, rows.size());
    const auto answer_one = [&](std::size_t i) {
        FewestLengthOptions each = options;
        each.progress = [&](double) { return progress.finished(0); };
        for (const std::size_t k : rising) {
            each.max_changes = max_changes[k];
            const FewestLength found = min_length_fewest(car, widths[i], each);
            rows[i * max_changes.size() + k] = {max_changes[k], widths[i], found};
            if (found.length) each.longest = std::min(each.longest, *found.length - car.length());
            if (!progress.finished(1)) return;
        }
    };
    on_all_cores(widths.size(), sweep, progress, answer_one);
    if (progress.given_up()) rows.clear();
    return rows;
}

}  // namespace snug
