// Limits: what may be asked, each bound under its one name.
#pragma once

#include <numbers>

#include "snug/version.hpp"

namespace snug::limits {

inline constexpr double shortest = 1e-6;  ///< of a car or a slot: the least length and width [m]
inline constexpr double longest = 1e6;    ///< the greatest [m]
inline constexpr double farthest = 1e9;   ///< a coordinate in the world [m], or a heading there [rad]

inline constexpr double least_steer = 0.1 * std::numbers::pi / 180.0;  ///< of a Car [rad]
inline constexpr double most_steer = 89.9 * std::numbers::pi / 180.0;  ///< [rad]

inline constexpr int usual_changes = 200;          ///< where a search ends unless told otherwise
inline constexpr int most_changes = 100'000;       ///< that full steering may be allowed
inline constexpr int most_changes_fewest = 1'000;  ///< that a search over all maneuvers may be allowed
inline constexpr int most_threads = 1'024;

inline constexpr double quarter_turn = std::numbers::pi / 2.0;  ///< entry headings end there [rad]
inline constexpr double half_turn = std::numbers::pi;           ///< [rad]

inline constexpr double finest = 1e-9;    ///< the least spacing of a lattice, or of waypoints [m]
inline constexpr double touching = 1e-9;  ///< what overlaps no deeper than this touches [m]

}  // namespace snug::limits
