// The paper's strategy as a machine: full steering until contact, then the other way round, move after move.
//
// State is the turning centre and the heading. A move keeps the centre and lowers the heading; at its end the centre
// jumps across the car to the other side. With Slope, the derivatives with respect to the entry heading come along.
//
// Parked means within a quarter turn of parallel, and headings only fall: a car that comes to stand straight across, nose to
// the curb, has turned away. That ends a move, and the run with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "contact/entry_corner.hpp"
#include "contact/parking.hpp"
#include "contact/turning.hpp"
#include "model/angles.hpp"

namespace snug::detail {

/// Straight across, nose to the curb.
inline constexpr QuarterHeading turned_away = {1.0, 0.0, 1};
/// The same direction, so many whole turns before that.
inline QuarterHeading before_turned_away(QuarterHeading heading) {
    heading.quarter = turned_away.quarter - ((turned_away.quarter - heading.quarter) & 3);
    return heading;
}

/// Car and slot with everything that can be computed once.
struct FullSteering {
    Problem problem;
    TurningFrame backward;  ///< turning about the left centre
    TurningFrame forward;   ///< turning about the right centre
    bool height_decides;    ///< see by_height_alone()
    EntryShape entry;       ///< the body at the entry position

    /// For runs that begin in the quarter turn `first_quarter` (see QuarterHeading) or later.
    explicit FullSteering(Problem of, int first_quarter = 0)
        : FullSteering(std::move(of), TurningShape(of), first_quarter) {}

private:
    FullSteering(Problem&& of, const TurningShape& shape, int first_quarter)
        : problem(std::move(of)),
          backward(problem, shape, problem.radius),
          forward(problem, shape, -problem.radius),
          height_decides(first_quarter >= 0 && by_height_alone(problem)),
          entry(problem, shape.ways) {
        problem.parked.heading = std::min(problem.parked.heading, limits::quarter_turn);
        for (int quarter = first_quarter; quarter <= turned_away.quarter; ++quarter) {
            backward.see(shape, quarter);
            forward.see(shape, quarter);
        }
    }
};

/// What one move did. Nothing is filled in until it is driven.
struct FullMove {
    Meets meets;  ///< nothing: it has turned away
    bool backward;
    bool stuck;               ///< it had no length
    std::uint8_t ahead;       ///< see Found
    int quarter;              ///< in which quarter turn the move ended
    std::int16_t part;        ///< which corner or edge, by its index in the outline
    std::int16_t sector;      ///< of that quarter
    double depth;             ///< D_n: by how little the car misses being parked during the move: how high the frame's
                              ///< highest corner is at least, or what else counts as parked [m]
    double depth_slope;       ///< d depth / d entry heading; this and what follows only where slopes are asked for
    double x, y;              ///< of the turning centre [m]
    double x_slope, y_slope;  ///< with the entry heading
    /// How high above the curb the lowest corner's circle ends, in the first and the second quarter turn (negative: the
    /// corner meets the curb) [m]; NaN where the move does not sweep that point. Its slope is that of y.
    std::array<double, 2> graze;
};

/// Backward in the second quarter turn, tail up: how high the leftmost corner crosses the rear side, and how far behind the
/// front corner of the slot the lowest corner sinks below the neighbour's top [m]; NaN where it does not.
struct Clearings {
    double tail = std::numeric_limits<double>::quiet_NaN();
    double nose = std::numeric_limits<double>::quiet_NaN();
    double tail_slope = 0.0, nose_slope = 0.0;
};
inline Clearings clearings(const FullSteering& steering, const FullMove& move) {
    Clearings clears;
    if (!move.backward || move.meets == Meets::nothing || move.quarter != 1) return clears;
    const Sector& sector = steering.backward.at(1, move.sector);
    const double tail_along = -steering.problem.length - move.x;
    const Root<double> tail = root<Plain<double>>(corner_on_wall<Plain<double>, -1>(sector.leftmost, tail_along));
    if (tail.s >= 0.0 && tail.c >= 0.0) {
        clears.tail = move.y + steering.problem.rear_setback - tail.across;
        clears.tail_slope = move.y_slope - move.x_slope * tail_along / tail.across;
    }
    const double above_front = move.y + steering.problem.front_setback;
    const Root<double> nose = root<Plain<double>>(corner_on_ground<Plain<double>>(sector.lowest, above_front));
    if (nose.s >= 0.0 && nose.c >= 0.0) {
        clears.nose = move.x + nose.across;
        clears.nose_slope = move.x_slope - move.y_slope * above_front / nose.across;
    }
    return clears;
}

/// The car between two moves (or at its entry position).
class FullSteeringRun {
public:
    /// At the entry position with this heading in [0, pi/2].
    FullSteeringRun(const FullSteering& steering, double entry_heading) : steering_(&steering) {
        const auto [sine, cosine] = angles::sine_cosine(entry_heading);
        heading_ = {cosine, sine, 0};
        const double front = steering.entry.corner.x;
        const double side = steering.problem.radius - steering.entry.corner.y;
        const double x = -front * heading_.c - side * heading_.s;
        const double y = -front * heading_.s + side * heading_.c;
        x_ = x;
        y_ = y - steering.problem.front_setback;
        x_slope_ = -y;
        y_slope_ = x;
        sector_ = steering.backward.sector_of(heading_);
    }

