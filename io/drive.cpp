// The answers of drive_runs() as JSON and CSV.
#include <limits>
#include <nlohmann/json.hpp>

#include "io/csv.hpp"
#include "io/lists.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

void add_answer(Json& json, const Car& car, const Pose& start, const DriveOptions& options, const DriveAnswer& answer) {
    json["start"] = as_json(start);
    json["sensing"] = list_of(options.errors.sensing);
    json["bias"] = list_of(options.errors.bias);
    json["actuation"] = Json::array({options.errors.distance, options.errors.steering});
    json["lag"] = options.errors.lag;
    json["slot_error"] = Json::array({options.errors.slot_place, options.errors.slot_size});
    json["steer"] = options.steer == Steer::moving ? "moving" : "standing";
    json["rate"] = options.rate;
    json["runs"] = answer.runs.size();
    json["seed"] = options.seed;
    json["plannable"] = answer.plannable;
    if (!answer.plannable) return;
    json["margin"] = answer.margin;
    json["parked"] = answer.parked();
    json["contacts"] = answer.contacts();
    json["planned_changes"] = answer.planned_changes;
    json["lower_bound"] = answer.lower_bound;
    if (answer.standing_changes) json["standing_changes"] = *answer.standing_changes;
    if (answer.runs.empty()) return;
    const DriveTotals all = answer.totals();
    json["direction_changes"] = {{"mean", all.mean_changes}, {"max", all.most_changes}};
    const Trajectory planned = answer.planned ? answer.planned_trajectory(options.limits) : Trajectory{car, {}, {}, 0};
    json["standing_steers"] = {
        {"planned", planned.standing_steers}, {"mean", all.mean_standing_steers}, {"max", all.most_standing_steers}};
    json["seconds"] = {{"planned", planned.seconds()}, {"mean", all.mean_seconds}, {"max", all.most_seconds}};
    json["smallest_distance"] = nullptr;  // in a place without obstacles
    if (all.smallest_distance < std::numeric_limits<double>::infinity())
        json["smallest_distance"] = all.smallest_distance;
}

}  // namespace

Json drive_as_json(const Car& car, const Street& street, const Pose& start, const DriveOptions& options,
                   const DriveAnswer& answer) {
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"slot", as_json(street)}};
    add_answer(json, car, start, options, answer);
    return json;
}

Json drive_as_json(const Car& car, const Scene& scene, const DriveOptions& options, const DriveAnswer& answer) {
    Json json = {{"schema", 1}, {"car", as_json(car)}, {"scene", as_json(scene)}};
    add_answer(json, car, scene.start, options, answer);
    return json;
}

std::string drive_as_csv(const DriveAnswer& answer) {
    Csv csv({"run", "parked", "contact", "direction_changes", "standing_steers", "seconds", "smallest_distance"});
    for (std::size_t i = 0; i < answer.runs.size(); ++i) {
        const DriveRun& run = answer.runs[i];
        csv.row(i, run.parked ? 1 : 0, run.contact ? 1 : 0, run.direction_changes, run.standing_steers, run.seconds,
                run.smallest_distance);
    }
    return csv.text();
}

}  // namespace snug
