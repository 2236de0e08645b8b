#include "fewest_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace snug::detail {

namespace {

constexpr std::size_t rows_between_looks = 64;
constexpr double infinity = std::numeric_limits<double>::infinity();

double cosine_of(double sine) { return std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))); }

double tangent_of(double sine) { return sine / cosine_of(sine); }

/// A point of the car, from its rear axle centre.
struct CarPoint {
    double ahead, left;

    [[nodiscard]] Point turned(double sine, double cosine) const {
        return {ahead * cosine - left * sine, ahead * sine + left * cosine};
    }
};

/// Least and greatest value of u sin + v cos between two headings, rounded outward.
struct Span {
    double least, greatest;
};
Span span(double u, double v, double sine_from, double sine_to) {
    const double first = u * sine_from + v * cosine_of(sine_from);
    const double last = u * sine_to + v * cosine_of(sine_to);
    if (sine_from == sine_to) return {first, first};
    // Off its chord by at most an eighth of the second derivative times the turn squared.
    const double turn = std::asin(sine_to) - std::asin(sine_from);
    const double bulge = std::hypot(u, v) * turn * turn / 8.0;
    return {std::min(first, last) - bulge, std::max(first, last) + bulge};
}

}  // namespace

std::size_t Rows::cells() const {
    std::size_t sum = 0;
    for (const Window& window : windows) sum += window.size();
    return sum;
}

Lattice::Lattice(const Problem& problem, Enter enter, Bound bound, double spacing, const Anchor& anchor,
                 const Rows* within_coarser, const Watch& watch)
    : problem_(problem),
      enter_(enter),
      bound_(bound),
      spacing_(spacing),
      sine_step_(spacing / (2.0 * problem.radius)),
      anchor_(anchor),
      rounding_(4e-16 * (problem.length + problem.width + 4.0 * problem.radius + problem.touching.front +
                         problem.touching.rear + problem.touching.left)) {
    first_column_ = static_cast<int>(std::ceil((-steepest_sine - anchor.sine) / sine_step_));
    last_column_ = static_cast<int>(std::floor((steepest_sine - anchor.sine) / sine_step_));
    measure_columns();
    find_rows(within_coarser);
    measure_rows(watch);
}

Lattice::Lattice(const Lattice& other, const Problem& problem, Bound bound, const Watch& watch)
    : problem_(problem),
      enter_(other.enter_),
      bound_(bound),
      spacing_(other.spacing_),
      sine_step_(other.sine_step_),
      anchor_(other.anchor_),
      rounding_(other.rounding_),
      first_column_(other.first_column_),
      last_column_(other.last_column_),
      rows_(other.rows_),
      begin_(other.begin_) {
    measure_columns();
    measure_rows(watch);
}

