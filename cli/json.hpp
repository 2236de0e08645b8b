// Answers as JSON text: what the command needs of the JSON library, which takes long to compile, behind plain functions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/clearance.hpp"
#include "cli/drive.hpp"
#include "cli/entry.hpp"
#include "cli/min_slot.hpp"
#include "cli/min_street.hpp"
#include "cli/park.hpp"
#include "snug/atlas.hpp"
#include "snug/io.hpp"
#include "snug/leave.hpp"
#include "snug/sweep.hpp"
#include "snug/trajectory.hpp"
#include "snug/waypoints.hpp"

namespace snug::cli {

std::string car_json(const Car& car);
std::string cars_json(const std::vector<Car>& cars);
/// With what any maneuver can do, where that was asked because the strategy cannot park.
std::string entry_json(const EntryQuestion& question, const Answer& answer, const std::optional<Answer>& any_maneuver,
                       const std::optional<StartTolerance>& tolerance);
std::string fewest_json(const EntryQuestion& question, const Answer& answer);
std::string leave_json(const EntryQuestion& question, const Answer& answer);
std::string park_json(const ParkQuestion& question, const ParkAnswer& answer);
std::string park_json(const ParkQuestion& question, const RollingAnswer& answer);
std::string drive_json(const ParkQuestion& question, const DriveOptions& options, const DriveAnswer& answer);
/// The answer of an atlas, with the stored cell that it comes from.
std::string atlas_json(const EntryQuestion& question, Strategy strategy, const Answer& answer, const AtlasCell& cell);
std::string clearance_json(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows);
std::string min_street_json(const MinStreetQuestion& question, const std::vector<MinStreet>& rows);
std::string waypoints_json(const std::vector<Waypoint>& waypoints);
std::string trajectory_json(const Trajectory& trajectory, double period);

/// Minimum slots, part by part, for there may be too many to hold.
class MinSlotJson {
public:
    explicit MinSlotJson(const MinSlotQuestion& question) : question_(question) {}

    std::string begin();
    std::string row(const MinSlot& row);
    std::string end();

private:
    const MinSlotQuestion& question_;
    ListInParts list_;
};

}  // namespace snug::cli
