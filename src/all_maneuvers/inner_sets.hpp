// What the car can do: for every node of a lattice over (a, b) and every move, intervals of y from which it parks with so
// many direction changes, driving along the lattice. Nodes are joined by arcs of full steering and, across a cell, by
// turning off from one arc on the way; what is met between nodes is left to be checked.
//
// The lattice is that of outer_sets.hpp with the start pose as node (0, 0). Time runs backward: sets grow outward from where
// the car is parked, and a forward move of the car leaving is a backward move of the car parking.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "all_maneuvers/chart.hpp"
#include "all_maneuvers/outer_sets.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

struct Interval {
    double low = 0.0, high = 0.0;
};

/// Intervals of y for every node of some spans.
struct InnerSet {
    struct Few {
        std::uint32_t begin = 0, count = 0;
    };
    std::vector<Few> of;
    std::vector<Interval> intervals;

    [[nodiscard]] const Interval* begin(std::size_t node) const { return intervals.data() + of[node].begin; }
    [[nodiscard]] const Interval* end(std::size_t node) const { return begin(node) + of[node].count; }
};

class InnerLattice {
public:
    /// Nodes at distance h, within `cells` of the lattice of lower bounds.
    InnerLattice(const ChartPlace& place, double h, double h0, const Layer& cells, const Watching& watch);

    [[nodiscard]] double h() const { return h_; }
    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] double x(int row) const { return start_.x + row * (h_ / 2.0); }
    [[nodiscard]] double sine(int column) const { return start_sine_ + column * sine_step_; }
    /// r cos(heading)
    [[nodiscard]] double level(int column) const { return level_[static_cast<std::size_t>(column - first_column_)]; }
    [[nodiscard]] const Spans& spans() const { return spans_; }
    [[nodiscard]] const InnerSet& free() const { return free_; }
    [[nodiscard]] const InnerSet& parked() const { return parked_; }

    /// The free intervals, clipped to cells of the lattice of lower bounds.
    [[nodiscard]] InnerSet clipped(const Limits& limits) const;
    /// Everything from which a move leads back to `starts`, within `free`.
    [[nodiscard]] InnerSet sweep(const InnerSet& starts, const InnerSet& free, Direction direction,
                                 const Watching& watch) const;
    [[nodiscard]] bool holds(const InnerSet& set, int row, int column, double y) const;
    [[nodiscard]] bool holds_start(const InnerSet& set) const { return holds(set, 0, 0, start_.y); }
    /// Where a node's intervals are, if it is one.
    [[nodiscard]] std::optional<std::size_t> node(int row, int column) const {
        const Span span = spans_.of(row);
        const int cell = cell_of(column);
        if (cell < span.from || cell > span.to) return std::nullopt;
        return span.at(cell);
    }

    mutable std::size_t updates = 0;

private:
    double h_, radius_, sine_step_;
    Pose start_;
    double start_sine_;
    int offset_ = 0;  ///< the node (i, j) lies in the cell (i + offset, j + offset)
    int first_column_ = 0;
    std::vector<double> level_;
    Spans spans_;
    InnerSet free_, parked_;
};

}  // namespace snug::detail::sets
