// Problems 1 and 2 of the paper: from which headings can the car enter, with how few direction changes.
#pragma once

#include <functional>
#include <optional>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

struct EntryOptions {
    /// Empty: Problem 1, the fewest changes (at most 200). Set: Problem 2, every count up to it. 0 to 100000.
    std::optional<int> max_changes = {};
    double min_range = 0.0;  ///< leave out stretches of headings narrower than this [rad], 0 to pi/2
    Driving driving = {};
    Parked parked = {};  ///< what counts as parked
    /// Show that no heading is missed. Without, the answer comes some ten times sooner and says that it is not proved.
    bool prove = true;
    /// Told the part done (0 to 1) from time to time on long questions; returning false gives the question up.
    std::function<bool(double)> progress = {};
};

/// All entry headings in [0, pi/2] from which the car parks, by full steering until contact, with the fewest direction
/// changes, or with at most `max_changes`, as exact ranges (edges to 1e-12 rad, rounded inward), and one best maneuver.
/// Throws Error when an option is impossible.
Answer entry(const Car& car, const Slot& slot, const EntryOptions& options = {});

/// How much a slot lacks to hold the parallel car, with the clearance it keeps from neighbours and curb (none where a neighbour
/// is set back). [m], 0 if nothing. Where it lacks something the car may still park aslant, as in a short but deep slot.
struct Shortfall {
    double length = 0.0;
    double width = 0.0;

    friend bool operator==(const Shortfall&, const Shortfall&) = default;
};
Shortfall shortfall(const Car& car, const Slot& slot, const Driving& driving = {});

}  // namespace snug
