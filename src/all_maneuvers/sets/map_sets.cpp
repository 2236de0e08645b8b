#include "all_maneuvers/sets/map_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "all_maneuvers/sets/steps.hpp"
#include "model/angles.hpp"
#include "model/polygon.hpp"
#include "snug/limits.hpp"

namespace snug::detail::sets {

namespace {

constexpr double near_end = 1e-8;            ///< and so much less will do afterwards [m]
constexpr double begin_grid = 1.0 / 1024.0;  ///< to which moves begin, rounded inward, so that sets do not creep [m]

/// Of what was logged for each level, the first one first, what belongs to each cell.
template <class Level, class Logged, class Make>
ByCell<Level> by_cell(const std::vector<std::vector<Logged>>& levels, std::size_t cells, const Make& make) {
    ByCell<Level> all;
    all.begin.assign(cells + 1, 0);
    for (const std::vector<Logged>& level : levels)
        for (const Logged& one : level) ++all.begin[one.node + 1];
    for (std::size_t i = 0; i < cells; ++i) all.begin[i + 1] += all.begin[i];
    all.of.resize(all.begin[cells]);
    std::vector<std::uint32_t> next(all.begin.begin(), all.begin.end() - 1);
    for (std::size_t k = 0; k < levels.size(); ++k)
        for (const Logged& one : levels[k]) all.of[next[one.node]++] = make(one, static_cast<int>(k));
    return all;
}

/// How far y is inside; negative outside.
double room_in(const Interval& interval, double y) {
    const double room = std::min(y - interval.low, interval.high - y);
    return room < -near_end ? -1.0 : std::max(room, 0.0);
}

template <class Of>
std::size_t bytes_of(const ByCell<Of>& cells) {
    return cells.begin.size() * sizeof(std::uint32_t) + cells.of.size() * sizeof(Of);
}

}  // namespace

OuterMap::OuterMap(const ChartPlace& place, double h, const Watch& watch)
    : sweeping_(Sweeping{OuterLattice(place, h, h, nullptr, watch), {}, {}}), grid_(sweeping_->lattice.grid()) {
    for (const Layer& layer : sweeping_->lattice.free()) spans_.push_back(layer.spans);
    for (const Direction direction : both_directions) sweeping_->logs.of(direction).resize(spans_.size());
}

bool OuterMap::sweep_on(const Watch& watch) {
    if (complete_) return false;
    BothWays<Pairs>& now = sweeping_->now;
    const bool first = most_ < 0;
    BothWays<Pairs> next = next_moves(sweeping_->lattice, first ? nullptr : &now.forward.back(),
                                      first ? nullptr : &now.backward.back(), watch);
    complete_ = true;
    for (const Direction direction : both_directions) {
        for (std::size_t m = 0; m < spans_.size(); ++m) {
            const Pairs::Of& to = next.of(direction).front().layers[m];
            const Pairs::Of* from = first ? nullptr : &now.of(direction).front().layers[m];
            std::vector<Logged> log;
            for (std::size_t i = 0; i < spans_[m].cells; ++i) {
                if (from ? to.z[i] == from->z[i] && to.w[i] == from->w[i] : to.z[i] == -nowhere) continue;
                log.push_back({static_cast<std::uint32_t>(i), to.z[i], to.w[i]});
            }
            complete_ = complete_ && log.empty();
            sweeping_->logs.of(direction)[m].push_back(std::move(log));
        }
    }
    now = std::move(next);
    ++most_;
    return true;
}

void OuterMap::settle() {
    for (const Direction direction : both_directions) {
        std::vector<ByCell<Level>>& mine = direction == Direction::forward ? forward_ : backward_;
        mine.clear();
        for (std::size_t m = 0; m < spans_.size(); ++m)
            mine.push_back(
                by_cell<Level>(sweeping_->logs.of(direction)[m], spans_[m].cells, [](const Logged& one, int k) {
                    return Level{one.z, one.w, k};
                }));
    }
}

void OuterMap::finish() {
    settle();
    sweeping_.reset();
}

int OuterMap::changes_at(const Pose& pose) const {
    int fewest = most_ + 1;
    for (const Direction direction : both_directions) {
        const CellGrid::Place at = grid_.place_of(pose, direction);
        const int cell = cell_of(at.column);
        const std::vector<ByCell<Level>>& levels = direction == Direction::forward ? forward_ : backward_;
        for (std::size_t m = 0; m < levels.size(); ++m) {
            const Span span = spans_[m].of(at.row);
            if (cell < span.from || cell > span.to) continue;
            const std::size_t i = span.at(cell);
            for (const Level* level = levels[m].first(i); level != levels[m].last(i); ++level) {
                if (level->changes >= fewest) break;
                if (level->z == -nowhere || pose.y > level->z * micro + at.up + 1e-6 ||
                    pose.y < level->w * micro + at.down - 1e-6)
                    continue;
                fewest = level->changes;
                break;
            }
        }
    }
    return fewest;
}

std::size_t OuterMap::bytes() const {
    std::size_t sum = 0;
    for (const std::vector<ByCell<Level>>* levels : {&forward_, &backward_})
        for (const ByCell<Level>& layer : *levels) sum += bytes_of(layer);
    for (const Spans& spans : spans_) sum += spans.rows.size() * sizeof(Span);
    return sum;
}

namespace {

/// The convex, counter-clockwise polygon around points.
std::vector<Point> convex_hull(std::vector<Point> points) {
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point> hull;
    const auto add = [&](const Point& p, std::size_t first) {
        constexpr double flat = 1e-12;  // [m^2]
        while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= flat) hull.pop_back();
        hull.push_back(p);
    };
    for (const Point& p : points) add(p, 0);
    const std::size_t lower = hull.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.pop_back();
    return hull;
}

}  // namespace

