#include "snug/entry.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "contact/entering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "full_steering/proof.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr std::size_t most_proof_moves = 100'000;  ///< driven for a proof: some 0.1 s at most
constexpr double inward = 2e-13;  ///< edges are moved this far into their range, beyond any rounding [rad]

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

/// How many changes a single run from this heading parks with; -1 if it does not, with up to that many.
int changes_from(const FullSteering& steering, double heading, int most) {
    FullSteeringRun run(steering, heading);
    for (int changes = 0; changes <= most; ++changes) {
        const FullMove move = run.drive<false>();
        if (move.stuck) return -1;
        if (move.depth <= 0.0) return changes;
        if (move.meets == Meets::nothing) return -1;
    }
    return -1;
}

bool parks_as_said(const FullSteering& steering, const CountedHeadings& range) {
    return changes_from(steering, 0.5 * (range.min + range.max), range.changes) == range.changes;
}

/// A range whose middle does not park with its count is one that rounding made.
void leave_out_noise(const FullSteering& steering, std::vector<CountedHeadings>& found, std::vector<Headings>& noise) {
    std::erase_if(found, [&](const CountedHeadings& range) {
        if (parks_as_said(steering, range)) return false;
        noise.push_back({range.min, range.max});
        return true;
    });
}

/// Where the proof is to cut first: around the edges found, and here and there.
ProofHints hints_from(const std::vector<CountedHeadings>& found, int changes) {
    constexpr double beside = 1.5e-12;
    ProofHints hints{changes, {}};
    for (int i = 1; i < 16; ++i) hints.headings.push_back(limits::quarter_turn * i / 16);
    for (const CountedHeadings& range : found)
        hints.headings.insert(hints.headings.end(),
                              {range.min - beside, range.min + beside, range.max - beside, range.max + beside});
    std::sort(hints.headings.begin(), hints.headings.end());
    return hints;
}

/// What holds at a heading: a count, -1 for none.
int count_at(const std::vector<CountedHeadings>& ranges, double heading) {
    const auto after = std::upper_bound(ranges.begin(), ranges.end(), heading,
                                        [](double at, const CountedHeadings& range) { return at < range.min; });
    return after != ranges.begin() && heading <= std::prev(after)->max ? std::prev(after)->changes : -1;
}

/// Puts what is proved beside what was found, in place: what was missed is added once a single run has shown it; what the
/// two do not agree upon is undecided.
void settle(const FullSteering& steering, std::vector<CountedHeadings>& found, const ProvedRanges& proved,
            std::vector<Headings>& undecided) {
    std::vector<double> edges;
    for (const CountedHeadings& range : found) edges.insert(edges.end(), {range.min, range.max});
    for (const CountedHeadings& range : proved.ranges) edges.insert(edges.end(), {range.min, range.max});
    for (const Sliver& sliver : proved.undecided) edges.insert(edges.end(), {sliver.min, sliver.max});
    std::sort(edges.begin(), edges.end());
    std::vector<CountedHeadings> missed;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const double min = edges[i - 1];
        const double max = edges[i];
        if (max - min <= one_subrange) continue;
        const double at = 0.5 * (min + max);
        const int said = count_at(found, at);
        const int right = count_at(proved.ranges, at);
        if (said == right) continue;
        if (said < 0 && changes_from(steering, at, right) == right) {
            missed.push_back({min, max, right});
        } else {
            undecided.push_back({min, max});
        }
    }
    found.insert(found.end(), missed.begin(), missed.end());
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.min < b.min; });
    for (const Sliver& sliver : proved.undecided)
        if (sliver.max - sliver.min > one_subrange) undecided.push_back({sliver.min, sliver.max});
    for (const CountedHeadings& range : proved.ranges) {  // too narrow to be compared
        const bool known = std::any_of(found.begin(), found.end(), [&](const CountedHeadings& other) {
            return other.min <= range.max + one_subrange && range.min <= other.max + one_subrange;
        });
        if (!known) undecided.push_back({range.min, range.max});
    }
}

