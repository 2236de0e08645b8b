// The picture of one maneuver: from the entry position to the goal, move by move.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "canvas.hpp"
#include "car_shape.hpp"
#include "header.hpp"
#include "labels.hpp"
#include "legs.hpp"
#include "moves_table.hpp"
#include "path.hpp"
#include "scene.hpp"
#include "snug/draw.hpp"
#include "snug/entry_position.hpp"
#include "stage.hpp"
#include "view.hpp"

namespace snug {
namespace drawing {
namespace {

constexpr std::size_t many_moves = 4;  ///< from here on the path is shown enlarged

/// Room for the enlarged path: the road above a neighbour, on the side where the car does not stand out.
std::optional<Box> free_road(const View& view, const Stage& stage, const Box& driven) {
    constexpr double gap = 10.0;
    const bool beside_rear = stage.options.driving.enter == Enter::backward;
    const double inner =
        view({beside_rear ? std::min(-stage.slot.length(), driven.x_min) : std::max(0.0, driven.x_max), 0.0}).x;
    const Box page = view.page();
    const bool on_left = beside_rear != view.turned;
    const Box box = {on_left ? page.x_min + gap : inner + gap, on_left ? inner - gap : page.x_max - gap,
                     page.y_min + gap, view({0.0, 0.0}).y - gap};
    if (box.x_max - box.x_min < 140.0 || box.y_max - box.y_min < 120.0) {
        return std::nullopt;
    }
    return box;
}

void draw_stage(cairo_t* canvas, const View& view, const Stage& stage, const Box& driven) {
    draw_ground(canvas, view, stage.car, stage.slot);
    const Saved saved(canvas);
    clip_to(canvas, view);
    const Move& first = *stage.legs.front().move;
    const Pose entry = first.start;
    const Pose goal = stage.legs.back().move->end;
    draw_goal(canvas, view, stage, goal);
    draw_entry(canvas, view, stage, entry, first.steering_angle);
    draw_stops(canvas, view, stage);
    draw_grown(canvas, view, stage, entry, palette::entry);
    draw_grown(canvas, view, stage, goal, palette::goal);
    draw_slot(canvas, view, stage.slot);
    for (const Leg& leg : stage.legs) {
        if (leg.move->contact) {
            draw_contact(canvas,
                         contact_point(view, stage.car, stage.slot, *leg.move, stage.options.driving.clearance));
        }
    }
    draw_paths(canvas, view, stage.car, stage.slot, stage.legs);
    std::optional<Box> room;
    if (stage.legs.size() >= many_moves) {
        room = free_road(view, stage, driven);
    }
    if (room) {
        draw_contact_numbers(canvas, view, stage.car, stage.slot, stage.legs, stage.options.driving.clearance);
        draw_enlarged_path(canvas, *room, stage.car, stage.slot, stage.legs);
    } else {
        draw_numbers(canvas, view, stage.slot, stage.legs, view.page());
    }
    draw_cross(canvas, view, stage.slot, entry, palette::entry_text);
    draw_cross(canvas, view, stage.slot, goal, palette::goal_text);
    write_beside(canvas, view, stage, entry,
                 (stage.options.leaving ? "parked pose, heading " : "entry position, heading ") +
                     degrees_label(std::abs(stage.slot.to_slot(entry).heading)),
                 {type::normal, palette::entry_text, true, Align::center, true});
    write(canvas, on_page(view, stage.slot, goal, {0.82 * stage.car.front(), 0.0}),
          stage.options.leaving ? "out" : "goal", {type::normal, palette::goal_text, true, Align::center, true});
}

/// What the table says at the end of each move where nothing is met.
std::vector<std::string> ends_of_leaving(const std::vector<Leg>& legs) {
    std::vector<std::string> ends(legs.size());
    ends.back() = "the way is free";
    return ends;
}

std::string draw_driven(const Slot& slot, const Maneuver& maneuver, PictureFormat format,
                        const PictureOptions& options) {
    const Car& car = maneuver.car;
    const std::vector<Leg> legs = legs_of(maneuver);
    const Stage stage = {car, slot, legs, options};
    const Unit unit = unit_for(car.length());
    const Box driven = swept(maneuver, slot);
    const View view = view_of(car, slot, driven, stage_panel);
    const Box page = view.page();

    const double table_top = page.y_max + key_height + 14.0;
    const double height = table_top + table_height(legs.size()) + margin;
    const std::string facts = changes_label(maneuver.direction_changes()) +
                              (options.leaving ? ", parked heading " : ", entry heading ") +
                              degrees_label(std::abs(slot.to_slot(maneuver.entry()).heading)) + ", " +
                              path_label(maneuver.length(), unit) + " driven";
    return to_bytes({page_width, height}, format, picture_title(car, slot, unit) + ": " + facts, [&](cairo_t* canvas) {
        draw_header(canvas, car, slot, unit, facts, options);
        draw_stage(canvas, view, stage, driven);
        draw_dimensions(canvas, view, slot, unit);
        draw_scale(canvas, view, slot);
        draw_key(canvas, {page.x_min, page.y_max + key_height / 2 + 2.0}, view, options.driving.clearance > 0.0);
        std::vector<std::string> ends;
        if (options.leaving) ends = ends_of_leaving(legs);
        draw_table(canvas, {margin, table_top}, page_width - 2 * margin, maneuver, slot, legs, unit, ends);
    });
}

/// The slot, and the car beside it where it would have to begin.
std::string draw_unparked(const Car& car, const Slot& slot, std::string_view why, PictureFormat format,
                          const PictureOptions& options) {
    const std::vector<Leg> legs;
    const Stage stage = {car, slot, legs, options};
    const Unit unit = unit_for(car.length());
    const Pose entry = entry_position(car, slot, 0.0, options.driving);
    const View view = view_of(car, slot, box_of(car, slot, entry), stage_panel);
    const Box page = view.page();
    const std::string title = picture_title(car, slot, unit) + ": " + std::string(why);
    return to_bytes({page_width, page.y_max + margin}, format, title, [&](cairo_t* canvas) {
        draw_header(canvas, car, slot, unit, why, options);
        draw_ground(canvas, view, car, slot);
        {
            const Saved saved(canvas);
            clip_to(canvas, view);
            draw_entry(canvas, view, stage, entry, 0.0);
            draw_grown(canvas, view, stage, entry, palette::entry);
            draw_cross(canvas, view, slot, entry, palette::entry_text);
            draw_slot(canvas, view, slot);
            write_beside(canvas, view, stage, entry, "parallel entry position",
                         {type::normal, palette::entry_text, true, Align::center, true});
        }
        draw_dimensions(canvas, view, slot, unit);
        draw_scale(canvas, view, slot);
    });
}

}  // namespace
}  // namespace drawing

std::string draw_maneuver(const Car& car, const Slot& slot, const Answer& answer, PictureFormat format,
                          const PictureOptions& options) {
    if (answer.maneuver && !answer.maneuver->moves.empty()) {
        return drawing::draw_driven(slot, *answer.maneuver, format, options);
    }
    return drawing::draw_unparked(car, slot, drawing::verdict(car, slot, answer, options), format, options);
}

std::string draw_maneuver(const Slot& slot, const Maneuver& maneuver, PictureFormat format,
                          const PictureOptions& options) {
    if (!maneuver.moves.empty()) {
        return drawing::draw_driven(slot, maneuver, format, options);
    }
    return drawing::draw_unparked(maneuver.car, slot, "no maneuver", format, options);
}

}  // namespace snug
