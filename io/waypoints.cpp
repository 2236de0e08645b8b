// Waypoints as JSON and as CSV.
#include <nlohmann/json.hpp>

#include "io/csv.hpp"
#include "snug/io.hpp"

namespace snug {

Json as_json(const std::vector<Waypoint>& waypoints) {
    Json json = {{"schema", 1}, {"waypoints", Json::array()}};
    for (const Waypoint& waypoint : waypoints) {
        json["waypoints"].push_back({{"x", waypoint.pose.x},
                                     {"y", waypoint.pose.y},
                                     {"heading", waypoint.pose.heading},
                                     {"direction", to_string(waypoint.direction)},
                                     {"curvature", waypoint.curvature},
                                     {"distance", waypoint.distance}});
    }
    return json;
}

std::string as_csv(const std::vector<Waypoint>& waypoints) {
    Csv csv({"x", "y", "heading", "direction", "curvature", "distance"});
    for (const Waypoint& waypoint : waypoints)
        csv.row(waypoint.pose.x, waypoint.pose.y, waypoint.pose.heading, static_cast<int>(waypoint.direction),
                waypoint.curvature, waypoint.distance);
    return csv.text();
}

}  // namespace snug
