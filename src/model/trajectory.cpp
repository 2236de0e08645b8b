// A maneuver over time: pieces from rest to rest, the steering in between.
#include "snug/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"
#include "snug/rolling.hpp"

namespace snug {
namespace {

constexpr double most_points = 1e6;
constexpr double least_period = 1e-6;
constexpr double least_limit = 1e-3;
constexpr double greatest_limit = 1e3;

void check(const MotionLimits& limits) {
    check_between("greatest speed", limits.speed, least_limit, greatest_limit, " m/s");
    check_between("acceleration", limits.acceleration, least_limit, greatest_limit, " m/s2");
    check_between("deceleration", limits.deceleration, least_limit, greatest_limit, " m/s2");
    check_between("steering rate", limits.steering_rate, least_limit, greatest_limit, " rad/s");
}

/// Where the car is `seconds` after `from`, up to the next point.
TrajectoryPoint moved_on(const Car& car, const TrajectoryPoint& from, double seconds) {
    TrajectoryPoint to = from;
    to.time = from.time + seconds;
    to.speed = from.speed + from.acceleration * seconds;
    const double driven = std::abs((from.speed + from.acceleration * seconds / 2.0) * seconds);
    to.distance = from.distance + driven;
    if (from.sharpness != 0.0) {
        const RollingPiece piece = {from.direction, from.curvature, from.sharpness, driven, from.pose, {}};
        to.pose = piece.at(driven);
        to.curvature = piece.curvature_at(driven);
        to.steering_angle = angles::atan(car.wheelbase() * to.curvature);
        const double cosine = angles::cos(to.steering_angle);
        to.steering_rate = car.wheelbase() * from.sharpness * std::abs(to.speed) * cosine * cosine;
        return to;
    }
    to.steering_angle = from.steering_angle + from.steering_rate * seconds;
    to.curvature = angles::tan(to.steering_angle) / car.wheelbase();
    to.pose = drive(car, from.pose, from.direction, from.steering_angle, driven);
    return to;
}

/// A trajectory point by point: each call adds what the car does for a while.
class Writer {
public:
    Writer(const Maneuver& maneuver, const MotionLimits& limits, double steering_angle)
        : result_{maneuver.car, limits, {}, 0} {
        now_.pose = maneuver.entry();
        now_.direction = maneuver.moves.front().direction;
        now_.steering_angle = steering_angle;
        now_.curvature = angles::tan(steering_angle) / maneuver.car.wheelbase();
    }

    /// While the car stands.
    void steer(double angle) {
        const double turn = angle - now_.steering_angle;
        if (turn == 0.0) return;
        now_.steering_rate = turn > 0.0 ? result_.limits.steering_rate : -result_.limits.steering_rate;
        hold(std::abs(turn) / result_.limits.steering_rate);
        now_.steering_rate = 0.0;
        now_.steering_angle = angle;
        now_.curvature = angles::tan(angle) / result_.car.wheelbase();
        ++result_.standing_steers;
    }

    /// From rest to rest, with the steering angle that the wheels have. The top speed v satisfies
    /// v^2 / 2a + v^2 / 2d <= length.
    void roll(const Pose& start, const Pose& end, Direction direction, double length) {
        const double a = result_.limits.acceleration;
        const double d = result_.limits.deceleration;
        const double sign = static_cast<double>(static_cast<int>(direction));
        const double top = std::min(result_.limits.speed, std::sqrt(2.0 * length * (a / (a + d)) * d));
        const double gaining = top * top / (2.0 * a);
        const double losing = top * top / (2.0 * d);
        const double distance = now_.distance;
        now_.pose = start;
        now_.direction = direction;
        const auto leg = [&](double acceleration, double seconds, double end_speed, double driven) {
            now_.acceleration = sign * acceleration;
            hold(seconds);
            now_.acceleration = 0.0;
            now_.speed = sign * end_speed;
            now_.distance = distance + driven;
            now_.pose = drive(result_.car, start, direction, now_.steering_angle, driven);
        };
        leg(a, top / a, top, gaining);
        if (top == result_.limits.speed) leg(0.0, std::max(0.0, length - gaining - losing) / top, top, length - losing);
        leg(-d, top / d, 0.0, length);
        now_.speed = 0.0;  // not -0
        now_.pose = end;
    }

    Trajectory finished() {
        result_.points.push_back(now_);
        return std::move(result_);
    }

private:
    void hold(double seconds) {
        if (seconds == 0.0) return;
        result_.points.push_back(now_);
        now_.time += seconds;
    }

    Trajectory result_;
    TrajectoryPoint now_;
};

}  // namespace

TrajectoryPoint Trajectory::at(double time) const {
    if (!(time > points.front().time)) return points.front();
    if (time >= points.back().time) return points.back();
    const auto after = std::upper_bound(points.begin(), points.end(), time,
                                        [](double t, const TrajectoryPoint& point) { return t < point.time; });
    const TrajectoryPoint& from = *(after - 1);
    return moved_on(car, from, time - from.time);
}

Trajectory trajectory(const Maneuver& maneuver, const MotionLimits& limits, double steering_angle) {
    check(limits);
    check_between("steering angle at the start", steering_angle, -limits::most_steer, limits::most_steer, " rad");
    if (maneuver.moves.empty()) return {maneuver.car, limits, {}, 0};
    Writer writer(maneuver, limits, steering_angle);
    const std::vector<Move>& moves = maneuver.moves;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (moves[i].length == 0.0) continue;
        const Move& first = moves[i];
        double length = first.length;
        Pose end = first.end;
        // What goes on the same way is one piece.
        for (; i + 1 < moves.size(); ++i) {
            const Move& next = moves[i + 1];
            if (next.length != 0.0 &&
                (next.direction != first.direction || next.steering_angle != first.steering_angle))
                break;
            length += next.length;
            end = next.end;
        }
        writer.steer(first.steering_angle);
        writer.roll(first.start, end, first.direction, length);
    }
    return writer.finished();
}

std::vector<TrajectoryPoint> sampled(const Trajectory& trajectory, double period) {
    check_between("period of a trajectory", period, least_period, std::numeric_limits<double>::infinity(), " s");
    const double seconds = trajectory.seconds();
    if (seconds / period > most_points)
        throw Error("period of a trajectory is " + spelled(period) + " s, which makes more than " +
                    spelled(most_points) + " points of " + spelled(seconds) + " s; take a longer period");
    std::vector<TrajectoryPoint> points;
    if (trajectory.points.empty()) return points;
    for (double i = 0.0; i * period < seconds; ++i) points.push_back(trajectory.at(i * period));
    points.push_back(trajectory.points.back());
    return points;
}

}  // namespace snug
