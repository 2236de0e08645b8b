// Rolling: a way into a place on which the steering turns only while the car rolls.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/park_map.hpp"
#include "snug/place.hpp"
#include "snug/trajectory.hpp"

namespace snug {

/// Driving one way while the curvature changes evenly with the distance driven: a clothoid; an arc or a straight line where it
/// does not change.
struct RollingPiece {
    Direction direction = Direction::backward;
    double curvature = 0.0;  ///< where the piece starts, of the steering, positive to the left [1/m]
    double sharpness = 0.0;  ///< what the curvature gains in every metre driven [1/m2]
    double length = 0.0;     ///< path of the rear axle centre, never negative [m]
    Pose start;
    Pose end;

    /// So far after its start [m], to a few units in the last place of the distance.
    [[nodiscard]] Pose at(double distance) const;
    [[nodiscard]] double curvature_at(double distance) const { return curvature + sharpness * distance; }

    friend bool operator==(const RollingPiece&, const RollingPiece&) = default;
};

/// Where a car stops and turns its steering before it rolls on.
struct StandingSteer {
    std::size_t piece = 0;   ///< the one that begins there
    int stop = 0;            ///< the direction has changed so often when the car stands there; 0: the start
    double curvature = 0.0;  ///< that the wheels have there; the piece begins with another [1/m]

    friend bool operator==(const StandingSteer&, const StandingSteer&) = default;
};

/// A car and what it drives: each piece starts where the one before ends, with the curvature that one ends with, at the stops
/// in between too; where it begins with another, the car stops and turns its steering.
struct RollingManeuver {
    Car car;
    std::vector<RollingPiece> pieces;

    /// Where the steering turns at standstill, when the wheels have that curvature at the start.
    [[nodiscard]] std::vector<StandingSteer> standing_steers(double curvature = 0.0) const;

    [[nodiscard]] int direction_changes() const;
    /// Path of the rear axle centre. [m]
    [[nodiscard]] double length() const;
    /// Nearly the same in arcs at most so long [m], for pictures and waypoints: each with the curvature in the middle of what it
    /// stands for, between poses on the way.
    [[nodiscard]] Maneuver in_arcs(double most = 0.05) const;

    friend bool operator==(const RollingManeuver&, const RollingManeuver&) = default;
};

/// The quickest way to drive it when on each piece the speed is at most that at which its sharpness takes the whole steering
/// rate with the wheels straight, rate / (wheelbase x sharpness): from there it falls with the square of the steering angle's
/// cosine, so the rate is kept everywhere. It stops where the direction changes and where the curvature jumps: there the steering
/// turns at its rate while the car stands. Throws Error as trajectory() of a Maneuver does, and where a piece is so sharp that it
/// would take less than 0.001 m/s.
Trajectory rolling_trajectory(const RollingManeuver& maneuver, const MotionLimits& limits = {});

/// When the steering may turn: while the car stands, or only while it rolls.
enum class Steer { standing, moving };

struct RollingOptions {
    double clearance = 0.0;  ///< grows the frame for contacts [m]
    /// The least speed at which the car can roll steadily while its steering turns at its rate [m/s]: the slower it rolls, the
    /// shorter is the way on which the steering turns. Four times and twice that speed are tried first with every number of
    /// direction changes.
    double creep = 0.03;
    double steering_rate = 0.5;  ///< of the steering angle, at the road wheels [rad/s]
    int most_more = 6;           ///< direction changes that it may take more than with steering at standstill
    int max_changes = 200;       ///< and in all
    /// Pieces of a way looked at before it gives up: counted, so that the answer is the same on every machine.
    int most_work = 1'000'000;
    double spacing = 0.0;  ///< of the map that is planned on [m]; 0: its usual one
    /// Told from time to time; returning false gives up.
    std::function<bool()> progress = {};
};

struct RollingAnswer {
    std::optional<RollingManeuver> maneuver;  ///< empty where none was found; that is no proof
    /// Then one that turns its steering at standstill, too: at as few stops as were found to do, or else as the map steers. Empty
    /// where none is known either.
    std::optional<RollingManeuver> standing;
    double creep = 0.0;  ///< the speed at which its steering turns at its rate [m/s]
    /// With so many direction changes the map knows a maneuver that steers at standstill, from the same start.
    std::optional<int> standing_changes;
    int lower_bound = 0;  ///< of the direction changes of any maneuver
    int work = 0;         ///< pieces looked at
    bool cancelled = false;
};

/// From the start into the place, with as few direction changes as it finds: as many as with steering at standstill where the
/// room allows it, else more. What it finds keeps 0.1 mm from everything, beside the clearance: so much takes the proof
/// that nothing is touched between the poses that are looked at. Throws Error as ParkMap does, and where the start lies outside
/// of the map or nearer to something than that.
RollingAnswer park_rolling(const Car& car, const Place& place, const Pose& start, const RollingOptions& options = {});
/// The same on a map made before, whose clearance holds (options.clearance and spacing do not count), for a car whose wheels have
/// that steering angle at the start [rad].
RollingAnswer park_rolling(const ParkMap& map, const Pose& start, double steering_angle = 0.0,
                           const RollingOptions& options = {});

}  // namespace snug
