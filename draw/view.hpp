// Which part of the slot frame is seen, where on the page, and how a car's own frame lands there.
#pragma once

#include <cairo.h>

#include <array>
#include <vector>

#include "snug/car.hpp"
#include "snug/draw.hpp"
#include "snug/maneuver.hpp"
#include "snug/slot.hpp"

namespace snug::drawing {

/// From the slot frame [m] to the page [points].
struct View {
    Box seen;             ///< part of the slot frame [m]
    Point top_left;       ///< on the page
    double scale = 1.0;   ///< points per metre
    bool turned = false;  ///< slots on the left: x of the slot frame runs to the left on the page

    Point operator()(const Point& p) const;
    [[nodiscard]] Box page() const;
};

/// Room on the page.
struct Panel {
    Point top_left;
    double width = 0.0;
    double max_height = 0.0;
};

/// The box of the slot frame [m] as large as the panel allows, over its whole width; points on the page above and below are
/// kept free.
View fitted(const Slot& slot, const Box& seen, const Panel& panel, double above = 0.0, double below = 0.0);

/// A view for a car that needs the given box of the slot frame [m]: with half a car beside the slot and space for the
/// dimensions below the curb. Of slots far larger than the car only the part around the car is seen.
View view_of(const Car& car, const Slot& slot, const Box& needed, const Panel& panel);

/// A pose [world] in the slot frame as a matrix from the car's own frame [m, x to the front, y to the left] to the page.
cairo_matrix_t placed(const View& view, const Slot& slot, const Pose& pose);
/// A point of the car's own frame on the page.
Point on_page(const View& view, const Slot& slot, const Pose& pose, const Point& in_car);

/// The box around the car frame at a pose, in the slot frame.
Box box_of(const Car& car, const Slot& slot, const Pose& pose);
Box joined(const Box& a, const Box& b);

/// The path of the rear axle centre over a move, on the page.
std::vector<Point> path_of(const View& view, const Car& car, const Slot& slot, const Move& move);
/// Where the contact at the end of a move happens, on the page; `clearance` as for the maneuver.
Point contact_point(const View& view, const Car& car, const Slot& slot, const Move& move, double clearance);

}  // namespace snug::drawing
