// One move of all cars of a box: to the obstacle they meet first, or until they are parked.
//
// How far round. A car may turn any way in one move, up to a full circle, and parks at the first moment at which its frame
// is inside; a circle without contact ends the run. But a car that comes to rest steeper than steepest_at_rest() has turned
// away and parks no more.
#pragma once

#include <limits>
#include <vector>

#include "full_steering/proof/meeting.hpp"

namespace snug::detail::proof {

/// What came of a box.
struct Outcome {
    enum What : unsigned char { none, parks, undecided } what = none;
    int move = 0;
    bool goes_on = false;  ///< none in the moves asked for, and more could follow
    Failure failure;
};

enum class After : unsigned char { moved, ended, grazed };

class Mover {
public:
    Mover(const ProofProblem& problem, int max_changes);

    /// Centre and heading at the entry position of all headings in the box.
    [[nodiscard]] State enter(const Box& box) const;
    /// For a box of which nothing is known yet.
    void forget() {
        doubtful_ = false;
        away_from_ = std::numeric_limits<int>::max();
    }
    /// Move outcome.move. `graze`: one that is taken to meet the curb, or to pass.
    After move(const State& state, State& then, Outcome& outcome, const Failure* graze = nullptr,
               bool meets_curb = false);

    [[nodiscard]] std::size_t moves() const { return moves_; }  ///< driven in all
    [[nodiscard]] bool doubtful() const { return doubtful_; }   ///< the box may be no entry position
    [[nodiscard]] int away_from() const { return away_from_; }  ///< see Box

private:
    const ProofProblem& problem_;
    Steering backward_;
    Steering forward_;
    double steepest_;
    std::vector<Met> likely_;  ///< what the last box met in each move
    Space space_;
    Meeting meeting_;
    std::size_t moves_ = 0;
    bool doubtful_ = false;
    int away_from_ = std::numeric_limits<int>::max();
    Form short_of_away_;  ///< by how much that box has not turned away
};

}  // namespace snug::detail::proof
