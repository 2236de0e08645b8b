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

constexpr double step = 0.05;                 ///< between two measurements on the way [m]
constexpr int most_moves = 300;               ///< a run that takes more is given up
constexpr int most_looks = 20;                ///< without a way, before the car calls itself stuck
constexpr int looks_before_a_way = 10;        ///< at standstill, before the next way is chosen
constexpr int looks_when_parked = 40;         ///< before the car calls itself parked
constexpr double creeping = 0.1;              ///< speed beside something [m/s]
constexpr double near_margins = 2.0;          ///< beside it is nearer than so many margins
constexpr double least_before_another = 0.2;  ///< that it rolls before it looks for another way [m]
constexpr double least_astray = 0.025;        ///< and off its way by so much, or the margin [m]
constexpr double settling = 0.7;              ///< distance in which deviations from a move die away [m]
constexpr double look_seconds = 0.1;          ///< what a look at standstill takes [s]

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
    Run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options, std::uint64_t number)
        : car_(assistant.car()),
          place_(assistant.place()),
          assistant_(&assistant),
          slots_(slots),
          options_(options),
          errors_(options.errors),
          normal_(options.seed * 0x9E3779B97F4A7C15ULL + number * 0xD1B54A32D192ED03ULL + 1),
          truth_(start),
          off_{normal_(errors_.slot_place), normal_(errors_.slot_place), normal_(errors_.slot_size),
               normal_(errors_.slot_size)},
          filter_(measured(), first_deviation(errors_)) {
        if (slots_) {
            slot_ = slot_alone(place_);
            away_ = away();
            if (away_ == 0.0) part_ = 0.0;
            looks_at_the_slot();
        }
        result_.smallest_distance = distance();
        result_.track.push_back(truth_);
    }

    DriveRun driven() {
        if (options_.blind)
            blind();
        else
            looking();
        result_.parked = !result_.contact && stands_parked(car_, place_, truth_);
        return std::move(result_);
    }

