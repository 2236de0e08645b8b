// What `snug park` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/trajectory.hpp"
#include "cli/waypoints.hpp"
#include "snug/park.hpp"
#include "snug/rolling.hpp"
#include "snug/scene.hpp"

namespace snug::cli {

struct ParkQuestion {
    Car car;
    Scene scene;                   ///< also of a street, with the place it is
    std::optional<Street> street;  ///< when it is one
    ParkOptions options;
    bool leaving = false;  ///< the way out of the street's slot, onto the road
};

/// What a person needs: what to do move by move from where the car stands, how it ends, and what is proved. At most 80 columns.
std::string park_text(const ParkQuestion& question, const ParkAnswer& answer);
/// The same where the steering turns only while the car rolls.
std::string park_text(const ParkQuestion& question, const RollingAnswer& answer);

/// The car, the place and where the car stands, of park and drive alike: a slot at a street, or --scene; and --from.
struct WhereOptions {
    explicit WhereOptions(Options& options);
    [[nodiscard]] ParkQuestion question() const;

    BayOptions bay;
    ParkedOptions parked;
    DrivingOptions driving;
    Option<std::string> scene;
    Option<Pose> from;
};

/// --max-changes, --resolution and --time-limit, of park and leave alike.
struct SearchOptions {
    /// `finest`: what part of the car's length the spacing is by default.
    SearchOptions(Options& options, const std::string& finest);
    /// Of ParkOptions or FewestOptions.
    template <class Asked>
    void limit(Asked& asked) const {
        asked.max_changes = max_changes.value_or(asked.max_changes);
        asked.resolution = resolution.value_or(asked.resolution);
        asked.time_limit = time_limit.value_or(asked.time_limit);
        if constexpr (requires { asked.threads; }) asked.threads = threads.value_or(0);
    }

    Option<int> max_changes;
    Option<double> resolution;
    Option<double> time_limit;
    Option<int> threads;
};

/// --steer.
Option<Steer> steer_option(Options& options);

/// What --draw shows.
enum class ParkView { maneuver, map };

/// Where the parts of an answer go.
struct ParkFiles {
    Format format = Format::text;
    std::optional<PictureFile> picture;
    std::optional<WaypointsFile> route;
    std::optional<TrajectoryFile> timed;
    std::string path;  ///< empty for standard output
    ParkView view = ParkView::maneuver;
};

/// -o, --format, --draw, --waypoints and --trajectory.
struct ParkFileOptions {
    explicit ParkFileOptions(Options& options);
    [[nodiscard]] ParkFiles files(Format format) const;

    OutputOptions output;
    Option<std::string> draw;
    WaypointsOptions waypoints;
    TrajectoryOptions trajectory;
};

/// Answers the question, with what is known when Ctrl-C is pressed.
Action park_action(const ParkQuestion& question, const ParkFiles& files);
/// With steering that turns only while the car rolls.
Action rolling_action(const ParkQuestion& question, const ParkFiles& files);

}  // namespace snug::cli
