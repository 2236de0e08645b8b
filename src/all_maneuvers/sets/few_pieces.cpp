#include "all_maneuvers/sets/few_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "all_maneuvers/sets/route.hpp"
#include "contact/few.hpp"
#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr double full_turn = 6.283185307179586;

double turned_left(double angle) {
    const double left_over = std::remainder(angle, full_turn);
    return left_over < 0.0 ? left_over + full_turn : left_over;
}

/// At most three.
struct Pieces {
    std::array<Path, 3> all;
    std::size_t count = 0;

    [[nodiscard]] std::size_t size() const { return count; }
    [[nodiscard]] bool empty() const { return count == 0; }
    [[nodiscard]] const Path* begin() const { return all.data(); }
    [[nodiscard]] const Path* end() const { return all.data() + count; }
    [[nodiscard]] const Path& back() const { return all[count - 1]; }
    void push_back(const Path& piece) { all[count++] = piece; }
};
using Ways = Few<Pieces, 4>;

/// Ways of an arc, a straight line and an arc from one pose to another, driven forward or backward (Dubins 1957), the
/// shortest first.
Ways ways_between(const Pose& from, const Pose& to, double way, double radius) {
    // Backward is forward for a car that looks the other way: left stays left of the car, but turns the other way round.
    const auto [s, c] = angles::sine_cosine(from.heading);
    const double dx = (to.x - from.x) * way, dy = to.y - from.y;
    const double ahead = (dx * c * 1.0 + way * dy * s) / radius;
    const double aside = ((to.y - from.y) * c - (to.x - from.x) * s) / radius;
    const double turn = way * (to.heading - from.heading);
    // Now as if forward from the origin along x, with radius 1; mirrored in x the sense of left is kept.
    struct Found {
        double first, middle, last, first_sense, last_sense;
    };
    Few<Found, 4> found;
    for (const double one : {1.0, -1.0}) {
        for (const double other : {1.0, -1.0}) {
            // Centres at (0, one) and where the last arc has its own.
            const auto [ts, tc] = angles::sine_cosine(turn);
            const double x = ahead - other * ts, y = aside + other * tc - one;
            const double apart = angles::hypot(x, y);
            double middle = apart, heading = angles::atan2(y, x);
            if (one != other) {
                if (apart < 2.0) continue;
                middle = std::sqrt((apart - 2.0) * (apart + 2.0));
                heading += one * angles::atan2(2.0, middle);
            } else if (apart < 1e-12) {
                heading = turn;
            }
            const double first = turned_left(one * heading), last = turned_left(other * (turn - heading));
            found.push_back(
                {first < full_turn - 1e-9 ? first : 0.0, middle, last < full_turn - 1e-9 ? last : 0.0, one, other});
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.first + a.middle + a.last < b.first + b.middle + b.last; });
    Ways ways;
    for (const Found& of : found) {
        if (of.first > 2.5 || of.last > 2.5) continue;
        Pieces pieces;
        Pose at = from;
        const auto add = [&](double curvature, double length) {
            if (!(length > 1e-9)) return;
            pieces.push_back({at, curvature, way, length});
            at = pieces.back().at(length);
        };
        add(of.first_sense / radius, of.first * radius);
        add(0.0, of.middle * radius);
        add(of.last_sense / radius, of.last * radius);
        const double off = std::abs(at.x - to.x) + std::abs(at.y - to.y) + std::abs(at.heading - to.heading);
        if (off < 1e-7 && !pieces.empty()) ways.push_back(pieces);
    }
    return ways;
}

/// An arc, wider than the tightest, and a straight line, in either order: the widest arc that does. Empty where the two poses do
/// not face each other so.
std::vector<Path> arc_and_line(const Pose& from, const Pose& to, double way, double radius) {
    const double turned = to.heading - from.heading;
    if (std::abs(turned) < 1e-3 || std::abs(turned) > 2.5) return {};
    const auto [s, c] = angles::sine_cosine(from.heading);
    const auto [s2, c2] = angles::sine_cosine(to.heading);
    // Where the lines through both poses cross: so far ahead of one and behind the other.
    const double x = way * (to.x - from.x), y = way * (to.y - from.y);
    const double cross = c * s2 - s * c2;
    const double before = (x * s2 - y * c2) / cross, after = (y * c - x * s) / cross;
    const double tangent = std::min(before, after);
    if (!(tangent > 1e-3)) return {};
    const double half = turned / 2.0;
    const double curvature = way * angles::sin(half) / angles::cos(half) / tangent;
    if (std::abs(curvature) * radius > 1.0) return {};
    std::vector<Path> pieces;
    Pose at = from;
    const auto add = [&](double bend, double length) {
        if (!(length > 1e-9)) return;
        pieces.push_back({at, bend, way, length});
        at = pieces.back().at(length);
    };
    add(0.0, before - tangent);
    add(curvature, std::abs(turned / curvature));
    add(0.0, after - tangent);
    const double off = std::abs(at.x - to.x) + std::abs(at.y - to.y) + std::abs(at.heading - to.heading);
    return off < 1e-7 ? pieces : std::vector<Path>{};
}

