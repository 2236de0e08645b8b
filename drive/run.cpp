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
constexpr double least_step = 0.002;          ///< while the steering turns [m]
constexpr int most_moves = 300;               ///< a run that takes more is given up
constexpr int most_work = 30'000;             ///< for another way on which the steering does not turn at standstill
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
    Run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options, std::uint64_t number,
        const RollingManeuver* plan)
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
          planned_with_(&assistant),
          filter_(measured(), first_deviation(errors_)) {
        if (slots_) {
            slot_ = slot_alone(place_);
            away_ = away();
            if (away_ == 0.0) part_ = 0.0;
            looks_at_the_slot();
        }
        if (plan) way_ = plan->pieces;
        result_.smallest_distance = distance();
        result_.track.push_back(truth_);
    }

    DriveRun driven() {
        if (options_.steer == Steer::moving)
            rolling();
        else if (options_.blind)
            blind();
        else
            looking();
        result_.parked = !result_.contact && stands_parked(car_, place_, truth_);
        return std::move(result_);
    }

private:
    struct Deviation {
        double along;    ///< ahead of where the move would be
        double left;     ///< of the move, seen along its heading
        double heading;  ///< [rad]
    };

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

    /// With steering that turns only while the car rolls: along the way planned, which is planned anew where it has come off it.
    void rolling() {
        int parked = 0, stuck = 0;
        for (int stretches = 0; stretches < most_moves && !result_.contact;) {
            stand(looks_before_a_way * look_seconds);
            if (options_.blind) {
                if (next_ == way_.size()) return;
            } else {
                looks_at_the_slot();
                const MapBounds bounds = assistant_->map().at(filter_.pose());
                if (bounds.direction_changes == 0 && !bounds.first) {
                    if (++parked == looks_when_parked / looks_before_a_way + 1) return;
                    continue;
                }
                if (!is_on_the_way() && !plans(bounds)) {
                    const Instruction instruction = assistant_->next(filter_.pose(), last_);
                    if (instruction.what != Instruction::move && instruction.what != Instruction::escape) {
                        if (++stuck == most_looks) return;
                        continue;
                    }
                    for (const Move& move : instruction.moves)
                        if (!drive_move(move)) break;
                    ++stretches;
                    continue;
                }
            }
            parked = stuck = 0;
            ++stretches;
            if (!drive_stretch()) way_.clear(), next_ = 0;
        }
    }

    /// Does it stand where the next piece begins, near enough that corrections on the way will do?
    bool is_on_the_way() const {
        if (next_ == way_.size() || planned_with_ != assistant_) return false;
        constexpr double most_along = 0.06;  // what it stops off by is little beside it [m]
        const Deviation off = deviation(way_[next_].start, way_[next_].direction);
        return std::abs(off.along) < most_along && astray(off) < most_astray();
    }
    bool plans(const MapBounds& bounds) {
        way_.clear();
        next_ = 0;
        planned_with_ = assistant_;
        if (bounds.where == MapBounds::free && bounds.first) {
            if (const auto plan = rolling_plan(assistant_->map(), filter_.pose(), steering_, options_, most_work))
                way_ = plan->pieces;
            // Where it has to steer at standstill, only until it stops: from there it may do without.
            if (!RollingManeuver{car_, way_}.standing_steers(std::tan(steering_) / car_.wheelbase()).empty())
                way_.erase(
                    std::find_if(way_.begin(), way_.end(),
                                 [&](const RollingPiece& piece) { return piece.direction != way_.front().direction; }),
                    way_.end());
        } else {
            away_with_the_wheels_as_they_are();
        }
        return !way_.empty();
    }
    /// Nearer to something than the margin: on the arc that it stands on to where the map knows a way, half of the room kept.
    void away_with_the_wheels_as_they_are() {
        constexpr double farthest = 1.0, each = 0.02;  // [m]
        const double room = nearest_distance(car_, seen_place(), filter_.pose());
        const double kept = std::min(room, assistant_->map().clearance()) / 2.0;
        double least = std::numeric_limits<double>::infinity();
        for (const Direction direction : {Direction::backward, Direction::forward}) {
            for (int i = 1; i * each <= farthest; ++i) {
                const Pose there = drive(car_, filter_.pose(), direction, steering_, i * each);
                if (nearest_distance(car_, seen_place(), there) < kept) break;
                const MapBounds bounds = assistant_->map().at(there);
                if (bounds.where != MapBounds::free || !bounds.direction_changes) continue;
                const double cost = *bounds.direction_changes +
                                    (bounds.first && *bounds.first != direction ? 1.0 : 0.0) +
                                    (last_ && *last_ != direction ? 1.0 : 0.0) + i * each;
                if (cost >= least) continue;
                least = cost;
                way_ = {{direction, std::tan(steering_) / car_.wheelbase(), 0.0, i * each, filter_.pose(), there}};
            }
        }
    }

    /// Drives the way until the direction changes or the curvature jumps: true; or something is near, or it is astray: false.
    bool drive_stretch() {
        const Direction direction = way_[next_].direction;
        if (last_ && *last_ != direction) ++result_.direction_changes;
        last_ = direction;
        // Only a jump is turned at standstill; what corrections have left is corrected on the way.
        const auto bends_apart = [](double one, double other) { return std::abs(one - other) > 1e-9; };
        const double bend = way_[next_].curvature;
        const double before =
            next_ == 0 ? std::tan(steering_) / car_.wheelbase() : way_[next_ - 1].curvature_at(way_[next_ - 1].length);
        if (bends_apart(bend, before)) turn_wheels(std::atan(bend * car_.wheelbase()));
        set_off();
        const std::size_t first = next_;
        double length = way_[next_++].length;
        for (; next_ < way_.size() && way_[next_].direction == direction &&
               !bends_apart(way_[next_].curvature, way_[next_ - 1].curvature_at(way_[next_ - 1].length));
             ++next_)
            length += way_[next_].length;
        struct On {
            const RollingPiece& piece;
            double distance;
        };
        const auto on = [&](double distance) {
            std::size_t i = first;
            for (; i + 1 < next_ && distance > way_[i].length; ++i) distance -= way_[i].length;
            return On{way_[i], std::clamp(distance, 0.0, way_[i].length)};
        };
        double progress = 0.0, rolled = 0.0;
        Deviation off = deviation(way_[first].start, direction);
        if (options_.blind)
            off = {};
        else
            progress = std::max(0.0, off.along);
        bool clear = true;
        while (progress < length && rolled < length + 4.0 * step && !result_.contact) {
            const On here = on(progress);
            const bool creeps = !options_.blind && nearest_distance(car_, seen_place(), filter_.pose()) <
                                                       near_margins * assistant_->map().clearance();
            // A part of the steering rate is left for corrections.
            constexpr double planned_part = 0.8;
            const double turns = std::abs(here.piece.sharpness) * car_.wheelbase();
            double speed = creeps ? std::min(creeping, options_.limits.speed) : options_.limits.speed;
            if (turns > 0.0) speed = std::min(speed, planned_part * options_.limits.steering_rate / turns);
            const double ds =
                std::min(std::clamp(speed * look_seconds, least_step, step), std::max(length - progress, 1e-3));
            const On there = on(progress + ds);
            const double meant = there.piece.curvature_at(there.distance);
            const double steering =
                options_.blind ? std::atan(meant * car_.wheelbase()) : corrected(direction, meant, off);
            if (!options_.blind && is_near(direction, steering, ds)) {
                clear = false;
                if (rolled > 0.0) break;
            }
            roll_and_steer(direction, progress, length, ds, steering, speed);
            rolled += ds;
            progress += ds;
            if (options_.blind) continue;
            look();
            const On now = on(progress);
            off = deviation(now.piece.at(now.distance), direction);
            progress += off.along;
            clear = clear && !(rolled > least_before_another && astray(off) > most_astray());
            if (!clear) break;
        }
        come_to_rest(direction, steering_);
        return clear && !result_.contact;
    }

    /// The wheels turn towards the steering at no more than their rate while the car rolls.
    void roll_and_steer(Direction direction, double done, double length, double ds, double steering, double speed) {
        const double seconds = ds / speed_at(done + ds / 2.0, length, ds, speed);
        result_.seconds += seconds;
        const double most = options_.limits.steering_rate * seconds;
        const double told = std::clamp(steering, steering_ - most, steering_ + most);
        const double kept = errors_.lag > 0.0 ? std::exp(-seconds / errors_.lag) : 0.0;
        const double wheels = told + (wheels_ - told) * kept;
        truth_ = drive(car_, truth_, direction, (wheels_ + wheels) / 2.0 + offset_, ds);
        const double sign = static_cast<double>(static_cast<int>(direction));
        filter_.roll(sign * ds, std::tan((steering_ + told) / 2.0) / car_.wheelbase());
        wheels_ = wheels;
        steering_ = told;
        arrived();
    }

    /// How far a corner may be off its way.
    double astray(const Deviation& off) const { return std::abs(off.left) + car_.front() * std::abs(off.heading); }
    double most_astray() const { return std::max(assistant_->map().clearance(), least_astray); }

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
            if (rolled > least_before_another && astray(off) > most_astray()) {
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
        turn_wheels(move.steering_angle);
        set_off();
    }
    /// At standstill.
    void turn_wheels(double angle) {
        if (angle != steering_) ++result_.standing_steers;
        stand(std::abs(angle - steering_) / options_.limits.steering_rate);
        if (errors_.lag > 0.0) stand(4.0 * errors_.lag);  // until they are there
        steering_ = wheels_ = angle;
    }
    /// Its steering is off by something new.
    void set_off() {
        offset_ = normal_(errors_.steering);
        const double c = std::cos(steering_);
        filter_.forget_curvature(errors_.steering / (car_.wheelbase() * c * c));
    }

    /// The wheels truly roll, and the car thinks they roll as it told them. They follow what is told as a lag of the first order does.
    void roll(const Move& move, double done, double ds, double steering, double speed) {
        const double seconds = ds / speed_at(done + ds / 2.0, move.length, ds, speed);
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

    /// From rest to rest on that length, where it has done so much of it.
    double speed_at(double done, double length, double ds, double speed) const {
        const double left = std::max(length - done, ds / 2.0);
        return std::min({speed, std::sqrt(2.0 * options_.limits.acceleration * done),
                         std::sqrt(2.0 * options_.limits.deceleration * left)});
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

    Deviation deviation(const Move& move, double progress) const {
        return deviation(drive(car_, move.start, move.direction, move.steering_angle, std::max(0.0, progress)),
                         move.direction);
    }
    Deviation deviation(const Pose& planned, Direction direction) const {
        const Pose& at = filter_.pose();
        const double c = std::cos(planned.heading), s = std::sin(planned.heading);
        const double dx = at.x - planned.x, dy = at.y - planned.y;
        const double sign = static_cast<double>(static_cast<int>(direction));
        return {sign * (c * dx + s * dy), c * dy - s * dx, at.heading - planned.heading};
    }

    double corrected(const Move& move, const Deviation& off) const {
        return corrected(move.direction, std::tan(move.steering_angle) / car_.wheelbase(), off);
    }
    /// Deviations die away like the critically damped spring of that length: left'' = -left / l^2 - 2 left' / l.
    double corrected(Direction direction, double meant, const Deviation& off) const {
        const double sign = static_cast<double>(static_cast<int>(direction));
        const double curvature =
            meant - filter_.curvature() - off.left / (settling * settling) - 2.0 * sign * off.heading / settling;
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
    std::vector<RollingPiece> way_;  ///< planned, with steering that turns only while the car rolls
    std::size_t next_ = 0;           ///< of its pieces
    const Assistant* planned_with_;  ///< on whose map
    PoseFilter filter_;
    double steering_ = 0.0;
    double wheels_ = 0.0;
    double offset_ = 0.0;
    std::optional<Direction> last_;
    DriveRun result_;
};

}  // namespace

DriveRun drive_run(const Assistant& assistant, Slots* slots, const Pose& start, const DriveOptions& options,
                   std::uint64_t number, const RollingManeuver* plan) {
    return Run(assistant, slots, start, options, number, plan).driven();
}

std::optional<RollingManeuver> rolling_plan(const ParkMap& map, const Pose& from, double steering_angle,
                                            const DriveOptions& options, int most_work) {
    RollingOptions how;
    how.steering_rate = options.limits.steering_rate;
    how.most_work = most_work;
    RollingAnswer answer = park_rolling(map, from, steering_angle, how);
    std::optional<RollingManeuver> way = answer.maneuver ? std::move(answer.maneuver) : std::move(answer.standing);
    if (!way || way->pieces.empty()) return way;
    // Holding the steering, as far as the car is parked most surely.
    constexpr double along = 0.02, across = 0.012, turned = 0.006;
    constexpr double each = 0.01, farthest = 0.3, worth_a_metre = 2.0;  // [m]; of poses that are parked
    const RollingPiece& last = way->pieces.back();
    const double bend = last.curvature_at(last.length), steering = std::atan(bend * map.car().wheelbase());
    const auto parked_about = [&](const Pose& pose) {
        const double c = std::cos(pose.heading), s = std::sin(pose.heading);
        int count = 0;
        for (const auto& [x, y, h] : {Pose{}, Pose{along, 0.0, 0.0}, Pose{-along, 0.0, 0.0}, Pose{0.0, across, 0.0},
                                      Pose{0.0, -across, 0.0}, Pose{0.0, 0.0, turned}, Pose{0.0, 0.0, -turned}}) {
            const MapBounds bounds = map.at({pose.x + x * c - y * s, pose.y + x * s + y * c, pose.heading + h});
            count += bounds.direction_changes == 0 && !bounds.first ? 1 : 0;
        }
        return count;
    };
    double best = parked_about(last.end), length = 0.0;
    for (int i = 1; i * each <= farthest; ++i) {
        const Pose there = drive(map.car(), last.end, last.direction, steering, i * each);
        const double worth = parked_about(there) - worth_a_metre * i * each;
        if (worth <= best) continue;
        if (!map.goes_free(last.end, last.direction, steering, i * each)) break;
        best = worth;
        length = i * each;
    }
    if (length > 0.0)
        way->pieces.push_back({last.direction, bend, 0.0, length, last.end,
                               drive(map.car(), last.end, last.direction, steering, length)});
    return way;
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
