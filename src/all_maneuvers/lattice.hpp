// The lattice on which all maneuvers are compared: how high the car can be at each place and heading.
//
// The rear axle centre's x and the heading make two characteristic coordinates a = x - r sin(heading) and
// b = x + r sin(heading), which no forward motion lets fall and no backward motion lets rise. The lattice has the spacing h
// in both. Row s holds the places x = s h / 2 and column d the headings with sine d h / (2 r); s + d is even. A full left
// turn forward leads from (s, d) to (s + 1, d + 1), a full right turn to (s + 1, d - 1), backward likewise the other way.
// docs/fewest.md has the reasons for every number here.
//
// Heights are kept as z = y + r cos(heading) in the entering frame (entering.hpp), and the car leaves the slot: time runs
// backward.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "all_maneuvers/numbers.hpp"
#include "all_maneuvers/watch.hpp"
#include "contact/entering.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail {

/// Which bound on the number of direction changes the lattice gives.
enum class Bound {
    lower,  ///< cells around the lattice's points hold every real motion: what they cannot do, no car can
    upper,  ///< points joined by arcs of full steering are motions themselves, if nothing is met in between
};

/// Where the lattice's row 0 and column 0 lie.
struct Anchor {
    double x = 0.0;
    double sine = 0.0;
};

/// Cells of a row or columns, both ends included.
struct Window {
    int from = 1;
    int to = 0;

    [[nodiscard]] bool empty() const { return from > to; }
    [[nodiscard]] std::size_t size() const { return empty() ? 0 : static_cast<std::size_t>(to - from) + 1; }
    void cover(const Window& other) {
        if (other.empty()) return;
        if (empty()) {
            *this = other;
        } else {
            from = from < other.from ? from : other.from;
            to = to > other.to ? to : other.to;
        }
    }
};

/// A window of every row from the first on.
struct Rows {
    int first = 0;
    std::vector<Window> windows;

    [[nodiscard]] std::size_t cells() const;
};

/// Within row s the cell of column d has this index; neighbours in a row are two columns apart.
inline int cell_of_column(int d) { return d >> 1; }
inline int column_of_cell(int row, int cell) { return 2 * cell + (row & 1); }

/// What a sweep adds on its way: from the column to the left (d - 1) and to the right (d + 1) in the row before, and to a
/// car that begins its move here.
struct SweepTerms {
    std::vector<double> keep, from_left, from_right;
    std::vector<double> ceiling;  ///< see Above
};

/// Spare numbers around every row, because whole vectors are read.
constexpr std::size_t row_padding = 16;

/// Steeper headings are upright: the lattices end there, all at the same heading, so that what the coarse ones leave out no
/// finer one needs. Spacings of at most a 64th of the turning radius keep the last cells and terms below the vertical.
constexpr double steepest_sine = 0.96;

/// Numbers of one column; heights as z. [m]
struct Column {
    double cosine = 1.0, tangent = 0.0;
    double start = 0.0;                       ///< highest parked position
    double start_from = 0.0, start_to = 0.0;  ///< and where there are any
    double tail_out = 0.0;                    ///< lowest one with the tail's right corner above the entry side
    double from = 0.0, to = 0.0;              ///< the column ends here
    double out_rear = 0.0, out_front = 0.0;   ///< beyond, the car is out
};

/// How high a neighbour lifts the cars of one parity's columns that reach beyond its wall. The car's lower edges cross the
/// wall one after the other, so the lowest position is the least of a few straight lines in x, and at last level. [m]
struct Neighbour {
    std::vector<double> wall;   ///< beyond this x the car is above the neighbour
    std::vector<double> level;  ///< lowest position above it, wherever the car is
    struct Lines {
        std::vector<double> at_0, slope;
    };
    std::vector<Lines> lines;  ///< as many as the column with most edges needs; a rectangle's need one
};

/// Where the obstacles let a car be, for all columns of one parity. [m]
struct Limits {
    std::vector<double> from, to;  ///< the column's ends
    std::vector<double> curb;      ///< lowest position above the curb
    Neighbour front, rear;
};

/// All that is fixed: obstacles and terms. Entering nose first the nose must stay in (see fewest.hpp): in the entering
/// frame the car then never backs its tail out.
class Lattice {
public:
    /// No lattice that begins anew has more cells.
    static double most_cells(const Problem& problem, double spacing);

    /// Within those rows of a lattice twice as coarse, if given, everything that matters must lie.
    Lattice(const Problem& problem, Enter enter, Bound bound, double spacing, const Anchor& anchor,
            const Rows* within_coarser, const Watch& watch);
    /// The same rows with the other bound, or for a car of another size.
    Lattice(const Lattice& other, const Problem& problem, Bound bound, const Watch& watch);

