// My own car: a data sheet and a tape measure say all that is needed.
#include <snug/snug.hpp>

#include <cstdio>

int main() {
    // In metres; front and rear are measured from the rear axle.
    snug::CarDimensions measured = {.width = 1.80, .front = 3.60, .rear = 0.80, .wheelbase = 2.60};
    // A data sheet has no steering angle, but how wide a street the car turns in, from curb to curb.
    measured.max_steer = snug::steer_for_curb_to_curb(measured.wheelbase, measured.width, 10.9);
    const snug::Car car(measured, "my car");

    // The slot is on the left of the road, 90 cm longer than the car and 20 cm wider.
    const snug::Slot slot({.length = car.length() + 0.9, .width = car.width() + 0.2, .side = snug::Side::left});

    const snug::Answer answer = snug::entry(car, slot);
    if (answer.parkable())
        std::printf("%s parks with %d direction changes\n", car.name().c_str(), *answer.direction_changes);
    else
        std::printf("%s does not park there\n", car.name().c_str());

    // A car that cannot exist is refused, and told why.
    try {
        measured.wheelbase = -2.6;
        const snug::Car impossible(measured);
    } catch (const snug::Error& error) {
        std::puts(error.what());
    }
}

// Prints:
// my car parks with 3 direction changes
// car wheelbase is -2.6 m, but must lie between 1e-06 and 1000000 m
