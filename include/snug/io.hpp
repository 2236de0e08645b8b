// Cars and answers as JSON and CSV: the files the command reads and the answers it prints.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/drive.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"
#include "snug/min_slot.hpp"
#include "snug/min_street.hpp"
#include "snug/park.hpp"
#include "snug/rolling.hpp"
#include "snug/scene.hpp"
#include "snug/start_tolerance.hpp"
#include "snug/trajectory.hpp"
#include "snug/waypoints.hpp"

namespace snug {

/// JSON whose keys stay in the order they were set. Numbers are written with all their digits and read back the same.
using Json = nlohmann::ordered_json;

/// A car from a JSON object: `width`, `front`, `rear`, `wheelbase` [m], one of `max_steer` [rad], `max_steer_deg`,
/// `turning_radius` (of the rear axle centre) [m] or `curb_to_curb` (diameter) [m], and optionally `name`.
/// Throws Error, beginning with `source`, when it is anything else.
Car car_from_json(std::string_view text, const std::string& source);
/// The car in a file of at most 1 MB. Throws Error when it cannot be read.
Car read_car(const std::string& path);

/// Cars from CSV (RFC 4180), as `snug cars --format csv` writes it: a line names the columns, in any order, and each further
/// line is a car. Needed are `name` (a different one for each car), `width`, `front`, `rear`, `wheelbase` and one of
/// `max_steer`, `max_steer_deg`, `turning_radius` and `curb_to_curb`, as in a car file. There may be several of these, of
/// which a car fills at least one, and `length`; those filled must agree. Throws Error, beginning with `source` and with the
/// line and column, when anything is wrong.
std::vector<Car> cars_from_csv(std::string_view text, const std::string& source);
/// The cars in a file of at most 100 MB. Throws Error when it cannot be read.
std::vector<Car> read_cars(const std::string& path);

/// A car file, with `max_steer`; a car that is no rectangle has its `outline`.
Json as_json(const Car& car);
/// A fleet that cars_from_csv() reads back the same.
std::string as_csv(const std::vector<Car>& cars);
Json as_json(const Slot& slot);
Json as_json(const Pose& pose);
Json as_json(const Box& box);
Json as_json(const Move& move);
Json as_json(const Maneuver& maneuver);
/// The answer of `snug entry --format json`; the strategy may be the name of a baseline.
Json as_json(const Car& car, const Slot& slot, const EntryOptions& options, const Answer& answer,
             std::string_view strategy = "max-steer");

/// The answer of `snug entry --strategy fewest --format json`, with `proved` and `lower_bound`. `max_changes` as asked.
Json as_json(const Car& car, const Slot& slot, std::optional<int> max_changes, const Answer& answer,
             const Driving& driving = {}, const Parked& parked = {});
/// `any_maneuver`: what all maneuvers can where a strategy cannot park; `direction_changes` is null where none was found.
Json any_maneuver_as_json(const Answer& answer);
/// `start_tolerance`: how far the start may be off along the slot, out into the road, and both at once.
Json as_json(const StartTolerance& tolerance);
/// A row of `snug min-slot --format json`.
Json as_json(const MinSlot& slot, const MinSlotOptions& options);
/// The same number of rows for every street, counts inside, as min_streets() has them.
Json min_streets_as_json(const Car& car, const std::vector<Street>& streets, const MinStreetOptions& options,
                         const std::vector<MinStreet>& rows);
/// max_changes,length,width,road and what is sought with _lower
std::string min_streets_as_csv(const std::vector<Street>& streets, StreetSize sought,
                               const std::vector<MinStreet>& rows);
/// The answer of `snug leave --format json`.
Json leave_as_json(const Car& car, const Slot& slot, const Answer& answer, const Driving& driving = {});

/// The answer of `snug park --format json`, in a street or in a scene.
Json park_as_json(const Car& car, const Street& street, const Pose& start, const ParkOptions& options,
                  const ParkAnswer& answer);
Json park_as_json(const Car& car, const Scene& scene, const ParkOptions& options, const ParkAnswer& answer);
/// The same as CSV: a row for every move.
std::string park_as_csv(const Place& place, const ParkAnswer& answer);
/// With --steer moving: `steer`, `standing_changes`, `creep`, and the moves with the steering angle at both ends.
Json park_as_json(const Car& car, const Street& street, const Pose& start, const ParkOptions& options,
                  const RollingAnswer& answer);
Json park_as_json(const Car& car, const Scene& scene, const ParkOptions& options, const RollingAnswer& answer);
std::string park_as_csv(const RollingAnswer& answer);
/// The answer of `snug drive --format json`, in a street or in a scene.
Json drive_as_json(const Car& car, const Street& street, const Pose& start, const DriveOptions& options,
                   const DriveAnswer& answer);
Json drive_as_json(const Car& car, const Scene& scene, const DriveOptions& options, const DriveAnswer& answer);
/// The same as CSV: a row for every run.
std::string drive_as_csv(const DriveAnswer& answer);
/// A street's slot, and a scene as a file of its own.
Json as_json(const Street& street);
Json as_json(const Scene& scene);

/// `snug entry --waypoints FILE.json`: `schema` and `waypoints`, a list of objects.
Json as_json(const std::vector<Waypoint>& waypoints);
/// `snug entry --waypoints FILE.csv`: a row for each, all numbers, the direction 1 forward and -1 backward.
std::string as_csv(const std::vector<Waypoint>& waypoints);

Json as_json(const MotionLimits& limits);
/// `--trajectory FILE.json`: `schema`, `car`, `limits`, `seconds`, `standing_steers` and `trajectory`, a list of objects, one
/// every `period` [s].
Json as_json(const Trajectory& trajectory, double period);
/// `--trajectory FILE.csv`: a row for each, all numbers, the direction 1 forward and -1 backward.
std::string as_csv(const Trajectory& trajectory, double period);
/// `--trajectory FILE.xosc`: an OpenSCENARIO 1.0 scenario in which the car follows the trajectory, a vertex every `period` [s].
std::string as_openscenario(const Trajectory& trajectory, double period);

/// JSON text: what fits on a line stays on one; ends with a newline.
std::string write(const Json& json);
/// A number with all its digits, as in JSON.
std::string write(double number);

/// The text of an object whose last value is a list that may be too long to hold: part by part, as write() would say it over
/// several lines.
class ListInParts {
public:
    std::string begin(const Json& object, const std::string& key_of_list);
    std::string item(const Json& item);
    std::string end();

private:
    bool first_ = true;
};

}  // namespace snug
