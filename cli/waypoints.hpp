// The options --waypoints and --spacing: a maneuver as a file for path followers.
#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "snug/maneuver.hpp"

namespace snug::cli {

struct WaypointsFile {
    std::string path;
    bool json = false;     ///< otherwise CSV
    double spacing = 0.0;  ///< [m]
};

void add_waypoints(Options& options);

/// Where waypoints were asked for, checked as far as one can before the work.
std::optional<WaypointsFile> waypoints_file(const Options& options);

/// What the file holds; no waypoints when there is no maneuver, so that no old ones stay behind. Throws Error.
std::string written(const WaypointsFile& file, const std::optional<Maneuver>& maneuver);

}  // namespace snug::cli
