#include "all_maneuvers/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace snug::detail {

namespace {

constexpr std::size_t rows_between_looks = 64;
constexpr double infinity = std::numeric_limits<double>::infinity();

double cosine_of(double sine) { return std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))); }

/// A point of the car, from its rear axle centre.
struct CarPoint {
    double ahead, left;

    [[nodiscard]] Point turned(double sine, double cosine) const {
        return {ahead * cosine - left * sine, ahead * sine + left * cosine};
    }
};

/// A stretch of headings.
struct CellHeadings {
    double sine_from, cosine_from, sine_to, cosine_to;
    double bulge;  ///< an eighth of the greatest turn squared

    CellHeadings(double sine, double reach)
        : sine_from(sine - reach),
          cosine_from(cosine_of(sine_from)),
          sine_to(sine + reach),
          cosine_to(cosine_of(sine_to)),
          bulge(reach * reach / (2.0 * least_cosine() * least_cosine())) {}
    [[nodiscard]] double least_cosine() const { return std::min(cosine_from, cosine_to); }

    /// Least and greatest value of u sin + v cos, rounded outward: off its chord by at most an eighth of the second
    /// derivative times the turn squared.
    struct Span {
        double least, greatest;
    };
    [[nodiscard]] Span span(double u, double v) const {
        const double first = u * sine_from + v * cosine_from;
        const double last = u * sine_to + v * cosine_to;
        const double off = std::sqrt(u * u + v * v) * bulge;
        return {std::min(first, last) - off, std::max(first, last) + off};
    }
};

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
    if (within_coarser != nullptr) {
        find_rows(*within_coarser);
        if (measured_.empty()) measured_ = {first_column_, first_column_};
        measure_columns();
    } else {
        measured_ = {first_column_, last_column_};
        measure_columns();
        find_rows();
    }
    std::size_t begin = 0;
    for (const Window& window : rows_.windows) {
        begin_.push_back(begin);
        begin += window.size() + 2 * row_padding;
    }
    begin_.push_back(begin);
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
      measured_(other.measured_),
      rows_(other.rows_),
      begin_(other.begin_) {
    measure_columns();
    measure_rows(watch);
}

