#include "place_ground.hpp"

#include <array>

namespace snug::drawing {

Slot frame_of(const Street& street) {
    return Slot({.length = street.length,
                 .width = street.width,
                 .side = street.side,
                 .corner = street.corner,
                 .heading = street.heading});
}

Slot frame_of(const Scene& scene) {
    return Slot({.length = 1.0, .width = 1.0, .corner = {scene.start.x, scene.start.y}});
}

std::string facts_of(const Street& street, const Unit& unit) {
    std::string facts = "slot " + size_label(street.length, street.width, unit) + " on the " +
                        (street.side == Side::left ? "left" : "right");
    if (street.angle > 0.0) facts += ", at " + degrees_label(street.angle, 1);
    if (street.road) facts += ", road " + length_label(*street.road, unit);
    return facts + (street.enter == Enter::forward ? ", nose first" : ", tail first");
}

std::string facts_of(const Scene& scene) {
    const std::size_t count = scene.place.obstacles().size();
    return "a scene with " + std::to_string(count) + (count == 1 ? " obstacle" : " obstacles");
}

namespace {

/// A polygon of the slot frame without what lies on the far side of one edge of a box.
template <class Inside, class Cut>
std::vector<Point> without(const std::vector<Point>& polygon, const Inside& inside, const Cut& cut) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        if (inside(from)) kept.push_back(from);
        if (inside(from) != inside(to)) kept.push_back(cut(from, to));
    }
    return kept;
}

}  // namespace

std::vector<Point> on_page(const View& view, const Slot& frame, const std::vector<Point>& world) {
    const double out = 20.0 / view.scale;
    const Box box = {view.seen.x_min - out, view.seen.x_max + out, view.seen.y_min - out, view.seen.y_max + out};
    std::vector<Point> polygon;
    for (const Point& corner : world) polygon.push_back(frame.to_slot(corner));
    const auto at_x = [](double x) {
        return [x](const Point& a, const Point& b) { return Point{x, a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x))}; };
    };
    const auto at_y = [](double y) {
        return [y](const Point& a, const Point& b) { return Point{a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), y}; };
    };
    polygon = without(
        polygon, [&](const Point& p) { return p.x >= box.x_min; }, at_x(box.x_min));
    polygon = without(
        polygon, [&](const Point& p) { return p.x <= box.x_max; }, at_x(box.x_max));
    polygon = without(
        polygon, [&](const Point& p) { return p.y >= box.y_min; }, at_y(box.y_min));
    polygon = without(
        polygon, [&](const Point& p) { return p.y <= box.y_max; }, at_y(box.y_max));
    for (Point& corner : polygon) corner = view(corner);
    return polygon;
}

void draw_obstacles(cairo_t* canvas, const View& view, const Slot& frame, const Place& place) {
    trace_box(canvas, view.page());
    fill(canvas, palette::road);
    for (const PlaceObstacle& obstacle : place.obstacles()) {
        trace(canvas, on_page(view, frame, obstacle.corners), true);
        fill_and_stroke(canvas, obstacle.low ? palette::curb : palette::blocked, palette::neighbour_line, line::thin);
    }
}

void draw_target(cairo_t* canvas, const View& view, const Slot& frame, const Place& place, bool filled) {
    const auto* inside = std::get_if<ParkedInside>(&place.parked());
    if (inside == nullptr) return;
    const std::vector<Point> corners = on_page(view, frame, inside->corners);
    if (filled) {
        trace(canvas, corners, true);
        fill(canvas, palette::slot_floor);
    }
    const Saved saved(canvas);
    const std::array<double, 2> pattern = {5.0, 4.0};
    cairo_set_dash(canvas, pattern.data(), 2, 0.0);
    trace(canvas, corners, true);
    stroke(canvas, palette::slot, line::thin);
}

}  // namespace snug::drawing
