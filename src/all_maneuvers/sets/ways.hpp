// Upper bounds: ways along what is left of a lattice, checked.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/left.hpp"
#include "contact/place_contact.hpp"

namespace snug::detail::sets {

/// The fewest changes along the lattice of upper bounds, up to `most`, whatever is met between its nodes.
std::optional<int> changes_along(const ChartPlace& place, double h, double h0, const Limits& limits, int most,
                                 const Watch& watch, std::size_t& updates);

/// The way that a map of the place has from the start (map_sets.hpp): seldom the one with the fewest changes, but a map has one
/// where the arcs between the nodes of as coarse a lattice of sets meet something. Empty if it has none with at most so many.
std::vector<Path> way_on_map(const ChartPlace& place, double h, int most, const Watch& watch);

/// Any way with as many changes as are left; empty if none is found.
std::vector<Path> any_way(const ChartPlace& place, double h0, const Left& left, const Watch& watch,
                          std::size_t& updates);
/// Of the ways with as many changes as are left one that ends well and keeps a distance; empty if none is found.
std::vector<Path> way_to_drive(const ChartPlace& place, double h0, const Left& left, const Watch& watch,
                               std::size_t& updates);

/// Whether a way with a change more saves a detour, keeps a distance or ends better: less aslant.
bool worth_a_change(const ChartPlace& place, const std::vector<Path>& one, const std::vector<Path>& other);

}  // namespace snug::detail::sets