void Lattice::measure_column(int d) {
    const Extents& car = problem_.touching;
    const bool cells = bound_ == Bound::lower;
    const double sine = this->sine(d);
    const CellHeadings headings(sine, cells ? sine_step_ : 0.0);  // of the cell
    const double least_cosine = headings.least_cosine();
    // How far a point of the car can be from where it is at the cell's middle, along and across.
    const double farthest = angles::hypot(std::max(car.front, car.rear), car.left);
    const double half = spacing_ / 2.0;
    const double along = cells ? half * std::max(1.0, farthest / (problem_.radius * least_cosine)) : 0.0;
    const double across = cells ? half * farthest / (problem_.radius * least_cosine) : 0.0;
    const double outward = cells ? 64.0 * rounding_ : 0.0;
    const double rear_wall = -problem_.length - along - outward;
    const double front_wall = along + outward;

    const int place = d - measured_.from + 2;
    Column& column = columns_[static_cast<std::size_t>(place)];
    column.cosine = cosine_of(sine);
    column.tangent = sine / column.cosine;
    // Parked: the real frame inside.
    const Extents& parked = problem_.parked;
    column.start = infinity;
    column.start_from = -infinity;
    column.start_to = infinity;
    for (const CarPoint& corner : {CarPoint{parked.front, parked.left}, CarPoint{-parked.rear, parked.left},
                                   CarPoint{-parked.rear, -parked.left}, CarPoint{parked.front, -parked.left}}) {
        const double top = headings.span(-corner.ahead, problem_.radius - corner.left).greatest;
        column.start = std::min(column.start, top + outward);
        const double x = corner.turned(sine, column.cosine).x;
        column.start_from = std::max(column.start_from, rear_wall - x);
        column.start_to = std::min(column.start_to, front_wall - x);
    }
    const CarPoint front_left{car.front, car.left};
    const CarPoint rear_left{-car.rear, car.left};
    const CarPoint rear_right{-car.rear, -car.left};
    const CarPoint front_right{car.front, -car.left};
    const auto height = [&](const CarPoint& corner) {
        return headings.span(-corner.ahead, problem_.radius - corner.left);
    };
    column.tail_out = height(rear_right).greatest + outward;

    const Point front = front_right.turned(sine, column.cosine);
    const Point rear = rear_right.turned(sine, column.cosine);
    // From one cell to the next a corner moves at most this far: goals must be deep enough not to be jumped over.
    const double step = half * (1.0 + farthest / (problem_.radius * least_cosine));
    column.out_front = front_wall - front.x;
    column.out_rear = rear_wall - rear.x;
    column.to = column.out_front + 2.0 * step;
    column.from = column.out_rear - 2.0 * step;

    Limits& limits = limits_[d & 1];
    const std::size_t i = term(cell_of_column(d));
    if (d > first_column_ && d < last_column_) {
        limits.from[i] = column.from;
        limits.to[i] = column.to;
    }
    limits.curb[i] = std::max({height(front_left).least, height(rear_left).least, height(rear_right).least,
                               height(front_right).least}) -
                     problem_.width - outward;
    // Beside a neighbour the lowest point above it must not be below the entry side. That point lies where an edge of the
    // frame crosses the wall, so the lowest position is a line in x; beyond the edge's lower end it is that end.
    const bool nose_up = sine >= 0.0;
    const double steep = sine == 0.0 ? 0.0 : -1.0 / column.tangent;
    limits.front_slope[i] = nose_up ? column.tangent : steep;
    limits.rear_slope[i] = nose_up ? steep : column.tangent;
    limits.front_from[i] = column.out_front;
    limits.rear_to[i] = column.out_rear;
    if (nose_up) {
        limits.rear_to[i] = std::max(column.out_rear, rear_wall - rear_left.turned(sine, column.cosine).x);
    } else {
        limits.front_from[i] = std::min(column.out_front, front_wall - front_left.turned(sine, column.cosine).x);
    }
    limits.front_level[i] = nose_up ? infinity : column.out_front;
    limits.rear_level[i] = nose_up ? column.out_rear : -infinity;
    const double to_z = problem_.radius * least_cosine - across - outward;
    limits.front_at_0[i] = to_z - front.y - (front_wall - front.x) * limits.front_slope[i];
    limits.rear_at_0[i] = to_z - rear.y - (rear_wall - rear.x) * limits.rear_slope[i];
}

void Lattice::measure_columns() {
    columns_.resize(measured_.size() + 4);
    const std::size_t count = term(cell_of_column(measured_.to)) + 1 + row_padding;
    for (Limits& limits : limits_) {
        limits.from.assign(count, infinity);  // nothing beside the columns
        for (std::vector<double>* numbers :
             {&limits.to, &limits.curb, &limits.front_from, &limits.front_level, &limits.front_at_0,
              &limits.front_slope, &limits.rear_to, &limits.rear_level, &limits.rear_at_0, &limits.rear_slope})
            numbers->assign(count, 0.0);
    }
    for (int d = measured_.from - 2; d <= measured_.to + 2; ++d) measure_column(d);
    for (const int parity : {0, 1}) {
        forward_[parity] = terms(Direction::forward, parity);
        backward_[parity] = terms(Direction::backward, parity);
    }
}

