// What a maneuver shows on its stage: the car where it begins, where it stops and where it ends, and the key to the signs.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "labels.hpp"
#include "legs.hpp"
#include "view.hpp"

namespace snug::drawing {

inline constexpr double key_height = 30.0;

struct Stage {
    const Car& car;
    const Slot& slot;
    const std::vector<Leg>& legs;
    const PictureOptions& options;
};

/// Text along the road side of a car frame.
void write_beside(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, std::string_view text,
                  const TextStyle& style);
/// The car at the start, its wheels turned, and at the goal.
void draw_entry(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, double steering);
void draw_goal(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose);
/// The frames at the direction changes, later ones darker.
void draw_stops(cairo_t* canvas, const View& view, const Stage& stage);
/// With clearance, the grown frame is what touches.
void draw_grown(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, Color color);
/// What the signs in the picture mean.
void draw_key(cairo_t* canvas, Point at, const View& view, bool has_clearance);

}  // namespace snug::drawing
