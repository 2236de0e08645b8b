// Whether and where all cars of a box meet one obstacle in a move, or are parked.
#pragma once

#include <vector>

#include "full_steering/proof/spells.hpp"

namespace snug::detail::proof {

/// What comes of an obstacle in a move.
struct Meeting {
    enum What : unsigned char { never, contact, stuck, undecided } what = never;
    HeadingForm at;
    Touched touched;
    Failure failure;
};

inline Meeting cannot_tell(const Failure& failure) {
    Meeting meeting;
    meeting.what = Meeting::undecided;
    meeting.failure = failure;
    return meeting;
}

/// In the frame of x: y as x's heading turned by some Form.
inline Form off_from(const HeadingForm& x, const HeadingForm& y) {
    return (y.off + (y.angle - x.angle)).with_rest(2.0 * angle_error);
}

/// Room for the conditions of one stage.
struct Space {
    std::vector<Doing> first, last;
    std::vector<Spells> spells;
    std::vector<int> at;
    explicit Space(std::size_t most) : first(most), last(most), spells(most), at(most) {}
};

/// What is the same for all obstacles of a move.
struct BluntMove {
    BluntErrors errors;
    Blunt start;
    Blunt until;
};

/// The question to one obstacle.
struct Asked {
    const Obstacle& obstacle;
    Met met;
    const State& state;          ///< the cars at the start of the move
    const HeadingForm& until;    ///< they turn to here and no further
    bool until_contact = false;  ///< because another obstacle stops them
    const BluntMove& blunt;
    const Failure* passes = nullptr;  ///< a graze that is taken to pass
};

/// False: it may be that nothing was overlapped when the move began, but that is not sure (of an entry position).
bool meets(const Asked& asked, Space& space, Meeting& met);

}  // namespace snug::detail::proof
