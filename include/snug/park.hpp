// Park: from any pose, among any obstacles, with the fewest direction changes over all maneuvers, proved.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/contact.hpp"
#include "snug/fewest.hpp"
#include "snug/place.hpp"

namespace snug {

using ParkProgress = FewestProgress;

struct ParkOptions {
    int max_changes = 200;   ///< direction changes allowed, 0 to 1000
    double clearance = 0.0;  ///< grows the frame for contacts [m]
    /// Spacing of the finest lattice the bounds are computed on [m]; 0: an eight-hundredth of the car's length, or up to four times
    /// finer where that takes seconds. Coarser ones are tried first, and the search ends where the bounds meet.
    double resolution = 0.0;
    double time_limit = std::numeric_limits<double>::infinity();  ///< ends with the bounds found so far [s]
    bool roomiest =
        true;  ///< look for a maneuver that keeps its distance; otherwise any with that many changes will do
    /// 0 to 1024, the one that asks among them; 0: all cores, as far as they are of use. They begin where there is enough to do, the
    /// answer is the same, and only the one that asks tells `progress`.
    int threads = 1;
    /// Told from time to time; returning false ends with the bounds found so far.
    std::function<bool(const ParkProgress&)> progress = {};
};

/// What the car is nearest to where it stops.
struct ParkStop {
    std::size_t obstacle = 0;  ///< of the place
    PlaceGap gap;

    /// Whether it touches it.
    [[nodiscard]] bool is_contact() const { return gap.distance <= 1e-6; }
};

/// Of the maneuver from the start to where the car is parked: arcs and straight lines, none of which goes through anything.
struct ParkAnswer : Answer {
    bool impossible = false;  ///< no number of direction changes will do: proved
    /// For every move of the maneuver, at its end; empty in a place without obstacles.
    std::vector<ParkStop> stops;
    /// With more direction changes, in rising order, each much shorter than those with fewer or ending straighter.
    std::vector<Maneuver> alternatives;
};

/// The fewest direction changes with which the car parks from where it stands, whatever way it is steered within its limit
/// and wherever it stops; it may begin forward or backward.
///
/// `lower_bound`, `proved` and `impossible` are about all maneuvers during which the middle of the rear axle stays in the
/// place's region and the heading within 80 degrees of the middle between the heading at the start and the parked one (of
/// the two ways round the shorter). Nothing is claimed about maneuvers that turn farther. docs/park.md has the proof.
///
/// Throws Error when an option is impossible, the start meets an obstacle or lies outside the region, the heading at the start
/// and the parked one are more than 150 degrees apart, or the region is too large for the spacing.
ParkAnswer park(const Car& car, const Place& place, const Pose& start, const ParkOptions& options = {});

}  // namespace snug
