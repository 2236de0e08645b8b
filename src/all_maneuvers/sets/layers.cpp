// Layers of intervals: what of them is left, and where they lie. Not what a map is made of, so that it may be slower than that.
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/by_rows.hpp"
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

void make_room(Micros& numbers, std::size_t count, const std::shared_ptr<NumberStore>& store) {
    if (count > numbers.capacity()) {
        const std::size_t room = std::max(count, 2 * numbers.capacity());  // where the next ones are larger, too
        numbers = Micros(store);
        numbers.reserve(room);
    }
    numbers.resize(count);
}

namespace {

/// For cells that are about to be written.
void lay_out(Layer& layer, const std::shared_ptr<NumberStore>& store) {
    layer.spans.store();
    make_room(layer.low, layer.spans.cells + vector_padding, store);
    make_room(layer.high, layer.spans.cells + vector_padding, store);
}

}  // namespace

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
    all.low.resize(all.spans.cells + vector_padding, nowhere);
    all.high.resize(all.spans.cells + vector_padding, -nowhere);
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

Limits made_by_rows(const Watch& watch, Rows rows, std::size_t layers, const Call<Rows, LayerRows*>& make) {
    const int blocks = blocks_of(rows);
    std::vector<LayerRows> made(layers * static_cast<std::size_t>(blocks));
    const auto of = [&](int block) { return made.data() + layers * static_cast<std::size_t>(block); };
    in_blocks(watch, true, rows, [&](Rows some) { make(some, of((some.first - rows.first) / rows_at_once)); });
    Limits all(layers);
    for (std::size_t k = 0; k < layers; ++k) {
        // In one piece: rows between those that hold anything stay empty.
        Layer& layer = all[k];
        std::vector<std::size_t> begins;
        std::size_t cells = 0;
        for (int block = 0; block < blocks; ++block) {
            LayerRows& some = of(block)[k];
            begins.push_back(cells);
            cells += some.low_.size();
            if (some.empty()) continue;
            if (layer.spans.rows.empty()) layer.spans.first = some.spans_.first;
            layer.spans.rows.resize(static_cast<std::size_t>(some.spans_.first - layer.spans.first));
            layer.spans.rows.insert(layer.spans.rows.end(), some.spans_.rows.begin(), some.spans_.rows.end());
        }
        lay_out(layer, watch.store());
        in_parts(watch, cells > worth_threads, blocks, [&](int block, const Watch&) {
            LayerRows some = std::move(of(block)[k]);
            const auto begin = static_cast<std::ptrdiff_t>(begins[static_cast<std::size_t>(block)]);
            std::copy(some.low_.begin(), some.low_.end(), layer.low.begin() + begin);
            std::copy(some.high_.begin(), some.high_.end(), layer.high.begin() + begin);
        });
    }
    return all;
}

namespace {

/// Tells `write` where cells of some rows of a layer go; those at either end that hold nothing are dropped then.
template <class Write>
void write_rows(Layer& layer, Rows rows, const Write& write) {
    Spans& spans = layer.spans;
    for (int row = std::max(rows.first, spans.first); row <= std::min(rows.last, spans.last()); ++row) {
        Span& span = spans.rows[static_cast<std::size_t>(row - spans.first)];
        if (span.empty()) continue;
        const auto count = static_cast<std::size_t>(span.to - span.from) + 1;
        Micro *low = layer.low.data() + span.begin, *high = layer.high.data() + span.begin;
        std::fill_n(low, count, nowhere);
        std::fill_n(high, count, -nowhere);
        write(row, span.from, low, high, count);
        while (!span.empty() && *low > *high) ++span.from, ++span.begin, ++low, ++high;
        while (!span.empty() && layer.low[span.at(span.to)] > layer.high[span.at(span.to)]) --span.to;
    }
}

}  // namespace

void OuterLattice::room_for_clipped(const Limits& coarser, Limits& clipped, const Watch& watch) const {
    std::vector<Parents> parents;
    for (const Layer& layer : coarser) parents.push_back({&layer});
    clipped.resize(free_.size());
    for (std::size_t k = 0; k < free_.size(); ++k) {
        const Layer& layer = free_[k];
        Layer& mine = clipped[k];
        mine.spans.first = layer.spans.first;
        mine.spans.rows.clear();
        for (const Span& all : layer.spans.rows) {
            const int row = layer.spans.first + static_cast<int>(mine.spans.rows.size());
            Span span = {all.to + 1, all.from - 1, 0};
            for (const Parents& of : parents) {
                const Span columns = of.columns(row);
                if (columns.empty()) continue;
                span.from = std::min(span.from, std::max(all.from, cell_of(columns.from)));
                span.to = std::max(span.to, std::min(all.to, cell_of(columns.to)));
            }
            mine.spans.rows.push_back(span.empty() ? Span{} : span);
        }
        lay_out(mine, watch.store());
    }
}

void OuterLattice::clip(Rows rows, const Limits& coarser, Limits& clipped) const {
    std::vector<Parents> parents;
    for (const Layer& layer : coarser) parents.push_back({&layer});
    std::vector<Micro> least, most;
    for (std::size_t k = 0; k < free_.size(); ++k) {
        const Layer& layer = free_[k];
        write_rows(clipped[k], rows, [&](int row, int first, Micro* low, Micro* high, std::size_t count) {
            const std::size_t at = layer.spans.of(row).at(first);
            for (const Parents& of : parents) {
                least.assign(count + vector_padding, nowhere);
                most.assign(count + vector_padding, -nowhere);
                of.limits(row, first, count, least.data(), most.data());
                cut({low, high, layer.low.data() + at, layer.high.data() + at, least.data(), most.data(), nullptr,
                     nullptr},
                    count);
            }
        });
    }
}

Limits OuterLattice::within(const Pairs& pairs, const Limits& limits, Direction direction, const Watch& watch) const {
    const Numbers& of = numbers(direction);
    Limits all(limits.size());
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const Spans &spans = limits[k].spans, &reached = pairs.layers[k].reached;
        all[k].spans = {spans.first, {}, 0};
        for (int row = spans.first; row <= spans.last(); ++row) {
            const Span mine = spans.of(row), theirs = reached.of(row);
            const Span both = {std::max(mine.from, theirs.from), std::min(mine.to, theirs.to), 0};
            all[k].spans.rows.push_back(both.empty() ? Span{} : both);
        }
    }
    for (Layer& layer : all) lay_out(layer, watch.store());
    in_blocks(watch, is_large(all), rows_of({&all}), [&](Rows rows) {
        for (std::size_t k = 0; k < limits.size(); ++k) {
            const Layer& layer = limits[k];
            const Pairs::Of& theirs = pairs.layers[k];
            write_rows(all[k], rows, [&](int row, int first, Micro* low, Micro* high, std::size_t count) {
                const std::size_t at = layer.spans.of(row).at(first), pair = theirs.reached.of(row).at(first);
                cut({low, high, layer.low.data() + at, layer.high.data() + at, theirs.w.data() + pair,
                     theirs.z.data() + pair, of.down.at(row, first), of.up.at(row, first)},
                    count);
            });
        }
    });
    return all;
}

}  // namespace snug::detail::sets
