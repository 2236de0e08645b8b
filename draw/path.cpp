// What moves: the path of the rear axle centre, where its direction changes, and what the car touches.
#include "path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene.hpp"

namespace snug::drawing {
namespace {

constexpr double badge_radius = 6.0;

Color color_of(Direction direction) { return direction == Direction::backward ? palette::backward : palette::forward; }

/// Strokes the current path as the direction asks for.
void stroke_path(cairo_t* canvas, Direction direction) {
    if (direction == Direction::backward) {
        stroke(canvas, palette::backward, line::path);
        return;
    }
    cairo_path_t* path = cairo_copy_path(canvas);
    stroke(canvas, palette::forward, line::path + 1.0);
    cairo_append_path(canvas, path);
    cairo_path_destroy(path);
    stroke(canvas, palette::paper, line::path - 1.0);
}

double length_of(const std::vector<Point>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    }
    return length;
}

/// An arrow head past the middle of the path, where the ends of the neighbouring moves do not hide it.
void draw_arrow(cairo_t* canvas, const std::vector<Point>& points, Direction direction) {
    const double size = std::min(9.0, 0.5 * length_of(points));
    if (size < 2.5) {
        return;
    }
    const std::size_t at = points.size() * 11 / 20;
    const Point& from = points[at - 1];
    const Point& to = points[at];
    const double step = std::hypot(to.x - from.x, to.y - from.y);
    const Point tip = {to.x + (to.x - from.x) / step * size / 2, to.y + (to.y - from.y) / step * size / 2};
    trace_arrow_head(canvas, tip, to.x - from.x, to.y - from.y, size);
    if (direction == Direction::forward) {
        fill_and_stroke(canvas, palette::paper, palette::forward, 1.1);
    } else {
        fill(canvas, palette::backward);
    }
}

/// A numbered point on the page.
struct Number {
    Point at;
    const Leg* leg = nullptr;
};

constexpr double pitch = 2 * badge_radius + 2.5;

/// As many of the numbers as there is room for, the first and the last among them.
std::vector<Number> thinned(const std::vector<Number>& numbers, double room) {
    const std::size_t count = std::min(numbers.size(), static_cast<std::size_t>(std::max(1.0, room / pitch)));
    std::vector<Number> shown;
    for (std::size_t i = 0; i < count; ++i) {
        shown.push_back(numbers[count == 1 ? 0 : i * (numbers.size() - 1) / (count - 1)]);
    }
    return shown;
}

/// Places for badges that lie near the wanted ones (rising) without touching each other, all between the limits.
std::vector<double> spread(std::vector<double> wanted, double least, double most) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        wanted[i] = std::max(wanted[i], i == 0 ? least : wanted[i - 1] + pitch);
    }
    double limit = most;
    for (std::size_t i = wanted.size(); i-- > 0;) {
        wanted[i] = std::min(wanted[i], limit);
        limit = wanted[i] - pitch;
    }
    return wanted;
}

/// Badges along a line: across is where they stand, along where their points lie. `horizontal`: along is x.
void draw_badges(cairo_t* canvas, const std::vector<Number>& numbers, double across, bool horizontal, double least,
                 double most) {
    std::vector<Number> shown = thinned(numbers, most - least + pitch);
    const auto along = [horizontal](const Point& p) { return horizontal ? p.x : p.y; };
    std::stable_sort(shown.begin(), shown.end(),
                     [&](const Number& a, const Number& b) { return along(a.at) < along(b.at); });
    std::vector<double> places;
    places.reserve(shown.size());
    for (const Number& number : shown) {
        places.push_back(along(number.at));
    }
    if (!shown.empty()) {  // a crowd stays centred over its points
        const double middle = (places.front() + places.back()) / 2;
        const double reach = std::max(places.back() - places.front(), pitch * static_cast<double>(shown.size() - 1));
        const double start = std::max(least, std::min(middle - reach / 2, most - reach));
        places = spread(places, start, start + reach);
    }
    const auto badge = [&](std::size_t i) { return horizontal ? Point{places[i], across} : Point{across, places[i]}; };
    for (std::size_t i = 0; i < shown.size(); ++i) {
        draw_line(canvas, shown[i].at, badge(i), palette::faint_ink, line::hair);
    }
    for (std::size_t i = 0; i < shown.size(); ++i) {
        draw_badge(canvas, badge(i), std::to_string(shown[i].leg->number), color_of(shown[i].leg->move->direction));
    }
}

}  // namespace

void draw_paths(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const std::vector<Leg>& legs) {
    for (const Leg& leg : legs) {
        trace(canvas, path_of(view, car, slot, *leg.move));
        stroke_path(canvas, leg.move->direction);
    }
    for (const Leg& leg : legs) {
        draw_arrow(canvas, path_of(view, car, slot, *leg.move), leg.move->direction);
    }
}

void draw_path_sample(cairo_t* canvas, Point from, Point to, Direction direction) {
    trace(canvas, {from, to});
    stroke_path(canvas, direction);
    std::vector<Point> points;
    for (int i = 0; i <= 20; ++i) {
        points.push_back({from.x + (to.x - from.x) * i / 20.0, from.y + (to.y - from.y) * i / 20.0});
    }
    draw_arrow(canvas, points, direction);
}

