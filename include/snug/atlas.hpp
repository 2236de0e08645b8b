// Atlas: answers computed beforehand for many cars and slots, looked up in a file that is mapped into memory.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/geometry.hpp"
#include "snug/maneuver.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"
#include "snug/strategy.hpp"

namespace snug {

/// The question an atlas answers for every car and slot.
struct AtlasOptions {
    Strategy strategy = Strategy::max_steer;
    /// As in EntryOptions (empty: the fewest, up to 200, and their headings; set: every count up to it) and FewestOptions.
    std::optional<int> max_changes = {};
    double min_range = 0.0;   ///< max_steer: narrower ranges of headings are left out [rad]
    double resolution = 0.0;  ///< fewest: spacing of the finest lattice [m]; 0: as fewest() chooses
    Driving driving = {};

    friend bool operator==(const AtlasOptions&, const AtlasOptions&) = default;
};

/// A stored move: a Move without its poses, which drive() gives.
struct AtlasMove {
    Direction direction = Direction::backward;
    double steering_angle = 0.0;     ///< positive to the left, for a slot on the right [rad]
    double length = 0.0;             ///< path of the rear axle centre [m]
    std::optional<Contact> contact;  ///< what ends the move in the stored slot

    friend bool operator==(const AtlasMove&, const AtlasMove&) = default;
};

/// What is stored for one car in one slot: a view of the mapped file, valid as long as its Atlas. Poses and headings are
/// those of a slot on the right with its corner at the origin and heading 0.
class AtlasCell {
public:
    [[nodiscard]] double length() const noexcept { return length_; }  ///< of the stored slot [m]
    [[nodiscard]] double width() const noexcept { return width_; }    ///< of the stored slot [m]
    /// Which way the car goes in. Nose first, poses are those of the stored slot, whose rear corner is to be taken for the real
    /// one's; maneuver() does so.
    [[nodiscard]] Enter enter() const noexcept { return enter_; }
    /// The fewest; empty when no maneuver was found.
    [[nodiscard]] std::optional<int> direction_changes() const noexcept;
    /// No maneuver has fewer in the stored slot; 0 where nothing is proved, as with full steering alone.
    [[nodiscard]] int lower_bound() const noexcept { return lower_bound_; }
    /// fewest: the bounds meet, or the lower one exceeds what was allowed.
    [[nodiscard]] bool proved() const noexcept { return proved_; }

    /// Ranges of entry headings, in rising order; none with Strategy::fewest.
    [[nodiscard]] std::size_t ranges() const noexcept { return ranges_; }
    [[nodiscard]] HeadingRange range(std::size_t i) const noexcept;

    /// The maneuver: where it begins, and its moves; no moves when none was found.
    [[nodiscard]] Pose entry() const noexcept;
    [[nodiscard]] std::size_t moves() const noexcept { return moves_; }
    [[nodiscard]] AtlasMove move(std::size_t i) const noexcept;

private:
    friend class Atlas;
    const std::byte* body_ = nullptr;
    double length_ = 0.0;
    double width_ = 0.0;
    double max_steer_ = 0.0;
    Enter enter_ = Enter::backward;
    int direction_changes_ = -1;
    int lower_bound_ = 0;
    bool proved_ = false;
    bool angles_stored_ = false;
    std::uint32_t ranges_ = 0;
    std::uint32_t moves_ = 0;
};

/// What an atlas says of a slot.
enum class AtlasVerdict {
    parks,        ///< with the maneuver of `cell`
    cannot_park,  ///< max_steer: this very slot is stored and nothing parks; fewest: proved, of this slot or a larger one
    undecided,    ///< the stored slot below is too small, and nothing is proved of the slot asked for
    outside_grid,  ///< shorter, longer, narrower or wider than every stored slot, or not a number
    no_such_car,   ///< the atlas has not so many cars
    damaged,       ///< a part of the file that is needed for the answer is damaged
};

struct AtlasAnswer {
    AtlasVerdict verdict = AtlasVerdict::outside_grid;
    /// The nearest stored slot that is no longer and no wider than the one asked for: whatever is driven there fits. Its
    /// maneuver is safe in the real slot when it is followed as stored, not driven on until contact.
    AtlasCell cell;
    /// No maneuver has fewer in the slot asked for: what is proved of the nearest stored slot that is no shorter and no
    /// narrower. 0 where nothing is.
    int lower_bound = 0;
};

/// An exported atlas, open for look-ups. docs/atlas-format.md describes the file byte by byte.
///
/// Opening checks the file's head and index; the block of cells that holds an answer is checked when it is first used.
/// Look-ups allocate nothing, throw nothing and may run on many threads at once. The file must not be changed or cut in
/// place while it is open; `snug atlas export` replaces files as a whole.
class Atlas {
public:
    /// Maps the file. Throws Error when it cannot be read, is no atlas, or its head or index is damaged.
    explicit Atlas(const std::string& path);
    /// An atlas that is in memory already: the bytes must stay as long as it.
    explicit Atlas(std::span<const std::byte> bytes);

