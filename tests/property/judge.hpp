// Judges one answer to Problems 1 and 2 with the oracle: every heading sampled, every range entered, every maneuver
// followed. Shares nothing with the solver but the types it answers with.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "oracle/random_cases.hpp"
#include "snug/snug.hpp"

namespace oracle {

/// What was looked at and what was wrong.
struct Verdict {
    std::vector<std::string> failures;
    long samples = 0;          // strategies driven in double, to screen
    long decided = 0;          // and in long double, where the screening disagreed
    long edges = 0;            // edges of reported ranges
    long undecided_edges = 0;  // of them those within 1e-12 of another outcome and off by that
    long undecided = 0;        // other headings so
    long dips = 0;             // places where the depth was minimised
    double seconds = 0;        // the slowest answer
    bool parkable = false;
    double thinnest = 10;    // the thinnest reported subrange
    bool only_thin = false;  // no best subrange is wider than the paper's sampling of 1e-4 rad

    Verdict& operator+=(const Verdict& other) {
        failures.insert(failures.end(), other.failures.begin(), other.failures.end());
        samples += other.samples;
        decided += other.decided;
        edges += other.edges;
        undecided_edges += other.undecided_edges;
        undecided += other.undecided;
        dips += other.dips;
        seconds = std::max(seconds, other.seconds);
        return *this;
    }
};

struct JudgeOptions {
    double heading_step = 1e-5;   // [rad]
    int unparkable_changes = 40;  // changes tried at every sample of a slot the solver calls too small; 200 at some
};

/// Asks the solver about the case and judges what it says.
Verdict judge(const Case& asked, std::uint64_t seed, const JudgeOptions& options = {});

}  // namespace oracle
