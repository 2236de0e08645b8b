// The answers of the search over all maneuvers as JSON objects, key by key as documented.
#include <nlohmann/json.hpp>

#include "io/conditions.hpp"
#include "snug/io.hpp"

namespace snug {

namespace {

void add_bounds(Json& json, const Answer& answer) {
    if (answer.direction_changes) json["direction_changes"] = *answer.direction_changes;
    json["proved"] = answer.proved;
    json["lower_bound"] = answer.lower_bound;
}

}  // namespace

Json as_json(const Car& car, const Slot& slot, std::optional<int> max_changes, const Answer& answer,
             const Driving& driving, const Parked& parked) {
    Json json = {{"schema", 1},
                 {"car", as_json(car)},
                 {"slot", as_json(slot)},
                 {"strategy", "fewest"},
                 {"max_changes", nullptr}};
    if (max_changes) json["max_changes"] = *max_changes;
    add_conditions(json, driving, parked);
    json["parkable"] = nullptr;
    if (answer.direction_changes || answer.proved) json["parkable"] = answer.direction_changes.has_value();
    add_bounds(json, answer);
    json["entry_ranges"] = Json::array();
    if (answer.maneuver) json["maneuver"] = as_json(*answer.maneuver);
    return json;
}

Json any_maneuver_as_json(const Answer& answer) {
    Json json = {{"direction_changes", nullptr}, {"lower_bound", answer.lower_bound}, {"proved", answer.proved}};
    if (answer.direction_changes) json["direction_changes"] = *answer.direction_changes;
    return json;
}

Json as_json(const StartTolerance& tolerance) {
    return {{"along", tolerance.along},
            {"out", tolerance.out},
            {"both", {{"along", tolerance.both_along}, {"out", tolerance.both_out}}}};
}

Json leave_as_json(const Car& car, const Slot& slot, const Answer& answer, const Driving& driving) {
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"slot", as_json(slot)}};
    add_conditions(json, driving, {});
    add_bounds(json, answer);
    if (answer.maneuver) json["maneuver"] = as_json(*answer.maneuver);
    return json;
}

}  // namespace snug
