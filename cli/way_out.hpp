// Where the answer is no: which other maneuvers would do, and what change of slot, clearance or count.
#pragma once

#include <optional>
#include <string>

#include "cli/entry.hpp"
#include "cli/min_slot.hpp"
#include "cli/park.hpp"

namespace snug::cli {

/// The library's any_maneuver(): what other maneuvers can do.
std::optional<Answer> any_maneuver(const EntryQuestion& question);

/// The ways out of a no, each alone and each tried: what is said parks.
struct WayOut {
    std::optional<Answer> any;         ///< over all maneuvers; not where that was the question
    std::optional<int> changes;        ///< the strategy parks with so many, which is more than was allowed
    std::optional<double> longer;      ///< by so much [m]
    std::optional<double> wider;       ///< [m]
    std::optional<double> clearance;   ///< keeping no more than this [m]
    std::optional<double> longer_any;  ///< what other maneuvers need, where they do not park in this slot either [m]
};

/// `most_changes` as allowed, by full steering or, with Strategy::fewest, over all maneuvers. Baselines get `any` alone.
WayOut way_out(const EntryQuestion& question, Strategy strategy, int most_changes);

/// In words, with the options to give; empty when nothing is known to do.
std::string way_out_text(const EntryQuestion& question, const WayOut& out);

/// The same for a car that starts where it stands: what more changes, more room or less clearance would do, tried from there.
std::string way_out_text(const ParkQuestion& question);
/// And for one that is to leave its slot onto an open road.
std::string way_out_text(const EntryQuestion& question, const Pose& parked, const FewestOptions& asked);

/// A line about a count that is not the fewest; empty when it may be.
std::string fewer_text(int changes, const std::optional<Answer>& any);

/// Which slots other maneuvers park in, for those of the rows without one for which that is known within a few seconds; empty
/// when it is none.
std::string other_maneuvers(const MinSlotQuestion& question, const std::vector<MinSlot>& rows);

}  // namespace snug::cli
