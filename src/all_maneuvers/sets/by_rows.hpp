// Layers made some rows at a time, on as many threads as there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/workers.hpp"

namespace snug::detail::sets {

/// Some rows of a layer.
class LayerRows {
public:
    [[nodiscard]] bool empty() const { return low_.empty(); }
    /// Intervals of cells from one on, low > high where there is none. Rows in rising order; what is not added holds nothing.
    void add(int row, int first_cell, const Micro* low, const Micro* high, std::size_t count) {
        std::size_t begin = 0;
        while (begin < count && low[begin] > high[begin]) ++begin;
        while (begin < count && low[count - 1] > high[count - 1]) --count;
        if (begin == count) return;
        if (empty()) spans_.first = row;
        while (spans_.last() < row) spans_.rows.emplace_back();
        spans_.rows.back() = {first_cell + static_cast<int>(begin), first_cell + static_cast<int>(count) - 1, 0};
        low_.insert(low_.end(), low + begin, low + count);
        high_.insert(high_.end(), high + begin, high + count);
    }

    friend Limits made_by_rows(const Watch& watch, Rows rows, std::size_t layers, const Call<Rows, LayerRows*>& make);

private:
    Spans spans_;
    std::vector<Micro> low_, high_;
};

constexpr std::size_t worth_threads = 50'000;  ///< cells
inline bool is_large(const Limits& limits) {
    std::size_t cells = 0;
    for (const Layer& layer : limits) cells += layer.spans.cells;
    return cells > worth_threads;
}
constexpr int rows_at_once = 64;
inline int blocks_of(Rows rows) { return rows.first > rows.last ? 0 : (rows.last - rows.first) / rows_at_once + 1; }

/// Does something for all rows, some at a time, perhaps at the same time as others.
template <class Do>
void in_blocks(const Watch& watch, bool worth_while, Rows rows, const Do& act) {
    in_parts(watch, worth_while, blocks_of(rows), [&](int block, const Watch&) {
        const int first = rows.first + block * rows_at_once;
        act(Rows{first, std::min(first + rows_at_once - 1, rows.last)});
    });
}

/// So many layers. `make` is told some of the rows at a time, perhaps at the same time as others, and where to add those of each
/// layer.
Limits made_by_rows(const Watch& watch, Rows rows, std::size_t layers, const Call<Rows, LayerRows*>& make);

}  // namespace snug::detail::sets
