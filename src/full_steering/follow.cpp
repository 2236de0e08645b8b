#include "full_steering/follow.hpp"

#include <algorithm>

namespace snug::detail {

namespace {

/// So many runs are worth a vector.
constexpr std::size_t worth_a_vector = 4;

}  // namespace

bool in_vectors(const FullSteering& steering) {
    const Problem& problem = steering.problem;
    return steering.backward.per_quarter == 1 && problem.at_curb == problem.body && steering.height_decides;
}

void follow_alone(const FullSteering& steering, Run& run, int limit, std::vector<FullMove>& moves) {
    run.first = moves.size();
    FullSteeringRun car(steering, run.heading);
    bool stuck = false;
    for (int n = 0; n <= std::min(run.last, limit); ++n) {
        FullMove& move = moves.emplace_back();
        car.drive<true>(move);
        if (move.depth <= 0.0 && !run.past_parked) {
            run.changes = n;
            break;
        }
        if (ends(move, stuck)) break;
        stuck = move.stuck;
    }
    run.count = moves.size() - run.first;
}

void Follow::drive(std::vector<Run>& runs) {
    if (vectors && runs.size() >= worth_a_vector) {
        follow_in_lanes(steering, runs, limit, fewest, moves);
    } else {
        int least = limit;
        for (Run& run : runs) {
            follow_alone(steering, run, least, moves);
            if (fewest) least = std::min(least, run.changes);
        }
    }
    if (fewest)
        for (const Run& run : runs) limit = std::min(limit, run.changes);
    for (Run& run : runs) {
        if (run.changes > limit) run.changes = never;
        driven += std::min(run.count, static_cast<std::size_t>(limit) + 1);
    }
}

}  // namespace snug::detail
