#include "all_maneuvers/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "snug/contact.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

constexpr std::size_t most_tries = 500'000;  ///< pieces driven to see which can be spared
constexpr int most_bridges = 20'000;         ///< short cuts looked for in a round
constexpr std::size_t ways_across = 12;      ///< tried for each
constexpr int most_rounds = 4;
using limits::half_turn;
using limits::touching;  // closer to its end a move ends in contact

}  // namespace

namespace {

Car seen_entering(const Car& car, const Slot& slot, Enter enter) {
    const Car on_the_right = slot.side() == Side::left ? car.mirrored() : car;
    return enter == Enter::forward ? on_the_right.turned_about() : on_the_right;
}

Slot seen_entering(const Slot& slot, Enter enter) {
    SlotDimensions seen = slot.dimensions();
    seen.side = Side::right;
    seen.corner = {};
    seen.heading = 0.0;
    if (enter == Enter::forward) std::swap(seen.front_setback, seen.rear_setback);
    return Slot(seen);
}

Point placed(const Point& point, const Pose& pose) {
    const auto [s, c] = angles::sine_cosine(pose.heading);
    return {pose.x + point.x * c - point.y * s, pose.y + point.x * s + point.y * c};
}

}  // namespace

Ground::Ground(const Car& asked, const Slot& asked_slot, const Driving& asked_driving, const Parked& parked)
    : car(seen_entering(asked, asked_slot, asked_driving.enter)),
      slot(seen_entering(asked_slot, asked_driving.enter)),
      driving(asked_driving),
      problem(entering_problem(asked, asked_slot, asked_driving, parked)),
      side(problem.body) {}

Point Ground::front_corner(const Pose& pose) const { return placed(side.front, pose); }

FirstContact contact_on(const Ground& ground, const Pose& start, Direction direction, double steering_angle) {
    return first_contact(ground.car, ground.slot, start, direction, steering_angle, ground.driving);
}

namespace {

/// How high a point of the car comes on a move, and how low. [m]
struct Rise {
    double lowest, highest;
};
Rise rise(const Ground& ground, const Move& move, const Point& point) {
    const auto height = [&](const Pose& pose) { return placed(point, pose).y; };
    const double start = height(move.start), end = height(move.end);
    Rise rise{std::min(start, end), std::max(start, end)};
    const double curvature = angles::tan(move.steering_angle) / ground.car.wheelbase();
    if (curvature == 0.0) return rise;
    // Where its path is level: it turns with the car.
    const double turning = move.direction == Direction::forward ? curvature : -curvature;
    const double level = -angles::atan2(curvature * point.x, 1.0 - curvature * point.y) - move.start.heading;
    for (int half_turns = -3; half_turns <= 3; ++half_turns) {
        const double distance = (level + half_turns * half_turn) / turning;
        if (!(distance > 0.0 && distance < move.length)) continue;
        const double there = height(drive(ground.car, move.start, move.direction, move.steering_angle, distance));
        rise = {std::min(rise.lowest, there), std::max(rise.highest, there)};
    }
    return rise;
}

/// The way out as a polyline in characteristic coordinates: a straight segment there is an arc or a line on the road,
/// upright ones are full left, level ones full right.
struct Plan {
    Pose start;
    std::vector<LatticePath::Leg> legs;  // their points without the start of the leg
};

std::size_t piece_count(const Plan& plan) {
    std::size_t pieces = 0;
    for (const LatticePath::Leg& leg : plan.legs) pieces += leg.points.size();
    return pieces;
}

class Smoother {
public:
    Smoother(const Ground& ground, const Watch& watch)
        : ground_(ground), watch_(watch), radius_(ground.car.turning_radius()) {}

