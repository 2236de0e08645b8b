// The oracle checks itself: the closed form against tiny steps, on random poses and on whole strategies.
#include <gtest/gtest.h>

#include <cstdio>
#include <optional>

#include "dense_stepping.hpp"
#include "random_cases.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

/// A pose near the slot that touches nothing.
template <class Real>
std::optional<Place<Real>> free_place(Random& random, const Problem<Real>& problem) {
    const double L = double(problem.gap.length), W = double(problem.gap.width);
    for (int i = 0; i < 100; ++i) {
        Place<Real> place{Real(random.between(-L - 3, 4)), Real(random.between(-W, 4)),
                          Real(random.chance(0.5) ? random.between(-0.3, 0.8) : random.between(-3.2, 3.2))};
        if (i % 2 == 0)  // in or half in the slot
            place = {Real(random.between(-L, 0)), Real(random.between(-W, 0.5)), Real(random.between(-0.2, 0.2))};
        if (depth(problem.grown, place, problem.gap) < 0) return place;
    }
    return {};
}

TEST(Oracle, FirstContactAgreesWithTinySteps) {
    int contacts = 0, insides = 0, grazes = 0;
    const int cases = snug::test::sample(200, 20000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = random_case(11, std::uint64_t(i));
        const auto problem =
            make_problem<double>(asked.car, asked.slot.length, asked.slot.width, asked.driving.clearance);
        Random random(std::uint64_t(i) + 1);
        const auto place = free_place(random, problem);
        if (!place) continue;
        const double steer = random.between(0.2, 1.0) * asked.car.max_steer;
        double radius = asked.car.wheelbase / std::tan(steer) * (random.chance(0.5) ? 1 : -1);
        if (random.chance(0.1)) radius = std::numeric_limits<double>::infinity();
        const Path<double> path{*place, radius, random.chance(0.5) ? 1 : -1};
        const Drive<double> exact = drive(problem, path, {false, true});
        const double farthest = path.straight() ? 20.0 : 2 * std::numbers::pi * std::abs(radius);
        const double step = 1e-4;
        const Stepped<double> stepped = step_along(problem, path, farthest, step);
        const auto where = [&] { return command_line(asked) + " case " + std::to_string(i); };

        // A dip into a block between two steps is as shallow as step^2 / 8R: too shallow to be seen.
        const bool grazing =
            exact.graze < 1e-8 || (std::isfinite(exact.contact) && exact.contact < farthest &&
                                   depth(problem.grown, path.at(exact.contact + step), problem.gap) < 1e-8);
        if (grazing) {
            ++grazes;
            continue;
        }
        if (std::isfinite(exact.contact) && exact.contact < farthest) {
            ++contacts;
            EXPECT_NEAR(stepped.contact, exact.contact + step / 2, step) << where();
        } else {
            EXPECT_TRUE(std::isinf(stepped.contact)) << where() << " stepped into " << stepped.contact;
        }
        if (exact.inside_to - exact.inside_from > 3 * step && exact.inside_from < farthest - 3 * step) {
            ++insides;
            EXPECT_NEAR(stepped.inside_from, exact.inside_from, 1.01 * step) << where();
            EXPECT_NEAR(stepped.inside_to, std::min(exact.inside_to, farthest), 1.01 * step) << where();
        } else if (std::isinf(exact.inside_from)) {
            EXPECT_TRUE(std::isinf(stepped.inside_from)) << where() << " stepped inside at " << stepped.inside_from;
        }
    }
    std::printf("%d contacts, %d stretches inside, %d left out as grazing\n", contacts, insides, grazes);
    EXPECT_GT(contacts, cases / 4);
    EXPECT_GT(insides, cases / 100);
    EXPECT_LT(grazes, cases / 20 + 2);
}

TEST(Oracle, StrategyAgreesWithTinySteps) {
    int parked = 0, undecided = 0;
    const int cases = snug::test::sample(60, 2000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = random_case(12, std::uint64_t(i));
        const auto problem = make_problem<double>(asked.car, asked.slot.length, asked.slot.width,
                                                  asked.driving.clearance, asked.driving.enter);
        Random random(std::uint64_t(i) + 1);
        double heading = random.between(0, 0.7);
        for (int k = 0; k < 50 && i % 3 != 0 && !run(problem, heading, 12).parked(); ++k)
            heading = random.between(0, 0.7);
        const oracle::Run<double> exact = run(problem, heading, 12, true);
        // Stepping cannot see what is smaller than a step.
        const double step = 1e-4;
        bool fine = exact.graze < 1e-7 || std::abs(exact.least_top) < step;
        for (const Leg<double>& leg : exact.legs) fine = fine || leg.length < step;
        if (fine) {
            ++undecided;
            continue;
        }
        const int stepped = stepped_changes(problem, heading, 12, step);
        EXPECT_EQ(stepped, exact.parked() ? exact.changes : -1) << command_line(asked) << " heading " << heading;
        if (exact.parked()) ++parked;
    }
    std::printf("%d of %d parked, %d left out as too fine to step\n", parked, cases, undecided);
    EXPECT_GT(parked, cases / 20);
    EXPECT_LT(undecided, cases / 10 + 2);
}

TEST(Oracle, DoubleAndLongDoubleAgree) {
    const int cases = snug::test::sample(300, 20000);
    for (int i = 0; i < cases; ++i) {
        const Case asked = random_case(13, std::uint64_t(i));
        const double heading = Random(std::uint64_t(i)).between(0, 0.7);
        const auto fast = run(make_problem<double>(asked.car, asked.slot.length, asked.slot.width,
                                                   asked.driving.clearance, asked.driving.enter),
                              heading, 20);
        const auto fine = run(make_problem<long double>(asked.car, asked.slot.length, asked.slot.width,
                                                        asked.driving.clearance, asked.driving.enter),
                              static_cast<long double>(heading), 20, true);
        if (fine.graze < 1e-11L || std::abs(fine.least_top) < 1e-11L) continue;
        EXPECT_EQ(fast.parked(), fine.parked()) << command_line(asked) << " heading " << heading;
        EXPECT_EQ(fast.changes, fine.changes) << command_line(asked) << " heading " << heading;
    }
}

}  // namespace
}  // namespace oracle
