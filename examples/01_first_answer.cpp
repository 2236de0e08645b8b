// Does a Renault ZOE fit into a slot of 5.2 x 1.9 m, and how?
#include <snug/snug.hpp>

#include <iomanip>
#include <iostream>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 5.2, .width = 1.9});
    const snug::Answer answer = snug::entry(car, slot);
    if (!answer.parkable()) return 1;
    std::cout << std::fixed << std::setprecision(3);
    std::cout << *answer.direction_changes << " direction changes, entered with a heading from "
              << answer.ranges.front().min << " to " << answer.ranges.back().max << " rad\n";
    for (const snug::Move& move : answer.maneuver->moves)
        std::cout << to_string(move.direction) << ' ' << move.length << " m\n";
}

// Prints:
// 3 direction changes, entered with a heading from 0.448 to 0.456 rad
// backward 0.346 m
// forward 0.266 m
// backward 0.979 m
// forward 0.211 m
