// The number of changes is piecewise constant in the entry heading, and its pieces can be arbitrarily thin. What does
// not hide is the depth D_n (full_steering.hpp): parked during move n means D_n <= 0. D_n is continuous in the heading
// as long as every move meets the same obstacles; it has a kink where two obstacles are met at once and jumps where a
// corner that grazed an obstacle begins to miss it.
//
// So the interval of headings is split, from a coarse grid downwards,
//   - at every jump, located to the last bit as the root of the grazing height (or by bisection),
//   - at every root of D_n, located the same way,
//   - wherever D_n or a grazing height falls on the left and rises on the right steeply enough to reach zero between,
// until both ends of every piece tell its whole story. A split takes one run of the strategy after the other; several pieces
// go through theirs in rounds, so that the runs of a round can be driven side by side.
#include "full_steering/heading_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "full_steering/follow.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

constexpr double least_gap = 1e-13;  ///< between the two sides of a root; beyond rounding, short of any range [rad]
constexpr std::size_t most_moves = 30'000'000;
/// Pieces under way where runs are driven in vectors: with fewer, lanes are left empty; more take memory.
constexpr std::size_t side_by_side = 16;
constexpr std::size_t room_for_moves =
    2048;  ///< at first: so much that it is not given back to the system after every search

/// What `move` met, and what else it may come to meet in a quarter turn without a jump: the car rolls from an edge onto
/// the corner at its end and back. Only the tail that swings up behind the rear corner does not roll, it flies.
unsigned same_obstacle(const FullMove& move, int quarter) {
    switch (move.meets) {
        case Meets::front_side:
        case Meets::front_corner: return bit_of(Meets::front_side) | bit_of(Meets::front_corner);
        case Meets::rear_side:
        case Meets::rear_corner:
            if (quarter == 0) return bit_of(Meets::rear_side) | bit_of(Meets::rear_corner);
            return move.quarter == 0 ? bit_of(Meets::rear_side) : bit_of(move.meets);
        case Meets::curb: return move.quarter == quarter ? bit_of(Meets::curb) : 0U;
        default: return bit_of(move.meets);
    }
}

/// Value and slope of a smooth function at one heading.
struct Sample {
    double value = 0.0;
    double slope = 0.0;
};

/// May one trust that a function that is positive at both ends of an interval stays so in between? Yes if it is far from
/// zero for how much it moves, if it plainly rises or falls, or if its tangents, made four times as steep, meet above
/// zero. (Beyond a jump slopes are infinite, so straight lines alone would not do.) With a kink between, where another
/// slope begins, the lesser value must exceed the steepest change known.
inline __attribute__((always_inline)) bool stays_positive(const Sample& left, const Sample& right, double width,
                                                          bool smooth) {
    const double change = right.value - left.value;
    const double gentle = std::min(std::abs(left.slope), std::abs(right.slope)) * width;
    const double steep = std::max(std::abs(left.slope), std::abs(right.slope)) * width;
    const double least = std::min(left.value, right.value);
    if (!smooth) {
        const double falls = std::min(left.value + 2.0 * left.slope * width, right.value - 2.0 * right.slope * width);
        return falls > 0.0 && least > steep;
    }
    if (left.slope < 0.0 && right.slope > 0.0) {
        const double fall = 4.0 * left.slope;
        const double rise = 4.0 * right.slope;
        const double meet = (change - rise * width) / (fall - rise);
        if (meet > 0.0 && meet < width) return left.value + fall * meet > 0.0;
    }
    if (least > 2.0 * (std::abs(change) + gentle)) return true;
    if (left.slope > 0.0 && right.slope < 0.0) return steep <= least;
    const double bent = std::abs(change - 0.5 * (left.slope + right.slope) * width);
    return bent <= std::max(0.25 * least, 0.05 * std::abs(change));
}

