// Trajectories as JSON, as CSV and as an OpenSCENARIO file.
#include <nlohmann/json.hpp>

#include "io/csv.hpp"
#include "snug/io.hpp"

namespace snug {
namespace {

/// In an attribute of XML.
std::string escaped(const std::string& text) {
    std::string result;
    for (const char one : text) {
        switch (one) {
            case '&': result += "&amp;"; break;
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '"': result += "&quot;"; break;
            default: result += static_cast<unsigned char>(one) < ' ' ? ' ' : one;
        }
    }
    return result;
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + write(value) + "\""; }

std::string world_position(const Pose& pose) {
    return "<Position><WorldPosition" + attribute("x", pose.x) + attribute("y", pose.y) + attribute("h", pose.heading) +
           "/></Position>";
}

/// The vehicle: OpenSCENARIO measures from the middle of the rear axle on the ground, as this library does. What the solver does
/// not know (height, wheels) is usual for a car.
std::string vehicle(const Car& car, const MotionLimits& limits) {
    const double front = car.front();
    const double rear = car.rear();
    const double width = car.width();
    const auto axle = [&](const char* name, double max_steering, double x) {
        return std::string("          <") + name + attribute("maxSteering", max_steering) +
               attribute("wheelDiameter", 0.6) + attribute("trackWidth", 0.85 * width) + attribute("positionX", x) +
               attribute("positionZ", 0.3) + "/>\n";
    };
    return "      <Vehicle name=\"" + escaped(car.name()) +
           "\" vehicleCategory=\"car\">\n"
           "        <BoundingBox>\n          <Center" +
           attribute("x", (front - rear) / 2.0) + attribute("y", 0.0) + attribute("z", 0.75) +
           "/>\n          <Dimensions" + attribute("width", width) + attribute("length", front + rear) +
           attribute("height", 1.5) + "/>\n        </BoundingBox>\n        <Performance" +
           attribute("maxSpeed", limits.speed) + attribute("maxAcceleration", limits.acceleration) +
           attribute("maxDeceleration", limits.deceleration) + "/>\n        <Axles>\n" +
           axle("FrontAxle", car.max_steer(), car.wheelbase()) + axle("RearAxle", 0.0, 0.0) +
           "        </Axles>\n        <Properties/>\n      </Vehicle>\n";
}

}  // namespace

Json as_json(const MotionLimits& limits) {
    return {{"speed", limits.speed},
            {"acceleration", limits.acceleration},
            {"deceleration", limits.deceleration},
            {"steering_rate", limits.steering_rate}};
}

Json as_json(const Trajectory& trajectory, double period) {
    Json json = {{"schema", 1},
                 {"car", as_json(trajectory.car)},
                 {"limits", as_json(trajectory.limits)},
                 {"seconds", trajectory.seconds()},
                 {"standing_steers", trajectory.standing_steers},
                 {"trajectory", Json::array()}};
    for (const TrajectoryPoint& point : sampled(trajectory, period))
        json["trajectory"].push_back({{"time", point.time},
                                      {"x", point.pose.x},
                                      {"y", point.pose.y},
                                      {"heading", point.pose.heading},
                                      {"direction", to_string(point.direction)},
                                      {"speed", point.speed},
                                      {"acceleration", point.acceleration},
                                      {"steering_angle", point.steering_angle},
                                      {"steering_rate", point.steering_rate},
                                      {"curvature", point.curvature},
                                      {"distance", point.distance}});
    return json;
}

std::string as_csv(const Trajectory& trajectory, double period) {
    Csv csv({"time", "x", "y", "heading", "direction", "speed", "acceleration", "steering_angle", "steering_rate",
             "curvature", "distance"});
    for (const TrajectoryPoint& point : sampled(trajectory, period))
        csv.row(point.time, point.pose.x, point.pose.y, point.pose.heading, static_cast<int>(point.direction),
                point.speed, point.acceleration, point.steering_angle, point.steering_rate, point.curvature,
                point.distance);
    return csv.text();
}

std::string as_openscenario(const Trajectory& trajectory, double period) {
    const std::vector<TrajectoryPoint> points = sampled(trajectory, period);
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSCENARIO>\n"
        "  <FileHeader revMajor=\"1\" revMinor=\"0\" date=\"2000-01-01T00:00:00\" description=\"Parking maneuver\" "
        "author=\"snug\"/>\n"
        "  <CatalogLocations/>\n  <RoadNetwork/>\n  <Entities>\n    <ScenarioObject name=\"ego\">\n" +
        vehicle(trajectory.car, trajectory.limits) +
        "    </ScenarioObject>\n  </Entities>\n  <Storyboard>\n    <Init>\n      <Actions>\n";
    if (!points.empty())
        text += "        <Private entityRef=\"ego\"><PrivateAction><TeleportAction>" +
                world_position(points.front().pose) + "</TeleportAction></PrivateAction></Private>\n";
    text += "      </Actions>\n    </Init>\n";
    if (points.size() > 1) {
        const auto at_time = [](const char* name, double seconds) {
            return std::string("<ConditionGroup><Condition name=\"") + name +
                   "\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition><SimulationTimeCondition" +
                   attribute("value", seconds) +
                   " rule=\"greaterThan\"/></ByValueCondition></Condition></ConditionGroup>";
        };
        text +=
            "    <Story name=\"parking\">\n      <Act name=\"drive\">\n        <ManeuverGroup name=\"ego\" "
            "maximumExecutionCount=\"1\">\n"
            "          <Actors selectTriggeringEntities=\"false\"><EntityRef entityRef=\"ego\"/></Actors>\n"
            "          <Maneuver name=\"park\">\n            <Event name=\"follow\" priority=\"overwrite\">\n"
            "              <Action name=\"follow\">\n                <PrivateAction><RoutingAction>"
            "<FollowTrajectoryAction>\n                  <Trajectory name=\"maneuver\" closed=\"false\">\n"
            "                    <Shape><Polyline>\n";
        for (const TrajectoryPoint& point : points)
            text += "                      <Vertex" + attribute("time", point.time) + ">" + world_position(point.pose) +
                    "</Vertex>\n";
        text +=
            "                    </Polyline></Shape>\n                  </Trajectory>\n"
            "                  <TimeReference><Timing domainAbsoluteRelative=\"relative\" scale=\"1\" offset=\"0\"/>"
            "</TimeReference>\n"
            "                  <TrajectoryFollowingMode followingMode=\"position\"/>\n"
            "                </FollowTrajectoryAction></RoutingAction></PrivateAction>\n              </Action>\n"
            "              <StartTrigger>" +
            at_time("start", 0.0) +
            "</StartTrigger>\n            </Event>\n          </Maneuver>\n        </ManeuverGroup>\n"
            "        <StartTrigger>" +
            at_time("begin", 0.0) + "</StartTrigger>\n      </Act>\n    </Story>\n";
    } else {
        text +=
            "    <Story name=\"parking\"><Act name=\"stand\"><ManeuverGroup name=\"ego\" maximumExecutionCount=\"1\">"
            "<Actors selectTriggeringEntities=\"false\"/></ManeuverGroup><StartTrigger/></Act></Story>\n";
    }
    text += "    <StopTrigger/>\n  </Storyboard>\n</OpenSCENARIO>\n";
    return text;
}

}  // namespace snug