/// Two arcs, no tighter than the tightest, whose common tangent is as far from either pose. Empty where there are none.
std::vector<Path> two_arcs(const Pose& from, const Pose& to, double way, double radius) {
    const auto direction = [&](double heading) {
        const auto [s, c] = angles::sine_cosine(heading);
        return Point{way * c, way * s};
    };
    const Point one = direction(from.heading), two = direction(to.heading);
    const Point across = {to.x - from.x, to.y - from.y};
    const double square = across.x * across.x + across.y * across.y;
    const double along = across.x * (one.x + two.x) + across.y * (one.y + two.y);
    const double apart = 2.0 * (1.0 - (one.x * two.x + one.y * two.y));
    if (!(square > 1e-4 && along > 0.0)) return {};
    // Both tangents are so long: apart tangent^2 + 2 along tangent = square.
    const double tangent = square / (along + std::sqrt(along * along + apart * square));
    const Point middle = {(from.x + to.x + tangent * (one.x - two.x)) / 2.0,
                          (from.y + to.y + tangent * (one.y - two.y)) / 2.0};
    std::vector<Path> pieces;
    Pose at = from;
    for (const Point& end : {middle, Point{to.x, to.y}}) {
        const Point tangent_here = direction(at.heading);
        const double x = end.x - at.x, y = end.y - at.y;
        const double chord = angles::hypot(x, y);
        const double sine = (tangent_here.x * y - tangent_here.y * x) / chord;  // of half of what it turns
        const double bend = 2.0 * sine / chord;
        if (!(tangent_here.x * x + tangent_here.y * y > 0.0) || std::abs(bend) * radius > 1.0 || std::abs(bend) < 1e-4)
            return {};
        pieces.push_back({at, way * bend, way, 2.0 * std::abs(angles::asin(sine) / bend)});
        at = pieces.back().at(pieces.back().length);
    }
    const double off = std::abs(at.x - to.x) + std::abs(at.y - to.y) + std::abs(at.heading - to.heading);
    return off < 1e-7 ? pieces : std::vector<Path>{};
}

template <class Some>
bool stays_in_chart(const Some& way) {
    for (const Path& piece : way)
        if (std::abs(angles::sin(piece.at(piece.length).heading)) > steepest_sine ||
            std::abs(piece.at(piece.length).heading) > full_turn / 4.0)
            return false;
    return true;
}

}  // namespace

std::vector<std::vector<Path>> shortest_ways(const Pose& from, const Pose& to, double way, double radius) {
    std::vector<std::vector<Path>> all;
    for (const Pieces& pieces : ways_between(from, to, way, radius)) all.emplace_back(pieces.begin(), pieces.end());
    return all;
}

std::vector<Path> with_few_pieces(const ChartPlace& place, const std::vector<Path>& way) {
    std::vector<Path> few;
    with_few_pieces(place, way, few);
    return few;
}