/// The same for a function that has the same sign at both ends.
inline __attribute__((always_inline)) bool keeps_sign(const Sample& left, const Sample& right, double width,
                                                      bool smooth) {
    const double sign = left.value > 0.0 ? 1.0 : -1.0;
    return stays_positive({sign * left.value, sign * left.slope}, {sign * right.value, sign * right.slope}, width,
                          smooth);
}

/// Where between two values of opposite sign the root is to be expected, from 0 to 1: the heading as a cubic of the value.
double root_between(const Sample& left, const Sample& right, double width) {
    const double change = right.value - left.value;
    const double t = -left.value / change;
    const double start = change / (left.slope * width);
    const double end = change / (right.slope * width);
    return t * (t * (3.0 - 2.0 * t + end * (t - 1.0)) + start * (1.0 - t) * (1.0 - t));
}

struct Leaf {
    double heading;
    int changes;
};
using Quantity = Sample (*)(const FullSteering&, const FullMove&, int edge);

/// A root of a quantity of move n, as far as it is known.
struct Root {
    std::size_t n = 0;
    Quantity quantity = nullptr;
    int edge = 0;             ///< of the outline, where the quantity is one of an edge
    double a = 0.0, b = 0.0;  ///< it lies between
    Sample at_a, at_b;
    bool left_is_out = false;
    double two_ago = 0.0, one_ago = 0.0;  ///< how far apart a and b were
    int steps = 0;
    bool nearly_there = false;  ///< the run asked for may be one of these two
    Run before, after;          ///< those at a and b; no moves: not driven yet
};
struct Interval {
    Run left, right;
};
enum class Asks { nothing, middle, step, sides };
/// An interval of headings, and what it has asked for to be split.
struct Piece : Interval {
    Asks asks = Asks::nothing;
    double middle = 0.0;  ///< where to split it
    std::size_t asked = 0;
    std::optional<Root> root;

    explicit Piece(const Interval& of) : Interval(of) {}
};

class Search {
public:
    Search(const FullSteering& steering, int max_changes, Find find, const Progress& progress)
        : steering_(steering),
          runs_{steering, in_vectors(steering), max_changes, find == Find::fewest},
          find_(find),
          progress_(progress) {}

    std::vector<CountedHeadings> run() {
        possible_ = possible_headings(steering_.problem, steering_.entry);
        for (const Headings& headings : possible_) search(headings);
        if (given_up_) return {};
        std::vector<CountedHeadings> ranges = constant_ranges();
        if (find_ == Find::fewest)
            std::erase_if(ranges, [this](const CountedHeadings& range) { return range.changes != runs_.limit; });
        return ranges;
    }

    [[nodiscard]] SearchWork work() const {
        return {possible_, runs_.driven, !given_up_ && runs_.driven <= most_moves};
    }

private:
    void search(const Headings& headings) {
        constexpr std::size_t cells = 48;
        runs_.moves.clear();
        runs_.moves.reserve(room_for_moves);
        asked_.clear();
        asked_.reserve(cells + 1);
        pieces_.reserve(2 * cells);
        under_way_.reserve(side_by_side);
        leaves_.reserve(4 * cells);
        for (std::size_t i = 0; i <= cells; ++i) {
            const double part = static_cast<double>(i) / cells;
            ask(headings.min + (headings.max - headings.min) * part);
            if (headings.max == headings.min) break;
        }
        drive_asked();
        const std::size_t first_leaf = leaves_.size();
        for (std::size_t i = asked_.size() - 1; i > 0; --i) pieces_.push_back({asked_[i - 1], asked_[i]});
        emit(asked_.back());
        while (!pieces_.empty() || !under_way_.empty()) round();
        std::sort(leaves_.begin() + static_cast<std::ptrdiff_t>(first_leaf), leaves_.end(),
                  [](const Leaf& a, const Leaf& b) { return a.heading < b.heading; });
        leaves_.push_back({std::numeric_limits<double>::quiet_NaN(), never});  // ranges end here
    }

