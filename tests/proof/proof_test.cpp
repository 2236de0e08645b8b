// The proof of entry ranges, attacked.
#include "full_steering/proof/proof.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>

#include "compare.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

using snug::detail::Find;
using snug::detail::prove_ranges;
using snug::detail::Sliver;

constexpr std::size_t most_moves = 3'000'000;

ProvedRanges proved(const Case& asked, int max_changes, Find find) {
    return prove_ranges(proof_problem_of(asked), max_changes, find, {}, {}, most_moves);
}

double undecided(const ProvedRanges& answer) {
    return std::accumulate(answer.undecided.begin(), answer.undecided.end(), 0.0,
                           [](double sum, const Sliver& sliver) { return sum + sliver.max - sliver.min; });
}

Case rectangle_case(const snug::CarDimensions& car, double length, double width, double clearance = 0.0) {
    Case asked;
    asked.car = car;
    asked.slot.length = length;
    asked.slot.width = width;
    asked.driving.clearance = clearance;
    return asked;
}

void expect_range(const ProvedRanges& answer, double min, double max, int changes, double error) {
    for (const auto& range : answer.ranges)
        if (range.changes == changes && std::abs(range.min - min) < error && std::abs(range.max - max) < error) return;
    ADD_FAILURE() << "no range " << min << " to " << max << " with " << changes;
}

TEST(Proof, OfThePapersSlots) {
    const auto cars = table_of_cars();
    const auto mid = proved(rectangle_case(cars[0].second, 5.1, 2.2), 200, Find::fewest);
    ASSERT_EQ(mid.ranges.size(), 1U);
    expect_range(mid, 0.459779474171, 0.463598499884, 9, 2e-12);
    const auto zoe = proved(rectangle_case(cars[1].second, 4.5, 2.0), 200, Find::fewest);
    ASSERT_EQ(zoe.ranges.size(), 1U);
    expect_range(zoe, 0.485026374575, 0.486947112022, 18, 3e-12);
    const auto none = proved(rectangle_case(cars[1].second, 4.8, 1.84), 50, Find::fewest);
    EXPECT_TRUE(none.ranges.empty());
    EXPECT_EQ(none.proved_changes, 50);
    EXPECT_LT(undecided(none), 2e-10);
}

TEST(Proof, OfRangesThatAQuickSearchMissed) {
    const auto nine = proved(rectangle_case({1.6966474020276665, 4.2402365169053038, 0.88159571123864877,
                                             3.3376308396997216, 0.55338414573502426},
                                            5.4677352067547744, 3.4450439909676072),
                             200, Find::fewest);
    expect_range(nine, 0.6720359, 0.6720384, 9, 1e-7);
    const auto eleven = proved(rectangle_case({1.6583475745325489, 1.1038735380480147, 0.022468896530309673,
                                               0.96990573304500127, 0.83846274154652822},
                                              1.9331919065846606, 1.979006323047134),
                               200, Find::fewest);
    ASSERT_EQ(eleven.ranges.size(), 1U);
    expect_range(eleven, 0.948170604, 0.948177697, 11, 1e-8);
    const auto two = proved(rectangle_case({2.046231289248821, 2.4339476763744257, 2.561157263571463,
                                            2.4762755379543098, 0.51788495371386445},
                                           5.5432260074639812, 4.2031541170433613, 0.014278330291301534),
                            12, Find::all);
    expect_range(two, 0.92067, 0.92312, 12, 1e-5);
}

TEST(Proof, LeavesOutWhatRoundingDecides) {
    const auto tangent = proved(rectangle_case({2.3407496286221248, 1.6296087239970856, 0.25579434428378178,
                                                1.1524775538288863, 0.8189386842086086},
                                               3.1454425525267018, 2.6626856784916404),
                                200, Find::fewest);
    EXPECT_TRUE(tangent.ranges.empty());
    EXPECT_FALSE(tangent.undecided.empty());
    EXPECT_LT(undecided(tangent), 1e-10);
}

/// The cases of a test: SNUG_FIRST and SNUG_CASES choose a part. A soak says from time to time how far it is.
struct Cases {
    int first, end;
    explicit Cases(int all)
        : first(int(snug::test::number("SNUG_FIRST", 0))),
          end(first + int(snug::test::number("SNUG_CASES", std::uint64_t(all)))) {}
    static void tell(int done) {
        if (!snug::test::is_set("SNUG_SOAK") || done % 100 != 0) return;
        std::printf("%d cases\n", done);
        std::fflush(stdout);
    }
};

/// Proves each case and holds it against the oracle.
void attack(Case (*make)(std::uint64_t seed, std::uint64_t index), std::uint64_t seed, int cases, int headings,
            int max_changes) {
    long looked = 0, brink = 0, wide = 0;
    const Cases chosen(cases);
    for (int i = chosen.first; i < chosen.end; ++i) {
        Cases::tell(i - chosen.first);
        const Case asked = make(seed, std::uint64_t(i));
        const ProvedRanges fewest = proved(asked, max_changes, Find::fewest);
        const int limit = fewest.ranges.empty() ? max_changes : fewest.ranges.front().changes + asked.more_changes;
        const ProvedRanges all = proved(asked, limit, Find::all);
        Compare compare(asked, all, limit);
        compare.sample(headings, 0.37);
        for (const auto& range : fewest.ranges) compare.try_heading(range.min + 0.3 * (range.max - range.min));
        looked += compare.looked;
        brink += compare.undecided;
        wide += undecided(fewest) > 1e-9;
        for (const std::string& failure : compare.failures) ADD_FAILURE() << "case " << i << ": " << failure;
    }
    std::printf("%d cases, %ld headings, %ld on the brink, %ld cases with more than 1e-9 rad undecided\n",
                chosen.end - chosen.first, looked, brink, wide);
}