void with_few_pieces(const ChartPlace& place, const std::vector<Path>& way, std::vector<Path>& few) {
    few.clear();
    for (std::size_t begin = 0; begin < way.size();) {
        std::size_t end = begin;
        while (end < way.size() && way[end].way == way[begin].way) ++end;
        // Poses 0 to n of this move; a stretch from one to another is replaced if that meets nothing.
        const Path* const move = way.data() + begin;
        const std::size_t n = end - begin;
        const auto pose = [&](std::size_t i) { return i < n ? move[i].start : move[n - 1].at(move[n - 1].length); };
        Pose at = pose(0);
        const auto shortcut = [&](std::size_t to) {
            for (const Pieces& pieces : ways_between(at, pose(to), way[begin].way, place.radius)) {
                if (!stays_in_chart(pieces)) continue;
                if (std::all_of(pieces.begin(), pieces.end(), [&](const Path& piece) { return is_free(place, piece); }))
                    return pieces;
            }
            return Pieces{};
        };
        for (std::size_t i = 0; i < n;) {
            Pieces best;
            std::size_t reached = i;
            // The whole rest, or else as far as doubling and then halving of the step leads.
            std::size_t step = n - i;
            best = shortcut(n);
            if (!best.empty()) {
                reached = n;
            } else {
                for (step = 1; i + step < n; step *= 2) {
                    const Pieces pieces = shortcut(i + step);
                    if (pieces.empty()) break;
                    best = pieces;
                    reached = i + step;
                }
                for (; step > 0; step /= 2) {
                    if (reached + step >= n) continue;
                    const Pieces pieces = shortcut(reached + step);
                    if (pieces.empty()) continue;
                    best = pieces;
                    reached += step;
                }
            }
            if (best.empty()) {  // as it was
                best.push_back(move[i]);
                best.all[0].start = at;
                reached = i + 1;
            }
            for (Path piece : best) {
                piece.start = at;
                if (!few.empty() && few.back().way == piece.way && few.back().curvature == piece.curvature) {
                    few.back().length += piece.length;
                } else {
                    few.push_back(piece);
                }
                at = few.back().at(few.back().length);
            }
            i = reached;
        }
        begin = end;
    }
}

namespace {

constexpr double worth_a_piece = 0.8;  ///< of length [m]
constexpr double worth_holding = 0.3;  ///< the wheel between straight and full [m]
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t most_joints = 24;  ///< of a move that are looked at

Pose end_of(const std::vector<Path>& pieces) { return pieces.back().at(pieces.back().length); }

/// The pieces of one move and where it can be joined: at every piece's start, in its middle where it is long, and at the end.
struct Joints {
    std::vector<Pose> poses;
    std::vector<double> rest;             ///< the least trouble from there to the end of the move
    std::vector<std::vector<Path>> next;  ///< the way from there to the joint `to`
    std::vector<std::size_t> to;

