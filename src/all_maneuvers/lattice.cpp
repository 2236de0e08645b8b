#include "all_maneuvers/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "all_maneuvers/right_side.hpp"
#include "model/angles.hpp"

namespace snug::detail {

namespace {

constexpr std::size_t rows_between_looks = 64;
constexpr int columns_between_looks = 64;
constexpr double infinity = std::numeric_limits<double>::infinity();

double cosine_of(double sine) { return std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))); }

/// A point of the car, or an edge of it, at a heading.
Point turned(const Point& point, double sine, double cosine) {
    return {point.x * cosine - point.y * sine, point.x * sine + point.y * cosine};
}

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

/// The same number many times over. Fresh memory is slow, so somebody looks at the clock now and then.
Numbers<double> many(std::size_t count, double number, const Watch& watch) {
    constexpr std::size_t at_once = std::size_t{1} << 20;
    Numbers<double> numbers(watch.store(), count);
    for (std::size_t done = 0; done < count; done += at_once) {
        std::fill_n(numbers.data() + done, std::min(count - done, at_once), number);
        watch();
    }
    return numbers;
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
      rounding_(4e-16 * (problem.length + problem.width + 4.0 * problem.radius + problem.body.front() +
                         problem.body.rear() + std::max(problem.body.left(), problem.body.right()))) {
    measure_body();
    first_column_ = static_cast<int>(std::ceil((-steepest_sine - anchor.sine) / sine_step_));
    last_column_ = static_cast<int>(std::floor((steepest_sine - anchor.sine) / sine_step_));
    if (within_coarser != nullptr) {
        find_rows(*within_coarser);
        if (measured_.empty()) measured_ = {first_column_, first_column_};
        measure_columns(watch);
    } else {
        measured_ = {first_column_, last_column_};
        measure_columns(watch);
        find_rows(watch);
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
    measure_body();
    measure_columns(watch);
    measure_rows(watch);
}

double Lattice::most_cells(const Problem& problem, double spacing) {
    double farthest = 0.0;
    for (const Point& corner : problem.body.corners()) farthest = std::max(farthest, angles::hypot(corner.x, corner.y));
    const double rows = 2.0 * (problem.length + 2.0 * farthest) / spacing + 100.0;
    const double columns = 2.0 * steepest_sine * problem.radius / spacing + 2.0 * row_padding + 2.0;  // in a row
    return rows * columns;
}

void Lattice::measure_body() {
    const RightSide side(problem_.body);
    front_corner_ = side.front;
    rear_corner_ = side.rear;
    farthest_ = 0.0;
    for (const Point& corner : problem_.body.corners())
        farthest_ = std::max(farthest_, angles::hypot(corner.x, corner.y));
    // Parked at most so far off parallel.
    const double most = problem_.parked.heading;
    steepest_parked_ = most < 1.5 ? angles::sin(most) : 1.0;
}

bool Lattice::may_park_upright() const {
    const double sine = steepest_sine - 4.0 * sine_step_;
    if (steepest_parked_ < sine) return false;
    // From the foremost corner to the rearmost, as nearly level with each other as there are.
    double ahead[2] = {infinity, -infinity}, behind[2] = {infinity, -infinity};
    for (const Point& corner : problem_.frame.corners()) {
        for (auto& [end, reach] : {std::pair{&ahead, corner.x - problem_.frame.front()},
                                   std::pair{&behind, -problem_.frame.rear() - corner.x}}) {
            if (reach < -1e-12 * farthest_) continue;
            (*end)[0] = std::min((*end)[0], corner.y);
            (*end)[1] = std::max((*end)[1], corner.y);
        }
    }
    const double aslant = std::max({0.0, ahead[0] - behind[1], behind[0] - ahead[1]});
    return problem_.width >= (problem_.frame.front() + problem_.frame.rear()) * sine - aslant * cosine_of(sine);
}

void Lattice::measure_column(int d) {
    const bool cells = bound_ == Bound::lower;
    const double sine = this->sine(d);
    const CellHeadings headings(sine, cells ? sine_step_ : 0.0);  // of the cell
    const double least_cosine = headings.least_cosine();
    // How far a point of the car can be from where it is at the cell's middle, along and across.
    const double half = spacing_ / 2.0;
    const double along = cells ? half * std::max(1.0, farthest_ / (problem_.radius * least_cosine)) : 0.0;
    const double across = cells ? half * farthest_ / (problem_.radius * least_cosine) : 0.0;
    const double outward = cells ? 64.0 * rounding_ : 0.0;
    const double rear_wall = -problem_.length - along - outward;
    const double front_wall = along + outward;

    const int place = d - measured_.from + 2;
    Column& column = columns_[static_cast<std::size_t>(place)];
    column.cosine = cosine_of(sine);
    column.tangent = sine / column.cosine;
    // Heights at which a point of the car is level with the entry side.
    const auto level = [&](const Point& point) { return headings.span(-point.x, problem_.radius - point.y); };
    // Parked: the real frame inside, and near enough to the curb.
    column.start = infinity;
    column.start_from = -infinity;
    column.start_to = infinity;
    double lowest = -infinity;
    for (const Point& corner : problem_.frame.corners()) {
        const CellHeadings::Span height = level(corner);
        column.start = std::min(column.start, height.greatest + outward);
        lowest = std::max(lowest, height.greatest);
        const double x = turned(corner, sine, column.cosine).x;
        column.start_from = std::max(column.start_from, rear_wall - x);
        column.start_to = std::min(column.start_to, front_wall - x);
    }
    column.start = std::min(column.start, lowest - problem_.width + problem_.parked.curb + outward);
    const double margin = cells ? -sine_step_ - 1e-12 : sine == 0.0 ? 0.0 : 1e-12;
    if (std::abs(sine) + margin > steepest_parked_) column.start = -infinity;

    column.tail_out = level(rear_corner_).greatest + outward;
    if (!cells) {  // on an arc to the next point the corner rises above both ends
        const double reach = angles::hypot(rear_corner_.x, problem_.radius + std::abs(rear_corner_.y));
        const double turn = sine_step_ / cosine_of(std::abs(sine) + sine_step_);
        column.tail_out -= reach * turn * turn / 8.0;
    }

    // From one cell to the next a corner moves at most this far: goals must be deep enough not to be jumped over.
    const double step = half * (1.0 + farthest_ / (problem_.radius * least_cosine));
    column.out_front = front_wall - turned(front_corner_, sine, column.cosine).x;
    column.out_rear = rear_wall - turned(rear_corner_, sine, column.cosine).x;
    column.to = column.out_front + 2.0 * step;
    column.from = column.out_rear - 2.0 * step;

    Limits& limits = limits_[d & 1];
    const std::size_t i = term(cell_of_column(d));
    double curb = -infinity;
    for (const Point& corner : problem_.at_curb.corners()) curb = std::max(curb, level(corner).least);
    limits.curb[i] = curb - problem_.width - outward;
    measure_neighbours(d, front_wall, rear_wall, problem_.radius * least_cosine - across - outward);
    // Where a neighbour stands so deep that a car above it may count as parked, it is out already.
    const auto lift = [&](const Neighbour& neighbour, double x) {
        double least = neighbour.level[i];
        for (const Neighbour::Lines& lines : neighbour.lines)
            least = std::min(least, lines.at_0[i] + lines.slope[i] * x);
        return least;
    };
    if (column.start_to > column.to && column.start >= lift(limits.front, column.to)) column.to = column.start_to;
    if (column.start_from < column.from && column.start >= lift(limits.rear, column.from))
        column.from = column.start_from;
    if (d > first_column_ && d < last_column_) {
        limits.from[i] = column.from;
        limits.to[i] = column.to;
    }
}

void Lattice::measure_neighbours(int d, double front_wall, double rear_wall, double to_z) {
    // Beside a neighbour the lowest point above it must not be below its top. That point lies where a lower edge of the
    // body crosses the wall, so the lowest position is a line in x; beyond the edge's lower end it is that end. The lower
    // edges curve upward, so of several lines the least counts.
    const double sine = this->sine(d);
    const double cosine = cosine_of(sine);
    const std::vector<Point>& corners = problem_.body.corners();
    Limits& limits = limits_[d & 1];
    const std::size_t i = term(cell_of_column(d));
    double rightmost = -infinity, leftmost = infinity, low = infinity;
    std::size_t rising = 0, falling = 0;
    const auto add = [&](Neighbour& neighbour, std::size_t place, double wall, double height, const Point& at,
                         double slope) {
        if (neighbour.lines.size() <= place) {
            const std::size_t count = neighbour.level.size();
            neighbour.lines.push_back({std::vector<double>(count, infinity), std::vector<double>(count, 0.0)});
        }
        neighbour.lines[place].at_0[i] = height - at.y - (wall - at.x) * slope;
        neighbour.lines[place].slope[i] = slope;
    };
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Point& next = corners[k + 1 == corners.size() ? 0 : k + 1];
        const Point at = turned(corners[k], sine, cosine);
        rightmost = std::max(rightmost, at.x);
        leftmost = std::min(leftmost, at.x);
        low = std::min(low, at.y);
        const Point edge = turned({next.x - corners[k].x, next.y - corners[k].y}, sine, cosine);
        if (!(edge.x > 0.0)) continue;  // an upper one
        if (edge.y > 0.0) add(limits.front, rising++, front_wall, to_z - problem_.front_setback, at, edge.y / edge.x);
        if (edge.y < 0.0) add(limits.rear, falling++, rear_wall, to_z - problem_.rear_setback, at, edge.y / edge.x);
    }
    limits.front.wall[i] = front_wall - rightmost;
    limits.rear.wall[i] = rear_wall - leftmost;
    limits.front.level[i] = to_z - problem_.front_setback - low;
    limits.rear.level[i] = to_z - problem_.rear_setback - low;
}

void Lattice::measure_columns(const Watch& watch) {
    columns_.resize(measured_.size() + 4);
    const std::size_t count = term(cell_of_column(measured_.to)) + 1 + row_padding;
    for (Limits& limits : limits_) {
        limits.from.assign(count, infinity);  // nothing beside the columns
        limits.front.lines.clear();
        limits.rear.lines.clear();
        for (std::vector<double>* numbers :
             {&limits.to, &limits.curb, &limits.front.wall, &limits.front.level, &limits.rear.wall, &limits.rear.level})
            numbers->assign(count, 0.0);
    }
    for (int d = measured_.from - 2; d <= measured_.to + 2; ++d) {
        if (d % columns_between_looks == 0) watch();
        measure_column(d);
    }
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

void Lattice::find_rows(const Watch& watch) {
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
        if (d % columns_between_looks == 0) watch();
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
    needed_ = many(begin_.back(), infinity, watch);
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

Heights::Heights(const Lattice& lattice, const Watch& watch)
    : lattice_(&lattice), z_(many(lattice.needed_.size(), nowhere, watch)) {
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
    const Numbers<double>& needed = backward ? lattice_->needed_backward_ : lattice_->needed_;
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
