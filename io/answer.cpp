// Cars, slots, maneuvers and answers as JSON objects, key by key as documented.
#include <iterator>
#include <nlohmann/json.hpp>
#include <variant>

#include "snug/io.hpp"

namespace snug {

std::string_view to_string(const Strategy& strategy) {
    constexpr std::string_view names[] = {"max-steer", "stepping", "reversed-trials", "parallel-trials"};
    static_assert(std::size(names) == std::variant_size_v<Strategy>);
    return names[strategy.index()];
}

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
    return json;
}

Json as_json(const Slot& slot) {
    return {{"length", slot.length()},
            {"width", slot.width()},
            {"side", slot.side() == Side::right ? "right" : "left"},
            {"corner", Json::array({slot.corner().x, slot.corner().y})},
            {"heading", slot.heading()}};
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
        moves.push_back(as_json(move));
    }
    return {{"direction_changes", maneuver.direction_changes()},
            {"length", maneuver.length()},
            {"swept", as_json(swept(maneuver))},
            {"entry", as_json(maneuver.entry())},
            {"goal", as_json(maneuver.goal())},
            {"moves", std::move(moves)}};
}

Json as_json(const Car& car, const Slot& slot, const EntryOptions& options, const Answer& answer) {
    Json json = {{"schema", 1},
                 {"car", as_json(car)},
                 {"slot", as_json(slot)},
                 {"strategy", to_string(options.strategy)},
                 {"max_changes", nullptr},
                 {"parkable", nullptr}};
    if (options.max_changes) {
        json["max_changes"] = *options.max_changes;
    }
    if (!answer.cancelled) {
        json["parkable"] = answer.parkable();
    }
    if (answer.direction_changes) {
        json["direction_changes"] = *answer.direction_changes;
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
