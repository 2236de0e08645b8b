#include "all_maneuvers/route.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr double touch = 1e-9;  ///< deeper is contact [m]

enum Steering : std::uint8_t { left, straight, right };

struct At {
    int row = 0, column = 0;
    double y = 0.0;
};

constexpr double worth_a_step = 1e-4;  ///< of room [m]
constexpr double enough_room = 0.05;   ///< to end a move [m]

/// Steps from a node towards the parked poses. A step of full steering leads to the row beside, a straight one across a cell.
struct Stepper {
    const InnerLattice& lattice;
    int way;  ///< of the rows: -1 where the car, leaving, drives forward

    Stepper(const InnerLattice& on, Direction leaving) : lattice(on), way(leaving == Direction::forward ? -1 : 1) {}

    [[nodiscard]] At from(const At& at, Steering steering) const {
        const int d = at.column;
        if (steering == straight) {
            const double sine = lattice.sine(d);
            return {at.row + 2 * way, d, at.y + way * lattice.h() * sine / std::sqrt((1.0 - sine) * (1.0 + sine))};
        }
        // To the left the car keeps y + r cos, to the right y - r cos. Driving back to the left the heading falls.
        const int to = steering == left ? d + way : d - way;
        const double gain =
            steering == left ? lattice.level(d) - lattice.level(to) : lattice.level(to) - lattice.level(d);
        return {at.row + way, to, at.y + gain};
    }
};

/// Adds a piece of so many steps to the way; a piece of the same kind grows.
void drive_on(const InnerLattice& lattice, std::vector<Path>& way, Pose& pose, int& column, Steering steering,
              int steps, Direction direction) {
    Path piece;
    piece.start = pose;
    piece.way = direction == Direction::forward ? 1.0 : -1.0;
    const double sine = lattice.sine(column);
    if (steering == straight) {
        piece.length = steps * lattice.h() / std::sqrt((1.0 - sine) * (1.0 + sine));
    } else {
        const double sense = (steering == left ? 1.0 : -1.0) * piece.way;
        const int to = column + static_cast<int>(sense) * steps;
        piece.curvature = (steering == left ? 1.0 : -1.0) / lattice.radius();
        piece.length = std::abs(angles::asin(lattice.sine(to)) - angles::asin(sine)) * lattice.radius();
        column = to;
    }
    if (!(piece.length > 0.0)) return;
    if (!way.empty() && way.back().way == piece.way && way.back().curvature == piece.curvature) {
        way.back().length += piece.length;
        pose = way.back().at(way.back().length);
        return;
    }
    way.push_back(piece);
    pose = piece.at(piece.length);
}

}  // namespace

