// The oracle checks itself: safe steps against tiny ones, on random poses and on whole strategies, for any outline.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <numeric>
#include <optional>
#include <utility>

#include "dense_stepping.hpp"
#include "random_outlines.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

/// Rectangles in the paper's slots, and outlines among any neighbours.
Case any_case(std::uint64_t seed, int i) {
    return i % 3 == 0 ? random_case(seed, std::uint64_t(i)) : random_outline_case(seed, std::uint64_t(i));
}

/// A pose near the slot that touches nothing.
std::optional<Place<double>> free_place(Random& random, const Problem<double>& problem) {
    const double length = problem.length, width = problem.width;
    for (int i = 0; i < 100; ++i) {
        Place<double> place{random.between(-length - 3, 4), random.between(-width, 4),
                            random.chance(0.5) ? random.between(-0.3, 0.8) : random.between(-3.2, 3.2)};
        if (i % 2 == 0)  // in or half in the slot
            place = {random.between(-length, 0), random.between(-width, 0.5),
                     random.between(-0.2, 0.2) * (random.chance(0.5) ? 1 : 0.1)};
        if (depth(problem, place) < 0) return place;
    }
    return {};
}

TEST(Oracle, ClippingAndSeparatingAxesAgreeOnWhatOverlaps) {
    int free = 0, overlapping = 0;
    for (int i = 0; i < snug::test::sample(20000, 1000000); ++i) {
        static Case asked;
        if (i % 100 == 0) asked = any_case(14, i / 100);
        const auto problem = make_problem<double>(asked);
        Random random(std::uint64_t(i) + 1);
        const Place<double> place{random.between(-problem.length - 3, 4), random.between(-problem.width - 1, 4),
                                  random.between(-3.2, 3.2)};
        const auto axes = depths(problem, place), clipped = sunk(problem, place);
        for (const Block block : {front_block, rear_block, curb_block}) {
            if (std::abs(axes[block]) < 1e-9) continue;
            EXPECT_EQ(axes[block] > 0, clipped[block] > 0) << command_line(asked) << " block " << block;
            ++(axes[block] > 0 ? overlapping : free);
        }
    }
    EXPECT_GT(free, overlapping / 10);
    EXPECT_GT(overlapping, free / 10);
}

TEST(Oracle, FirstContactAgreesWithTinySteps) {
    int contacts = 0, insides = 0, grazes = 0;
    const int cases = snug::test::sample(100, 20000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = any_case(11, i);
        const auto problem = make_problem<double>(asked);
        Random random(std::uint64_t(i) + 1);
        const auto place = free_place(random, problem);
        if (!place) continue;
        const double steer = random.between(0.2, 1.0) * asked.car.max_steer;
        double radius = asked.car.wheelbase / std::tan(steer) * (random.chance(0.5) ? 1 : -1);
        if (random.chance(0.1)) radius = std::numeric_limits<double>::infinity();
        const Path<double> path{*place, radius, random.chance(0.5) ? 1 : -1};
        const double farthest = path.straight() ? 20.0 : 2 * std::numbers::pi * std::abs(radius);
        const double contact = first_contact(problem, path, farthest);
        const double step = 1e-4;
        const Stepped<double> stepped = step_along(problem, path, farthest, step);
        const auto where = [&] { return command_line(asked) + " case " + std::to_string(i); };

        // A dip into something between two steps is as shallow as step^2 / 8R: too shallow to be seen.
        const double allowing = first_contact(problem, path, farthest, 1e-7);
        if (std::isfinite(contact) && !(allowing - contact < step)) {
            ++grazes;
            continue;
        }
        if (std::isfinite(contact)) {
            ++contacts;
            EXPECT_NEAR(stepped.contact, contact + step / 2, step) << where();
        } else {
            EXPECT_TRUE(std::isinf(stepped.contact)) << where() << " stepped into " << stepped.contact;
        }
        const double until = std::min(contact, farthest);
        const double from = first_parked(problem, path, until);
        if (std::isinf(from)) {
            EXPECT_TRUE(std::isinf(stepped.inside_from)) << where() << " stepped inside at " << stepped.inside_from;
            continue;
        }
        const Path<double> on{path.at(from), path.radius, path.direction};
        const double to = from + last_parked(problem, on, until - from);
        if (to - from > 3 * step) {
            ++insides;
            EXPECT_NEAR(stepped.inside_from, from, 1.01 * step) << where();
            EXPECT_NEAR(stepped.inside_to, to, 1.01 * step) << where();
        }
    }
    std::printf("%d contacts, %d stretches inside, %d left out as grazing\n", contacts, insides, grazes);
    EXPECT_GT(contacts, cases / 4);
    EXPECT_GT(insides, cases / 200);
    EXPECT_LT(grazes, cases / 20 + 2);
}

