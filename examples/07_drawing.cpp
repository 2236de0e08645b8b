// A picture says it better.
#include <snug/draw.hpp>
#include <snug/snug.hpp>

#include <cstdio>
#include <fstream>

int main() {
    const snug::Car car = *snug::find_car("mid-size");
    const snug::Slot slot({.length = 5.3, .width = 2.2});
    const snug::Answer answer = snug::entry(car, slot);

    // How to park. A picture is the bytes of a file: SVG or PDF to print and zoom, PNG to look at.
    std::ofstream("maneuver.svg", std::ios::binary) << snug::draw_maneuver(car, slot, answer, snug::PictureFormat::svg);

    // Where to begin: all entry positions, and where each of them ends.
    std::ofstream("entries.png", std::ios::binary) << snug::draw_entries(car, slot, answer, snug::PictureFormat::png);

    std::printf("parking with %d direction changes is drawn in maneuver.svg,\n", *answer.direction_changes);
    std::puts("where to begin in entries.png");
}

// Prints:
// parking with 3 direction changes is drawn in maneuver.svg,
// where to begin in entries.png
