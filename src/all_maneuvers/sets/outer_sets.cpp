#include "all_maneuvers/sets/outer_sets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "all_maneuvers/sets/by_rows.hpp"
#include "all_maneuvers/sets/set_sweep.hpp"
#include "all_maneuvers/workers.hpp"
#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr Micro coarse_grid = 512;  ///< to which direction changes are rounded: 0.12 mm

double clamped(double sine) { return std::clamp(sine, -steepest_sine, steepest_sine); }
double tangent_of(double sine) { return sine / cosine_of(sine); }

}  // namespace

void sort_rising(std::vector<Interval>& intervals) {
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
}

void sort_longest_first(std::vector<Interval>& intervals) {
    std::sort(intervals.begin(), intervals.end(),
              [](const Interval& a, const Interval& b) { return a.high - a.low > b.high - b.low; });
}

OuterLattice::OuterLattice(const ChartPlace& place, double h, double h0, const Layer* coarser, const Watch& watch)
    : h_(h), radius_(place.radius), sine_step_(h / (2.0 * place.radius)), start_(place.start) {
    x0_ = place.start.x - h0 / 3.0 + h / 2.0;
    sine0_ = angles::sin(place.start.heading);
    first_column_ = static_cast<int>(std::floor((-steepest_sine - sine0_) / sine_step_ - 1.0)) - 1;
    last_column_ = static_cast<int>(std::ceil((steepest_sine - sine0_) / sine_step_ + 1.0)) + 1;
    number_columns();
    measure(place, coarser, watch);
}

void OuterLattice::number_columns() {
    const double r = radius_;
    // Bounds of one direction, forward: backward is the mirror image, in which the sine changes its sign.
    const auto up = [&](double sine) {
        const double low = sine - sine_step_, high = sine + sine_step_;
        const double gain = h_ * tangent_of(clamped(high));
        if (low < -steepest_sine || high > steepest_sine) {
            const double steep = std::max(std::abs(clamped(low)), std::abs(clamped(high)));
            return std::max(0.0, gain) - r * cosine_of(steep);
        }
        const double c = cosine_of(sine), u = cosine_of(high), v = cosine_of(low);
        return std::max(-r * std::min(c, u), gain - r * std::min(v, c));
    };
    // Most of r cos - (a - a_i) T_hi.
    const auto z_high = [&](double sine) {
        const double high = clamped(sine + sine_step_);
        const double tangent = tangent_of(high);
        if (tangent >= 0.0) {
            const double middle = clamped(sine);
            return r * (middle <= 0.0 && high >= 0.0 ? 1.0 : std::max(cosine_of(middle), cosine_of(high)));
        }
        // Then b = b_j + h is best, and along that edge the place where the tangent is twice as steep.
        const double level = 2.0 * tangent / std::sqrt(1.0 + 4.0 * tangent * tangent);
        const double best = std::clamp(level, clamped(sine), high);
        return r * cosine_of(best) - 2.0 * r * (high - best) * tangent;
    };
    const auto apart = [&](double sine) {
        const double low = sine - sine_step_, high = sine + sine_step_;
        const double t_low = h_ * tangent_of(clamped(low)), t_high = h_ * tangent_of(clamped(high));
        if (low < -steepest_sine || high > steepest_sine) {
            const double steep = std::max(std::abs(clamped(low)), std::abs(clamped(high)));
            return 2.0 * r * cosine_of(steep) + std::min(0.0, t_low) - std::max(0.0, t_high);
        }
        const double c = 2.0 * r * cosine_of(sine), u = 2.0 * r * cosine_of(high), v = 2.0 * r * cosine_of(low);
        return std::min(std::min(c, v - t_high), std::min(u + t_low, c + t_low - t_high));
    };
    const auto t_high = [&](int d) { return tangent_of(clamped(sine(d + 1))); };
    const auto t_low = [&](int d) { return tangent_of(clamped(sine(d - 1))); };
    const int first = cell_of(first_column_), last = cell_of(last_column_);
    const auto fill = [&](ColumnNumbers& numbers, auto&& value) {
        numbers.first_cell = first;
        for (int parity : {0, 1}) {
            for (int cell = first; cell <= last; ++cell) numbers.of[parity].push_back(value(2 * cell + parity));
            numbers.of[parity].resize(numbers.of[parity].size() + vector_padding, 0);
        }
    };
    fill(apart_, [&](int d) { return rounded_down(apart(sine(d))); });
    for (const int way : {1, -1}) {
        Numbers& of = way > 0 ? forward_ : backward_;
        fill(of.up, [&](int d) { return rounded_up(up(way * sine(d))); });
        fill(of.down, [&](int d) { return -rounded_up(up(-way * sine(d))); });
        fill(of.z_high, [&](int d) { return rounded_up(z_high(way * sine(d))); });
        fill(of.w_low, [&](int d) { return rounded_up(z_high(-way * sine(d))); });
        fill(of.from_left, [&](int d) { return way * rounded_down(h_ * t_low(d - 1)); });
        fill(of.from_right, [&](int d) { return way * rounded_up(h_ * t_high(d + 1)); });
        fill(of.turn_z, [&](int d) { return rounded_up(h_ * (way > 0 ? -t_low(d) : t_high(d))); });
        fill(of.turn_w, [&](int d) { return rounded_down(h_ * (way > 0 ? -t_high(d) : t_low(d))); });
    }
}

