// The moves as a table: number, direction, steering, length, heading, contact.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "labels.hpp"
#include "legs.hpp"

namespace snug::drawing {

/// How tall the table of that many moves is. [points]
double table_height(std::size_t moves);
/// `ends`: in words where the legs end that meet nothing; where these are empty they stop.
void draw_table(cairo_t* canvas, Point top_left, double width, const Maneuver& maneuver, const Slot& slot,
                const std::vector<Leg>& legs, const Unit& unit, const std::vector<std::string>& ends = {});

}  // namespace snug::drawing
