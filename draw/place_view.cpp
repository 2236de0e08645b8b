// The picture of parking in any place: obstacles, where the car stands, the way and where it ends.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "canvas.hpp"
#include "car_shape.hpp"
#include "header.hpp"
#include "labels.hpp"
#include "legs.hpp"
#include "moves_table.hpp"
#include "path.hpp"
#include "place_ground.hpp"
#include "scene.hpp"
#include "snug/draw.hpp"
#include "stage.hpp"
#include "view.hpp"

namespace snug {
namespace drawing {
namespace {

/// What is drawn, and the frame that lies level on the page: a street's slot, or the world.
struct Picture {
    const Car& car;
    Place place;
    const Pose& start;
    const ParkAnswer& answer;
    Slot frame;
    std::string facts;
};

/// What is to be seen at least, in the frame: the goal and all of the car all the way.
Box needed(const Picture& picture) {
    Box box = box_of(picture.car, picture.frame, picture.start);
    if (picture.answer.maneuver && !picture.answer.maneuver->moves.empty())
        box = joined(box, swept(*picture.answer.maneuver, picture.frame));
    if (const auto* inside = std::get_if<ParkedInside>(&picture.place.parked())) {
        for (const Point& corner : inside->corners) {
            const Point p = picture.frame.to_slot(corner);
            box = joined(box, {p.x, p.x, p.y, p.y});
        }
    } else {
        box = joined(box, box_of(picture.car, picture.frame, std::get<ParkedAt>(picture.place.parked()).pose));
    }
    return box;
}

View view_of(const Picture& picture) {
    const double around = 0.25 * picture.car.length();
    Box seen = needed(picture);
    seen = {seen.x_min - around, seen.x_max + around, seen.y_min - around, seen.y_max + around};
    return fitted(picture.frame, seen, {{margin, header_height}, page_width - 2 * margin, 600.0});
}

/// Rear axles of a car that errs: of many runs, as many as can be told apart.
void draw_tracks(cairo_t* canvas, const View& view, const Stage& stage) {
    constexpr std::size_t most = 100;
    const std::vector<std::vector<Pose>>& all = stage.options.tracks;
    const double alpha = std::max(0.08, 0.5 / std::sqrt(static_cast<double>(std::max<std::size_t>(1, all.size()))));
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) {
        cairo_new_path(canvas);
        for (const Pose& pose : all[i]) {
            const Point at = drawing::on_page(view, stage.slot, pose, {0.0, 0.0});
            cairo_line_to(canvas, at.x, at.y);
        }
        stroke(canvas, palette::slot.faded(alpha), line::frame);
    }
}

void draw_stage(cairo_t* canvas, const View& view, const Stage& stage, const Picture& picture) {
    const Saved saved(canvas);
    clip_to(canvas, view);
    draw_obstacles(canvas, view, picture.frame, picture.place);
    draw_target(canvas, view, picture.frame, picture.place);
    draw_tracks(canvas, view, stage);
    if (picture.answer.maneuver) {
        const Pose goal = stage.legs.empty() ? picture.start : stage.legs.back().move->end;
        draw_goal(canvas, view, stage, goal);
        draw_grown(canvas, view, stage, goal, palette::goal);
    }
    draw_entry(canvas, view, stage, picture.start, stage.legs.empty() ? 0.0 : stage.legs.front().move->steering_angle);
    draw_grown(canvas, view, stage, picture.start, palette::entry);
    if (!stage.legs.empty()) {
        draw_stops(canvas, view, stage);
        draw_paths(canvas, view, stage.car, stage.slot, stage.legs);
        draw_numbers(canvas, view, stage.slot, stage.legs, view.page());
    }
    write_beside(canvas, view, stage, picture.start, "start",
                 {type::normal, palette::entry_text, true, Align::center, true});
    draw_cross(canvas, view, stage.slot, picture.start, palette::entry_text);
    if (stage.legs.empty()) return;
    const Pose goal = stage.legs.back().move->end;
    draw_cross(canvas, view, stage.slot, goal, palette::goal_text);
    write(canvas, drawing::on_page(view, stage.slot, goal, {0.82 * stage.car.front(), 0.0}), "goal",
          {type::normal, palette::goal_text, true, Align::center, true});
}

/// "rear-left corner 0.12 m from curb", for every leg at whose end the direction changes.
std::vector<std::string> ends_of(const std::vector<Leg>& legs, const Picture& picture, const Unit& unit) {
    std::vector<std::string> ends;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        std::string& end = ends.emplace_back();
        if (!legs[i].turns_at_end && i + 1 < legs.size()) end = "turn the wheel on the way";
        if (!legs[i].turns_at_end || i >= picture.answer.stops.size()) continue;
        const ParkStop& stop = picture.answer.stops[i];
        const std::string what = picture.place.name_of(stop.obstacle);
        end = std::string(to_string(stop.gap.part)) +
              (stop.is_contact() ? " meets " + what : " " + path_label(stop.gap.distance, unit) + " from " + what);
    }
    return ends;
}

/// The answer in one line.
std::string said(const ParkAnswer& answer, const Unit& unit) {
    if (!answer.maneuver)
        return answer.impossible ? "cannot park, proved for any number of direction changes" : "no maneuver found";
    return changes_label(*answer.direction_changes) +
           (answer.lower_bound >= *answer.direction_changes ? ", proved the fewest"
                                                            : ", at least " + std::to_string(answer.lower_bound)) +
           "; " + path_label(answer.maneuver->length(), unit) + " driven";
}

std::string drawn(const Picture& picture, const std::string& answer, PictureFormat format,
                  const PictureOptions& options) {
    const Unit unit = unit_for(picture.car.length());
    const std::optional<Maneuver>& way = picture.answer.maneuver;
    const std::vector<Leg> legs = way ? legs_of(*way) : std::vector<Leg>{};
    const Stage stage = {picture.car, picture.frame, legs, options};
    const View view = view_of(picture);
    const Box page = view.page();
    const double table_top = page.y_max + key_height + 14.0;
    const double height = legs.empty() ? page.y_max + margin : table_top + table_height(legs.size()) + margin;
    return to_bytes(
        {page_width, height}, format, name_of(picture.car) + ", " + picture.facts + ": " + answer,
        [&](cairo_t* canvas) {
            draw_header(canvas, name_of(picture.car), answer, picture.facts);
            draw_stage(canvas, view, stage, picture);
            draw_scale_bar(canvas, view, {page.x_max - 12.0, page.y_max - 12.0});
            if (legs.empty()) return;
            draw_key(canvas, {page.x_min, page.y_max + key_height / 2 + 2.0}, view, options.driving.clearance > 0.0);
            draw_table(canvas, {margin, table_top}, page_width - 2 * margin, *way, picture.frame, legs, unit,
                       ends_of(legs, picture, unit));
        });
}

}  // namespace
}  // namespace drawing

