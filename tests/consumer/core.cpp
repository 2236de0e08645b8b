// A program that links the core alone. Prints the version it was built with.
#include <snug/snug.hpp>

#include <iostream>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Answer answer = snug::entry(car, snug::Slot({.length = 4.5, .width = 2.0}));
    const std::vector<int> counts = snug::direction_changes(car, snug::Slot({.length = 4.5, .width = 2.0}), {0.486});
    std::cout << SNUG_VERSION << ": " << *answer.direction_changes << " direction changes, " << counts.front()
              << " in vectors\n";
}
