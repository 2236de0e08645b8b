// One move at full steering, exactly: the car turns clockwise about a fixed centre until something stops it.
//
// Both kinds of move of the paper's strategy, backward with full left and forward with full right steering, turn the car
// clockwise; other moves are mirror images. Everything here lives in the slot frame (see slot.hpp).
//
// The idea: while the heading stays within one quarter turn, the same corner of the frame is the lowest, the same the
// leftmost and the same the rightmost. A convex frame can then meet the world in five ways only:
//
//     rightmost corner - front side        lowest corner - curb          leftmost corner - rear side
//     edge between rightmost and           edge between leftmost and
//     lowest corner - front corner         lowest corner - rear corner
//
// (and, coming from the road, the lowest corner can land on a neighbour). Each is a point crossing a line while moving
// on a circle: one square root, and only one of the two crossings leads inward.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "snug/car.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail {

/// What a turning car meets.
enum class Meets : unsigned char {
    nothing,
    front_side,
    front_corner,
    curb,
    rear_corner,
    rear_side,
    front_top,
    rear_top
};

/// What that is called: which part of the car meets what, in the given quarter turn.
inline Contact contact_of(Meets meets, int quarter) {
    constexpr std::array corners = {CarPart::rear_right_corner, CarPart::front_right_corner, CarPart::front_left_corner,
                                    CarPart::rear_left_corner};
    constexpr std::array edges = {CarPart::right_edge, CarPart::front_edge, CarPart::left_edge, CarPart::rear_edge};
    const auto around = [quarter](std::size_t steps) { return (static_cast<std::size_t>(quarter & 3) + steps) % 4; };
    switch (meets) {
        case Meets::front_side: return {corners[around(1)], Obstacle::front_side};
        case Meets::front_corner: return {edges[around(0)], Obstacle::front_corner};
        case Meets::rear_corner: return {edges[around(3)], Obstacle::rear_corner};
        case Meets::rear_side: return {corners[around(3)], Obstacle::rear_side};
        case Meets::front_top: return {corners[around(0)], Obstacle::front_side};
        case Meets::rear_top: return {corners[around(0)], Obstacle::rear_side};
        default: return {corners[around(0)], Obstacle::curb};
    }
}

/// A heading as its quarter turn and the direction within it: heading = atan2(s, c) - quarter * pi/2, c and s >= 0.
/// Turning clockwise, s falls to 0 and the next quarter begins at s = 1.
struct QuarterHeading {
    double c = 1.0;
    double s = 0.0;
    int quarter = 0;

    [[nodiscard]] double cosine() const {
        switch (quarter & 3) {
            case 0: return c;
            case 1: return s;
            case 2: return -c;
            default: return -s;
        }
    }
    [[nodiscard]] double sine() const {
        switch (quarter & 3) {
            case 0: return s;
            case 1: return -c;
            case 2: return -s;
            default: return c;
        }
    }
    /// Falls with the angle, at an even pace, and needs no trigonometry: sin - cos.
    [[nodiscard]] double order() const { return s - c; }
    [[nodiscard]] double angle() const { return angles::atan2(s, c) - quarter * 1.57079632679489661923; }
};

/// A corner of the frame seen from the turning centre, x along the heading of the quarter.
struct TurningCorner {
    double x = 0.0;
    double y = 0.0;
    double radius = 0.0;
    double per_square = 0.0;  ///< 1 / radius^2

    TurningCorner() = default;
    TurningCorner(double along, double across)
        : x(along),
          y(across),
          radius(std::sqrt(along * along + across * across)),
          per_square(1.0 / (along * along + across * across)) {}
};

/// The frame as it lies in one quarter turn.
struct QuarterFrame {
    TurningCorner lowest;
    TurningCorner leftmost;   ///< shares its x with the lowest
    TurningCorner rightmost;  ///< shares its y with the lowest
    TurningCorner top;        ///< highest corner of the parked frame
    double graze_order =
        0.0;  ///< order() of the heading at which the lowest corner is lowest; infinite if in no quarter
};

/// The frame in all four quarter turns about one turning centre.
using TurningFrame = std::array<QuarterFrame, 4>;

