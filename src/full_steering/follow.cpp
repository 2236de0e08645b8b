#include "full_steering/follow.hpp"

#include <algorithm>

namespace snug::detail {

namespace {

/// So many runs are worth a vector.
constexpr std::size_t worth_a_vector = 4;

void follow(const FullSteering& steering, Run& run, int limit, std::vector<FullMove>& moves) {
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

}  // namespace

bool in_vectors(const FullSteering& steering) {
    const Problem& problem = steering.problem;
    return steering.backward.rectangle && problem.at_curb == problem.body && steering.height_decides;
}

void follow_one_by_one(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest,
                       std::vector<FullMove>& moves) {
    for (Run& run : runs) {
        follow(steering, run, limit, moves);
        if (fewest) limit = std::min(limit, run.changes);
    }
}

void Follow::drive(std::vector<Run>& runs) {
    if (vectors && runs.size() >= worth_a_vector) {
        follow_in_lanes(steering, runs, limit, fewest, moves);
    } else {
        follow_one_by_one(steering, runs, limit, fewest, moves);
    }
    if (fewest)
        for (const Run& run : runs) limit = std::min(limit, run.changes);
    for (Run& run : runs) {
        if (run.changes > limit) run.changes = never;
        driven += std::min(run.count, static_cast<std::size_t>(limit) + 1);
    }
}

}  // namespace snug::detail