InnerMap::InnerMap(const ChartPlace& place, double h, const Watch& watch)
    : place_(place), h_(h), sine_step_(h / (2.0 * place.radius)) {
    last_column_ = static_cast<int>(std::floor(steepest_sine / sine_step_));
    first_column_ = -last_column_;
    first_cell_ = cell_of(first_column_) - 2;
    width_ = static_cast<std::size_t>(cell_of(last_column_) + 2 - first_cell_) + 1;
    first_row_ = static_cast<int>(std::floor(place.x_min / (h / 2.0))) - 2;
    last_row_ = static_cast<int>(std::ceil(place.x_max / (h / 2.0))) + 2;
    const std::size_t nodes = static_cast<std::size_t>(last_row_ - first_row_ + 1) * width_;
    for (std::vector<InnerSet::Few>& free : free_) free.resize(nodes);
    const std::vector<Band> parked_at = measure_columns(watch);

    for (int row = first_row_ + 2; row <= last_row_ - 2; ++row) {
        for (int d = first_column_ + ((first_column_ ^ row) & 1); d <= last_column_; d += 2) {
            const Band& band = parked_at[static_cast<std::size_t>(d - first_column_)];
            if (x(row) < band.from || x(row) > band.to) continue;
            double low = 0.0, high = 0.0;
            band.at(x(row), low, high);
            if (low + wary > high - wary) continue;
            for (const Interval& free : known(at_node, row, d)) {
                const Interval both = {std::max(low + wary, free.low), std::min(high - wary, free.high)};
                if (both.low <= both.high)
                    parked_log_.push_back({static_cast<std::uint32_t>(index(row, cell_of(d))), both});
            }
        }
    }
    parked_ = by_cell<Interval>(std::vector<std::vector<Logged>>{parked_log_}, nodes,
                                [](const Logged& one, int) { return one.y; });
    for (std::vector<InnerSet::Few>& sets : sets_) sets.resize(nodes);
    changed_.resize(nodes);
}

bool InnerMap::sweep_on(const Watch& watch) {
    if (most() >= 0 && logs_.forward.back().empty() && logs_.backward.back().empty()) return false;
    const auto k = logs_.forward.size();
    for (const Direction direction : both_directions) {
        const std::vector<Logged>& begins = k == 0 ? parked_log_ : logs_.of(other(direction))[k - 1];
        std::vector<Logged> log = sweep(begins, direction, sets_[direction == Direction::forward ? 0 : 1], watch);
        logs_.of(direction).push_back(std::move(log));
    }
    return true;
}

void InnerMap::settle() {
    const auto level = [](const Logged& one, int k) { return Level{one.y, k}; };
    forward_ = by_cell<Level>(logs_.forward, changed_.size(), level);
    backward_ = by_cell<Level>(logs_.backward, changed_.size(), level);
}

