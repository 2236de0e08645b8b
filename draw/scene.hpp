// What stands still: road, curb, neighbours, the slot with its dimensions, and a scale bar.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "labels.hpp"
#include "view.hpp"

namespace snug::drawing {

/// Road, curb, and the cars parked in front of and behind the slot, clipped to the view.
void draw_ground(cairo_t* canvas, const View& view, const Car& car, const Slot& slot);
/// The blue frame of the slot; its entry side, which is open, is dashed.
void draw_slot(cairo_t* canvas, const View& view, const Slot& slot);
/// The length of the slot below the curb.
void draw_length(cairo_t* canvas, const View& view, const Slot& slot, const Unit& unit);
/// The same, and the width to the right of the view.
void draw_dimensions(cairo_t* canvas, const View& view, const Slot& slot, const Unit& unit);
/// A scale bar in a lower corner of the view, clear of the slot where that can be.
void draw_scale(cairo_t* canvas, const View& view, const Slot& slot);
/// A bar of round length, a metre if that suits, that ends at the given point on the page.
void draw_scale_bar(cairo_t* canvas, const View& view, Point right_end, double longest = 160.0);
/// Clips to the view until the canvas is restored.
void clip_to(cairo_t* canvas, const View& view);

}  // namespace snug::drawing