    /// Takes the pieces under way one run further, and with them the next ones from the left.
    void round() {
        throw_away();
        asked_.clear();
        std::erase_if(under_way_, [this](Piece& piece) { return !ask_for(piece); });
        // Whoever wants any heading gets the first from the left; and what is driven alone is driven quicker after its like.
        const std::size_t most = runs_.vectors && find_ != Find::any ? side_by_side : 1;
        while (under_way_.size() < most && !pieces_.empty()) {
            under_way_.emplace_back(pieces_.back());
            pieces_.pop_back();
            if (!ask_for(under_way_.back())) under_way_.pop_back();
        }
        drive_asked();
        std::erase_if(under_way_, [this](Piece& piece) { return take(piece); });
    }

    void ask(double heading) { asked_.push_back({heading, runs_.limit}); }

    void drive_asked() {
        if (asked_.empty()) return;
        runs_.drive(asked_);
        for (const Run& run : asked_) found_ = found_ || run.changes != never;
    }

    /// Asks for the next run that a piece needs; false if it needs no more.
    bool ask_for(Piece& piece) {
        piece.asked = asked_.size();
        if (piece.asks == Asks::middle) {
            ask(piece.middle);
        } else if (piece.asks == Asks::step && interests(*piece.root)) {
            step_to_root(piece);
        } else {
            explore(piece);
        }
        return asked_.size() > piece.asked;
    }

    /// Takes the run that a piece has asked for; true if that splits it.
    bool take(Piece& piece) {
        const Run& first = asked_[piece.asked];
        if (piece.asks == Asks::middle) {
            pieces_.push_back({first, piece.right});
            pieces_.push_back({piece.left, first});
            return true;
        }
        Root& root = *piece.root;
        if (piece.asks == Asks::sides) {
            const Run& last = asked_[piece.asked + (root.before.count == 0 && root.after.count == 0 ? 1 : 0)];
            if (root.before.count == 0) root.before = first;
            if (root.after.count == 0) root.after = last;
            split_beside_root(piece);
            return true;
        }
        if (interests(root)) take_step(piece, first);
        return false;
    }

    /// A limit that has fallen makes the root of a later move uninteresting; its piece is looked at again.
    [[nodiscard]] bool interests(const Root& root) const { return static_cast<int>(root.n) <= runs_.limit; }

    /// Throws away the moves of runs that no piece needs, when room gets scarce.
    void throw_away() {
        if (runs_.moves.size() < runs_.moves.capacity() / 4 * 3) return;
        std::vector<Run*> needed;
        const auto need = [&](Run& run) {
            if (run.count != 0) needed.push_back(&run);
        };
        for (Interval& piece : pieces_) {
            need(piece.left);
            need(piece.right);
        }
        for (Piece& piece : under_way_) {
            need(piece.left);
            need(piece.right);
            if (!piece.root) continue;
            need(piece.root->before);
            need(piece.root->after);
        }
        std::sort(needed.begin(), needed.end(), [](const Run* a, const Run* b) { return a->first < b->first; });
        std::size_t end = 0;
        std::size_t first = std::numeric_limits<std::size_t>::max();  // of the last one moved, before
        for (Run* run : needed) {
            if (run->first != first) {
                first = run->first;
                const auto from = runs_.moves.begin() + static_cast<std::ptrdiff_t>(first);
                std::copy_n(from, run->count, runs_.moves.begin() + static_cast<std::ptrdiff_t>(end));
                end += run->count;
            }
            run->first = end - run->count;
        }
        runs_.moves.resize(end);
        if (end > runs_.moves.capacity() / 2) runs_.moves.reserve(2 * runs_.moves.capacity());
    }

    /// Is there no need, or no use, to look any closer?
    bool done(const Run& at) {
        if (progress_ && runs_.driven >= next_report_) {
            next_report_ = runs_.driven + 1'000'000;
            if (!progress_(at.heading / limits::quarter_turn)) given_up_ = true;
        }
        return given_up_ || (find_ == Find::any && found_) || runs_.driven > most_moves;
    }