void InnerMap::finish() {
    settle();
    parked_log_ = {};
    logs_ = {};
    for (std::vector<InnerSet::Few>& sets : sets_) sets = {};
    changed_ = {};
    reached_ = {};
    measured_ = {};
    gaps_ = {};
    xs_ = {};
    intervals_.shrink_to_fit();
}

std::vector<Band> InnerMap::measure_columns(const Watch& watch) {
    std::vector<Band> parked;
    const double r = place_.radius;
    // One more on either side: steps are looked at before it is known that they stay in the chart.
    for (int d = first_column_ - 1; d <= last_column_ + 1; ++d)
        level_.push_back(r * cosine_of(std::clamp(sine(d), -1.0, 1.0)));
    ChartPlace swept = place_;
    swept.parked.clear();
    swept.region.clear();
    for (int d = first_column_; d <= last_column_; ++d) {
        watch();
        const double heading = angles::asin(sine(d));
        const double before = d > first_column_ ? heading - angles::asin(sine(d - 1)) : 0.0;
        const double after = d < last_column_ ? angles::asin(sine(d + 1)) - heading : 0.0;
        const double most = std::max(before, after);
        // Off the straight lines and flat faces between a cell's four nodes: second order in the angle.
        const auto off = [&](double farthest) { return (farthest / 2.0 + 2.0 * r) * most * most + 1e-7; };
        ChartPlace here = place_;
        for (HalfPlane& edge : here.region) edge.offset -= off(r);
        Bands bands = bands_at(here, sine(d));
        measure(at_node, d, bands);
        parked.push_back(std::move(bands.parked));

        const Pose start = {0.0, 0.0, heading};
        const auto sweeps = [&](const std::vector<Pose>& poses, double bulge_angle, double side) {
            for (std::size_t k = 0; k < place_.shapes.size(); ++k) {
                std::vector<Point> points;
                for (const Pose& pose : poses)
                    for (const Point& p : placed(place_.shapes[k], pose)) points.push_back(p);
                double farthest = 0.0;
                for (const Point& p : place_.shapes[k])
                    farthest = std::max(farthest, angles::hypot(p.x, std::abs(p.y - side * r)));
                const double bulge = side == 0.0 ? off(farthest) : farthest * bulge_angle * bulge_angle / 7.9 + 1e-7;
                swept.shapes[k] = grown_polygon(convex_hull(std::move(points)), bulge);
            }
            return bands_at(swept, 0.0);
        };
        const bool has_left = d<last_column_, has_right = d> first_column_;
        const double up_left = has_left ? level(d) - level(d + 1) : 0.0,
                     up_right = has_right ? level(d - 1) - level(d) : 0.0;
        const Pose left_side = {h_ / 2.0, up_left, heading + after},
                   right_side = {h_ / 2.0, up_right, heading - before};
        if (has_left) measure(to_left, d, sweeps({start, left_side}, after, 1.0));
        if (has_right) measure(to_right, d, sweeps({start, right_side}, before, -1.0));
        const Pose one = {h_, 2.0 * up_left, heading}, two = {h_, 2.0 * up_right, heading};
        if (has_left && has_right) measure(across, d, sweeps({start, left_side, right_side, one, two}, most, 0.0));
    }
    return parked;
}

void InnerMap::measure(Kind kind, int column, const Bands& bands) {
    static const Band everywhere = {-std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::infinity(),
                                    {{-farthest_y, 0.0}},
                                    {{farthest_y, 0.0}}};
    const int first = first_row_ + 2 + ((first_row_ ^ column) & 1), last = last_row_ - 2;
    const auto rows = static_cast<std::size_t>(std::max(0, (last - first) / 2 + 1));
    xs_.clear();
    for (std::size_t i = 0; i < rows; ++i) xs_.push_back(x(first + 2 * static_cast<int>(i)));
    measured_.measure(kind == at_node ? bands.region : everywhere, bands.solids, xs_);
    for (std::size_t i = 0; i < rows; ++i) {
        const std::size_t node = index(first + 2 * static_cast<int>(i), cell_of(column));
        if (kind != at_node && free_[at_node][node].count == 0) continue;
        InnerSet::Few& few = free_[kind][node];
        few.begin = static_cast<std::uint32_t>(intervals_.size());
        measured_.at(i, {-farthest_y, farthest_y}, gaps_);
        for (const Interval& gap : gaps_) {
            if (gap.low + wary > gap.high - wary) continue;
            intervals_.push_back({gap.low + wary, gap.high - wary});
            ++few.count;
        }
    }
}

