// One run: what the wheels truly do, what the car thinks it does, and how it keeps to its moves.
#include "drive/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "drive/filter.hpp"
#include "snug/contact.hpp"

namespace snug {
namespace {

constexpr double step = 0.05;          ///< between two measurements on the way [m]
constexpr int most_moves = 300;        ///< a run that takes more is given up
constexpr int most_looks = 20;         ///< without a way, before the car calls itself stuck
constexpr int looks_before_a_way = 3;  ///< at standstill, before the next way is chosen
constexpr int looks_when_parked = 10;  ///< before the car calls itself parked
constexpr double settling = 0.7;       ///< distance in which deviations from a move die away [m]
constexpr double look_seconds = 0.1;   ///< what a look at standstill takes [s]

/// Normal numbers, the same on every machine whose logarithm is.
class Normal {
public:
    explicit Normal(std::uint64_t seed) : engine_(seed) {}

    double operator()(double deviation) {
        if (deviation == 0.0) return 0.0;
        const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
        return deviation * radius * std::cos(2.0 * std::numbers::pi * unit());
    }

private:
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

    std::mt19937_64 engine_;
};

class Run {
public:
    Run(const Assistant& assistant, const Pose& start, const DriveOptions& options, std::uint64_t number)
        : assistant_(assistant),
          options_(options),
          normal_(options.seed * 0x9E3779B97F4A7C15ULL + number * 0xD1B54A32D192ED03ULL + 1),
          truth_(start),
          filter_(measured(), options.errors.sensing) {
        result_.smallest_distance = distance();
        result_.track.push_back(truth_);
    }

    DriveRun driven() {
        if (options_.blind)
            blind();
        else
            looking();
        result_.parked = !result_.contact && stands_parked(assistant_.car(), assistant_.place(), truth_);
        return std::move(result_);
    }

private:
    void looking() {
        int parked = 0, stuck = 0;
        for (int moves = 0; moves < most_moves && !result_.contact;) {
            stand(looks_before_a_way * look_seconds);
            const Instruction instruction = assistant_.next(filter_.pose(), last_);
            if (instruction.what == Instruction::parked) {
                if (++parked == looks_when_parked / looks_before_a_way + 1) return;
                continue;
            }
            // What it measured cannot be: it looks again.
            if (instruction.what == Instruction::stuck || instruction.what == Instruction::overlap) {
                if (++stuck == most_looks) return;
                continue;
            }
            parked = stuck = 0;
            ++moves;
            for (const Move& move : instruction.moves)
                if (!drive_move(move)) break;
        }
    }

    void blind() {
        const std::optional<Maneuver> plan = assistant_.plan(filter_.pose());
        if (!plan) return;
        for (const Move& move : plan->moves) {
            if (result_.contact) return;
            begin(move);
            for (double left = move.length; left > 0.0 && !result_.contact; left -= step)
                roll(move.direction, move.steering_angle, std::min(left, step));
            come_to_rest(move.direction, move.steering_angle);
            result_.seconds += rolling_seconds(move.length);
        }
    }

    /// Drives a move, correcting on the way, until it is done: true; or something is near: false.
    bool drive_move(const Move& move) {
        begin(move);
        double progress = 0.0;
        double rolled = 0.0;
        double steering = move.steering_angle;
        bool clear = true;
        while (clear && progress < move.length && rolled < move.length + 4.0 * step && !result_.contact) {
            const double ds = std::min(step, std::max(move.length - progress, 1e-3));
            clear = !is_near(move.direction, steering, ds);
            if (!clear && rolled > 0.0) break;
            roll(move.direction, steering, ds);
            rolled += ds;
            look();
            const Deviation off = deviation(move, progress + ds);
            progress = progress + ds + off.along;
            steering = corrected(move, off);
        }
        come_to_rest(move.direction, steering);
        steering_ = steering;
        result_.seconds += rolling_seconds(rolled);
        return clear && !result_.contact;
    }

    /// Stands, and turns the wheels for a move.
    void begin(const Move& move) {
        if (last_ && *last_ != move.direction) ++result_.direction_changes;
        last_ = move.direction;
        stand(std::abs(move.steering_angle - steering_) / options_.limits.steering_rate);
        steering_ = move.steering_angle;
        offset_ = normal_(options_.errors.steering);
        const double c = std::cos(move.steering_angle);
        filter_.forget_curvature(options_.errors.steering / (assistant_.car().wheelbase() * c * c));
    }

    /// The wheels truly roll, and the car thinks they roll as it told them.
    void roll(Direction direction, double steering, double ds) {
        truth_ = drive(assistant_.car(), truth_, direction, steering + offset_, ds);
        const double sign = static_cast<double>(static_cast<int>(direction));
        filter_.roll(sign * ds, std::tan(steering) / assistant_.car().wheelbase());
        result_.track.push_back(truth_);
        const double room = distance();
        result_.smallest_distance = std::min(result_.smallest_distance, room);
        result_.contact = result_.contact || room < 0.0;
    }