namespace {

/// What a stretch of a layer's row takes things in with.
template <class Numbers>
Taking taking_of(Pairs::Of& pairs, const Layer& layer, const Span& span, const Numbers& numbers,
                 const ColumnNumbers& apart, int row, int cell) {
    const std::size_t at = span.at(cell);
    return {pairs.z.data() + at,          pairs.w.data() + at,         layer.low.data() + at,
            layer.high.data() + at,       numbers.up.at(row, cell),    numbers.down.at(row, cell),
            numbers.z_high.at(row, cell), numbers.w_low.at(row, cell), apart.at(row, cell)};
}

/// Nothing, beside some rows of limits.
void clear(Pairs& pairs, const Limits& limits, Rows rows) {
    for (std::size_t k = 0; k < limits.size(); ++k) {
        for (int row = rows.first; row <= rows.last; ++row) {
            const Span span = limits[k].spans.of(row);
            if (span.empty()) continue;
            const auto count = static_cast<std::size_t>(span.to - span.from) + 1;
            std::fill_n(pairs.layers[k].z.data() + span.begin, count, -nowhere);
            std::fill_n(pairs.layers[k].w.data() + span.begin, count, nowhere);
        }
    }
}

void lay_out(Pairs& pairs, const Limits& limits, const std::shared_ptr<NumberStore>& store) {
    pairs.layers.resize(limits.size());
    for (std::size_t k = 0; k < limits.size(); ++k) {
        make_room(pairs.layers[k].z, limits[k].low.size(), store);
        make_room(pairs.layers[k].w, limits[k].low.size(), store);
        pairs.layers[k].reached.first = limits[k].spans.first;
        pairs.layers[k].reached.rows.assign(limits[k].spans.rows.size(), {});
    }
}

}  // namespace

void OuterLattice::offer(Pairs& pairs, const Limits& limits, Direction direction, int row, const Span& given,
                         const Micro* z, const Micro* w) const {
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const Span mine = limits[k].spans.of(row);
        const int first = std::max(mine.from, given.from), last = std::min(mine.to, given.to);
        if (first > last) continue;
        const auto skip = static_cast<std::size_t>(first - given.from);
        take_in(taking_of(pairs.layers[k], limits[k], mine, numbers(direction), apart_, row, first),
                {z + skip, w + skip, nullptr, nullptr}, static_cast<std::size_t>(last - first) + 1);
    }
}

void OuterLattice::begin(Rows rows, Pairs& pairs, const Limits& limits, Direction direction,
                         const Limits& places) const {
    clear(pairs, limits, rows);
    const Numbers& of = numbers(direction);
    std::vector<Micro> z, w;
    for (const Layer& from : places) {
        for (int row = rows.first; row <= rows.last; ++row) {
            const Span given = from.spans.of(row);
            if (given.empty()) continue;
            z.assign(static_cast<std::size_t>(given.to - given.from) + 1 + vector_padding, -nowhere);
            w.assign(z.size(), nowhere);
            for (int cell = given.from; cell <= given.to; ++cell) {
                const std::size_t at = given.at(cell);
                if (from.low[at] > from.high[at]) continue;
                z[static_cast<std::size_t>(cell - given.from)] = from.high[at] + *of.z_high.at(row, cell);
                w[static_cast<std::size_t>(cell - given.from)] = from.low[at] - *of.w_low.at(row, cell);
            }
            offer(pairs, limits, direction, row, given, z.data(), w.data());
        }
    }
}