    [[nodiscard]] const AtlasOptions& options() const noexcept { return options_; }
    /// The version of snug whose answers these are.
    [[nodiscard]] std::string_view made_by() const noexcept;

    [[nodiscard]] std::size_t cars() const noexcept { return cars_; }
    [[nodiscard]] std::string_view car_name(std::size_t car) const noexcept;  ///< in alphabetical order
    [[nodiscard]] std::optional<std::size_t> find_car(std::string_view name) const noexcept;
    [[nodiscard]] Car car(std::size_t car) const;

    [[nodiscard]] std::size_t widths() const noexcept { return widths_; }
    [[nodiscard]] double width(std::size_t i) const noexcept;  ///< rising [m]
    [[nodiscard]] std::size_t lengths() const noexcept { return lengths_; }
    [[nodiscard]] double length(std::size_t i) const noexcept;  ///< rising [m]

    /// The safe answer for a slot between grid points.
    [[nodiscard]] AtlasAnswer look_up(std::size_t car, double length, double width) const noexcept;
    /// What is stored at a grid point; empty when its block is damaged. The indices must exist.
    [[nodiscard]] std::optional<AtlasCell> cell(std::size_t car, std::size_t width, std::size_t length) const noexcept;

    /// Blocks of cells, each with a checksum of its own, and whether one is whole: what look-ups ask for themselves.
    [[nodiscard]] std::size_t blocks() const noexcept { return blocks_; }
    [[nodiscard]] bool block_is_whole(std::size_t block) const noexcept;

private:
    struct Unmap {
        std::size_t bytes;
        void operator()(const std::byte* mapped) const noexcept;
    };
    using Mapped = std::unique_ptr<const std::byte, Unmap>;
    static Mapped map(const std::string& path);
    /// Checks head and index; `name` is the file's in the sentence about what is wrong with it.
    void open(const std::string& name);
    [[nodiscard]] std::span<const std::byte> block_bytes(std::size_t block) const noexcept;
    [[nodiscard]] bool check(std::size_t block) const noexcept;

    Mapped mapped_;  ///< nothing where the bytes are somebody else's
    std::span<const std::byte> bytes_;
    AtlasOptions options_;
    std::size_t cars_ = 0;
    std::size_t widths_ = 0;
    std::size_t lengths_ = 0;
    std::size_t blocks_ = 0;
    int block_bits_ = 0;  ///< a block has two to the power of this many cells
    const std::byte* names_ = nullptr;
    const std::byte* corners_ = nullptr;
    const std::byte* width_values_ = nullptr;
    const std::byte* length_values_ = nullptr;
    const std::byte* first_block_ = nullptr;
    const std::byte* index_ = nullptr;
    /// What is known of each block. Threads that find out at the same time find the same.
    enum class Block : std::uint8_t { unknown, whole, damaged };
    std::unique_ptr<std::atomic<Block>[]> states_;
};

/// The stored maneuver with its poses, in the world of a slot no smaller than the stored one, and driven from its entry corner
/// as it is stored: contacts that only the stored slot has are left out. No moves when none are stored.
Maneuver maneuver(const AtlasCell& cell, const Car& car, const Slot& slot);

}  // namespace snug