void draw_badge(cairo_t* canvas, Point at, std::string_view label, Color color) {
    const TextStyle style = {label.size() > 2   ? 5.6
                             : label.size() > 1 ? 7.0
                                                : type::tiny,
                             palette::paper, true, Align::center};
    cairo_new_path(canvas);
    cairo_arc(canvas, at.x, at.y, badge_radius, 0.0, 2.0 * std::numbers::pi);
    fill_and_stroke(canvas, color, palette::paper, 0.8);
    write(canvas, at, label, style);
}

void draw_contact(cairo_t* canvas, Point at) {
    constexpr double size = 4.2;
    trace(canvas, {{at.x - size, at.y}, {at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size}}, true);
    fill_and_stroke(canvas, palette::contact, palette::ink, 0.9);
}

void draw_numbers(cairo_t* canvas, const View& view, const Slot& slot, const std::vector<Leg>& legs,
                  const Box& within) {
    std::vector<Number> above;
    std::vector<Number> below;
    double top = within.y_max;
    double bottom = within.y_min;
    for (const Leg& leg : legs) {
        const Point at = view(slot.to_slot(Point{leg.move->end.x, leg.move->end.y}));
        top = std::min(top, at.y);
        bottom = std::max(bottom, at.y);
        if (leg.turns_at_end) {
            (leg.move->direction == Direction::backward ? above : below).push_back({at, &leg});
        }
    }
    const double least = within.x_min + pitch;
    const double most = within.x_max - pitch;
    draw_badges(canvas, above, std::max(top - 24.0, within.y_min + pitch), true, least, most);
    draw_badges(canvas, below, std::min(bottom + 24.0, within.y_max - pitch), true, least, most);
}

void draw_contact_numbers(cairo_t* canvas, const View& view, const Car& car, const Slot& slot,
                          const std::vector<Leg>& legs, double clearance) {
    std::vector<Number> front;
    std::vector<Number> rear;
    std::vector<Number> curb;
    for (const Leg& leg : legs) {
        if (!leg.move->contact) {
            continue;
        }
        const Obstacle met = leg.move->contact->obstacle;
        const bool at_front = met == Obstacle::front_side || met == Obstacle::front_corner;
        std::vector<Number>& there = met == Obstacle::curb ? curb : at_front ? front : rear;
        there.push_back({contact_point(view, car, slot, *leg.move, clearance), &leg});
    }
    const Box page = view.page();
    const double outward = view.turned ? -22.0 : 22.0;
    const double least = view({0.0, 0.0}).y + badge_radius;
    const double most = page.y_max - pitch;
    draw_badges(canvas, front, view({0.0, 0.0}).x + outward, false, least, most);
    draw_badges(canvas, rear, view({-slot.length(), 0.0}).x - outward, false, least, most);
    draw_badges(canvas, curb, view({0.0, -slot.width()}).y + 18.0, true, page.x_min + pitch, page.x_max - pitch);
}

void draw_enlarged_path(cairo_t* canvas, const Box& box, const Car& car, const Slot& slot,
                        const std::vector<Leg>& legs) {
    const Saved saved(canvas);
    trace_rounded(canvas, box, 6.0);
    fill_and_stroke(canvas, palette::slot_floor, palette::rule, line::thin);
    trace_rounded(canvas, box, 6.0);
    cairo_clip(canvas);

    const Pose& first_stop = legs.front().move->end;
    Point p = slot.to_slot(Point{first_stop.x, first_stop.y});
    Box stops = {p.x, p.x, p.y, p.y};
    for (const Leg& leg : legs) {
        p = slot.to_slot(Point{leg.move->end.x, leg.move->end.y});
        stops = joined(stops, {p.x, p.x, p.y, p.y});
    }
    const double width = box.x_max - box.x_min;
    const double height = box.y_max - box.y_min;
    const double least = 1e-9 * car.length();
    View view;
    view.turned = slot.side() == Side::left;
    view.top_left = {box.x_min, box.y_min};
    view.scale = std::min((width - 36.0) / std::max(least, stops.x_max - stops.x_min),
                          (height - 118.0) / std::max(least, stops.y_max - stops.y_min));
    const double x = (stops.x_min + stops.x_max) / 2;
    const double y = (stops.y_min + stops.y_max) / 2 + 4.0 / view.scale;
    view.seen = {x - width / 2 / view.scale, x + width / 2 / view.scale, y - height / 2 / view.scale,
                 y + height / 2 / view.scale};
    draw_paths(canvas, view, car, slot, legs);
    draw_numbers(canvas, view, slot, legs, {box.x_min, box.x_max, box.y_min + 20.0, box.y_max - 22.0});
    const TextStyle caption = {type::small, palette::faint_ink, true};
    write(canvas, {box.x_min + 10.0, box.y_min + 13.0},
          fitted(canvas, "Rear axle centre, enlarged", caption, width - 20.0), caption);
    draw_scale_bar(canvas, view, {box.x_max - 10.0, box.y_max - 9.0}, width / 3);
}

}  // namespace snug::drawing
