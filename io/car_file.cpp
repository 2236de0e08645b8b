// How the keys of a description go together, and how files are read.
#include "car_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <system_error>

#include "sentences/check.hpp"
#include "sentences/spelling.hpp"

namespace snug {
namespace {

constexpr std::size_t longest_name = 100;  // [bytes]
constexpr double agreement = 1e-9;         // of values that say the same, relative

// What a described car may be: model cars of a thumb's width and road trains are, cars in millimetres or inches are not.
constexpr double least_length = 1e-3;  // [m]
constexpr double most_width = 10.0;    // [m]
constexpr double most_length = 50.0;   // from the rear axle to either end [m]
constexpr double least_steer = 5.0 * degree;
constexpr double most_steer = 80.0 * degree;

/// What cars on roads measure, to tell by it which unit somebody had in mind. [m]
struct Usual {
    double least;
    double most;
};
Usual usual(const std::string& key) {
    if (key == "width") return {1.2, 3.0};
    if (key == "rear" || key == "front_overhang" || key == "rear_overhang") return {0.3, 2.5};
    if (key == "wheelbase") return {1.6, 5.0};
    if (key == "length") return {2.3, 9.0};
    if (key == "front") return {2.0, 7.0};
    return {5.0, 15.0};  // circles, and their radius
}

/// "; 1771 looks like millimetres, which would be 1.771 m"; empty when it looks like nothing.
std::string in_another_unit(const std::string& key, double value) {
    struct Unit {
        const char* name;
        double metres;
    };
    for (const Unit& unit :
         {Unit{"millimetres", 1e-3}, Unit{"inches", 0.0254}, Unit{"centimetres", 1e-2}, Unit{"feet", 0.3048}}) {
        const double metres = value * unit.metres;
        if (metres < usual(key).least || metres > usual(key).most) continue;
        return "; " + spelled(value) + " looks like " + unit.name + ", which would be " +
               spelled(std::round(metres * 1e4) / 1e4) + " m";
    }
    return "";
}

/// A sum of lengths without what binary numbers add: 0.657, not 0.6569999999999996. [m]
double tidy(double length) { return std::round(length * 1e12) / 1e12; }

class Described {
public:
    Described(const CarDescription& description, const Complaint& complaint)
        : given_(description), complaint_(complaint) {}

    Car car() {
        for (const std::string& key : car_lengths)
            if (given_.has(key)) check_length(key);
        if (!given_.outline) needed("width");
        wheelbase_ = needed("wheelbase");
        const Outline outline = given_.outline ? given_outline() : rectangle();
        if (outline.front() < wheelbase_) refuse_front(outline);
        agree_on_lengths(outline);
        const Car straight = build(outline, (least_steer + most_steer) / 2.0);  // the lengths, before the steering
        const double steer = steering(straight);
        Car car = build(outline, steer);
        agree_on_steering(car);
        return car;
    }

private:
    [[noreturn]] void complain(const std::string& key, const std::string& what) const { throw complaint_(key, what); }

    [[nodiscard]] double at(const std::string& key) const { return given_.numbers.at(key); }

    double needed(const std::string& key) const {
        if (!given_.has(key)) complain(key, "is missing; give it in metres");
        return at(key);
    }

    void check_length(const std::string& key) const {
        const bool overhang = key == "front_overhang" || key == "rear_overhang";
        const double least = overhang && key == "front_overhang" ? 0.0 : least_length;
        check(key, at(key), least,
              key == "width"    ? most_width
              : key == "length" ? 2.0 * most_length
                                : most_length,
              " m", in_another_unit(key, at(key)));
    }

    void check(const std::string& key, double value, double least, double most, const std::string& unit,
               const std::string& hint) const {
        constexpr double rounding = 1e-12;  // of a bound turned from one unit into another
        if (value >= least * (1.0 - rounding) && value <= most * (1.0 + rounding)) return;
        complain(key, "is " + spelled(value) + unit + ", but must lie between " + spelled(least) + " and " +
                          spelled(most) + unit + hint);
    }

