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

/// Whether a box around everything the car can come to is apart from a box around the solid.
bool is_out_of_reach(const std::vector<Point>& shape, const Path& piece, const std::vector<Point>& solid) {
    double size = 0.0;
    for (const Point& p : shape) size = std::max(size, std::abs(p.x) + std::abs(p.y));
    const double reach = piece.length + size + 0.01;
    double left = solid[0].x, right = left, below = solid[0].y, above = below;
    for (const Point& p : solid) {
        left = std::min(left, p.x), right = std::max(right, p.x);
        below = std::min(below, p.y), above = std::max(above, p.y);
    }
    return piece.start.x + reach < left || piece.start.x - reach > right || piece.start.y + reach < below ||
           piece.start.y - reach > above;
}

}  // namespace

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

bool is_free(const ChartPlace& place, const Path& piece) {
    for (const HalfPlane& edge : place.region)
        if (farthest_along(piece, edge.normal) > edge.offset + 1e-6) return false;
    for (const ChartPlace::Solid& solid : place.solids) {
        const std::vector<Point>& shape = place.shapes[solid.stops];
        if (!is_out_of_reach(shape, piece, solid.corners) &&
            first_contact(shape, piece, solid.corners, touch) < piece.length)
            return false;
    }
    return true;
}

bool is_drivable(const ChartPlace& place, const std::vector<Path>& way) {
    for (const ChartPlace::Solid& solid : place.solids)
        if (overlap(placed(place.shapes[solid.stops], place.start), solid.corners) > touch) return false;
    for (const Path& piece : way)
        if (!is_free(place, piece)) return false;
    return is_parked(place, way.empty() ? place.start : way.back().at(way.back().length));
}

}  // namespace snug::detail::sets
