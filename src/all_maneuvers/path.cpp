#include "all_maneuvers/path.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace snug::detail {

namespace {

bool is_out(const Heights& heights, Lattice::Goal::Where where) {
    const Lattice& lattice = heights.lattice();
    return std::any_of(lattice.goals().begin(), lattice.goals().end(), [&](const Lattice::Goal& goal) {
        return goal.where == where && heights.at(goal.row, column_of_cell(goal.row, goal.cell)) > Heights::nowhere;
    });
}

}  // namespace

std::optional<int> changes_along(const Lattice& lattice, const Start& start, int most, const Watch& watch) {
    // Moves alternate. Those that begin forward get out after an even number of changes; beginning backward can save one.
    std::optional<int> fewest;
    for (const int first : {0, 1}) {
        Heights heights(lattice, watch);
        start(heights);
        const int last = fewest ? *fewest - 1 : most;
        for (int k = 0; k <= last; ++k) {
            const bool forward = (k + first) % 2 == 0;
            const bool out = heights.sweep(forward ? Direction::forward : Direction::backward, watch);
            // Out over the rear neighbour it takes a move forward to drive away.
            if (!out || !is_out(heights, forward ? Lattice::Goal::front : Lattice::Goal::rear)) continue;
            if (const int changes = forward ? k : k + 1; changes <= last) fewest = changes;
            break;
        }
    }
    return fewest;
}

namespace {

struct Node {
    int row, column;
};

Characteristic characteristic(const Lattice& lattice, const Node& node) {
    const double x = lattice.x(node.row);
    const double across = lattice.problem().radius * lattice.sine(node.column);
    return {x - across, x + across};
}

/// The way to a node within the last of these sweeps, back to where it begins; the node becomes that place.
std::vector<Node> way_back(const Heights& before, const Heights& after, Direction direction, Node& node) {
    const Lattice& lattice = before.lattice();
    const int step = direction == Direction::forward ? 1 : -1;
    std::vector<Node> way = {node};
    int last_turn = 0;
    for (;;) {
        const double z = after.at(node.row, node.column);
        if (before.at(node.row, node.column) == z) return way;
        const int row = node.row - step;
        const SweepTerms& terms = lattice.terms_of(direction, node.row);
        const std::size_t term = lattice.term(cell_of_column(node.column));
        const bool from_left = after.at(row, node.column - 1) + terms.from_left[term] == z;
        const bool from_right = after.at(row, node.column + 1) + terms.from_right[term] == z;
        const int turn = from_left && (!from_right || last_turn <= 0) ? -1 : 1;  // rather as before
        last_turn = turn;
        node = {row, node.column + turn};
        way.push_back(node);
    }
}

/// Of all ways out there the one that clears the neighbour most, nose up if possible.
std::optional<Node> roomiest_way_out(const Heights& heights, Lattice::Goal::Where where) {
    const Lattice& lattice = heights.lattice();
    std::optional<Node> out;
    double best = Heights::nowhere;
    for (const Lattice::Goal& goal : lattice.goals()) {
        const Node node{goal.row, column_of_cell(goal.row, goal.cell)};
        const double z = heights.at(node.row, node.column);
        if (goal.where != where || z == Heights::nowhere) continue;
        const double room = z - lattice.needed(node.row, node.column) - (lattice.sine(node.column) < 0.0 ? 1e6 : 0.0);
        if (room > best) {
            best = room;
            out = node;
        }
    }
    return out;
}

/// Out over the rear neighbour: on straight back, tail up, until the car comes out level when it turns away forward.
void drive_away(const Lattice& lattice, const Node& out, double z, LatticePath& path) {
    const Problem& problem = lattice.problem();
    const double sine = lattice.sine(out.column);
    const double below = problem.radius + problem.body.right() - z;
    Characteristic at = characteristic(lattice, out);
    if (sine < 0.0 && below > 0.0) {
        const double back = (below / -sine + 1e-3 * problem.radius) * std::sqrt((1.0 - sine) * (1.0 + sine));
        at = {at.a - back, at.b - back};
        path.legs[path.legs.size() - 2].points.push_back(at);
    }
    path.legs.back().points = {at};
    at.b = std::max(at.a, at.b);
    path.legs.back().points.push_back(at);
    const double on = std::max(0.0, -at.a) + problem.length + problem.radius;
    path.legs.back().points.push_back({at.a + on, at.b + on});
}

}  // namespace

namespace {
/// To find the way back all heights are needed again, last ones first: kept are a few, the others computed again.
int moves_between_kept(int changes) { return 1 + static_cast<int>(std::sqrt(changes)); }
}  // namespace

int heights_kept(int changes) {
    const int between = moves_between_kept(changes);
    return 1 + changes / between + 1 + between + 2;
}

std::optional<LatticePath> path_along(const Lattice& lattice, const Start& start, int changes, const Watch& watch) {
    const int between = moves_between_kept(changes);
    std::vector<Heights> kept;
    Heights heights(lattice, watch);
    start(heights);
    for (int k = 0; k <= changes; ++k) {
        if (k % between == 0) kept.push_back(heights);
        heights.sweep(direction_at(k, changes), watch);
    }
    Lattice::Goal::Where where = Lattice::Goal::front;
    std::optional<Node> out = roomiest_way_out(heights, where);
    if (!out) {
        where = Lattice::Goal::rear;
        out = roomiest_way_out(heights, where);
    }
    if (!out) return std::nullopt;
    LatticePath path;
    Node node = *out;
    std::vector<Heights> levels;
    for (int k = changes; k >= 0; --k) {
        if (levels.size() < 2) {  // those from the last one kept up to this
            const int first = k / between * between;
            levels = {std::move(kept.back())};
            kept.pop_back();
            for (int level = first; level <= k; ++level) {
                levels.push_back(levels.back());
                levels.back().sweep(direction_at(level, changes), watch);
            }
        }
        const Heights after = std::move(levels.back());
        levels.pop_back();
        LatticePath::Leg leg;
        leg.direction = direction_at(k, changes);
        for (const Node& at : way_back(levels.back(), after, leg.direction, node))
            leg.points.push_back(characteristic(lattice, at));
        std::reverse(leg.points.begin(), leg.points.end());
        path.legs.push_back(std::move(leg));
        if (k == 0) path.z = levels.back().at(node.row, node.column);
    }
    std::reverse(path.legs.begin(), path.legs.end());
    if (lattice.enter() == Enter::forward)
        for (std::size_t i = 0; i + 1 < path.legs.size(); ++i) path.legs[i].nose_in = true;
    if (where == Lattice::Goal::rear) drive_away(lattice, *out, heights.at(out->row, out->column), path);
    return path;
}

}  // namespace snug::detail
