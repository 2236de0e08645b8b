// Waypoints as JSON and as CSV.
#include <nlohmann/json.hpp>

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
    std::string text = "x,y,heading,direction,curvature,distance\n";
    for (const Waypoint& waypoint : waypoints) {
        text += write(waypoint.pose.x) + ',' + write(waypoint.pose.y) + ',' + write(waypoint.pose.heading) + ',' +
                std::to_string(static_cast<int>(waypoint.direction)) + ',' + write(waypoint.curvature) + ',' +
                write(waypoint.distance) + '\n';
    }
    return text;
}

}  // namespace snug