    [[nodiscard]] std::vector<Move> leaving(const LatticePath& path, Finish finish) const;

private:
    [[nodiscard]] Characteristic characteristic(const Pose& pose) const {
        const double across = radius_ * angles::sin(pose.heading);
        return {pose.x - across, pose.x + across};
    }
    /// The piece to a point, contacts not looked at; empty where no heading leads there.
    [[nodiscard]] std::optional<Move> piece(const Pose& from, Direction direction, const Characteristic& to) const;
    [[nodiscard]] bool free(const Move& move) const {
        return contact_on(ground_, move.start, move.direction, move.steering_angle).distance >= move.length;
    }
    /// Appends the pieces of a leg from the last pose on; false where one meets something.
    bool drive_leg(const LatticePath::Leg& leg, Pose& pose, std::vector<Move>& moves) const;
    /// The whole way, cut where the corner is level with p; empty unless it is free and gets out.
    [[nodiscard]] std::vector<Move> driven(const Plan& plan) const;
    /// Ends the last move where the front-right corner passes x = 0 and checks the way from there.
    [[nodiscard]] bool cut_at_p(std::vector<Move>& moves) const;
    /// Few points for a leg from here on.
    [[nodiscard]] std::optional<LatticePath::Leg> fewer_points(const LatticePath::Leg& leg, Pose pose) const;
    /// Part of a plan that is free and gets out.
    struct Piece {
        Pose start, end;
        double least = 0.0;  ///< the rest can be driven as planned from this height of its end on
    };
    /// The pieces of each leg, when the last may be so much lower.
    [[nodiscard]] std::vector<std::vector<Piece>> pieces(const Plan& plan, double spare) const;
    /// Replaces stretches of the plan by one piece or two that end high enough for all that follows.
    void straighten(Plan& plan) const;
    /// One piece from the pose, at the end of the leg's piece before `from`, to that of its piece `to`; else two by way of
    /// a point between. It ends no lower than `least` and no higher than `most`, and of several it is the highest.
    [[nodiscard]] std::optional<LatticePath::Leg> bridge(const LatticePath::Leg& leg, std::size_t from, std::size_t to,
                                                         const Pose& pose, double least, double most) const;
    void drop_points(Plan& plan) const;
    /// Full or straight steering in the place of what lies between, wherever all that follows can be driven to the same points.
    void steer_plainly(Plan& plan) const;
    /// Takes as little of something (all of it: 1) as still gets out. Returns whether the corner then passes p itself,
    /// and the plan for that.
    bool sink_to_p(Plan& plan, const std::function<Plan(double)>& less) const;
    bool shorten_last_backward(Plan& plan) const;
    bool turn_right_earlier(Plan& plan) const;
    bool start_lower(Plan& plan) const;

