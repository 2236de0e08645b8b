#include "all_maneuvers/inner_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr double wary = 1e-7;  ///< so much is kept from the ends of intervals: sums are rounded [m]
constexpr std::size_t most_intervals = 4;  ///< at a node; more are of no use

/// Overlapping ones become one, of many the longest are kept.
void tidy(std::vector<Interval>& intervals) {
    if (intervals.size() < 2) return;
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < intervals.size(); ++i) {
        if (intervals[i].low <= intervals[last].high) {
            intervals[last].high = std::max(intervals[last].high, intervals[i].high);
        } else {
            intervals[++last] = intervals[i];
        }
    }
    intervals.resize(last + 1);
    if (intervals.size() > most_intervals) {
        std::sort(intervals.begin(), intervals.end(),
                  [](const Interval& a, const Interval& b) { return a.high - a.low > b.high - b.low; });
        intervals.resize(most_intervals);
    }
}

}  // namespace

InnerLattice::InnerLattice(const ChartPlace& place, double h, double h0, const Layer& cells, const Watching& watch)
    : h_(h),
      radius_(place.radius),
      sine_step_(h / (2.0 * place.radius)),
      start_(place.start),
      start_sine_(angles::sin(place.start.heading)) {
    offset_ = static_cast<int>(std::floor(h0 / 3.0 / h));
    // A node in row s lies in a cell of row s + 2 offset and the same column.
    Spans spans;
    spans.first = cells.spans.first - 2 * offset_;
    for (Span span : cells.spans.rows) {
        const int row = spans.first + static_cast<int>(spans.rows.size());
        while (!span.empty() && sine(column_of(row, span.from)) < -steepest_sine) ++span.from;
        while (!span.empty() && sine(column_of(row, span.to)) > steepest_sine) --span.to;
        spans.rows.push_back(span);
    }
    spans.store();
    int last_column = 0;
    for (int row = spans.first; row <= spans.last(); ++row) {
        const Span span = spans.of(row);
        if (span.empty()) continue;
        first_column_ = std::min(first_column_, column_of(row, span.from));
        last_column = std::max(last_column, column_of(row, span.to));
    }
    first_column_ -= 2;
    last_column += 2;
    std::vector<Bands> columns;
    for (int d = first_column_; d <= last_column; ++d) {
        const double s = std::clamp(sine(d), -1.0, 1.0);
        level_.push_back(radius_ * std::sqrt((1.0 - s) * (1.0 + s)));
        columns.push_back(bands_at(place, s));
        watch();
    }
    free_.of.resize(spans.cells);
    parked_.of.resize(spans.cells);
    free_.spans = parked_.spans = spans;
    std::vector<Interval> taken;
    for (int row = spans.first; row <= spans.last(); ++row) {
        const Span span = spans.of(row), of_cells = cells.spans.of(row + 2 * offset_);
        const double here = x(row);
        for (int cell = span.from; cell <= span.to; ++cell) {
            const std::size_t node = span.at(cell), outer = of_cells.at(cell);
            free_.of[node].begin = static_cast<std::uint32_t>(free_.intervals.size());
            parked_.of[node].begin = static_cast<std::uint32_t>(parked_.intervals.size());
            if (cells.low[outer] > cells.high[outer]) continue;
            const Bands& bands = columns[static_cast<std::size_t>(column_of(row, cell) - first_column_)];
            double low = 0.0, high = 0.0;
            bands.region.at(here, low, high);
            low = std::max(low, cells.low[outer] * micro);
            high = std::min(high, cells.high[outer] * micro);
            if (low > high) continue;
            double parked_low = 0.0, parked_high = 0.0;
            bands.parked.at(here, parked_low, parked_high);
            taken.clear();
            for (const Band& solid : bands.solids) {
                if (here < solid.from || here > solid.to) continue;
                double from_y = 0.0, to_y = 0.0;
                solid.at(here, from_y, to_y);
                if (from_y < to_y && to_y > low && from_y < high) taken.push_back({from_y, to_y});
            }
            std::sort(taken.begin(), taken.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
            const auto add = [&](double from_y, double to_y) {
                if (from_y + wary > to_y - wary) return;
                free_.intervals.push_back({from_y + wary, to_y - wary});
                ++free_.of[node].count;
                from_y = std::max(from_y, parked_low);
                to_y = std::min(to_y, parked_high);
                if (from_y + 2.0 * wary > to_y - 2.0 * wary) return;
                parked_.intervals.push_back({from_y + 2.0 * wary, to_y - 2.0 * wary});
                ++parked_.of[node].count;
            };
            double begin = low;
            for (const Interval& interval : taken) {
                if (interval.low > begin) add(begin, interval.low);
                begin = std::max(begin, interval.high);
            }
            if (begin < high) add(begin, high);
        }
    }
}

InnerSet InnerLattice::clipped(const Limits& limits) const {
    InnerSet set;
    int first = 0, last = -1;
    for (const Layer& layer : limits) {
        if (layer.spans.rows.empty()) continue;
        first = first > last ? layer.spans.first : std::min(first, layer.spans.first);
        last = std::max(last, layer.spans.last());
    }
    set.spans.first = first - 2 * offset_;
    for (int row = first; row <= last; ++row) {
        Span mine;
        for (const Layer& layer : limits) {
            const Span span = layer.spans.of(row);
            if (span.empty()) continue;
            mine.from = mine.empty() ? span.from : std::min(mine.from, span.from);
            mine.to = std::max(mine.to, span.to);
        }
        const Span free = free_.spans.of(row - 2 * offset_);
        mine.from = std::max(mine.from, free.from);
        mine.to = std::min(mine.to, free.to);
        set.spans.rows.push_back(mine);
    }
    set.spans.store();
    set.of.resize(set.spans.cells);
    std::vector<Interval> found;
    for (int row = set.spans.first; row <= set.spans.last(); ++row) {
        const Span span = set.spans.of(row), free_span = free_.spans.of(row);
        for (int cell = span.from; cell <= span.to; ++cell) {
            found.clear();
            for (const Layer& layer : limits) {
                const Span cells = layer.spans.of(row + 2 * offset_);
                if (cell < cells.from || cell > cells.to) continue;
                const double low = layer.low[cells.at(cell)] * micro, high = layer.high[cells.at(cell)] * micro;
                for (const Interval& free : free_.at(free_span, cell)) {
                    const Interval both = {std::max(low, free.low), std::min(high, free.high)};
                    if (both.low <= both.high) found.push_back(both);
                }
            }
            tidy(found);
            set.of[span.at(cell)] = {static_cast<std::uint32_t>(set.intervals.size()), static_cast<std::uint32_t>(found.size())};
            set.intervals.insert(set.intervals.end(), found.begin(), found.end());
        }
    }
    return set;
}

InnerSet InnerLattice::sweep(const InnerSet& starts, const InnerSet& free, Direction direction,
                             const Watching& watch) const {
    InnerSet set;
    set.spans = free.spans;
    set.of.resize(set.spans.cells);
    const bool forward = direction == Direction::forward;
    const int step = forward ? 1 : -1;
    std::vector<Interval> found;
    const int rows = static_cast<int>(set.spans.rows.size());
    for (int n = 0; n < rows; ++n) {
        const int row = forward ? set.spans.first + n : set.spans.last() - n;
        if (n % 64 == 0) watch();
        const Span span = set.spans.of(row), begin_span = starts.spans.of(row);
        const Span before = set.spans.of(row - step), before_that = set.spans.of(row - 2 * step);
        for (int cell = span.from; cell <= span.to; ++cell) {
            const InnerSet::Range rooms = free.at(span, cell);
            if (rooms.empty()) continue;
            ++updates;
            const int d = column_of(row, cell);
            found.clear();
            const auto add = [&](double low, double high) {
                for (const Interval& room : rooms) {
                    const Interval both = {std::max(low, room.low), std::min(high, room.high)};
                    if (both.low <= both.high) found.push_back(both);
                }
            };
            for (const Interval& begin : starts.at(begin_span, cell)) add(begin.low, begin.high);
            // From the column to the left the car keeps y + r cos forward, from the right y - r cos; backward the reverse.
            const double from_left = step * (level(d - 1) - level(d)), from_right = step * (level(d) - level(d + 1));
            const int left = cell_of(d - 1), right = cell_of(d + 1);
            for (const Interval& from : set.at(before, left)) add(from.low + from_left, from.high + from_left);
            for (const Interval& from : set.at(before, right)) add(from.low + from_right, from.high + from_right);
            // Across a cell: by way of one side, of the other, or turning off in between, where both are free.
            const double least = 2.0 * std::min(from_left, from_right), most = 2.0 * std::max(from_left, from_right);
            for (const Interval& from : set.at(before_that, cell)) {
                for (const Interval& one : free.at(before, left)) {
                    for (const Interval& other : free.at(before, right)) {
                        const double low = std::max({from.low, one.low - from_left, other.low - from_right});
                        const double high = std::min({from.high, one.high - from_left, other.high - from_right});
                        if (low <= high) add(low + least, high + most);
                    }
                }
            }
            if (found.empty()) continue;
            tidy(found);
            set.of[span.at(cell)] = {static_cast<std::uint32_t>(set.intervals.size()), static_cast<std::uint32_t>(found.size())};
            set.intervals.insert(set.intervals.end(), found.begin(), found.end());
        }
    }
    return set;
}

}  // namespace snug::detail::sets
