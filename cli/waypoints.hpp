// The options --waypoints and --spacing: a maneuver as a file for path followers.
#pragma once

#include <optional>
#include <string>

#include "cli/options.hpp"
#include "snug/maneuver.hpp"

namespace snug::cli {

struct WaypointsOptions {
    explicit WaypointsOptions(Options& options);

    Option<std::string> file;
    Option<double> spacing;
};

struct WaypointsFile {
    std::string path;
    bool json = false;     ///< otherwise CSV
    double spacing = 0.0;  ///< [m]
};

/// Where waypoints were asked for, checked as far as one can before the work; `draw` and `output` must be other files.
std::optional<WaypointsFile> waypoints_file(const WaypointsOptions& options, const Option<std::string>& draw,
                                            const Option<std::string>& output);

/// What the file holds; no waypoints when there is no maneuver, so that no old ones stay behind. Throws Error.
std::string written(const WaypointsFile& file, const std::optional<Maneuver>& maneuver);

}  // namespace snug::cli
