// The smallest roads and bays for many streets and counts at once. A street is a task: what does with few changes does with more.
#include <algorithm>
#include <cstddef>
#include <set>

#include "snug/sweep.hpp"
#include "tasks.hpp"

namespace snug {

std::vector<MinStreet> min_streets(const Car& car, const std::vector<Street>& streets,
                                   const std::vector<int>& max_changes, const MinStreetOptions& options,
                                   const SweepOptions& sweep) {
    const std::set<int> rising(max_changes.begin(), max_changes.end());
    std::vector<MinStreet> rows(streets.size() * max_changes.size());
    Progress progress(sweep, streets.size() * rising.size());
    on_all_cores(streets.size(), sweep, progress, [&](std::size_t i) {
        MinStreetOptions each = options;
        each.progress = [&](double) { return progress.finished(0); };
        for (const int changes : rising) {
            each.max_changes = changes;
            const MinStreet found = min_street(car, streets[i], each);
            for (std::size_t k = 0; k < max_changes.size(); ++k)
                if (max_changes[k] == changes) rows[i * max_changes.size() + k] = found;
            if (found.size) each.largest = *found.size;
            progress.finished(1);
        }
    });
    for (std::size_t i = 0; i < rows.size(); ++i) {
        // Those that nobody began.
        if (!progress.given_up() || rows[i].lower > 0.0) continue;
        rows[i].max_changes = max_changes[i % max_changes.size()];
        rows[i].cancelled = true;
    }
    return rows;
}

}  // namespace snug
