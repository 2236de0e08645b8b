// Cars of data sheets: are they what the sheets say, and do they turn in the circles printed there?
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "numbers.hpp"
#include "snug/car.hpp"

namespace model {
namespace {

/// A sheet's numbers typed once more: lengths [m] (of the length and the sum of its parts the longer), and the circle's diameter or radius in the sheet's unit.
struct Printed {
    std::string name;
    double length, width, wheelbase, front_overhang, rear_overhang;
    std::string circle;  ///< as printed, with the digits it has
    double diameters;    ///< 2 for a radius, 1 for a diameter
    double unit;         ///< [m]
};

const std::vector<Printed>& printed() {
    static const std::vector<Printed> sheets{
        {"citroen-jumper", 5.998, 2.050, 4.035, 0.948, 1.015, "14.14", 1, 1},
        {"dacia-bigster", 4.571, 1.812, 2.702, 0.854, 1.015, "10.97", 1, 1},
        {"dacia-duster", 4.343, 1.813, 2.657, 0.857, 0.829, "10.96", 1, 1},
        {"dacia-jogger", 4.550, 1.784, 2.898, 0.833, 0.819, "11.39", 1, 1},
        {"dacia-sandero", 4.102, 1.753, 2.604, 0.833, 0.665, "10.64", 1, 1},
        {"dacia-spring", 3.701, 1.583, 2.423, 0.683, 0.595, "9.63", 1, 1},
        {"hyundai-ioniq-5", 4.635, 1.890, 3.000, 0.845, 0.790, "12", 1, 1},
        {"hyundai-ioniq-6", 4.855, 1.880, 2.950, 0.850, 1.055, "5.91", 2, 1},
        {"hyundai-palisade", 4.980, 1.975, 2.900, 0.945, 1.135, "38.7", 1, 0.3048},
        {"hyundai-santa-fe", 4.785, 1.900, 2.765, 0.945, 1.075, "11.40", 1, 1},
        {"hyundai-staria", 5.253, 1.997, 3.273, 0.910, 1.070, "5.97", 2, 1},
        {"kia-ev3", 4.310, 1.850, 2.680, 0.815, 0.815, "10.4", 1, 1},
        {"kia-ev5", 4.610, 1.875, 2.750, 0.910, 0.950, "11.7", 1, 1},
        {"lexus-lbx", 4.190, 1.825, 2.580, 0.860, 0.750, "5.2", 2, 1},
        {"lexus-nx", 4.660, 1.865, 2.690, 1.007, 0.963, "5.8", 2, 1},
        {"mazda-cx-3", 4.275, 1.765, 2.570, 0.910, 0.795, "5.3", 2, 1},
        {"mazda-cx-30", 4.395, 1.795, 2.655, 0.915, 0.825, "5.3", 2, 1},
        {"mazda-cx-5", 4.545, 1.840, 2.700, 0.945, 0.900, "5.5", 2, 1},
        {"mazda-mx-5", 3.915, 1.735, 2.310, 0.760, 0.845, "4.7", 2, 1},
        {"renault-master", 6.225, 2.070, 4.332, 0.869, 1.024, "15.7", 1, 1},
        {"skoda-octavia", 4.690, 1.829, 2.686, 0.910, 1.094, "10.4", 1, 1},
        {"tesla-model-3", 4.720, 1.850, 2.875, 0.868, 0.977, "11.7", 1, 1},
        {"tesla-model-s", 5.021, 1.987, 2.960, 0.961, 1.100, "12.3", 1, 1},
        {"tesla-model-y", 4.790, 1.920, 2.890, 0.889, 1.011, "12.13", 1, 1},
    };
    return sheets;
}

TEST(SheetCars, HaveTheLengthsOfTheirSheets) {
    const std::vector<snug::SheetCar> known = snug::sheet_cars();
    ASSERT_EQ(known.size(), printed().size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const snug::Car& car = known[i].car;
        const Printed& sheet = printed()[i];
        EXPECT_EQ(car.name(), sheet.name);
        EXPECT_NEAR(car.length(), sheet.length, 1e-12) << sheet.name;
        EXPECT_EQ(car.width(), sheet.width) << sheet.name;
        EXPECT_EQ(car.wheelbase(), sheet.wheelbase) << sheet.name;
        EXPECT_NEAR(car.front() - car.wheelbase(), sheet.front_overhang, 1e-12) << sheet.name;
        EXPECT_EQ(car.rear(), sheet.rear_overhang) << sheet.name;
        EXPECT_TRUE(car.is_rectangle());
    }
}

TEST(SheetCars, TurnInTheCircleOfTheirSheets) {
    const std::vector<snug::SheetCar> known = snug::sheet_cars();
    ASSERT_EQ(known.size(), printed().size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const snug::Car& car = known[i].car;
        const Printed& sheet = printed()[i];
        // The outer front wheel stands at right angles to the line from the circle's centre to it.
        const long double across =
            car.wheelbase() / std::tan(static_cast<long double>(car.max_steer())) + car.width() / 2.0L;
        const long double circle = 2.0L * std::hypot(across, static_cast<long double>(car.wheelbase()));
        const std::size_t dot = sheet.circle.find('.');
        const int decimals = dot == sheet.circle.npos ? 0 : static_cast<int>(sheet.circle.size() - dot - 1);
        const double scale = sheet.diameters * sheet.unit;
        const double rounding = 0.5 * std::pow(10.0, -decimals) * scale;
        EXPECT_NEAR(static_cast<double>(circle), std::stod(sheet.circle) * scale, rounding) << sheet.name;
        // It is the printed number and not one that merely rounds to it.
        EXPECT_NEAR(static_cast<double>(circle), std::stod(sheet.circle) * scale, 1e-12) << sheet.name;
        EXPECT_NEAR(car.curb_to_curb(), static_cast<double>(circle), 1e-12) << sheet.name;
        EXPECT_EQ(known[i].circle.find((sheet.diameters == 2 ? "radius " : "") + sheet.circle + " "), 0U) << sheet.name;
    }
}

TEST(SheetCars, AreCarsThatPeopleDrive) {
    for (const snug::SheetCar& known : snug::sheet_cars()) {
        const snug::Car& car = known.car;
        EXPECT_TRUE(car.length() > 3.5 && car.length() < 6.5) << car.name();
        EXPECT_TRUE(car.width() > 1.55 && car.width() < 2.1) << car.name();
        EXPECT_TRUE(car.max_steer() > 25 * degree && car.max_steer() < 45 * degree) << car.name();
    }
}

TEST(SheetCars, NameTheirSheets) {
    for (const snug::SheetCar& known : snug::sheet_cars()) {
        EXPECT_FALSE(known.sheet.empty()) << known.car.name();
        const bool address =
            known.source.find("https://") != known.source.npos || known.source.find("github.com/") != known.source.npos;
        EXPECT_TRUE(address) << known.car.name();
        EXPECT_NE(known.source.back(), '\n') << known.car.name();
        const bool said = known.circle.find("curb to curb") != known.circle.npos;
        const bool unsaid = known.circle.find("curb or wall not said") != known.circle.npos;
        EXPECT_NE(said, unsaid) << known.car.name();
    }
}

TEST(SheetCars, HaveNamesOfTheirOwnInKebabCaseAndInOrder) {
    std::set<std::string> names;
    for (const snug::Car& car : snug::catalogue()) names.insert(car.name());
    std::string before;
    for (const snug::SheetCar& known : snug::sheet_cars()) {
        const std::string& name = known.car.name();
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_LT(before, name);
        before = name;
        EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), name.npos) << name;
        EXPECT_EQ(name.find("--"), name.npos) << name;
        EXPECT_TRUE(name.front() != '-' && name.back() != '-') << name;
    }
}

TEST(SheetCars, AreFoundAndSuggestedByName) {
    for (const snug::SheetCar& known : snug::sheet_cars()) {
        const auto found = snug::find_car(known.car.name());
        ASSERT_TRUE(found.has_value()) << known.car.name();
        EXPECT_EQ(*found, known.car);
        EXPECT_EQ(snug::nearest_car_name(known.car.name()), known.car.name());
    }
    EXPECT_EQ(snug::nearest_car_name("tesla-model3"), "tesla-model-3");
    EXPECT_EQ(snug::nearest_car_name("mx-5"), "mazda-mx-5");
    EXPECT_EQ(snug::nearest_car_name("Kia-EV5"), "kia-ev5");
}

}  // namespace
}  // namespace model
