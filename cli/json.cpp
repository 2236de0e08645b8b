// The only file of the command that knows the JSON library.
#include "cli/json.hpp"

#include <nlohmann/json.hpp>

namespace snug::cli {
namespace {

Json fewest_object(const EntryQuestion& question, const Answer& answer) {
    const EntryOptions& options = question.options;
    return as_json(question.car, question.slot, options.max_changes, answer, options.driving, options.parked);
}

}  // namespace

std::string car_json(const Car& car) { return write(as_json(car)); }

std::string cars_json(const std::vector<Car>& cars) {
    Json list = Json::array();
    for (const Car& car : cars) list.push_back(as_json(car));
    return write(list);
}

std::string entry_json(const EntryQuestion& question, const Answer& answer, const std::optional<Answer>& any_maneuver,
                       const std::optional<StartTolerance>& tolerance) {
    Json json = as_json(question.car, question.slot, question.options, answer, strategy_name(question.baseline));
    if (any_maneuver) json["any_maneuver"] = any_maneuver_as_json(*any_maneuver);
    if (tolerance) json["start_tolerance"] = as_json(*tolerance);
    return write(json);
}

std::string fewest_json(const EntryQuestion& question, const Answer& answer) {
    return write(fewest_object(question, answer));
}

std::string leave_json(const EntryQuestion& question, const Answer& answer) {
    return write(leave_as_json(question.car, question.slot, answer, question.options.driving));
}

std::string park_json(const ParkQuestion& question, const ParkAnswer& answer) {
    if (question.street)
        return write(park_as_json(question.car, *question.street, question.scene.start, question.options, answer));
    return write(park_as_json(question.car, question.scene, question.options, answer));
}

std::string park_json(const ParkQuestion& question, const RollingAnswer& answer) {
    if (question.street)
        return write(park_as_json(question.car, *question.street, question.scene.start, question.options, answer));
    return write(park_as_json(question.car, question.scene, question.options, answer));
}

std::string drive_json(const ParkQuestion& question, const DriveOptions& options, const DriveAnswer& answer) {
    if (question.street)
        return write(drive_as_json(question.car, *question.street, question.scene.start, options, answer));
    return write(drive_as_json(question.car, question.scene, options, answer));
}

std::string atlas_json(const EntryQuestion& question, Strategy strategy, const Answer& answer, const AtlasCell& cell) {
    Json json = strategy == Strategy::fewest ? fewest_object(question, answer)
                                             : as_json(question.car, question.slot, question.options, answer);
    json["cell"] = {{"length", cell.length()},
                    {"width", cell.width()},
                    {"shorter", question.slot.length() - cell.length()},
                    {"narrower", question.slot.width() - cell.width()}};
    return write(json);
}

std::string waypoints_json(const std::vector<Waypoint>& waypoints) { return write(as_json(waypoints)); }

std::string trajectory_json(const Trajectory& trajectory, double period) { return write(as_json(trajectory, period)); }

std::string clearance_json(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows) {
    Json json = {{"schema", 1},
                 {"car", as_json(question.car)},
                 {"strategy", to_string(question.options.strategy)},
                 {"rows", Json::array()}};
    for (const KeptClearance& kept : rows) {
        Json& row = json["rows"].emplace_back(Json{{"max_changes", kept.max_changes},
                                                   {"width", question.slot.width()},
                                                   {"length", question.slot.length()},
                                                   {"clearance", nullptr}});
        if (kept.clearance) row["clearance"] = *kept.clearance;
        if (question.options.strategy == Strategy::fewest) row["clearance_upper"] = kept.upper;
    }
    return write(json);
}

std::string min_street_json(const MinStreetQuestion& question, const std::vector<MinStreet>& rows) {
    return write(min_streets_as_json(question.car, question.streets, question.options, rows));
}

std::string MinSlotJson::begin() {
    return list_.begin({{"schema", 1}, {"car", as_json(question_.car)}, {"strategy", strategy_name(question_)}},
                       "rows");
}

std::string MinSlotJson::row(const MinSlot& row) { return list_.item(as_json(row, question_.options)); }

std::string MinSlotJson::end() { return list_.end(); }

}  // namespace snug::cli
