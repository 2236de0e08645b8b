// The options --trajectory, --period and the limits of motion: a maneuver over time as a file.
#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "snug/maneuver.hpp"
#include "snug/trajectory.hpp"

namespace snug::cli {

struct TrajectoryOptions {
    explicit TrajectoryOptions(Options& options);

    Option<std::string> file;
    Option<double> period;
    Option<double> speed;
    Option<double> acceleration;
    Option<double> deceleration;
    Option<double> steering_rate;
};

struct TrajectoryFile {
    enum class Format { csv, json, openscenario };

    std::string path;
    Format format = Format::csv;
    double period = 0.0;  ///< [s]
    MotionLimits limits;
};

/// Where a trajectory was asked for, checked as far as one can before the work; the others must be other files.
std::optional<TrajectoryFile> trajectory_file(const TrajectoryOptions& options, const Option<std::string>& waypoints,
                                              const Option<std::string>& draw, const Option<std::string>& output);

/// What the file holds; no points when there is no maneuver, so that no old ones stay behind. Throws Error.
std::string written(const TrajectoryFile& file, const Car& car, const std::optional<Maneuver>& maneuver);
std::string written(const TrajectoryFile& file, const Trajectory& whole);

}  // namespace snug::cli
