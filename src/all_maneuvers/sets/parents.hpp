// A layer of the lattice twice as coarse, as the cells of a lattice see it: cell (S, D) has its children in columns 2 D of rows
// 2 S and 2 S + 2, and in columns 2 D - 1 and 2 D + 1 of row 2 S + 1.
#pragma once

#include <algorithm>
#include <cstddef>

#include "all_maneuvers/sets/outer_sets.hpp"

namespace snug::detail::sets {

struct Parents {
    const Layer* layer;

    [[nodiscard]] Rows rows() const {
        return layer->spans.rows.empty() ? Rows{} : Rows{2 * layer->spans.first, 2 * layer->spans.last() + 2};
    }
    /// All children in a row lie between these columns.
    [[nodiscard]] Span columns(int row) const {
        Span all;
        const auto parents = [&](int parent_row, int beside) {
            const Span span = layer->spans.of(parent_row);
            if (span.empty()) return;
            const int from = 2 * column_of(parent_row, span.from) - beside;
            const int to = 2 * column_of(parent_row, span.to) + beside;
            all = all.empty() ? Span{from, to, 0} : Span{std::min(all.from, from), std::max(all.to, to), 0};
        };
        if ((row & 1) == 0) {
            parents(row / 2, 0);
            parents(row / 2 - 1, 0);
        } else {
            parents((row - 1) >> 1, 1);
        }
        return all;
    }
    /// Of the cells of a row from one on; where there is no parent, the numbers stay as they are.
    void limits(int row, int first_cell, std::size_t count, Micro* low, Micro* high) const {
        const int last_cell = first_cell + static_cast<int>(count) - 1;
        const auto give = [&](int parent_row, int beside) {
            const Span span = layer->spans.of(parent_row);
            const int shift = (parent_row & 1) - beside;  // parent p has a child in cell 2 p + shift
            const int from = std::max(span.from, (first_cell - shift + 1) >> 1);
            const int to = std::min(span.to, (last_cell - shift) >> 1);
            if (from > to) return;
            const Micro *parents_low = layer->low.data() + span.at(from),
                        *parents_high = layer->high.data() + span.at(from);
            const auto first = static_cast<std::size_t>(2 * from + shift - first_cell);
            const auto parents = static_cast<std::size_t>(to - from) + 1;
            for (std::size_t i = 0; i < parents; ++i) {
                low[first + 2 * i] = parents_low[i];
                high[first + 2 * i] = parents_high[i];
            }
        };
        if ((row & 1) == 0) {
            give(row / 2, 0);
            give(row / 2 - 1, 0);
        } else {
            give((row - 1) >> 1, 0);
            give((row - 1) >> 1, 1);
        }
    }
    struct Limit {
        Micro low, high;
    };
    /// Of the parent; low > high where there is none.
    [[nodiscard]] Limit limits(int row, int column) const {
        const int i = ((row - column) / 2) >> 1, j = ((row + column) / 2) >> 1;
        const Span span = layer->spans.of(i + j);
        const int cell = cell_of(j - i);
        if (cell < span.from || cell > span.to) return {nowhere, -nowhere};
        return {layer->low[span.at(cell)], layer->high[span.at(cell)]};
    }
};

}  // namespace snug::detail::sets
