// One place on several threads: the same answers, whoever computes what. The thread sanitizer runs these tests.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "all_maneuvers/workers.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

using detail::GivenUp;
using detail::in_order;
using detail::in_parts;
using detail::Watch;
using detail::Workers;

TEST(Workers, DoEveryPartOnce) {
    Workers workers(4);
    const Watch watch([] {}, &workers);
    for (const int parts : {1, 2, 3, 4, 5, 100, 1000}) {
        std::vector<std::atomic<int>> done(static_cast<std::size_t>(parts));
        in_parts(watch, true, parts, [&](int part, const Watch& inside) {
            ++done[static_cast<std::size_t>(part)];
            // Parts of a part are done where it is.
            const auto here = std::this_thread::get_id();
            int within = 0;
            in_parts(inside, true, 3, [&](int, const Watch&) {
                EXPECT_TRUE(parts == 1 || std::this_thread::get_id() == here);
                ++within;
            });
            EXPECT_TRUE(parts == 1 || within == 3);
        });
        for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1) << "of " << parts;
    }
}

TEST(Workers, TakeInOrderWhatIsPrepared) {
    Workers workers(3);
    const Watch watch([] {}, &workers);
    std::mt19937_64 random(1);
    for (int run = 0; run < test::sample(200, 2000); ++run) {
        const int steps = static_cast<int>(random() % 60);
        std::vector<int> prepared(static_cast<std::size_t>(steps), 0), taken;
        in_order(
            watch, true, steps, [&](int step) { prepared[static_cast<std::size_t>(step)] += step + 1; },
            [&](int step) {
                EXPECT_EQ(prepared[static_cast<std::size_t>(step)], step + 1);
                taken.push_back(step);
            });
        std::vector<int> all(static_cast<std::size_t>(steps));
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(taken, all) << "run " << run;
    }
}

TEST(Workers, EndWithWhatIsThrown) {
    Workers workers(4);
    const Watch watch([] {}, &workers);
    for (int bad = 0; bad < 40; ++bad) {
        const auto fail_at = [&](int step) {
            if (step == bad) throw std::runtime_error(std::to_string(step));
        };
        const auto message = [&](const std::function<void()>& act) {
            try {
                act();
            } catch (const std::runtime_error& error) {
                return std::string(error.what());
            }
            return std::string("nothing");
        };
        EXPECT_EQ(message([&] { in_parts(watch, true, 40, [&](int part, const Watch&) { fail_at(part); }); }),
                  std::to_string(bad));
        EXPECT_EQ(message([&] { in_order(watch, true, 40, fail_at, [](int) {}); }), std::to_string(bad));
        EXPECT_EQ(message([&] {
                      in_order(
                          watch, true, 40, [](int) {}, fail_at);
                  }),
                  std::to_string(bad));
    }
}

TEST(Workers, OnlyTheThreadThatAsksWatches) {
    Workers workers(3);
    const auto asks = std::this_thread::get_id();
    int looks = 0;
    const Watch watch(
        [&] {
            EXPECT_EQ(std::this_thread::get_id(), asks);
            if (++looks > 100) throw GivenUp{};
        },
        &workers);
    EXPECT_THROW(in_parts(watch, true, 1'000'000'000, [](int, const Watch& inside) { inside(); }), GivenUp);
    EXPECT_EQ(looks, 101);
}

struct Case {
    Street street;
    Pose start;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const double road : {2.2, 2.5, 3.5}) {
        Street street;
        street.length = 5.2;
        street.width = 2.0;
        street.road = road;
        all.push_back({street, {2.0, road / 2.0, 0.0}});
    }
    for (const auto& [width, road] : {std::pair{2.1, 3.5}, std::pair{2.3, 5.0}}) {
        Street street;
        street.length = 5.0;
        street.width = width;
        street.road = road;
        street.angle = 1.5707963267948966;
        street.enter = Enter::forward;
        all.push_back({street, standard_start(street, *find_car("renault-zoe"))});
    }
    return all;
}

std::string told(const ParkAnswer& answer) {
    std::string text = std::to_string(answer.lower_bound) + " " +
                       std::to_string(answer.direction_changes.value_or(-1)) + " " + std::to_string(answer.spacing) +
                       (answer.impossible ? " impossible" : "");
    std::vector<Maneuver> ways = answer.alternatives;
    if (answer.maneuver) ways.push_back(*answer.maneuver);
    for (const Maneuver& way : ways) {
        text += "\n";
        for (const Move& move : way.moves) text += std::to_string(1e6 * move.length) + " ";
    }
    return text;
}

TEST(ParkOnThreads, AnswersAreTheSame) {
    const Car car = *find_car("renault-zoe");
    std::vector<Case> some = cases();
    some.resize(static_cast<std::size_t>(test::sample(5, 5, 2)));
    for (const Case& asked : some) {
        ParkOptions options;
        options.roomiest = asked.street.angle != 0.0;
        options.resolution = options.roomiest ? 0.02 : test::sample(0, 0, 1) * 0.01;
        const std::string alone = told(park(car, street_place(asked.street), asked.start, options));
        for (const int threads : {0, 3}) {
            options.threads = threads;
            EXPECT_EQ(told(park(car, street_place(asked.street), asked.start, options)), alone) << threads;
        }
    }
}

TEST(ParkOnThreads, EndWhenTheCallerHasHadEnough) {
    const Car car = *find_car("renault-zoe");
    const Case asked = cases().front();
    for (const int enough : {1, 10, 100, 300, 1000}) {
        ParkOptions options;
        options.resolution = 0.02;
        options.threads = 3;
        int told = 0;
        options.progress = [&](const ParkProgress&) { return ++told < enough; };
        const ParkAnswer answer = park(car, street_place(asked.street), asked.start, options);
        EXPECT_EQ(answer.cancelled, told >= enough);
        EXPECT_LE(answer.lower_bound, 7);
    }
}

TEST(ParkOnThreads, AnImpossibleNumberIsRefused) {
    const Car car = *find_car("renault-zoe");
    ParkOptions options;
    for (const int threads : {-1, 1025}) {
        options.threads = threads;
        EXPECT_THROW((void)park(car, street_place(cases().front().street), cases().front().start, options), Error);
    }
}

}  // namespace
}  // namespace snug
