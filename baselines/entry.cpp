// entry() as the baselines answer it.
#include <cstddef>
#include <iterator>
#include <utility>

#include "baselines/stepping_entry.hpp"
#include "contact/entering.hpp"
#include "sentences/check.hpp"
#include "snug/baselines.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

Answer trials_answer(std::optional<Maneuver> maneuver) {
    Answer answer;
    if (maneuver) answer.direction_changes = maneuver->direction_changes();
    answer.maneuver = std::move(maneuver);
    return answer;
}

}  // namespace

Answer entry(const Car& car, const Slot& slot, const EntryOptions& options, const Baseline& baseline) {
    const MaxSteerOptions drive{options.max_changes.value_or(limits::usual_changes), options.driving, options.parked};
    detail::check(drive);
    check_between("smallest range", options.min_range, 0.0, limits::quarter_turn, " rad");
    if (const auto* trials = std::get_if<ReversedTrials>(&baseline))
        return trials_answer(reversed_trials(car, slot, *trials, drive));
    if (const auto* trials = std::get_if<ParallelTrials>(&baseline))
        return trials_answer(parallel_trials(car, slot, *trials, drive));
    const Shortfall lacks = shortfall(car, slot, options.driving);
    if (lacks.length > 0.0 || lacks.width > 0.0) return {};
    return stepping_entry(car, slot, options, std::get<Stepping>(baseline));
}

std::string_view to_string(const Baseline& baseline) {
    constexpr std::string_view names[] = {"stepping", "reversed-trials", "parallel-trials"};
    static_assert(std::size(names) == std::variant_size_v<Baseline>);
    return names[baseline.index()];
}

}  // namespace snug