    const Ground& ground_;
    const Watch& watch_;
    double radius_;
};

std::optional<Move> Smoother::piece(const Pose& from, Direction direction, const Characteristic& to) const {
    const Characteristic at = characteristic(from);
    const double sign = direction == Direction::forward ? 1.0 : -1.0;
    const double along_a = std::max(0.0, sign * (to.a - at.a));
    const double along_b = std::max(0.0, sign * (to.b - at.b));
    Move move;
    move.direction = direction;
    move.start = move.end = from;
    const double negligible = 1e-12 * radius_;
    if (along_a + along_b <= negligible) return move;
    const double sine = (to.b - to.a) / (2.0 * radius_);
    if (!(std::abs(sine) < 1.0)) return std::nullopt;
    const double end = angles::asin(sine);
    if (along_a <= negligible || along_b <= negligible) {
        move.steering_angle = along_a <= negligible ? ground_.car.max_steer() : -ground_.car.max_steer();
        move.length = radius_ * std::abs(end - from.heading);
    } else {
        double curvature = (along_b - along_a) / (radius_ * (along_a + along_b));
        if (std::abs(along_b - along_a) < 1e-9 * radius_) curvature = 0.0;
        move.steering_angle = std::clamp(angles::atan(curvature * ground_.car.wheelbase()), -ground_.car.max_steer(),
                                         ground_.car.max_steer());
        const double half = curvature == 0.0 ? 0.0 : (end - from.heading) / 2.0;
        const double chord = (along_a + along_b) / (2.0 * angles::cos(from.heading + half));
        move.length = chord / (std::abs(half) > 1e-8 ? angles::sin(half) / half : 1.0);
    }
    move.end = drive(ground_.car, from, direction, move.steering_angle, move.length);
    return move;
}

bool Smoother::drive_leg(const LatticePath::Leg& leg, Pose& pose, std::vector<Move>& moves) const {
    watch_();
    for (const Characteristic& to : leg.points) {
        const std::optional<Move> move = piece(pose, leg.direction, to);
        if (!move) return false;
        if (move->length == 0.0) continue;
        if (!free(*move)) return false;
        if (leg.nose_in && rise(ground_, *move, ground_.side.rear).highest > touching) return false;
        moves.push_back(*move);
        pose = move->end;
    }
    return true;
}

bool Smoother::cut_at_p(std::vector<Move>& moves) const {
    const auto past_p = [&](const Pose& pose) { return ground_.front_corner(pose).x > 0.0; };
    while (!moves.empty() && past_p(moves.back().start)) moves.pop_back();
    if (moves.empty() || !past_p(moves.back().end)) return false;
    Move& last = moves.back();
    double before = 0.0, after = last.length;
    for (;;) {
        const double middle = before + (after - before) / 2.0;
        if (middle <= before || middle >= after) break;
        (past_p(drive(ground_.car, last.start, last.direction, last.steering_angle, middle)) ? after : before) = middle;
    }
    last.length = before;
    last.end = drive(ground_.car, last.start, last.direction, last.steering_angle, before);
    if (!(ground_.above_p(last.end) >= 0.0)) return false;
    // From here straight on, or, nose down, full left until level; no entry position is nose down.
    Pose pose = last.end;
    if (pose.heading < 0.0) {
        const double a = characteristic(pose).a;
        const std::optional<Move> level = piece(pose, Direction::forward, {a, a});
        if (!level || !free(*level)) return false;
        moves.push_back(*level);
        pose = level->end;
    }
    pose.y += touching;
    return !contact_on(ground_, pose, Direction::forward, 0.0).contact;
}

std::vector<Move> Smoother::driven(const Plan& plan) const {
    std::vector<Move> moves;
    Pose pose = plan.start;
    for (const LatticePath::Leg& leg : plan.legs)
        if (!drive_leg(leg, pose, moves)) return {};
    if (!cut_at_p(moves)) return {};
    if (ground_.driving.enter == Enter::forward && !nose_comes_out_once(ground_, moves)) return {};
    return moves;
}

std::optional<LatticePath::Leg> Smoother::fewer_points(const LatticePath::Leg& leg, Pose pose) const {
    // Full left and then full right climbs more than any other way to the same point: taken as far as it is free.
    LatticePath::Leg few = leg.with({});
    std::size_t at = 0;
    while (at + 1 < leg.points.size()) {
        std::size_t step = leg.points.size() - 1 - at;
        for (;; step = (step + 1) / 2) {
            const Characteristic& to = leg.points[at + step];
            LatticePath::Leg jump = leg.with({to});
            if (step > 1) jump.points.insert(jump.points.begin(), {characteristic(pose).a, to.b});
            Pose end = pose;
            std::vector<Move> moves;
            if (drive_leg(jump, end, moves)) {
                few.points.insert(few.points.end(), jump.points.begin(), jump.points.end());
                pose = end;
                at += step;
                break;
            }
            if (step == 1) return std::nullopt;
        }
    }
    return few;
}

std::optional<LatticePath::Leg> Smoother::bridge(const LatticePath::Leg& leg, std::size_t from, std::size_t to,
                                                 const Pose& pose, double least, double most) const {
    std::optional<LatticePath::Leg> best;
    double highest = least;
    const auto consider = [&](LatticePath::Leg way) {
        Pose end = pose;
        std::vector<Move> moves;
        if (!drive_leg(way, end, moves) || end.y < highest || end.y > most) return;
        highest = end.y;
        best = std::move(way);
    };
    consider(leg.with({leg.points[to]}));
    if (best || to - from < 2) return best;
    const std::size_t step = std::max<std::size_t>(1, (to - from) / ways_across);
    for (std::size_t by = from; by < to; by += step) consider(leg.with({leg.points[by], leg.points[to]}));
    return best;
}

std::vector<std::vector<Smoother::Piece>> Smoother::pieces(const Plan& plan, double spare) const {
    std::vector<std::vector<Piece>> all;
    Pose pose = plan.start;
    for (const LatticePath::Leg& leg : plan.legs) {
        std::vector<Piece>& pieces = all.emplace_back();
        for (const Characteristic& to : leg.points) {
            const Pose start = pose;
            if (const std::optional<Move> move = piece(start, leg.direction, to)) pose = move->end;
            pieces.push_back({start, pose});
        }
    }
    // From the last to the first: how much lower each can be driven.
    double least = pose.y - spare;
    for (std::size_t i = all.size(); i-- > 0;) {
        const LatticePath::Leg& leg = plan.legs[i];
        for (std::size_t j = leg.points.size(); j-- > 0;) {
            Piece& at = all[i][j];
            at.least = least + touching;
            double lower = std::max(0.0, at.end.y - least);
            for (; lower > touching; lower /= 4.0) {
                const std::optional<Move> move =
                    piece({at.start.x, at.start.y - lower, at.start.heading}, leg.direction, leg.points[j]);
                if (move && free(*move)) break;
            }
            least = lower > touching ? at.start.y - lower : at.start.y;
        }
    }
    return all;
}

void Smoother::straighten(Plan& plan) const {
    const std::vector<Move> whole = driven(plan);
    if (whole.empty()) return;
    const std::vector<std::vector<Piece>> planned = pieces(plan, std::max(0.0, ground_.above_p(whole.back().end)));
    Plan straight{plan.start, {}};
    Pose pose = plan.start;
    int tries = most_bridges;
    for (std::size_t i = 0; i < planned.size(); ++i) {
        const LatticePath::Leg& leg = plan.legs[i];
        LatticePath::Leg& few = straight.legs.emplace_back(leg.with({}));
        std::size_t last = leg.points.size();
        if (i + 1 == planned.size())  // the piece that passes p stays
            while (last > 0 && ground_.front_corner(planned[i][last - 1].end).x > -touching) --last;
        std::size_t step = last;
        for (std::size_t at = 0; at < leg.points.size(); at += step) {
            std::optional<LatticePath::Leg> way;
            step = at < last && tries > 0 ? std::min(2 * step, last - at) : 1;
            for (; !way && step > 1; --tries) {
                const Piece& to = planned[i][at + step - 1];
                // Nose first the car must not come out again, so it stays below the planned way.
                way = bridge(
                    leg, at, at + step - 1, pose, to.least,
                    ground_.driving.enter == Enter::forward ? to.end.y : std::numeric_limits<double>::infinity());
                if (!way) step = step > 2 ? (step + 1) / 2 : 1;
            }
            if (!way) way = leg.with({leg.points[at]});
            std::vector<Move> moves;
            if (!drive_leg(*way, pose, moves)) return;
            few.points.insert(few.points.end(), way->points.begin(), way->points.end());
        }
    }
    if (!driven(straight).empty()) plan = std::move(straight);
}

void Smoother::drop_points(Plan& plan) const {
    std::size_t tries = most_tries / std::max<std::size_t>(1, piece_count(plan));
    bool dropped = true;
    while (dropped) {
        dropped = false;
        for (LatticePath::Leg& leg : plan.legs) {
            for (std::size_t i = 0; leg.points.size() > 1 && i + 1 < leg.points.size();) {
                if (tries-- == 0) return;
                const Characteristic point = leg.points[i];
                leg.points.erase(leg.points.begin() + static_cast<std::ptrdiff_t>(i));
                if (!driven(plan).empty()) {
                    dropped = true;
                } else {
                    leg.points.insert(leg.points.begin() + static_cast<std::ptrdiff_t>(i), point);
                    ++i;
                }
            }
        }
    }
}

void Smoother::steer_plainly(Plan& plan) const {
    const double negligible = 1e-9 * radius_;
    // Two for a piece whose steering must be held between straight and full, one for another, none for none.
    const auto minds = [&](const Characteristic& from, const Characteristic& to) {
        const double along_a = std::abs(to.a - from.a), along_b = std::abs(to.b - from.b);
        if (along_a <= negligible && along_b <= negligible) return 0;
        const bool plain = along_a <= negligible || along_b <= negligible || std::abs(along_a - along_b) <= negligible;
        return plain ? 1 : 2;
    };
    const auto leads = [&](Direction direction, const Characteristic& from, const Characteristic& to) {
        const double sign = direction == Direction::forward ? 1.0 : -1.0;
        return sign * (to.a - from.a) >= 0.0 && sign * (to.b - from.b) >= 0.0;
    };
    std::size_t tries = most_tries / std::max<std::size_t>(1, piece_count(plan));
    for (bool better = true; better;) {
        better = false;
        Characteristic from = characteristic(plan.start);
        for (std::size_t i = 0; i < plan.legs.size(); ++i) {
            for (std::size_t j = 0; j < plan.legs[i].points.size(); ++j) {
                const Direction direction = plan.legs[i].direction;
                const bool ends_leg = j + 1 == plan.legs[i].points.size(), ends = ends_leg && i + 1 == plan.legs.size();
                Characteristic& point = plan.legs[i].points[j];
                const Characteristic before = point;
                const Characteristic next = ends       ? before
                                            : ends_leg ? plan.legs[i + 1].points.front()
                                                       : plan.legs[i].points[j + 1];
                const Direction after = ends_leg && !ends ? plan.legs[i + 1].direction : direction;
                const double straight_a = before.a - from.a, straight_b = before.b - from.b;
                const double both = (straight_a + straight_b) / 2.0;
                for (const Characteristic& other : {Characteristic{from.a, before.b}, Characteristic{before.a, from.b},
                                                    Characteristic{from.a + both, from.b + both},
                                                    Characteristic{from.a + straight_a, from.b + straight_a},
                                                    Characteristic{from.a + straight_b, from.b + straight_b},
                                                    Characteristic{next.a, before.b}, Characteristic{before.a, next.b},
                                                    Characteristic{from.a, next.b}, Characteristic{next.a, from.b}}) {
                    if (!leads(direction, from, other) || (!ends && !leads(after, other, next))) continue;
                    const int gain = minds(from, point) + (ends ? 0 : minds(point, next)) - minds(from, other) -
                                     (ends ? 0 : minds(other, next));
                    if (gain <= 0) continue;
                    if (tries-- == 0) return;
                    const Characteristic was = std::exchange(point, other);
                    if (driven(plan).empty()) {
                        point = was;
                    } else {
                        better = true;
                    }
                }
                from = point;
            }
        }
    }
}

bool Smoother::sink_to_p(Plan& plan, const std::function<Plan(double)>& less) const {
    double works = 1.0, fails = 0.0;
    for (int i = 0; i < 100; ++i) {
        const double middle = works + (fails - works) / 2.0;
        if (middle == works || middle == fails) break;
        (driven(less(middle)).empty() ? fails : works) = middle;
    }
    const Plan lowest = less(works);
    const std::vector<Move> moves = driven(lowest);
    if (moves.empty() || ground_.above_p(moves.back().end) > touching) return false;
    plan = lowest;
    return true;
}

bool Smoother::shorten_last_backward(Plan& plan) const {
    if (plan.legs.size() < 2) return false;
    const Plan whole = plan;
    const LatticePath::Leg& back = whole.legs[whole.legs.size() - 2];
    Pose begin = whole.start;
    std::vector<Move> moves;
    for (std::size_t i = 0; i + 2 < whole.legs.size(); ++i) drive_leg(whole.legs[i], begin, moves);
    const Characteristic from = characteristic(begin);
    return sink_to_p(plan, [&](double part) {
        Plan shorter = whole;
        LatticePath::Leg& leg = shorter.legs[whole.legs.size() - 2];
        std::vector<double> lengths;
        double left = 0.0;
        Characteristic at = from;
        for (const Characteristic& point : back.points) {
            lengths.push_back(std::abs(point.a - at.a) + std::abs(point.b - at.b));
            left += part * lengths.back();
            at = point;
        }
        at = from;
        leg.points.clear();
        for (std::size_t i = 0; i < back.points.size() && left > 0.0; ++i) {
            const double share = lengths[i] > 0.0 ? std::min(1.0, left / lengths[i]) : 1.0;
            leg.points.push_back({at.a + share * (back.points[i].a - at.a), at.b + share * (back.points[i].b - at.b)});
            left -= lengths[i];
            at = back.points[i];
        }
        const Characteristic turn = leg.points.empty() ? from : leg.points.back();
        for (Characteristic& point : shorter.legs.back().points)
            point = {std::max(point.a, turn.a), std::max(point.b, turn.b)};
        return shorter;
    });
}

bool Smoother::turn_right_earlier(Plan& plan) const {
    const Plan whole = plan;
    Pose begin = whole.start;
    std::vector<Move> moves;
    for (std::size_t i = 0; i + 1 < whole.legs.size(); ++i) drive_leg(whole.legs[i], begin, moves);
    const Characteristic from = characteristic(begin);
    const Characteristic to = whole.legs.back().points.back();
    return sink_to_p(plan, [&](double part) {
        Plan earlier = whole;
        const double rest = 1.0 - part;
        for (Characteristic& point : earlier.legs.back().points) {
            // Towards first right and then left, which climbs least.
            point.a += rest * (to.a - point.a);
            point.b += rest * (from.b - point.b);
        }
        earlier.legs.back().points.push_back(to);
        return earlier;
    });
}

bool Smoother::start_lower(Plan& plan) const {
    const Plan whole = plan;
    const std::vector<Move> moves = driven(whole);
    const double height = ground_.above_p(moves.back().end);
    return sink_to_p(plan, [&](double part) {
        Plan lower = whole;
        lower.start.y -= (1.0 - part) * 1.001 * height;
        return lower;
    });
}

std::vector<Move> Smoother::leaving(const LatticePath& path, Finish finish) const {
    if (path.legs.empty()) return {};
    const Characteristic first = path.legs.front().points.front();
    Plan plan;
    const double heading = angles::asin((first.b - first.a) / (2.0 * radius_));
    plan.start = {(first.a + first.b) / 2.0, path.z - radius_ * angles::cos(heading), heading};
    Pose pose = plan.start;
    std::vector<Move> moves;
    for (const LatticePath::Leg& leg : path.legs) {
        std::optional<LatticePath::Leg> few = fewer_points(leg, pose);
        if (!few) return {};
        drive_leg(*few, pose, moves);
        plan.legs.push_back(std::move(*few));
    }
    // The lattice may have planned for a larger frame: on until the corner is past p.
    std::vector<Characteristic>& points = plan.legs.back().points;
    if (points.empty()) points.push_back(characteristic(pose));
    const Characteristic end = points.back();
    const double short_of_p = std::max(0.0, -ground_.front_corner(pose).x) * 2.0 + 1e-3 * radius_;
    points.push_back({pose.heading >= 0.0 ? end.a + short_of_p : end.a, end.b + short_of_p});
    moves = driven(plan);
    if (finish == Finish::checked || moves.empty()) return moves;
    std::size_t before = piece_count(plan) + 1;
    for (int round = 0; round < most_rounds && piece_count(plan) < before; ++round) {
        before = piece_count(plan);
        straighten(plan);
        drop_points(plan);
    }
    if (finish == Finish::tidy) steer_plainly(plan);
    // Whoever passes above p may climb less.
    if (finish == Finish::at_p && !shorten_last_backward(plan) && !turn_right_earlier(plan)) start_lower(plan);
    return driven(plan);
}

}  // namespace

