// Which entry headings park with how many direction changes, exactly (Problems 1 and 2 for the paper's strategy).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "full_steering/full_steering.hpp"
#include "snug/answer.hpp"

namespace snug::detail {

/// A closed range of headings that all park with the same number of changes.
struct CountedHeadings {
    double min = 0.0;
    double max = 0.0;
    int changes = 0;
};

/// What to look for among the headings that need at most `max_changes`.
enum class Find { all, fewest, any };

/// Told the part done from time to time; returning false gives up.
using Progress = std::function<bool(double)>;

/// What a search took, and whether it looked everywhere it should.
struct SearchWork {
    std::vector<Headings> possible;  ///< headings at which the car can enter, in rising order
    std::size_t moves = 0;
    bool complete = true;  ///< not given up, and within the bound
};

/// All ranges, or those with the smallest count there is, or one to show that there is any. Empty when given up.
///
/// A car and a slot whose dimensions differ by many orders of magnitude can be beyond the resolution of doubles, and
/// rounding then makes pieces without end; so the search stops splitting after 30 million moves, ten times what any car
/// needs that can be built. `work`, if given, says so.
std::vector<CountedHeadings> heading_ranges(const FullSteering& steering, int max_changes, Find find,
                                            const Progress& progress = {}, SearchWork* work = nullptr);

/// Ranges this close touch. [rad]
inline constexpr double one_subrange = 1e-11;
/// Narrower ranges are no more than rounding. [rad]
inline constexpr double resolvable_range = 1e-12;

/// Neighbouring ranges without a gap, from the first to the last: one chain of headings that all park.
struct Chain {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// The chains of headings that need at most `changes` and are at least `width` wide [rad]. `ranges` is in rising order.
std::vector<Chain> chains(const std::vector<CountedHeadings>& ranges, int changes, double width);

}  // namespace snug::detail
