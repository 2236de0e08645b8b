// Random cars and places: bays at streets of all angles, with and without a far side, and scattered boxes.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "snug/park.hpp"

namespace park_test {

using snug::Car;
using snug::Enter;
using snug::Place;
using snug::Point;
using snug::Pose;
using snug::Street;

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 1) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    bool chance(double part) { return between(0.0, 1.0) < part; }
    int whole(int low, int high) { return low + static_cast<int>(between(0.0, high - low + 1 - 1e-9)); }

private:
    std::mt19937_64 engine_;
};

struct Case {
    Car car;
    Place place;
    Pose start;
    std::string described;
};

inline Car random_car(Random& random) {
    const double wheelbase = random.between(2.2, 3.6);
    return Car({.width = random.between(1.5, 2.1),
                .front = wheelbase + random.between(0.5, 1.1),
                .rear = random.between(0.5, 1.2),
                .wheelbase = wheelbase,
                .max_steer = random.between(0.45, 0.75)},
               "random");
}

inline Street random_street(Random& random, const Car& car) {
    Street street;
    street.length = car.length() * random.between(1.05, 1.35);
    street.width = car.width() * random.between(1.04, 1.4);
    const int kind = random.whole(0, 3);
    street.angle = kind <= 1 ? 0.0 : kind == 2 ? 1.5707963267948966 : random.between(0.5, 1.2);
    if (kind >= 2) street.length = car.length() * random.between(1.0, 1.2);
    if (!random.chance(0.25)) street.road = random.between(car.width() + 0.4, kind <= 1 ? 5.0 : 8.0);
    street.enter = random.chance(0.5) ? Enter::backward : Enter::forward;
    street.side = random.chance(0.3) ? snug::Side::left : snug::Side::right;
    street.stretch = random.between(4.0, 9.0);
    street.corner = {random.between(-5.0, 5.0), random.between(-5.0, 5.0)};
    street.heading = random.between(-3.0, 3.0);
    if (random.chance(0.3)) street.curb = snug::Curb::low;
    return street;
}

inline std::string described(const Car& car, const Street& street, const Pose& start) {
    std::ostringstream text;
    text.precision(17);
    text << "car " << car.width() << " " << car.front() << " " << car.rear() << " " << car.wheelbase() << " "
         << car.max_steer() << " street " << street.length << " " << street.width << " angle " << street.angle
         << " road " << street.road.value_or(-1.0) << " stretch " << street.stretch << " forward "
         << (street.enter == Enter::forward) << " left " << (street.side == snug::Side::left) << " corner "
         << street.corner.x << " " << street.corner.y << " heading " << street.heading << " low "
         << (street.curb == snug::Curb::low) << " start " << start.x << " " << start.y << " " << start.heading;
    return text.str();
}

/// A bay at a street, with some boxes scattered over it now and then; the start is the usual one, shifted and turned.
inline Case random_case(std::uint64_t index) {
    Random random(index);
    const Car car = random_car(random);
    const Street street = random_street(random, car);
    const Place bay = street_place(street);
    Pose start = standard_start(street, car);
    start.x += random.between(-1.5, 1.5);
    start.y += random.between(-0.3, 0.3);
    start.heading += random.between(-0.3, 0.3);
    std::string text = described(car, street, start);
    if (!random.chance(0.25)) return {car, bay, start, text};
    snug::PlaceDescription scene{bay.obstacles(), bay.parked(), bay.region()};
    std::ostringstream boxes;
    boxes.precision(17);
    for (int i = random.whole(1, 3); i > 0; --i) {
        const snug::Slot frame(
            {.length = 1.0, .width = 1.0, .side = street.side, .corner = street.corner, .heading = street.heading});
        const double x = random.between(-street.stretch, street.stretch), y = random.between(1.0, 6.0);
        const double turned = random.between(0.0, 3.0), size = random.between(0.1, 0.5);
        std::vector<Point> corners;
        const int count = random.whole(3, 6);
        for (int k = 0; k < count; ++k) {
            const double angle = turned + 6.283185307179586 * k / count;
            corners.push_back(frame.to_world(Point{x + size * std::cos(angle), y + size * std::sin(angle)}));
            boxes << " " << corners.back().x << "," << corners.back().y;
        }
        boxes << ";";
        scene.obstacles.push_back({corners, random.chance(0.2), "box", {}});
    }
    return {car, Place(scene), start, text + " boxes" + boxes.str()};
}

}  // namespace park_test
