// Clothoids, and how quickly they are driven.
#include "snug/rolling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "model/angles.hpp"
#include "sentences/check.hpp"

namespace snug {
namespace {

/// Gauss and Legendre's eight places in [-1, 1] and their weights: with a turn of half a radian at most, the integral of a
/// cosine is exact to rounding.
constexpr std::array<std::array<double, 2>, 4> places = {{{0.18343464249564980, 0.36268378337836198},
                                                          {0.52553240991632899, 0.31370664587788729},
                                                          {0.79666647741362674, 0.22238103445337447},
                                                          {0.96028985649753623, 0.10122853629037626}}};
constexpr double most_turn = 0.5;        // [rad]
constexpr double same_curvature = 1e-9;  // but for rounding [1/m]

double sign_of(Direction direction) { return static_cast<double>(static_cast<int>(direction)); }

}  // namespace

Pose RollingPiece::at(double distance) const {
    const double way = sign_of(direction);
    const double bend = std::max(std::abs(curvature), std::abs(curvature_at(distance)));
    const int parts = 1 + static_cast<int>(bend * distance / most_turn);
    const double half = distance / (2.0 * parts);
    const auto heading_at = [&](double s) { return start.heading + way * s * (curvature + sharpness * s / 2.0); };
    double x = 0.0, y = 0.0;
    for (int i = 0; i < parts; ++i) {
        const double middle = (2 * i + 1) * half;
        for (const auto& [place, weight] : places) {
            for (const double s : {middle - place * half, middle + place * half}) {
                const auto [sine, cosine] = angles::sine_cosine(heading_at(s));
                x += weight * cosine;
                y += weight * sine;
            }
        }
    }
    return {start.x + way * half * x, start.y + way * half * y, heading_at(distance)};
}

int RollingManeuver::direction_changes() const {
    int changes = 0;
    for (std::size_t i = 1; i < pieces.size(); ++i)
        if (pieces[i].direction != pieces[i - 1].direction) ++changes;
    return changes;
}

std::vector<StandingSteer> RollingManeuver::standing_steers(double curvature) const {
    std::vector<StandingSteer> steers;
    int stop = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (i > 0 && pieces[i].direction != pieces[i - 1].direction) ++stop;
        if (std::abs(pieces[i].curvature - curvature) > same_curvature) steers.push_back({i, stop, curvature});
        curvature = pieces[i].curvature_at(pieces[i].length);
    }
    return steers;
}

double RollingManeuver::length() const {
    double sum = 0.0;
    for (const RollingPiece& piece : pieces) sum += piece.length;
    return sum;
}

Maneuver RollingManeuver::in_arcs(double most) const {
    check_between("length of an arc", most, 1e-4, 1e6, " m");
    Maneuver arcs{car, {}};
    for (const RollingPiece& piece : pieces) {
        const int parts = piece.sharpness == 0.0 ? 1 : static_cast<int>(std::ceil(piece.length / most));
        const double step = piece.length / parts;
        Pose from = piece.start;
        for (int i = 0; i < parts; ++i) {
            Move move;
            move.direction = piece.direction;
            move.steering_angle = std::clamp(angles::atan(car.wheelbase() * piece.curvature_at((i + 0.5) * step)),
                                             -car.max_steer(), car.max_steer());
            move.length = step;
            move.start = from;
            move.end = from = i + 1 == parts ? piece.end : piece.at((i + 1) * step);
            arcs.moves.push_back(move);
        }
    }
    return arcs;
}

