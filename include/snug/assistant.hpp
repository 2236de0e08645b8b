// Assistant: what a car that knows its map does next, from wherever it was measured.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/park_map.hpp"
#include "snug/place.hpp"

namespace snug {

/// How a plan keeps its distance from a car that errs.
struct AssistantOptions {
    /// The frame grows by it for planning, and the car is parked only where it stands by half of it farther inside. [m]
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
        parked,   ///< nothing: the car is parked
        move,     ///< drive these moves, then ask again
        escape,   ///< the same, but the car stands nearer to something than the margin: they lead away from it
        overlap,  ///< the pose measured overlaps something: they lead out of it, and no overlap grows on the way
        stuck,    ///< no way is known from here
    };
    What what = stuck;
    std::vector<Move> moves;    ///< of one direction, the first from the pose measured
    int direction_changes = 0;  ///< of all of the way to where the car is parked; 0 where an escape takes several arcs

    friend bool operator==(const Instruction&, const Instruction&) = default;
};

class Assistant;

/// What an assistant writes on while it answers, made once: then next() allocates nothing (but for cars and obstacles of more than
/// 64 corners, which it is not made for). One for each thread.
class AssistantMemory {
public:
    explicit AssistantMemory(const Assistant& assistant);
    AssistantMemory(AssistantMemory&&) noexcept;
    AssistantMemory& operator=(AssistantMemory&&) noexcept;
    ~AssistantMemory();

    /// How many poses the last answer looked at: its time grows with it, and it is the same on every machine. Beside the way through
    /// the map, which has a pose every few centimetres, at most 1,750 for short arcs (700 where the map has a way, or out of what
    /// is overlapped) and 487 for where to stop.
    [[nodiscard]] std::size_t poses_looked_at() const;

private:
    friend class Assistant;
    struct Lists;
    std::unique_ptr<Lists> lists_;
};

/// Plans for one car in one place. It keeps no state from one question to the next, so the answer to a pose is the same whenever it
/// is asked, and threads may share an assistant.
class Assistant {
public:
    /// Sweeps the map. Throws Error when an option is impossible, what counts as parked is too small for the margin, or the place is
    /// too large for a map.
    Assistant(const Car& car, const Place& place, const AssistantOptions& options = {});
    Assistant(const Car& car, const Street& street, const AssistantOptions& options = {});
    /// With the map() of an assistant made before, or of another process, for the same car, place and options. Throws Error when it
    /// is of another car or place, or with another margin.
    Assistant(const Car& car, const Place& place, ParkMap map, const AssistantOptions& options = {});

    /// From a measured pose: how to drive until the direction changes, on the way with the fewest changes the map knows. `driven` is
    /// the direction of the last move, for turning costs a change. It goes through nothing, grown by the margin.
    ///
    /// The last arc ends where coming to rest a little off (2 cm along, 1.2 cm aside, 0.006 rad) does the least harm on average: up to
    /// 30 cm before or beyond where the map has it.
    ///
    /// Where a short arc of one direction leads to a pose from where fewer changes are left in all, it is driven first; so too where
    /// the map knows no way, as when the car stands closer to something than the margin (but does not overlap it): an arc on which
    /// at least half of the distance is left that the car has (a corner swings out before the car is away), or failing that one that
    /// ends by 1 cm or more farther away. Where the pose measured
    /// overlaps something the way out is the arc of up to 1 m on which no overlap grows (all the way, but for 1 um) and at whose end
    /// the least is left, the shortest of those; stuck where there is none. So is a pose that is no number or outside of the map.
    [[nodiscard]] Instruction next(const Pose& measured, std::optional<Direction> driven = {}) const;
    /// The same in memory made before, where it stays until the next question.
    [[nodiscard]] const Instruction& next(const Pose& measured, std::optional<Direction> driven,
                                          AssistantMemory& memory) const;
    /// All of the way that the map knows, before next() chooses where to stop; empty when the car is parked or stuck.
    [[nodiscard]] std::optional<Maneuver> plan(const Pose& measured) const;

    /// The car with its whole steering, in the place as it is.
    [[nodiscard]] const Car& car() const { return car_; }
    [[nodiscard]] const Place& place() const { return place_; }
    [[nodiscard]] const ParkMap& map() const { return map_; }

private:
    friend class AssistantMemory;
    using Lists = AssistantMemory::Lists;
    /// What of the car, about its rear axle, keeps from what of the place.
    struct Around {
        std::vector<Point> shape, solid;
        std::vector<Point> shape_normals, solid_normals;  ///< outward, of the edges that begin at the corners
        std::size_t begin = 0;                            ///< of the gaps along its edges, in a list of those of all
        Point low, high;                                  ///< corners of a box around the solid
        double reach = 0.0;                               ///< of the shape's farthest corner from the rear axle
    };
    struct Arc {
        Instruction::What what = Instruction::stuck;
        Move move;
        int changes = 0;
    };
    void answer(const Pose& measured, std::optional<Direction> driven, Lists& lists) const;
    [[nodiscard]] Arc way_out(const Pose& measured, Lists& lists) const;
    [[nodiscard]] Arc short_way(const Pose& measured, std::optional<Direction> driven, int most_changes,
                                Lists& lists) const;
    /// Until it touches something, infinite if it does not within the arc.
    [[nodiscard]] double free_length(const Move& arc) const;
    void settle(Move& last, std::size_t& looked) const;
    [[nodiscard]] double expected_changes(const Pose& end, Direction driven, std::size_t& looked) const;
    [[nodiscard]] static double gap(const Around& around, const Pose& pose);
    [[nodiscard]] double nearest(const Pose& pose) const;
    static void gaps_along_edges(const Around& around, const Pose& pose, double* gaps);
    /// On a part of an arc, of which the gaps at both ends are given: does the overlap stay at most that of the gap `floor`? It may
    /// be halved so many times; there is room for the gaps of each.
    [[nodiscard]] bool never_deeper(const Around& around, const Move& arc, double from, const double* gaps_from,
                                    double to, const double* gaps_to, double floor, int halvings, double* room,
                                    std::size_t& looked) const;

    Car car_;
    Place place_;
    ParkMap map_;
    std::vector<Around> around_;
};

}  // namespace snug
