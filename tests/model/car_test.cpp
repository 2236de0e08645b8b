// Cars: which can exist, how tightly they turn, and where their corners are.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numbers.hpp"
#include "random_maneuvers.hpp"
#include "refusals.hpp"
#include "sample.hpp"

namespace model {
namespace {

constexpr snug::CarDimensions zoe{1.771, 3.427, 0.657, 2.588, 33 * degree};

TEST(Car, HasTheDimensionsAndTheNameItWasGiven) {
    const snug::Car car(zoe, "mine");
    EXPECT_EQ(car.name(), "mine");
    EXPECT_EQ(car.width(), 1.771);
    EXPECT_EQ(car.front(), 3.427);
    EXPECT_EQ(car.rear(), 0.657);
    EXPECT_EQ(car.wheelbase(), 2.588);
    EXPECT_EQ(car.max_steer(), 33 * degree);
    EXPECT_DOUBLE_EQ(car.length(), 4.084);
}

TEST(Car, OfImpossibleDimensionsIsRefusedByName) {
    const std::vector<std::pair<std::string, double snug::CarDimensions::*>> lengths{
        {"car width", &snug::CarDimensions::width},
        {"car front", &snug::CarDimensions::front},
        {"car rear", &snug::CarDimensions::rear},
        {"car wheelbase", &snug::CarDimensions::wheelbase}};
    for (const auto& [name, member] : lengths) {
        for (const double bad : {0.0, -1.8, 0.99e-6, 1.01e6, nan, infinity, -infinity}) {
            snug::CarDimensions dimensions = zoe;
            dimensions.*member = bad;
            const std::string sentence = refusal([&] { snug::Car{dimensions}; });
            EXPECT_EQ(sentence.find(name + " is "), 0U) << sentence << " for " << bad;
            EXPECT_NE(sentence.find("must lie between 1e-06 and 1000000 m"), std::string::npos) << sentence;
        }
    }
    for (const double bad : {0.0, -0.5, 0.09 * degree, 89.91 * degree, 90 * degree, 2.0, nan, infinity, -infinity}) {
        snug::CarDimensions dimensions = zoe;
        dimensions.max_steer = bad;
        const std::string sentence = refusal([&] { snug::Car{dimensions}; });
        EXPECT_EQ(sentence.find("car max_steer is "), 0U) << sentence << " for " << bad;
        EXPECT_NE(sentence.find("between 0.1 and 89.9 degrees"), std::string::npos) << sentence;
    }
}

TEST(Car, RefusalQuotesTheValue) {
    snug::CarDimensions dimensions = zoe;
    dimensions.width = -1.8;
    EXPECT_EQ(refusal([&] { snug::Car{dimensions}; }), "car width is -1.8 m, but must lie between 1e-06 and 1000000 m");
    dimensions = zoe;
    dimensions.max_steer = 90 * degree;
    EXPECT_EQ(refusal([&] { snug::Car{dimensions}; }),
              "car max_steer is 1.57079632679 rad (90 degrees), but must lie between 0.1 and 89.9 degrees");
}

TEST(Car, AtTheVeryLimitsExists) {
    EXPECT_NO_THROW(snug::Car({1e-6, 1e-6, 1e-6, 1e-6, 0.1 * degree}));
    EXPECT_NO_THROW(snug::Car({1e6, 1e6, 1e6, 1e6, 89.9 * degree}));
}

TEST(Car, MayHaveAFrontShorterThanItsWheelbase) {
    EXPECT_NO_THROW(snug::Car({zoe.width, zoe.rear, zoe.front, zoe.wheelbase, zoe.max_steer}));
}

TEST(Car, CornersAreAheadAndBesideTheRearAxleInCounterClockwiseOrder) {
    Random random(1);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        const snug::Pose pose = random_pose(random);
        const double half = car.width() / 2;
        const std::array<snug::Point, 4> ahead_and_left{
            {{car.front(), half}, {-car.rear(), half}, {-car.rear(), -half}, {car.front(), -half}}};
        const auto corners = frame(car, pose);
        for (std::size_t k = 0; k < 4; ++k) {
            const double dx = corners[k].x - pose.x;
            const double dy = corners[k].y - pose.y;
            EXPECT_NEAR(dx * std::cos(pose.heading) + dy * std::sin(pose.heading), ahead_and_left[k].x, 1e-13);
            EXPECT_NEAR(dy * std::cos(pose.heading) - dx * std::sin(pose.heading), ahead_and_left[k].y, 1e-13);
        }
    }
}

TEST(Car, OuterFrontWheelRunsOnTheCurbToCurbCircle) {
    Random random(2);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        // Half a circle to the left takes the right front wheel to the opposite point.
        const auto wheel = [&](const snug::Pose& pose) {
            const double half = car.width() / 2;
            return snug::Point{pose.x + car.wheelbase() * std::cos(pose.heading) + half * std::sin(pose.heading),
                               pose.y + car.wheelbase() * std::sin(pose.heading) - half * std::cos(pose.heading)};
        };
        const snug::Pose start = random_pose(random);
        const double half_circle = std::numbers::pi * car.turning_radius();
        const snug::Point from = wheel(start);
        const snug::Point to = wheel(drive(car, start, snug::Direction::forward, car.max_steer(), half_circle));
        EXPECT_NEAR(std::hypot(to.x - from.x, to.y - from.y), car.curb_to_curb(), 1e-12 * car.curb_to_curb());
    }
}

