// Cars that jam: between something behind and something ahead they move less and less, and come nowhere.
//
// Take what blocks the way back and what blocks the way ahead, each as the one condition of its obstacle that does not hold
// while all others do, and let u and v be what they still lack. Turning backward by b uses up at least a b of u and adds at
// most a' b to v; turning forward by f uses up at least e f of v and adds at most e' f to u. With p = u / a and q = v / e,
//     p falls by b and q rises by at most k b, or q falls by f and p rises by at most m f, where k = a' / e and m = e' / a.
// Where k m < 1, p + q sqrt(m / k) falls either way, by (1 - sqrt(k m)) times b or sqrt(m / k) f. So all the turning that
// is ever to come, with any number of moves, is bounded. Where within that bound the rates are as said, the conditions
// that hold go on holding and the car is not parked, it never is.
//
// One more condition may not hold yet if turning either way lets it hold sooner: until it does, for a turn of at most
// some z, that way is not blocked.
#pragma once

#include "full_steering/proof/gaps.hpp"

namespace snug::detail::proof {

class Jam {
public:
    explicit Jam(const ProofProblem& problem)
        : frame_(problem.frame), radius_(problem.radius), size_(size_of(frame_)) {}

    /// Before a move that is not the first. False where it cannot be told.
    [[nodiscard]] bool jams(const State& state, const Steering& backward, const Steering& forward) const;

private:
    std::vector<Point> frame_;
    double radius_;
    double size_;
};

}  // namespace snug::detail::proof