std::vector<Path> way_by_steps(const InnerLattice& lattice, const InnerChain& chain, const ChartPlace& place) {
    std::vector<Path> way;
    Pose pose = place.start;
    At at = {0, 0, place.start.y};
    for (std::size_t k = chain.reaches.size(); k-- > 0;) {
        const Direction leaving = chain.direction(k);
        const Direction direction = leaving == Direction::forward ? Direction::backward : Direction::forward;
        const Stepper stepper(lattice, leaving);
        const InnerSet &begins = chain.begins[k], &reaches = chain.reaches[k];
        for (;;) {
            // Where the next move can begin this one may end; it goes on as long as that gives more room.
            const double room_here = begins.at(at.row, at.column).room(at.y);
            const InnerSet& towards = room_here < 0.0 ? reaches : begins;
            const auto room_at = [&](const At& next) { return towards.at(next.row, next.column).room(next.y); };
            const At to_left = stepper.from(at, left), to_right = stepper.from(at, right);
            const double left_room = room_at(to_left), right_room = room_at(to_right);
            // Across the cell, turning off after a part of the first arc: what that gains depends on where.
            At across = {at.row + 2 * stepper.way, at.column, at.y};
            double across_room = -1.0;
            const double one = 2.0 * (to_left.y - at.y), other = 2.0 * (to_right.y - at.y);
            for (const Interval& interval : towards.at(across.row, across.column)) {
                const double from = std::max(at.y + std::min(one, other), interval.low);
                const double to = std::min(at.y + std::max(one, other), interval.high);
                if (from > to) continue;
                const double y = std::clamp((interval.low + interval.high) / 2.0, from, to);
                const double room = std::min(y - interval.low, interval.high - y);
                if (room > across_room) {
                    across_room = room;
                    across.y = y;
                }
            }
            const double most = std::max({left_room, right_room, across_room});
            if (room_here >= 0.0 && (room_here > enough_room || most <= room_here + worth_a_step)) break;
            if (most < 0.0) return {};
            int column = at.column;
            if (left_room >= right_room && left_room >= across_room) {
                drive_on(lattice, way, pose, column, left, 1, direction);
                at = to_left;
            } else if (right_room >= across_room) {
                drive_on(lattice, way, pose, column, right, 1, direction);
                at = to_right;
            } else {
                // First to the left by a part of an arc, right by a whole one, and left again; y falls or rises with the part.
                const double r = lattice.radius(), d = lattice.h() / (2.0 * r), s = lattice.sine(at.column);
                const auto cosine = [](double sine) { return std::sqrt((1.0 - sine) * (1.0 + sine)); };
                const double way_of = stepper.way;
                const auto gain = [&](double part) {
                    return 2.0 * r * (cosine(s + way_of * (part - 1.0) * d) - cosine(s + way_of * part * d));
                };
                // The gain rises or falls all the way from part 0 to part 1.
                double from = 0.0, to = 1.0;
                const double wanted = across.y - at.y;
                const double sign = gain(1.0) > gain(0.0) ? 1.0 : -1.0;
                for (int i = 0; i < 60; ++i) {
                    const double middle = (from + to) / 2.0;
                    (sign * (gain(middle) - wanted) < 0.0 ? from : to) = middle;
                }
                const double part = (from + to) / 2.0;
                const double turn = direction == Direction::forward ? 1.0 : -1.0;
                double here = s;
                const auto arc = [&](double curvature, double to_sine) {
                    Path piece;
                    piece.start = pose;
                    piece.way = turn;
                    piece.curvature = curvature / r;
                    piece.length = std::abs(angles::asin(to_sine) - angles::asin(here)) * r;
                    here = to_sine;
                    if (!(piece.length > 0.0)) return;
                    way.push_back(piece);
                    pose = piece.at(piece.length);
                };
                arc(1.0, s + turn * part * d);
                arc(-1.0, s + turn * (part - 1.0) * d);
                arc(1.0, s);
                at = across;
            }
        }
    }
    return way;
}

namespace {

/// The most of normal . p along the path of the rear axle's middle.
double farthest_along(const Path& path, const Point& normal) {
    const Pose end = path.at(path.length);
    double most = std::max(normal.x * path.start.x + normal.y * path.start.y, normal.x * end.x + normal.y * end.y);
    if (path.curvature == 0.0) return most;
    // On the circle it is where the heading is at a right angle to the normal.
    const double change = path.way * path.length * path.curvature;
    for (const double quarter : {1.0, -1.0}) {
        const double heading = angles::atan2(normal.y, normal.x) + quarter * 1.5707963267948966;
        double turned = std::remainder(heading - path.start.heading, 6.283185307179586);
        if (change > 0.0 && turned < 0.0) turned += 6.283185307179586;
        if (change < 0.0 && turned > 0.0) turned -= 6.283185307179586;
        if (std::abs(turned) > std::abs(change)) continue;
        const Pose there = path.at(turned / (path.way * path.curvature));
        most = std::max(most, normal.x * there.x + normal.y * there.y);
    }
    return most;
}

bool is_parked(const ChartPlace& place, const Pose& pose) {
    const double sine = angles::sin(pose.heading);
    if (sine < place.parked_from - touch || sine > place.parked_to + touch) return false;
    const std::vector<Point> frame = placed(place.frame, pose);
    for (const ParkedLimit& limit : place.parked) {
        const Point& n = limit.within.normal;
        double least = std::numeric_limits<double>::infinity(), most = -least;
        if (limit.of == ParkedLimit::axle) {
            least = most = n.x * pose.x + n.y * pose.y;
        } else {
            for (const Point& p : frame) {
                least = std::min(least, n.x * p.x + n.y * p.y);
                most = std::max(most, n.x * p.x + n.y * p.y);
            }
        }
        const double at = limit.of == ParkedLimit::nearest_point ? least : most;
        if (at > limit.within.offset + touch) return false;
    }
    return true;
}

}  // namespace

