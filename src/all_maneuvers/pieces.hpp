// From a way along the lattice to a maneuver a person can drive: few arcs and straight lines, each checked by exact
// contact.
#pragma once

#include <vector>

#include "all_maneuvers/path.hpp"
#include "all_maneuvers/right_side.hpp"
#include "contact/entering.hpp"
#include "snug/car.hpp"
#include "snug/contact.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// The question in the entering frame (entering.hpp), where every car enters backward into a slot on the right.
struct Ground {
    Car car;
    Slot slot;
    Driving driving;  ///< as asked, with the way in
    Problem problem;
    RightSide side;  ///< of the body

    Ground(const Car& asked, const Slot& asked_slot, const Driving& asked_driving, const Parked& parked = {});

    /// Where the body's corner in front on the right is: once it has passed the front neighbour's corner p, the car is out.
    [[nodiscard]] Point front_corner(const Pose& pose) const;
    /// And how far above p.
    [[nodiscard]] double above_p(const Pose& pose) const { return front_corner(pose).y + problem.front_setback; }
};

/// What the car meets with this steering.
FirstContact contact_on(const Ground& ground, const Pose& start, Direction direction, double steering_angle);

/// How much is made of a path.
enum class Finish {
    checked,  ///< free of contact, pieces as they come
    tidy,     ///< few pieces, full or straight steering where that costs nothing
    at_p,     ///< few pieces, and the body's front corner on the right passes p if it can
};

/// The path as pieces that meet nothing, up to where that corner is level with p and the way on is free. Empty when the
/// way out that the lattice shows meets something between its points.
std::vector<Move> leaving_moves(const Ground& ground, const LatticePath& path, Finish finish, const Watch& watch);

/// The same way driven back.
std::vector<Move> turned_round(const std::vector<Move>& moves);

/// The moves with the contacts that end them.
std::vector<Move> with_contacts(const Ground& ground, std::vector<Move> moves);

/// Whether a way out keeps to what entering nose first asks: the nose's corner on the curb side (in the entering frame the
/// tail's) comes out once, in the last move, and nowhere before, on the arcs as little as at their ends.
bool nose_comes_out_once(const Ground& ground, const std::vector<Move>& leaving);

/// Whether the way out ends with the corner at p.
bool ends_at_p(const Ground& ground, const std::vector<Move>& moves);

}  // namespace snug::detail
