// Where to cut a box of which something could not be told, and when to leave it.
#pragma once

#include <vector>

#include "full_steering/proof/driver.hpp"

namespace snug::detail::proof {

/// Adds the parts, the lowest headings last. They begin where the driver was when it looked at the box, as far as it was
/// hardly more than a straight line in the heading (`radius`: of the turning circle).
void cut(const Box& box, const Outcome& outcome, const Driver& driver, double radius, std::vector<Box>& boxes);

/// No cut would help: the box is narrow, and what could not be told depends on rounding more than on the heading.
bool hopeless(const Box& box, const Failure& failure);

}  // namespace snug::detail::proof