namespace {

bool is_free(const ChartPlace& place, const Path& piece) {
    for (const HalfPlane& edge : place.region)
        if (farthest_along(piece, edge.normal) > edge.offset + 1e-6) return false;
    for (const ChartPlace::Solid& solid : place.solids)
        if (first_contact(place.shapes[solid.stops], piece, solid.corners, touch) < piece.length) return false;
    return true;
}

}  // namespace

bool is_drivable(const ChartPlace& place, const std::vector<Path>& way) {
    for (const ChartPlace::Solid& solid : place.solids)
        if (overlap(placed(place.shapes[solid.stops], place.start), solid.corners) > touch) return false;
    for (const Path& piece : way)
        if (!is_free(place, piece)) return false;
    return is_parked(place, way.empty() ? place.start : way.back().at(way.back().length));
}

namespace {

constexpr double full_turn = 6.283185307179586;

double turned_left(double angle) {
    const double left_over = std::remainder(angle, full_turn);
    return left_over < 0.0 ? left_over + full_turn : left_over;
}

/// Ways of an arc, a straight line and an arc from one pose to another, driven forward or backward (Dubins 1957), the
/// shortest first.
std::vector<std::vector<Path>> ways_between(const Pose& from, const Pose& to, double way, double radius) {
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
    std::vector<Found> found;
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
    std::vector<std::vector<Path>> ways;
    for (const Found& of : found) {
        if (of.first > 2.5 || of.last > 2.5) continue;
        std::vector<Path> pieces;
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
        if (off < 1e-7 && !pieces.empty()) ways.push_back(std::move(pieces));
    }
    return ways;
}

bool stays_in_chart(const std::vector<Path>& way) {
    for (const Path& piece : way)
        if (std::abs(angles::sin(piece.at(piece.length).heading)) > steepest_sine ||
            std::abs(piece.at(piece.length).heading) > full_turn / 4.0)
            return false;
    return true;
}

}  // namespace

std::vector<Path> with_few_pieces(const ChartPlace& place, const std::vector<Path>& way) {
    std::vector<Path> few;
    for (std::size_t begin = 0; begin < way.size();) {
        std::size_t end = begin;
        while (end < way.size() && way[end].way == way[begin].way) ++end;
        // Poses 0 to n of this move; a stretch from one to another is replaced if that meets nothing.
        std::vector<Path> move(way.begin() + static_cast<std::ptrdiff_t>(begin),
                               way.begin() + static_cast<std::ptrdiff_t>(end));
        const std::size_t n = move.size();
        const auto pose = [&](std::size_t i) { return i < n ? move[i].start : move.back().at(move.back().length); };
        Pose at = pose(0);
        const auto shortcut = [&](std::size_t to) {
            for (std::vector<Path>& pieces : ways_between(at, pose(to), way[begin].way, place.radius)) {
                if (!stays_in_chart(pieces)) continue;
                if (std::all_of(pieces.begin(), pieces.end(), [&](const Path& piece) { return is_free(place, piece); }))
                    return pieces;
            }
            return std::vector<Path>{};
        };
        for (std::size_t i = 0; i < n;) {
            std::vector<Path> best;
            std::size_t reached = i;
            // The whole rest, or else as far as doubling and then halving of the step leads.
            std::size_t step = n - i;
            best = shortcut(n);
            if (!best.empty()) {
                reached = n;
            } else {
                for (step = 1; i + step < n; step *= 2) {
                    std::vector<Path> pieces = shortcut(i + step);
                    if (pieces.empty()) break;
                    best = std::move(pieces);
                    reached = i + step;
                }
                for (; step > 0; step /= 2) {
                    if (reached + step >= n) continue;
                    std::vector<Path> pieces = shortcut(reached + step);
                    if (pieces.empty()) continue;
                    best = std::move(pieces);
                    reached += step;
                }
            }
            if (best.empty()) {  // as it was
                best = {move[i]};
                best[0].start = at;
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
    return few;
}

}  // namespace snug::detail::sets
