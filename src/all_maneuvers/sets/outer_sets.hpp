// What no maneuver can leave: for every cell of a lattice over (a, b) and every move, sets of y that hold every place the
// car can come to with so many direction changes. Where they miss the other end, more changes are needed.
//
// The rear axle's x and the heading make a = x - r sin(heading) and b = x + r sin(heading), which no forward motion lets
// fall and no backward motion lets rise. Cells have the side h in both. Row s holds the centres x = s h / 2, column d the
// headings with sine d h / (2 r); s + d is even. Cell (s, d) is [a_i, a_i + h] x [b_j, b_j + h], i = (s-d)/2, j = (s+d)/2.
//
// Within a cell the car is in one of the intervals that solids leave free; each keeps one pair (z, w), which bounds
//   forward   z >= y + r cos - (a - a_i) T_hi        w <= y - r cos - (b - b_j) T_lo
//   backward  z >= y + r cos - (a - a_i - h) T_lo    w <= y - r cos - (b - b_j - h) T_hi
// with T_hi and T_lo the largest and the least tangent in the cell. Numbers are whole multiples of 2^-22 m, rounded
// outward: sums are exact, so "nothing was added" is exact, too.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "all_maneuvers/numbers.hpp"
#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/watch.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

/// 2^-22 m.
using Micro = std::int32_t;
constexpr double micro = 0x1p-22;
constexpr Micro nowhere = 805306368;  ///< 192 m: farther than anything
constexpr double farthest_y = 100.0;  ///< the region lies within [m]

/// For certain: what rounding adds is less than a thousandth.
inline Micro rounded_down(double metres) {
    const double exact = metres / micro - 1e-3;
    const auto cut_off = static_cast<Micro>(exact);
    return static_cast<double>(cut_off) > exact ? cut_off - 1 : cut_off;
}
inline Micro rounded_up(double metres) { return -rounded_down(-metres); }

/// Of x or y, open at neither end [m].
struct Interval {
    double low = 0.0, high = 0.0;
};
void sort_rising(std::vector<Interval>& intervals);
void sort_longest_first(std::vector<Interval>& intervals);

/// Of a heading in the chart with that sine.
inline double cosine_of(double sine) { return std::sqrt((1.0 - sine) * (1.0 + sine)); }

/// Cells `from` to `to` of a row.
struct Span {
    int from = 0;
    int to = -1;
    std::size_t begin = 0;  ///< where they are stored

    [[nodiscard]] bool empty() const { return from > to; }
    [[nodiscard]] bool holds(int cell) const { return from <= cell && cell <= to; }
    [[nodiscard]] std::size_t at(int cell) const { return begin + static_cast<std::size_t>(cell - from); }
};

/// Of every row from the first on. Where they are stored there may be numbers of none between them.
struct Spans {
    int first = 0;
    std::vector<Span> rows;
    std::size_t cells = 0;

    [[nodiscard]] Span of(int row) const {
        const int i = row - first;
        return i < 0 || i >= static_cast<int>(rows.size()) ? Span{} : rows[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] int last() const { return first + static_cast<int>(rows.size()) - 1; }
    /// Gives every row its place in the store.
    void store();
    template <class Self, class Pack>
    static void pack(Self& self, Pack& pack) {
        pack(self.first, self.rows, self.cells);
    }
};

/// Within row s the cell of column d.
inline int cell_of(int d) { return d >> 1; }
inline int column_of(int row, int cell) { return 2 * cell + (row & 1); }

using Micros = Numbers<Micro>;
/// For so many that are about to be written; what they were is lost.
void make_room(Micros& numbers, std::size_t count, const std::shared_ptr<NumberStore>& store);

/// Intervals of y, at most one in a cell; low > high where there is none.
struct Layer {
    Spans spans;
    Micros low, high;
};
/// Several in a cell, in any order.
using Limits = std::vector<Layer>;
constexpr std::size_t most_layers = 6;  ///< where there would be more, the nearest are taken together

/// `first` to `last`; none if that is before.
struct Rows {
    int first = 0, last = -1;
};
/// In which any of several have cells.
Rows rows_of(const std::vector<const Limits*>& several);

/// The pairs of one move, layer by layer beside the limits they were made in.
struct Pairs {
    struct Of {
        Micros z, w;
        Spans reached = {};  ///< where they hold anything
    };
    std::vector<Of> layers;
};

inline Direction other(Direction direction) {
    return direction == Direction::forward ? Direction::backward : Direction::forward;
}
constexpr Direction both_directions[] = {Direction::forward, Direction::backward};

/// Something of every move forward and every move backward.
template <class Of>
struct BothWays {
    std::vector<Of> forward, backward;

    std::vector<Of>& of(Direction direction) { return direction == Direction::forward ? forward : backward; }
    const std::vector<Of>& of(Direction direction) const {
        return direction == Direction::forward ? forward : backward;
    }
};

/// Numbers of columns, by parity and cell.
struct ColumnNumbers {
    int first_cell = 0;
    std::vector<Micro> of[2];

