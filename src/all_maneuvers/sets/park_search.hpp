// Both bounds on the number of direction changes for parking, on finer and finer lattices.
#pragma once

#include <optional>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/slot_in_place.hpp"
#include "contact/place_contact.hpp"

namespace snug::detail::sets {

struct ParkQuestion {
    ChartPlace place;
    std::optional<SlotInPlace> slot = {};  ///< if it is one
    int max_changes = 200;
    double coarsest = 0.08, finest = 0.01;  ///< spacings, a power of two apart [m]
    int finer = 0;  ///< how many times the finest is halved where so little is left that this is soon done
    bool roomiest = true;
};

/// What is known. It only ever gets better, so that it can be used whenever the search is given up.
struct ParkBounds {
    int lower = 0;                          ///< no maneuver has fewer
    bool impossible = false;                ///< none will do at all
    std::optional<int> upper;               ///< as `way` has
    std::vector<Path> way;                  ///< in the chart, checked
    std::vector<std::vector<Path>> others;  ///< with one change more each, but shorter or ending better
    double spacing = 0.0;                   ///< of the finest lattice [m]
    std::size_t updates = 0;                ///< cells computed

    [[nodiscard]] bool meet() const { return impossible || (upper && *upper == lower); }
};

/// Narrows the bounds until they meet or the finest lattice is done. Throws GivenUp.
void narrow(const ParkQuestion& question, ParkBounds& bounds, const Watch& watch);

}  // namespace snug::detail::sets
