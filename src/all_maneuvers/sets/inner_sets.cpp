#include "all_maneuvers/sets/inner_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr std::size_t most_intervals = 4;  ///< at a node; more are of no use

Span covering(const Span& one, const Span& other) {
    if (one.empty() || other.empty()) return one.empty() ? other : one;
    return {std::min(one.from, other.from), std::max(one.to, other.to), 0};
}

}  // namespace

void tidy(std::vector<Interval>& intervals, std::size_t most) {
    if (intervals.size() < 2) return;
    sort_rising(intervals);
    std::size_t last = 0;
    for (std::size_t i = 1; i < intervals.size(); ++i) {
        if (intervals[i].low <= intervals[last].high) {
            intervals[last].high = std::max(intervals[last].high, intervals[i].high);
        } else {
            intervals[++last] = intervals[i];
        }
    }
    intervals.resize(last + 1);
    if (intervals.size() > most) {
        sort_longest_first(intervals);
        intervals.resize(most);
        sort_rising(intervals);
    }
}

InnerLattice::InnerLattice(const ChartPlace& place, double h, double h0, const Layer& cells, const Watch& watch)
    : h_(h),
      radius_(place.radius),
      sine_step_(h / (2.0 * place.radius)),
      start_(place.start),
      start_sine_(angles::sin(place.start.heading)),
      cells_(&cells) {
    offset_ = static_cast<int>(std::floor(h0 / 3.0 / h));
    // A node in row s lies in a cell of row s + 2 offset and the same column.
    Spans spans;
    spans.first = cells.spans.first - 2 * offset_;
    int last_column = 0;
    for (Span span : cells.spans.rows) {
        const int row = spans.first + static_cast<int>(spans.rows.size());
        while (!span.empty() && sine(column_of(row, span.from)) < -steepest_sine) ++span.from;
        while (!span.empty() && sine(column_of(row, span.to)) > steepest_sine) --span.to;
        spans.rows.push_back(span);
        if (span.empty()) continue;
        first_column_ = std::min(first_column_, column_of(row, span.from));
        last_column = std::max(last_column, column_of(row, span.to));
    }
    spans.store();
    first_column_ -= 2;
    last_column += 2;
    columns_.reserve(static_cast<std::size_t>(last_column - first_column_) + 1);
    for (int d = first_column_; d <= last_column; ++d) {
        const double s = std::clamp(sine(d), -1.0, 1.0);
        level_.push_back(radius_ * std::sqrt((1.0 - s) * (1.0 + s)));
        columns_.push_back(bands_at(place, s));
        watch();
    }
    free_.spans = spans;
    free_.of = Numbers<InnerSet::Few>(watch.store());
    free_.of.resize(spans.cells, {0, not_measured});
    free_.intervals = Numbers<Interval>(watch.store());
    const auto each_that_may_be_parked = [&](auto&& act) {
        for (int d = first_column_; d <= last_column; ++d) {
            const Band& band = columns_[static_cast<std::size_t>(d - first_column_)].parked;
            if (!(band.from <= band.to)) continue;
            // The band may have no end.
            const auto row_at = [&](double rows) {
                return static_cast<int>(std::clamp(rows, spans.first - 1.0, spans.last() + 1.0));
            };
            const int first = std::max(spans.first, row_at(std::floor((band.from - start_.x) / (h_ / 2.0))));
            const int last = std::min(spans.last(), row_at(std::ceil((band.to - start_.x) / (h_ / 2.0))));
            for (int row = first + ((first ^ d) & 1); row <= last; row += 2)
                if (spans.of(row).holds(cell_of(d))) act(row, cell_of(d), band);
        }
    };
    parked_.spans.first = spans.first;
    parked_.spans.rows.resize(spans.rows.size());
    each_that_may_be_parked([&](int row, int cell, const Band&) {
        Span& span = parked_.spans.rows[static_cast<std::size_t>(row - spans.first)];
        span = covering(span, {cell, cell, 0});
    });
    parked_.spans.store();
    parked_.of.resize(parked_.spans.cells, {0, 0});
    each_that_may_be_parked([&](int row, int cell, const Band& band) {
        double low = 0.0, high = 0.0;
        band.at(x(row), low, high);
        if (low > high) return;
        const InnerSet::Few few = measured(row, spans.of(row), cell);
        InnerSet::Few& mine = parked_.of[parked_.spans.of(row).at(cell)];
        mine.begin = static_cast<std::uint32_t>(parked_.intervals.size());
        for (std::uint32_t i = 0; i < few.count; ++i) {
            const Interval& free = free_.intervals[few.begin + i];
            const Interval both = {std::max(low, free.low) + wary, std::min(high, free.high) - wary};
            if (both.low > both.high) continue;
            parked_.intervals.push_back(both);
            ++mine.count;
        }
    });
}

