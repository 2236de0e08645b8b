// Wild but valid questions: no crash, no end of work, and answers that make sense.
#include <gtest/gtest.h>

#include <cstdio>

#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace oracle {
namespace {

double wild_length(Random& random) {
    switch (random.below(5)) {
        case 0: return std::pow(10.0, random.between(-6, 6));
        case 1: return random.chance(0.5) ? 1e-6 : 1e6;
        case 2: return double(1 + random.below(6));
        default: return random.between(0.1, 6);
    }
}

Case wild_case(std::uint64_t i) {
    constexpr double degree = std::numbers::pi / 180;
    Random random(i);
    static const std::vector<Case> cases = [] {
        std::vector<Case> made;
        for (std::uint64_t k = 0; k < 100; ++k) made.push_back(random_case(41, k));
        return made;
    }();
    Case asked = cases[std::size_t(i) % cases.size()];
    const bool whole = random.chance(0.3);
    for (double* length : {&asked.car.width, &asked.car.front, &asked.car.rear, &asked.car.wheelbase})
        if (whole || random.chance(0.2)) *length = wild_length(random);
    if (random.chance(0.4))
        asked.car.max_steer =
            (random.chance(0.2) ? (random.chance(0.5) ? 0.1001 : 89.8999) : random.between(0.11, 89.89)) * degree;
    if (whole && random.chance(0.7)) {
        asked.slot.length = std::clamp(asked.car_length() * random.between(0.9, 2), 1e-6, 1e6);
        asked.slot.width = std::clamp(asked.car.width * random.between(0.9, 2), 1e-6, 1e6);
    }
    if (random.chance(0.2)) asked.slot.length = wild_length(random);
    if (random.chance(0.2)) asked.slot.width = wild_length(random);
    if (random.chance(0.1)) asked.slot.length = asked.car_length();
    if (random.chance(0.1)) asked.slot.width = asked.car.width;
    asked.slot.length = std::clamp(asked.slot.length, 1e-6, 1e6);
    asked.slot.width = std::clamp(asked.slot.width, 1e-6, 1e6);
    if (random.chance(0.1)) asked.slot.corner = {random.between(-1e9, 1e9), random.between(-1e9, 1e9)};
    if (random.chance(0.1)) asked.driving.clearance = random.between(0, 3);
    asked.car_name.clear();
    return asked;
}

TEST(Fuzz, WildQuestionsAreAnsweredAndMakeSense) {
    int parkable = 0, given_up = 0, refused = 0;
    constexpr int patience = 10;  // each of a million moves
    int most_reports = 0;
    const int questions = snug::test::sample(200, 100000, 10);
    for (int i = 0; i < questions; ++i) {
        const Case asked = wild_case(std::uint64_t(i));
        Random random(std::uint64_t(i) + 5);
        snug::EntryOptions options;
        options.driving = asked.driving;
        if (random.chance(0.5)) options.max_changes = random.below(random.chance(0.1) ? 2000 : 40);
        if (random.chance(0.3)) options.min_range = random.between(0, 0.1);
        std::string line = command_line(asked);
        if (options.max_changes) line += " --max-changes " + std::to_string(*options.max_changes);
        if (options.min_range > 0) line += " --min-range " + std::to_string(options.min_range);
        // The work is counted in reports of progress, and nothing may go on after it has been given up.
        int reports = 0, after = 0;
        options.progress = [&](double) {
            after += reports > patience;
            return ++reports <= patience;
        };
        snug::Answer answer;
        try {
            answer = snug::entry(snug::Car(asked.car), snug::Slot(asked.slot), options);
        } catch (const snug::Error&) {
            ++refused;
            continue;
        }
        EXPECT_LE(after, 1) << "question " << i << " goes on though it was given up: " << line;
        most_reports = std::max(most_reports, reports);
        if (answer.cancelled) {
            ++given_up;
            continue;
        }
        EXPECT_EQ(answer.parkable(), answer.direction_changes.has_value()) << line;
        EXPECT_EQ(answer.parkable(), answer.maneuver.has_value()) << line;
        EXPECT_EQ(answer.parkable(), !answer.ranges.empty()) << line;
        double last = 0;
        for (const snug::HeadingRange& r : answer.ranges) {
            EXPECT_TRUE(last <= r.min && r.min <= r.max && r.max <= std::numbers::pi / 2) << line;
            // A stretch that is wide enough may hold headings that need fewer changes than all of it.
            if (options.min_range == 0) {
                EXPECT_GE(r.direction_changes, answer.direction_changes.value_or(0)) << line;
            }
            last = r.max;
        }
        if (!answer.maneuver) continue;
        ++parkable;
        // The 1e-9 m are for cars of ordinary size near the origin of the world.
        const double size = std::max({asked.car_length(), asked.car.width, asked.slot.length, asked.slot.width,
                                      asked.car.wheelbase / std::tan(asked.car.max_steer)});
        const bool ordinary = size < 50 && asked.car.width > 0.1 && asked.car_length() > 0.5 &&
                              std::hypot(asked.slot.corner.x, asked.slot.corner.y) < 1e3 &&
                              *answer.direction_changes < 60;
        if (ordinary)
            for (const std::string& fault : faults(asked, *answer.maneuver, *answer.direction_changes))
                ADD_FAILURE() << line << "\n    " << fault;
        else
            EXPECT_EQ(answer.maneuver->direction_changes(), *answer.direction_changes) << line;
        const double heading = random.between(0, 1.57);
        snug::MaxSteerOptions run_options;
        run_options.max_changes = options.max_changes.value_or(200);
        (void)snug::max_steer(snug::Car(asked.car), snug::Slot(asked.slot), heading, run_options);
    }
    std::printf("%d questions, %d parkable, %d given up, %d refused; at most %d reports of progress\n", questions,
                parkable, given_up, refused, most_reports);
    EXPECT_GT(parkable, questions / 20);
    EXPECT_LT(refused, questions / 2);
}

}  // namespace
}  // namespace oracle
