// From ways in a chart to maneuvers in the world.
#pragma once

#include <vector>

#include "contact/place_contact.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail {

/// A way in the chart, driven from where the car stands.
Maneuver in_world(const Car& car, const Pose& start, const std::vector<Path>& way);

/// Its moves, into a list whose memory is used again.
void in_world(const Car& car, const Pose& start, const std::vector<Path>& way, std::vector<Move>& moves);

}  // namespace snug::detail
