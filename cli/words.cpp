#include "cli/words.hpp"

#include <cmath>
#include <numbers>

#include "cli/table.hpp"
#include "sentences/check.hpp"
#include "snug/trajectory.hpp"

namespace snug::cli {

std::string changes(int count) {
    return count == 0 ? "no direction change" : std::to_string(count) + " direction change" + (count == 1 ? "" : "s");
}

std::string name(const Car& car) { return car.name().empty() ? "The car" : car.name(); }

std::string words(const Shortfall& lacking, double clearance) {
    std::string text = lacking.length > 0.0 ? fixed(lacking.length, 3) + " m too short" : "";
    text += lacking.length > 0.0 && lacking.width > 0.0 ? " and " : "";
    text += lacking.width > 0.0 ? fixed(lacking.width, 3) + " m too narrow" : "";
    if (text.empty()) return text;
    return text + " for the car" + (clearance > 0.0 ? " with its clearance" : "");
}

std::string steering(const Car& car, double angle) {
    if (angle == 0.0) {
        return "straight";
    }
    const std::string side = angle > 0.0 ? "left" : "right";
    const bool full = std::abs(angle) >= car.max_steer() * (1.0 - 1e-9);
    return full ? "full " + side : side + " " + fixed(std::abs(angle) * 180.0 / std::numbers::pi, 1) + " deg";
}

std::string metres(double length) { return fixed(length, 3) + " m"; }

std::string driven(const Maneuver& maneuver) {
    const MotionLimits usual;
    const Trajectory timed = trajectory(maneuver, usual);
    const int turns = timed.standing_steers;
    return metres(maneuver.length()) + " in all, in " + fixed(timed.seconds(), 0) + " s at up to " +
           spelled(usual.speed) + " m/s" +
           (turns == 0 ? "" : "; stands to steer " + (turns == 1 ? "once" : std::to_string(turns) + " times"));
}

}  // namespace snug::cli
