#include "all_maneuvers/search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "contact/entering.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

constexpr double usual_part = 1e-4;  ///< of the car's length: the usual resolution
constexpr double coarsest_part = 1.0 / 128;
constexpr double least_in_radius = 64.0;   ///< spacings in a turning radius (see steepest_sine)
constexpr int most_at_hand = 40;           ///< changes
constexpr double well_known = 1.0 / 1000;  ///< of the car's length: the next lattice shows what the finest takes
constexpr double most_memory = 1.8e9;      ///< [bytes]

/// What both lattices take, and with them so many copies of the heights. [bytes]
double memory_of(const LeavingQuestion& question, double cells, int heights) {
    const int lattices = question.ground.driving.enter == Enter::forward ? 4 : 2;
    return cells * static_cast<double>(sizeof(double)) * (lattices + heights);
}

/// A chain of sweeps whose last one, after `last` changes, goes forward.
struct Chain {
    std::optional<int> out;  ///< changes after which the car got out first
    Rows reached;            ///< within so many changes
};

Chain run_chain(const Lattice& lattice, const LeavingQuestion& question, int last, bool on_when_out,
                const Watch& watch) {
    Chain chain;
    if (lattice.may_park_upright()) chain.out = 0;
    Heights heights(lattice, watch);
    question.start(heights);
    for (int k = 0; k <= last; ++k) {
        const Direction direction = direction_at(k, last);
        if (heights.sweep(direction, watch) && !chain.out) {
            chain.out = direction == Direction::forward ? k : k + 1;
            if (!on_when_out) break;
        }
    }
    chain.reached = heights.reached();
    return chain;
}

double coarsest_sensible(const LeavingQuestion& question) {
    return detail::coarsest_sensible(question.ground.problem, question.ground.car);
}

double finest(const LeavingQuestion& question) {
    const double usual =
        std::min(usual_part * question.ground.car.length(), question.ground.problem.radius / least_in_radius);
    return question.resolution > 0.0 ? std::min(question.resolution, coarsest_sensible(question)) : usual;
}

/// The finest times a power of two.
double coarsest(const LeavingQuestion& question) {
    double spacing = finest(question);
    while (2.0 * spacing <= coarsest_sensible(question)) spacing *= 2.0;
    return spacing;
}

/// Whether even the coarsest lattice takes too much memory, as in slots thousands of times as long as the car.
bool too_large(const LeavingQuestion& question) {
    const Problem& problem = question.ground.problem;
    return memory_of(question, Lattice::most_cells(problem, coarsest(question)), 2) > most_memory;
}

/// Bounds on lattices from the coarsest to the finest, as far as `depth` changes; false when that is not enough.
bool narrow_to(const LeavingQuestion& question, int depth, LeavingBounds& bounds, const Watch& watch) {
    std::optional<Rows> reached;
    if (too_large(question)) return true;
    for (double spacing = coarsest(question); spacing > 0.999 * finest(question); spacing /= 2.0) {
        const int last = bounds.upper ? *bounds.upper - 1 : depth;
        if (last < bounds.lower) return bounds.upper || depth == question.max_changes;
        if (reached && spacing <= well_known * question.ground.car.length()) {
            const double finer = spacing / finest(question);
            const double memory = memory_of(question, 4.0 * static_cast<double>(reached->cells()), 2);
            if (question.resolution > 0.0 && memory * finer * finer > most_memory)
                throw Error("resolution is " + spelled(question.resolution) + " m, but the lattice for that takes " +
                            spelled(std::ceil(memory * finer * finer / 1e9)) + " GB of memory; it must be at least " +
                            spelled(question.resolution * std::sqrt(memory * finer * finer / most_memory)) + " m");
            if (memory > most_memory) return true;
        }
        const Lattice lower(question.ground.problem, question.ground.driving.enter, Bound::lower, spacing,
                            question.anchor, reached ? &*reached : nullptr, watch);
        Chain chain = run_chain(lower, question, last, true, watch);
        bounds.spacing = spacing;
        const int none_below = chain.out ? *chain.out - 1 : last + 1;
        bounds.lower = std::max(bounds.lower, none_below);
        if (chain.out && bounds.lower == none_below) {
            // Beginning the other way may save a change.
            if (none_below < 0 || !run_chain(lower, question, none_below, false, watch).out) bounds.lower = *chain.out;
        }
        reached = std::move(chain.reached);
        if (bounds.meet()) return true;
        if (!chain.out && !bounds.upper) return depth == question.max_changes;

        const Lattice upper(lower, question.ground.problem, Bound::upper, watch);
        const std::optional<int> changes = changes_along(upper, question.start, last, watch);
        const double cells = static_cast<double>(upper.rows().cells());
        for (int k = changes.value_or(last + 1); k <= std::min(last, changes.value_or(0) + 1); ++k) {
            if (memory_of(question, cells, heights_kept(k)) > most_memory) break;
            const std::optional<LatticePath> path = path_along(upper, question.start, k, watch);
            std::vector<Move> moves;
            if (path) moves = leaving_moves(question.ground, *path, Finish::checked, watch);
            if (moves.empty()) continue;
            bounds.path = path;
            bounds.moves = std::move(moves);
            bounds.upper = Maneuver{question.ground.car, bounds.moves}.direction_changes();
            break;
        }
        if (bounds.meet() || (question.any_upper_will_do && !bounds.moves.empty())) return true;
    }
    return true;
}

}  // namespace

