// Drive: a plan driven many times by a simulated car that errs, looking again on the way.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "snug/assistant.hpp"
#include "snug/car.hpp"
#include "snug/park.hpp"
#include "snug/place.hpp"
#include "snug/rolling.hpp"
#include "snug/trajectory.hpp"

namespace snug {

/// What is wrong with a car's measurements and with what its wheels do: standard deviations of normal errors.
struct CarErrors {
    Pose sensing = {0.02, 0.02, 0.0087266462599716477};  ///< of every measured pose [m, m, rad]
    Pose bias = {0.0, 0.0, 0.0};                         ///< added to every measured pose [m, m, rad]
    double distance = 0.01;                              ///< of where it comes to rest along a move [m]
    double steering = 0.017453292519943295;              ///< of the steering angle, the same during a move [rad]
    /// How far the wheels are behind what they are told on the way: a lag of the first order. It is no deviation. [s]
    double lag = 0.1;
    /// Of where a street's slot seems to lie, along the street and across it, and of its length and width, as the car sees them
    /// from the start; with the distance to the slot, the least so far, they shrink to nothing. [m]
    double slot_place = 0.0;
    double slot_size = 0.0;
};

struct DriveOptions {
    CarErrors errors = {};
    /// How much the car is grown for planning [m]; empty: of a list, of those that park often enough, the one with the fewest
    /// changes on average. It is chosen by as many other runs, and then has to do in those of the answer, too.
    std::optional<double> margin = {};
    double rate = 0.999;   ///< the share of runs that must park without contact, where the margin is looked for
    double spacing = 0.0;  ///< of the map [m]; 0: its usual one
    int runs = 1000;
    std::uint64_t seed = 1;  ///< the same seed, the same runs
    /// Drive the plan of the start to its end without measuring again.
    bool blind = false;
    /// Moving: it drives along clothoids, and stands to steer only where no way is found without.
    Steer steer = Steer::standing;
    MotionLimits limits = {};
    int threads = 0;  ///< 0: all cores
    /// Told how many runs of the margin now tried are done; returning false gives up with the runs done.
    std::function<bool(double margin, int runs)> progress = {};
};

/// One run of the car.
struct DriveRun {
    bool parked = false;             ///< truly, and without contact
    bool contact = false;            ///< touched something; the run ends there
    int direction_changes = 0;       ///< driven
    int standing_steers = 0;         ///< how often the wheels turned while the car stood
    double seconds = 0.0;            ///< until it stood for good
    double smallest_distance = 0.0;  ///< to anything [m]
    std::vector<Pose> track;         ///< true poses, every few centimetres

    friend bool operator==(const DriveRun&, const DriveRun&) = default;
};

/// All runs together.
struct DriveTotals {
    double mean_changes = 0.0;
    int most_changes = 0;
    double mean_standing_steers = 0.0;
    int most_standing_steers = 0;
    double mean_seconds = 0.0;
    double most_seconds = 0.0;
    double smallest_distance =
        std::numeric_limits<double>::infinity();  ///< in a place without obstacles it stays so [m]
};

struct DriveAnswer {
    bool plannable = false;  ///< with a margin at all: else there are no runs
    bool cancelled = false;
    double margin = 0.0;  ///< [m]
    int planned_changes = 0;
    int lower_bound = 0;              ///< of the direction changes of any maneuver of the car as it is, without errors
    std::optional<Maneuver> planned;  ///< from the start, with its margin; of a rolling plan its arcs
    /// With Steer::moving the plan itself; its curvature jumps where it has to steer at standstill.
    std::optional<RollingManeuver> rolling;
    /// With Steer::moving: so many direction changes has a plan with that margin that steers at standstill.
    std::optional<int> standing_changes;
    std::vector<DriveRun> runs;

    /// What was planned, as park() would answer it.
    [[nodiscard]] ParkAnswer plan() const {
        ParkAnswer answer;
        answer.maneuver = planned;
        if (planned) answer.direction_changes = planned_changes;
        answer.lower_bound = lower_bound;
        return answer;
    }
    [[nodiscard]] int parked() const {
        int count = 0;
        for (const DriveRun& run : runs) count += run.parked ? 1 : 0;
        return count;
    }
    [[nodiscard]] int contacts() const {
        int count = 0;
        for (const DriveRun& run : runs) count += run.contact ? 1 : 0;
        return count;
    }
    /// The plan over time. There must be one.
    [[nodiscard]] Trajectory planned_trajectory(const MotionLimits& limits) const {
        return rolling ? rolling_trajectory(*rolling, limits) : trajectory(*planned, limits);
    }
    /// There must be a run.
    [[nodiscard]] DriveTotals totals() const {
        DriveTotals all;
        for (const DriveRun& run : runs) {
            all.mean_changes += run.direction_changes;
            all.most_changes = std::max(all.most_changes, run.direction_changes);
            all.mean_standing_steers += run.standing_steers;
            all.most_standing_steers = std::max(all.most_standing_steers, run.standing_steers);
            all.mean_seconds += run.seconds;
            all.most_seconds = std::max(all.most_seconds, run.seconds);
            all.smallest_distance = std::min(all.smallest_distance, run.smallest_distance);
        }
        all.mean_changes /= static_cast<double>(runs.size());
        all.mean_standing_steers /= static_cast<double>(runs.size());
        all.mean_seconds /= static_cast<double>(runs.size());
        return all;
    }
};

/// Drives from the start into the place as the Assistant says: in every run the car measures its pose at standstill and every 5 cm on
/// the way, weighs what it measured against what it thinks it drove (an extended Kalman filter over pose and steering error), keeps
/// to its move by small corrections of the steering, stops where the move ends or something is near, and asks again.
/// Beside something, nearer than two margins, it creeps at 0.1 m/s and looks every centimetre.
/// With Steer::moving it keeps to a plan of park_rolling() on the Assistant's map, which it makes anew where it has come off it;
/// its steering keeps the steering rate, corrections included. Where there is neither plan nor a way with the wheels as they are, it
/// does as the Assistant says, and steers at standstill: that is counted.
/// Throws Error when an option is impossible, or the start meets an obstacle or lies outside of the map.
DriveAnswer drive_runs(const Car& car, const Place& place, const Pose& start, const DriveOptions& options = {});
/// In a street, whose slot may be seen with errors: in any other place they have to be 0.
DriveAnswer drive_runs(const Car& car, const Street& street, const Pose& start, const DriveOptions& options = {});

}  // namespace snug