InnerSet::Range InnerMap::known(Kind kind, int row, int column) const {
    const InnerSet::Few few = free_[kind][index(row, cell_of(column))];
    return {intervals_.data() + few.begin, intervals_.data() + few.begin + few.count};
}

std::vector<InnerMap::Logged> InnerMap::sweep(const std::vector<Logged>& begins, Direction direction,
                                              std::vector<InnerSet::Few>& sets, const Watch& watch) {
    std::vector<Logged> log;
    std::fill(changed_.begin(), changed_.end(), std::uint8_t{0});
    struct Part {
        std::size_t from = 0, to = 0;
    };
    std::vector<Part> begins_of(static_cast<std::size_t>(last_row_ - first_row_) + 1);
    for (std::size_t i = 0; i < begins.size(); ++i) {
        Part& part = begins_of[begins[i].node / width_];
        if (part.from == part.to) part.from = i;
        part.to = i + 1;
    }
    const bool forward = direction == Direction::forward;
    const int step = forward ? 1 : -1;
    std::vector<Interval> found;
    Span live, live_before, live_before_that;  // what has changed in this row and in those before
    for (int n = 0; n <= last_row_ - first_row_ - 4; ++n) {
        const int row = forward ? first_row_ + 2 + n : last_row_ - 2 - n;
        if (n % 64 == 0) watch();
        live_before_that = live_before;
        live_before = live;
        live = {};
        const Part part = begins_of[static_cast<std::size_t>(row - first_row_)];
        // Cells that anything new leads to.
        Span led;
        const auto cover = [&](int from, int to) {
            led = led.empty() ? Span{from, to, 0} : Span{std::min(led.from, from), std::max(led.to, to), 0};
        };
        const auto cell_in_row = [&](std::size_t i) { return static_cast<int>(begins[i].node % width_) + first_cell_; };
        if (part.from < part.to) cover(cell_in_row(part.from), cell_in_row(part.to - 1));
        if (!live_before.empty()) cover(live_before.from - 1, live_before.to + 1);
        if (!live_before_that.empty()) cover(live_before_that.from, live_before_that.to);
        std::size_t next = part.from;
        int from_cell = led.from, to_cell = led.to;
        while (from_cell <= to_cell && column_of(row, from_cell) < first_column_) ++from_cell;
        while (from_cell <= to_cell && column_of(row, to_cell) > last_column_) --to_cell;
        for (int cell = from_cell; cell <= to_cell; ++cell) {
            const std::size_t here = index(row, cell);
            const int d = column_of(row, cell);
            const std::size_t left = index(row - step, cell_of(d - 1)), right = index(row - step, cell_of(d + 1)),
                              opposite = index(row - 2 * step, cell);
            const std::size_t first_begin = next;
            while (next < part.to && begins[next].node == here) ++next;
            const bool from_left = changed_[left] != 0, from_right = changed_[right] != 0,
                       from_opposite = changed_[opposite] != 0;
            if (first_begin == next && !from_left && !from_right && !from_opposite) continue;
            InnerSet::Few& set = sets[here];
            const auto old = [&](std::uint32_t i) -> const Interval& { return reached_[set.begin + i]; };
            found.clear();
            const auto add = [&](double low, double high) {
                if (low > high) return;
                for (std::uint32_t i = 0; i < set.count; ++i)
                    if (old(i).low <= low && high <= old(i).high) return;
                found.push_back({low, high});
            };
            for (std::size_t i = first_begin; i < next; ++i)
                add(std::ceil(begins[i].y.low / begin_grid) * begin_grid,
                    std::floor(begins[i].y.high / begin_grid) * begin_grid);
            // From the column to the left the car keeps y + r cos forward, from the right y - r cos; backward the reverse.
            // Only where the whole step is free: seen from the end at which forward it begins.
            const auto add_step = [&](const InnerSet::Few& from, Kind kind, int column, double least, double most) {
                const InnerSet::Range free =
                    forward ? known(kind, kind == across ? row - 2 : row - 1, column) : known(kind, row, d);
                for (std::uint32_t i = from.begin; i < from.begin + from.count; ++i) {
                    const Interval& of = reached_[i];
                    for (const Interval& gap : free) {
                        if (!forward) {
                            add(std::max(of.low + least, gap.low), std::min(of.high + most, gap.high));
                        } else if (const double low = std::max(of.low, gap.low), high = std::min(of.high, gap.high);
                                   low <= high) {
                            add(low + least, high + most);
                        }
                    }
                }
            };
            const double by_left = d > first_column_ ? step * (level(d - 1) - level(d)) : 0.0;
            const double by_right = d < last_column_ ? step * (level(d) - level(d + 1)) : 0.0;
            if (from_left) add_step(sets[left], forward ? to_left : to_right, d - 1, by_left, by_left);
            if (from_right) add_step(sets[right], forward ? to_right : to_left, d + 1, by_right, by_right);
            if (from_opposite && d > first_column_ && d < last_column_)
                add_step(sets[opposite], across, d, 2.0 * std::min(by_left, by_right),
                         2.0 * std::max(by_left, by_right));
            if (found.empty()) continue;
            const std::size_t all = found.size();
            for (std::size_t i = 0; i < all; ++i) {
                for (const Interval& free : known(at_node, row, d)) {
                    const Interval both = {std::max(found[i].low, free.low), std::min(found[i].high, free.high)};
                    if (both.low <= both.high) found.push_back(both);
                }
            }
            found.erase(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(all));
            if (found.empty()) continue;
            for (std::uint32_t i = 0; i < set.count; ++i) found.push_back(old(i));
            tidy(found, most_intervals);
            bool changed = false;
            for (const Interval& interval : found) {
                bool is_known = false;
                for (std::uint32_t i = 0; i < set.count; ++i)
                    is_known = is_known || (old(i).low == interval.low && old(i).high == interval.high);
                if (is_known) continue;
                changed = true;
                log.push_back({static_cast<std::uint32_t>(here), interval});
            }
            if (!changed) continue;
            set = {static_cast<std::uint32_t>(reached_.size()), static_cast<std::uint32_t>(found.size())};
            reached_.insert(reached_.end(), found.begin(), found.end());
            changed_[here] = 1;
            if (live.empty()) live.from = cell;
            live.to = cell;
        }
    }
    return log;
}

