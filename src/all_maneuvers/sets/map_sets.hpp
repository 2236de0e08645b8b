// One sweep outward from the parked poses: with how many direction changes the car parks from every pose of a chart, bounded
// from both sides.
//
// What the outer sets (outer_sets.hpp) of a level hold is kept where it is more than those of the level before, and likewise
// sets of true intervals of y, from each place of which the car parks for certain: a step from node to node sweeps a
// shape that, seen from the node, is the same in every row. Its hull, widened by what arcs bulge, is taken for the car, so that
// nothing is met between nodes either.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/free_along.hpp"
#include "all_maneuvers/sets/inner_sets.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/packing.hpp"
#include "all_maneuvers/sets/steps.hpp"
#include "contact/place_contact.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

/// What is known of a level, for one of many cells each: those of a cell follow one another.
template <class Of>
struct ByCell {
    std::vector<std::uint32_t> begin;
    std::vector<Of> of;

    template <class Self, class Pack>
    static void pack(Self& self, Pack& pack) {
        pack(self.begin, self.of);
    }
    [[nodiscard]] const Of* first(std::size_t cell) const { return of.data() + begin[cell]; }
    [[nodiscard]] const Of* last(std::size_t cell) const { return of.data() + begin[cell + 1]; }
};

/// No maneuver has fewer changes. Swept level by level; look-ups know of those swept when it last settled.
class OuterMap {
public:
    OuterMap(const ChartPlace& place, double h, const Watch& watch);
    explicit OuterMap(Unpacking& from) { from(*this); }
    /// One level more; false where that would hold nothing new.
    bool sweep_on(const Watch& watch);
    void settle();
    /// Settles, for no more will be swept.
    void finish();
    template <class Self, class Pack>
    static void pack(Self& self, Pack& pack) {
        pack(self.grid_, self.spans_, self.most_, self.complete_, self.forward_, self.backward_);
    }

    /// The fewest with which the sets hold a pose in the chart; more than asked for where they do not.
    [[nodiscard]] int changes_at(const Pose& pose) const;
    /// Those are all there are: what they do not hold never parks.
    [[nodiscard]] bool complete() const { return complete_; }
    /// Levels swept, less one.
    [[nodiscard]] int most() const { return most_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Level {
        Micro z, w;
        int changes;
    };
    struct Logged {
        std::uint32_t node;
        Micro z, w;
    };
    struct Sweeping {
        OuterLattice lattice;
        BothWays<std::vector<std::vector<Logged>>> logs;  ///< by layer and level
        BothWays<Pairs> now;
    };
    std::optional<Sweeping> sweeping_;
    CellGrid grid_;
    std::vector<Spans> spans_;  ///< of the layers that are free
    int most_ = -1;
    bool complete_ = false;
    std::vector<ByCell<Level>> forward_, backward_;  ///< beside them
};

/// A way from a pose to a node, and with how many changes it goes on from there.
struct Joining {
    int changes = 0;
    Direction direction = Direction::forward;  ///< of the car parking
    At node;
    double sines[3] = {};     ///< of the heading: at the pose, where the first arc ends, at the node
    double first_side = 1.0;  ///< of the first arc; the second is of the other
};

/// A maneuver has so many changes. Swept like OuterMap.
class InnerMap {
public:
    InnerMap(const ChartPlace& place, double h, const Watch& watch);
    InnerMap(const ChartPlace& place, Unpacking& from) : place_(place) { from(*this); }
    bool sweep_on(const Watch& watch);
    void settle();
    void finish();
    /// Levels swept, less one.
    [[nodiscard]] int most() const { return static_cast<int>(logs_.forward.size()) - 1; }
    template <class Self, class Pack>
    static void pack(Self& self, Pack& pack) {
        pack(self.h_, self.sine_step_, self.first_row_, self.last_row_, self.first_cell_, self.first_column_,
             self.last_column_, self.width_, self.level_, self.intervals_, self.forward_, self.backward_, self.parked_);
        for (auto& free : self.free_) pack(free);
    }

