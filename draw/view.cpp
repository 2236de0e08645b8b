// Which part of the slot frame is seen, where on the page, and how a car's own frame lands there.
#include "view.hpp"

#include <algorithm>
#include <cmath>

namespace snug::drawing {
namespace {

constexpr double above = 26.0;  // room on the page above what is needed
constexpr double below = 66.0;  // and below the curb, for numbers and dimensions

/// The corner or the middle of the edge that touches, grown by the clearance, in the car's own frame.
Point part_of(const Car& car, const Contact& contact, double clearance) {
    const bool wheel = to_string(contact.part).find("wheel") != std::string_view::npos;
    const bool edge = to_string(contact.part).find("edge") != std::string_view::npos;
    const Outline outline = (wheel ? car.wheels() : car.outline()).grown(clearance);
    const std::vector<Point>& corners = outline.corners();
    const Point& from = corners[contact.part_index % corners.size()];
    if (!edge) return from;
    const Point& to = corners[(contact.part_index + 1) % corners.size()];
    return {(from.x + to.x) / 2, (from.y + to.y) / 2};
}

Point in_world(const Pose& pose, const Point& in_car) {
    const double c = std::cos(pose.heading);
    const double s = std::sin(pose.heading);
    return {pose.x + c * in_car.x - s * in_car.y, pose.y + s * in_car.x + c * in_car.y};
}

}  // namespace

Point View::operator()(const Point& p) const {
    const double along = turned ? seen.x_max - p.x : p.x - seen.x_min;
    return {top_left.x + along * scale, top_left.y + (seen.y_max - p.y) * scale};
}

Box View::page() const {
    return {top_left.x, top_left.x + (seen.x_max - seen.x_min) * scale, top_left.y,
            top_left.y + (seen.y_max - seen.y_min) * scale};
}

View fitted(const Slot& slot, const Box& seen, const Panel& panel, double above, double below) {
    View view;
    view.turned = slot.side() == Side::left;
    view.top_left = panel.top_left;
    view.scale = std::min(panel.width / (seen.x_max - seen.x_min),
                          (panel.max_height - above - below) / (seen.y_max - seen.y_min));
    const double spare = panel.width / view.scale - (seen.x_max - seen.x_min);
    view.seen = {seen.x_min - spare / 2, seen.x_max + spare / 2, seen.y_min - below / view.scale,
                 seen.y_max + above / view.scale};
    return view;
}

View view_of(const Car& car, const Slot& slot, const Box& needed, const Panel& panel) {
    const double length = car.length();
    const double around = 2.5 * length;
    Box seen;
    seen.x_min = std::max(std::min(-slot.length(), needed.x_min) - length / 2, needed.x_min - around);
    seen.x_max = std::min(std::max(0.0, needed.x_max) + length / 2, needed.x_max + around);
    seen.y_min = std::max(std::min(-slot.width(), needed.y_min), needed.y_min - length);
    seen.y_max = std::max(needed.y_max, std::min(0.6 * car.width(), needed.y_min + 2.0 * length));

    return fitted(slot, seen, panel, above, below);
}

Point on_page(const View& view, const Slot& slot, const Pose& pose, const Point& in_car) {
    return view(slot.to_slot(in_world(pose, in_car)));
}

cairo_matrix_t placed(const View& view, const Slot& slot, const Pose& pose) {
    // Through the slot frame, where numbers stay small even if the slot lies far out in the world.
    const Pose at = slot.to_slot(pose);
    const double across = slot.mirrored(1.0);  // the car's left as the slot frame sees it
    const Point origin = view({at.x, at.y});
    const double x = view.turned ? -view.scale : view.scale;
    const double c = std::cos(at.heading);
    const double s = std::sin(at.heading);
    cairo_matrix_t matrix;
    cairo_matrix_init(&matrix, x * c, -view.scale * s, -x * s * across, -view.scale * c * across, origin.x, origin.y);
    return matrix;
}

Box box_of(const Car& car, const Slot& slot, const Pose& pose) {
    const auto corners = frame(car, pose);
    const Point first = slot.to_slot(corners[0]);
    Box box = {first.x, first.x, first.y, first.y};
    for (const Point& corner : corners) {
        const Point p = slot.to_slot(corner);
        box = joined(box, {p.x, p.x, p.y, p.y});
    }
    return box;
}

Box joined(const Box& a, const Box& b) {
    return {std::min(a.x_min, b.x_min), std::max(a.x_max, b.x_max), std::min(a.y_min, b.y_min),
            std::max(a.y_max, b.y_max)};
}

std::vector<Point> path_of(const View& view, const Car& car, const Slot& slot, const Move& move) {
    constexpr int pieces = 48;
    std::vector<Point> points;
    for (int i = 0; i <= pieces; ++i) {
        const Pose pose = drive(car, move.start, move.direction, move.steering_angle, move.length * i / pieces);
        points.push_back(view(slot.to_slot(Point{pose.x, pose.y})));
    }
    return points;
}

Point contact_point(const View& view, const Car& car, const Slot& slot, const Move& move, double clearance) {
    if (move.contact->obstacle == Obstacle::front_corner) {
        return view({0.0, -slot.front_setback()});
    }
    if (move.contact->obstacle == Obstacle::rear_corner) {
        return view({-slot.length(), -slot.rear_setback()});
    }
    return on_page(view, slot, move.end, part_of(car, *move.contact, clearance));
}

}  // namespace snug::drawing
