// Seeded random cars, outlines and slots, the same everywhere: what the solver is judged on. Nothing is tuned to answers.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "snug/snug.hpp"
#include "strategy.hpp"

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

/// A question: a car, a slot, and how to drive.
struct Case {
    std::string kind;      // how the slot was chosen
    std::string car_name;  // of the paper's table 1; empty for a made-up car
    snug::CarDimensions car;
    std::vector<snug::Point> outline;  // empty: the rectangle of these dimensions; else they are how far it reaches
    snug::SlotDimensions slot;
    snug::Driving driving;
    snug::Parked parked;
    int more_changes = 0;  // Problem 2 is asked with this many changes more than the fewest

    double car_length() const { return car.front + car.rear; }
    snug::Car made_car() const {
        if (outline.empty()) return snug::Car(car, car_name);
        return snug::Car(snug::Outline(outline), car.wheelbase, car.max_steer, car_name);
    }
    snug::Slot made_slot() const { return snug::Slot(slot); }
    /// All lengths, in place.
    std::vector<double*> lengths() {
        std::vector<double*> all = {&car.width,         &car.front,  &car.rear,           &car.wheelbase,
                                    &slot.length,       &slot.width, &slot.front_setback, &slot.rear_setback,
                                    &driving.clearance, &parked.curb};
        if (driving.curb_clearance) all.push_back(&*driving.curb_clearance);
        for (snug::Point& p : outline) all.push_back(&p.x), all.push_back(&p.y);
        return all;
    }
};

/// Counter-clockwise, as the case has it.
template <class Real>
Polygon<Real> polygon_of(const Case& asked) {
    if (asked.outline.empty()) return rectangle(Real(asked.car.front), Real(asked.car.rear), Real(asked.car.width) / 2);
    std::vector<Vec<Real>> corners;
    for (const snug::Point& p : asked.outline) corners.push_back({Real(p.x), Real(p.y)});
    Real area = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]);
    if (area < 0) std::reverse(corners.begin(), corners.end());
    return Polygon<Real>(corners);
}

/// Where the wheels stand: level with the axles and as far out as the body is there; as far as the whole body where the
/// front axle lies ahead of it.
template <class Real>
Polygon<Real> wheels_of(const Case& asked) {
    const Polygon<Real> body = polygon_of<Real>(asked);
    const Real ahead = asked.car.wheelbase;
    Real left = body.corners[0].y, right = left, front = body.corners[0].x;
    for (const Vec<Real>& p : body.corners)
        left = std::max(left, p.y), right = std::min(right, p.y), front = std::max(front, p.x);
    const auto [rear_right, rear_left] = across(body, Real(0));
    auto [front_right, front_left] = across(body, ahead);
    if (ahead > front) front_right = right, front_left = left;
    return Polygon<Real>({{ahead, front_left}, {0, rear_left}, {0, rear_right}, {ahead, front_right}});
}

/// The case in the slot frame.
template <class Real>
Problem<Real> make_problem(const Case& asked) {
    const bool left = asked.slot.side == snug::Side::left, low = asked.slot.curb == snug::Curb::low;
    const auto seen = [&](const Polygon<Real>& polygon) { return left ? polygon.mirrored() : polygon; };
    Problem<Real> problem;
    problem.car = seen(polygon_of<Real>(asked));
    problem.body = problem.car.grown(Real(asked.driving.clearance));
    problem.at_curb = (low ? seen(wheels_of<Real>(asked)) : problem.car).grown(Real(asked.driving.at_curb()));
    problem.length = asked.slot.length;
    problem.width = asked.slot.width;
    problem.front_setback = asked.slot.front_setback;
    problem.rear_setback = asked.slot.rear_setback;
    problem.radius = Real(asked.car.wheelbase) / std::tan(Real(asked.car.max_steer));
    problem.enter = asked.driving.enter;
    problem.parked_heading = asked.parked.heading;
    problem.parked_curb = asked.parked.curb;
    return problem;
}

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

/// Does any heading park? Sampled coarsely, then three times finer around the two that come closest.
inline bool some_heading_parks(const Problem<double>& problem, int max_changes) {
    struct Sample {
        double heading, height;
    };
    Run<double> result;
    std::vector<Sample> best;
    bool parks = false;
    const auto look = [&](double heading) {
        if (parks || heading < 0 || heading > std::numbers::pi / 2) return;
        run(problem, heading, max_changes, result, Look::at_depths_too);
        parks = result.parked();
        best.push_back({heading, result.least()});
    };
    double step = 0.01;
    for (double heading = 0; heading < 1.2; heading += step) look(heading);
    for (int level = 0; level < 3; ++level) {
        std::sort(best.begin(), best.end(), [](const Sample& a, const Sample& b) { return a.height < b.height; });
        if (best.size() > 2) best.erase(best.begin() + 2, best.end());
        step /= 8;
        for (const Sample s : std::vector<Sample>(best))
            for (int i = -8; i <= 8; ++i) look(s.heading + i * step);
    }
    return parks;
}

