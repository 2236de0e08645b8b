// A maneuver as a file for path followers.
#include "cli/waypoints.hpp"

#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"
#include "snug/limits.hpp"

namespace snug::cli {
namespace {

constexpr double usual_spacing = 0.05;

}  // namespace

WaypointsOptions::WaypointsOptions(Options& options)
    : file(options.text("--waypoints", "FILE",
                        "Poses along the maneuver, for path followers: FILE\nends with .csv or .json.")),
      spacing(options.number("--spacing", "M", "At most that far apart [m] (0.05).",
                             {" m", limits::finest, limits::longest})) {}

std::optional<WaypointsFile> waypoints_file(const WaypointsOptions& options, const Option<std::string>& draw,
                                            const Option<std::string>& output) {
    refuse_without(options.file, options.spacing);
    if (!options.file) return std::nullopt;
    const std::string& path = *options.file;
    const WaypointsFile file = {path, ends_with(path, ".json"), options.spacing.value_or(usual_spacing)};
    if (!file.json && !ends_with(path, ".csv"))
        throw Error(options.file.name() + ": " + in_quotes(path) +
                    " has no known extension; end it with .csv or .json");
    refuse_same_file(options.file, draw);
    refuse_same_file(options.file, output);
    check_writable(options.file.name(), path);
    return file;
}

std::string written(const WaypointsFile& file, const std::optional<Maneuver>& maneuver) {
    try {
        const std::vector<Waypoint> all = maneuver ? waypoints(*maneuver, file.spacing) : std::vector<Waypoint>{};
        return file.json ? waypoints_json(all) : as_csv(all);
    } catch (const Error& error) {
        throw Error(std::string("--spacing: ") + error.what());
    }
}

}  // namespace snug::cli
