// What is said of where a corner meets a line, for all cars of a box at once, against single cars of it in long double.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "full_steering/proof/gaps.hpp"
#include "sample.hpp"

namespace snug::detail::proof {
namespace {

/// Corners whose circles reach beyond the line by a part of their radius that is anything from a billionth to all of it, seen
/// from centres that differ by up to as much.
TEST(Enclosures, OfRootsHoldForEveryCar) {
    constexpr long double turn = 6.283185307179586476925286766559L;
    std::mt19937_64 bits(11);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    const auto part = [&] { return bits() % 4 == 0 ? 1.0 : bits() % 4 == 1 ? -1.0 : between(-1.0, 1.0); };
    int told = 0;
    const int cases = test::sample(20'000, 1'000'000);
    for (int i = 0; i < cases; ++i) {
        Condition of;
        of.kind = static_cast<Condition::Kind>(bits() % 3);
        of.x = between(-5.0, 5.0);
        of.y = between(-8.0, 8.0);
        of.level = between(-6.0, 6.0);
        of.error = 1e-14;
        of.make_linear();
        if (of.radius < 0.3) continue;
        const double beyond = of.radius * std::pow(10.0, between(-9.0, -0.01));
        State state;
        state.x.mid = between(-6.0, 6.0);
        state.y.mid = between(-6.0, 6.0);
        Form& moves = of.kind == Condition::below ? state.y : state.x;
        const double way = of.kind == Condition::below ? of.py : of.px;
        moves.mid = (beyond - of.radius - of.k) / way;
        const double apart = beyond * std::pow(10.0, between(-3.0, 0.0));
        moves.along = 0.9 * apart * between(-1.0, 1.0);
        moves.first = 0.05 * apart * between(-1.0, 1.0);
        moves.rest = 0.05 * apart;
        const bool begins = bits() % 2 == 0;
        HeadingForm found;
        if (!root_of(of, state, begins, 0.0, found)) continue;
        ++told;
        for (int k = 0; k < 8; ++k) {
            const double along = part(), first = part(), rest = part();
            const auto at = [&](const Form& form, double noise) {
                return static_cast<long double>(form.mid) + static_cast<long double>(form.along) * along +
                       static_cast<long double>(form.first) * first + static_cast<long double>(form.rest) * noise;
            };
            const long double level = -(way * at(moves, rest) + of.k);
            const long double radius = std::hypot(static_cast<long double>(of.a), static_cast<long double>(of.b));
            ASSERT_LT(std::abs(level), radius) << "case " << i << " has a car without a root";
            const long double aside = std::acos(level / radius);
            const long double heading =
                std::atan2(static_cast<long double>(of.b), static_cast<long double>(of.a)) + (begins ? aside : -aside);
            const long double base = std::atan2(static_cast<long double>(found.s), static_cast<long double>(found.c));
            const long double off = std::remainder(heading - base, turn);
            EXPECT_LE(std::abs(off - at(found.off, 0.0)), found.off.rest) << "case " << i;
        }
    }
    EXPECT_GT(told, cases / 2);
}

}  // namespace
}  // namespace snug::detail::proof
