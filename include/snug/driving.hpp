// Driving: how close the car may come, which end goes in first, and what counts as parked.
#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "snug/version.hpp"

namespace snug {

/// How the car goes into the slot: tail first, or nose first (solved as the mirrored slot and the car turned about).
enum class Enter { backward, forward };

/// What holds for the whole way in, or out.
struct Driving {
    double clearance = 0.0;  ///< grows the frame on every side for contacts and for the entry position [m], 0 to 1e6
    std::optional<double> curb_clearance = {};  ///< at the curb; empty: as everywhere [m]
    Enter enter = Enter::backward;              ///< tail or nose first

    [[nodiscard]] double at_curb() const { return curb_clearance.value_or(clearance); }

    friend bool operator==(const Driving&, const Driving&) = default;
};

/// What counts as parked: the whole frame inside the slot, and
struct Parked {
    double heading = std::numeric_limits<double>::infinity();  ///< at most so far off the parallel heading [rad]
    double curb = std::numeric_limits<double>::infinity();     ///< its nearest point at most so far from the curb [m]

    friend bool operator==(const Parked&, const Parked&) = default;
};

/// Throws Error unless these are possible.
void check(const Driving& driving);
void check(const Parked& parked);

/// "backward", "forward"
std::string_view to_string(Enter enter);

}  // namespace snug