private:
    void looking() {
        int parked = 0, stuck = 0;
        for (int moves = 0; moves < most_moves && !result_.contact;) {
            stand(looks_before_a_way * look_seconds);
            looks_at_the_slot();
            const Instruction instruction = assistant_->next(filter_.pose(), last_);
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
        const std::optional<Maneuver> plan = assistant_->plan(filter_.pose());
        if (!plan) return;
        for (const Move& move : plan->moves) {
            if (result_.contact) return;
            begin(move);
            for (double done = 0.0; done < move.length && !result_.contact; done += step)
                roll(move, done, std::min(move.length - done, step), move.steering_angle, options_.limits.speed);
            come_to_rest(move.direction, move.steering_angle);
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
            // Beside something it creeps, and sees as often as at standstill.
            const bool creeps =
                nearest_distance(car_, seen_place(), filter_.pose()) < near_margins * assistant_->map().clearance();
            const double speed = creeps ? std::min(creeping, options_.limits.speed) : options_.limits.speed;
            const double ds = std::min(creeps ? creeping * look_seconds : step, std::max(move.length - progress, 1e-3));
            clear = !is_near(move.direction, steering, ds);
            if (!clear && rolled > 0.0) break;
            roll(move, progress, ds, steering, speed);
            rolled += ds;
            look();
            const Deviation off = deviation(move, progress + ds);
            progress = progress + ds + off.along;
            steering = corrected(move, off);
            // Where a corner may be off by the margin another way is better.
            const double astray = std::abs(off.left) + car_.front() * std::abs(off.heading);
            if (rolled > least_before_another && astray > std::max(assistant_->map().clearance(), least_astray)) {
                clear = false;
                break;
            }
        }
        come_to_rest(move.direction, steering);
        steering_ = steering;
        return clear && !result_.contact;
    }

    /// Stands, and turns the wheels for a move.
    void begin(const Move& move) {
        if (last_ && *last_ != move.direction) ++result_.direction_changes;
        last_ = move.direction;
        stand(std::abs(move.steering_angle - steering_) / options_.limits.steering_rate);
        if (errors_.lag > 0.0) stand(4.0 * errors_.lag);  // until they are there
        steering_ = wheels_ = move.steering_angle;
        offset_ = normal_(errors_.steering);
        const double c = std::cos(move.steering_angle);
        filter_.forget_curvature(errors_.steering / (car_.wheelbase() * c * c));
    }

    /// The wheels truly roll, and the car thinks they roll as it told them. They follow what is told as a lag of the first order does.
    void roll(const Move& move, double done, double ds, double steering, double speed) {
        const MotionLimits& limits = options_.limits;
        const double middle = done + ds / 2.0, left = std::max(move.length - middle, ds / 2.0);
        const double seconds = ds / std::min({speed, std::sqrt(2.0 * limits.acceleration * middle),
                                              std::sqrt(2.0 * limits.deceleration * left)});
        result_.seconds += seconds;
        double angle = steering;
        if (errors_.lag > 0.0) {
            const double kept = std::exp(-seconds / errors_.lag);
            angle += (wheels_ - steering) * (1.0 - kept) * errors_.lag / seconds;
            wheels_ = steering + (wheels_ - steering) * kept;
        }
        truth_ = drive(car_, truth_, move.direction, angle + offset_, ds);
        const double sign = static_cast<double>(static_cast<int>(move.direction));
        filter_.roll(sign * ds, std::tan(steering) / car_.wheelbase());
        arrived();
    }

    /// It does not stop quite where it means to.
    void come_to_rest(Direction direction, double steering) {
        if (result_.contact) return;
        const double beyond = normal_(errors_.distance);
        const Direction way = beyond >= 0.0                     ? direction
                              : direction == Direction::forward ? Direction::backward
                                                                : Direction::forward;
        truth_ = drive(car_, truth_, way, steering + offset_, std::abs(beyond));
        filter_.slip(errors_.distance, std::tan(steering) / car_.wheelbase());
        arrived();
    }

    void arrived() {
        result_.track.push_back(truth_);
        const double room = distance();
        result_.smallest_distance = std::min(result_.smallest_distance, room);
        result_.contact = result_.contact || room < 0.0;
        if (!slots_ || part_ == 0.0) return;
        const double part = std::min(part_, away() / away_);
        filter_.wander(errors_.slot_place * std::sqrt(part_ * part_ - part * part));
        part_ = part;
        seen_.reset();
    }

    /// Would the car, where it thinks it is, come nearer to something than a third of the margin?
    bool is_near(Direction direction, double steering, double ds) {
        const Pose next = drive(car_, filter_.pose(), direction, steering, ds);
        const double room = nearest_distance(car_, seen_place(), next);
        return room < assistant_->map().clearance() / 3.0 &&
               room < nearest_distance(car_, seen_place(), filter_.pose());
    }

    struct Deviation {
        double along;    ///< ahead of where the move would be
        double left;     ///< of the move, seen along its heading
        double heading;  ///< [rad]
    };
    Deviation deviation(const Move& move, double progress) const {
        const Pose planned = drive(car_, move.start, move.direction, move.steering_angle, std::max(0.0, progress));
        const Pose& at = filter_.pose();
        const double c = std::cos(planned.heading), s = std::sin(planned.heading);
        const double dx = at.x - planned.x, dy = at.y - planned.y;
        const double sign = static_cast<double>(static_cast<int>(move.direction));
        return {sign * (c * dx + s * dy), c * dy - s * dx, at.heading - planned.heading};
    }

    /// Deviations die away like the critically damped spring of that length: left'' = -left / l^2 - 2 left' / l.
    double corrected(const Move& move, const Deviation& off) const {
        const double sign = static_cast<double>(static_cast<int>(move.direction));
        const double curvature = std::tan(move.steering_angle) / car_.wheelbase() - filter_.curvature() -
                                 off.left / (settling * settling) - 2.0 * sign * off.heading / settling;
        return std::clamp(std::atan(curvature * car_.wheelbase()), -car_.max_steer(), car_.max_steer());
    }

    /// In the frame of the slot, whose place is off by less and less.
    Pose measured() {
        Pose pose = truth_;
        pose.x += errors_.bias.x + part_ * off_.x + normal_(errors_.sensing.x);
        pose.y += errors_.bias.y + part_ * off_.y + normal_(errors_.sensing.y);
        pose.heading += errors_.bias.heading + normal_(errors_.sensing.heading);
        return pose;
    }
    static Pose first_deviation(const CarErrors& errors) {
        Pose deviation = errors.sensing;
        deviation.x = std::hypot(deviation.x, errors.slot_place);
        deviation.y = std::hypot(deviation.y, errors.slot_place);
        return deviation;
    }
    /// Stands for some time. It measures all the while, unless it is blind.
    void stand(double seconds) {
        result_.seconds += seconds;
        if (options_.blind) return;
        for (double time = 0.0; time < seconds; time += look_seconds) look();
    }
    void look() { filter_.see(measured(), errors_.sensing); }

    /// Plans from now on for the slot as long and wide as it now seems; where the car would not fit, as it seemed before.
    void looks_at_the_slot() {
        if (!slots_) return;
        if (const Assistant* assistant = slots_->seen(part_ * off_.longer, part_ * off_.wider)) assistant_ = assistant;
    }
    /// As it now seems to be.
    const Place& seen_place() {
        if (!slots_) return place_;
        if (!seen_) seen_ = street_place(slots_->seeming(part_ * off_.longer, part_ * off_.wider));
        return *seen_;
    }
    /// From the car to the slot. [m]
    [[nodiscard]] double away() const { return std::max(0.0, nearest_distance(car_, *slot_, truth_)); }
    /// As if it were in the way.
    static Place slot_alone(const Place& place) {
        const PlaceObstacle slot = {std::get<ParkedInside>(place.parked()).corners};
        return Place({{slot}, place.parked(), place.region()});
    }

    [[nodiscard]] double distance() const { return nearest_distance(car_, place_, truth_); }

    const Car& car_;
    const Place& place_;  ///< as it is
    const Assistant* assistant_;
    Slots* slots_;  ///< none where the slot is seen as it is
    const DriveOptions& options_;
    const CarErrors& errors_;
    Normal normal_;
    Pose truth_;
    struct Off {
        double x, y, longer, wider;
    };
    Off off_;            ///< what the slot is off by, seen from the start [m]
    double part_ = 1.0;  ///< of that, by how near the car has been to it
    double away_ = 1.0;  ///< at the start [m]
    std::optional<Place> slot_;
    std::optional<Place> seen_;
    PoseFilter filter_;
    double steering_ = 0.0;
    double wheels_ = 0.0;
    double offset_ = 0.0;
    std::optional<Direction> last_;
    DriveRun result_;
};

}  // namespace

DriveRun drive_run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options,
                   std::uint64_t number) {
    return Run(assistant, slots, start, options, number).driven();
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
