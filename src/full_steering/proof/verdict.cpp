#include "full_steering/proof/verdict.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <random>
#include <utility>

#include "full_steering/cases.hpp"
#include "full_steering/follow.hpp"

namespace snug::detail {

std::optional<int> SingleRuns::changes_from(double heading, int most) const {
    const auto changes_in = [&](const FullSteering& in) {
        const FullSteeringRun at_entry(in, heading);
        if (!is_possible(in.problem, in.entry, heading, at_entry.heading().c, at_entry.heading().s)) return -1;
        return direction_changes_alone(in, heading, most);
    };
    const int changes = changes_in(steering);
    for (const double more : {steering.problem.touch, -steering.problem.touch}) {
        FullSteering other = steering;
        other.problem.length += more;
        other.problem.width += more;
        if (changes_in(other) != changes) return std::nullopt;
    }
    return changes;
}

namespace {

constexpr double narrow = 1e-6;  ///< ranges are looked at in many places, not in their middle alone [rad]
constexpr int many_places = 32;

/// The part of a range that single runs show; nothing where they do not show most of it.
std::optional<CountedHeadings> shown_part(const SingleRuns& runs, const CountedHeadings& range) {
    const auto shown = [&](double heading) { return runs.changes_from(heading, range.changes) == range.changes; };
    const double wide = range.max - range.min;
    if (wide > narrow) return shown(0.5 * (range.min + range.max)) ? std::optional(range) : std::nullopt;
    CountedHeadings part = range;
    std::minstd_rand random;  // the stripes that rounding makes keep step with anything regular
    std::array<double, many_places> at{};
    for (;;) {
        for (double& heading : at) {
            const double of_one = static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max());
            heading = part.min + of_one * (part.max - part.min);
        }
        std::sort(at.begin(), at.end());
        CountedHeadings longest{part.min, part.min, range.changes};
        double from = part.min;
        bool all = true;
        for (const double heading : at) {
            if (shown(heading)) continue;
            all = false;
            if (heading - from > longest.max - longest.min) longest = {from, heading, range.changes};
            from = heading;
        }
        if (all) return part;
        if (part.max - from > longest.max - longest.min) longest = {from, part.max, range.changes};
        if (longest.max - longest.min < 0.5 * wide) return std::nullopt;
        part = longest;
    }
}

}  // namespace

void leave_out_noise(const SingleRuns& runs, std::vector<CountedHeadings>& found, std::vector<Headings>& noise) {
    std::vector<CountedHeadings> left;
    std::size_t next = 0;
    const auto leave_out = [&](std::size_t end) {
        for (; next < end; ++next) noise.push_back({found[next].min, found[next].max});
    };
    for (const Chain& chain : chains(found, never, resolvable_range)) {
        leave_out(chain.first);
        while (next <= chain.last) {
            // A splinter among several is what rounding made of an end.
            const CountedHeadings& range = found[next];
            const bool splinter = chain.first < chain.last && range.max - range.min <= one_subrange;
            const std::optional<CountedHeadings> shown = splinter ? std::nullopt : shown_part(runs, range);
            if (!shown) {
                leave_out(next + 1);
                continue;
            }
            if (range.min < shown->min) noise.push_back({range.min, shown->min});
            if (shown->max < range.max) noise.push_back({shown->max, range.max});
            left.push_back(*shown);
            ++next;
        }
    }
    leave_out(found.size());
    found = std::move(left);
}

ProofHints hints_from(const std::vector<Headings>& possible, const std::vector<CountedHeadings>& found, int changes) {
    // Around the end of a range one box in which all is straight: it is cut at the end, and its parts need the last move only.
    constexpr std::array beside = {1e-4, 1e-2, 3e-2};
    // Where entry positions end: cars jam below, and above they plainly overlap something.
    constexpr double below = 5e-3;
    constexpr double above = 4e-3;
    constexpr double end = 1.57079632679489661923;
    ProofHints hints{changes, {}};
    for (const int i : {1, 2, 3, 4, 5, 6, 8, 11}) hints.headings.push_back(end * i / 16);
    for (const Headings& headings : possible)
        hints.headings.insert(hints.headings.end(), {headings.max - below, headings.max, headings.max + above});
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
    // What the proof cut is one range where a run shows that it goes on.
    std::vector<CountedHeadings> whole;
    for (const CountedHeadings& range : found) {
        if (!whole.empty() && whole.back().changes == range.changes && range.min - whole.back().max <= one_subrange &&
            runs.changes_from(0.5 * (whole.back().max + range.min), range.changes) == range.changes) {
            whole.back().max = range.max;
        } else {
            whole.push_back(range);
        }
    }
    found = std::move(whole);
    // Those too narrow to be compared are the ends of ranges, or have been missed.
    const auto leave_open = [&](double min, double max) {
        const bool at_an_end =
            max - min <= one_subrange && std::any_of(found.begin(), found.end(), [&](const CountedHeadings& range) {
                return range.min <= max + one_subrange && min <= range.max + one_subrange;
            });
        if (!at_an_end) undecided.push_back({min, max});
    };
    // What corrections on both sides left over of a range, inside a sliver, is none unless a run shows it.
    std::vector<CountedHeadings> leftovers;
    std::erase_if(found, [&](const CountedHeadings& range) {
        const bool in_sliver = std::any_of(proved.undecided.begin(), proved.undecided.end(), [&](const Sliver& sliver) {
            return sliver.min <= range.min && range.max <= sliver.max;
        });
        if (range.max - range.min > one_subrange && !in_sliver) return false;
        if (runs.changes_from(0.5 * (range.min + range.max), range.changes) == range.changes) return false;
        leftovers.push_back(range);
        return true;
    });
    for (const CountedHeadings& range : leftovers) leave_open(range.min, range.max);
    for (const Sliver& sliver : proved.undecided) leave_open(sliver.min, sliver.max);
    for (const CountedHeadings& range : proved.ranges)
        if (range.max - range.min <= one_subrange) leave_open(range.min, range.max);
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
