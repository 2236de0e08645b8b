// The paper's section 4.2: from which headings the car can enter when the direction changes are limited.
#pragma once

#include <vector>

#include "paper/work.hpp"
#include "snug/entry.hpp"

namespace snug::paper {

/// A range of headings without a gap, whatever counts it holds. [rad]
struct Subrange {
    double min = 0.0;
    double max = 0.0;
};

std::vector<Subrange> subranges(const std::vector<HeadingRange>& ranges);

/// Entry headings in one slot.
struct SlotHeadings {
    double extra_length = 0.0;  ///< [m]
    double extra_width = 0.0;   ///< [m]
    int max_changes = 0;
    std::vector<Subrange> exact;
    std::vector<Subrange> sampled;  ///< exact too, but without those narrower than the paper's heading step
};

/// Renault ZOE: over the extra width, for 1, 2, 5 and 10 changes at the extra length 1.1 m,
std::vector<SlotHeadings> headings_over_width(Work& work);
/// and for at most 10 changes at the extra lengths 0.5 to 1.9 m.
std::vector<SlotHeadings> headings_over_length(Work& work);
/// At most 10 changes at the extra length 1.1 m by Algorithm 1, on the paper's grid.
std::vector<SlotHeadings> stepped_headings(Work& work);

std::vector<File> headings_files(const std::vector<SlotHeadings>& over_width,
                                 const std::vector<SlotHeadings>& over_length);

}  // namespace snug::paper
