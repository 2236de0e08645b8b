// Cars as seen from above: the one place that draws a car.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "view.hpp"

namespace snug::drawing {

struct CarLook {
    Color body;
    Color outline;
    Color glass;
    double line = line::thin;
};

/// The shape of a car within its frame, at a pose in the world.
void draw_car(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose,
              const CarLook& look);
/// Its wheels, the front ones turned by the steering angle.
void draw_wheels(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose,
                 double steering_angle, Color color);
/// The car frame, its outline, grown by `grown` [m] on every side.
void trace_frame(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const Pose& pose,
                 double grown = 0.0);
/// A cross at the rear axle centre.
void draw_cross(cairo_t* canvas, const View& view, const Slot& slot, const Pose& pose, Color color);

}  // namespace snug::drawing
