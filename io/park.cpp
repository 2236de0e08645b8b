// The answers of park() as JSON and CSV, and what they were asked of: streets and scenes.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/conditions.hpp"
#include "io/csv.hpp"
#include "io/lists.hpp"
#include "snug/io.hpp"

namespace snug {

Json list_of(const Pose& pose) { return Json::array({pose.x, pose.y, pose.heading}); }

namespace {

Json point(const Point& p) { return Json::array({p.x, p.y}); }

Json polygon(const std::vector<Point>& corners) {
    Json list = Json::array();
    for (const Point& corner : corners) list.push_back(point(corner));
    return list;
}

Json driven(const Maneuver& maneuver, const Pose& start, const std::vector<ParkStop>& stops, const Place& place) {
    Json moves = Json::array();
    for (std::size_t i = 0; i < maneuver.moves.size(); ++i) {
        Json move = as_json(maneuver.moves[i]);
        if (i < stops.size()) {
            const ParkStop& stop = stops[i];
            const Json met = {{"car", to_string(stop.gap.part)}, {"obstacle", place.name_of(stop.obstacle)}};
            if (stop.is_contact()) move["contact"] = met;
            move["nearest"] = met;
            move["nearest"]["distance"] = std::max(0.0, stop.gap.distance);
        }
        moves.push_back(std::move(move));
    }
    const bool stays = maneuver.moves.empty();
    const Trajectory timed = trajectory(maneuver);
    return {{"direction_changes", stays ? 0 : maneuver.direction_changes()},
            {"length", maneuver.length()},
            {"seconds", timed.seconds()},
            {"standing_steers", timed.standing_steers},
            {"start", as_json(start)},
            {"goal", as_json(stays ? start : maneuver.goal())},
            {"moves", std::move(moves)}};
}

/// What follows the question.
void add_answer(Json& json, const Place& place, const Pose& start, const ParkOptions& options,
                const ParkAnswer& answer) {
    json["start"] = as_json(start);
    json["max_changes"] = options.max_changes;
    json["parkable"] = nullptr;
    if (answer.direction_changes || answer.proved) json["parkable"] = answer.direction_changes.has_value();
    if (answer.direction_changes) json["direction_changes"] = *answer.direction_changes;
    json["proved"] = answer.proved;
    json["lower_bound"] = answer.lower_bound;
    if (answer.impossible) json["impossible"] = true;
    json["spacing"] = answer.spacing;
    if (!answer.maneuver) return;
    json["maneuver"] = driven(*answer.maneuver, start, answer.stops, place);
    if (answer.alternatives.empty()) return;
    Json& others = json["alternatives"] = Json::array();
    for (const Maneuver& other : answer.alternatives) others.push_back(driven(other, start, {}, place));
}

}  // namespace

Json as_json(const Street& street) {
    Json json = {{"length", street.length},
                 {"width", street.width},
                 {"side", street.side == Side::right ? "right" : "left"},
                 {"corner", point(street.corner)},
                 {"heading", street.heading},
                 {"angle", street.angle},
                 {"road", nullptr},
                 {"stretch", street.stretch}};
    if (street.road) json["road"] = *street.road;
    if (street.front_setback > 0.0) json["front_setback"] = street.front_setback;
    if (street.rear_setback > 0.0) json["rear_setback"] = street.rear_setback;
    if (street.curb == Curb::low) json["curb"] = "low";
    return json;
}

Json as_json(const Scene& scene) {
    Json json = {{"obstacles", Json::array()}};
    for (const PlaceObstacle& obstacle : scene.place.obstacles()) {
        Json one = polygon(obstacle.corners);
        if (obstacle.low || !obstacle.name.empty()) {
            one = {{"polygon", std::move(one)}};
            if (obstacle.low) one["low"] = true;
            if (!obstacle.name.empty()) one["name"] = obstacle.name;
        }
        json["obstacles"].push_back(std::move(one));
    }
    if (const auto* inside = std::get_if<ParkedInside>(&scene.place.parked())) {
        json["parked"] = {{"inside", polygon(inside->corners)},
                          {"heading", inside->heading},
                          {"heading_tolerance", inside->heading_tolerance}};
    } else {
        const auto& at = std::get<ParkedAt>(scene.place.parked());
        json["parked"] = {{"pose", list_of(at.pose)}, {"tolerance", Json::array({at.along, at.across, at.heading})}};
    }
    json["start"] = list_of(scene.start);
    Box around = {1e300, -1e300, 1e300, -1e300};
    for (const Point& p : scene.place.region())
        around = {std::min(around.x_min, p.x), std::max(around.x_max, p.x), std::min(around.y_min, p.y),
                  std::max(around.y_max, p.y)};
    json["region"] = as_json(around);
    return json;
}

Json park_as_json(const Car& car, const Street& street, const Pose& start, const ParkOptions& options,
                  const ParkAnswer& answer) {
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"slot", as_json(street)}};
    Driving driving;
    driving.clearance = options.clearance;
    driving.curb_clearance = street.curb_clearance;
    driving.enter = street.enter;
    add_conditions(json, driving, street.parked);
    add_answer(json, street_place(street), start, options, answer);
    return json;
}