double coarsest_sensible(const Problem& problem, const Car& car) {
    return std::min(coarsest_part * car.length(), problem.radius / least_in_radius);
}

std::vector<Move> moves_at_hand(const LeavingQuestion& question, const Watch& watch) {
    if (too_large(question)) return {};
    const Problem& problem = question.ground.problem;
    const double spacing = problem.radius / least_in_radius;
    const Lattice upper(problem, question.ground.driving.enter, Bound::upper, spacing, question.anchor, nullptr, watch);
    const int most = std::min(question.max_changes, most_at_hand);
    const std::optional<int> fewest = changes_along(upper, question.start, most, watch);
    for (int k = fewest.value_or(most + 1); k <= std::min(most, fewest.value_or(0) + 2); ++k) {
        const std::optional<LatticePath> path = path_along(upper, question.start, k, watch);
        std::vector<Move> moves;
        if (path) moves = leaving_moves(question.ground, *path, Finish::checked, watch);
        if (!moves.empty()) return moves;
    }
    return {};
}

void fall_back_on(std::vector<Move> at_hand, const Car& car, LeavingBounds& bounds) {
    if (at_hand.empty()) return;
    const int changes = Maneuver{car, at_hand}.direction_changes();
    if (bounds.upper && *bounds.upper <= changes) return;
    bounds.upper = changes;
    bounds.moves = std::move(at_hand);
}

int sensible_depth(const LeavingQuestion& question, const Watch& watch) {
    if (too_large(question)) return question.max_changes;
    const Lattice lower(question.ground.problem, question.ground.driving.enter, Bound::lower, coarsest(question),
                        question.anchor, nullptr, watch);
    const std::optional<int> guess = run_chain(lower, question, question.max_changes, false, watch).out;
    return guess ? std::min(question.max_changes, 2 * *guess + 10) : question.max_changes;
}

void narrow(const LeavingQuestion& question, int depth, LeavingBounds& bounds, const Watch& watch) {
    while (!narrow_to(question, depth, bounds, watch)) depth = std::min(question.max_changes, 2 * depth + 10);
}

namespace {

/// The roomiest way out with as many changes as the bounds; none if the lattices find none. They are no finer than a part of
/// the car's length, and distances are halved so many times.
std::vector<Move> roomiest_moves(const LeavingQuestion& question, const LeavingBounds& bounds, double finest_part,
                                 int halvings, const Watch& watch) {
    const int changes = *bounds.upper;
    const Car& car = question.ground.car;
    const auto keeping = [&](double distance) {
        Problem problem = question.ground.problem;
        problem.body = problem.body.grown(distance);
        problem.at_curb = problem.at_curb.grown(distance);
        return problem;
    };
    std::optional<Rows> reached;
    if (too_large(question)) return {};
    double spacing = coarsest(question);
    for (; spacing > std::max(0.999 * finest(question), finest_part * car.length()); spacing /= 2.0) {
        const Lattice lower(question.ground.problem, question.ground.driving.enter, Bound::lower, spacing,
                            question.anchor, reached ? &*reached : nullptr, watch);
        Chain chain = run_chain(lower, question, changes, true, watch);
        if (!chain.out) return {};
        reached = std::move(chain.reached);
        if (spacing > 1e-3 * car.length()) continue;
        // The greatest distance with which the car still gets out.
        double kept = 0.0;
        double too_much = 0.5 * std::max(0.0, question.ground.slot.length() - car.length());
        std::optional<LatticePath> best;
        const auto try_keeping = [&](double distance) {
            const Lattice upper(lower, keeping(distance), Bound::upper, watch);
            std::optional<LatticePath> path = path_along(upper, question.start, changes, watch);
            if (!path) return false;
            best = std::move(path);
            return true;
        };
        if (!try_keeping(kept)) continue;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (kept + too_much) / 2.0;
            (try_keeping(middle) ? kept : too_much) = middle;
        }
        std::vector<Move> moves = leaving_moves(question.ground, *best, question.finish, watch);
        if (!moves.empty()) return moves;
    }
    return {};
}

