#include "snug/entry.hpp"

#include <algorithm>
#include <utility>

#include "contact/entering.hpp"
#include "contact/standing_room.hpp"
#include "full_steering/heading_ranges.hpp"
#include "full_steering/proof/proof.hpp"
#include "full_steering/proof/verdict.hpp"
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
        if (!chains(ranges, changes, width).empty()) return changes;
    }
    return std::nullopt;
}

/// The ranges of all wide enough chains, edges rounded inward.
std::vector<HeadingRange> ranges_of(const std::vector<CountedHeadings>& found, int changes, double width) {
    std::vector<HeadingRange> ranges;
    int subrange = 0;
    for (const Chain& chain : chains(found, changes, width)) {
        for (std::size_t i = chain.first; i <= chain.last; ++i) {
            const double edge = std::min(inward, (found[i].max - found[i].min) / 4.0);
            const double min = found[i].min > 0.0 ? found[i].min + edge : 0.0;
            ranges.push_back({min, found[i].max - edge, found[i].changes, subrange});
        }
        ++subrange;
    }
    return ranges;
}

/// An answer while it is being worked out.
struct Search {
    const Car& car;
    const Slot& slot;
    const EntryOptions& options;
    FullSteering steering;
    ProofProblem problem;
    SingleRuns runs;
    int limit;     ///< of the direction changes
    double width;  ///< of headings, at least
    std::vector<CountedHeadings> found;
    SearchWork work;
    Answer answer;

    Search(const Car& of, const Slot& into, const EntryOptions& with)
        : car(of),
          slot(into),
          options(with),
          steering(entering_problem(car, slot, options.driving, options.parked)),
          problem(proof_problem(car, slot, options.driving, options.parked)),
          runs{steering},
          limit(options.max_changes.value_or(limits::usual_changes)),
          width(std::max(options.min_range, resolvable_range)) {}

    [[nodiscard]] std::optional<int> fewest() const { return fewest_changes(found, width); }

    void look() {
        Progress progress;
        if (options.progress) {
            progress = [&](double part) {
                answer.cancelled = answer.cancelled || !options.progress(part);
                return !answer.cancelled;
            };
        }
        const auto search = [&](int most, Find find) {
            found = heading_ranges(steering, most, find, progress, &work);
            leave_out_noise(runs, found, answer.undecided);
        };
        search(limit, options.max_changes ? Find::all : Find::fewest);
        int allowed = options.max_changes || found.empty() ? limit : found.front().changes;
        // Nothing wide enough: allow more changes, a few at first.
        for (int more = 1; !fewest() && allowed < limit && !answer.cancelled; more *= 2) {
            allowed = std::min(allowed + more, limit);
            search(allowed, Find::all);
        }
        answer.undecided = joined(answer.undecided);
    }

    /// Asks the prover about up to so many changes; false where the search had found what is not so, and nothing is left.
    bool prove(int asked) {
        bool all = fewest() && (options.max_changes || options.min_range > 0.0);
        const int guess = fewest().value_or(-1);
        std::erase_if(found, [&](const CountedHeadings& range) { return range.changes > asked; });
        ProvedRanges proved = prove_ranges(problem, asked, all ? Find::all : Find::fewest,
                                           hints_from(work.possible, found, guess), {}, most_proof_moves);
        if (options.max_changes && !all && !proved.ranges.empty()) {  // the search had found none
            all = true;
            proved = prove_ranges(problem, asked, Find::all, hints_from(work.possible, proved.ranges, -1), {},
                                  most_proof_moves);
        }
        // A smaller count than was found: no other is asked about.
        const bool smaller = !all && !proved.ranges.empty() && (guess < 0 || proved.ranges.front().changes < guess);
        const std::vector<CountedHeadings> before = found;
        if (smaller) found.clear();
        answer.undecided.clear();  // what rounding had made is the proof's to judge
        settle(runs, found, proved, answer.undecided);
        if (smaller && !fewest()) found = before;  // no run shows it
        answer.undecided = joined(answer.undecided);
        if (guess >= 0 && !fewest() && asked < limit) return false;
        // Nothing parks with fewer, but for slivers; where more is left open than those, only what it cannot hide is sure.
        const int claimed = fewest().value_or(asked + 1);
        answer.lower_bound = smaller ? claimed : std::min(proved.proved_changes + 1, claimed);
        double open = 0.0;
        for (const Headings& part : answer.undecided) open += part.max - part.min;
        if (open > most_undecided) {
            for (const Headings& part : answer.undecided) {
                int from = 0;
                for (const Sliver& sliver : proved.undecided)
                    if (sliver.min <= part.min && part.max <= sliver.max) from = sliver.from_changes;
                answer.lower_bound = std::min(answer.lower_bound, from);
            }
        }
        answer.proved = answer.lower_bound == claimed;
        return true;
    }

    Answer finish() {
        if (answer.cancelled) return answer;
        const std::optional<int> changes = fewest();
        if (!changes) {
            answer.cancelled = !work.complete && !answer.proved;  // it did not look everywhere
            return answer;
        }
        answer.direction_changes = changes;
        answer.ranges = ranges_of(found, options.max_changes ? limit : *changes, width);
        const MaxSteerOptions drive = {*changes, options.driving, options.parked};
        answer.maneuver =
            detail::max_steer(car, slot, steering, middle(*widest_range(answer.ranges, *changes)), drive).maneuver;
        return answer;
    }
};

Answer max_steer_entry(const Car& car, const Slot& slot, const EntryOptions& options) {
    Search search(car, slot, options);
    search.look();
    if (options.prove && !search.answer.cancelled) {
        const int asked = options.max_changes ? search.limit : search.fewest().value_or(search.limit);
        if (!search.prove(asked)) search.prove(search.limit);
    }
    return search.finish();
}

/// Whether the car can stand in the slot as it must be parked, parallel or aslant.
bool can_stand(const Car& car, const Slot& slot, const EntryOptions& options) {
    if (shortfall(car, slot, options.driving) == Shortfall{}) return true;
    const Problem problem = entering_problem(car, slot, options.driving, options.parked);
    return slot.width() >= least_width(problem, slot.length());
}

}  // namespace

Answer entry(const Car& car, const Slot& slot, const EntryOptions& options) {
    const MaxSteerOptions drive{options.max_changes.value_or(limits::usual_changes), options.driving, options.parked};
    check(drive);
    check_between("smallest range", options.min_range, 0.0, limits::quarter_turn, " rad");
    if (!can_stand(car, slot, options)) {
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
