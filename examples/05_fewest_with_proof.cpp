// Could a better driver do it with fewer direction changes?
//
// The other examples steer as far as the wheels go, as the paper does. Here all ways to drive are considered, and the
// answer comes with a proof that none has fewer changes.
#include <snug/snug.hpp>

#include <cstdio>

int main() {
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 4.8, .width = 1.84});  // 7 cm wider than the car

    if (!snug::entry(car, slot).parkable()) std::puts("always steering as far as it goes: impossible");

    const snug::Answer answer = snug::fewest(car, slot);
    if (answer.direction_changes) std::printf("steering at will: %d direction changes\n", *answer.direction_changes);
    std::printf("nobody can do it with fewer than %d\n", answer.lower_bound);
}

// Prints:
// always steering as far as it goes: impossible
// steering at will: 8 direction changes
// nobody can do it with fewer than 8
