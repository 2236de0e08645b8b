// What stands still: road, curb, neighbours, the slot with its dimensions, and a scale bar.
#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "car_shape.hpp"

namespace snug::drawing {
namespace {

/// A box of the slot frame on the page, cut a little outside the view.
Box page_box(const View& view, const Box& box) {
    const Point a = view({std::max(box.x_min, view.seen.x_min), std::min(box.y_max, view.seen.y_max)});
    const Point b = view({std::min(box.x_max, view.seen.x_max), std::max(box.y_min, view.seen.y_min)});
    return {std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)};
}

void fill_box(cairo_t* canvas, const View& view, const Box& box, Color color) {
    if (box.x_min >= view.seen.x_max || box.x_max <= view.seen.x_min || box.y_min >= view.seen.y_max ||
        box.y_max <= view.seen.y_min) {
        return;
    }
    trace_box(canvas, page_box(view, box));
    fill(canvas, color);
}

void draw_curb(cairo_t* canvas, const View& view, const Slot& slot, double stone) {
    const double top = -slot.width();
    if (top <= view.seen.y_min) {
        return;
    }
    fill_box(canvas, view, {view.seen.x_min, view.seen.x_max, view.seen.y_min, top}, palette::sidewalk);
    const double thickness = 5.0 / view.scale;
    fill_box(canvas, view, {view.seen.x_min, view.seen.x_max, top - thickness, top}, palette::curb);
    for (double x = std::ceil(view.seen.x_min / stone) * stone; x < view.seen.x_max; x += stone) {
        draw_line(canvas, view({x, top}), view({x, top - thickness}), palette::sidewalk, line::hair);
    }
}

/// The neighbours are what the slot says they are, blocks; the cars in them are of the size of the car that parks.
void draw_neighbours(cairo_t* canvas, const View& view, const Car& car, const Slot& slot) {
    const double length = slot.length();
    fill_box(canvas, view, {0.0, view.seen.x_max, -slot.width(), 0.0}, palette::blocked);
    fill_box(canvas, view, {view.seen.x_min, -length, -slot.width(), 0.0}, palette::blocked);
    const CarLook look = {palette::neighbour, palette::neighbour_line, palette::neighbour_glass, line::hair};
    for (const double x : {car.rear(), -length - car.front()}) {
        if (x - car.rear() > view.seen.x_max || x + car.front() < view.seen.x_min) {
            continue;
        }
        draw_car(canvas, view, car, slot, slot.to_world(Pose{x, -car.width() / 2, 0.0}), look);
    }
}

/// A dimension line between two points of one level, with a short stroke at either end; an end outside the view is open.
void draw_measure(cairo_t* canvas, Point from, Point to, bool from_open, bool to_open) {
    draw_line(canvas, from, to, palette::slot, line::thin);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.0)) {
        return;
    }
    const Point across = {-(to.y - from.y) / length * 4.0, (to.x - from.x) / length * 4.0};
    const auto end = [&](Point at, double sign, bool open) {
        if (open) {
            trace_arrow_head(canvas, at, sign * (to.x - from.x), sign * (to.y - from.y), 7.0);
            fill(canvas, palette::slot);
        } else {
            draw_line(canvas, {at.x - across.x, at.y - across.y}, {at.x + across.x, at.y + across.y}, palette::slot,
                      line::thin);
        }
    };
    end(from, -1.0, from_open);
    end(to, 1.0, to_open);
}

}  // namespace

void clip_to(cairo_t* canvas, const View& view) {
    trace_rounded(canvas, view.page(), 6.0);
    cairo_clip(canvas);
}

void draw_ground(cairo_t* canvas, const View& view, const Car& car, const Slot& slot) {
    const Saved saved(canvas);
    clip_to(canvas, view);
    fill_box(canvas, view, view.seen, palette::road);
    {
        const Saved dashed(canvas);
        const double dash = 0.35 * car.length() * view.scale;
        const std::array<double, 2> pattern = {dash, dash};
        cairo_set_dash(canvas, pattern.data(), 2, 0.0);
        cairo_set_line_cap(canvas, CAIRO_LINE_CAP_BUTT);
        const double lane = 1.75 * car.width();
        draw_line(canvas, view({view.seen.x_min, lane}), view({view.seen.x_max, lane}), palette::lane_line, 3.0);
    }
    draw_curb(canvas, view, slot, car.length() / 4);
    draw_neighbours(canvas, view, car, slot);
    fill_box(canvas, view, {-slot.length(), 0.0, -slot.width(), 0.0}, palette::slot_floor);
}