/// The same question where only those cars count as parked that stand at most so far off parallel [rad], at most so far from the
/// curb and at least so far from both neighbours [m].
LeavingQuestion parked_well(const LeavingQuestion& question, double heading, double curb, double apart) {
    LeavingQuestion better = question;
    Problem& problem = better.ground.problem;
    problem.parked.heading = std::min(problem.parked.heading, heading);
    problem.parked.curb = std::min(problem.parked.curb, curb);
    if (!(apart > 0.0)) return better;
    // Everything the frame covers while it is moved along the slot by so much either way: the corners behind the highest and
    // the lowest one move back, those ahead forward, and these two both ways.
    const std::vector<Point>& corners = problem.frame.corners();
    std::vector<Point> longer;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& at = corners[i];
        const double before = at.y - corners[(i + corners.size() - 1) % corners.size()].y;
        const double after = corners[(i + 1) % corners.size()].y - at.y;
        // Counter-clockwise the front goes up.
        if (before > 0.0 || after > 0.0) longer.push_back({at.x + apart, at.y});
        if (before < 0.0 || after < 0.0) longer.push_back({at.x - apart, at.y});
        if (before < 0.0 && after > 0.0) std::swap(longer[longer.size() - 2], longer.back());
    }
    problem.frame = Outline(longer);
    return better;
}

/// A good way out of a place where the car stands well: parallel, then near the curb, then in the middle between the neighbours;
/// none if the lattices find none with as many changes.
std::vector<Move> well_parked_moves(const LeavingQuestion& question, const LeavingBounds& bounds, const Watch& watch,
                                    const std::function<bool(const std::vector<Move>&)>& good) {
    constexpr double coarse = 6e-4;  // of the car's length
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    const double half = 0.5 * std::max(0.0, question.ground.slot.length() - question.ground.car.length());
    for (const double heading : {1e-3, 0.05}) {
        for (const double curb : {0.15, anywhere}) {
            std::vector<Move> moves =
                roomiest_moves(parked_well(question, heading, curb, 0.0), bounds, coarse, 0, watch);
            if (moves.empty()) continue;  // the least that is asked
            for (const double part : {0.8, 0.4, 0.15}) {
                std::vector<Move> apart =
                    roomiest_moves(parked_well(question, heading, curb, part * half), bounds, coarse, 4, watch);
                if (good(apart)) return apart;
            }
            if (good(moves)) return moves;
        }
    }
    return {};
}

}  // namespace

void make_drivable(const LeavingQuestion& question, LeavingBounds& bounds, bool roomiest, const Watch& watch) {
    if (!bounds.upper) return;
    const auto good = [&](const std::vector<Move>& moves) {
        return !moves.empty() && (question.finish != Finish::at_p || ends_at_p(question.ground, moves));
    };
    std::vector<Move> best;
    if (roomiest && question.finish == Finish::at_p) best = well_parked_moves(question, bounds, watch, good);
    if (roomiest && !good(best)) best = roomiest_moves(question, bounds, 2e-4, 7, watch);
    if (!good(best) && bounds.path) {
        std::vector<Move> plain = leaving_moves(question.ground, *bounds.path, question.finish, watch);
        if (best.empty() || good(plain)) best = std::move(plain);
    }
    // Without a path the paper's strategy has a maneuver that is good.
    if (best.empty() || (!bounds.path && !good(best))) return;
    bounds.moves = std::move(best);
}

void check(const FewestOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check(options.driving);
    check(options.parked);
    check_between("resolution", options.resolution, 0.0, limits::longest, " m");
    check_between("time limit", options.time_limit, 0.0, std::numeric_limits<double>::infinity(), " s");
}

Watch watch_of(const FewestOptions& options, const LeavingBounds& bounds, double times) {
    using Clock = std::chrono::steady_clock;
    return [&options, &bounds, times, begin = Clock::now()] {
        const double part = std::chrono::duration<double>(Clock::now() - begin).count() / options.time_limit;
        if (part > times) throw GivenUp{};
        if (options.progress && !options.progress({bounds.lower, bounds.upper, bounds.spacing, std::min(part, 1.0)}))
            throw GivenUp{};
    };
}

Answer impossible(int max_changes) {
    Answer answer;
    answer.lower_bound = max_changes + 1;
    answer.proved = true;
    return answer;
}

Answer answer_of(const LeavingQuestion& question, LeavingBounds bounds, const Car& car, const Slot& slot,
                 bool driven_in) {
    Answer answer;
    answer.direction_changes = bounds.upper;
    answer.lower_bound = bounds.lower;
    answer.proved = bounds.meet() || bounds.lower > question.max_changes;
    answer.spacing = bounds.spacing;
    if (bounds.moves.empty()) return answer;
    const Enter enter = question.ground.driving.enter;
    std::vector<Move> moves =
        with_contacts(question.ground, driven_in ? turned_round(bounds.moves) : std::move(bounds.moves));
    for (Move& move : moves) {
        move.direction = entering_direction(enter, move.direction);
        move.steering_angle = slot.mirrored(move.steering_angle);
        move.start = to_world(slot, enter, move.start);
        move.end = to_world(slot, enter, move.end);
        if (move.contact) move.contact = to_world(car, slot, enter, *move.contact);
    }
    answer.maneuver = Maneuver{car, std::move(moves)};
    return answer;
}

}  // namespace snug::detail
