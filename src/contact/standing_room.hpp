// How small may a slot be for the car to stand in it at all, at whatever heading it may be parked? Smaller ones need no search.
#pragma once

#include "contact/entering.hpp"

namespace snug::detail {

/// No slot of that width and shorter holds the parked car; infinite if none does. The problem's own length does not count. [m]
double least_length(const Problem& problem, double width);
/// No slot of that length and narrower does. [m]
double least_width(const Problem& problem, double length);

}  // namespace snug::detail
