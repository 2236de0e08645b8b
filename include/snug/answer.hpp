// Answer: what is known of parking a car, whichever question was asked.
#pragma once

#include <optional>
#include <vector>

#include "snug/maneuver.hpp"

namespace snug {

/// A closed range of headings. [rad]
struct Headings {
    double min = 0.0;
    double max = 0.0;

    friend bool operator==(const Headings&, const Headings&) = default;
};

/// A maximal range of entry headings that park with the same number of direction changes. Both ends belong to it.
struct HeadingRange {
    double min = 0.0;           ///< [rad]
    double max = 0.0;           ///< [rad]
    int direction_changes = 0;  ///< what every heading of the range needs
    int subrange = 0;           ///< ranges that touch (gap at most 1e-11 rad) share it: the paper's subranges

    friend bool operator==(const HeadingRange&, const HeadingRange&) = default;
};

/// The answer to entry(), fewest() and leave(), and what an atlas is made of.
struct Answer {
    /// The fewest that a maneuver was found for; empty where none was.
    std::optional<int> direction_changes;
    /// Nothing that was asked about has fewer; more than what is allowed: the car cannot park with as many. Among all
    /// maneuvers for fewest() and leave(), among entry headings for full steering.
    int lower_bound = 0;
    /// The two meet, or the lower bound exceeds what is allowed. With full steering also: no heading is missed but for
    /// those in `undecided`, together no wider than 1e-9 rad, of which neither this nor the lower bound tells.
    bool proved = false;
    /// Given up before anything was decided, by the progress callback or at the bound on work: as far as it had come.
    bool cancelled = false;
    /// Full steering: the headings that park, in rising order.
    std::vector<HeadingRange> ranges;
    /// Full steering: headings of which nothing is claimed. The ends of ranges, to 1e-11 rad, are not listed.
    std::vector<Headings> undecided;
    /// One best maneuver.
    std::optional<Maneuver> maneuver;
    /// fewest(), leave(): of the finest lattice that was needed [m]; 0 if none was.
    double spacing = 0.0;

    [[nodiscard]] bool parkable() const { return direction_changes.has_value(); }

    friend bool operator==(const Answer&, const Answer&) = default;
};

/// Where to enter from: small errors in the heading do the least harm in the middle of the widest range. That with so many
/// direction changes, the first of several; null when there is none.
inline const HeadingRange* widest_range(const std::vector<HeadingRange>& ranges, int direction_changes) {
    const HeadingRange* widest = nullptr;
    for (const HeadingRange& range : ranges) {
        if (range.direction_changes != direction_changes) continue;
        if (widest == nullptr || range.max - range.min > widest->max - widest->min) widest = &range;
    }
    return widest;
}

inline double middle(const HeadingRange& range) { return range.min + (range.max - range.min) / 2.0; }

}  // namespace snug
