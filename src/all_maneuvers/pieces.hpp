// From a way along the lattice to a maneuver a person can drive: few arcs and straight lines, each checked by exact
// contact.
#pragma once

#include <vector>

#include "all_maneuvers/path.hpp"
#include "snug/car.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// The question in the entering frame (entering.hpp), where every car enters backward into a slot on the right.
struct Ground {
    Car car;
    Slot slot;
    double clearance;
    Enter enter;

    Ground(const Car& asked, const Slot& asked_slot, Enter way_in, double keeps);
};

/// How much is made of a path.
enum class Finish {
    checked,  ///< free of contact, pieces as they come
    tidy,     ///< few pieces
    at_p,     ///< few pieces, and the front-right corner of the frame (grown by the clearance) passes p if it can
};

/// The path as pieces that meet nothing, up to where that corner is level with p and the way on is free. Empty when the
/// way out that the lattice shows meets something between its points.
std::vector<Move> leaving_moves(const Ground& ground, const LatticePath& path, Finish finish, const Watch& watch);

/// The same way driven back.
std::vector<Move> turned_round(const std::vector<Move>& moves);

/// The moves with the contacts that end them.
std::vector<Move> with_contacts(const Ground& ground, std::vector<Move> moves);

/// Whether the way out ends with the corner at p.
bool ends_at_p(const Ground& ground, const std::vector<Move>& moves);

}  // namespace snug::detail
