// Entry headings on a scale: which are possible, which park, and with how many direction changes.
#pragma once

#include <cairo.h>

#include <vector>

#include "canvas.hpp"
#include "snug/entry.hpp"

namespace snug::drawing {

/// `possible`: headings in rising order, evenly spaced where they are possible. Below the scale of all headings the part
/// with the ranges is shown enlarged, where that makes thin ranges visible.
void draw_heading_scale(cairo_t* canvas, const Box& box, const std::vector<double>& possible,
                        const std::vector<HeadingRange>& ranges);

}  // namespace snug::drawing