/// `offset`: how far the turning centre lies to the left of the rear axle centre (negative: to the right). [m]
inline TurningFrame turning_frame(const Outline& touching, const Outline& parked, double offset) {
    TurningFrame frames;
    const std::array<double, 4> outer = {touching.front(), touching.left(), touching.rear(), touching.right()};
    const std::array<double, 4> inner = {parked.front(), parked.left(), parked.rear(), parked.right()};
    const std::array<double, 4> centre_x = {0.0, offset, 0.0, -offset};
    const std::array<double, 4> centre_y = {offset, 0.0, -offset, 0.0};
    for (std::size_t q = 0; q < 4; ++q) {
        const double right = outer[q] - centre_x[q];
        const double top = outer[(q + 1) % 4] - centre_y[q];
        const double left = -outer[(q + 2) % 4] - centre_x[q];
        const double bottom = -outer[(q + 3) % 4] - centre_y[q];
        frames[q].lowest = {left, bottom};
        frames[q].graze_order = left <= 0.0 && bottom <= 0.0 ? (bottom - left) / frames[q].lowest.radius
                                                             : std::numeric_limits<double>::infinity();
        frames[q].leftmost = {left, top};
        frames[q].rightmost = {right, bottom};
        frames[q].top = {inner[q] - centre_x[q], inner[(q + 1) % 4] - centre_y[q]};
    }
    return frames;
}

/// A contact found in a quarter turn: the heading there and what is met.
struct QuarterContact {
    double c = 0.0;
    double s = 0.0;
    double order = -2.0;  ///< s - c; the first contact of a clockwise turn is the largest
    double across = 0.0;  ///< the root taken: how squarely the circle crosses the line [m]
    Meets meets = Meets::nothing;
    unsigned ahead = 0;  ///< bits of everything that would be met in this quarter, were nothing else in the way
};

/// The bit of QuarterContact::ahead.
constexpr unsigned bit_of(Meets meets) { return 1U << static_cast<unsigned>(meets); }

/// How a part of the car and an obstacle stand before the move: apart or parting, touching and closing in, or corner to
/// corner and bound to miss each other.
enum class AtStart { apart, touches, slips_off };

/// What touches has its root this near in order(), even where the circle only just crosses.
constexpr double near_start = 1e-2;

