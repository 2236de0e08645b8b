// From the lattice to a maneuver a person can drive: few arcs and straight lines, each checked by exact contact.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fewest_lattice.hpp"
#include "snug/car.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug::detail {

/// A point in characteristic coordinates: a = x - r sin(heading), b = x + r sin(heading). [m]
struct Characteristic {
    double a = 0.0;
    double b = 0.0;
};

/// A way out of the slot along the lattice.
struct LatticePath {
    /// Driving one way; each move starts where the last one ended. The points never fall in a or b driving forward,
    /// never rise backward.
    struct Leg {
        Direction direction = Direction::forward;
        std::vector<Characteristic> points;
    };
    double z = 0.0;  ///< height at the start [m]
    std::vector<Leg> legs;
};

/// Puts the car where it starts.
using Start = std::function<void(Heights&)>;

/// Fewest direction changes, up to `most`, with which the car leaves along the lattice of upper bounds; empty if none.
std::optional<int> changes_along(const Lattice& lattice, const Start& start, int most, const Watch& watch);

/// A path with so many changes; empty if there is none.
std::optional<LatticePath> path_along(const Lattice& lattice, const Start& start, int changes, const Watch& watch);

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