std::vector<Move> leaving_moves(const Ground& ground, const LatticePath& path, Finish finish, const Watch& watch) {
    return Smoother(ground, watch).leaving(path, finish);
}

std::vector<Move> turned_round(const std::vector<Move>& moves) {
    std::vector<Move> turned(moves.rbegin(), moves.rend());
    for (Move& move : turned) {
        move.direction = reverse_of(move.direction);
        std::swap(move.start, move.end);
    }
    return turned;
}

std::vector<Move> with_contacts(const Ground& ground, std::vector<Move> moves) {
    for (Move& move : moves) {
        const FirstContact met = contact_on(ground, move.start, move.direction, move.steering_angle);
        move.contact.reset();
        if (std::abs(met.distance - move.length) <= touching) move.contact = met.contact;
    }
    return moves;
}

bool nose_comes_out_once(const Ground& ground, const std::vector<Move>& leaving) {
    std::size_t last = leaving.size();  // move
    while (last > 0 && leaving[last - 1].direction == Direction::forward) --last;
    bool out = false;
    for (std::size_t i = 0; i < leaving.size(); ++i) {
        const Rise corner = rise(ground, leaving[i], ground.side.rear);
        if (i < last && corner.highest > touching) return false;
        if (out && corner.lowest < -touching) return false;
        const bool comes_out = placed(ground.side.rear, leaving[i].end).y > touching;
        if (!comes_out && corner.highest > touching) return false;
        out = comes_out;
    }
    return true;
}

bool ends_at_p(const Ground& ground, const std::vector<Move>& moves) {
    const Pose& end = moves.back().end;
    return angles::hypot(ground.front_corner(end).x, ground.above_p(end)) <= touching;
}

}  // namespace snug::detail
