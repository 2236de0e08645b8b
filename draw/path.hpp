// What moves: the path of the rear axle centre, where its direction changes, and what the car touches.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "labels.hpp"
#include "legs.hpp"
#include "view.hpp"

namespace snug::drawing {

/// Backward is a solid dark line, forward a hollow one; arrow heads point the way.
void draw_paths(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const std::vector<Leg>& legs);
/// A stretch of line as `draw_paths` shows a direction, for keys and tables.
void draw_path_sample(cairo_t* canvas, Point from, Point to, Direction direction);
/// Numbers of the direction changes, in rows above and below the path, within the box on the page.
void draw_numbers(cairo_t* canvas, const View& view, const Slot& slot, const std::vector<Leg>& legs, const Box& within);
/// Numbers of the moves that end in contact, beside the contacts.
void draw_contact_numbers(cairo_t* canvas, const View& view, const Car& car, const Slot& slot,
                          const std::vector<Leg>& legs, double clearance);
void draw_badge(cairo_t* canvas, Point at, std::string_view label, Color color);
/// A small diamond on what the car touches.
void draw_contact(cairo_t* canvas, Point at);
/// The path enlarged to fill the box on the page, with its own scale bar.
void draw_enlarged_path(cairo_t* canvas, const Box& box, const Car& car, const Slot& slot,
                        const std::vector<Leg>& legs);

}  // namespace snug::drawing
