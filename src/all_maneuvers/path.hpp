// From the lattice's heights to a way out along its points.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "all_maneuvers/lattice.hpp"

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
        bool nose_in = false;  ///< entering nose first the nose must stay in here

        /// Another way to drive it.
        [[nodiscard]] Leg with(std::vector<Characteristic> others) const {
            return {direction, std::move(others), nose_in};
        }
    };
    double z = 0.0;  ///< height at the start [m]
    std::vector<Leg> legs;
};

/// Of a chain of moves, the last one forward.
inline Direction direction_at(int level, int last) {
    return (last - level) % 2 == 0 ? Direction::forward : Direction::backward;
}

/// Puts the car where it starts.
using Start = std::function<void(Heights&)>;

/// Fewest direction changes, up to `most`, with which the car leaves along the lattice of upper bounds; empty if none.
std::optional<int> changes_along(const Lattice& lattice, const Start& start, int most, const Watch& watch);

/// Copies of the heights that are in memory while the path with so many changes is found.
int heights_kept(int changes);

/// A path with so many changes; empty if there is none.
std::optional<LatticePath> path_along(const Lattice& lattice, const Start& start, int changes, const Watch& watch);

}  // namespace snug::detail