    /// Move n of a run; a run that ended repeats its last two moves. (Moves without length are the limit of the shorter
    /// and shorter moves of neighbouring headings.)
    [[nodiscard]] const FullMove& move(const Run& run, std::size_t n) const {
        if (n < run.count) return runs_.moves[run.first + n];
        const bool stuck = runs_.moves[run.first + run.count - 1].stuck && run.count > 1;
        return runs_.moves[run.first + run.count - (stuck && (n - run.count) % 2 == 0 ? 2 : 1)];
    }

    static Sample depth(const FullSteering&, const FullMove& move, int = 0) { return {move.depth, move.depth_slope}; }
    static Sample first_graze(const FullSteering&, const FullMove& move, int = 0) {
        return {move.graze[0], move.y_slope};
    }
    static Sample second_graze(const FullSteering&, const FullMove& move, int = 0) {
        return {move.graze[1], move.y_slope};
    }
    static Sample tail_clears(const FullSteering& steering, const FullMove& move, int = 0) {
        const Clearings clears = clearings(steering, move);
        return {clears.tail, clears.tail_slope};
    }
    static Sample nose_clears(const FullSteering& steering, const FullMove& move, int = 0) {
        const Clearings clears = clearings(steering, move);
        return {clears.nose, clears.nose_slope};
    }
    /// A neighbour's corner, seen from the turning centre, its distance's slope with the entry heading times that distance.
    struct SeenPoint {
        double x, y, slope;
    };
    static SeenPoint front_corner(const FullSteering& steering, const FullMove& move) {
        const double y = move.y + steering.problem.front_setback;
        return {move.x, y, move.x * move.x_slope + y * move.y_slope};
    }
    static SeenPoint rear_corner(const FullSteering& steering, const FullMove& move) {
        const double x = move.x + steering.problem.length;
        const double y = move.y + steering.problem.rear_setback;
        return {x, y, x * move.x_slope + y * move.y_slope};
    }
    static const TurningEdge& edge_of(const FullSteering& steering, const FullMove& move, int edge) {
        return (move.backward ? steering.backward : steering.forward).edges[static_cast<std::size_t>(edge)];
    }

    /// How far a neighbour's corner passes the far end of an edge, and the near side of its line. [m]
    template <SeenPoint Corner(const FullSteering&, const FullMove&)>
    static Sample passes_end(const FullSteering& steering, const FullMove& move, int edge) {
        const TurningEdge& seen = edge_of(steering, move, edge);
        const SeenPoint at = Corner(steering, move);
        const double across = std::sqrt(at.x * at.x + at.y * at.y - seen.distance * seen.distance);
        return {across - (seen.to + steering.problem.touch), at.slope / across};
    }
    template <SeenPoint Corner(const FullSteering&, const FullMove&)>
    static Sample passes_line(const FullSteering& steering, const FullMove& move, int edge) {
        const double off = edge_of(steering, move, edge).distance;
        const SeenPoint at = Corner(steering, move);
        const double reach = at.x * at.x + at.y * at.y;
        const double distance = std::sqrt(reach);
        return {(reach - off * off) / (distance + std::abs(off)), at.slope / distance};
    }

    /// A corner of the body that swings up in front of the rear side rolls on along it and then along the edges above, as far
    /// as these draw away from the turning centre.
    [[nodiscard]] bool rolls_on(const FullMove& a, const FullMove& b) const {
        const FullMove& by_corner = a.meets == Meets::rear_side ? a : b;
        const FullMove& by_edge = a.meets == Meets::rear_side ? b : a;
        if (by_corner.meets != Meets::rear_side || by_edge.meets != Meets::rear_corner) return false;
        const auto count = static_cast<int>(steering_.problem.body.corners().size());
        for (int i = 0; i < count; ++i) {
            const int edge = (by_corner.part + i) % count;
            if (!(edge_of(steering_, by_edge, edge).from > 0.0)) return false;
            if (edge == by_edge.part) return true;
        }
        return false;
    }

