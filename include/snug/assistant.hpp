// Assistant: what a car that knows its map does next, from wherever it was measured.
#pragma once

#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/park_map.hpp"
#include "snug/place.hpp"

namespace snug {

/// How a plan keeps its distance from a car that errs.
struct AssistantOptions {
    /// The frame grows by it for planning, and the car is parked only where it stands so far inside of what counts. [m]
    double margin = 0.05;
    /// Of the steering angle, kept for corrections on the way. [rad]
    double steering_reserve = 0.0;
    double spacing = 0.0;  ///< of the map [m]; 0: its usual one
    /// Of the cars that come along, as ParkMapOptions has it.
    std::optional<double> heading = {};
};

/// What to do next.
struct Instruction {
    enum What {
        parked,  ///< nothing: the car is parked
        move,    ///< drive this move, then ask again
        escape,  ///< the same, but the car stands nearer to something than the margin: the move leads away from it
        stuck,   ///< no way is known from here
    };
    What what = stuck;
    Move next;                 ///< from the pose measured, with one steering angle
    int direction_changes = 0;  ///< of the way to where the car is parked, this move included

    friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// Plans for one car in one place. It keeps no state from one question to the next, so the answer to a pose is the same whenever it
/// is asked, and threads may share an assistant.
class Assistant {
public:
    /// Sweeps the map. Throws Error when an option is impossible, what counts as parked is too small for the margin, or the place is
    /// too large for a map.
    Assistant(const Car& car, const Place& place, const AssistantOptions& options = {});
    Assistant(const Car& car, const Street& street, const AssistantOptions& options = {});

    /// From a measured pose: the first move of the way with the fewest changes the map knows. It goes through nothing, grown by the
    /// margin. Where the car stands closer than that to something (but does not overlap it), the shortest arc that comes no nearer
    /// to anything than the car stands and ends where a way is known. A pose that is no number, outside of the map, or overlaps
    /// something has no way: stuck.
    [[nodiscard]] Instruction next(const Pose& measured) const;
    /// All of the way, as next() would give it move by move; empty when the car is parked or stuck.
    [[nodiscard]] std::optional<Maneuver> plan(const Pose& measured) const;

    /// The car with its whole steering, in the place as it is.
    [[nodiscard]] const Car& car() const { return car_; }
    [[nodiscard]] const Place& place() const { return place_; }
    [[nodiscard]] const ParkMap& map() const { return map_; }

private:
    [[nodiscard]] Instruction escape_from(const Pose& measured) const;

    Car car_;
    Place place_;
    ParkMap map_;
};

}  // namespace snug