Column Lattice::column(double sine) const {
    const Extents& car = problem_.touching;
    const double cosine = cosine_of(sine);
    const bool cells = bound_ == Bound::lower;
    const double reach = cells ? sine_step_ : 0.0;  // of the cell to either side
    const double least_cosine = std::min(cosine_of(sine - reach), cosine_of(sine + reach));
    // How far a point of the car can be from where it is at the cell's middle, along and across.
    const double farthest = std::hypot(std::max(car.front, car.rear), car.left);
    const double half = spacing_ / 2.0;
    const double along = cells ? half * std::max(1.0, farthest / (problem_.radius * least_cosine)) : 0.0;
    const double across = cells ? half * farthest / (problem_.radius * least_cosine) : 0.0;
    const double outward = cells ? 64.0 * rounding_ : 0.0;
    const double rear_wall = -problem_.length - along - outward;
    const double front_wall = along + outward;

    Column column;
    // Parked: the real frame inside.
    {
        const Extents& parked = problem_.parked;
        const std::array<CarPoint, 4> corners = {
            CarPoint{parked.front, parked.left}, CarPoint{-parked.rear, parked.left},
            CarPoint{-parked.rear, -parked.left}, CarPoint{parked.front, -parked.left}};
        column.start = infinity;
        column.start_from = -infinity;
        column.start_to = infinity;
        for (const CarPoint& corner : corners) {
            column.start = std::min(
                column.start, span(-corner.ahead, problem_.radius - corner.left, sine - reach, sine + reach).greatest);
            const double x = corner.turned(sine, cosine).x;
            column.start_from = std::max(column.start_from, rear_wall - x);
            column.start_to = std::min(column.start_to, front_wall - x);
        }
        column.start += outward;
    }
    const CarPoint front_left{car.front, car.left};
    const CarPoint rear_left{-car.rear, car.left};
    const CarPoint rear_right{-car.rear, -car.left};
    const CarPoint front_right{car.front, -car.left};
    column.curb = -infinity;
    for (const CarPoint& corner : {front_left, rear_left, rear_right, front_right}) {
        const Span lowest = span(-corner.ahead, problem_.radius - corner.left, sine - reach, sine + reach);
        column.curb = std::max(column.curb, lowest.least - problem_.width - outward);
    }

    column.tail_out =
        span(-rear_right.ahead, problem_.radius - rear_right.left, sine - reach, sine + reach).greatest + outward;

    const double to_z = problem_.radius * least_cosine - across - outward;
    const Point front = front_right.turned(sine, cosine);
    const Point rear = rear_right.turned(sine, cosine);
    column.nose_up = sine >= 0.0;
    // From one cell to the next a corner moves at most this far: goals must be deep enough not to be jumped over.
    const double step = half * (1.0 + farthest / (problem_.radius * least_cosine));
    column.out_front = front_wall - front.x;
    column.out_rear = rear_wall - rear.x;
    column.to = column.out_front + 2.0 * step;
    column.from = column.out_rear - 2.0 * step;

    // Beside a neighbour the lowest point above it must not be below the entry side. That point lies where an edge of the
    // frame crosses the wall, so the lowest position is a line in x; beyond the edge's lower end it is that end.
    const double slope = tangent_of(sine);
    if (column.nose_up) {
        column.beside = rear_wall - rear_left.turned(sine, cosine).x;
        column.rear_slope = sine > 0.0 ? -1.0 / slope : 0.0;
        column.rear_at_0 = to_z - rear.y - (rear_wall - rear.x) * column.rear_slope;
        column.front_slope = slope;
        column.front_at_0 = to_z - front.y - (front_wall - front.x) * slope;
    } else {
        column.beside = front_wall - front_left.turned(sine, cosine).x;
        column.front_slope = -1.0 / slope;
        column.front_at_0 = to_z - front.y - (front_wall - front.x) * column.front_slope;
        column.rear_slope = slope;
        column.rear_at_0 = to_z - rear.y - (rear_wall - rear.x) * slope;
    }
    return column;
}

void Lattice::measure_columns() {
    columns_.clear();
    for (int d = first_column_; d <= last_column_; ++d) columns_.push_back(column(sine(d)));
    for (const int parity : {0, 1}) {
        forward_[parity] = terms(Direction::forward, parity);
        backward_[parity] = terms(Direction::backward, parity);
    }
}

SweepTerms Lattice::terms(Direction direction, int parity) const {
    SweepTerms terms;
    constexpr int padding = row_padding;
    const int first = cell_of_column(first_column_) - padding;
    const int last = cell_of_column(last_column_) + padding;
    const double radius = problem_.radius;
    for (int cell = first; cell <= last; ++cell) {
        const int d = 2 * cell + parity;
        double keep = 0.0, from_left = 0.0, from_right = 0.0, ceiling = 0.0;
        if (d > first_column_ && d < last_column_) {
            const bool forward = direction == Direction::forward;
            ceiling = at(d).tail_out;
            if (bound_ == Bound::upper) {
                // A left turn leaves z alone, a right turn y - r cos(heading).
                const auto gains = [&](int from) {
                    return 2.0 * radius * (cosine_of(sine(d)) - cosine_of(sine(from)));
                };
                (forward ? from_right : from_left) = gains(forward ? d + 1 : d - 1);
            } else {
                // Gain of z where a changes by h: at most the tangent at the cell's steepest corner. Within a cell z is
                // at most Z + max(0, gain); kept is that maximum.
                const auto gain = [&](int column) {
                    return forward ? spacing_ * tangent_of(sine(column + 1)) : -spacing_ * tangent_of(sine(column - 1));
                };
                const auto within = [&](int column) { return std::max(0.0, gain(column)); };
                const int before = forward ? d - 1 : d + 1;  // where a stays
                const int other = forward ? d + 1 : d - 1;   // where it changes
                keep = std::abs(gain(d)) + 2.0 * rounding_;
                (forward ? from_left : from_right) = within(d) - within(before) + 2.0 * rounding_;
                (forward ? from_right : from_left) = gain(other) - within(other) + within(d) + 2.0 * rounding_;
            }
        }
        terms.keep.push_back(keep);
        terms.from_left.push_back(from_left);
        terms.from_right.push_back(from_right);
        terms.ceiling.push_back(ceiling);
    }
    return terms;
}

