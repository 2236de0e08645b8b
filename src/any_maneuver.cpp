#include "snug/any_maneuver.hpp"

#include <algorithm>

#include "snug/error.hpp"
#include "snug/fewest.hpp"

namespace snug {

std::optional<Answer> any_maneuver(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked,
                                   int max_changes) {
    constexpr double patience = 2.0;  // [s]; the spacing decides where the search ends, and hardly ever the clock
    FewestOptions options;
    options.max_changes = std::min(max_changes, limits::most_changes_fewest);
    options.driving = driving;
    options.parked = parked;
    options.resolution = std::max(limits::finest, car.length() / 500.0);
    options.time_limit = patience;
    options.roomiest = false;
    try {
        return fewest(car, slot, options);
    } catch (const Error&) {
        return std::nullopt;  // a slot so large that the lattice does not fit into memory
    }
}

}  // namespace snug
