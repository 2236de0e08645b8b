// What comes of a box, driven move after move: all its headings park in move n and in none before; none parks in the moves
// asked for; or something cannot be told.
#pragma once

#include <vector>

#include "full_steering/proof/move.hpp"

namespace snug::detail::proof {

class Driver {
public:
    Driver(const ProofProblem& problem, int max_changes)
        : mover_(problem, max_changes), trail_(static_cast<std::size_t>(max_changes) + 2) {}

    /// With at most `limit` changes. The box is told what may be wrong with it.
    Outcome look(Box& box, int limit);
    Outcome look(const Starts& starts, int limit);

    /// The last box before move n, and how it may have come that far in two ways.
    [[nodiscard]] const State& before(int n) const { return trail_[static_cast<std::size_t>(n)]; }
    [[nodiscard]] bool forked() const { return forks_ > 0; }

    [[nodiscard]] std::size_t boxes() const { return boxes_; }  ///< looked at in all
    [[nodiscard]] std::size_t moves() const { return mover_.moves(); }

private:
    Outcome follow(int n);
    Outcome both_ways(const Outcome& fork);
    bool jams(int n, Outcome& outcome) const;

    static constexpr int most_forks = 8;  ///< in a box
    Mover mover_;
    std::vector<State> trail_;  ///< the box before each move
    std::size_t boxes_ = 0;
    int limit_ = 0;
    int forks_ = 0;
};

}  // namespace snug::detail::proof
