// Can the answers to Problems 1 and 2 be trusted? Random cars and slots, every answer judged by the oracle.
//
// SNUG_SOAK=1 runs thousands; SNUG_SEED, SNUG_FIRST and SNUG_CASES choose which, to go on where a soak ended or to look
// at one case again.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

#include "oracle/judge.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

std::uint64_t number(const char* variable, std::uint64_t otherwise) {
    const char* value = std::getenv(variable);
    return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

TEST(EntrySoak, TheOracleFindsNothingBetterNothingMoreAndNothingWrong) {
    const std::uint64_t seed = number("SNUG_SEED", 1), first = number("SNUG_FIRST", 0);
    const std::uint64_t cases = number("SNUG_CASES", std::uint64_t(snug::test::sample(60, 2400)));
    const bool soak = snug::test::is_set("SNUG_SOAK");

    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    Verdict total;
    std::map<std::string, std::pair<int, int>> kinds;  // cases, failing cases
    int parkable = 0, only_thin = 0, failing = 0, done = 0;
    const auto work = [&] {
        for (std::uint64_t i = next++; i < cases; i = next++) {
            const Case asked = random_case(seed, first + i);
            Verdict verdict;
            try {
                verdict = judge(asked, first + i);
            } catch (const std::exception& error) {
                verdict.failures.push_back(std::string("thrown: ") + error.what());
            }
            const std::lock_guard lock(mutex);
            total += verdict;
            if (verdict.seconds > 2) {
                std::printf("case %llu took the solver %.1f s: %s\n", static_cast<unsigned long long>(first + i),
                            verdict.seconds, command_line(asked).c_str());
                std::fflush(stdout);
            }
            parkable += verdict.parkable;
            only_thin += verdict.only_thin;
            ++kinds[asked.kind].first;
            ++done;
            if (!verdict.failures.empty()) {
                ++failing;
                ++kinds[asked.kind].second;
                std::printf("case %llu of seed %llu (%s, +%d changes): %s\n",
                            static_cast<unsigned long long>(first + i), static_cast<unsigned long long>(seed),
                            asked.kind.c_str(), asked.more_changes, command_line(asked).c_str());
                for (const std::string& failure : verdict.failures) std::printf("    %s\n", failure.c_str());
                std::fflush(stdout);
            }
            if (soak && done % 100 == 0) {
                std::printf("%d of %llu judged, %d failing\n", done, static_cast<unsigned long long>(cases), failing);
                std::fflush(stdout);
            }
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();

    std::printf("%d cases, %d parkable, %d of them only from ranges below 1e-4 rad\n", done, parkable, only_thin);
    for (const auto& [kind, counts] : kinds)
        std::printf("  %-9s %5d cases, %d failing\n", kind.c_str(), counts.first, counts.second);
    std::printf("%ld headings driven, %ld decided in long double, %ld dips searched\n", total.samples, total.decided,
                total.dips);
    std::printf("%ld edges of ranges, %ld within rounding; %ld other headings within rounding\n", total.edges,
                total.undecided_edges, total.undecided);
    std::printf("slowest answer %.3f s\n", total.seconds);
    EXPECT_EQ(failing, 0);
}

}  // namespace
}  // namespace oracle