    /// The way with the fewest changes that is known; empty where none is. Nothing is allocated.
    [[nodiscard]] std::optional<Joining> joining(const Pose& pose) const;
    /// Driven, in the chart; empty if it cannot be followed.
    void way(const Pose& start, const Joining& joining, std::vector<Path>& way) const;

    [[nodiscard]] double h() const { return h_; }
    [[nodiscard]] double radius() const { return place_.radius; }
    [[nodiscard]] double sine(int column) const { return column * sine_step_; }
    [[nodiscard]] double level(int column) const {
        const int after_first = column - first_column_ + 1;
        return level_[static_cast<std::size_t>(after_first)];
    }
    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr std::size_t most_intervals = 4;  ///< at a node
    struct Level {
        Interval y;
        int changes;
        int filled = 0;  ///< so that a packed map holds nothing but itself
    };
    /// What is free at nodes, and for steps from them to the left and the right forward and across a cell.
    enum Kind { at_node, to_left, to_right, across, kinds };
    struct Logged {
        std::uint32_t node;
        Interval y;
    };

    [[nodiscard]] std::size_t index(int row, int cell) const {
        return static_cast<std::size_t>(row - first_row_) * width_ + static_cast<std::size_t>(cell - first_cell_);
    }
    [[nodiscard]] bool has(int row, int column) const {
        return row >= first_row_ + 2 && row <= last_row_ - 2 && column >= first_column_ && column <= last_column_;
    }
    [[nodiscard]] double x(int row) const { return row * (h_ / 2.0); }
    std::vector<Band> measure_columns(const Watch& watch);  ///< returns where the car is parked
    void measure(Kind kind, int column, const Bands& bands);
    [[nodiscard]] InnerSet::Range known(Kind kind, int row, int column) const;
    std::vector<Logged> sweep(const std::vector<Logged>& begins, Direction direction, std::vector<InnerSet::Few>& sets,
                              const Watch& watch);
    /// What moves with so many changes reach, in that direction of leaving, and where they begin.
    template <class Do>
    void each_reached(Direction leaving, int row, int column, int changes, const Do& act) const;
    template <class Do>
    void each_begin(Direction leaving, int row, int column, int changes, const Do& act) const;
    /// The fewest with which the car goes on from a node; negative where it is not known to.
    [[nodiscard]] int changes_from(Direction leaving, const At& node) const;
    struct Moved {
        Pose at;
        double sine = 0.0, cosine = 1.0;  ///< of the heading

        [[nodiscard]] Point of(const Point& p) const {
            return {at.x + p.x * cosine - p.y * sine, at.y + p.x * sine + p.y * cosine};
        }
        /// As the car sees it.
        [[nodiscard]] Point seen(const Point& p) const {
            const double x = p.x - at.x, y = p.y - at.y;
            return {x * cosine + y * sine, y * cosine - x * sine};
        }
    };
    /// Whether an arc of full steering to that side meets nothing for certain, and stays in the region.
    [[nodiscard]] bool is_apart(const Moved& from, const Moved& to, double side) const;

    ChartPlace place_;
    double h_ = 0.0, sine_step_ = 0.0;
    int first_row_ = 0, last_row_ = 0, first_cell_ = 0, first_column_ = 0, last_column_ = 0;
    std::size_t width_ = 0;
    std::vector<double> level_;
    std::vector<InnerSet::Few> free_[kinds];
    std::vector<Interval> intervals_;
    ByCell<Level> forward_, backward_;
    ByCell<Interval> parked_;
    // While it is swept.
    std::vector<Logged> parked_log_;
    BothWays<std::vector<Logged>> logs_;  ///< by level
    std::vector<InnerSet::Few> sets_[2];
    std::vector<Interval> reached_;
    FreeAlong measured_;
    std::vector<Interval> gaps_;
    std::vector<double> xs_;
    std::vector<std::uint8_t> changed_;
};

}  // namespace snug::detail::sets