    /// Where does a neighbour's corner that one of two moves meets, and the other does not, get past the body? At the end of
    /// the edges that draw away from the turning centre, or where they come nearest to it. True if the piece asks for it.
    bool seek_missed_corner(Piece& piece, std::size_t n, const FullMove& a, const FullMove& b) {
        for (const FullMove* met : {&a, &b}) {
            const bool front = met->meets == Meets::front_corner;
            if (!front && met->meets != Meets::rear_corner) continue;
            const auto count = static_cast<int>(steering_.problem.body.corners().size());
            const auto edge = [&](int index) { return edge_of(steering_, *met, (index + count) % count); };
            int last = met->part;
            while (last < met->part + count && edge(last + 1).from > 0.0) ++last;
            int nearest = met->part;
            while (nearest > met->part - count && edge(nearest).from > 0.0) --nearest;
            const auto seek = [&](Quantity passes, int index) {
                const int own = (index + count) % count;
                if (!(passes(steering_, a, own).value * passes(steering_, b, own).value < 0.0)) return false;
                seek_root(piece, n, passes, own);
                return true;
            };
            if (seek(front ? passes_end<front_corner> : passes_end<rear_corner>, last) ||
                seek(front ? passes_line<front_corner> : passes_line<rear_corner>, nearest))
                return true;
        }
        return false;
    }

    /// Finishes a piece, or asks for what splits it until its ends tell all.
    void explore(Piece& piece) {
        piece.asks = Asks::nothing;
        const Run& left = piece.left;
        const Run& right = piece.right;
        const double width = right.heading - left.heading;
        if (done(left)) {
            emit(left);
            emit(right);
            return;
        }
        if (width <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(right.heading, 1e-3)) {
            emit(left);
            return;
        }
        const std::size_t moves =
            std::min(static_cast<std::size_t>(runs_.limit) + 1, std::max(left.count, right.count));
        bool smooth = true;  // a kink in one move is one in all that follow
        for (std::size_t n = 0; n < moves; ++n) {
            const FullMove& a = move(left, n);
            const FullMove& b = move(right, n);
            const bool alike = a.meets == b.meets && a.quarter == b.quarter;
            smooth = smooth && alike && a.part == b.part;
            const double first = a.graze[0] * b.graze[0];  // NaN unless both moves sweep that point
            const double second = a.graze[1] * b.graze[1];
            if (first < 0.0) return seek_root(piece, n, first_graze);
            if (second < 0.0) return seek_root(piece, n, second_graze);
            if (!alike && jump_between(a, b)) {
                for (const Quantity clears : {tail_clears, nose_clears})
                    if (clears(steering_, a, 0).value * clears(steering_, b, 0).value < 0.0)
                        return seek_root(piece, n, clears);
                if (!rolls_on(a, b)) {
                    if (seek_missed_corner(piece, n, a, b)) return;
                    return split(piece, 0.5);
                }
            }
            if (alike && a.part != b.part && seek_missed_corner(piece, n, a, b))
                return;  // the tail flies on past an edge
            if (first > 0.0 && !keeps_sign(first_graze(steering_, a), first_graze(steering_, b), width, smooth))
                return split_within(piece, first_graze(steering_, a), first_graze(steering_, b), smooth);
            if (second > 0.0 && !keeps_sign(second_graze(steering_, a), second_graze(steering_, b), width, smooth))
                return split_within(piece, second_graze(steering_, a), second_graze(steering_, b), smooth);
            if ((a.depth <= 0.0) != (b.depth <= 0.0)) return seek_root(piece, n, depth);
            if (!keeps_sign(depth(steering_, a), depth(steering_, b), width, smooth))
                return split_within(piece, depth(steering_, a), depth(steering_, b), smooth);
            if (a.depth <= 0.0) break;
            const double steepest = std::max(std::abs(a.depth_slope), std::abs(b.depth_slope));
            if (!(std::abs(a.depth - b.depth) <= 4.0 * steepest * width + 1e-12 * steering_.problem.length))
                return split(piece, 0.5);  // a jump nothing else told of
        }
        emit(left);
    }

