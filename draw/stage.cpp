// What a maneuver shows on its stage: the car where it begins, where it stops and where it ends, and the key to the signs.
#include "stage.hpp"

#include <array>
#include <cmath>

#include "car_shape.hpp"
#include "path.hpp"

namespace snug::drawing {

void write_beside(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, std::string_view text,
                  const TextStyle& style) {
    const double side = stage.slot.mirrored(stage.car.width() / 2 + stage.options.driving.clearance);
    const Point front = on_page(view, stage.slot, pose, {stage.car.front(), side});
    const Point rear = on_page(view, stage.slot, pose, {-stage.car.rear(), side});
    const double sign = front.x >= rear.x ? 1.0 : -1.0;
    const Saved saved(canvas);
    cairo_translate(canvas, (front.x + rear.x) / 2, (front.y + rear.y) / 2);
    cairo_rotate(canvas, std::atan2(sign * (front.y - rear.y), sign * (front.x - rear.x)));
    write(canvas, {0.0, -10.0}, text, style);
}

void draw_entry(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, double steering) {
    draw_car(canvas, view, stage.car, stage.slot, pose,
             {palette::entry.faded(0.13), palette::entry.faded(0.40), palette::entry.faded(0.18), line::hair});
    draw_wheels(canvas, view, stage.car, stage.slot, pose, steering, palette::entry.faded(0.5));
    trace_frame(canvas, view, stage.car, stage.slot, pose);
    stroke(canvas, palette::entry, line::frame + 0.4);
}

void draw_goal(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose) {
    draw_car(canvas, view, stage.car, stage.slot, pose,
             {palette::goal.faded(0.14), palette::goal.faded(0.45), palette::goal.faded(0.20), line::hair});
    trace_frame(canvas, view, stage.car, stage.slot, pose);
    stroke(canvas, palette::goal, line::frame + 0.4);
}

void draw_stops(cairo_t* canvas, const View& view, const Stage& stage) {
    const auto last = static_cast<double>(stage.legs.back().number);
    for (const Leg& leg : stage.legs) {
        if (!leg.turns_at_end) {
            continue;
        }
        trace_frame(canvas, view, stage.car, stage.slot, leg.move->end);
        stroke(canvas, palette::ink.faded(0.16 + 0.34 * leg.number / last), line::hair);
    }
}

void draw_grown(cairo_t* canvas, const View& view, const Stage& stage, const Pose& pose, Color color) {
    if (!(stage.options.driving.clearance > 0.0)) {
        return;
    }
    const Saved saved(canvas);
    const std::array<double, 2> pattern = {0.5, 3.0};
    cairo_set_dash(canvas, pattern.data(), 2, 0.0);
    trace_frame(canvas, view, stage.car, stage.slot, pose, stage.options.driving.clearance);
    stroke(canvas, color, 1.2);
}

void draw_key(cairo_t* canvas, Point at, const View& view, bool has_clearance) {
    const TextStyle style = {type::small, palette::faint_ink};
    const auto item = [&](double width, std::string_view text) {
        at.x += width + 6.0;
        write(canvas, at, text, style);
        at.x += text_width(canvas, text, style) + 20.0;
    };
    const auto sample = [&](Color color, double thickness, double width) {
        trace_box(canvas, {at.x, at.x + width, at.y - 4.5, at.y + 4.5});
        stroke(canvas, color, thickness);
    };
    for (const Direction direction : {Direction::backward, Direction::forward}) {
        const bool to_left = (direction == Direction::backward) != view.turned;
        const Point end = {at.x + 26.0, at.y};
        draw_path_sample(canvas, to_left ? end : at, to_left ? at : end, direction);
        item(26.0, "driven " + std::string(to_string(direction)));
    }
    sample(palette::ink.faded(0.5), line::hair, 20.0);
    item(20.0, "frame at a direction change");
    draw_contact(canvas, {at.x + 5.0, at.y});
    item(10.0, "contact");
    draw_line(canvas, {at.x, at.y}, {at.x + 10.0, at.y}, palette::ink, 1.3);
    draw_line(canvas, {at.x + 5.0, at.y - 5.0}, {at.x + 5.0, at.y + 5.0}, palette::ink, 1.3);
    item(10.0, "rear axle centre");
    if (has_clearance) {
        const Saved saved(canvas);
        const std::array<double, 2> pattern = {0.5, 3.0};
        cairo_set_dash(canvas, pattern.data(), 2, 0.0);
        sample(palette::ink, 1.2, 20.0);
        item(20.0, "frame with clearance");
    }
}

}  // namespace snug::drawing
