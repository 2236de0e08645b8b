// What is free in the cells of a lattice of sets.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/by_rows.hpp"
#include "all_maneuvers/sets/free_along.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/parents.hpp"
#include "all_maneuvers/workers.hpp"

namespace snug::detail::sets {

namespace {

/// The longest first; where there are more than layers, the nearest are taken together.
void sort_into_layers(std::vector<Interval>& gaps) {
    while (gaps.size() > most_layers) {
        std::size_t nearest = 0;
        for (std::size_t k = 1; k + 1 < gaps.size(); ++k)
            if (gaps[k + 1].low - gaps[k].high < gaps[nearest + 1].low - gaps[nearest].high) nearest = k;
        gaps[nearest].high = gaps[nearest + 1].high;
        gaps.erase(gaps.begin() + static_cast<std::ptrdiff_t>(nearest) + 1);
    }
    sort_longest_first(gaps);
}

/// Cells of some rows, filled in any order.
class Block {
public:
    void put(std::size_t cell, const Interval& interval, std::size_t cells) {
        if (low_.empty()) {
            low_.assign(cells, nowhere);
            high_.assign(cells, -nowhere);
        }
        low_[cell] = rounded_down(interval.low);
        high_[cell] = rounded_up(interval.high);
    }
    void add_to(LayerRows& layer, int first_row, int first_cell, std::size_t width) const {
        for (std::size_t begin = 0; begin < low_.size(); begin += width)
            layer.add(first_row++, first_cell, low_.data() + begin, high_.data() + begin, width);
    }

private:
    std::vector<Micro> low_, high_;
};

}  // namespace

void OuterLattice::measure(const ChartPlace& place, const Layer* coarser, const Watch& watch) {
    // Columns that have a heading of the chart in them.
    int first_column = first_column_, last_column = last_column_;
    while (sine(first_column) + sine_step_ < -steepest_sine) ++first_column;
    while (sine(last_column) - sine_step_ > steepest_sine) --last_column;
    std::vector<Bands> columns(static_cast<std::size_t>(last_column - first_column) + 1);
    in_parts(watch, true, last_column - first_column + 1, [&](int i, const Watch&) {
        columns[static_cast<std::size_t>(i)] = bands_of_cell(place, sine(first_column + i), h_);
    });
    std::optional<Parents> parents;
    if (coarser) parents = Parents{coarser};
    Rows rows = {static_cast<int>(std::floor((place.x_min - h_ - x0_) / (h_ / 2.0))),
                 static_cast<int>(std::ceil((place.x_max + h_ - x0_) / (h_ / 2.0)))};
    if (parents) rows = {std::max(rows.first, parents->rows().first), std::min(rows.last, parents->rows().last)};

    // Column by column, some rows at once, so that bands are measured in vectors; layers are made row by row.
    constexpr std::size_t both = 2 * most_layers;  // those that are free, and where the car is parked in them
    Limits made = made_by_rows(watch, rows, both, [&](Rows some, LayerRows* layers) {
        const auto columns_of = [&](int row) {
            if (!parents) return Span{first_column, last_column, 0};
            const Span children = parents->columns(row);
            return Span{std::max(first_column, children.from), std::min(last_column, children.to), 0};
        };
        Span wanted[rows_at_once], all;
        // By the parity of their rows, as columns have it.
        std::vector<double> xs[2];
        for (int row = some.first; row <= some.last; ++row) {
            xs[row & 1].push_back(x(row));
            const Span& span = wanted[row - some.first] = columns_of(row);
            if (!span.empty())
                all = all.empty() ? span : Span{std::min(all.from, span.from), std::max(all.to, span.to), 0};
        }
        if (all.empty()) return;
        const int first_cell = cell_of(all.from);
        const auto width = static_cast<std::size_t>(cell_of(all.to) - first_cell) + 1;
        Block blocks[both];
        FreeAlong free;
        BandAlong parked;
        std::vector<Interval> gaps;
        for (int d = all.from; d <= all.to; ++d) {
            const auto wants = [&](int row) {
                return wanted[row - some.first].from <= d && d <= wanted[row - some.first].to;
            };
            int from = some.first + ((some.first ^ d) & 1), to = some.last - ((some.last ^ d) & 1);
            while (from <= to && !wants(from)) from += 2;
            while (from <= to && !wants(to)) to -= 2;
            if (from > to) continue;
            const Bands& bands = columns[static_cast<std::size_t>(d - first_column)];
            const auto count = static_cast<std::size_t>(to - from) / 2 + 1;
            const std::span<const double> at = {xs[d & 1].data() + static_cast<std::size_t>(from - some.first) / 2,
                                                count};
            free.measure(bands.region, bands.solids, at);
            const bool may_park = bands.parked.from <= at.back() && bands.parked.to >= at.front();
            if (may_park) parked.measure(bands.parked, at);
            for (int row = from; row <= to; row += 2) {
                if (!wants(row)) continue;
                const auto i = static_cast<std::size_t>(row - from) / 2;
                Interval left = {-farthest_y, farthest_y};
                if (parents) {
                    const auto [low, high] = parents->limits(row, d);
                    left = {low * micro, high * micro};
                }
                free.at(i, left, gaps);
                if (gaps.size() > 1) sort_into_layers(gaps);
                const std::size_t cell = static_cast<std::size_t>(row - some.first) * width +
                                         static_cast<std::size_t>(cell_of(d) - first_cell);
                for (std::size_t k = 0; k < gaps.size(); ++k) {
                    blocks[k].put(cell, gaps[k], rows_at_once * width);
                    if (!may_park) continue;
                    const auto [low, high] = parked.at(i);
                    const Interval inside = {std::max(low, gaps[k].low), std::min(high, gaps[k].high)};
                    if (inside.low <= inside.high) blocks[most_layers + k].put(cell, inside, rows_at_once * width);
                }
            }
        }
        for (std::size_t k = 0; k < both; ++k) blocks[k].add_to(layers[k], some.first, first_cell, width);
    });
    for (std::size_t k = 0; k < most_layers && made[k].spans.cells > 0; ++k) {
        free_.push_back(std::move(made[k]));
        parked_.push_back(std::move(made[most_layers + k]));
    }
}

}  // namespace snug::detail::sets
