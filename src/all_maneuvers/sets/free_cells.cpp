// What is free in the cells of a lattice of sets.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "all_maneuvers/sets/free_along.hpp"
#include "all_maneuvers/sets/layer_builder.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/parents.hpp"

namespace snug::detail::sets {

namespace {

constexpr std::size_t most_layers = 6;  ///< of a cell; where there are more, the nearest are taken together
constexpr int rows_at_once = 128;

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
    /// Leaves nothing here.
    void move_to(LayerBuilder& layer, int first_row, int first_cell, std::size_t width) {
        for (std::size_t begin = 0; begin < low_.size(); begin += width)
            layer.add(first_row++, first_cell, low_.data() + begin, high_.data() + begin, width);
        low_.clear();
        high_.clear();
    }

private:
    std::vector<Micro> low_, high_;
};

}  // namespace

void OuterLattice::measure(const ChartPlace& place, const Layer* coarser, const Watching& watch) {
    // Columns that have a heading of the chart in them.
    int first_column = first_column_, last_column = last_column_;
    while (sine(first_column) + sine_step_ < -steepest_sine) ++first_column;
    while (sine(last_column) - sine_step_ > steepest_sine) --last_column;
    std::vector<Bands> columns;
    columns.reserve(static_cast<std::size_t>(last_column - first_column) + 1);
    for (int d = first_column; d <= last_column; ++d) {
        columns.push_back(bands_of_cell(place, sine(d), h_));
        watch();
    }
    std::optional<Parents> parents;
    if (coarser) parents = Parents{coarser};
    Rows rows = {static_cast<int>(std::floor((place.x_min - h_ - x0_) / (h_ / 2.0))),
                 static_cast<int>(std::ceil((place.x_max + h_ - x0_) / (h_ / 2.0)))};
    if (parents) rows = {std::max(rows.first, parents->rows().first), std::min(rows.last, parents->rows().last)};

    // Column by column, some rows at once, so that bands are measured in vectors; layers are made row by row.
    LayerBuilder found[most_layers], found_parked[most_layers];
    Block free_block[most_layers], parked_block[most_layers];
    const int first_cell = cell_of(first_column);
    const auto width = static_cast<std::size_t>(cell_of(last_column) - first_cell) + 1;
    if (!parents) found[0].expect(static_cast<std::size_t>(rows.last - rows.first + 1) * width);
    std::vector<Span> columns_in(rows_at_once);
    FreeAlong free;
    BandAlong parked;
    std::vector<Interval> gaps;
    for (int block = rows.first; block <= rows.last; block += rows_at_once) {
        watch();
        const int block_end = std::min(block + rows_at_once - 1, rows.last);
        const auto columns_of = [&](int row) -> Span& { return columns_in[static_cast<std::size_t>(row - block)]; };
        Span all;
        for (int row = block; row <= block_end; ++row) {
            Span& span = columns_of(row) = {first_column, last_column, 0};
            if (parents) {
                const Span children = parents->columns(row);
                span = {std::max(span.from, children.from), std::min(span.to, children.to), 0};
            }
            if (span.empty()) continue;
            all = all.empty() ? span : Span{std::min(all.from, span.from), std::max(all.to, span.to), 0};
        }
        // By the parity of their rows, as columns have it.
        std::vector<double> xs[2];
        for (int row = block; row <= block_end; ++row) xs[row & 1].push_back(x(row));
        for (int d = all.from; d <= all.to; ++d) {
            const auto wanted = [&](int row) { return columns_of(row).from <= d && d <= columns_of(row).to; };
            int from = block + ((block ^ d) & 1), to = block_end - ((block_end ^ d) & 1);
            while (from <= to && !wanted(from)) from += 2;
            while (from <= to && !wanted(to)) to -= 2;
            if (from > to) continue;
            const Bands& bands = columns[static_cast<std::size_t>(d - first_column)];
            const auto count = static_cast<std::size_t>(to - from) / 2 + 1;
            const std::span<const double> at = {xs[d & 1].data() + static_cast<std::size_t>(from - block) / 2, count};
            free.measure(bands.region, bands.solids, at);
            const bool may_park = bands.parked.from <= at.back() && bands.parked.to >= at.front();
            if (may_park) parked.measure(bands.parked, at);
            for (int row = from; row <= to; row += 2) {
                if (!wanted(row)) continue;
                const auto i = static_cast<std::size_t>(row - from) / 2;
                Interval left = {-farthest_y, farthest_y};
                if (parents) {
                    const auto [low, high] = parents->limits(row, d);
                    left = {low * micro, high * micro};
                }
                free.at(i, left, gaps);
                if (gaps.size() > 1) sort_into_layers(gaps);
                const std::size_t cell =
                    static_cast<std::size_t>(row - block) * width + static_cast<std::size_t>(cell_of(d) - first_cell);
                for (std::size_t k = 0; k < gaps.size(); ++k) {
                    free_block[k].put(cell, gaps[k], rows_at_once * width);
                    if (!may_park) continue;
                    const auto [low, high] = parked.at(i);
                    const Interval both = {std::max(low, gaps[k].low), std::min(high, gaps[k].high)};
                    if (both.low <= both.high) parked_block[k].put(cell, both, rows_at_once * width);
                }
            }
        }
        for (std::size_t k = 0; k < most_layers; ++k) {
            free_block[k].move_to(found[k], block, first_cell, width);
            parked_block[k].move_to(found_parked[k], block, first_cell, width);
        }
    }
    for (std::size_t k = 0; k < most_layers && !found[k].empty(); ++k) {
        free_.push_back(found[k].done());
        parked_.push_back(found_parked[k].done());
    }
}

}  // namespace snug::detail::sets