    /// Does what ends the move change between the two in any other way than by rolling on, or by one obstacle getting in
    /// the way of another? Looked at where the later of the two ends, the other's obstacle must still lie ahead.
    [[nodiscard]] static bool jump_between(const FullMove& a, const FullMove& b) {
        const FullMove& early = a.quarter < b.quarter ? a : b;
        const FullMove& late = a.quarter < b.quarter ? b : a;
        const unsigned expected = same_obstacle(early, late.quarter);
        if ((expected & bit_of(late.meets)) != 0) return false;
        if ((expected & late.ahead) == 0) return true;
        return early.quarter == late.quarter && (same_obstacle(late, early.quarter) & early.ahead) == 0;
    }

    void split(Piece& piece, double part) {
        split_later(piece, part);
        ask(piece.middle);
    }

    static void split_later(Piece& piece, double part) {
        const double left = piece.left.heading;
        const double right = piece.right.heading;
        piece.middle = left + (right - left) * part;
        if (!(piece.middle > left && piece.middle < right)) piece.middle = left + (right - left) * 0.5;
        piece.asks = Asks::middle;
    }

    /// Where the tangents meet if there may be a kink; at the lowest point of a parabola with these slopes; or else nearer
    /// to the steeper end.
    void split_within(Piece& piece, const Sample& a, const Sample& b, bool smooth) {
        double part = std::abs(a.slope) > std::abs(b.slope) ? 0.3 : 0.7;
        const double width = piece.right.heading - piece.left.heading;
        const double meet = ((b.value - a.value) / width - b.slope) / (a.slope - b.slope);
        if (!smooth && meet > 0.0 && meet < 1.0) {
            part = std::clamp(meet, 0.02, 0.98);
        } else if (a.value * a.slope < 0.0 && b.value * b.slope > 0.0 && std::isfinite(a.slope) &&
                   std::isfinite(b.slope)) {
            part = std::clamp(a.slope / (a.slope - b.slope), 0.05, 0.95);
        }
        split(piece, part);
    }

    /// Splits at the root of a quantity of move n, as close as rounding lets it be told.
    void seek_root(Piece& piece, std::size_t n, Quantity quantity, int edge = 0) {
        Root& root = piece.root.emplace();
        root.n = n;
        root.quantity = quantity;
        root.edge = edge;
        root.a = piece.left.heading;
        root.b = piece.right.heading;
        root.at_a = quantity(steering_, move(piece.left, n), edge);
        root.at_b = quantity(steering_, move(piece.right, n), edge);
        root.left_is_out = root.at_a.value > 0.0;
        root.two_ago = root.one_ago = 16.0 * (root.b - root.a);
        step_to_root(piece);
    }

    /// Newton from the better end, each step a thousandth longer so that the root comes to lie between; bisection where that
    /// does not help.
    void step_to_root(Piece& piece) {
        Root& root = *piece.root;
        const double width = root.b - root.a;
        if (root.steps == 200 || !(width > least_gap)) return ask_for_sides(piece);
        const bool from_a = std::abs(root.at_a.value) < std::abs(root.at_b.value);
        const Sample& best = from_a ? root.at_a : root.at_b;
        const double step = -best.value / best.slope;
        const double longer = step + std::copysign(std::max(1e-3 * std::abs(step), 0.4 * least_gap), step);
        double next = (from_a ? root.a : root.b) + longer;
        if (root.steps == 0) next = root.a + width * root_between(root.at_a, root.at_b, width);
        if (!(next > root.a && next < root.b) || width > 0.25 * root.two_ago) next = root.a + 0.5 * width;
        root.two_ago = root.one_ago;
        root.one_ago = width;
        ++root.steps;
        if (next <= root.a || next >= root.b) return ask_for_sides(piece);
        root.nearly_there = std::abs(step) < 1e3 * least_gap;
        piece.asks = Asks::step;
        if (root.nearly_there) {
            ask(next);
        } else {
            asked_.push_back({next, static_cast<int>(root.n), true});
        }
    }

