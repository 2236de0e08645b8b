// Car: the dimensions that decide how a car parks, checked, and the cars that are known by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/geometry.hpp"
#include "snug/outline.hpp"

namespace snug {

/// The paper's car dimensions D = (w, d_f, d_r, b, phi_max), section 2.1.
struct CarDimensions {
    double width = 0.0;      ///< w: width without mirrors [m]
    double front = 0.0;      ///< d_f: from the rear axle centre to the front [m]
    double rear = 0.0;       ///< d_r: from the rear axle centre to the back [m]
    double wheelbase = 0.0;  ///< b: between the axles [m]
    double max_steer = 0.0;  ///< phi_max: largest steering angle [rad], between 0.1 and 89.9 degrees

    friend bool operator==(const CarDimensions&, const CarDimensions&) = default;
};

/// A car that can exist. Lengths lie between 1e-6 and 1e6 m; the front may be shorter than the wheelbase, because a car
/// entering nose first is solved as the car with front and rear swapped.
class Car {
public:
    /// A rectangle, as in the paper. Throws Error when a dimension is impossible.
    explicit Car(const CarDimensions& dimensions, std::string name = {});
    /// A car with this outline; its dimensions are how far it reaches. Throws Error when the rear axle's middle is not inside,
    /// or a dimension is impossible.
    Car(Outline outline, double wheelbase, double max_steer, std::string name = {});

    [[nodiscard]] double width() const { return dimensions_.width; }
    [[nodiscard]] double front() const { return dimensions_.front; }
    [[nodiscard]] double rear() const { return dimensions_.rear; }
    [[nodiscard]] double wheelbase() const { return dimensions_.wheelbase; }
    [[nodiscard]] double max_steer() const { return dimensions_.max_steer; }
    [[nodiscard]] const CarDimensions& dimensions() const { return dimensions_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const Outline& outline() const { return outline_; }
    /// The wheels' outer faces: level with the axles, as far out as the body is there. What a low curb stops. Where the front
    /// axle lies ahead of the body, which only a car that somebody made up has, its wheels are as wide apart as the body.
    [[nodiscard]] const Outline& wheels() const { return wheels_; }
    /// The car seen in a mirror beside it, and the one that drives nose first where this one drives tail first.
    [[nodiscard]] Car mirrored() const;
    [[nodiscard]] Car turned_about() const;

    /// Bumper to bumper, d_f + d_r. [m]
    [[nodiscard]] double length() const { return dimensions_.front + dimensions_.rear; }
    /// r = b / tan(phi_max): radius of the rear axle centre's tightest circle. [m]
    [[nodiscard]] double turning_radius() const;
    /// d = 2 sqrt((r + w/2)^2 + b^2): diameter of the outer front wheel's tightest circle, as data sheets print it. [m]
    [[nodiscard]] double curb_to_curb() const;
    /// Diameter of the tightest circle that the body needs, to the side where it needs more. [m]
    [[nodiscard]] double wall_to_wall() const;
    /// Whether the outline is the rectangle of its dimensions.
    [[nodiscard]] bool is_rectangle() const;

    friend bool operator==(const Car&, const Car&) = default;

private:
    static Outline wheels_of(const Outline& body, double wheelbase);

    CarDimensions dimensions_;
    Outline outline_;
    Outline wheels_;
    std::string name_;
};

/// Corners of an outline at a pose, counter-clockwise from the front left. [m]
std::vector<Point> placed(const Outline& outline, const Pose& pose);
/// Corners of the car frame, which is its outline, at a pose. [m]
std::vector<Point> frame(const Car& car, const Pose& pose);

/// Steering angle [rad] whose rear axle centre turns with the given radius [m].
double steer_for_turning_radius(double wheelbase, double radius);
/// Steering angle [rad] of a car with the given curb-to-curb diameter [m]; NaN when no steering reaches it.
double steer_for_curb_to_curb(double wheelbase, double width, double diameter);
/// Steering angle [rad] of a car with the given wall-to-wall diameter [m]; NaN when no steering reaches it.
double steer_for_wall_to_wall(const Outline& outline, double wheelbase, double diameter);

/// The five cars of the paper's table 1, in its order.
std::vector<Car> catalogue();

/// A car whose numbers are a data sheet's. Its steering limit is what gives the sheet's turning circle from curb to curb; a
/// circle of which the sheet does not say which it is counts as that.
struct SheetCar {
    Car car;
    std::string sheet;   ///< publisher and title of what has the lengths
    std::string circle;  ///< the turning circle as printed, and which circle that is, as far as it is said
    std::string
        source;  ///< where the sheet and the circle were read, and what is special; lines, the last one without an end
};
/// Cars of public data sheets, sorted by name; none of them is in the catalogue.
std::vector<SheetCar> sheet_cars();

/// The car of that name, of the catalogue or of a data sheet.
std::optional<Car> find_car(std::string_view name);
/// The name of such a car that was probably meant by what was typed; empty when none comes near.
std::optional<std::string> nearest_car_name(std::string_view typed);

}  // namespace snug
