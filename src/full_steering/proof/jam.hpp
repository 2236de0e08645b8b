// Cars that jam: between something behind and something ahead they move too little to come anywhere.
//
// Take what blocks the way back and what blocks the way ahead, each as the one condition of its obstacle that does not hold
// while all others do, and let u and v be what they still lack. Turning backward by b uses up at least a b of u and adds at
// most a' b to v; turning forward by f uses up at least e f of v and adds at most e' f to u. With p = u / a and q = v / e,
//     p falls by b and q rises by at most k b, or q falls by f and p rises by at most m f, where k = a' / e and m = e' / a.
// In so many moves the cars turn no more than if each of them used up all there is. (A turn left for later adds less: what
// it adds comes later, too.) Where k m < 1, all turning that is ever to come is bounded: p + q sqrt(m / k) falls either way,
// by (1 - sqrt(k m)) times b or sqrt(m / k) f. Where within that bound the rates are as said, the conditions that hold go on
// holding, and the cars stay steeper than they fit between entry side and curb, or too high, none of them parks.
//
// One more condition may not hold yet if turning either way lets it hold sooner: until it does, for a turn of at most
// some z, that way is not blocked.
#pragma once

#include <vector>

#include "full_steering/proof/gaps.hpp"

namespace snug::detail::proof {

enum class Jammed : unsigned char { no, for_now, for_good };

class Jam {
public:
    explicit Jam(const ProofProblem& problem);

    /// Before a move: do none of the cars park in `moves` moves, this one included, or in any number? An entry position
    /// that is none counts as one that does not. Only asked where it looks like that, or `anyway`.
    [[nodiscard]] Jammed jams(const State& state, const Steering& backward, const Steering& forward, int moves,
                              bool anyway) const;

private:
    std::vector<Point> frame_;
    double radius_;
    double size_;
    double least_;  ///< a heading: steeper above parallel the frame does not fit
};

}  // namespace snug::detail::proof
