#include "full_steering/proof/verdict.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace snug::detail {

int SingleRuns::changes_from(double heading, int most) const {
    constexpr QuarterHeading straight_down = {1.0, 0.0, 1};
    FullSteeringRun run(steering, heading);
    for (int changes = 0; changes <= most; ++changes) {
        const QuarterHeading start = run.heading();
        const Turn turn = {run.backward() ? &steering.backward : &steering.forward, &steering.problem, run.x(),
                           run.y()};
        const FullMove move = run.drive<false>();
        const bool goes_round = move.meets == Meets::nothing || run.heading().quarter > 1;
        if (move.stuck) return -1;
        // Beyond a quarter turn off parallel it is not parked, wherever its frame is.
        if (move.depth <= 0.0 && (!goes_round || first_parked(turn, start, straight_down, 0.0))) return changes;
        if (goes_round) return -1;
    }
    return -1;
}

void leave_out_noise(const SingleRuns& runs, std::vector<CountedHeadings>& found, std::vector<Headings>& noise) {
    std::erase_if(found, [&](const CountedHeadings& range) {
        if (runs.changes_from(0.5 * (range.min + range.max), range.changes) == range.changes) return false;
        noise.push_back({range.min, range.max});
        return true;
    });
}

ProofHints hints_from(const std::vector<CountedHeadings>& found, int changes) {
    // Beside the end of a range every box may be so wide, and no wider, that its square is as narrow as the one before.
    constexpr std::array beside = {1.5e-12, 1e-7, 1e-4};
    constexpr double end = 1.57079632679489661923;
    ProofHints hints{changes, {}};
    for (const int i : {1, 2, 3, 4, 5, 6, 8, 11}) hints.headings.push_back(end * i / 16);
    for (const CountedHeadings& range : found) {
        const double wide = range.max - range.min;
        for (const double away : beside) {
            hints.headings.insert(hints.headings.end(), {range.min - away, range.max + away});
            if (2.0 * away < wide) hints.headings.insert(hints.headings.end(), {range.min + away, range.max - away});
        }
    }
    std::sort(hints.headings.begin(), hints.headings.end());
    return hints;
}

namespace {

/// What holds at a heading: a count, -1 for none.
int count_at(const std::vector<CountedHeadings>& ranges, double heading) {
    const auto after = std::upper_bound(ranges.begin(), ranges.end(), heading,
                                        [](double at, const CountedHeadings& range) { return at < range.min; });
    return after != ranges.begin() && heading <= std::prev(after)->max ? std::prev(after)->changes : -1;
}

/// What is found to be so between two headings, and was not.
void correct(std::vector<CountedHeadings>& found, double min, double max, int changes) {
    std::vector<CountedHeadings> right;
    for (const CountedHeadings& range : found) {
        if (range.max <= min || max <= range.min) {
            right.push_back(range);
            continue;
        }
        if (range.min < min) right.push_back({range.min, min, range.changes});
        if (max < range.max) right.push_back({max, range.max, range.changes});
    }
    if (changes >= 0) right.push_back({min, max, changes});
    std::sort(right.begin(), right.end(), [](const auto& a, const auto& b) { return a.min < b.min; });
    found = right;
}

}  // namespace

void settle(const SingleRuns& runs, std::vector<CountedHeadings>& found, const ProvedRanges& proved,
            std::vector<Headings>& undecided) {
    std::vector<double> edges;
    for (const CountedHeadings& range : found) edges.insert(edges.end(), {range.min, range.max});
    for (const CountedHeadings& range : proved.ranges) edges.insert(edges.end(), {range.min, range.max});
    for (const Sliver& sliver : proved.undecided) edges.insert(edges.end(), {sliver.min, sliver.max});
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i) {
        const double min = edges[i - 1];
        const double max = edges[i];
        if (max - min <= one_subrange) continue;
        const double at = 0.5 * (min + max);
        const bool left_out = std::any_of(proved.undecided.begin(), proved.undecided.end(),
                                          [at](const Sliver& sliver) { return sliver.min <= at && at <= sliver.max; });
        if (left_out) continue;
        const int right = count_at(proved.ranges, at);
        if (count_at(found, at) == right) continue;
        if (runs.changes_from(at, right >= 0 ? right : proved.proved_changes) == right) {
            correct(found, min, max, right);
        } else {
            undecided.push_back({min, max});
        }
    }
    for (const Sliver& sliver : proved.undecided)
        if (sliver.max - sliver.min > one_subrange) undecided.push_back({sliver.min, sliver.max});
    for (const CountedHeadings& range : proved.ranges) {  // too narrow to be compared
        const bool known = std::any_of(found.begin(), found.end(), [&](const CountedHeadings& other) {
            return other.min <= range.max + one_subrange && range.min <= other.max + one_subrange;
        });
        if (!known) undecided.push_back({range.min, range.max});
    }
}

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

}  // namespace snug::detail