    [[nodiscard]] double x(int row) const { return anchor_.x + row * (spacing_ / 2.0); }
    [[nodiscard]] double sine(int column) const { return anchor_.sine + column * sine_step_; }
    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] Enter enter() const { return enter_; }
    [[nodiscard]] const Rows& rows() const { return rows_; }

    [[nodiscard]] const SweepTerms& terms_of(Direction direction, int row) const {
        return (direction == Direction::forward ? forward_ : backward_)[row & 1];
    }
    /// Where in its terms a cell is found.
    [[nodiscard]] std::size_t term(int cell) const {
        return static_cast<std::size_t>(cell - cell_of_column(measured_.from)) + row_padding;
    }

    /// Where the car is out, or stands upright in the slot and can drive straight out.
    struct Goal {
        int row, cell;
        enum Where { front, rear, upright } where;
    };
    [[nodiscard]] const std::vector<Goal>& goals() const { return goals_; }
    /// Whether the rows reach there.
    [[nodiscard]] bool holds(int row, int column) const {
        const int i = row - rows_.first;
        if (i < 0 || i >= static_cast<int>(rows_.windows.size())) return false;
        const Window& window = rows_.windows[static_cast<std::size_t>(i)];
        return cell_of_column(column) >= window.from && cell_of_column(column) <= window.to;
    }
    /// Whether the slot may be deep enough to park at the headings next to upright that the lattice leaves out.
    [[nodiscard]] bool may_park_upright() const;
    /// Lowest free position. [m]
    [[nodiscard]] double needed(int row, int column) const { return needed_[index(row, cell_of_column(column))]; }

private:
    friend class Heights;

    void measure_body();
    void measure_columns(const Watch& watch);
    void find_rows(const Watch& watch);
    void find_rows(const Rows& coarse);
    void measure_column(int d);
    void measure_neighbours(int d, double front_wall, double rear_wall, double to_z);
    [[nodiscard]] SweepTerms terms(Direction direction, int parity) const;
    void measure_rows(const Watch& watch);
    void find_goals();
    [[nodiscard]] const Column& at(int column) const {
        const int place = column - measured_.from + 2;
        return columns_[static_cast<std::size_t>(place)];
    }
    [[nodiscard]] std::size_t index(int row, int cell) const;

    Problem problem_;
    Point front_corner_, rear_corner_;  // of the body's right side
    double farthest_ = 0.0;             // of the body's corners from the rear axle's middle [m]
    double steepest_parked_ = 1.0;      // sine of it
    Enter enter_;
    Bound bound_;
    double spacing_;
    double sine_step_;
    Anchor anchor_;
    double rounding_ = 0.0;  ///< more than a sum of two heights can be off [m]
    int first_column_ = 0;
    int last_column_ = 0;
    Window measured_;                      // columns that the rows can reach
    std::vector<Column> columns_;          // and two more at either end
    Limits limits_[2];                     // by the parity of the column
    SweepTerms forward_[2], backward_[2];  // likewise
    Rows rows_;                            // within which the car may be
    std::vector<std::size_t> begin_;       // of each row's cells
    Numbers<double> needed_;               // lowest free position of each cell
    Numbers<double> needed_backward_;      // where that is another one driving backward
    std::vector<Goal> goals_;
};

/// Highest position of the car in every cell after some moves; it changes sweep by sweep.
class Heights {
public:
    static constexpr double nowhere = -std::numeric_limits<double>::infinity();

    Heights(const Lattice& lattice, const Watch& watch);

    /// Parked anywhere.
    void start_parked();
    /// At one place, z high; nowhere if that is not free.
    void start_at(int row, int column, double z);
    /// Lets the car make one more move in the direction. Returns whether it gets out, or could at once the other way.
    bool sweep(Direction direction, const Watch& watch);

    [[nodiscard]] double at(int row, int column) const;
    /// Where the car can be.
    [[nodiscard]] const Rows& reached() const { return reached_; }
    /// Cells computed so far.
    [[nodiscard]] std::size_t updates() const { return updates_; }
    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }

private:
    /// Cells of one row; `before` are the heights in the row before, from the column to the left of the first cell on.
    void sweep_cells(int row, const Window& cells, Direction direction, const double* before);

    const Lattice* lattice_;
    Numbers<double> z_;
    std::vector<double> nothing_;
    Rows reached_;
    std::size_t updates_ = 0;
};

/// Lowest free positions of `count` cells in the row at x, the first one's limits being those at `first`. Whole vectors
/// are written: up to `row_padding` numbers more.
void measure_row(double* needed, const Limits& limits, std::size_t first, double x, std::size_t count);

/// What becomes of positions above the ceiling.
enum class Above { allowed, lowered, dropped };

/// `count` cells of a row, from the neighbouring cells in the row before: the higher of staying, coming from the left and
/// from the right, or nowhere when that is too low. Whole vectors are read: up to `row_padding` numbers more.
void sweep_row(double* row, const double* left, const double* right, const double* keep, const double* from_left,
               const double* from_right, const double* needed, Above above, const double* ceiling, std::size_t count);

}  // namespace snug::detail