/// Cars nobody builds: short fronts, long rears, small circles; slots up to 2.7 times as wide.
Case odd_case(std::uint64_t seed, std::uint64_t index) {
    Random random(seed * 77777 + index * 0xBF58476D1CE4E5B9ULL + 5);
    Case chosen;
    chosen.car.wheelbase = random.between(0.8, 6);
    chosen.car.width = random.between(0.9, 2.6);
    chosen.car.front = chosen.car.wheelbase + random.between(0.02, 1.8);
    chosen.car.rear = random.between(0.02, 3.0);
    chosen.car.max_steer = random.between(0.2, 1.1);
    if (random.chance(0.2)) chosen.car.rear = chosen.car.front + random.between(0.1, 2.0);
    if (random.chance(0.3)) chosen.driving.enter = snug::Enter::forward;
    if (random.chance(0.3)) chosen.driving.clearance = random.between(0.001, 0.1);
    chosen.slot.length = chosen.car_length() + 2 * chosen.driving.clearance + random.unit() * random.between(0, 1.5);
    chosen.slot.width = (chosen.car.width + chosen.driving.clearance) * (1 + random.unit() * random.between(0, 1.7));
    chosen.more_changes = random.below(6);
    return chosen;
}

TEST(Proof, AgreesWithTheOracle) {
    const int headings = snug::test::is_set("SNUG_SOAK") ? 20'000 : 300;
    attack(random_case, 401, snug::test::sample(20, 5000), headings, 15);
}
TEST(Proof, AgreesWithTheOracleForOddCars) { attack(odd_case, 402, snug::test::sample(10, 5000), 300, 12); }
TEST(Proof, AgreesWithTheOracleForOutlines) { attack(random_outline_case, 403, snug::test::sample(10, 5000), 200, 10); }

/// The least over all headings of how far the car stays short of parking with up to `changes`.
double shortest(const Case& asked, int changes, double& at) {
    const Problem<double> problem = make_problem<double>(asked);
    Run<double> driven;
    const auto short_of = [&](double heading) {
        run(problem, heading, changes, driven, Look::at_depths_too);
        return driven.parked() ? std::min(driven.least(), 0.0) : driven.least();
    };
    double best = std::numeric_limits<double>::infinity();
    double step = 0.02;
    for (double heading = 0.02; heading < 1.1; heading += step) {
        const double value = short_of(heading);
        if (value < best) best = value, at = heading;
    }
    for (int level = 0; level < 5; ++level) {
        const double middle = at;
        step /= 5;
        for (int i = -5; i <= 5; ++i) {
            const double value = short_of(middle + i * step);
            if (value < best) best = value, at = middle + i * step;
        }
    }
    return best;
}

/// Lengths tuned until some depth only just dips below zero: the range there must be found, and hold.
TEST(Proof, FindsWhatOnlyJustParks) {
    const Cases chosen(snug::test::sample(60, 40000));
    int tuned = 0;
    for (int i = chosen.first; i < chosen.end; ++i) {
        Cases::tell(i - chosen.first);
        Case asked = i % 2 == 0 ? random_case(404, std::uint64_t(i)) : odd_case(404, std::uint64_t(i));
        Random random(std::uint64_t(i) + 9);
        const int changes = random.below(9);
        double at = 0.0;
        double fails = asked.car_length() + 2 * asked.driving.clearance, works = fails + 3.0;
        asked.slot.length = works;
        if (shortest(asked, changes, at) > 0) continue;
        for (int k = 0; k < 30; ++k) {
            asked.slot.length = (fails + works) / 2;
            (shortest(asked, changes, at) <= 0 ? works : fails) = asked.slot.length;
        }
        asked.slot.length = works + std::pow(10.0, random.between(-10.0, -4.0));
        if (shortest(asked, changes, at) > 0) continue;
        ++tuned;
        const ProvedRanges answer = proved(asked, changes, Find::all);
        Compare compare(asked, answer, changes);
        compare.try_heading(at);
        for (const auto& range : answer.ranges) compare.try_heading(0.5 * (range.min + range.max));
        for (const std::string& failure : compare.failures) ADD_FAILURE() << "tuned " << i << ": " << failure;
    }
    std::printf("%d slots tuned\n", tuned);
    EXPECT_GT(tuned, (chosen.end - chosen.first) / 10);
}

TEST(Proof, LeavesOverWhatTheLimitOfMovesCutsOff) {
    const auto cut_off = prove_ranges(proof_problem_of(rectangle_case(table_of_cars()[1].second, 4.5, 2.0)), 200,
                                      Find::all, {}, {}, 500);
    EXPECT_GT(undecided(cut_off), 0.1);
    EXPECT_LT(cut_off.moves, 1000U);
}

TEST(Proof, IsTheSameWithHints) {
    const auto problem = proof_problem_of(rectangle_case(table_of_cars()[0].second, 5.1, 2.2));
    const auto with = prove_ranges(problem, 200, Find::fewest, {9, {0.4597, 0.4636}});
    ASSERT_EQ(with.ranges.size(), 1U);
    expect_range(with, 0.459779474171, 0.463598499884, 9, 2e-12);
}

}  // namespace
}  // namespace oracle
