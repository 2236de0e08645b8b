// How much clearance a car can keep in a slot with so many direction changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/min_slot.hpp"
#include "snug/slot.hpp"

namespace snug::cli {

struct KeptClearance {
    int max_changes = 0;
    std::optional<double> clearance;  ///< the largest that parks [m]; empty where not even none does
    double upper = 0.0;               ///< fewest: no more than this, proved [m]
};

struct ClearanceQuestion {
    Car car;
    Slot slot;
    MinSlotOptions options;  ///< its strategy, its driving but for the clearance, what counts as parked
    std::vector<int> max_changes;
};

/// With full steering to 1e-9 m; a little more clearance is harder but for odd cars, where the largest is found if clearances
/// park over a hundredth of all there is room for. Over all maneuvers to a tenth of a millimetre, as far as the resolution
/// lets it.
std::vector<KeptClearance> kept_clearances(const ClearanceQuestion& question);

std::string clearance_text(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows);
/// max_changes,width,length,clearance and with fewest clearance_upper
std::string clearance_csv(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows);

}  // namespace snug::cli