std::string draw_park(const Car& car, const Street& street, const Pose& start, const ParkAnswer& answer,
                      PictureFormat format, const PictureOptions& options) {
    using namespace drawing;
    const Unit unit = unit_for(car.length());
    return drawn({car, street_place(street), start, answer, frame_of(street), facts_of(street, unit)},
                 said(answer, unit), format, options);
}

std::string draw_park(const Car& car, const Scene& scene, const ParkAnswer& answer, PictureFormat format,
                      const PictureOptions& options) {
    using namespace drawing;
    return drawn({car, scene.place, scene.start, answer, frame_of(scene), facts_of(scene)},
                 said(answer, unit_for(car.length())), format, options);
}

std::string draw_maneuver(const Maneuver& maneuver, PictureFormat format) {
    using namespace drawing;
    const Box box = swept(maneuver);
    const Scene scene = {
        Place({{},
               ParkedAt{maneuver.goal()},
               {{box.x_min, box.y_min}, {box.x_max, box.y_min}, {box.x_max, box.y_max}, {box.x_min, box.y_max}}}),
        maneuver.entry()};
    ParkAnswer answer;
    answer.maneuver = maneuver;
    const std::string driven = changes_label(maneuver.direction_changes()) + "; " +
                               path_label(maneuver.length(), unit_for(maneuver.car.length())) + " driven";
    return drawn({maneuver.car, scene.place, scene.start, answer, frame_of(scene), "the maneuver alone"}, driven,
                 format, {});
}

}  // namespace snug