template <class Do>
void InnerMap::each_reached(Direction leaving, int row, int column, int changes, const Do& act) const {
    if (!has(row, column)) return;
    const ByCell<Level>& levels = leaving == Direction::forward ? forward_ : backward_;
    const std::size_t cell = index(row, cell_of(column));
    for (const Level* level = levels.first(cell); level != levels.last(cell) && level->changes <= changes; ++level)
        act(level->y);
}

template <class Do>
void InnerMap::each_begin(Direction leaving, int row, int column, int changes, const Do& act) const {
    if (changes > 0) return each_reached(other(leaving), row, column, changes - 1, act);
    if (!has(row, column)) return;
    const std::size_t cell = index(row, cell_of(column));
    std::for_each(parked_.first(cell), parked_.last(cell), act);
}

bool InnerMap::is_apart(const Moved& from, const Moved& to, double side) const {
    // Both ends turned about one centre. What a point reaches along a direction lies between that at the ends, unless it
    // turns back on the way: then it is off by no more than an arc bulges.
    const double angle = std::abs(to.at.heading - from.at.heading);
    const double off = angle * angle / 7.9;
    const Point centre_seen = {0.0, side * place_.radius};
    const Point centre = from.of(centre_seen);
    const auto most_along = [off](const Point& n, const Point& one, const Point& two, const Point& about) {
        const double turning_one = n.x * (one.y - about.y) - n.y * (one.x - about.x);
        const double turning_two = n.x * (two.y - about.y) - n.y * (two.x - about.x);
        const double most = std::max(n.x * one.x + n.y * one.y, n.x * two.x + n.y * two.y);
        if (turning_one * turning_two > 0.0) return most;
        return most + off * angles::hypot(n.x, n.y) * angles::hypot(one.x - about.x, one.y - about.y);
    };
    for (const HalfPlane& edge : place_.region)
        if (most_along(edge.normal, {from.at.x, from.at.y}, {to.at.x, to.at.y}, centre) >
            edge.offset + limits::touching)
            return false;
    for (const ChartPlace::Solid& solid : place_.solids) {
        const std::vector<Point>& shape = place_.shapes[solid.stops];
        // Along a direction in the world the whole car stays short of the whole solid.
        const auto stays_short = [&](const Point& n) {
            double least = std::numeric_limits<double>::infinity();
            for (const Point& p : solid.corners) least = std::min(least, n.x * p.x + n.y * p.y);
            const double length = angles::hypot(n.x, n.y);
            if (!(length > 0.0)) return false;
            return std::all_of(shape.begin(), shape.end(), [&](const Point& p) {
                return most_along(n, from.of(p), to.of(p), centre) <= least + limits::touching * length;
            });
        };
        bool apart = false;
        const std::size_t corners = solid.corners.size();
        for (std::size_t i = 0; i < corners && !apart; ++i) {
            const Point &one = solid.corners[i], &two = solid.corners[(i + 1) % corners];
            apart = stays_short({one.y - two.y, two.x - one.x});
        }
        for (std::size_t i = 0; i < shape.size() && !apart; ++i) {
            // Beyond an edge of the car all the way: seen from the car the solid turns about the centre.
            const Point &one = shape[i], &two = shape[(i + 1) % shape.size()];
            const Point n = {one.y - two.y, two.x - one.x};  // into the car
            const double edge = n.x * one.x + n.y * one.y, length = angles::hypot(n.x, n.y);
            apart = std::all_of(solid.corners.begin(), solid.corners.end(), [&](const Point& p) {
                return most_along(n, from.seen(p), to.seen(p), centre_seen) <= edge + limits::touching * length;
            });
            // Or along the way of a corner.
            const Point begin = from.of(one), end = to.of(one);
            apart = apart || stays_short({end.y - begin.y, begin.x - end.x}) ||
                    stays_short({begin.y - end.y, end.x - begin.x});
        }
        if (!apart) return false;
    }
    return true;
}

