// What a search found and what is proved, put beside each other: single runs decide where the two differ.
#pragma once

#include <optional>
#include <vector>

#include "full_steering/full_steering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "full_steering/proof/proof.hpp"
#include "snug/answer.hpp"

namespace snug::detail {

/// A car that drives from one heading.
struct SingleRuns {
    const FullSteering& steering;

    /// How many changes it parks with; -1 if it does not, with up to that many. Nothing where rounding decides: where it is
    /// not so in slots that are larger and smaller by a hair.
    [[nodiscard]] std::optional<int> changes_from(double heading, int most) const;
};

/// Takes out what rounding made or hides: ranges whose middle does not park with their count, narrow ones where that is so
/// anywhere, and stretches too narrow to be told from it.
void leave_out_noise(const SingleRuns& runs, std::vector<CountedHeadings>& found, std::vector<Headings>& noise);

/// Where the proof is to cut first: where entry positions end, around the edges found, and here and there.
ProofHints hints_from(const std::vector<Headings>& possible, const std::vector<CountedHeadings>& found, int changes);

/// Puts right what was found, in place. What neither the proof nor a single run shows is added to the undecided.
void settle(const SingleRuns& runs, std::vector<CountedHeadings>& found, const ProvedRanges& proved,
            std::vector<Headings>& undecided);

/// In rising order, those that touch as one.
std::vector<Headings> joined(std::vector<Headings> parts);

}  // namespace snug::detail
