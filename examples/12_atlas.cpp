// Answers computed beforehand: an atlas is written once and looked up in ever after, without allocating anything.
#include <snug/atlas_build.hpp>
#include <snug/snug.hpp>

#include <iomanip>
#include <iostream>
#include <span>
#include <string>

int main() {
    // A small one in memory. `snug atlas build` and `snug atlas export` make large ones, which snug::Atlas maps by their path.
    const snug::AtlasPlan plan = {{*snug::find_car("renault-zoe")}, {1.9, 2.0}, {4.6, 4.8, 5.0}, {}};
    std::string file;
    snug::AtlasWriter writer(plan, SNUG_VERSION, [&](std::string_view bytes) { file += bytes; });
    for (const double width : plan.widths)
        for (const double length : plan.lengths)
            writer.add(*snug::solve(plan.cars.front(), width, length, plan.options));
    writer.finish();

    const snug::Atlas atlas(std::as_bytes(std::span<const char>(file)));
    const std::size_t car = *atlas.find_car("renault-zoe");
    const snug::AtlasAnswer answer = atlas.look_up(car, 4.87, 2.0);
    if (answer.verdict != snug::AtlasVerdict::parks) return 1;
    std::cout << std::fixed << std::setprecision(3);
    std::cout << "as in " << answer.cell.length() << " x " << answer.cell.width()
              << " m: " << *answer.cell.direction_changes() << " direction changes\n";
    const snug::HeadingRange headings = answer.cell.range(0);
    std::cout << "enter with a heading from " << headings.min << " to " << headings.max << " rad\n";
    const snug::AtlasMove first = answer.cell.move(0);
    std::cout << "first " << to_string(first.direction) << ' ' << first.length << " m, steering "
              << first.steering_angle << " rad\n";
}

// Prints:
// as in 4.800 x 2.000 m: 3 direction changes
// enter with a heading from 0.466 to 0.470 rad
// first backward 0.458 m, steering 0.576 rad
