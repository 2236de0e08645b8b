// What processes tell each other arrives as it was, and whatever else arrives is refused.
#include "cluster/bytes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sample.hpp"
#include "snug/error.hpp"

namespace snug::cluster {
namespace {

SolvedBatch some_answers() {
    SolvedBatch solved = {{3, 1.9, {4.5, 4.6, 4.7}}, {}};
    for (const double length : {4.5, 4.6}) solved.answers.push_back(*solve(catalogue()[1], 2.0, length, {}));
    solved.answers[0].moves[0].contact.reset();
    solved.answers[1].entry.x = -0.0;
    return solved;
}

TEST(Bytes, AnswersArriveAsTheyWere) {
    const SolvedBatch solved = some_answers();
    const SolvedBatch back = solved_from(to_bytes(solved), 4);
    EXPECT_EQ(to_bytes(back), to_bytes(solved));
    EXPECT_EQ(back.cells.lengths, solved.cells.lengths);
    ASSERT_EQ(back.answers.size(), 2U);
    EXPECT_EQ(back.answers[0].moves.size(), solved.answers[0].moves.size());
    EXPECT_EQ(back.answers[0].moves.back().length, solved.answers[0].moves.back().length);
    EXPECT_FALSE(back.answers[0].moves[0].contact);
    EXPECT_TRUE(std::signbit(back.answers[1].entry.x));
}

TEST(Bytes, TasksArriveAsTheyWere) {
    std::vector<Car> cars = catalogue();
    cars.emplace_back(Outline::rounded(3.6, 0.8, 0.9, 0.4, 0.2), 2.6, 0.6, "round");
    const Task task = {
        {cars, {}, {}, {.max_changes = 7, .driving = {.clearance = 0.1, .enter = Enter::forward}}}, 3};
    const Task back = task_from(to_bytes(task));
    EXPECT_EQ(to_bytes(back), to_bytes(task));
    EXPECT_EQ(back.plan.cars, cars);
    EXPECT_EQ(back.plan.options.max_changes, 7);
}

TEST(Bytes, DamagedOnesAreRefusedOrReadSafely) {
    std::mt19937 random(1);
    const std::string task = to_bytes(Task{{catalogue(), {}, {}, {}}, 0});
    const std::string solved = to_bytes(some_answers());
    EXPECT_THROW(static_cast<void>(solved_from(solved, 3)), Error);  // there is no fourth car
    for (std::size_t size = 0; size < solved.size(); ++size)
        EXPECT_THROW(static_cast<void>(solved_from(solved.substr(0, size), 4)), Error);
    const auto damaged = [&](std::string bytes) {
        for (std::size_t count = 1 + random() % 4; count > 0; --count)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        return bytes;
    };
    for (int i = 0; i < snug::test::sample(20'000, 1'000'000); ++i) {
        try {
            const SolvedBatch read = solved_from(damaged(solved), 4);
            EXPECT_LE(read.answers.size(), read.cells.lengths.size());
            static_cast<void>(task_from(damaged(task)));
        } catch (const Error&) {
        }
    }
}

}  // namespace
}  // namespace snug::cluster
