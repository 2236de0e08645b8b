// One move of all cars of a box: to the obstacle they meet first, or until they are parked.
//
// A car that comes to rest steeper below parallel than it can be parked, or stands too high for how far it can still sink,
// parks no more.
#pragma once

#include <array>
#include <vector>

#include "full_steering/proof/jam.hpp"
#include "full_steering/proof/meeting.hpp"
#include "full_steering/proof/sinking.hpp"

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
    /// The same for starts off the entry position.
    [[nodiscard]] State enter(const Starts& starts) const;
    /// For a box of which nothing is known yet.
    void forget() { doubtful_ = false; }
    /// Move outcome.move. `graze`: one that is taken to meet the curb, or to pass.
    After move(const State& state, State& then, Outcome& outcome, const Failure* graze = nullptr,
               bool meets_curb = false);

    /// See Jam.
    [[nodiscard]] Jammed jams(const State& state, int moves, bool anyway) const {
        return jam_.jams(state, steerings_[0], steerings_[1], moves, anyway);
    }

    [[nodiscard]] std::size_t moves() const { return moves_; }  ///< driven in all
    [[nodiscard]] bool doubtful() const { return doubtful_; }   ///< the box may be no entry position

private:
    const ProofProblem& problem_;
    std::array<Steering, 2> steerings_;  ///< backward, forward
    double steepest_;
    Sinking sinking_;
    Jam jam_;
    std::vector<Met> likely_;  ///< what the last box met in each move
    Space space_;
    Meeting meeting_;
    std::size_t moves_ = 0;
    bool doubtful_ = false;
};

}  // namespace snug::detail::proof
