// What `snug park` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "cli/trajectory.hpp"
#include "cli/waypoints.hpp"
#include "snug/park.hpp"
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

/// Where the parts of an answer go.
struct ParkFiles {
    Format format = Format::text;
    std::optional<PictureFile> picture;
    std::optional<WaypointsFile> route;
    std::optional<TrajectoryFile> timed;
    std::string path;  ///< empty for standard output
};

/// Answers the question, with what is known when Ctrl-C is pressed.
Action park_action(const ParkQuestion& question, const ParkFiles& files);

}  // namespace snug::cli
