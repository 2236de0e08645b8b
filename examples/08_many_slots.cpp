// How long should the slots of a street be? Every car, every width, on all cores.
#include <snug/snug.hpp>
#include <snug/sweep.hpp>

#include <cstdio>
#include <vector>

int main() {
    const std::vector<double> widths = {1.9, 2.0, 2.1, 2.2, 2.3};  // of the slots

    std::printf("%-16s", "slots of [m]");
    for (const double width : widths) std::printf("%7.1f", width);
    std::puts("");

    for (const snug::Car& car : snug::catalogue()) {
        std::printf("%-16s", car.name().c_str());
        // The shortest slot of every width in which the car parks with at most 5 direction changes,
        // if there is one.
        for (const snug::MinSlot& slot : snug::min_slots(car, widths, {5})) {
            if (slot.length)
                std::printf("%7.2f", *slot.length);
            else
                std::printf("%7s", "-");
        }
        std::puts("");
    }
}

// Prints:
// slots of [m]        1.9    2.0    2.1    2.2    2.3
// mid-size              -   5.49   5.17   5.16   5.16
// renault-zoe        4.90   4.67   4.67   4.67   4.67
// opel-corsa         4.12   4.12   4.12   4.12   4.12
// vw-transporter        -      -      -   6.63   6.25
// mercedes-amg-gt       -      -   5.71   5.43   5.19
