// ParkMap: from every pose in a place, with how few direction changes the car parks, and how: swept once, then looked up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "snug/car.hpp"
#include "snug/maneuver.hpp"
#include "snug/place.hpp"

namespace snug {

namespace detail {
struct WayLists;
}

class ParkMap;

struct ParkMapOptions {
    /// Of the lattice [m]; half of it takes four times as long. 0: 8 cm, or a 32nd of the turning radius where that is less.
    double spacing = 0.0;
    double clearance = 0.0;  ///< grows the frame for contacts [m]
    int max_changes = 50;    ///< counted up to, 0 to 1000
    /// Of the cars that come along [rad]: the map covers headings within 80 degrees of the middle between this and the parked one.
    /// Empty: the parked one; of a street: its own.
    std::optional<double> heading = {};
    /// Told from time to time; returning false gives up: the constructor throws Error.
    std::function<bool()> progress = {};
    /// A pose to know of before all others: long before the map is done `known` is told of what is swept so far. That says of this
    /// pose what the whole map will, and of others perhaps less; it is not to be kept.
    struct First {
        Pose pose;
        std::function<void(const ParkMap& so_far)> known;
    };
    std::optional<First> first = {};
};

/// What a map knows of a pose.
struct MapBounds {
    enum Where : std::uint8_t {
        free,     ///< as below
        blocked,  ///< the car meets an obstacle there
        outside,  ///< of the region or the headings covered: nothing is known
    };
    Where where = outside;
    /// No maneuver within region and headings has fewer direction changes; one more than the map counts up to when it takes more.
    int lower_bound = 0;
    bool impossible = false;  ///< no number of changes will do: proved
    /// A maneuver has so many; empty where none is known.
    std::optional<int> direction_changes;
    /// How that begins; empty where the car is parked already.
    std::optional<Direction> first;

    [[nodiscard]] bool proved() const { return impossible || direction_changes == lower_bound; }
    friend bool operator==(const MapBounds&, const MapBounds&) = default;
};

/// Of one car in one place. A look-up allocates nothing; copies share what was computed, and threads may share a map.
class ParkMap {
public:
    /// Throws Error when an option is impossible, the place too large for the spacing, or progress says to give up.
    ParkMap(const Car& car, const Place& place, const ParkMapOptions& options = {});
    ParkMap(const Car& car, const Street& street, const ParkMapOptions& options = {});

    /// For a process or a worker that shares no memory with this one: what was swept, as bytes that the same version of the library
    /// reads back on the same kind of machine.
    [[nodiscard]] std::vector<std::byte> packed() const;
    /// With the car, place and options it was made with. Throws Error when the bytes are damaged, or another version's or another
    /// map's. They are trusted otherwise: read none that a stranger made.
    static ParkMap unpacked(const Car& car, const Place& place, const ParkMapOptions& options,
                            std::span<const std::byte> bytes);
    static ParkMap unpacked(const Car& car, const Street& street, const ParkMapOptions& options,
                            std::span<const std::byte> bytes);

    [[nodiscard]] MapBounds at(const Pose& pose) const;
    /// From there until parked, with as many changes as at() says, or fewer; each piece is checked by exact contact. Empty where none is
    /// known, and where the car is parked already.
    [[nodiscard]] std::optional<Maneuver> maneuver(const Pose& pose) const;

    /// Whether driving so far meets nothing and stays in the region, by exact contact; so does no pose outside of what is covered.
    [[nodiscard]] bool goes_free(const Pose& pose, Direction direction, double steering_angle, double length) const;

    [[nodiscard]] const Car& car() const;
    [[nodiscard]] const Place& place() const;
    [[nodiscard]] double spacing() const;
    [[nodiscard]] double clearance() const;
    /// It counts up to so many changes.
    [[nodiscard]] int max_changes() const;
    /// In the middle of those covered; 80 degrees to either side are. [rad]
    [[nodiscard]] double middle_heading() const;

    /// Tells cars, places and clearances apart.
    [[nodiscard]] std::uint64_t fingerprint() const;
    [[nodiscard]] static std::uint64_t fingerprint(const Car& car, const Place& place, double clearance = 0.0);
    /// Throws Error when this is the map of another car or place, or with another clearance.
    void expect(const Car& car, const Place& place, double clearance = 0.0) const;

    /// Memory it takes.
    [[nodiscard]] std::size_t bytes() const;

private:
    friend class Assistant;
    /// The moves of maneuver(), none where there is none. Nothing is allocated while the lists have room.
    void moves(const Pose& pose, detail::WayLists& lists, std::vector<Move>& moves) const;

    struct Swept;
    explicit ParkMap(std::shared_ptr<const Swept> swept) : swept_(std::move(swept)) {}
    std::shared_ptr<const Swept> swept_;
};

}  // namespace snug
