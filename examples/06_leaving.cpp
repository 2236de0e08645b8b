// I am parked in. How do I get out?
#include <snug/snug.hpp>

#include <cstdio>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 5.2, .width = 2.0});
    // Where the car stands: 30 cm behind the car in front, 10 cm from the curb.
    const snug::Pose parked = snug::parked_pose(car, slot, {.front = 0.3, .curb = 0.1});

    const snug::Answer out = snug::leave(car, slot, parked);
    if (!out.maneuver) return 1;
    std::printf("%d direction changes%s:\n", *out.direction_changes, out.proved ? ", and no way has fewer" : "");
    for (const snug::Move& move : out.maneuver->moves) {
        const char* way = move.direction == snug::Direction::forward ? "forward" : "backward";
        const char* steering = move.steering_angle > 0 ? "left" : move.steering_angle < 0 ? "right" : "straight";
        std::printf("%s, steering %s, %.2f m\n", way, steering, move.length);
    }
}

// Prints:
// 3 direction changes, and no way has fewer:
// backward, steering left, 0.33 m
// backward, steering right, 0.41 m
// forward, steering left, 0.62 m
// forward, steering right, 0.32 m
// backward, steering left, 0.27 m
// backward, steering right, 0.55 m
// forward, steering left, 0.93 m
