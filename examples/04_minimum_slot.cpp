// How short may the slot be? That depends on how often the driver is willing to change direction.
#include <snug/snug.hpp>

#include <cstdio>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const double width = 2.0;  // from the road to the curb

    std::puts("direction changes   shortest slot");
    for (const int changes : {0, 1, 2, 5, 10}) {
        const auto length = snug::min_slot(car, width, {.max_changes = changes}).length;
        if (length) std::printf("%17d   %.3f m\n", changes, *length);
    }

    // Whoever wants to stay 10 cm away from everything needs more.
    const auto length = snug::min_slot(car, width, {.max_changes = 10, .driving = {.clearance = 0.1}}).length;
    if (length) std::printf("%17d   %.3f m, never nearer than 0.1 m to anything\n", 10, *length);
}

// Prints:
// direction changes   shortest slot
//                 0   5.686 m
//                 1   5.152 m
//                 2   4.911 m
//                 5   4.666 m
//                10   4.552 m
//                10   5.155 m, never nearer than 0.1 m to anything