InnerSet::Few InnerLattice::measured(int row, const Span& span, int cell) {
    InnerSet::Few& few = free_.of[span.at(cell)];
    if (few.count != not_measured) return few;
    few = {static_cast<std::uint32_t>(free_.intervals.size()), 0};
    const std::size_t outer = cells_->spans.of(row + 2 * offset_).at(cell);
    if (cells_->low[outer] > cells_->high[outer]) return few;
    const Bands& bands = columns_[static_cast<std::size_t>(column_of(row, cell) - first_column_)];
    const double here = x(row);
    double low = 0.0, high = 0.0;
    bands.region.at(here, low, high);
    low = std::max(low, cells_->low[outer] * micro);
    high = std::min(high, cells_->high[outer] * micro);
    if (low > high) return few;
    taken_.clear();
    for (const Band& solid : bands.solids) {
        if (here < solid.from || here > solid.to) continue;
        double from = 0.0, to = 0.0;
        solid.at(here, from, to);
        if (from < to && to > low && from < high) taken_.push_back({from, to});
    }
    sort_rising(taken_);
    const auto add = [&](double from, double to) {
        if (from + wary > to - wary) return;
        free_.intervals.push_back({from + wary, to - wary});
        ++few.count;
    };
    double begin = low;
    for (const Interval& solid : taken_) {
        add(begin, solid.low);
        begin = std::max(begin, solid.high);
    }
    add(begin, high);
    return few;
}