SweepTerms Lattice::terms(Direction direction, int parity) const {
    SweepTerms terms;
    constexpr int padding = row_padding;
    const int first = cell_of_column(measured_.from) - padding;
    const int last = cell_of_column(measured_.to) + padding;
    const double radius = problem_.radius;
    for (int cell = first; cell <= last; ++cell) {
        const int d = 2 * cell + parity;
        double keep = 0.0, from_left = 0.0, from_right = 0.0, ceiling = 0.0;
        if (d >= measured_.from && d <= measured_.to && d > first_column_ && d < last_column_) {
            const bool forward = direction == Direction::forward;
            ceiling = at(d).tail_out;
            if (bound_ == Bound::upper) {
                // A left turn leaves z alone, a right turn y - r cos(heading).
                const auto gains = [&](int from) { return 2.0 * radius * (at(d).cosine - at(from).cosine); };
                (forward ? from_right : from_left) = gains(forward ? d + 1 : d - 1);
            } else {
                // Gain of z where a changes by h: at most the tangent at the cell's steepest corner. Within a cell z is
                // at most Z + max(0, gain); kept is that maximum.
                const auto gain = [&](int column) {
                    return spacing_ * (forward ? at(column + 1).tangent : -at(column - 1).tangent);
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

void Lattice::find_rows(const Rows& coarse) {
    // A cell lies within one row and one column of its place in the coarser lattice.
    int first = coarse.first;
    int last = coarse.first + static_cast<int>(coarse.windows.size()) - 1;
    const auto window_of = [&](int t) { return coarse.windows[static_cast<std::size_t>(t - coarse.first)]; };
    while (first < last && window_of(first).empty()) ++first;
    while (first < last && window_of(last).empty()) --last;
    rows_.first = 2 * first - 4;
    for (int s = rows_.first; s <= 2 * last + 4; ++s) {
        Window& window = rows_.windows.emplace_back();
        const int middle = s >> 1;
        for (int t = std::max(first, middle - 1); t <= std::min(last, middle + 2); ++t) {
            const Window from = window_of(t);
            if (from.empty()) continue;
            window.cover({cell_of_column(std::max(first_column_, 2 * column_of_cell(t, from.from) - 3)),
                          cell_of_column(std::min(last_column_, 2 * column_of_cell(t, from.to) + 3))});
        }
        if (!window.empty()) measured_.cover({column_of_cell(s, window.from), column_of_cell(s, window.to)});
    }
}

void Lattice::find_rows() {
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
                rows_.windows[static_cast<std::size_t>(s - rows_.first)].cover({cell_of_column(d), cell_of_column(d)});
    }
}

std::size_t Lattice::index(int row, int cell) const {
    const auto i = static_cast<std::size_t>(row - rows_.first);
    return begin_[i] + static_cast<std::size_t>(cell - rows_.windows[i].from) + row_padding;
}

void Lattice::measure_rows(const Watch& watch) {
    needed_.assign(begin_.back(), infinity);
    for (std::size_t i = 0; i < rows_.windows.size(); ++i) {
        if (i % rows_between_looks == 0) watch();
        const int row = rows_.first + static_cast<int>(i);
        const Window& window = rows_.windows[i];
        if (!window.empty())
            measure_row(&needed_[begin_[i] + row_padding], limits_[row & 1], term(window.from), x(row), window.size());
    }
    find_goals();
    if (enter_ == Enter::backward) return;
    needed_backward_ = needed_;
    for (const Goal& goal : goals_)
        if (goal.where != Goal::upright || bound_ == Bound::upper)
            needed_backward_[index(goal.row, goal.cell)] = infinity;
}

void Lattice::find_goals() {
    goals_.clear();
    const double per_row = 2.0 / spacing_;
    for (int d = std::max(first_column_ + 1, measured_.from); d <= std::min(last_column_ - 1, measured_.to); ++d) {
        const Column& column = at(d);
        const bool upright = d == first_column_ + 1 || d == last_column_ - 1;
        const auto add = [&](double from, double to, auto&& where) {
            const int first = static_cast<int>(std::floor((from - anchor_.x) * per_row)) - 1;
            const int last = static_cast<int>(std::ceil((to - anchor_.x) * per_row)) + 1;
            for (int s = first + ((first + d) & 1); s <= last; s += 2) {
                const double here = x(s);
                if (holds(s, d) && here >= column.from && here <= column.to && (upright || where(here)))
                    goals_.push_back({s, cell_of_column(d),
                                      upright                   ? Goal::upright
                                      : here > column.out_front ? Goal::front
                                                                : Goal::rear});
            }
        };
        if (upright) {
            add(column.from, column.to, [](double) { return true; });
        } else {
            add(column.from, column.out_rear, [&](double here) { return here < column.out_rear; });
            add(column.out_front, column.to, [&](double here) { return here > column.out_front; });
        }
    }
}

Heights::Heights(const Lattice& lattice) : lattice_(&lattice), z_(lattice.needed_.size(), nowhere) {
    reached_.first = lattice.rows_.first;
    reached_.windows.assign(lattice.rows_.windows.size(), {});
}

void Heights::start_parked() {
    const Lattice& lattice = *lattice_;
    const int first = std::max(lattice.first_column_ + 1, lattice.measured_.from);
    const int last = std::min(lattice.last_column_ - 1, lattice.measured_.to);
    for (int d = first; d <= last; ++d) {
        const Column& column = lattice.at(d);
        const double curb = lattice.limits_[d & 1].curb[lattice.term(cell_of_column(d))];
        if (!(column.start >= curb && column.start_from <= column.start_to)) continue;
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
