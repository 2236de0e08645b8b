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
    spans_.first = cells.spans.first - 2 * offset_;
    for (Span span : cells.spans.rows) {
        const int row = spans_.first + static_cast<int>(spans_.rows.size());
        while (!span.empty() && sine(column_of(row, span.from)) < -steepest_sine) ++span.from;
        while (!span.empty() && sine(column_of(row, span.to)) > steepest_sine) --span.to;
        spans_.rows.push_back(span);
    }
    spans_.store();
    int last_column = 0;
    for (int row = spans_.first; row <= spans_.last(); ++row) {
        const Span span = spans_.of(row);
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
    free_.of.resize(spans_.cells);
    parked_.of.resize(spans_.cells);
    std::vector<Interval> taken;
    for (int row = spans_.first; row <= spans_.last(); ++row) {
        const Span span = spans_.of(row), of_cells = cells.spans.of(row + 2 * offset_);
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
    set.of.resize(spans_.cells);
    std::vector<Interval> found;
    for (int row = spans_.first; row <= spans_.last(); ++row) {
        const Span span = spans_.of(row);
        for (int cell = span.from; cell <= span.to; ++cell) {
            const std::size_t node = span.at(cell);
            set.of[node].begin = static_cast<std::uint32_t>(set.intervals.size());
            found.clear();
            for (const Layer& layer : limits) {
                const Span cells = layer.spans.of(row + 2 * offset_);
                if (cell < cells.from || cell > cells.to) continue;
                const double low = layer.low[cells.at(cell)] * micro, high = layer.high[cells.at(cell)] * micro;
                for (const Interval* free = free_.begin(node); free != free_.end(node); ++free) {
                    const Interval both = {std::max(low, free->low), std::min(high, free->high)};
                    if (both.low <= both.high) found.push_back(both);
                }
            }
            tidy(found);
            set.of[node].count = static_cast<std::uint32_t>(found.size());
            set.intervals.insert(set.intervals.end(), found.begin(), found.end());
        }
    }
    return set;
}

InnerSet InnerLattice::sweep(const InnerSet& starts, const InnerSet& free, Direction direction,
                             const Watching& watch) const {
    InnerSet set;
    set.of.resize(spans_.cells);
    const bool forward = direction == Direction::forward;
    const int step = forward ? 1 : -1;
    std::vector<Interval> found;
    const int rows = static_cast<int>(spans_.rows.size());
    for (int n = 0; n < rows; ++n) {
        const int row = forward ? spans_.first + n : spans_.last() - n;
        if (n % 64 == 0) watch();
        const Span span = spans_.of(row), before = spans_.of(row - step), before_that = spans_.of(row - 2 * step);
        for (int cell = span.from; cell <= span.to; ++cell) {
            const std::size_t node = span.at(cell);
            set.of[node].begin = static_cast<std::uint32_t>(set.intervals.size());
            if (free.of[node].count == 0) continue;
            ++updates;
            const int d = column_of(row, cell);
            found.clear();
            const auto add = [&](double low, double high) {
                for (const Interval* room = free.begin(node); room != free.end(node); ++room) {
                    const Interval both = {std::max(low, room->low), std::min(high, room->high)};
                    if (both.low <= both.high) found.push_back(both);
                }
            };
            for (const Interval* begin = starts.begin(node); begin != starts.end(node); ++begin) add(begin->low, begin->high);
            // From the column to the left the car keeps y + r cos forward, from the right y - r cos; backward the reverse.
            const double from_left = step * (level(d - 1) - level(d)), from_right = step * (level(d) - level(d + 1));
            const int left = cell_of(d - 1), right = cell_of(d + 1);
            const bool has_left = left >= before.from && left <= before.to, has_right = right >= before.from && right <= before.to;
            if (has_left) {
                const std::size_t at = before.at(left);
                for (const Interval* from = set.begin(at); from != set.end(at); ++from)
                    add(from->low + from_left, from->high + from_left);
            }
            if (has_right) {
                const std::size_t at = before.at(right);
                for (const Interval* from = set.begin(at); from != set.end(at); ++from)
                    add(from->low + from_right, from->high + from_right);
            }
            // Across a cell: by way of one side, of the other, or turning off in between, where both are free.
            if (has_left && has_right && cell >= before_that.from && cell <= before_that.to) {
                const std::size_t at = before_that.at(cell), at_left = before.at(left), at_right = before.at(right);
                const double to_left = step * (level(d - 1) - level(d)), to_right = step * (level(d) - level(d + 1));
                const double least = std::min(from_left + to_left, from_right + to_right);
                const double most = std::max(from_left + to_left, from_right + to_right);
                for (const Interval* from = set.begin(at); from != set.end(at); ++from) {
                    for (const Interval* one = free.begin(at_left); one != free.end(at_left); ++one) {
                        for (const Interval* other = free.begin(at_right); other != free.end(at_right); ++other) {
                            const double low = std::max({from->low, one->low - to_left, other->low - to_right});
                            const double high = std::min({from->high, one->high - to_left, other->high - to_right});
                            if (low <= high) add(low + least, high + most);
                        }
                    }
                }
            }
            tidy(found);
            set.of[node].count = static_cast<std::uint32_t>(found.size());
            set.intervals.insert(set.intervals.end(), found.begin(), found.end());
        }
    }
    return set;
}

bool InnerLattice::holds(const InnerSet& set, int row, int column, double y) const {
    const std::optional<std::size_t> at = node(row, column);
    if (!at) return false;
    for (const Interval* interval = set.begin(*at); interval != set.end(*at); ++interval)
        if (y >= interval->low && y <= interval->high) return true;
    return false;
}

}  // namespace snug::detail::sets
