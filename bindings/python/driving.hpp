// What stands between a plan and the wheels, with what was asked: rolling ways, simulated runs.
#pragma once

#include <optional>
#include <string>

#include "answers.hpp"
#include "progress.hpp"
#include "snug/drive.hpp"

namespace snug::python {

/// Of park() with steer='moving'.
struct AskedRolling : RollingAnswer {
    std::optional<Car> car;
    std::optional<AnyPlace> place;
    Pose start;
    int max_changes = 0;  ///< as asked
    double clearance = 0.0;
};

/// Of drive_runs().
struct AskedDrive : DriveAnswer {
    std::optional<Car> car;
    std::optional<AnyPlace> place;
    Pose start;
    DriveOptions options;  ///< without what tells progress
    Point actuation;
    Point slot_error;
};

Place place_of(const AnyPlace& place);
Pose start_in(const AnyPlace& place, const Car& car);
/// The `heading` given, which a map covers the surroundings of, or else the street's or that of the scene's start.
double heading_in(const AnyPlace& place, const std::optional<double>& heading);

AskedRolling park_moving(const Car& car, const AnyPlace& place, const Pose& start, const ParkOptions& options,
                         double steering_rate, Progress& progress);

std::string json_text(const AskedRolling& answer);
std::string json_text(const AskedDrive& answer);
std::optional<std::string> picture(const AskedRolling& answer);
std::optional<std::string> picture(const AskedDrive& answer);

}  // namespace snug::python