    /// Everything from a joint on.
    [[nodiscard]] std::vector<Path> from(std::size_t i) const {
        std::vector<Path> all;
        for (; i + 1 < poses.size(); i = to[i]) all.insert(all.end(), next[i].begin(), next[i].end());
        return all;
    }
};

/// All short ways between two poses.
std::vector<std::vector<Path>> ways_to_join(const Pose& from, const Pose& to, double way, double radius) {
    std::vector<std::vector<Path>> ways;
    for (const Pieces& pieces : ways_between(from, to, way, radius)) ways.emplace_back(pieces.begin(), pieces.end());
    std::vector<Path> wide = arc_and_line(from, to, way, radius);
    if (!wide.empty()) ways.push_back(std::move(wide));
    wide = two_arcs(from, to, way, radius);
    if (!wide.empty()) ways.push_back(std::move(wide));
    return ways;
}

bool all_free(const ChartPlace& place, const std::vector<Path>& pieces) {
    return stays_in_chart(pieces) &&
           std::all_of(pieces.begin(), pieces.end(), [&](const Path& piece) { return is_free(place, piece); });
}

/// The least trouble between the joints of a move, each stretch an arc, a line and an arc.
Joints joints_of(const ChartPlace& place, const std::vector<Path>& move) {
    std::vector<Path> cut;  // long pieces in two
    for (const Path& piece : move) {
        cut.push_back(piece);
        if (move.size() > most_joints / 2 || piece.length < 0.5) continue;
        cut.back().length /= 2.0;
        cut.push_back(cut.back());
        cut.back().start = piece.at(piece.length / 2.0);
    }
    Joints joints;
    // Where the pieces are many, some of their ends are left out.
    const std::size_t step = cut.size() / most_joints + 1;
    for (std::size_t i = 0; i < cut.size(); i += step) joints.poses.push_back(cut[i].start);
    joints.poses.push_back(end_of(cut));
    const std::size_t n = joints.poses.size();
    joints.rest.assign(n, infinity);
    joints.next.resize(n);
    joints.to.assign(n, 0);
    joints.rest[n - 1] = 0.0;
    for (std::size_t i = n - 1; i-- > 0;) {
        for (std::size_t k = i * step; k < std::min((i + 1) * step, cut.size()); ++k)
            joints.next[i].push_back(cut[k]);  // as it was
        joints.to[i] = i + 1;
        joints.rest[i] = trouble(joints.next[i], place.radius) + joints.rest[i + 1];
        for (std::size_t j = i + 1; j < n; ++j) {
            for (const Pieces& few : ways_between(joints.poses[i], joints.poses[j], move[0].way, place.radius)) {
                std::vector<Path> pieces(few.begin(), few.end());
                const double costs = trouble(pieces, place.radius) + joints.rest[j];
                if (costs >= joints.rest[i] || !all_free(place, pieces)) continue;
                joints.rest[i] = costs;
                joints.next[i] = std::move(pieces);
                joints.to[i] = j;
            }
        }
    }
    return joints;
}

/// Short ways to begin a move: one piece, or two, of several lengths up to some more than it had.
std::vector<std::vector<Path>> beginnings(const Pose& from, double way, double radius, double length) {
    std::vector<std::vector<Path>> all;
    const double steering[] = {0.0, 1.0 / radius, -1.0 / radius};
    constexpr int steps = 12;
    const double step = 1.5 * length / steps;
    for (const double curvature : steering) {
        for (int i = 1; i <= steps; ++i) {
            const Path one = {from, curvature, way, i * step};
            all.push_back({one});
            if (i % 2 != 0) continue;
            for (const double other : steering) {
                if (other == curvature) continue;
                for (int k = 2; i + k <= steps; k += 2)
                    all.push_back({one, {one.at(one.length), other, way, k * step}});
            }
        }
    }
    return all;
}

/// The move with its last two pieces shorter and longer.
std::vector<std::vector<Path>> variations(const std::vector<Path>& move) {
    constexpr double parts[] = {0.6, 0.8, 0.9, 0.95, 0.98, 1.0, 1.02, 1.05, 1.1, 1.2, 1.4};
    std::vector<std::vector<Path>> all;
    const std::size_t last = move.size() - 1;
    for (const double part : parts) {
        std::vector<Path> varied = move;
        if (last > 0) {
            varied[last - 1].length *= part;
            varied[last].start = varied[last - 1].at(varied[last - 1].length);
        }
        for (const double part_of_last : parts) {
            varied[last].length = move[last].length * part_of_last;
            all.push_back(varied);
        }
        if (last == 0) break;
    }
    return all;
}

/// A move and the one after it with less trouble, if there are such; what they end at stays.
bool improve(const ChartPlace& place, std::vector<Path>& move, std::vector<Path>& after) {
    const Joints joints = joints_of(place, after);
    double length = 0.0;
    for (const Path& piece : move) length += piece.length;
    double least = trouble(move, place.radius) + trouble(after, place.radius) - 1e-6;
    std::optional<std::vector<Path>> begin;
    std::vector<Path> join;
    std::size_t joint = 0;
    const auto try_from = [&](const std::vector<Path>& beginning) {
        const double costs = trouble(beginning, place.radius);
        if (costs >= least) return;
        const Pose there = end_of(beginning);
        int checked = -1;  // whether the beginning is free: only looked at when it matters
        for (std::size_t j = joints.poses.size(); j-- > 0;) {
            if (costs + joints.rest[j] >= least) continue;
            for (std::vector<Path>& pieces : ways_to_join(there, joints.poses[j], after[0].way, place.radius)) {
                const double all = costs + trouble(pieces, place.radius) + joints.rest[j];
                if (all >= least) continue;
                if (checked < 0) checked = all_free(place, beginning) ? 1 : 0;
                if (checked == 0) return;
                if (!all_free(place, pieces)) continue;
                least = all;
                begin = beginning;
                join = std::move(pieces);
                joint = j;
            }
        }
    };
    for (const std::vector<Path>& varied : variations(move)) try_from(varied);
    for (const std::vector<Path>& beginning : beginnings(move[0].start, move[0].way, place.radius, length))
        try_from(beginning);
    if (!begin) return false;
    move = *begin;
    const std::vector<Path> rest = joints.from(joint);
    after = std::move(join);
    after.insert(after.end(), rest.begin(), rest.end());
    return true;
}

/// The last move with less trouble, if there is such to a place nearby where the car is parked as straight. A place that is
/// farther off the one that was chosen is some trouble, too.
bool improve_end(const ChartPlace& place, std::vector<Path>& move) {
    constexpr double minds_along = 0.5, minds_across = 4.0;
    const Pose goal = end_of(move);
    const auto [s, c] = angles::sine_cosine(goal.heading);
    double least = trouble(move, place.radius) - 1e-6;
    std::vector<Path> best;
    double before = 0.0;
    for (std::size_t k = 0; k < move.size();
         before = trouble({move.begin(), move.begin() + static_cast<std::ptrdiff_t>(++k)}, place.radius)) {
        for (const double along : {0.0, -0.1, 0.1, -0.3, 0.3, -0.6, 0.6}) {
            for (const double across : {0.0, -0.02, 0.02, -0.05, 0.05, -0.1, 0.1, -0.2, 0.2}) {
                const double costs = before + minds_along * std::abs(along) + minds_across * std::abs(across);
                const Pose end = {goal.x + along * c - across * s, goal.y + along * s + across * c, goal.heading};
                if (costs >= least || !is_parked(place, end)) continue;
                for (const std::vector<Path>& pieces : ways_to_join(move[k].start, end, move[0].way, place.radius)) {
                    if (costs + trouble(pieces, place.radius) >= least || !all_free(place, pieces)) continue;
                    least = costs + trouble(pieces, place.radius);
                    best.assign(move.begin(), move.begin() + static_cast<std::ptrdiff_t>(k));
                    best.insert(best.end(), pieces.begin(), pieces.end());
                }
            }
        }
    }
    if (best.empty()) return false;
    move = std::move(best);
    return true;
}

/// Each piece begins where the one before it ends; those of one steering are one.
std::vector<Path> chained(const Pose& start, const std::vector<std::vector<Path>>& moves) {
    std::vector<Path> way;
    Pose at = start;
    for (const std::vector<Path>& move : moves) {
        for (Path piece : move) {
            if (!(piece.length > 1e-9)) continue;
            piece.start = at;
            if (!way.empty() && way.back().way == piece.way && way.back().curvature == piece.curvature) {
                way.back().length += piece.length;
            } else {
                way.push_back(piece);
            }
            at = end_of(way);
        }
    }
    return way;
}

/// Leaves out a last touch of the wheel that nobody would notice.
void drop_last_touch(const ChartPlace& place, const Pose& start, std::vector<std::vector<Path>>& moves) {
    constexpr double touch = 0.1, turns = 0.005;  // [m] and [rad]
    std::vector<Path>& last = moves.back();
    const double length = last.back().length;
    if (last.size() < 2 || length > touch || length * std::abs(last.back().curvature) > turns) return;
    const Path dropped = last.back();
    last.pop_back();
    if (!is_parked(place, end_of(chained(start, moves)))) last.push_back(dropped);
}

}  // namespace