CellGrid::Place CellGrid::place_of(const Pose& pose, Direction direction) const {
    const double sine = angles::sin(pose.heading), across = radius * sine;
    const double a = pose.x - across, b = pose.x + across;
    const double a0 = x0 - radius * sine0 - h / 2.0, b0 = x0 + radius * sine0 - h / 2.0;
    const int i = static_cast<int>(std::floor((a - a0) / h)), j = static_cast<int>(std::floor((b - b0) / h));
    const int d = j - i;
    const double in_a = a - a0 - i * h, in_b = b - b0 - j * h;
    const auto tangent_at = [&](int column) { return tangent_of(clamped(sine0 + column * sine_step)); };
    const double t_high = tangent_at(d + 1), t_low = tangent_at(d - 1);
    const double level = radius * cosine_of(sine);
    if (direction == Direction::forward) return {i + j, d, in_a * t_high - level, in_b * t_low + level};
    return {i + j, d, (in_a - h) * t_low - level, (in_b - h) * t_high + level};
}

void OuterLattice::begin_at_start(Rows rows, Pairs& pairs, const Limits& limits, Direction direction) const {
    clear(pairs, limits, rows);
    const CellGrid::Place at = grid().place_of(start_, direction);
    if (at.row < rows.first || at.row > rows.last) return;
    const int cell = cell_of(at.column);
    std::vector<Micro> z(1 + vector_padding, -nowhere), w(1 + vector_padding, nowhere);
    z[0] = rounded_up(start_.y - at.up + 1e-9);
    w[0] = rounded_down(start_.y - at.down - 1e-9);
    offer(pairs, limits, direction, at.row, {cell, cell, 0}, z.data(), w.data());
}

bool OuterLattice::holds(const Pairs& pairs, const Limits& limits, Direction direction, const Pose& pose) const {
    const CellGrid::Place at = grid().place_of(pose, direction);
    const int cell = cell_of(at.column);
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const Span mine = limits[k].spans.of(at.row);
        if (cell < mine.from || cell > mine.to) continue;
        const Micro z = pairs.layers[k].z[mine.at(cell)], w = pairs.layers[k].w[mine.at(cell)];
        if (z == -nowhere) continue;
        if (pose.y <= z * micro + at.up + 1e-6 && pose.y >= w * micro + at.down - 1e-6) return true;
    }
    return false;
}

void OuterLattice::turn(Rows rows, Pairs& pairs, const Limits& limits, Direction direction, const Pairs& before) const {
    clear(pairs, limits, rows);
    const Numbers& of = numbers(direction);
    std::vector<Micro> z, w;
    for (const Pairs::Of& from : before.layers) {
        for (int row = rows.first; row <= rows.last; ++row) {
            const Span given = from.reached.of(row);
            if (given.empty()) continue;
            const auto count = static_cast<std::size_t>(given.to - given.from) + 1;
            z.resize(count + vector_padding);
            w.resize(count + vector_padding);
            const Micro *old_z = from.z.data() + given.begin, *old_w = from.w.data() + given.begin;
            const Micro *more_z = of.turn_z.at(row, given.from), *more_w = of.turn_w.at(row, given.from);
            for (std::size_t i = 0; i < count; ++i) {
                z[i] = (old_z[i] + more_z[i] + (coarse_grid - 1)) & ~(coarse_grid - 1);
                w[i] = (old_w[i] + more_w[i]) & ~(coarse_grid - 1);
            }
            offer(pairs, limits, direction, row, given, z.data(), w.data());
        }
    }
}