void Lattice::find_rows(const Rows* within_coarser) {
    if (within_coarser != nullptr) {
        // A cell lies within one row and one column of its place in the coarser lattice.
        const Rows& coarse = *within_coarser;
        const int coarse_last = coarse.first + static_cast<int>(coarse.windows.size()) - 1;
        rows_.first = 2 * coarse.first - 2;
        rows_.windows.assign(2 * coarse.windows.size() + 3, {});
        for (int s = rows_.first; s <= 2 * coarse_last + 2; ++s) {
            Window& window = rows_.windows[static_cast<std::size_t>(s - rows_.first)];
            const int middle = s >> 1;
            for (int t = std::max(coarse.first, middle - 1); t <= std::min(coarse_last, middle + 2); ++t) {
                const Window& from = coarse.windows[static_cast<std::size_t>(t - coarse.first)];
                if (from.empty()) continue;
                window.cover({cell_of_column(std::max(first_column_, 2 * column_of_cell(t, from.from) - 3)),
                              cell_of_column(std::min(last_column_, 2 * column_of_cell(t, from.to) + 3))});
            }
        }
    } else {
        double from = infinity, to = -infinity;
        for (const Column& column : columns_) {
            from = std::min(from, column.from);
            to = std::max(to, column.to);
        }
        const double per_row = 2.0 / spacing_;
        rows_.first = static_cast<int>(std::floor((from - anchor_.x) * per_row)) - 1;
        const int last = static_cast<int>(std::ceil((to - anchor_.x) * per_row)) + 1;
        rows_.windows.assign(static_cast<std::size_t>(last - rows_.first) + 1, {});
        for (int d = first_column_; d <= last_column_; ++d) {
            const int bottom = static_cast<int>(std::floor((at(d).from - anchor_.x) * per_row)) - 1;
            const int top = static_cast<int>(std::ceil((at(d).to - anchor_.x) * per_row)) + 1;
            for (int s = std::max(bottom, rows_.first); s <= std::min(top, last); ++s)
                if (((s + d) & 1) == 0)
                    rows_.windows[static_cast<std::size_t>(s - rows_.first)].cover(
                        {cell_of_column(d), cell_of_column(d)});
        }
    }
    begin_.clear();
    std::size_t begin = 0;
    for (const Window& window : rows_.windows) {
        begin_.push_back(begin);
        begin += window.size() + 2 * row_padding;
    }
    begin_.push_back(begin);
}

std::size_t Lattice::index(int row, int cell) const {
    const auto i = static_cast<std::size_t>(row - rows_.first);
    return begin_[i] + static_cast<std::size_t>(cell - rows_.windows[i].from) + row_padding;
}

void Lattice::measure_rows(const Watch& watch) {
    needed_.assign(begin_.back(), infinity);
    goals_.clear();
    for (std::size_t i = 0; i < rows_.windows.size(); ++i) {
        if (i % rows_between_looks == 0) watch();
        const int s = rows_.first + static_cast<int>(i);
        const double here = x(s);
        const Window window = rows_.windows[i];
        for (int cell = window.from; cell <= window.to; ++cell) {
            const int d = column_of_cell(s, cell);
            if (d <= first_column_ || d >= last_column_) continue;
            const Column& column = at(d);
            if (!(here >= column.from && here <= column.to)) continue;
            const bool out_front = here > column.out_front;
            const bool out_rear = here < column.out_rear;
            double needed = column.curb;
            if (out_front || (!column.nose_up && here > column.beside)) {
                const double above = column.nose_up ? here : std::min(here, column.out_front);
                needed = std::max(needed, column.front_at_0 + column.front_slope * above);
            }
            if (out_rear || (column.nose_up && here < column.beside)) {
                const double above = column.nose_up ? std::max(here, column.out_rear) : here;
                needed = std::max(needed, column.rear_at_0 + column.rear_slope * above);
            }
            needed_[index(s, cell)] = needed;
            if (d == first_column_ + 1 || d == last_column_ - 1) {
                goals_.push_back({s, cell, Goal::upright});
            } else if (out_front || out_rear) {
                goals_.push_back({s, cell, out_front ? Goal::front : Goal::rear});
            }
        }
    }
    if (enter_ == Enter::backward) return;
    needed_backward_ = needed_;
    for (const Goal& goal : goals_)
        if (goal.where != Goal::upright || bound_ == Bound::upper)
            needed_backward_[index(goal.row, goal.cell)] = infinity;
}

Heights::Heights(const Lattice& lattice) : lattice_(&lattice), z_(lattice.needed_.size(), nowhere) {
    reached_.first = lattice.rows_.first;
    reached_.windows.assign(lattice.rows_.windows.size(), {});
}

