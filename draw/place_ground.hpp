// What stands around in a place, the frame it is drawn in, and what to call it.
#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include "canvas.hpp"
#include "labels.hpp"
#include "snug/place.hpp"
#include "snug/scene.hpp"
#include "view.hpp"

namespace snug::drawing {

/// The frame that lies level on the page: a street's slot, or the world about where the car stands.
Slot frame_of(const Street& street);
Slot frame_of(const Scene& scene);
/// "slot 5.20 m \u00d7 2.00 m on the right, road 3.50 m, tail first"
std::string facts_of(const Street& street, const Unit& unit);
std::string facts_of(const Scene& scene);

/// The part of a polygon around the view, on the page: what is far outside would be too far for Cairo.
std::vector<Point> on_page(const View& view, const Slot& frame, const std::vector<Point>& world);

void draw_obstacles(cairo_t* canvas, const View& view, const Slot& frame, const Place& place);
/// The polygon to park in; a pose to park at is shown by the car there.
void draw_target(cairo_t* canvas, const View& view, const Slot& frame, const Place& place, bool filled = true);

}  // namespace snug::drawing
