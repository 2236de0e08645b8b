// What the car can do: for every node of a lattice over (a, b) and every move, intervals of y from which it parks with so
// many direction changes, driving along the lattice. Nodes are joined by arcs of full steering and, across a cell, by
// turning off from one arc on the way; what is met between nodes is left to be checked.
//
// The lattice is that of outer_sets.hpp with the start pose as node (0, 0). Time runs backward: sets grow outward from where
// the car is parked, and a forward move of the car leaving is a backward move of the car parking.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

constexpr double wary = 1e-7;  ///< so much is kept from the ends of intervals: sums are rounded [m]
/// So far outside of them a car that touches something may be: they are clipped twice. [m]
constexpr double at_an_end = 2.0 * wary + 1e-8;

/// Intervals of y for nodes.
struct InnerSet {
    struct Few {
        std::uint32_t begin = 0, count = 0;
    };
    struct Range {
        const Interval *first = nullptr, *last = nullptr;

        [[nodiscard]] const Interval* begin() const { return first; }
        [[nodiscard]] const Interval* end() const { return last; }
        [[nodiscard]] bool empty() const { return first == last; }
        /// How far y is inside one of them, less than nothing at their very ends; -1 outside.
        [[nodiscard]] double room(double y) const {
            double most = -1.0;
            for (const Interval& interval : *this) {
                const double inside = std::min(y - interval.low, interval.high - y);
                if (inside >= -at_an_end) most = std::max(most, inside);
            }
            return most;
        }
    };
    Spans spans;
    Numbers<Few> of;
    Numbers<Interval> intervals;

    [[nodiscard]] Range at(const Span& span, int cell) const {
        if (cell < span.from || cell > span.to) return {};
        const Few few = of[span.at(cell)];
        return {intervals.data() + few.begin, intervals.data() + few.begin + few.count};
    }
    [[nodiscard]] Range at(int row, int column) const { return at(spans.of(row), cell_of(column)); }
};

constexpr std::uint32_t not_measured = 0xFFFFFFFF;  ///< as a count

/// In rising order; overlapping ones become one, of many the longest are kept.
void tidy(std::vector<Interval>& intervals, std::size_t most);

class InnerLattice {
public:
    /// Nodes at distance h, within `cells` of the lattice of lower bounds, which must outlive it.
    InnerLattice(const ChartPlace& place, double h, double h0, const Layer& cells, const Watch& watch);

    [[nodiscard]] double h() const { return h_; }
    [[nodiscard]] double radius() const { return radius_; }
    [[nodiscard]] double x(int row) const { return start_.x + row * (h_ / 2.0); }
    [[nodiscard]] double sine(int column) const { return start_sine_ + column * sine_step_; }
    /// r cos(heading)
    [[nodiscard]] double level(int column) const { return level_[static_cast<std::size_t>(column - first_column_)]; }
    [[nodiscard]] const InnerSet& parked() const { return parked_; }

    /// Everything from which a move leads back to `starts`, within `limits` of the lattice of lower bounds.
    [[nodiscard]] InnerSet sweep(const InnerSet& starts, const Limits& limits, Direction direction, const Watch& watch);
    [[nodiscard]] bool holds_start(const InnerSet& set) const { return set.at(0, 0).room(start_.y) > -1.0; }

    std::size_t updates = 0;

private:
    /// What solids and the region leave free at a node of the spans; measured when first asked for.
    InnerSet::Few measured(int row, const Span& span, int cell);

    double h_, radius_, sine_step_;
    Pose start_;
    double start_sine_;
    int offset_ = 0;  ///< the node (i, j) lies in the cell (i + offset, j + offset)
    int first_column_ = 0;
    std::vector<double> level_;
    const Layer* cells_;
    std::vector<Bands> columns_;
    InnerSet free_, parked_;
    std::vector<Interval> taken_;
};

}  // namespace snug::detail::sets
