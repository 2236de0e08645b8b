// A layer made cell by cell, row after row.
#pragma once

#include <cstddef>
#include <utility>

#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/set_sweep.hpp"

namespace snug::detail::sets {

/// Cells in rising order; what lies between them holds nothing.
class LayerBuilder {
public:
    [[nodiscard]] bool empty() const { return layer_.low.empty(); }
    void expect(std::size_t cells) {
        layer_.low.reserve(cells + vector_padding);
        layer_.high.reserve(cells + vector_padding);
    }
    void add(int row, int cell, Micro low, Micro high) {
        Spans& spans = layer_.spans;
        if (empty()) spans.first = row;
        while (spans.last() < row) spans.rows.push_back({0, -1, layer_.low.size()});
        Span& span = spans.rows.back();
        if (span.empty()) span = {cell, cell - 1, span.begin};
        for (; span.to < cell; ++span.to) {
            layer_.low.push_back(nowhere);
            layer_.high.push_back(-nowhere);
        }
        layer_.low.back() = low;
        layer_.high.back() = high;
    }
    /// The same for a stretch of a row.
    void add(int row, int first_cell, const Micro* low, const Micro* high, std::size_t count) {
        std::size_t begin = 0;
        while (begin < count && low[begin] > high[begin]) ++begin;
        while (begin < count && low[count - 1] > high[count - 1]) --count;
        if (begin == count) return;
        add(row, first_cell + static_cast<int>(begin), low[begin], high[begin]);
        layer_.spans.rows.back().to = first_cell + static_cast<int>(count) - 1;
        layer_.low.insert(layer_.low.end(), low + begin + 1, low + count);
        layer_.high.insert(layer_.high.end(), high + begin + 1, high + count);
    }
    Layer done() {
        layer_.spans.cells = layer_.low.size();
        layer_.low.resize(layer_.spans.cells + vector_padding, nowhere);
        layer_.high.resize(layer_.spans.cells + vector_padding, -nowhere);
        layer_.low.shrink_to_fit();
        layer_.high.shrink_to_fit();
        return std::move(layer_);
    }

private:
    Layer layer_;
};

}  // namespace snug::detail::sets