InnerSet InnerLattice::sweep(const InnerSet& starts, const Limits& limits, Direction direction, const Watch& watch) {
    InnerSet set;
    set.of = Numbers<InnerSet::Few>(watch.store());
    set.intervals = Numbers<Interval>(watch.store());
    const auto [first_row, last_row] = rows_of({&limits});
    set.spans.first = first_row - 2 * offset_;
    set.spans.rows.resize(static_cast<std::size_t>(std::max(0, last_row - first_row + 1)));
    const bool forward = direction == Direction::forward;
    const int step = forward ? 1 : -1;
    /// Of one layer of the limits in a row.
    struct Cells {
        Span span;
        const Micro *low, *high;
    };
    Cells layers[most_layers];
    std::vector<Interval> rooms, found;
    for (int n = 0; n <= last_row - first_row; ++n) {
        const int row = forward ? set.spans.first + n : set.spans.last() - n;
        if (n % 64 == 0) watch();
        const Span begin_span = starts.spans.of(row), free_span = free_.spans.of(row);
        const Span before = set.spans.of(row - step), before_that = set.spans.of(row - 2 * step);
        const Span free_before = free_.spans.of(row - step);
        Span within;
        std::size_t layer_count = 0;
        for (const Layer& layer : limits) {
            const Span span = layer.spans.of(row + 2 * offset_);
            if (span.empty()) continue;
            within = covering(within, span);
            layers[layer_count++] = {span, layer.low.data() + span.begin, layer.high.data() + span.begin};
        }
        // Cells that anything leads to: what is reached of them is kept.
        Span led = covering(begin_span, before_that);
        if (!before.empty()) led = covering(led, {before.from - 1, before.to + 1, 0});
        led = {std::max({led.from, within.from, free_span.from}), std::min({led.to, within.to, free_span.to}),
               set.of.size()};
        if (led.empty()) continue;
        set.of.resize(set.of.size() + static_cast<std::size_t>(led.to - led.from) + 1, {0, 0});
        Span& reached = set.spans.rows[static_cast<std::size_t>(row - set.spans.first)];
        for (int cell = led.from; cell <= led.to; ++cell) {
            const int d = column_of(row, cell);
            const int left = cell_of(d - 1), right = cell_of(d + 1);
            const InnerSet::Range begins = starts.at(begin_span, cell), from_before_that = set.at(before_that, cell);
            const InnerSet::Range lefts = set.at(before, left), rights = set.at(before, right);
            if (begins.empty() && lefts.empty() && rights.empty() && from_before_that.empty()) continue;
            ++updates;
            const InnerSet::Few free = measured(row, free_span, cell);
            rooms.clear();
            for (std::size_t m = 0; m < layer_count; ++m) {
                const Cells& cells = layers[m];
                if (!cells.span.holds(cell)) continue;
                const int i = cell - cells.span.from;
                const double low = cells.low[i] * micro, high = cells.high[i] * micro;
                for (std::uint32_t k = free.begin; k < free.begin + free.count; ++k) {
                    const Interval& gap = free_.intervals[k];
                    if (low <= gap.high && gap.low <= high)
                        rooms.push_back({std::max(low, gap.low), std::min(high, gap.high)});
                }
            }
            if (rooms.empty()) continue;
            found.clear();
            const auto add = [&](double low, double high) {
                for (const Interval& room : rooms) {
                    const double from = std::max(low, room.low), to = std::min(high, room.high);
                    if (from > to) continue;
                    // Mostly it overlaps the one before.
                    if (!found.empty() && from <= found.back().high && found.back().low <= to) {
                        found.back() = {std::min(from, found.back().low), std::max(to, found.back().high)};
                    } else {
                        found.push_back({from, to});
                    }
                }
            };
            for (const Interval& begin : begins) add(begin.low, begin.high);
            // From the column to the left the car keeps y + r cos forward, from the right y - r cos; backward the reverse.
            const double from_left = step * (level(d - 1) - level(d)), from_right = step * (level(d) - level(d + 1));
            for (const Interval& from : lefts) add(from.low + from_left, from.high + from_left);
            for (const Interval& from : rights) add(from.low + from_right, from.high + from_right);
            // Across a cell: by way of one side, of the other, or turning off in between, where both are free.
            if (!from_before_that.empty() && left >= free_before.from && right <= free_before.to) {
                const double least = 2.0 * std::min(from_left, from_right),
                             most = 2.0 * std::max(from_left, from_right);
                const InnerSet::Few ones = measured(row - step, free_before, left),
                                    others = measured(row - step, free_before, right);
                for (const Interval& from : from_before_that) {
                    for (std::uint32_t i = ones.begin; i < ones.begin + ones.count; ++i) {
                        for (std::uint32_t j = others.begin; j < others.begin + others.count; ++j) {
                            const Interval &one = free_.intervals[i], &other = free_.intervals[j];
                            const double low = std::max({from.low, one.low - from_left, other.low - from_right});
                            const double high = std::min({from.high, one.high - from_left, other.high - from_right});
                            if (low <= high) add(low + least, high + most);
                        }
                    }
                }
            }
            if (found.empty()) continue;
            tidy(found, most_intervals);
            set.of[led.at(cell)] = {static_cast<std::uint32_t>(set.intervals.size()),
                                    static_cast<std::uint32_t>(found.size())};
            for (const Interval& interval : found) set.intervals.push_back(interval);
            if (reached.empty()) reached = {cell, cell, led.at(cell)};
            reached.to = cell;
        }
        set.of.resize(reached.empty() ? led.begin : reached.at(reached.to) + 1);
    }
    set.spans.cells = set.of.size();
    set.of.shrink_to_fit();
    set.intervals.shrink_to_fit();
    return set;
}

}  // namespace snug::detail::sets