std::optional<Joining> InnerMap::joining(const Pose& pose) const {
    const double r = place_.radius, s = angles::sin(pose.heading), c = cosine_of(s);
    const double a = pose.x - r * s, b = pose.x + r * s;
    const int i = static_cast<int>(std::floor(a / h_)), j = static_cast<int>(std::floor(b / h_));
    struct Try {
        Joining joining;
        Moved middle;
    };
    Try tries[4];
    int count = 0;
    for (const Direction direction : both_directions) {
        const int ahead = direction == Direction::forward ? 1 : 0;
        Try one;
        one.joining.direction = direction;
        one.joining.node.row = i + j + 2 * ahead;
        one.joining.node.column = j - i;
        if (!has(one.joining.node.row, one.joining.node.column)) continue;
        const double a_node = (i + ahead) * h_, b_node = (j + ahead) * h_;
        for (const double side : {1.0, -1.0}) {
            // To the left b changes, and y + r cos stays; to the right a, and y - r cos.
            const double middle = side > 0.0 ? (b_node - a) / (2.0 * r) : (b - a_node) / (2.0 * r);
            if (std::abs(middle) > steepest_sine) continue;
            const double last = sine(one.joining.node.column);
            const double c_middle = cosine_of(middle), y = pose.y + side * r * (c - c_middle);
            one.joining.node.y = y - side * r * (c_middle - cosine_of(last));
            one.joining.first_side = side;
            one.joining.sines[0] = s;
            one.joining.sines[1] = middle;
            one.joining.sines[2] = last;
            const double x_middle = side > 0.0 ? (a + b_node) / 2.0 : (a_node + b) / 2.0;
            one.middle = {{x_middle, y, angles::asin(middle)}, middle, c_middle};
            const int changes = changes_from(other(direction), one.joining.node);
            if (changes < 0) continue;
            one.joining.changes = changes;
            int at = count++;
            for (; at > 0 && tries[at - 1].joining.changes > changes; --at) tries[at] = tries[at - 1];
            tries[at] = one;
        }
    }
    const Moved here = {pose, s, c};
    for (int k = 0; k < count; ++k) {
        const Joining& one = tries[k].joining;
        const double last = one.sines[2];
        const Moved node = {{x(one.node.row), one.node.y, angles::asin(last)}, last, cosine_of(last)};
        if (is_apart(here, tries[k].middle, one.first_side) && is_apart(tries[k].middle, node, -one.first_side))
            return one;
    }
    return std::nullopt;
}

