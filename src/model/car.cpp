// Which cars can exist, how tightly they turn, and the five cars of the paper.
#include "snug/car.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/limits.hpp"

namespace snug {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

using limits::longest;
using limits::shortest;
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

CarDimensions checked(const CarDimensions& dimensions) {
    check_between("car width", dimensions.width, shortest, longest, " m");
    check_between("car front", dimensions.front, shortest, longest, " m");
    check_between("car rear", dimensions.rear, shortest, longest, " m");
    check_between("car wheelbase", dimensions.wheelbase, shortest, longest, " m");
    check_steer(dimensions.max_steer);
    return dimensions;
}

/// How far the outline reaches to either side, level with x.
struct Sides {
    double left = -longest;
    double right = -longest;
};
Sides sides_at(const Outline& outline, double x) {
    Sides sides;
    const std::vector<Point>& corners = outline.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        if (x < std::min(from.x, to.x) || x > std::max(from.x, to.x)) continue;
        const double part = to.x == from.x ? 0.0 : (x - from.x) / (to.x - from.x);
        const double y = from.y + part * (to.y - from.y);
        sides.left = std::max({sides.left, y, to.x == x ? to.y : y});
        sides.right = std::max({sides.right, -y, to.x == x ? -to.y : -y});
    }
    return sides;
}

}  // namespace

Outline Car::wheels_of(const Outline& body, double wheelbase) {
    const Sides behind = sides_at(body, 0.0);
    if (!(behind.left > 0.0 && behind.right > 0.0))
        throw Error("the rear axle's middle, (0, 0), lies outside the outline, but must lie inside");
    const Sides ahead = wheelbase < body.front() ? sides_at(body, wheelbase) : Sides{body.left(), body.right()};
    return Outline({{wheelbase, ahead.left}, {0.0, behind.left}, {0.0, -behind.right}, {wheelbase, -ahead.right}},
                   Outline::Checked{});
}

Car::Car(const CarDimensions& dimensions, std::string name)
    : dimensions_(checked(dimensions)),
      outline_(Outline::rectangle(dimensions.front, dimensions.rear, dimensions.width / 2.0)),
      wheels_(wheels_of(outline_, dimensions.wheelbase)),
      name_(std::move(name)) {}

Car::Car(Outline outline, double wheelbase, double max_steer, std::string name)
    : dimensions_(checked({outline.left() + outline.right(), outline.front(), outline.rear(), wheelbase, max_steer})),
      outline_(std::move(outline)),
      wheels_(wheels_of(outline_, wheelbase)),
      name_(std::move(name)) {}

Car Car::mirrored() const {
    Car other = *this;
    other.outline_ = outline_.mirrored();
    other.wheels_ = wheels_.mirrored();
    return other;
}

Car Car::turned_about() const {
    Car other = *this;
    other.outline_ = outline_.turned_about();
    other.wheels_ = wheels_.turned_about();
    std::swap(other.dimensions_.front, other.dimensions_.rear);
    return other;
}

double Car::turning_radius() const { return dimensions_.wheelbase / angles::tan(dimensions_.max_steer); }

double Car::curb_to_curb() const {
    return 2.0 * angles::hypot(turning_radius() + dimensions_.width / 2.0, dimensions_.wheelbase);
}

double Car::wall_to_wall() const {
    double radius = 0.0;  // of the point that is farthest from the circle's centre, at (0, r) or (0, -r)
    for (const Point& corner : outline_.corners())
        radius = std::max(radius, angles::hypot(turning_radius() + std::abs(corner.y), corner.x));
    return 2.0 * radius;
}

bool Car::is_rectangle() const {
    return outline_ == Outline::rectangle(dimensions_.front, dimensions_.rear, dimensions_.width / 2.0);
}

std::vector<Point> placed(const Outline& outline, const Pose& pose) {
    const auto [s, c] = angles::sine_cosine(pose.heading);
    std::vector<Point> corners;
    corners.reserve(outline.corners().size());
    for (const Point& corner : outline.corners())
        corners.push_back({pose.x + corner.x * c - corner.y * s, pose.y + corner.x * s + corner.y * c});
    return corners;
}

std::vector<Point> frame(const Car& car, const Pose& pose) { return placed(car.outline(), pose); }

double steer_for_turning_radius(double wheelbase, double radius) { return angles::atan2(wheelbase, radius); }

double steer_for_curb_to_curb(double wheelbase, double width, double diameter) {
    // The outer front wheel runs on a circle of half the diameter, one wheelbase ahead of the rear axle's line.
    const double outer = diameter / 2.0;
    const double radius = std::sqrt((outer - wheelbase) * (outer + wheelbase)) - width / 2.0;
    return diameter > 0.0 && radius > 0.0 ? steer_for_turning_radius(wheelbase, radius)
                                          : std::numeric_limits<double>::quiet_NaN();
}

double steer_for_wall_to_wall(const Outline& outline, double wheelbase, double diameter) {
    // Every corner stays within the circle, and one is on it: the least of the radii that each alone would allow.
    const double outer = diameter / 2.0;
    double radius = std::numeric_limits<double>::infinity();
    for (const Point& corner : outline.corners())
        radius = std::min(radius, std::sqrt((outer - corner.x) * (outer + corner.x)) - std::abs(corner.y));
    const bool reached = std::all_of(outline.corners().begin(), outline.corners().end(),
                                     [&](const Point& corner) { return std::abs(corner.x) <= outer; });
    return reached && radius > 0.0 ? steer_for_turning_radius(wheelbase, radius)
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
    for (SheetCar& known : sheet_cars()) {
        if (known.car.name() == name) {
            return std::move(known.car);
        }
    }
    return std::nullopt;
}

std::optional<std::string> nearest_car_name(std::string_view typed) {
    std::vector<std::string> names;
    for (const Car& car : catalogue()) {
        names.push_back(car.name());
    }
    for (const SheetCar& known : sheet_cars()) {
        names.push_back(known.car.name());
    }
    return nearest_word(typed, names);
}

}  // namespace snug