/// Moves the length to where a smaller number of changes has only just become enough.
inline void make_thin(Random& random, Case& chosen) {
    const int changes = random.below(13);
    const auto parks = [&](double length) {
        Case sized = chosen;
        sized.slot.length = length;
        return some_heading_parks(make_problem<double>(sized), changes);
    };
    double fails = chosen.car_length() + 2 * chosen.driving.clearance, works = fails + 3.0;
    if (!parks(works)) return;
    for (int i = 0; i < 24; ++i) {
        const double middle = (fails + works) / 2;
        (parks(middle) ? works : fails) = middle;
    }
    chosen.slot.length = works + std::pow(10.0, random.between(-7.5, -3.0)) * (random.chance(0.85) ? 1 : -1);
}

/// Length and width, for a car and what it keeps clear.
inline void choose_slot(Random& random, Case& chosen) {
    const double needed_length = chosen.car_length() + 2 * chosen.driving.clearance;
    const double needed_width = chosen.car.width + chosen.driving.at_curb();
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
}

/// Where in the world, on which side, and how many changes more Problem 2 allows.
inline void choose_surroundings(Random& random, Case& chosen) {
    if (chosen.kind == "thin") make_thin(random, chosen);
    if (random.chance(0.5)) {
        chosen.slot.side = random.chance(0.5) ? snug::Side::left : snug::Side::right;
        chosen.slot.corner = {random.between(-50, 50), random.between(-50, 50)};
        chosen.slot.heading = random.between(-std::numbers::pi, std::numbers::pi);
    }
    chosen.more_changes = random.below(9);
}

inline Random random_of(std::uint64_t seed, std::uint64_t index) {
    return Random(seed * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL + 1);
}

/// Case number `index` of a seed: a rectangle, and a slot as in the paper.
inline Case random_case(std::uint64_t seed, std::uint64_t index) {
    Random random = random_of(seed, index);
    Case chosen;
    choose_car(random, chosen);
    if (random.chance(0.15)) chosen.driving.enter = snug::Enter::forward;
    if (random.chance(0.15)) chosen.driving.clearance = random.between(0.005, 0.1);
    choose_slot(random, chosen);
    choose_surroundings(random, chosen);
    return chosen;
}

/// A line for bash that asks the same question.
inline std::string command_line(const Case& asked) {
    std::ostringstream line;
    line.precision(17);
    line << "snug entry --car ";
    if (!asked.car_name.empty() && asked.outline.empty()) {
        line << asked.car_name;
    } else {
        line << "<(echo '{";
        if (asked.outline.empty()) {
            line << "\"width\": " << asked.car.width << ", \"front\": " << asked.car.front
                 << ", \"rear\": " << asked.car.rear;
        } else {
            line << "\"outline\": [";
            for (const snug::Point& p : asked.outline)
                line << (&p == asked.outline.data() ? "[" : ", [") << p.x << ", " << p.y << ']';
            line << ']';
        }
        line << ", \"wheelbase\": " << asked.car.wheelbase << ", \"max_steer\": " << asked.car.max_steer << "}')";
    }
    const auto option = [&](const char* name, double value, double usual) {
        if (value != usual) line << name << value;
    };
    constexpr double any = std::numeric_limits<double>::infinity(), degree = std::numbers::pi / 180;
    line << " --length " << asked.slot.length << " --width " << asked.slot.width;
    option(" --front-setback ", asked.slot.front_setback, 0);
    option(" --rear-setback ", asked.slot.rear_setback, 0);
    if (asked.slot.curb == snug::Curb::low) line << " --curb low";
    if (asked.slot.side == snug::Side::left) line << " --side left";
    if (asked.slot.corner.x != 0 || asked.slot.corner.y != 0)
        line << " --corner=" << asked.slot.corner.x << ',' << asked.slot.corner.y;
    option(" --heading=", asked.slot.heading, 0);
    option(" --clearance ", asked.driving.clearance, 0);
    if (asked.driving.curb_clearance) line << " --curb-clearance " << *asked.driving.curb_clearance;
    if (asked.driving.enter == snug::Enter::forward) line << " --enter forward";
    option(" --parked-heading ", asked.parked.heading / degree, any);
    option(" --parked-curb ", asked.parked.curb, any);
    return line.str();
}

}  // namespace oracle