Json park_as_json(const Car& car, const Scene& scene, const ParkOptions& options, const ParkAnswer& answer) {
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"scene", as_json(scene)}};
    Driving driving;
    driving.clearance = options.clearance;
    add_conditions(json, driving, {});
    add_answer(json, scene.place, scene.start, options, answer);
    return json;
}

namespace {

double steering_angle(const RollingPiece& piece, const Car& car, double distance) {
    return std::atan(car.wheelbase() * piece.curvature_at(distance));
}

ParkAnswer counts_of(const RollingAnswer& answer) {
    ParkAnswer counts;
    if (answer.maneuver) counts.direction_changes = answer.maneuver->direction_changes();
    counts.lower_bound = answer.lower_bound;
    counts.proved = counts.direction_changes == answer.lower_bound;
    return counts;
}

Json as_json(const RollingManeuver& maneuver, const Pose& start) {
    Json moves = Json::array();
    for (const RollingPiece& piece : maneuver.pieces)
        moves.push_back({{"direction", to_string(piece.direction)},
                         {"steering_angle", steering_angle(piece, maneuver.car, 0.0)},
                         {"steering_angle_end", steering_angle(piece, maneuver.car, piece.length)},
                         {"curvature", piece.curvature},
                         {"sharpness", piece.sharpness},
                         {"length", piece.length},
                         {"start", as_json(piece.start)},
                         {"end", as_json(piece.end)}});
    return {{"direction_changes", maneuver.direction_changes()},
            {"length", maneuver.length()},
            {"seconds", rolling_trajectory(maneuver).seconds()},
            {"start", as_json(start)},
            {"goal", as_json(maneuver.pieces.empty() ? start : maneuver.pieces.back().end)},
            {"moves", std::move(moves)}};
}

/// Where it stands to steer.
Json steers(const RollingManeuver& maneuver) {
    Json list = Json::array();
    for (const StandingSteer& steer : maneuver.standing_steers()) {
        const RollingPiece& piece = maneuver.pieces[steer.piece];
        const double before = std::atan(maneuver.car.wheelbase() * steer.curvature);
        list.push_back({{"move", steer.piece},
                        {"direction_changes", steer.stop},
                        {"pose", as_json(piece.start)},
                        {"steering_angle", before},
                        {"steering_angle_end", steering_angle(piece, maneuver.car, 0.0)}});
    }
    return list;
}

Json with_rolling(Json json, const Pose& start, const RollingAnswer& answer) {
    json.erase("spacing");
    json["steer"] = "moving";
    json["standing_changes"] = nullptr;
    if (answer.standing_changes) json["standing_changes"] = *answer.standing_changes;
    if (answer.standing) {
        json["standing"] = as_json(*answer.standing, start);
        json["standing"]["standing_steers"] = steers(*answer.standing);
    }
    if (!answer.maneuver) return json;
    json["creep"] = answer.creep;
    json["maneuver"] = as_json(*answer.maneuver, start);
    return json;
}

}  // namespace

Json park_as_json(const Car& car, const Street& street, const Pose& start, const ParkOptions& options,
                  const RollingAnswer& answer) {
    return with_rolling(park_as_json(car, street, start, options, counts_of(answer)), start, answer);
}

Json park_as_json(const Car& car, const Scene& scene, const ParkOptions& options, const RollingAnswer& answer) {
    return with_rolling(park_as_json(car, scene, options, counts_of(answer)), scene.start, answer);
}

std::string park_as_csv(const RollingAnswer& answer) {
    Csv csv({"direction", "steering_angle", "steering_angle_end", "length", "start_x", "start_y", "start_heading",
             "end_x", "end_y", "end_heading"});
    if (!answer.maneuver) return csv.text();
    for (const RollingPiece& piece : answer.maneuver->pieces)
        csv.row(to_string(piece.direction), steering_angle(piece, answer.maneuver->car, 0.0),
                steering_angle(piece, answer.maneuver->car, piece.length), piece.length, piece.start.x, piece.start.y,
                piece.start.heading, piece.end.x, piece.end.y, piece.end.heading);
    return csv.text();
}

std::string park_as_csv(const Place& place, const ParkAnswer& answer) {
    Csv csv({"direction", "steering_angle", "length", "start_x", "start_y", "start_heading", "end_x", "end_y",
             "end_heading", "nearest_car", "nearest_obstacle", "nearest_distance"});
    if (!answer.maneuver) return csv.text();
    for (std::size_t i = 0; i < answer.maneuver->moves.size(); ++i) {
        const Move& move = answer.maneuver->moves[i];
        std::optional<std::string> part, obstacle;
        std::optional<double> distance;
        if (i < answer.stops.size()) {
            part = to_string(answer.stops[i].gap.part);
            obstacle = place.name_of(answer.stops[i].obstacle);
            distance = std::max(0.0, answer.stops[i].gap.distance);
        }
        csv.row(to_string(move.direction), move.steering_angle, move.length, move.start.x, move.start.y,
                move.start.heading, move.end.x, move.end.y, move.end.heading, part, obstacle, distance);
    }
    return csv.text();
}

}  // namespace snug