Trajectory rolling_trajectory(const RollingManeuver& maneuver, const MotionLimits& limits) {
    constexpr double slowest = 1e-3;
    const Car& car = maneuver.car;
    Trajectory timed = trajectory(Maneuver{car, {}}, limits);  // checks the limits
    const std::vector<RollingPiece>& pieces = maneuver.pieces;
    if (pieces.empty()) return timed;
    // Squared speeds: the most on a piece, and where it starts; at stops it is 0. Backward as braking allows, forward as gaining.
    std::vector<double> most, at;
    std::vector<double> turns(pieces.size(), 0.0);  // of the steering at standstill [rad]
    for (const StandingSteer& steer : maneuver.standing_steers())
        turns[steer.piece] = angles::atan(car.wheelbase() * pieces[steer.piece].curvature) -
                             angles::atan(car.wheelbase() * steer.curvature);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double steers = car.wheelbase() * std::abs(pieces[i].sharpness);
        const double speed =
            steers * limits.speed > limits.steering_rate ? limits.steering_rate / steers : limits.speed;
        check_between("speed on a piece of the maneuver", speed, slowest, limits.speed, " m/s");
        most.push_back(speed * speed);
        const bool stops = i == 0 || pieces[i - 1].direction != pieces[i].direction || turns[i] != 0.0;
        at.push_back(stops ? 0.0 : std::min(most[i], most[i - 1]));
    }
    at.push_back(0.0);
    for (std::size_t i = pieces.size(); i-- > 0;)
        at[i] = std::min(at[i], at[i + 1] + 2.0 * limits.deceleration * pieces[i].length);
    for (std::size_t i = 0; i < pieces.size(); ++i)
        at[i + 1] = std::min(at[i + 1], at[i] + 2.0 * limits.acceleration * pieces[i].length);

    TrajectoryPoint now;
    double before = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const RollingPiece& piece = pieces[i];
        const double sign = sign_of(piece.direction);
        if (turns[i] != 0.0) {
            now.pose = piece.start;
            if (i == 0) now.direction = piece.direction;
            now.speed = now.acceleration = now.sharpness = 0.0;
            now.curvature = (i == 0 ? 0.0 : pieces[i - 1].curvature_at(pieces[i - 1].length));
            now.steering_angle = angles::atan(car.wheelbase() * now.curvature);
            now.steering_rate = turns[i] > 0.0 ? limits.steering_rate : -limits.steering_rate;
            now.distance = before;
            timed.points.push_back(now);
            now.time += std::abs(turns[i]) / limits.steering_rate;
            ++timed.standing_steers;
        }
        const double a = limits.acceleration, d = limits.deceleration;
        // v^2 + 2 a gaining = top = w^2 + 2 d losing, and both together are at most the piece.
        const double top = std::min(most[i], (2.0 * a * d * piece.length + d * at[i] + a * at[i + 1]) / (a + d));
        const double gaining = std::clamp((top - at[i]) / (2.0 * a), 0.0, piece.length);
        const double losing = std::clamp((top - at[i + 1]) / (2.0 * d), 0.0, piece.length - gaining);
        const double speed = std::sqrt(top);
        const auto leg = [&](double acceleration, double from, double to, double from_speed, double to_speed) {
            if (!(to > from)) return;
            const double seconds = 2.0 * (to - from) / (from_speed + to_speed);
            if (now.time + seconds == now.time) return;  // of rounding
            now.pose = from == 0.0 ? piece.start : piece.at(from);
            now.direction = piece.direction;
            now.speed = sign * from_speed + 0.0;  // not -0
            now.acceleration = sign * acceleration + 0.0;
            now.curvature = piece.curvature_at(from);
            now.sharpness = piece.sharpness;
            now.steering_angle = angles::atan(car.wheelbase() * now.curvature);
            const double cosine = angles::cos(now.steering_angle);
            now.steering_rate = car.wheelbase() * piece.sharpness * from_speed * cosine * cosine;
            now.distance = before + from;
            timed.points.push_back(now);
            now.time += seconds;
        };
        leg(a, 0.0, gaining, std::sqrt(at[i]), speed);
        leg(0.0, gaining, piece.length - losing, speed, speed);
        leg(-d, piece.length - losing, piece.length, speed, std::sqrt(at[i + 1]));
        before += piece.length;
    }
    now.pose = pieces.back().end;
    now.speed = now.acceleration = now.steering_rate = now.sharpness = 0.0;
    now.curvature = pieces.back().curvature_at(pieces.back().length);
    now.steering_angle = angles::atan(car.wheelbase() * now.curvature);
    now.distance = before;
    timed.points.push_back(now);
    return timed;
}

}  // namespace snug