void OuterLattice::sweep(Pairs& pairs, const Limits& limits, Direction direction, const Watch& watch,
                         const Call<Rows>& begin) const {
    lay_out(pairs, limits, watch.store());
    const Numbers& of = numbers(direction);
    const bool forward = direction == Direction::forward;
    std::size_t updates = 0;
    const Rows all = rows_of({&limits});
    // The row before, at full width, with nothing around what was reached in it.
    const int first_cell = cell_of(first_column_) - 1;
    const auto width = static_cast<std::size_t>(cell_of(last_column_) + 2 - first_cell) + vector_padding;
    struct Before {
        std::vector<Micro> z, w;
        Span live;
    };
    std::vector<Before> before(limits.size());
    for (Before& row : before) {
        row.z.assign(width, -nowhere);
        row.w.assign(width, nowhere);
    }
    const auto sweep_row = [&](int row) {
        for (std::size_t k = 0; k < limits.size(); ++k) {
            const Span mine = limits[k].spans.of(row);
            if (mine.empty()) continue;
            for (std::size_t m = 0; m < limits.size(); ++m) {
                if (before[m].live.empty()) continue;
                // The column to the left, d - 1, is the cell before in even rows, the column to the right that after in odd ones.
                const int left = (row & 1) == 0 ? -1 : 0;
                for (const int beside : {left, left + 1}) {
                    const int first = std::max(mine.from, before[m].live.from - beside);
                    const int last = std::min(mine.to, before[m].live.to - beside);
                    if (first > last) continue;
                    const auto skip = static_cast<std::size_t>(first + beside - first_cell);
                    const Micro* gain = (beside == left ? of.from_left : of.from_right).at(row, first);
                    const bool gains_z = forward == (beside != left);
                    const auto count = static_cast<std::size_t>(last - first) + 1;
                    take_in(taking_of(pairs.layers[k], limits[k], mine, of, apart_, row, first),
                            {before[m].z.data() + skip, before[m].w.data() + skip, gains_z ? gain : nullptr,
                             gains_z ? nullptr : gain},
                            count);
                    updates += count;
                }
            }
        }
        for (std::size_t k = 0; k < limits.size(); ++k) {
            Before& mine = before[k];
            if (!mine.live.empty()) {
                const auto from = static_cast<std::ptrdiff_t>(mine.live.from - first_cell);
                const auto count = static_cast<std::ptrdiff_t>(mine.live.to - mine.live.from) + 1;
                std::fill_n(mine.z.begin() + from, count, -nowhere);
                std::fill_n(mine.w.begin() + from, count, nowhere);
            }
            mine.live = {};
            const Span span = limits[k].spans.of(row);
            if (span.empty()) continue;
            Pairs::Of& now = pairs.layers[k];
            const Stretch part = reached(now.z.data() + span.begin, static_cast<std::size_t>(span.to - span.from) + 1);
            if (part.from == part.to) continue;
            mine.live = {span.from + static_cast<int>(part.from), span.from + static_cast<int>(part.to) - 1,
                         span.begin + part.from};
            now.reached.rows[static_cast<std::size_t>(row - now.reached.first)] = mine.live;
            const auto from = static_cast<std::ptrdiff_t>(mine.live.begin);
            const auto count = static_cast<std::ptrdiff_t>(mine.live.to - mine.live.from) + 1;
            std::copy_n(now.z.begin() + from, count, mine.z.begin() + (mine.live.from - first_cell));
            std::copy_n(now.w.begin() + from, count, mine.w.begin() + (mine.live.from - first_cell));
        }
    };
    const auto rows_in = [&](int step) {
        const int first = step * rows_at_once, last = std::min(first + rows_at_once - 1, all.last - all.first);
        return forward ? Rows{all.first + first, all.first + last} : Rows{all.last - last, all.last - first};
    };
    in_order(
        watch, is_large(limits), blocks_of(all), [&](int step) { begin(rows_in(step)); },
        [&](int step) {
            const Rows rows = rows_in(step);
            if (forward) {
                for (int row = rows.first; row <= rows.last; ++row) sweep_row(row);
            } else {
                for (int row = rows.last; row >= rows.first; --row) sweep_row(row);
            }
        });
    updates_[forward ? 0 : 1] += updates;
}

BothWays<Pairs> next_moves(const OuterLattice& lattice, const Pairs* last_forward, const Pairs* last_backward,
                           const Watch& watch) {
    const Limits& limits = lattice.free();
    BothWays<Pairs> next;
    in_parts(watch, is_large(limits), 2, [&](int part, const Watch& watched) {
        const Direction direction = both_directions[part];
        const Pairs* before = direction == Direction::forward ? last_backward : last_forward;
        Pairs pairs;
        lattice.sweep(pairs, limits, direction, watched, [&](Rows rows) {
            if (before) {
                lattice.turn(rows, pairs, limits, direction, *before);
            } else {
                lattice.begin(rows, pairs, limits, direction, lattice.parked());
            }
        });
        next.of(direction).push_back(std::move(pairs));
    });
    return next;
}

bool same(const Pairs& one, const Pairs& two) {
    const auto differ = [](const Micros& a, const Micros& b) {
        return !std::equal(a.begin(), a.end() - vector_padding, b.begin());
    };
    for (std::size_t k = 0; k < one.layers.size(); ++k)
        if (differ(one.layers[k].z, two.layers[k].z) || differ(one.layers[k].w, two.layers[k].w)) return false;
    return true;
}

}  // namespace snug::detail::sets