    /// Front and rear, each by itself or out of what data sheets print.
    [[nodiscard]] double front() const {
        if (given_.has("front")) return at("front");
        if (given_.has("front_overhang")) return tidy(wheelbase_ + at("front_overhang"));
        if (given_.has("length") && (given_.has("rear") || given_.has("rear_overhang")))
            return tidy(at("length") - rear());
        complain("front", "is missing; give it in metres, from the rear axle, or give front_overhang");
    }
    [[nodiscard]] double rear() const {
        if (given_.has("rear")) return at("rear");
        if (given_.has("rear_overhang")) return at("rear_overhang");
        if (given_.has("length") && (given_.has("front") || given_.has("front_overhang")))
            return tidy(at("length") - front());
        complain("rear", "is missing; give it in metres, from the rear axle, or give rear_overhang");
    }

    /// What the constructors of the model say, about a key.
    template <class Make>
    auto about(const std::string& key, const Make& make) const {
        try {
            return make();
        } catch (const Error& error) {
            complain(key, std::string("describes no car: ") + error.what());
        }
    }

    [[nodiscard]] Outline given_outline() const {
        if (given_.corner_radius)
            complain("corner_radius", "rounds a rectangle, but an outline is given, too; give one of them");
        return about("outline", [&] {
            for (const Point& corner : *given_.outline) {
                const double size = std::max(std::abs(corner.x), std::abs(corner.y));
                if (size > most_length)
                    throw Error("the coordinate " + spelled(size) + " m is more than " + spelled(most_length) + " m" +
                                in_another_unit("front", size));
            }
            Outline outline(*given_.outline);
            if (!(outline.rear() > 0.0 && outline.left() > 0.0 && outline.right() > 0.0))
                throw Error("the middle of the rear axle, (0, 0), lies outside, but must lie inside");
            if (outline.left() + outline.right() > most_width)
                throw Error("it is " + spelled(outline.left() + outline.right()) + " m wide, but must be at most " +
                            spelled(most_width) + " m" + in_another_unit("width", outline.left() + outline.right()));
            return outline;
        });
    }

    [[nodiscard]] Outline rectangle() const {
        const double half_width = needed("width") / 2.0;
        const double ahead = front();
        const double behind = rear();
        if (!(ahead > 0.0 && behind > 0.0))
            complain("length", "is " + spelled(at("length")) + " m, which leaves nothing for the other end");
        if (!given_.corner_radius) return Outline::rectangle(ahead, behind, half_width);
        return about("corner_radius", [&] {
            return Outline::rounded(ahead, behind, half_width, given_.corner_radius->front, given_.corner_radius->rear);
        });
    }

    [[noreturn]] void refuse_front(const Outline& outline) const {
        if (given_.outline)
            complain("outline",
                     "reaches " + spelled(outline.front()) + " m ahead of the rear axle, less than the wheelbase, " +
                         spelled(wheelbase_) +
                         " m; its points are measured from the middle of the rear axle, and the front wheels "
                         "must be inside");
        complain(given_.has("front") ? "front" : "length",
                 "puts the front " + spelled(outline.front()) + " m ahead of the rear axle, less than the wheelbase, " +
                     spelled(wheelbase_) + " m; front is measured from the rear axle: wheelbase + front overhang");
    }

    [[nodiscard]] Car build(const Outline& outline, double steer) const {
        const std::string key = given_.outline ? "outline" : "";
        return about(key, [&] { return Car(outline, wheelbase_, steer, given_.name); });
    }

    void agree(const std::string& key, double right, const std::string& others) const {
        if (!given_.has(key) || std::abs(at(key) - right) <= agreement * std::abs(right)) return;
        complain(key, "is " + spelled(at(key)) + ", which does not agree with " + others + ", by which it would be " +
                          spelled(right) + "; correct one or leave this one out");
    }

    void agree_on_lengths(const Outline& outline) const {
        const std::string by = given_.outline ? "the outline" : "front and rear";
        agree("width", outline.left() + outline.right(), by);
        agree("front", outline.front(), by);
        agree("rear", outline.rear(), by);
        agree("length", outline.front() + outline.rear(), by);
        agree("rear_overhang", outline.rear(), by);
        if (given_.has("front_overhang")) {
            const double overhang = outline.front() - wheelbase_;
            if (std::abs(at("front_overhang") - overhang) > agreement * outline.front())
                agree("front_overhang", overhang, by + " and wheelbase");
        }
    }