    /// From any pose in the entering frame, backward or forward first.
    FullSteeringRun(const FullSteering& steering, const Pose& pose, bool backward)
        : steering_(&steering), heading_(before_turned_away(in_quarters(pose.heading))), backward_(backward) {
        const auto [sine, cosine] = angles::sine_cosine(pose.heading);
        const double offset = backward ? steering.problem.radius : -steering.problem.radius;
        x_ = pose.x - offset * sine;
        y_ = pose.y + offset * cosine;
        sector_ = steering.backward.sector_of(heading_);
    }

    [[nodiscard]] const QuarterHeading& heading() const { return heading_; }
    [[nodiscard]] bool backward() const { return backward_; }
    /// Turning centre of the next move. [m]
    [[nodiscard]] double x() const { return x_; }
    [[nodiscard]] double y() const { return y_; }
    /// How it changes with the entry heading. [m]
    [[nodiscard]] double x_slope() const { return x_slope_; }
    [[nodiscard]] double y_slope() const { return y_slope_; }

    template <bool Slope>
    __attribute__((always_inline)) FullMove drive() {
        FullMove move;
        drive<Slope>(move);
        return move;
    }
    /// Drives the next move to its contact, and fills in a new `move`. A move that turns away leaves the car where it was.
    template <bool Slope>
    __attribute__((always_inline)) void drive(FullMove& move) {
        const TurningFrame& frame = backward_ ? steering_->backward : steering_->forward;
        double end_slope = heading_slope_;  // of the heading at the move's end
        // Number by number: a copy of the whole would wait for the stores of its parts.
        QuarterHeading now = {heading_.c, heading_.s, heading_.quarter};
        int index = sector_;
        const Sector* sector = &frame.at(now.quarter, index);
        move.backward = backward_;
        move.stuck = false;
        move.depth = height_of(sector->top, y_, now.c, now.s);
        if constexpr (Slope) {
            move.depth_slope = y_slope_ + slope_of_height(sector->top, now) * heading_slope_;
            move.x = x_;
            move.y = y_;
            move.x_slope = x_slope_;
            move.y_slope = y_slope_;
            move.graze.fill(std::numeric_limits<double>::quiet_NaN());
        }
        for (int sectors = 0;; ++sectors) {
            Found contact;
            const Bearing first =
                first_in_sector(frame, *sector, steering_->problem, x_, y_, now.quarter, now.c, now.s, contact);
            const bool met = contact.meets != Meets::nothing;
            move.meets = contact.meets;
            if constexpr (Slope) note_graze(*sector, now, move.meets, first.order(), move);
            if (sector->dip_order <= now.order() && !(met && first.order() > sector->dip_order))
                note_depth(y_ - sector->top.radius, y_slope_, move);
            if (met) {
                move.ahead = static_cast<std::uint8_t>(contact.ahead);
                move.part = static_cast<std::int16_t>(contact.part);
                move.stuck = sectors == 0 && first.order() == heading_.order();  // and the heading stays as it is
                if (!move.stuck) {
                    now.c = first.c;
                    now.s = first.s;
                }
                if constexpr (Slope) {
                    if (!move.stuck) end_slope = end_slope_at(frame, contact, now);
                }
                break;
            }
            note_depth(height_of(sector->top, y_, sector->end_c, sector->end_s), y_slope_, move);
            if (index + 1 < frame.per_quarter) {
                ++index;
                now.c = sector->end_c;
                now.s = sector->end_s;
            } else if (now.quarter < turned_away.quarter) {
                index = 0;
                now = {0.0, 1.0, now.quarter + 1};
            } else {
                break;
            }
            sector = &frame.at(now.quarter, index);
        }
        move.quarter = now.quarter;
        move.sector = static_cast<std::int16_t>(index);
        const bool met = move.meets != Meets::nothing;
        if (met) {
            const double height = height_of(sector->top, y_, now.c, now.s);
            if (height < move.depth) {
                move.depth = height;
                if constexpr (Slope) move.depth_slope = y_slope_ + slope_of_height(sector->top, now) * end_slope;
            }
        }
        if (!steering_->height_decides) {  // more than the height does
            const QuarterHeading start = {heading_.c, heading_.s, heading_.quarter};
            const QuarterHeading end = met ? QuarterHeading{now.c, now.s, now.quarter} : turned_away;
            const Miss miss = least_miss({&frame, &steering_->problem, x_, y_, x_slope_, y_slope_}, start, end,
                                         heading_slope_, met ? end_slope : 0.0);
            move.depth = miss.excess;
            move.depth_slope = miss.slope;
        }
        if (!met) return;
        if constexpr (Slope) heading_slope_ = end_slope;
        sector_ = index;
        turn_over<Slope>(now);
    }

private:
    static double slope_of_height(const TurningCorner& corner, const QuarterHeading& at) {
        return corner.x * at.c - corner.y * at.s;
    }