    void take_step(Piece& piece, const Run& run) {
        Root& root = *piece.root;
        const Sample value = root.quantity(steering_, move(run, root.n), root.edge);
        const bool other_event =
            std::isnan(value.value) || (root.nearly_there && run.changes < static_cast<int>(root.n));
        if (other_event) {  // leave it to the parts
            const double left = piece.left.heading;
            return split_later(piece, (run.heading - left) / (piece.right.heading - left));
        }
        const Run kept = root.nearly_there ? run : Run();
        if ((value.value > 0.0) == root.left_is_out) {
            root.a = run.heading;
            root.at_a = value;
            root.before = kept;
        } else {
            root.b = run.heading;
            root.at_b = value;
            root.after = kept;
        }
    }

    void ask_for_sides(Piece& piece) {
        piece.asks = Asks::sides;
        if (piece.root->before.count == 0) ask(piece.root->a);
        if (piece.root->after.count == 0) ask(piece.root->b);
        if (asked_.size() == piece.asked) split_beside_root(piece);
    }

    void split_beside_root(const Piece& piece) {
        emit(piece.root->before);
        pieces_.push_back({piece.root->after, piece.right});
        pieces_.push_back({piece.left, piece.root->before});
    }

    void emit(const Run& run) { leaves_.push_back({run.heading, run.changes}); }

    [[nodiscard]] std::vector<CountedHeadings> constant_ranges() const {
        std::vector<CountedHeadings> ranges;
        bool open = false;
        for (const Leaf& leaf : leaves_) {
            if (leaf.changes == never) {
                open = false;
            } else if (open && ranges.back().changes == leaf.changes) {
                ranges.back().max = leaf.heading;
            } else {
                ranges.push_back({leaf.heading, leaf.heading, leaf.changes});
                open = true;
            }
        }
        return ranges;
    }

    const FullSteering& steering_;
    Follow runs_;  ///< last in first out
    Find find_;
    const Progress& progress_;
    bool found_ = false;     ///< some heading parks
    bool given_up_ = false;  ///< as the progress callback said
    std::size_t next_report_ = 1'000'000;
    std::vector<Headings> possible_;  ///< entry headings
    std::vector<Interval> pieces_;    ///< to be looked at, from the right to the left
    std::vector<Piece> under_way_;    ///< those that wait for a run
    std::vector<Run> asked_;          ///< by them, in this round
    std::vector<Leaf> leaves_;        ///< ends of finished pieces, in rising order
};

}  // namespace

std::vector<CountedHeadings> heading_ranges(const FullSteering& steering, int max_changes, Find find,
                                            const Progress& progress, SearchWork* work) {
    Search search(steering, max_changes, find, progress);
    std::vector<CountedHeadings> ranges = search.run();
    if (work != nullptr) *work = search.work();
    return ranges;
}

std::vector<Chain> chains(const std::vector<CountedHeadings>& ranges, int changes, double width) {
    std::vector<Chain> found;
    std::size_t first = 0;
    while (first < ranges.size()) {
        std::size_t last = first;
        if (ranges[first].changes <= changes) {
            while (last + 1 < ranges.size() && ranges[last + 1].changes <= changes &&
                   ranges[last + 1].min - ranges[last].max <= one_subrange)
                ++last;
            if (ranges[last].max - ranges[first].min >= width) found.push_back({first, last});
        }
        first = last + 1;
    }
    return found;
}

}  // namespace snug::detail