    [[nodiscard]] const std::string& first_steering() const {
        for (const std::string& key : steerings)
            if (given_.has(key)) return key;
        complain("", "says nothing about the steering; give one of " + either(steerings));
    }

    /// The largest steering angle, under whichever name it is given. [rad]
    [[nodiscard]] double steering(const Car& car) const {
        const std::string& key = first_steering();
        const double value = at(key);
        if (key == "max_steer" || key == "max_steer_deg") {
            const bool radians = key == "max_steer";
            const double unit = radians ? 1.0 : degree;
            check(key, value, least_steer / unit, most_steer / unit, radians ? " rad" : " degrees",
                  steering_hint(car, value * unit, radians, value));
            return value * unit;
        }
        const double sharpest = circle(key, build(car.outline(), most_steer));
        const double dullest = circle(key, build(car.outline(), least_steer));
        check(key, value, sharpest, dullest, " m", in_another_unit(key, value));
        if (key == "turning_radius") return steer_for_turning_radius(car.wheelbase(), value);
        if (key == "curb_to_curb") return steer_for_curb_to_curb(car.wheelbase(), car.width(), value);
        return steer_for_wall_to_wall(car.outline(), car.wheelbase(), value);
    }

    /// What an angle that no car has would mean, or in which unit it would be one.
    static std::string steering_hint(const Car& car, double angle, bool radians, double value) {
        const double in_the_other = radians ? value * degree : value;
        if (in_the_other >= least_steer && in_the_other <= most_steer)
            return radians ? "; " + spelled(value) + " degrees are " + spelled(std::round(in_the_other * 1e6) / 1e6) +
                                 " rad"
                           : "; " + spelled(value) + " rad are " + spelled(std::round(value / degree * 1e4) / 1e4) +
                                 " degrees";
        if (!(angle > 0.0 && angle < std::numbers::pi / 2.0)) return "";
        const double radius = car.wheelbase() / std::tan(angle);
        return "; it would turn the rear axle on a circle of " + spelled(std::round(radius * 1e3) / 1e3) + " m radius";
    }

    static double circle(const std::string& key, const Car& car) {
        return key == "max_steer"        ? car.max_steer()
               : key == "max_steer_deg"  ? car.max_steer() / degree
               : key == "turning_radius" ? car.turning_radius()
               : key == "curb_to_curb"   ? car.curb_to_curb()
                                         : car.wall_to_wall();
    }

    void agree_on_steering(const Car& car) const {
        for (const std::string& key : steerings) agree(key, circle(key, car), first_steering());
    }

    const CarDescription& given_;
    const Complaint& complaint_;
    double wheelbase_ = 0.0;
};

}  // namespace

std::string unit_of(const std::string& key) {
    return key == "max_steer" ? "radians" : key == "max_steer_deg" ? "degrees" : "metres";
}

Car described(const CarDescription& description, const Complaint& complaint) {
    return Described(description, complaint).car();
}

void check_name(const std::string& what, const std::string& name) {
    if (name.size() > longest_name || printable(name) != name) {
        throw Error(what + " is " + in_quotes(name) + ", but must be at most " + std::to_string(longest_name) +
                    " bytes of UTF-8, free of control characters");
    }
}

std::string read_text(const std::string& path, std::size_t largest, const std::string& instead) {
    const auto failed = [&](int reason) {
        return Error(path + ": cannot be read: " + std::generic_category().message(reason) + "; " + instead);
    };
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) {
        throw failed(errno);
    }
    std::string text;
    std::string part(1 << 16, '\0');
    errno = 0;
    while (text.size() <= largest) {
        const std::size_t wanted = std::min(part.size(), largest + 1 - text.size());
        const std::size_t count = std::fread(part.data(), 1, wanted, file.get());
        text.append(part, 0, count);
        if (count < wanted) {
            break;
        }
    }
    if (std::ferror(file.get()) != 0) {
        throw failed(errno);
    }
    return text;
}

}  // namespace snug