/// In rising order, those that touch as one.
std::vector<Headings> joined(std::vector<Headings> parts) {
    std::sort(parts.begin(), parts.end(), [](const Headings& a, const Headings& b) { return a.min < b.min; });
    std::vector<Headings> whole;
    for (const Headings& part : parts) {
        if (!whole.empty() && part.min <= whole.back().max + one_subrange) {
            whole.back().max = std::max(whole.back().max, part.max);
        } else {
            whole.push_back(part);
        }
    }
    return whole;
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
    const int limit = options.max_changes.value_or(limits::usual_changes);
    std::vector<Headings> noise;
    SearchWork work;
    std::vector<CountedHeadings> found =
        heading_ranges(steering, limit, options.max_changes ? Find::all : Find::fewest, progress, &work);
    int allowed = options.max_changes || found.empty() ? limit : found.front().changes;
    leave_out_noise(steering, found, noise);
    std::optional<int> fewest = fewest_changes(found, width);
    // Nothing wide enough: allow more changes, a few at first.
    for (int more = 1; !fewest && allowed < limit && !answer.cancelled; more *= 2) {
        allowed = std::min(allowed + more, limit);
        found = heading_ranges(steering, allowed, Find::all, progress, &work);
        leave_out_noise(steering, found, noise);
        fewest = fewest_changes(found, width);
    }
    if (answer.cancelled) return answer;
    answer.undecided = joined(std::move(noise));
    if (options.prove) {
        const int asked = options.max_changes ? limit : fewest.value_or(limit);
        const bool all = options.max_changes || (fewest && !found.empty() && options.min_range > 0.0);
        std::erase_if(found, [&](const CountedHeadings& range) { return range.changes > asked; });
        const ProvedRanges proved =
            prove_ranges(proof_problem(car, slot, options.driving, options.parked), asked,
                         all ? Find::all : Find::fewest, hints_from(found, fewest ? asked : -1), {}, most_proof_moves);
        // A smaller count than was found: no other is asked about.
        const bool smaller = !all && !proved.ranges.empty() && (!fewest || proved.ranges.front().changes < *fewest);
        const std::vector<CountedHeadings> before = found;
        if (smaller) found.clear();
        settle(steering, found, proved, answer.undecided);
        if (smaller && !fewest_changes(found, width)) found = before;  // no run shows it
        answer.undecided = joined(std::move(answer.undecided));
        fewest = fewest_changes(found, width);
        // Nothing parks with fewer, unless in what is undecided: there from some count on.
        const int claimed = fewest.value_or(asked + 1);
        answer.lower_bound = smaller ? claimed : std::min(proved.proved_changes + 1, claimed);
        for (const Headings& part : answer.undecided) {
            int from = 0;
            for (const Sliver& sliver : proved.undecided)
                if (sliver.min <= part.min && part.max <= sliver.max) from = sliver.from_changes;
            answer.lower_bound = std::min(answer.lower_bound, from);
        }
        answer.proved = answer.lower_bound == claimed;
    }
    if (!fewest) {
        answer.cancelled = !work.complete && !answer.proved;  // it did not look everywhere
        return answer;
    }
    answer.direction_changes = fewest;
    answer.ranges = ranges_of(found, options.max_changes ? limit : *fewest, width);
    const MaxSteerOptions drive = {*fewest, options.driving, options.parked};
    answer.maneuver =
        detail::max_steer(car, slot, steering, middle(*widest_range(answer.ranges, *fewest)), drive).maneuver;
    return answer;
}

}  // namespace

Answer entry(const Car& car, const Slot& slot, const EntryOptions& options) {
    const MaxSteerOptions drive{options.max_changes.value_or(limits::usual_changes), options.driving, options.parked};
    check(drive);
    check_between("smallest range", options.min_range, 0.0, limits::quarter_turn, " rad");
    const Shortfall lacks = shortfall(car, slot, options.driving);
    if (lacks.length > 0.0 || lacks.width > 0.0) {
        Answer none;
        none.proved = options.prove;
        if (none.proved) none.lower_bound = options.max_changes.value_or(limits::usual_changes) + 1;
        return none;
    }
    return max_steer_entry(car, slot, options);
}

Shortfall shortfall(const Car& car, const Slot& slot, const Driving& driving) {
    const LeastSlot least = least_slot(car, slot, driving);
    return {std::max(0.0, least.length - slot.length()), std::max(0.0, least.width - slot.width())};
}

}  // namespace snug