    [[nodiscard]] const Micro* at(int row, int cell) const { return of[row & 1].data() + (cell - first_cell); }
};

/// The hull of several in every cell.
Layer hull(const std::vector<const Limits*>& several);

/// Where the cells of a lattice lie.
struct CellGrid {
    double h = 0.0, radius = 0.0, x0 = 0.0, sine0 = 0.0, sine_step = 0.0;

    /// The cell a pose lies in, and what lies between a pair's bounds and y there.
    struct Place {
        int row, column;
        double up, down;  ///< y <= z + up, y >= w + down
    };
    [[nodiscard]] Place place_of(const Pose& pose, Direction direction) const;
};

class OuterLattice {
public:
    /// Cells of side h, the start pose a third of h0 from the corner of one; h0 / h is a power of two. Only within what is
    /// left of the lattice twice as coarse, if given.
    OuterLattice(const ChartPlace& place, double h, double h0, const Layer* coarser, const Watch& watch);

    [[nodiscard]] double h() const { return h_; }
    [[nodiscard]] double x(int row) const { return x0_ + row * (h_ / 2.0); }
    [[nodiscard]] double sine(int column) const { return sine0_ + column * sine_step_; }
    /// What solids and the region leave free, and where the car is parked.
    [[nodiscard]] const Limits& free() const { return free_; }
    [[nodiscard]] const Limits& parked() const { return parked_; }

    /// Everything a move reaches, beside limits. What it begins with is put there by `begin`, some rows at a time, perhaps on other
    /// threads; the limits of these rows are not looked at before. What the pairs held is lost, their memory is used again.
    void sweep(Pairs& pairs, const Limits& limits, Direction direction, const Watch& watch,
               const Call<Rows>& begin) const;
    /// Begins with places in intervals of y.
    void begin(Rows rows, Pairs& pairs, const Limits& limits, Direction direction, const Limits& places) const;
    void begin_at_start(Rows rows, Pairs& pairs, const Limits& limits, Direction direction) const;
    /// Begins with what a move of the other direction has reached, rounded outward to a coarser grid.
    void turn(Rows rows, Pairs& pairs, const Limits& limits, Direction direction, const Pairs& before) const;

    [[nodiscard]] bool holds(const Pairs& pairs, const Limits& limits, Direction direction, const Pose& pose) const;
    [[nodiscard]] bool holds_start(const Pairs& pairs, const Limits& limits, Direction direction) const {
        return holds(pairs, limits, direction, start_);
    }
    /// Limits cut down to what pairs hold, that lie beside them or beside some they are a part of.
    [[nodiscard]] Limits within(const Pairs& pairs, const Limits& limits, Direction direction,
                                const Watch& watch) const;
    /// The free intervals, clipped to what is left of the lattice twice as coarse: room for them, and some rows.
    void room_for_clipped(const Limits& coarser, Limits& clipped, const Watch& watch) const;
    void clip(Rows rows, const Limits& coarser, Limits& clipped) const;

    [[nodiscard]] CellGrid grid() const { return {h_, radius_, x0_, sine0_, sine_step_}; }

    /// Cells computed since that was asked last.
    [[nodiscard]] std::size_t take_updates() const {
        return std::exchange(updates_[0], 0) + std::exchange(updates_[1], 0);
    }

private:
    struct Numbers {
        ColumnNumbers up, down;               ///< y <= z + up, y >= w + down
        ColumnNumbers z_high, w_low;          ///< z <= y + z_high, w >= y - w_low
        ColumnNumbers from_left, from_right;  ///< what z, or w, gains on the way from the column beside
        ColumnNumbers turn_z, turn_w;         ///< and at a change into this direction
    };
    void number_columns();
    /// What stands for the cells given, in a row, is taken in by those of the limits that fit it.
    void offer(Pairs& pairs, const Limits& limits, Direction direction, int row, const Span& given, const Micro* z,
               const Micro* w) const;
    void measure(const ChartPlace& place, const Layer* coarser, const Watch& watch);
    [[nodiscard]] const Numbers& numbers(Direction direction) const {
        return direction == Direction::forward ? forward_ : backward_;
    }

    double h_, radius_, x0_, sine0_, sine_step_;
    Pose start_;
    int first_column_ = 0, last_column_ = 0;
    Numbers forward_, backward_;
    ColumnNumbers apart_;  ///< z - w is at least this
    Limits free_, parked_;
    mutable std::size_t updates_[2] = {};  ///< of moves forward and backward
};

/// The moves with so many changes, one forward and one backward, from those with one less, if there are any. Nothing is clipped.
BothWays<Pairs> next_moves(const OuterLattice& lattice, const Pairs* last_forward, const Pairs* last_backward,
                           const Watch& watch);
bool same(const Pairs& one, const Pairs& two);

}  // namespace snug::detail::sets
