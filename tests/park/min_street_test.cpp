// The smallest roads and bays: the car parks in the size found, followed by code of its own; in smaller ones than the bound neither
// park() nor a plain search finds a way.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "park/plain_search.hpp"
#include "sample.hpp"
#include "snug/error.hpp"
#include "snug/min_street.hpp"

namespace {

using namespace park_test;
using snug::min_street;
using snug::MinStreet;
using snug::MinStreetOptions;
using snug::StreetSize;

TEST(MinStreet, ParksInTheSizeFoundAndInNoneBelowTheBound) {
    const int count = snug::test::sample(4, 200);
    const double resolution = snug::test::is_set("SNUG_SMALL") ? 0.08 : 0.04;
    int found_sizes = 0, searched = 0;
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(700000 + i));
        const Car car = random_car(random);
        Street street = random_street(random, car);
        if (!street.road) street.road = 5.0;
        MinStreetOptions options;
        options.sought = random.chance(0.5)                         ? StreetSize::road
                         : street.angle > 0.0 || random.chance(0.5) ? StreetSize::width
                                                                    : StreetSize::length;
        options.max_changes = random.whole(0, 2);
        options.precision = 0.05;
        options.resolution = resolution;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(car, street, {}) + " sought " +
                     std::string(to_string(options.sought)) + " changes " + std::to_string(options.max_changes));
        const MinStreet found = min_street(car, street, options);
        EXPECT_FALSE(found.cancelled);
        if (found.size) {
            ++found_sizes;
            EXPECT_LE(found.lower, *found.size);
            const Street enough = with_size(street, options.sought, *found.size);
            const Pose start = standard_start(enough, car);
            snug::ParkOptions asked;
            asked.max_changes = options.max_changes;
            asked.resolution = resolution;
            asked.roomiest = false;
            const auto answer = park(car, street_place(enough), start, asked);
            EXPECT_TRUE(answer.maneuver);
            if (answer.maneuver && !answer.maneuver->moves.empty()) {
                EXPECT_EQ(verdict(car, street_place(enough), start, answer), "");
            }
        }
        const double least = options.sought == StreetSize::length ? car.length() : car.width();
        for (int k = 0; k < snug::test::sample(1, 4); ++k) {
            const double size = found.lower - 1e-6 - std::pow(random.between(0.0, 1.0), 2) * (found.lower - least);
            if (size < least) continue;
            const Street small = with_size(street, options.sought, std::min(size, 30.0));
            const Case asked{car, street_place(small), standard_start(small, car), ""};
            if (depth_in_place(car, asked.place, asked.start) > -1e-3 ||
                outside_region(asked.place, asked.start) > -1e-3)
                continue;
            ++searched;
            EXPECT_EQ(PlainSearch(asked).changes(options.max_changes), -1) << "in one of " << size;
        }
    }
    std::printf("sizes found %d, smaller ones searched %d\n", found_sizes, searched);
}

/// What does with few changes does with more, what is wide enough for a car is so for a smaller one, and sides are alike.
TEST(MinStreet, MoreChangesSmallerCarsAndMirroredStreetsAreNoHarder) {
    const int count = snug::test::sample(2, 60);
    for (int i = 0; i < count; ++i) {
        Random random(static_cast<std::uint64_t>(710000 + i));
        const Car car = random_car(random);
        Street street = random_street(random, car);
        MinStreetOptions options;
        options.max_changes = random.whole(0, 2);
        options.precision = 0.05;
        options.resolution = 0.04;
        SCOPED_TRACE("case " + std::to_string(i) + ": " + described(car, street, {}));
        const MinStreet few = min_street(car, street, options);
        MinStreetOptions easier = options;
        ++easier.max_changes;
        const MinStreet more = min_street(car, street, easier);
        if (few.size) {
            EXPECT_LE(more.lower, *few.size);
            street.side = street.side == snug::Side::right ? snug::Side::left : snug::Side::right;
            EXPECT_LE(min_street(car, street, options).lower, *few.size);
        }
    }
}

TEST(MinStreet, CanBeGivenUpAndRefusesWhatIsImpossible) {
    const Car car = *snug::find_car("renault-zoe");
    const Street street = {.length = 5.2, .width = 2.0};
    MinStreetOptions options;
    options.max_changes = 2;
    int told = 0;
    options.progress = [&](double part) {
        EXPECT_GE(part, 0.0);
        EXPECT_LE(part, 1.0);
        return ++told < 3;
    };
    EXPECT_TRUE(min_street(car, street, options).cancelled);
    options.max_changes = -1;
    EXPECT_THROW(min_street(car, street, options), snug::Error);
}

}  // namespace