double trouble(const std::vector<Path>& way, double radius) {
    double sum = 0.0;
    for (const Path& piece : way) {
        sum += piece.length + worth_a_piece;
        const double bend = std::abs(piece.curvature) * radius;
        if (bend > 0.0 && bend < 1.0 - 1e-9) sum += worth_holding;
    }
    return sum;
}

int changes_of(const std::vector<Path>& way) {
    int changes = 0;
    for (std::size_t i = 1; i < way.size(); ++i) changes += way[i].way != way[i - 1].way;
    return changes;
}

std::vector<Path> polished(const ChartPlace& place, const std::vector<Path>& way) {
    if (way.empty()) return way;
    std::vector<std::vector<Path>> moves;
    for (const Path& piece : way) {
        if (moves.empty() || moves.back().back().way != piece.way) moves.emplace_back();
        moves.back().push_back(piece);
    }
    constexpr int passes = 3;
    for (int pass = 0; pass < passes; ++pass) {
        bool better = false;
        for (std::size_t k = 0; k + 1 < moves.size(); ++k) better = improve(place, moves[k], moves[k + 1]) || better;
        const std::vector<Path> last = joints_of(place, moves.back()).from(0);
        better = better || trouble(last, place.radius) < trouble(moves.back(), place.radius) - 1e-6;
        moves.back() = last;
        drop_last_touch(place, way[0].start, moves);
        better = improve_end(place, moves.back()) || better;
        if (!better) break;
    }
    std::vector<Path> shorter = chained(way[0].start, moves);
    return trouble(shorter, place.radius) < trouble(way, place.radius) ? shorter : way;
}

}  // namespace snug::detail::sets
