// At what angle to the curb should I begin, and how exactly must I hit it?
//
// Parking backward begins with the car's front corner beside the front neighbour's, the car turned by the entry heading.
#include <snug/snug.hpp>

#include <cstdio>
#include <numbers>

int main() {
    constexpr double degree = std::numbers::pi / 180.0;  // angles are in radians
    const snug::Car car = *snug::find_car("opel-corsa");
    const snug::Slot slot({.length = car.length() + 0.5, .width = car.width() + 0.2});

    // All headings from which the car parks with at most 7 direction changes.
    const snug::Answer answer = snug::entry(car, slot, {.max_changes = 7});
    for (const snug::HeadingRange& range : answer.ranges)
        std::printf("%.2f to %.2f degrees: %d direction changes\n", range.min / degree, range.max / degree,
                    range.direction_changes);

    // A driver who may be off by half a degree wants a whole degree in which all goes well.
    const snug::Answer roomy = snug::entry(car, slot, {.min_range = 1.0 * degree});
    std::printf("with half a degree to spare: %d direction changes\n", *roomy.direction_changes);
}

// Prints:
// 25.31 to 25.63 degrees: 5 direction changes
// 25.63 to 27.00 degrees: 6 direction changes
// 27.00 to 27.14 degrees: 7 direction changes
// with half a degree to spare: 6 direction changes
