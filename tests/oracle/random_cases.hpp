// Seeded random cars and slots, the same everywhere: what the solver is judged on. Fixed before the solver existed.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "simulation.hpp"

namespace oracle {

/// mt19937_64 is the same on every machine, the standard distributions are not: so the mapping is spelt out.
class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    double unit() { return double(bits_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int n) { return int((bits_() >> 32) * std::uint64_t(n) >> 32); }
    bool chance(double p) { return unit() < p; }

private:
    std::mt19937_64 bits_;
};

struct Case {
    std::string kind;      // how the slot was chosen
    std::string car_name;  // of the paper's table 1; empty for a made-up car
    snug::CarDimensions car;
    snug::SlotDimensions slot;
    snug::Driving driving;
    int more_changes = 0;  // Problem 2 is asked with this many changes more than the fewest

    double car_length() const { return car.front + car.rear; }
};

/// Table 1 of the paper.
inline std::vector<std::pair<std::string, snug::CarDimensions>> table_of_cars() {
    constexpr double degree = std::numbers::pi / 180;
    return {{"mid-size", {1.8, 3.7, 1.0, 2.7, 45 * degree}},
            {"renault-zoe", {1.771, 3.427, 0.657, 2.588, 33 * degree}},
            {"opel-corsa", {1.532, 3.212, 0.410, 2.343, 32 * degree}},
            {"vw-transporter", {1.994, 4.308, 1.192, 3.400, 36 * degree}},
            {"mercedes-amg-gt", {1.939, 3.528, 1.016, 2.630, 32 * degree}}};
}

inline void choose_car(Random& random, Case& chosen) {
    constexpr double degree = std::numbers::pi / 180;
    const auto table = table_of_cars();
    const auto& [name, dimensions] = table[std::size_t(random.below(int(table.size())))];
    const double kind = random.unit();
    chosen.car = dimensions;
    if (kind < 0.5) {
        chosen.car_name = name;
    } else if (kind < 0.75) {  // something like a catalogue car
        chosen.car.width *= random.between(0.85, 1.15);
        chosen.car.wheelbase *= random.between(0.85, 1.15);
        chosen.car.front = chosen.car.wheelbase + (dimensions.front - dimensions.wheelbase) * random.between(0.5, 1.5);
        chosen.car.rear *= random.between(0.5, 1.5);
        chosen.car.max_steer = random.between(25, 50) * degree;
    } else {  // extremes
        chosen.car.wheelbase = random.between(1.2, 6.0);
        chosen.car.width = random.between(0.9, 2.6);
        chosen.car.front = chosen.car.wheelbase + random.between(0.02, 1.8);
        chosen.car.rear = random.between(0.05, 2.5);
        chosen.car.max_steer = random.between(15, 60) * degree;
        if (random.chance(0.1)) std::swap(chosen.car.front, chosen.car.rear);
    }
}

/// The least height of the highest corner over all headings and the first `max_changes` + 1 moves: not above zero
/// when the car parks. Sampled coarsely, then three times finer around the three best headings.
inline double least_top_over_headings(const Problem<double>& problem, int max_changes) {
    struct Sample {
        double heading, height;
    };
    Run<double> result;
    const auto height = [&](double heading) {
        run(problem, heading, max_changes, result);
        return result.parked() ? std::min(result.least_top, 0.0) : result.least_top;
    };
    std::vector<Sample> best;
    const auto keep = [&](double heading) {
        if (heading < 0 || heading > std::numbers::pi / 2) return;
        best.push_back({heading, height(heading)});
    };
    double step = 0.005;
    for (double heading = 0; heading < 1.2; heading += step) keep(heading);
    for (int level = 0; level < 3; ++level) {
        std::sort(best.begin(), best.end(), [](const Sample& a, const Sample& b) { return a.height < b.height; });
        best.resize(std::min<std::size_t>(best.size(), 3));
        step /= 8;
        for (const Sample s : std::vector<Sample>(best))
            for (int i = -8; i <= 8; ++i) keep(s.heading + i * step);
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Sample& s : best) least = std::min(least, s.height);
    return least;
}

/// Moves the length to where a smaller number of changes has only just become enough.
inline void make_thin(Random& random, Case& chosen) {
    const int changes = random.below(13);
    const auto parks = [&](double length) {
        return least_top_over_headings(make_problem<double>(chosen.car, length, chosen.slot.width,
                                                            chosen.driving.clearance, chosen.driving.enter),
                                       changes) <= 0;
    };
    double fails = chosen.car_length() + 2 * chosen.driving.clearance, works = fails + 3.0;
    if (!parks(works)) return;
    for (int i = 0; i < 26; ++i) {
        const double middle = (fails + works) / 2;
        (parks(middle) ? works : fails) = middle;
    }
    chosen.slot.length = works + std::pow(10.0, random.between(-7.5, -3.0)) * (random.chance(0.85) ? 1 : -1);
}

/// Case number `index` of a seed.
inline Case random_case(std::uint64_t seed, std::uint64_t index) {
    Random random(seed * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL + 1);
    Case chosen;
    choose_car(random, chosen);
    if (random.chance(0.15)) chosen.driving.enter = snug::Enter::forward;
    if (random.chance(0.15)) chosen.driving.clearance = random.between(0.005, 0.1);
    const double needed_length = chosen.car_length() + 2 * chosen.driving.clearance;
    const double needed_width = chosen.car.width + chosen.driving.clearance;
    double extra_length = random.between(0.3, 0.8), extra_width = random.between(0.05, 0.4);
    const double kind = random.unit();
    if (kind < 0.45) {
        chosen.kind = "tight";
    } else if (kind < 0.60) {
        chosen.kind = "roomy";
        extra_length = random.between(0.8, 3.0);
        extra_width = random.between(0.1, 1.0);
    } else if (kind < 0.67) {
        chosen.kind = "hopeless";
        extra_length = random.between(-0.1, 0.3);
        extra_width = random.between(-0.05, 0.15);
    } else if (kind < 0.90) {
        chosen.kind = "thin";
        extra_width = random.between(0.03, 0.7);
    } else {
        chosen.kind = "exotic";
        switch (random.below(6)) {
            case 0: extra_width = random.between(1.0, 10.0); break;
            case 1: extra_length = random.between(3.0, 20.0); break;
            case 2: extra_length = 0.0; break;
            case 3: extra_width = 0.0; break;
            case 4: extra_length = std::pow(10.0, random.between(-9.0, -1.0)); break;
            default: extra_width = std::pow(10.0, random.between(-9.0, -1.0)); break;
        }
        if (random.chance(0.3)) extra_width += random.between(0.0, 4.0);
    }
    chosen.slot.length = needed_length + extra_length;
    chosen.slot.width = needed_width + extra_width;
    if (chosen.kind == "thin") make_thin(random, chosen);
    if (random.chance(0.5)) {
        chosen.slot.side = random.chance(0.5) ? snug::Side::left : snug::Side::right;
        chosen.slot.corner = {random.between(-50, 50), random.between(-50, 50)};
        chosen.slot.heading = random.between(-std::numbers::pi, std::numbers::pi);
    }
    chosen.more_changes = random.below(9);
    return chosen;
}

/// A line for bash that asks the same question.
inline std::string command_line(const Case& asked) {
    std::ostringstream line;
    line.precision(17);
    line << "snug entry --car ";
    if (!asked.car_name.empty()) {
        line << asked.car_name;
    } else {
        line << "<(echo '{\"width\": " << asked.car.width << ", \"front\": " << asked.car.front
             << ", \"rear\": " << asked.car.rear << ", \"wheelbase\": " << asked.car.wheelbase
             << ", \"max_steer\": " << asked.car.max_steer << "}')";
    }
    line << " --length " << asked.slot.length << " --width " << asked.slot.width;
    if (asked.slot.side == snug::Side::left) line << " --side left";
    if (asked.slot.corner.x != 0 || asked.slot.corner.y != 0)
        line << " --corner=" << asked.slot.corner.x << ',' << asked.slot.corner.y;
    if (asked.slot.heading != 0) line << " --heading=" << asked.slot.heading;
    if (asked.driving.clearance != 0) line << " --clearance " << asked.driving.clearance;
    if (asked.driving.enter == snug::Enter::forward) line << " --enter forward";
    return line.str();
}

}  // namespace oracle