void draw_slot(cairo_t* canvas, const View& view, const Slot& slot) {
    const Saved saved(canvas);
    clip_to(canvas, view);
    // Sides far outside the view are drawn just outside it, where the clip takes them away.
    const double beyond = 10.0 / view.scale;
    const double rear = std::max(-slot.length(), view.seen.x_min - beyond);
    const double front = std::min(0.0, view.seen.x_max + beyond);
    const double curb = std::max(-slot.width(), view.seen.y_min - beyond);
    trace(canvas, {view({rear, 0.0}), view({rear, curb}), view({front, curb}), view({front, 0.0})});
    stroke(canvas, palette::slot, line::frame);
    const std::array<double, 2> pattern = {5.0, 4.0};
    cairo_set_dash(canvas, pattern.data(), 2, 0.0);
    draw_line(canvas, view({rear, 0.0}), view({front, 0.0}), palette::slot, line::thin);
}

void draw_length(cairo_t* canvas, const View& view, const Slot& slot, const Unit& unit) {
    const Box page = view.page();
    const Box& seen = view.seen;
    const double level = page.y_max - 34.0;
    const double rear = std::max(-slot.length(), seen.x_min);
    const double front = std::min(0.0, seen.x_max);
    const Point from = {view({rear, 0.0}).x, level};
    const Point to = {view({front, 0.0}).x, level};
    const double start = std::min(view({0.0, std::max(-slot.width(), seen.y_min)}).y + 8.0, level);
    for (const Point& end : {from, to}) {
        draw_line(canvas, {end.x, start}, {end.x, level + 4.0}, palette::slot.faded(0.5), line::hair);
    }
    draw_measure(canvas, from, to, rear > -slot.length(), front < 0.0);
    const TextStyle style = {type::normal, palette::slot, true, Align::center};
    const std::string label = length_label(slot.length(), unit);
    const double half = text_width(canvas, label, style) / 2 + 6.0;
    const double middle = std::clamp((from.x + to.x) / 2, page.x_min + half, page.x_max - half);
    write(canvas, {middle, level + 14.0}, label, style);
}

void draw_dimensions(cairo_t* canvas, const View& view, const Slot& slot, const Unit& unit) {
    draw_length(canvas, view, slot, unit);
    const double x = view.page().x_max + 14.0;
    const double curb = std::max(-slot.width(), view.seen.y_min);
    const Point from = {x, view({0.0, 0.0}).y};
    const Point to = {x, view({0.0, curb}).y};
    draw_measure(canvas, from, to, false, curb > -slot.width());
    write(canvas, {x + 8.0, (from.y + to.y) / 2}, length_label(slot.width(), unit),
          {type::normal, palette::slot, true});
}

void draw_scale_bar(cairo_t* canvas, const View& view, Point right_end, double longest) {
    // A metre where that is neither a speck nor a street.
    const double metre = view.scale;
    const RoundLength bar =
        metre >= 40.0 && metre <= longest ? round_length(1.0) : round_length(0.7 * longest / view.scale);
    const double left = right_end.x - bar.metres * view.scale;
    trace(canvas, {{left, right_end.y - 4.0}, {left, right_end.y}, right_end, {right_end.x, right_end.y - 4.0}});
    stroke(canvas, palette::ink, 1.2);
    write(canvas, {(left + right_end.x) / 2, right_end.y - 8.0}, bar.label,
          {type::small, palette::ink, false, Align::center});
}

void draw_scale(cairo_t* canvas, const View& view, const Slot& slot) {
    constexpr double room = 190.0;
    const Box page = view.page();
    const double front = view({0.0, 0.0}).x;
    const double rear = view({-slot.length(), 0.0}).x;
    const bool left_is_free = std::min(front, rear) > page.x_min + room;
    const bool right_is_free = std::max(front, rear) < page.x_max - room;
    const double right_end = left_is_free && !right_is_free ? page.x_min + room : page.x_max - 14.0;
    draw_scale_bar(canvas, view, {right_end, page.y_max - 16.0});
}

}  // namespace snug::drawing
