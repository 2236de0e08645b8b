// Lower bounds: what sets leave of a lattice when only maneuvers with so many changes count.
#pragma once

#include <cstddef>
#include <optional>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"

namespace snug::detail::sets {

/// More memory would be needed than anybody expects; what is known by then stands.
struct TooLarge {};

bool has_no_cells(const Limits& limits);

/// Whether the sets of so many changes, both ways, can be held several times over.
bool fit(const OuterLattice& lattice, int changes);

/// With how many changes the sets around the parked poses reach the start: no maneuver has fewer.
struct Counted {
    int changes = 0;          ///< more than `most` when they do not
    bool impossible = false;  ///< they never will
    BothWays<Pairs> sets;     ///< with none, with one, and so on, if they are to be kept and fit
};
Counted count_from_below(const OuterLattice& lattice, int most, bool keep, const Watch& watch);

/// What is left of a lattice when only maneuvers with so many changes count: where the car can be in every move of leaving.
struct Left {
    double h = 0.0;
    BothWays<Limits> moves;
    Layer hull_of_all;
};
std::size_t bytes_of(const Left& left);
Layer hull_of(const BothWays<Limits>& moves);

/// From what is left of the lattice twice as coarse to what is left of this one; nothing when the start is out of reach.
/// Throws TooLarge when it is not, but what is left cannot be kept.
std::optional<Left> refined(const ChartPlace& place, double h0, Left left, std::size_t& updates, const Watch& watch);

}  // namespace snug::detail::sets
