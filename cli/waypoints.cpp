// A maneuver as a file for path followers.
#include "cli/waypoints.hpp"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "model/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr double usual_spacing = 0.05;

bool ends_with(const std::string& path, const std::string& extension) {
    return path.size() > extension.size() &&
           std::equal(extension.begin(), extension.end(), path.end() - static_cast<long>(extension.size()),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

}  // namespace

void add_waypoints(Options& options) {
    options.add("--waypoints", "FILE", "Poses along the maneuver, for path followers: FILE\nends with .csv or .json.");
    options.add("--spacing", "M", "At most that far apart [m] (0.05).");
}

std::optional<WaypointsFile> waypoints_file(const Options& options) {
    const std::string* path = options.typed("--waypoints");
    if (path == nullptr) {
        if (options.typed("--spacing") != nullptr)
            throw Error("--spacing belongs to --waypoints; leave it out or give --waypoints FILE");
        return std::nullopt;
    }
    WaypointsFile file = {*path, ends_with(*path, ".json"), usual_spacing};
    if (!file.json && !ends_with(*path, ".csv"))
        throw Error("--waypoints: " + in_quotes(*path) + " has no known extension; end it with .csv or .json");
    for (const char* other : {"--draw", "--output"}) {
        if (const std::string* taken = options.typed(other); taken != nullptr && *taken == *path)
            throw Error(std::string("--waypoints and ") + other + " are the same file; give them different names");
    }
    check_writable("--waypoints", *path);
    file.spacing = options.number("--spacing", usual_spacing, 1e-9, 1e6, " m");
    return file;
}

std::string written(const WaypointsFile& file, const std::optional<Maneuver>& maneuver) {
    try {
        const std::vector<Waypoint> all = maneuver ? waypoints(*maneuver, file.spacing) : std::vector<Waypoint>{};
        return file.json ? write(as_json(all)) : as_csv(all);
    } catch (const Error& error) {
        throw Error(std::string("--spacing: ") + error.what());
    }
}

}  // namespace snug::cli
