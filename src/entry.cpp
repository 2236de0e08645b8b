#include "snug/entry.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "baselines/stepping_entry.hpp"
#include "contact/entering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "full_steering/widest_range.hpp"
#include "model/check.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr int most_changes = 200;  ///< where the search ends unless told otherwise
constexpr double inward = 2e-13;   ///< edges are moved this far into their range, beyond any rounding [rad]

/// The smallest count for which some stretch of headings is wide enough; empty if there is none.
std::optional<int> fewest_changes(const std::vector<CountedHeadings>& ranges, double width) {
    std::vector<int> counts;
    for (const CountedHeadings& range : ranges) counts.push_back(range.changes);
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    for (const int changes : counts) {
        if (!stretches(ranges, changes, width).empty()) return changes;
    }
    return std::nullopt;
}

/// The ranges of all wide enough stretches, edges rounded inward.
std::vector<HeadingRange> ranges_of(const std::vector<CountedHeadings>& found, int changes, double width) {
    std::vector<HeadingRange> ranges;
    int subrange = 0;
    for (const Stretch& stretch : stretches(found, changes, width)) {
        for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
            const double edge = std::min(inward, (found[i].max - found[i].min) / 4.0);
            const double min = found[i].min > 0.0 ? found[i].min + edge : 0.0;
            ranges.push_back({min, found[i].max - edge, found[i].changes, subrange});
        }
        ++subrange;
    }
    return ranges;
}

Answer max_steer_entry(const Car& car, const Slot& slot, const EntryOptions& options) {
    Answer answer;
    const FullSteering steering(entering_problem(car, slot, options.driving, options.parked));
    const double width = std::max(options.min_range, resolvable_range);
    Progress progress;
    if (options.progress) {
        progress = [&](double part) {
            answer.cancelled = answer.cancelled || !options.progress(part);
            return !answer.cancelled;
        };
    }
    const int limit = options.max_changes.value_or(most_changes);
    std::vector<CountedHeadings> found =
        heading_ranges(steering, limit, options.max_changes ? Find::all : Find::fewest, progress);
    if (found.empty()) return answer;
    std::optional<int> fewest = fewest_changes(found, width);
    if (!options.max_changes) {  // nothing wide enough: allow more changes, a few at first
        int allowed = found.front().changes;
        for (int more = 1; !fewest && allowed < limit && !answer.cancelled; more *= 2) {
            allowed = std::min(allowed + more, limit);
            found = heading_ranges(steering, allowed, Find::all, progress);
            fewest = fewest_changes(found, width);
        }
    }
    if (!fewest || answer.cancelled) return answer;
    answer.direction_changes = fewest;
    answer.ranges = ranges_of(found, options.max_changes ? limit : *fewest, width);
    const MaxSteerOptions drive = {*fewest, options.driving, options.parked};
    answer.maneuver = max_steer(car, slot, middle(*widest_range(answer.ranges, *fewest)), drive).maneuver;
    return answer;
}

Answer trials_answer(std::optional<Maneuver> maneuver) {
    Answer answer;
    if (maneuver) answer.direction_changes = maneuver->direction_changes();
    answer.maneuver = std::move(maneuver);
    return answer;
}

}  // namespace

Answer entry(const Car& car, const Slot& slot, const EntryOptions& options) {
    const MaxSteerOptions drive{options.max_changes.value_or(most_changes), options.driving, options.parked};
    check(drive);
    check_between("smallest range", options.min_range, 0.0, 1.5707963267948966, " rad");
    if (const auto* trials = std::get_if<ReversedTrials>(&options.strategy))
        return trials_answer(reversed_trials(car, slot, *trials, drive));
    if (const auto* trials = std::get_if<ParallelTrials>(&options.strategy))
        return trials_answer(parallel_trials(car, slot, *trials, drive));
    const Shortfall lacks = shortfall(car, slot, options.driving);
    if (lacks.length > 0.0 || lacks.width > 0.0) return {};
    if (const auto* steps = std::get_if<Stepping>(&options.strategy)) {
        return stepping_entry(car, slot, options, *steps);
    }
    return max_steer_entry(car, slot, options);
}

Shortfall shortfall(const Car& car, const Slot& slot, const Driving& driving) {
    const auto kept_from = [&](double setback) { return setback > 0.0 ? 0.0 : driving.clearance; };
    const Outline& stops = slot.curb() == Curb::low ? car.wheels() : car.outline();
    const bool right = slot.side() == Side::right;
    const double width = slot.curb() == Curb::low
                             ? (right ? car.outline().left() + stops.right() : car.outline().right() + stops.left())
                             : car.width();
    return {
        std::max(0.0, car.length() + kept_from(slot.front_setback()) + kept_from(slot.rear_setback()) - slot.length()),
        std::max(0.0, width + driving.at_curb() - slot.width())};
}

Shortfall shortfall(const Car& car, const Slot& slot, double clearance) {
    return shortfall(car, slot, Driving{.clearance = clearance});
}

}  // namespace snug
