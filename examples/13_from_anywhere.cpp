// A car that does not stand where it should: the map of a street knows what to do from anywhere, without planning anew.
#include <snug/snug.hpp>

#include <iostream>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    snug::Street street;
    street.length = 5.2;
    street.width = 2.0;
    street.road = 3.5;

    const snug::ParkMap map(car, street);                                // once
    const snug::MapBounds bounds = map.at({2.0, 1.75, 0.0});             // lower_bound, direction_changes, first
    std::optional<snug::Maneuver> way = map.maneuver({2.0, 1.75, 0.0});  // again and again, from wherever the car is

    std::cout << *bounds.direction_changes << (bounds.proved() ? " change, proved\n" : " changes\n");

    // The car drives the first piece, slides 5 cm to the side and turns by a degree: how does it go on?
    snug::Pose pose = way->moves.front().end;
    pose.y += 0.05;
    pose.heading += 0.017;
    way = map.maneuver(pose);
    std::cout << "from there " << way->direction_changes() << "\n";
}

// Prints:
// 1 change, proved
// from there 2
