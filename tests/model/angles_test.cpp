// The core's own angle functions: how far from the true values they are, and what they keep exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/angles.hpp"
#include "numbers.hpp"
#include "random_maneuvers.hpp"
#include "sample.hpp"

namespace model {
namespace {

namespace angles = snug::angles;

constexpr double pi = std::numbers::pi;

/// How far off a result is, in units in the last place of the true value.
double ulps(double got, long double exact) {
    if (got == exact) {
        return 0.0;
    }
    const int exponent = std::max(std::ilogb(exact), -1022);
    return static_cast<double>(std::abs(got - exact) / std::scalbn(1.0L, exponent - 52));
}

/// The largest error over random arguments, half of them between the bounds and half of any smallness.
template <class Function, class Exact>
double worst(double bound, Function function, Exact exact) {
    Random random(1);
    double largest = 0.0;
    for (int i = snug::test::sample(200'000, 20'000'000); i > 0; --i) {
        const double spread = random.between(-bound, bound);
        const double small = random.chance(0.5) ? std::pow(10.0, random.between(-20.0, 0.0)) : 1.0;
        const double error = ulps(function(spread * small), exact(static_cast<long double>(spread * small)));
        largest = std::max(largest, error);
    }
    return largest;
}

TEST(Angles, SinesAreWithinAUnitInTheLastPlace) {
    for (const double bound : {0.8, 4.0, 7.0, 380.0}) {
        EXPECT_LT(worst(bound, angles::sin, [](long double x) { return std::sin(x); }), 0.85) << bound;
        EXPECT_LT(worst(bound, angles::cos, [](long double x) { return std::cos(x); }), 0.85) << bound;
        EXPECT_LT(worst(bound, angles::tan, [](long double x) { return std::tan(x); }), 2.4) << bound;
    }
}

TEST(Angles, ArcsAreWithinTwoUnitsInTheLastPlace) {
    for (const double bound : {0.1, 1.0, 8.0, 1e6})
        EXPECT_LT(worst(bound, angles::atan, [](long double x) { return std::atan(x); }), 2.1) << bound;
    EXPECT_LT(worst(1.0, angles::asin, [](long double x) { return std::asin(x); }), 2.1);
    EXPECT_LT(worst(1.0, angles::acos, [](long double x) { return std::acos(x); }), 2.1);

    Random random(2);
    for (int i = snug::test::sample(200'000, 20'000'000); i > 0; --i) {
        const double x = random.between(-9.0, 9.0);
        const double y = random.between(-9.0, 9.0);
        const long double exact_x = x;
        const long double exact_y = y;
        ASSERT_LT(ulps(angles::atan2(y, x), std::atan2(exact_y, exact_x)), 2.1) << y << ' ' << x;
        ASSERT_LT(ulps(angles::hypot(y, x), std::hypot(exact_y, exact_x)), 1.3) << y << ' ' << x;
    }
}

TEST(Angles, BeyondSixtyTurnsErrByLessThanTheAnglesOwnRounding) {
    Random random(3);
    for (int i = snug::test::sample(100'000, 10'000'000); i > 0; --i) {
        const double angle = random.between(-1.0, 1.0) * std::pow(10.0, random.between(2.5, 15.0));
        const double rounding = std::abs(angle) * 0x1p-53 + 2e-16;
        const long double exact = angle;
        ASSERT_NEAR(angles::sin(angle), static_cast<double>(std::sin(exact)), rounding) << angle;
        ASSERT_NEAR(angles::cos(angle), static_cast<double>(std::cos(exact)), rounding) << angle;
    }
    EXPECT_LE(std::abs(angles::sin(1e300)), 1.0);
}

TEST(Angles, OfMirrorImagesAreMirrorImages) {
    Random random(4);
    for (int i = snug::test::sample(100'000, 1'000'000); i > 0; --i) {
        const double angle = random.between(0.0, random.chance(0.5) ? 7.0 : 1e4);
        ASSERT_EQ(angles::sin(-angle), -angles::sin(angle)) << angle;
        ASSERT_EQ(angles::cos(-angle), angles::cos(angle)) << angle;
        ASSERT_EQ(angles::tan(-angle), -angles::tan(angle)) << angle;
        const double x = random.between(-2.0, 2.0);
        const double y = random.between(0.0, 2.0);
        ASSERT_EQ(angles::atan2(-y, x), -angles::atan2(y, x)) << y << ' ' << x;
        ASSERT_EQ(angles::hypot(x, y), angles::hypot(y, -x)) << y << ' ' << x;
    }
}

TEST(Angles, AreOneDirectionSeenTwoWays) {
    Random random(5);
    for (int i = snug::test::sample(100'000, 1'000'000); i > 0; --i) {
        const double angle = random.between(-pi, pi);
        const auto [s, c] = angles::sine_cosine(angle);
        ASSERT_EQ(s, angles::sin(angle));
        ASSERT_EQ(c, angles::cos(angle));
        ASSERT_NEAR(s * s + c * c, 1.0, 5e-16) << angle;
        ASSERT_NEAR(angles::atan2(s, c), angle, 1e-15) << angle;
        ASSERT_NEAR(angles::atan(angles::tan(angle / 2.0)), angle / 2.0, 1e-15) << angle;
        ASSERT_NEAR(angles::sin(angles::asin(s)), s, 5e-16) << angle;
        ASSERT_NEAR(angles::cos(angles::acos(c)), c, 5e-16) << angle;
    }
}

TEST(Angles, HaveTheirExactValuesAtWholeQuarterTurns) {
    EXPECT_EQ(angles::sin(0.0), 0.0);
    EXPECT_EQ(angles::cos(0.0), 1.0);
    EXPECT_EQ(angles::tan(0.0), 0.0);
    // The doubles nearest to quarter turns miss them by a little, which sines show in full.
    for (int quarters = -8; quarters <= 8; ++quarters) {
        const double angle = quarters * (pi / 2.0);
        const long double exact = angle;
        EXPECT_LT(ulps(angles::sin(angle), std::sin(exact)), 0.85) << quarters;
        EXPECT_LT(ulps(angles::cos(angle), std::cos(exact)), 0.85) << quarters;
        const double along = quarters % 2 == 0 ? angles::cos(angle) : angles::sin(angle);
        EXPECT_EQ(along, (quarters & 2) == 0 ? 1.0 : -1.0) << quarters;
    }
    EXPECT_EQ(angles::atan2(0.0, 1.0), 0.0);
    EXPECT_EQ(angles::atan2(1.0, 0.0), pi / 2.0);
    EXPECT_EQ(angles::atan2(0.0, -1.0), pi);
    EXPECT_EQ(angles::atan2(-1.0, 0.0), -pi / 2.0);
    EXPECT_EQ(angles::atan2(1.0, 1.0), pi / 4.0);
    EXPECT_EQ(angles::atan2(-1.0, 1.0), -pi / 4.0);
    EXPECT_EQ(angles::atan2(1.0, -1.0), 3.0 * pi / 4.0);
    EXPECT_EQ(angles::atan2(0.0, 0.0), 0.0);
    EXPECT_EQ(angles::asin(1.0), pi / 2.0);
    EXPECT_EQ(angles::asin(-1.0), -pi / 2.0);
    EXPECT_EQ(angles::acos(1.0), 0.0);
    EXPECT_EQ(angles::acos(0.0), pi / 2.0);
    EXPECT_EQ(angles::acos(-1.0), pi);
    EXPECT_EQ(angles::hypot(3.0, 4.0), 5.0);
}

TEST(Angles, OfWhatIsNoAngleAreNaN) {
    for (const double bad : {nan, infinity, -infinity}) {
        EXPECT_TRUE(std::isnan(angles::sin(bad))) << bad;
        EXPECT_TRUE(std::isnan(angles::cos(bad))) << bad;
        EXPECT_TRUE(std::isnan(angles::tan(bad))) << bad;
        EXPECT_TRUE(std::isnan(angles::asin(bad))) << bad;
        EXPECT_TRUE(std::isnan(angles::acos(bad))) << bad;
        EXPECT_TRUE(std::isnan(angles::atan2(bad, infinity))) << bad;
    }
    EXPECT_TRUE(std::isnan(angles::asin(1.0 + 1e-15)));
    EXPECT_TRUE(std::isnan(angles::acos(-1.0 - 1e-15)));
    EXPECT_TRUE(std::isnan(angles::atan(nan)));
    EXPECT_EQ(angles::atan(infinity), pi / 2.0);
    EXPECT_EQ(angles::atan(-infinity), -pi / 2.0);
}

}  // namespace
}  // namespace model
