// Does a Renault ZOE fit into a slot of 4.5 x 2.0 m, and how?
#include <snug/snug.hpp>

#include <iostream>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 4.5, .width = 2.0});
    const snug::EntryAnswer answer = snug::entry(car, slot);
    if (!answer.parkable) return 1;
    std::cout << *answer.direction_changes << " direction changes, entered with a heading from "
              << answer.ranges.front().min << " to " << answer.ranges.back().max << " rad\n";
    for (const snug::Move& move : answer.maneuver->moves)
        std::cout << to_string(move.direction) << ' ' << move.length << " m\n";
}