    /// It does not stop quite where it means to.
    void come_to_rest(Direction direction, double steering) {
        if (result_.contact) return;
        const double beyond = normal_(options_.errors.distance);
        const Direction way = beyond >= 0.0                     ? direction
                              : direction == Direction::forward ? Direction::backward
                                                                : Direction::forward;
        truth_ = drive(assistant_.car(), truth_, way, steering + offset_, std::abs(beyond));
        filter_.slip(options_.errors.distance);
        result_.track.push_back(truth_);
        const double room = distance();
        result_.smallest_distance = std::min(result_.smallest_distance, room);
        result_.contact = room < 0.0;
    }

    /// Would the car, where it thinks it is, come nearer to something than a third of the margin?
    bool is_near(Direction direction, double steering, double ds) const {
        const Pose next = drive(assistant_.car(), filter_.pose(), direction, steering, ds);
        const double room = nearest_distance(assistant_.car(), assistant_.place(), next);
        return room < assistant_.map().clearance() / 3.0 &&
               room < nearest_distance(assistant_.car(), assistant_.place(), filter_.pose());
    }

    struct Deviation {
        double along;    ///< ahead of where the move would be
        double left;     ///< of the move, seen along its heading
        double heading;  ///< [rad]
    };
    Deviation deviation(const Move& move, double progress) const {
        const Pose planned =
            drive(assistant_.car(), move.start, move.direction, move.steering_angle, std::max(0.0, progress));
        const Pose& at = filter_.pose();
        const double c = std::cos(planned.heading), s = std::sin(planned.heading);
        const double dx = at.x - planned.x, dy = at.y - planned.y;
        const double sign = static_cast<double>(static_cast<int>(move.direction));
        return {sign * (c * dx + s * dy), c * dy - s * dx, at.heading - planned.heading};
    }

    /// Deviations die away like the critically damped spring of that length: left'' = -left / l^2 - 2 left' / l.
    double corrected(const Move& move, const Deviation& off) const {
        const double sign = static_cast<double>(static_cast<int>(move.direction));
        const double wheelbase = assistant_.car().wheelbase();
        const double curvature = std::tan(move.steering_angle) / wheelbase - filter_.curvature() -
                                 off.left / (settling * settling) - 2.0 * sign * off.heading / settling;
        const double most = assistant_.car().max_steer();
        return std::clamp(std::atan(curvature * wheelbase), -most, most);
    }

    Pose measured() {
        const CarErrors& errors = options_.errors;
        Pose pose = truth_;
        pose.x += errors.bias.x + normal_(errors.sensing.x);
        pose.y += errors.bias.y + normal_(errors.sensing.y);
        pose.heading += errors.bias.heading + normal_(errors.sensing.heading);
        return pose;
    }
    /// Measures all the while, unless it is blind.
    void stand(double seconds) {
        result_.seconds += seconds;
        if (options_.blind) return;
        for (double time = 0.0; time < seconds; time += look_seconds) look();
    }
    void look() { filter_.see(measured(), options_.errors.sensing); }

    [[nodiscard]] double distance() const { return nearest_distance(assistant_.car(), assistant_.place(), truth_); }
    [[nodiscard]] double rolling_seconds(double length) const {
        if (length <= 0.0) return 0.0;
        Move move;
        move.direction = Direction::forward;
        move.length = length;
        return trajectory({assistant_.car(), {move}}, options_.limits).seconds();
    }

    const Assistant& assistant_;
    const DriveOptions& options_;
    Normal normal_;
    Pose truth_;
    PoseFilter filter_;
    double steering_ = 0.0;
    double offset_ = 0.0;
    std::optional<Direction> last_;
    DriveRun result_;
};

}  // namespace

DriveRun drive_run(const Assistant& assistant, const Pose& start, const DriveOptions& options, std::uint64_t number) {
    return Run(assistant, start, options, number).driven();
}

double nearest_distance(const Car& car, const Place& place, const Pose& pose) {
    double least = std::numeric_limits<double>::infinity();
    for (const PlaceGap& gap : gaps(car, place, pose)) least = std::min(least, gap.distance);
    return least;
}

bool stands_parked(const Car& car, const Place& place, const Pose& pose) {
    constexpr double touch = 1e-9;
    const auto round = [](double angle) { return std::abs(std::remainder(angle, 2.0 * std::numbers::pi)); };
    if (const auto* at = std::get_if<ParkedAt>(&place.parked())) {
        const double c = std::cos(at->pose.heading), s = std::sin(at->pose.heading);
        const double dx = pose.x - at->pose.x, dy = pose.y - at->pose.y;
        return std::abs(c * dx + s * dy) <= at->along + touch && std::abs(c * dy - s * dx) <= at->across + touch &&
               round(pose.heading - at->pose.heading) <= at->heading + touch;
    }
    const auto& inside = std::get<ParkedInside>(place.parked());
    if (round(pose.heading - inside.heading) > inside.heading_tolerance + touch) return false;
    const std::vector<Point>& corners = inside.corners;
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        area += a.x * b.y - a.y * b.x;
    }
    const double turn = area > 0.0 ? 1.0 : -1.0;
    double beside = std::numeric_limits<double>::infinity();
    for (const Point& p : frame(car, pose)) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            if (turn * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) < -touch * length) return false;
        }
        if (inside.beside) {
            const Point &a = inside.beside->from, &b = inside.beside->to;
            const double length = std::hypot(b.x - a.x, b.y - a.y);
            beside = std::min(beside, std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length);
        }
    }
    return !inside.beside || beside <= inside.beside->distance + touch;
}

}  // namespace snug