int InnerMap::changes_from(Direction leaving, const At& node) const {
    const ByCell<Level>& levels = leaving == Direction::forward ? forward_ : backward_;
    const std::size_t cell = index(node.row, cell_of(node.column));
    for (const Level* level = levels.first(cell); level != levels.last(cell); ++level)
        if (room_in(level->y, node.y) >= 0.0) return level->changes;
    return -1;
}

void InnerMap::way(const Pose& start, const Joining& joining, std::vector<Path>& way) const {
    way.clear();
    Pose pose = start;
    const double r = place_.radius;
    add_arc(way, pose, r, joining.first_side, joining.sines[0], joining.sines[1], joining.direction);
    add_arc(way, pose, r, -joining.first_side, joining.sines[1], joining.sines[2], joining.direction);
    At at = joining.node;
    Direction direction = joining.direction;
    for (int k = joining.changes; k >= 0; --k, direction = other(direction)) {
        const Direction leaving = other(direction);
        const Stepper stepper(*this, leaving);
        const bool upward = direction == Direction::forward;
        for (;;) {
            // Where the next move can begin this one may end; it goes on as long as that gives more room.
            double room_here = -1.0;
            each_begin(leaving, at.row, at.column, k,
                       [&](const Interval& begin) { room_here = std::max(room_here, room_in(begin, at.y)); });
            const auto each = [&](const At& next, const auto& act) {
                if (room_here < 0.0)
                    each_reached(leaving, next.row, next.column, k, act);
                else
                    each_begin(leaving, next.row, next.column, k, act);
            };
            // A step is seen from the end at which forward it begins.
            const auto free_at = [&](Kind kind, const At& next) {
                return upward ? known(kind, at.row, at.column) : known(kind, next.row, next.column);
            };
            const auto room_at = [&](const At& next, Kind kind) {
                double room = -1.0, free = -1.0;
                if (!has(next.row, next.column)) return room;
                for (const Interval& gap : free_at(kind, next))
                    free = std::max(free, room_in(gap, upward ? at.y : next.y));
                if (free >= 0.0)
                    each(next, [&](const Interval& reached) { room = std::max(room, room_in(reached, next.y)); });
                return room;
            };
            const At left_to = stepper.from(at, left), right_to = stepper.from(at, right);
            const double left_room = room_at(left_to, to_left), right_room = room_at(right_to, to_right);
            // Across the cell, turning off after a part of the first arc: what that gains depends on where.
            At opposite = {at.row + 2 * stepper.way, at.column, at.y};
            double across_room = -1.0;
            if (has(opposite.row, opposite.column) && has(left_to.row, left_to.column) &&
                has(right_to.row, right_to.column)) {
                const double one = 2.0 * (left_to.y - at.y), two = 2.0 * (right_to.y - at.y);
                for (const Interval& gap : free_at(across, opposite)) {
                    double from = at.y + std::min(one, two), to = at.y + std::max(one, two);
                    if (!upward) from = std::max(from, gap.low), to = std::min(to, gap.high);
                    if (from > to + near_end || (upward && room_in(gap, at.y) < 0.0)) continue;
                    from = std::min(from, to);
                    each(opposite, [&](const Interval& reached) {
                        const double y = std::clamp((reached.low + reached.high) / 2.0, from, to);
                        const double room = room_in(reached, y);
                        if (room <= across_room) return;
                        across_room = room;
                        opposite.y = y;
                    });
                }
            }
            const double most = std::max({left_room, right_room, across_room});
            if (room_here >= 0.0 && (room_here > enough_room || most <= room_here + worth_a_step)) break;
            if (most < 0.0) {
                way.clear();
                return;
            }
            if (left_room >= right_room && left_room >= across_room) {
                add_step(*this, way, pose, at.column, left, direction);
                at = left_to;
            } else if (right_room >= across_room) {
                add_step(*this, way, pose, at.column, right, direction);
                at = right_to;
            } else {
                add_turn_off(*this, way, pose, at.column, opposite.y - at.y, direction);
                at = opposite;
            }
        }
    }
}

std::size_t InnerMap::bytes() const {
    std::size_t sum =
        bytes_of(forward_) + bytes_of(backward_) + bytes_of(parked_) + intervals_.size() * sizeof(Interval);
    for (const std::vector<InnerSet::Few>& free : free_) sum += free.size() * sizeof(InnerSet::Few);
    return sum;
}

}  // namespace snug::detail::sets
