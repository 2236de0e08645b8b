// Which cars can exist, how tightly they turn, and the five cars of the paper.
#include "snug/car.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "model/angles.hpp"
#include "model/check.hpp"
#include "model/spelling.hpp"

namespace snug {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

constexpr double shortest = 1e-6;  // [m]
constexpr double longest = 1e6;    // [m]
constexpr double least_steer_deg = 0.1;
constexpr double most_steer_deg = 89.9;

void check_steer(double max_steer) {
    if (max_steer >= least_steer_deg * degree && max_steer <= most_steer_deg * degree) {
        return;
    }
    throw Error("car max_steer is " + spelled(max_steer) + " rad (" + spelled(max_steer / degree) +
                " degrees), but must lie between " + spelled(least_steer_deg) + " and " + spelled(most_steer_deg) +
                " degrees");
}

}  // namespace

Car::Car(const CarDimensions& dimensions, std::string name) : dimensions_(dimensions), name_(std::move(name)) {
    check_between("car width", dimensions.width, shortest, longest, " m");
    check_between("car front", dimensions.front, shortest, longest, " m");
    check_between("car rear", dimensions.rear, shortest, longest, " m");
    check_between("car wheelbase", dimensions.wheelbase, shortest, longest, " m");
    check_steer(dimensions.max_steer);
}

double Car::turning_radius() const { return dimensions_.wheelbase / angles::tan(dimensions_.max_steer); }

double Car::curb_to_curb() const {
    return 2.0 * angles::hypot(turning_radius() + dimensions_.width / 2.0, dimensions_.wheelbase);
}

std::array<Point, 4> frame(const Car& car, const Pose& pose) {
    const angles::SineCosine heading = angles::sine_cosine(pose.heading);
    const double c = heading.cosine;
    const double s = heading.sine;
    const double half = car.width() / 2.0;
    const auto corner = [&](double ahead, double left) {
        return Point{pose.x + ahead * c - left * s, pose.y + ahead * s + left * c};
    };
    return {corner(car.front(), half), corner(-car.rear(), half), corner(-car.rear(), -half),
            corner(car.front(), -half)};
}

double steer_for_turning_radius(double wheelbase, double radius) { return angles::atan2(wheelbase, radius); }

double steer_for_curb_to_curb(double wheelbase, double width, double diameter) {
    // The outer front wheel runs on a circle of half the diameter, one wheelbase ahead of the rear axle's line.
    const double outer = diameter / 2.0;
    const double radius = std::sqrt((outer - wheelbase) * (outer + wheelbase)) - width / 2.0;
    return diameter > 0.0 && radius > 0.0 ? steer_for_turning_radius(wheelbase, radius)
                                          : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Car> catalogue() {
    return {
        Car({1.800, 3.700, 1.000, 2.700, 45 * degree}, "mid-size"),
        Car({1.771, 3.427, 0.657, 2.588, 33 * degree}, "renault-zoe"),
        Car({1.532, 3.212, 0.410, 2.343, 32 * degree}, "opel-corsa"),
        Car({1.994, 4.308, 1.192, 3.400, 36 * degree}, "vw-transporter"),
        Car({1.939, 3.528, 1.016, 2.630, 32 * degree}, "mercedes-amg-gt"),
    };
}

std::optional<Car> find_car(std::string_view name) {
    for (Car& car : catalogue()) {
        if (car.name() == name) {
            return std::move(car);
        }
    }
    return std::nullopt;
}

std::optional<std::string> nearest_car_name(std::string_view typed) {
    std::vector<std::string> names;
    for (const Car& car : catalogue()) {
        names.push_back(car.name());
    }
    return nearest_word(typed, names);
}

}  // namespace snug