void Heights::start_parked() {
    const Lattice& lattice = *lattice_;
    for (int d = lattice.first_column_ + 1; d < lattice.last_column_; ++d) {
        const Column& column = lattice.at(d);
        if (!(column.start >= column.curb && column.start_from <= column.start_to)) continue;
        const double per_row = 2.0 / lattice.spacing_;
        const int from = static_cast<int>(std::ceil((column.start_from - lattice.anchor_.x) * per_row)) - 1;
        const int to = static_cast<int>(std::floor((column.start_to - lattice.anchor_.x) * per_row)) + 1;
        for (int s = from + ((from + d) & 1); s <= to; s += 2) {
            if (lattice.x(s) < column.start_from || lattice.x(s) > column.start_to) continue;
            start_at(s, d, column.start);
        }
    }
}

void Heights::start_at(int row, int column, double z) {
    if (!lattice_->holds(row, column) || z < lattice_->needed(row, column)) return;
    const int cell = cell_of_column(column);
    z_[lattice_->index(row, cell)] = z;
    reached_.windows[static_cast<std::size_t>(row - reached_.first)].cover({cell, cell});
}

double Heights::at(int row, int column) const {
    const int i = row - reached_.first;
    if (i < 0 || i >= static_cast<int>(reached_.windows.size())) return nowhere;
    const Window& window = reached_.windows[static_cast<std::size_t>(i)];
    const int cell = cell_of_column(column);
    return cell >= window.from && cell <= window.to ? z_[lattice_->index(row, cell)] : nowhere;
}

void Heights::sweep_cells(int row, const Window& cells, Direction direction, const double* before) {
    if (cells.empty()) return;
    const std::size_t count = cells.size();
    if (before == nullptr) {
        if (nothing_.size() < count + 2 * row_padding) nothing_.assign(count + 2 * row_padding, nowhere);
        before = nothing_.data();
    }
    const bool backward = direction == Direction::backward && !lattice_->needed_backward_.empty();
    const std::vector<double>& needed = backward ? lattice_->needed_backward_ : lattice_->needed_;
    const SweepTerms& terms = lattice_->terms_of(direction, row);
    const Above above = !backward ? Above::allowed : lattice_->bound_ == Bound::lower ? Above::lowered : Above::dropped;
    const std::size_t term = lattice_->term(cells.from);
    const std::size_t begin = lattice_->index(row, cells.from);
    sweep_row(&z_[begin], before, before + 1, &terms.keep[term], &terms.from_left[term], &terms.from_right[term],
              &needed[begin], above, above == Above::allowed ? nullptr : &terms.ceiling[term], count);
}

bool Heights::sweep(Direction direction, const Watch& watch) {
    const Lattice& lattice = *lattice_;
    const int count = static_cast<int>(reached_.windows.size());
    const int step = direction == Direction::forward ? 1 : -1;
    Window before;
    for (int i = step > 0 ? 1 : count - 2; i > 0 && i < count - 1; i += step) {
        if (static_cast<std::size_t>(i) % rows_between_looks == 0) watch();
        const int s = reached_.first + i;
        const auto row = static_cast<std::size_t>(i);
        Window window = reached_.windows[row];
        if (!before.empty()) window.cover({before.from - 1, before.to + 1});
        const Window& all = lattice.rows_.windows[row];
        window = {std::max(window.from, all.from), std::min(window.to, all.to)};
        if (window.empty()) {
            before = {};
            continue;
        }
        // Where the row before does not reach, nothing comes from it.
        const Window& other = lattice.rows_.windows[static_cast<std::size_t>(i - step)];
        const Window shared = before.empty() ? Window{}
                                             : Window{std::clamp(other.from - 1, window.from, window.to + 1),
                                                      std::clamp(other.to + 1, window.from - 1, window.to)};
        if (shared.empty()) {
            sweep_cells(s, window, direction, nullptr);
        } else {
            const int left = shared.from - 1 + (s & 1);  // the cell of the column to the left
            sweep_cells(s, {window.from, shared.from - 1}, direction, nullptr);
            sweep_cells(s, shared, direction, &z_[lattice.index(s - step, other.from)] + (left - other.from));
            sweep_cells(s, {shared.to + 1, window.to}, direction, nullptr);
        }
        updates_ += window.size();
        while (!window.empty() && z_[lattice.index(s, window.from)] == nowhere) ++window.from;
        while (!window.empty() && z_[lattice.index(s, window.to)] == nowhere) --window.to;
        if (window.empty()) window = {};
        reached_.windows[row] = before = window;
    }
    return std::any_of(lattice.goals_.begin(), lattice.goals_.end(),
                       [&](const Lattice::Goal& goal) { return z_[lattice.index(goal.row, goal.cell)] > nowhere; });
}

}  // namespace snug::detail