TEST(Oracle, StrategyAgreesWithTinySteps) {
    int parked = 0, undecided = 0;
    const int cases = snug::test::sample(60, 2000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = any_case(12, i);
        const auto problem = make_problem<double>(asked);
        Random random(std::uint64_t(i) + 1);
        double heading = random.between(0, 0.7);
        for (int k = 0; k < 50 && i % 4 != 0 && !run(problem, heading, 12).parked(); ++k)
            heading = random.between(0, 0.7);
        const oracle::Run<double> exact = run(problem, heading, 12, Look::at_depths_too);
        // Stepping cannot see what is smaller than a step.
        const double step = 1e-4;
        bool fine =
            !decide(make_problem<long double>(asked), heading, 12, 1e-7L).certain || std::abs(exact.least()) < step;
        for (const Leg<double>& leg : exact.legs) fine = fine || leg.contact < step;
        if (fine) {
            ++undecided;
            continue;
        }
        const int stepped = stepped_changes(problem, heading, 12, step);
        EXPECT_EQ(stepped, exact.parked() ? exact.changes : -1) << command_line(asked) << " heading " << heading;
        if (exact.parked()) ++parked;
    }
    std::printf("%d of %d parked, %d left out as too fine to step\n", parked, cases, undecided);
    EXPECT_GT(parked, cases / 40);
    EXPECT_LT(undecided, cases / 4 + 2);
}

TEST(Oracle, DoubleAndLongDoubleAgree) {
    int compared = 0;
    const int cases = snug::test::sample(150, 20000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = any_case(13, i);
        const double heading = Random(std::uint64_t(i)).between(0, 0.7);
        const auto fast = run(make_problem<double>(asked), heading, 20);
        const Decided fine = decide(make_problem<long double>(asked), heading, 20, 1e-11L);
        if (!fine.certain) continue;
        ++compared;
        EXPECT_EQ(fast.parked() ? fast.changes : -1, fine.count) << command_line(asked) << " heading " << heading;
    }
    EXPECT_GT(compared, cases * 3 / 4);
}

TEST(Oracle, OutlinesAreOfAllKinds) {
    std::array<int, 33> corners{};
    int set_back = 0, low = 0, conditions = 0, asymmetric = 0;
    const int cases = snug::test::sample(100, 3000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = random_outline_case(15, std::uint64_t(i));
        ++corners[asked.outline.size()];
        set_back += asked.slot.front_setback > 0;
        low += asked.slot.curb == snug::Curb::low;
        conditions += std::isfinite(asked.parked.heading) || std::isfinite(asked.parked.curb);
        const Polygon<double> polygon = polygon_of<double>(asked), other = polygon.mirrored();
        bool alike = false;
        for (const Vec<double>& p : polygon.corners)
            for (const Vec<double>& q : other.corners) alike = alike || length(p - q) < 1e-9;
        asymmetric += !alike;
    }
    const auto between = [&](std::ptrdiff_t few, std::ptrdiff_t many) {
        return std::accumulate(corners.begin() + few, corners.begin() + many + 1, 0);
    };
    EXPECT_GT(between(4, 4), cases / 40);
    for (const auto& [few, many] : {std::pair{5, 8}, {9, 16}, {17, 32}})
        EXPECT_GT(between(few, many), cases / 40) << few << " to " << many << " corners";
    for (const int some : {set_back, low, conditions, asymmetric}) EXPECT_GT(some, cases / 8);
}

}  // namespace
}  // namespace oracle