    static void note_depth(double height, double slope, FullMove& move) {
        if (height < move.depth) {
            move.depth = height;
            move.depth_slope = slope;
        }
    }

    [[nodiscard]] double end_slope_at(const TurningFrame& frame, const Found& contact, const QuarterHeading& at) const {
        switch (contact.meets) {
            case Meets::front_side: return slope_of_root(x_slope_, contact.across);
            case Meets::rear_side: return slope_of_root(-x_slope_, contact.across);
            case Meets::front_corner:
            case Meets::rear_corner: {
                const Point& normal = frame.normal(at.quarter, contact.part);
                const double nx = normal.x * at.c - normal.y * at.s;
                const double ny = normal.x * at.s + normal.y * at.c;
                return slope_of_root(nx * x_slope_ + ny * y_slope_, contact.across);
            }
            default: return slope_of_root(-y_slope_, contact.across);
        }
    }

    /// The lowest corner's circle reaches down to y - radius; note it where the move sweeps that point or meets the curb.
    void note_graze(const Sector& sector, const QuarterHeading& from, Meets meets, double order, FullMove& move) const {
        if (from.quarter < 0 || from.quarter > 1 || sector.graze_order > from.order()) return;
        if (meets != Meets::nothing && meets != Meets::curb && order > sector.graze_order) return;
        move.graze[static_cast<std::size_t>(from.quarter)] = y_ + steering_->problem.width - sector.at_curb.radius;
    }

    template <bool Slope>
    void turn_over(const QuarterHeading& now) {
        heading_ = now;
        const double across = backward_ ? 2.0 * steering_->problem.radius : -2.0 * steering_->problem.radius;
        x_ += across * now.sine();
        y_ -= across * now.cosine();
        if constexpr (Slope) {
            x_slope_ += across * now.cosine() * heading_slope_;
            y_slope_ += across * now.sine() * heading_slope_;
        }
        backward_ = !backward_;
    }

    const FullSteering* steering_;
    QuarterHeading heading_;
    int sector_ = 0;  ///< in its quarter
    double x_ = 0.0;
    double y_ = 0.0;
    double x_slope_ = 0.0;
    double y_slope_ = 0.0;
    double heading_slope_ = 1.0;
    bool backward_ = true;
};

/// The maneuver from an entry position, as snug::max_steer() gives it; heading and options are checked.
MaxSteerRun max_steer(const Car& car, const Slot& slot, const FullSteering& steering, double heading,
                      const MaxSteerOptions& options);

}  // namespace snug::detail
