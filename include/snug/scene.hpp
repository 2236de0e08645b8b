// Scene: a place and where the car stands in it, from a file.
#pragma once

#include <string>
#include <string_view>

#include "snug/place.hpp"

namespace snug {

struct Scene {
    Place place;
    Pose start;
};

/// A scene from a JSON object: `obstacles`, a list of polygons or of `{"polygon": [[x, y], ...], "low": true, "name": ".."}`;
/// `parked`, `{"inside": [[x, y], ...], "heading": RAD, "heading_tolerance": RAD}` or `{"pose": [x, y, RAD], "tolerance":
/// [along, across, RAD]}`; `start`, `[x, y, RAD]`; and optionally `region`, `{"x_min": .., "x_max": .., "y_min": .., "y_max":
/// ..}`, of the rear axle's middle: else everything named and 10 m on each side. Throws Error, beginning with `source`, when it
/// is anything else.
Scene scene_from_json(std::string_view text, const std::string& source);

/// A case of the TPCAP benchmark: start and parked pose (x, y, heading), the number of obstacles, the number of corners of each,
/// and the corners, all separated by commas or blanks. Parked is within 0.1 m and 0.05 rad. Throws Error as above.
Scene scene_from_csv(std::string_view text, const std::string& source);

/// The scene in a file of at most 1 MB; one whose name ends in .csv is read as a case of TPCAP. Throws Error when it cannot be
/// read.
Scene read_scene(const std::string& path);

}  // namespace snug
