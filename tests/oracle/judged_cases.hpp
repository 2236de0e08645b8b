// Judges many cases on all cores, and says which are wrong.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

#include "judge.hpp"
#include "sample.hpp"

namespace oracle {

/// Cases `0` to `usual` of seed 1, or those that SNUG_SEED, SNUG_FIRST and SNUG_CASES name.
inline void judge_all(Case (*make)(std::uint64_t seed, std::uint64_t index), int usual, const JudgeOptions& options) {
    const std::uint64_t seed = snug::test::number("SNUG_SEED", 1), first = snug::test::number("SNUG_FIRST", 0);
    const std::uint64_t cases = snug::test::number("SNUG_CASES", std::uint64_t(usual));

    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    Verdict total;
    std::map<std::string, std::pair<int, int>> kinds;  // cases, failing cases
    int parkable = 0, only_thin = 0, failing = 0, done = 0, of_search_alone = 0;
    const auto work = [&] {
        for (std::uint64_t i = next++; i < cases; i = next++) {
            const Case asked = make(seed, first + i);
            Verdict verdict;
            try {
                verdict = judge(asked, first + i, options);
                // The search alone does not say that it is right.
                JudgeOptions with_proof = options;
                with_proof.prove = true;
                if (!options.prove && !verdict.failures.empty()) {
                    const std::vector<std::string> of_search = std::move(verdict.failures);
                    verdict = judge(asked, first + i, with_proof);
                    if (verdict.failures.empty()) {
                        const std::lock_guard lock(mutex);
                        ++of_search_alone;
                        std::printf("case %llu: only the proof mends that %s\n",
                                    static_cast<unsigned long long>(first) + i, of_search.front().c_str());
                    }
                }
            } catch (const std::exception& error) {
                verdict.failures.push_back(std::string("thrown: ") + error.what());
            }
            const std::lock_guard lock(mutex);
            total += verdict;
            parkable += verdict.parkable;
            only_thin += verdict.only_thin;
            ++kinds[asked.kind].first;
            ++done;
            if (!verdict.failures.empty()) {
                ++failing;
                ++kinds[asked.kind].second;
                std::printf("case %llu of seed %llu (%s, +%d changes): %s\n",
                            static_cast<unsigned long long>(first) + i, static_cast<unsigned long long>(seed),
                            asked.kind.c_str(), asked.more_changes, command_line(asked).c_str());
                for (const std::string& failure : verdict.failures) std::printf("    %s\n", failure.c_str());
                std::fflush(stdout);
            }
            if (done % 100 == 0) {
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
    EXPECT_EQ(failing, 0);
    EXPECT_LE(of_search_alone, 1 + done / 1000);
    EXPECT_GT(parkable, done / 4);
}

}  // namespace oracle