TEST(Car, SteersAsItsDataSheetSays) {
    Random random(3);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        EXPECT_NEAR(snug::steer_for_turning_radius(car.wheelbase(), car.turning_radius()), car.max_steer(), 1e-14);
        EXPECT_NEAR(snug::steer_for_curb_to_curb(car.wheelbase(), car.width(), car.curb_to_curb()), car.max_steer(),
                    1e-12);
    }
}

TEST(Car, NoSteeringReachesACurbToCurbCircleSmallerThanTheCar) {
    EXPECT_TRUE(std::isnan(snug::steer_for_curb_to_curb(2.7, 1.8, 5.3)));  // not even the wheelbase fits
    const double pivoting = 2.0 * std::hypot(2.7, 0.9);                    // turning on the inner rear wheel's side
    EXPECT_TRUE(std::isnan(snug::steer_for_curb_to_curb(2.7, 1.8, pivoting * 0.999)));
    EXPECT_FALSE(std::isnan(snug::steer_for_curb_to_curb(2.7, 1.8, pivoting * 1.001)));
    EXPECT_TRUE(std::isnan(snug::steer_for_curb_to_curb(2.7, 1.8, nan)));
    EXPECT_TRUE(std::isnan(snug::steer_for_curb_to_curb(2.7, 1.8, -12.0)));
}

TEST(Catalogue, HoldsTheCarsOfThePaper) {
    const std::vector<snug::Car> cars = snug::catalogue();
    const auto table = oracle::table_of_cars();
    ASSERT_EQ(cars.size(), table.size());
    for (std::size_t i = 0; i < cars.size(); ++i) {
        const auto& [name, dimensions] = table[i];
        EXPECT_EQ(cars[i].name(), name);
        EXPECT_EQ(cars[i].width(), dimensions.width);
        EXPECT_EQ(cars[i].front(), dimensions.front);
        EXPECT_EQ(cars[i].rear(), dimensions.rear);
        EXPECT_EQ(cars[i].wheelbase(), dimensions.wheelbase);
        EXPECT_DOUBLE_EQ(cars[i].max_steer(), dimensions.max_steer);
    }
}

TEST(Catalogue, FindsEveryCarByItsNameAndNoOther) {
    for (const snug::Car& car : snug::catalogue()) {
        const auto found = snug::find_car(car.name());
        ASSERT_TRUE(found.has_value()) << car.name();
        EXPECT_EQ(found->width(), car.width());
        EXPECT_EQ(snug::nearest_car_name(car.name()), car.name());
    }
    EXPECT_FALSE(snug::find_car("renault").has_value());
    EXPECT_FALSE(snug::find_car("").has_value());
}

TEST(Catalogue, SuggestsTheNearestName) {
    EXPECT_EQ(snug::nearest_car_name("renault-zoo"), "renault-zoe");
    EXPECT_EQ(snug::nearest_car_name("midsize"), "mid-size");
    EXPECT_EQ(snug::nearest_car_name("mercedes-amg"), "mercedes-amg-gt");
    EXPECT_EQ(snug::nearest_car_name("vwtransporter"), "vw-transporter");
    EXPECT_EQ(snug::nearest_car_name("ople-corsa"), "opel-corsa");
    EXPECT_EQ(snug::nearest_car_name("vw"), "vw-transporter");
    EXPECT_EQ(snug::nearest_car_name("Zoe"), "renault-zoe");
    EXPECT_EQ(snug::nearest_car_name("MID-SIZE"), "mid-size");
    for (const char* none : {"", "-", "z", "oe", "fiat-500", "golf", "mercedes-benz-sprinter", "my-car"})
        EXPECT_FALSE(snug::nearest_car_name(none)) << none;
    EXPECT_FALSE(snug::nearest_car_name(std::string(1'000'000, 'x')));
}

}  // namespace
}  // namespace model
