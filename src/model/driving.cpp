#include "snug/driving.hpp"

#include <limits>

#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

void check(const Driving& driving) {
    check_between("clearance", driving.clearance, 0.0, limits::longest, " m");
    check_between("clearance from the curb", driving.at_curb(), 0.0, limits::longest, " m");
}

void check(const Parked& parked) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    check_between("largest heading of the parked car", parked.heading, 0.0, infinity, " rad");
    check_between("largest distance of the parked car from the curb", parked.curb, 0.0, infinity, " m");
}

}  // namespace snug