/// First contact while turning clockwise about (x, y) within a quarter, from the heading (c, s). What touches already and
/// would move in is met at once; what touches and moves away, or along, is not met.
inline QuarterContact first_contact_in_quarter(const QuarterFrame& frame, double x, double y, const Problem& problem,
                                               double start_c, double start_s) {
    QuarterContact first;
    const double start_order = start_s - start_c;
    // `at_start` is asked only of what has its root near the start, whether it touches there and moves in.
    const auto consider = [&](double c, double s, double across, Meets meets, auto at_start) {
        double order = s - c;
        const double later = start_order - order;
        if (later <= -near_start) return;
        const AtStart found = later < near_start ? at_start() : AtStart::apart;
        if (found == AtStart::slips_off) return;
        if (found == AtStart::touches) {
            order = start_order;
        } else if (!(s >= 0.0 && c >= 0.0 && later >= 0.0)) {
            return;
        }
        first.ahead |= bit_of(meets);
        if (order > first.order) {
            first.c = c;
            first.s = s;
            first.order = order;
            first.across = across;
            first.meets = meets;
        }
    };
    // A corner of the car meets an upright wall; the wall lies to the right (sign 1) or to the left (sign -1).
    const auto corner_meets_side = [&](const TurningCorner& corner, double wall, double sign, Meets meets) {
        const double along = wall - x;
        const double square = (corner.radius - along) * (corner.radius + along);
        if (!(square >= 0.0)) return;
        const double across = sign * std::sqrt(square);
        const double s = (across * corner.x - along * corner.y) * corner.per_square;
        const double c = (along * corner.x + across * corner.y) * corner.per_square;
        const double height = y + corner.x * s + corner.y * c;
        if (!(height <= problem.touch)) return;
        const auto at_start = [&] {
            const double start_x = corner.x * start_c - corner.y * start_s;
            const double start_y = corner.x * start_s + corner.y * start_c;
            if (std::abs(along - start_x) > problem.touch || sign * start_y <= 0.0) return AtStart::apart;
            return y + start_y >= -problem.touch && start_x <= 0.0 ? AtStart::slips_off : AtStart::touches;
        };
        // Rounding may have lifted a corner that touches above the wall's end.
        if (height > 0.0 && at_start() != AtStart::touches) return;
        consider(c, s, across, meets, at_start);
    };
    // The lowest corner meets level ground: the curb, or a neighbour it comes down upon.
    const auto corner_meets_ground = [&](double ground, Meets meets) {
        const TurningCorner& corner = frame.lowest;
        const double across = ground - y;
        const double square = (corner.radius - across) * (corner.radius + across);
        if (!(square >= 0.0)) return;
        const double along = std::sqrt(square);
        const double s = (across * corner.x - along * corner.y) * corner.per_square;
        const double c = (along * corner.x + across * corner.y) * corner.per_square;
        const double where = x + corner.x * c - corner.y * s;
        const double beyond_end = meets == Meets::front_top  ? where
                                  : meets == Meets::rear_top ? -problem.length - where
                                                             : std::numeric_limits<double>::infinity();
        if (!(beyond_end >= -problem.touch)) return;
        const auto at_start = [&] {
            const double start_x = corner.x * start_c - corner.y * start_s;
            const double start_y = corner.x * start_s + corner.y * start_c;
            if (std::abs(start_y - across) > problem.touch || start_x <= 0.0) return AtStart::apart;
            const bool moves_onto = meets == Meets::front_top ? start_y > 0.0 : start_y < 0.0;
            return beyond_end > problem.touch || moves_onto ? AtStart::touches : AtStart::apart;
        };
        if (beyond_end <= problem.touch && at_start() != AtStart::touches) return;
        consider(c, s, along, meets, at_start);
    };

    corner_meets_side(frame.rightmost, 0.0, 1.0, Meets::front_side);
    corner_meets_side(frame.leftmost, -problem.length, -1.0, Meets::rear_side);
    corner_meets_ground(-problem.width, Meets::curb);
    if (y + frame.lowest.x * start_s + frame.lowest.y * start_c > -problem.touch) {
        corner_meets_ground(0.0, Meets::front_top);
        corner_meets_ground(0.0, Meets::rear_top);
    }
    {  // the slot's front corner meets the edge from the lowest to the rightmost corner
        const double gx = -x;
        const double gy = -y;
        const double square = gx * gx + gy * gy - frame.lowest.y * frame.lowest.y;
        const double along = std::sqrt(std::max(square, 0.0));
        if (square >= 0.0 && along <= frame.rightmost.x + problem.touch && along >= frame.lowest.x - problem.touch) {
            const double per_square = 1.0 / (gx * gx + gy * gy);
            consider((gx * along + gy * frame.lowest.y) * per_square, (gy * along - gx * frame.lowest.y) * per_square,
                     along, Meets::front_corner, [&] {
                         const double start_x = gx * start_c + gy * start_s;
                         const double start_y = gy * start_c - gx * start_s;
                         if (std::abs(start_y - frame.lowest.y) > problem.touch || start_x <= 0.0)
                             return AtStart::apart;
                         const bool slips_off = (start_x >= frame.rightmost.x - problem.touch && start_y <= 0.0) ||
                                                (start_x <= frame.lowest.x + problem.touch && start_y >= 0.0);
                         return slips_off ? AtStart::slips_off : AtStart::touches;
                     });
        }
    }
    {  // the slot's rear corner meets the edge from the lowest to the leftmost corner
        const double gx = -problem.length - x;
        const double gy = -y;
        const double square = gx * gx + gy * gy - frame.lowest.x * frame.lowest.x;
        const double across = -std::sqrt(std::max(square, 0.0));
        if (square >= 0.0 && across <= frame.leftmost.y + problem.touch && across >= frame.lowest.y - problem.touch) {
            const double per_square = 1.0 / (gx * gx + gy * gy);
            consider((gx * frame.lowest.x + gy * across) * per_square, (gy * frame.lowest.x - gx * across) * per_square,
                     across, Meets::rear_corner, [&] {
                         const double start_x = gx * start_c + gy * start_s;
                         const double start_y = gy * start_c - gx * start_s;
                         if (std::abs(start_x - frame.lowest.x) > problem.touch || start_y >= 0.0)
                             return AtStart::apart;
                         const bool slips_off = (start_y >= frame.leftmost.y - problem.touch && start_x >= 0.0) ||
                                                (start_y <= frame.lowest.y + problem.touch && start_x <= 0.0);
                         return slips_off ? AtStart::slips_off : AtStart::touches;
                     });
        }
    }
    if (first.order == start_order) {  // what is met at the start is met right there
        first.c = start_c;
        first.s = start_s;
    }
    return first;
}

/// Height of the parked frame's highest corner at a heading of the quarter.
inline double top_height(const QuarterFrame& frame, double y, double c, double s) {
    return y + frame.top.x * s + frame.top.y * c;
}

}  // namespace snug::detail
