// Cars, slots, maneuvers and answers as JSON objects, key by key as documented.
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/conditions.hpp"
#include "snug/io.hpp"

namespace snug {

Json as_json(const Car& car) {
    Json json = Json::object();
    if (!car.name().empty()) {
        json["name"] = car.name();
    }
    json["width"] = car.width();
    json["front"] = car.front();
    json["rear"] = car.rear();
    json["wheelbase"] = car.wheelbase();
    json["max_steer"] = car.max_steer();
    if (!car.is_rectangle()) {
        Json& outline = json["outline"] = Json::array();
        for (const Point& corner : car.outline().corners()) outline.push_back(Json::array({corner.x, corner.y}));
    }
    return json;
}

Json as_json(const Slot& slot) {
    Json json = {{"length", slot.length()},
                 {"width", slot.width()},
                 {"side", to_string(slot.side())},
                 {"corner", Json::array({slot.corner().x, slot.corner().y})},
                 {"heading", slot.heading()}};
    if (slot.front_setback() > 0.0) json["front_setback"] = slot.front_setback();
    if (slot.rear_setback() > 0.0) json["rear_setback"] = slot.rear_setback();
    if (slot.curb() == Curb::low) json["curb"] = to_string(slot.curb());
    return json;
}

void add_conditions(Json& json, const Driving& driving, const Parked& parked) {
    if (driving != Driving{}) {
        Json& how = json["driving"] = {{"enter", to_string(driving.enter)}, {"clearance", driving.clearance}};
        if (driving.curb_clearance) how["curb_clearance"] = *driving.curb_clearance;
    }
    if (parked == Parked{}) return;
    Json& what = json["parked"] = Json::object();
    if (std::isfinite(parked.heading)) what["heading"] = parked.heading;
    if (std::isfinite(parked.curb)) what["curb"] = parked.curb;
}

Json as_json(const Pose& pose) { return {{"x", pose.x}, {"y", pose.y}, {"heading", pose.heading}}; }

Json as_json(const Box& box) {
    return {{"x_min", box.x_min}, {"x_max", box.x_max}, {"y_min", box.y_min}, {"y_max", box.y_max}};
}

Json as_json(const Move& move) {
    const double angle = move.steering_angle;
    Json json = {{"direction", to_string(move.direction)},
                 {"steering", angle > 0.0   ? "left"
                              : angle < 0.0 ? "right"
                                            : "straight"},
                 {"steering_angle", angle},
                 {"length", move.length},
                 {"start", as_json(move.start)},
                 {"end", as_json(move.end)},
                 {"contact", nullptr}};
    if (move.contact) {
        json["contact"] = {{"car", to_string(move.contact->part)}, {"obstacle", to_string(move.contact->obstacle)}};
    }
    return json;
}

Json as_json(const Maneuver& maneuver) {
    Json moves = Json::array();
    for (const Move& move : maneuver.moves) {
        Json& one = moves.emplace_back(as_json(move));
        if (move.contact && !maneuver.car.is_rectangle()) one["contact"]["index"] = move.contact->part_index;
    }
    const Trajectory timed = trajectory(maneuver);
    return {{"direction_changes", maneuver.direction_changes()},
            {"length", maneuver.length()},
            {"seconds", timed.seconds()},
            {"standing_steers", timed.standing_steers},
            {"swept", as_json(swept(maneuver))},
            {"entry", as_json(maneuver.entry())},
            {"goal", as_json(maneuver.goal())},
            {"moves", std::move(moves)}};
}

Json as_json(const Car& car, const Slot& slot, const EntryOptions& options, const Answer& answer,
             std::string_view strategy) {
    Json json = {{"schema", 1},
                 {"car", as_json(car)},
                 {"slot", as_json(slot)},
                 {"strategy", strategy},
                 {"max_changes", nullptr}};
    if (options.max_changes) {
        json["max_changes"] = *options.max_changes;
    }
    add_conditions(json, options.driving, options.parked);
    json["parkable"] = nullptr;
    if (!answer.cancelled) {
        json["parkable"] = answer.parkable();
    }
    if (answer.direction_changes) {
        json["direction_changes"] = *answer.direction_changes;
    }
    if (options.prove && strategy == "max-steer" && !answer.cancelled) {
        json["proved"] = answer.proved;
        Json& undecided = json["undecided"] = Json::array();
        for (const Headings& part : answer.undecided)
            undecided.push_back({{"heading_min", part.min}, {"heading_max", part.max}});
        if (!answer.parkable() && answer.lower_bound > 0) json["proved_changes"] = answer.lower_bound - 1;
    }
    json["entry_ranges"] = Json::array();
    for (const HeadingRange& range : answer.ranges) {
        json["entry_ranges"].push_back({{"heading_min", range.min},
                                        {"heading_max", range.max},
                                        {"direction_changes", range.direction_changes},
                                        {"subrange", range.subrange}});
    }
    if (answer.maneuver) {
        json["maneuver"] = as_json(*answer.maneuver);
    }
    return json;
}

}  // namespace snug
