// Layers of intervals: what of them is left, and where they lie. Not what a map is made of, so that it may be slower than that.
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/layer_builder.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/parents.hpp"
#include "all_maneuvers/sets/set_sweep.hpp"

namespace snug::detail::sets {

void Spans::store() {
    cells = 0;
    for (Span& span : rows) {
        span.begin = cells;
        if (!span.empty()) cells += static_cast<std::size_t>(span.to - span.from) + 1;
    }
}

Rows rows_of(const std::vector<const Limits*>& several) {
    Rows all;
    for (const Limits* limits : several) {
        for (const Layer& layer : *limits) {
            const Spans& spans = layer.spans;
            if (spans.rows.empty()) continue;
            const bool none_yet = all.first > all.last;
            all.first = none_yet ? spans.first : std::min(all.first, spans.first);
            all.last = none_yet ? spans.last() : std::max(all.last, spans.last());
        }
    }
    return all;
}

Layer hull(const std::vector<const Limits*>& several) {
    Layer all;
    const Rows rows = rows_of(several);
    all.spans.first = rows.first;
    all.spans.rows.resize(static_cast<std::size_t>(rows.last - rows.first) + 1);
    const auto each = [&](auto&& act) {
        for (const Limits* limits : several)
            for (const Layer& layer : *limits)
                for (int row = layer.spans.first; row <= layer.spans.last(); ++row)
                    if (const Span span = layer.spans.of(row); !span.empty()) act(layer, row, span);
    };
    each([&](const Layer&, int row, const Span& span) {
        Span& mine = all.spans.rows[static_cast<std::size_t>(row - rows.first)];
        if (mine.empty()) {
            mine = span;
        } else {
            mine.from = std::min(mine.from, span.from);
            mine.to = std::max(mine.to, span.to);
        }
    });
    all.spans.store();
    all.low.assign(all.spans.cells + vector_padding, nowhere);
    all.high.assign(all.spans.cells + vector_padding, -nowhere);
    each([&](const Layer& layer, int row, const Span& span) {
        const Span mine = all.spans.of(row);
        for (int cell = span.from; cell <= span.to; ++cell) {
            const std::size_t i = mine.at(cell);
            all.low[i] = std::min(all.low[i], layer.low[span.at(cell)]);
            all.high[i] = std::max(all.high[i], layer.high[span.at(cell)]);
        }
    });
    return all;
}

Limits OuterLattice::clipped(const Limits& coarser) const {
    std::vector<Parents> parents;
    for (const Layer& layer : coarser) parents.push_back({&layer});
    std::vector<Micro> lows, highs;
    Limits limits;
    for (const Layer& layer : free_) {
        LayerBuilder mine;
        for (int row = layer.spans.first; row <= layer.spans.last(); ++row) {
            const Span span = layer.spans.of(row);
            int from = span.to + 1, to = span.from - 1;
            for (const Parents& of : parents) {
                const Span columns = of.columns(row);
                if (columns.empty()) continue;
                from = std::min(from, std::max(span.from, cell_of(columns.from)));
                to = std::max(to, std::min(span.to, cell_of(columns.to)));
            }
            if (from > to) continue;
            const auto count = static_cast<std::size_t>(to - from) + 1;
            lows.assign(count, nowhere);
            highs.assign(count, -nowhere);
            for (int cell = from; cell <= to; ++cell) {
                const Micro free_low = layer.low[span.at(cell)], free_high = layer.high[span.at(cell)];
                if (free_low > free_high) continue;
                const int column = column_of(row, cell);
                Micro &low = lows[static_cast<std::size_t>(cell - from)],
                      &high = highs[static_cast<std::size_t>(cell - from)];
                for (const Parents& of : parents) {
                    const auto [least, most] = of.limits(row, column);
                    const Micro lower = std::max(free_low, least), upper = std::min(free_high, most);
                    if (lower > upper) continue;
                    low = std::min(low, lower);
                    high = std::max(high, upper);
                }
            }
            mine.add(row, from, lows.data(), highs.data(), count);
        }
        limits.push_back(mine.done());
    }
    return limits;
}

Pairs laid_out(const Pairs& pairs, const Limits& limits, const Limits& part) {
    Pairs all;
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const Spans& spans = part[k].spans;
        Pairs::Of mine{std::vector<Micro>(spans.cells + vector_padding, -nowhere),
                       std::vector<Micro>(spans.cells + vector_padding, nowhere)};
        for (int row = spans.first; row <= spans.last(); ++row) {
            const Span span = spans.of(row);
            if (span.empty()) continue;
            const auto from = static_cast<std::ptrdiff_t>(limits[k].spans.of(row).at(span.from));
            const auto to = static_cast<std::ptrdiff_t>(span.begin), count = std::ptrdiff_t(span.to) - span.from + 1;
            std::copy_n(pairs.layers[k].z.begin() + from, count, mine.z.begin() + to);
            std::copy_n(pairs.layers[k].w.begin() + from, count, mine.w.begin() + to);
        }
        all.layers.push_back(std::move(mine));
    }
    return all;
}

Limits OuterLattice::within(const Pairs& pairs, const Limits& limits, Direction direction) const {
    const Numbers& of = numbers(direction);
    Limits all;
    std::vector<Micro> lows, highs;
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const Layer& layer = limits[k];
        LayerBuilder mine;
        for (int row = layer.spans.first; row <= layer.spans.last(); ++row) {
            const Span span = layer.spans.of(row);
            if (span.empty()) continue;
            const auto count = static_cast<std::size_t>(span.to - span.from) + 1;
            lows.resize(count);
            highs.resize(count);
            const Micro *z = pairs.layers[k].z.data() + span.begin, *w = pairs.layers[k].w.data() + span.begin;
            const Micro *free_low = layer.low.data() + span.begin, *free_high = layer.high.data() + span.begin;
            const Micro *up = of.up.at(row, span.from), *down = of.down.at(row, span.from);
            for (std::size_t i = 0; i < count; ++i) {
                const Micro low = std::max(free_low[i], w[i] + down[i]), high = std::min(free_high[i], z[i] + up[i]);
                lows[i] = low <= high ? low : nowhere;
                highs[i] = low <= high ? high : -nowhere;
            }
            mine.add(row, span.from, lows.data(), highs.data(), count);
        }
        all.push_back(mine.done());
    }
    return all;
}

}  // namespace snug::detail::sets
