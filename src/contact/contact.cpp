#include "snug/contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "contact/edge.hpp"
#include "contact/parking.hpp"
#include "contact/turning.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr double touching_part = 1e-9;      ///< of the car's length: closer is touching, deeper is overlapping
constexpr double straight_bend = 1e-9;      ///< curvature below which a move starts as a straight line [1/m]
constexpr double full_circle_slack = 1e-9;  ///< how much of one is left when what touched at the start touches again

/// One move in a frame where the car turns clockwise or drives straight: the slot frame, or seen nose first.
struct PlainMove {
    Problem problem;
    Pose start;
    double forward = 1.0;    ///< 1, or -1 backward
    double curvature = 0.0;  ///< of the path, positive to the left [1/m]
};

/// A contact and when it happens, in the frame of the move.
struct Meeting {
    double distance = std::numeric_limits<double>::infinity();
    Meets meets = Meets::nothing;
    int part = 0;  ///< which corner or edge, by its index in the outline
};

const Point& corner_of(const Outline& outline, int index) { return outline.corners()[static_cast<std::size_t>(index)]; }

const Point& next_corner(const Outline& outline, int index) {
    return outline.corners()[(static_cast<std::size_t>(index) + 1) % outline.corners().size()];
}

Point outward_normal(const Outline& outline, int edge) {
    return outward(direction(corner_of(outline, edge), next_corner(outline, edge)));
}

/// An outline in the frame of the move, with the heading's direction.
struct Standing {
    Pose pose;
    double s, c;

    explicit Standing(const Pose& at) : pose(at) {
        const auto [sine, cosine] = angles::sine_cosine(at.heading);
        s = sine;
        c = cosine;
    }
    [[nodiscard]] Point turned(const Point& own) const { return {own.x * c - own.y * s, own.x * s + own.y * c}; }
    [[nodiscard]] Point at(const Point& own) const {
        const Point turned_own = turned(own);
        return {pose.x + turned_own.x, pose.y + turned_own.y};
    }
};

Point corner_met(const Problem& problem, Meets meets) {
    return meets == Meets::front_corner ? Point{0.0, -problem.front_setback}
                                        : Point{-problem.length, -problem.rear_setback};
}

Meeting first_met_straight(const PlainMove& move) {
    const Problem& problem = move.problem;
    const Standing car(move.start);
    const double dx = move.forward * car.c;
    const double dy = move.forward * car.s;
    Meeting first;
    const auto consider = [&](double gap, double closing, Meets meets, std::size_t part, auto touches_at) {
        if (!(closing > 0.0) || gap < -problem.touch) return;
        const double distance = std::max(0.0, gap / closing);
        if (distance < first.distance && touches_at(distance)) {
            first.distance = distance;
            first.meets = meets;
            first.part = static_cast<int>(part);
        }
    };
    const double front_top = -problem.front_setback;
    const double rear_top = -problem.rear_setback;
    const auto lands = [&problem](double beyond_end, double speed) {
        return beyond_end > problem.touch || (beyond_end >= -problem.touch && speed > 0.0);
    };
    const std::vector<Point>& corners = problem.body.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point point = car.at(corners[i]);
        // Touching a wall where it ends counts only for what does not slide past the end.
        const auto below = [&](double top) {
            return [&, top](double distance) {
                const double y = point.y + dy * distance - top;
                return y <= -problem.touch || (y <= problem.touch && dy < 0.0);
            };
        };
        consider(-point.x, dx, Meets::front_side, i, below(front_top));
        consider(point.x + problem.length, -dx, Meets::rear_side, i, below(rear_top));
        consider(point.y - front_top, -dy, Meets::front_top, i,
                 [&](double distance) { return lands(point.x + dx * distance, dx); });
        consider(point.y - rear_top, -dy, Meets::rear_top, i,
                 [&](double distance) { return lands(-problem.length - point.x - dx * distance, -dx); });
    }
    const std::vector<Point>& low = problem.at_curb.corners();
    for (std::size_t i = 0; i < low.size(); ++i)
        consider(car.at(low[i]).y + problem.width, -dy, Meets::curb, i, [](double) { return true; });

    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point normal = car.turned(outward_normal(problem.body, static_cast<int>(i)));
        if (!(normal.y < 0.0) || normal.x == 0.0) continue;
        const Meets meets = normal.x > 0.0 ? Meets::front_corner : Meets::rear_corner;
        const Point from = car.at(corners[i]);
        const Point to = car.at(corners[(i + 1) % corners.size()]);
        const Point fixed = corner_met(problem, meets);
        const Point way = {-normal.y, normal.x};
        const double along = (fixed.x - from.x) * way.x + (fixed.y - from.y) * way.y;
        const double length = (to.x - from.x) * way.x + (to.y - from.y) * way.y;
        const double gap = (fixed.x - from.x) * normal.x + (fixed.y - from.y) * normal.y;
        const double speed = -(dx * way.x + dy * way.y);  // of the corner, along the edge
        // At an end of the edge, does the corner move away over what comes next?
        const auto passes = [&](std::size_t neighbour) {
            const Point other = car.turned(outward_normal(problem.body, static_cast<int>(neighbour)));
            return other.x * dx + other.y * dy <= 0.0;
        };
        consider(gap, dx * normal.x + dy * normal.y, meets, i, [&](double distance) {
            const double at = along + speed * distance;
            if (at < -problem.touch || at > length + problem.touch) return false;
            if (at <= problem.touch && passes((i + corners.size() - 1) % corners.size())) return false;
            return at < length - problem.touch || !passes((i + 1) % corners.size());
        });
    }
    return first;
}

/// How the heading has turned, clockwise, from one to another. [rad]
double turned(const QuarterHeading& from, const QuarterHeading& to) {
    return (to.quarter - from.quarter) * limits::quarter_turn + angles::atan2(from.s, from.c) -
           angles::atan2(to.s, to.c);
}

struct Turning {
    TurningShape shape;
    TurningFrame frame;
    double x, y;
    QuarterHeading start;

    Turning(const PlainMove& move, double offset, double centre_x, double centre_y)
        : shape(move.problem),
          frame(move.problem, shape, offset),
          x(centre_x),
          y(centre_y),
          start(in_quarters(move.start.heading)) {
        frame.see(shape, start.quarter);
    }
};

/// The contact of a turn, and the heading there.
struct TurnMet {
    Meeting meeting;
    QuarterHeading at;
};

TurnMet first_met_turning(const PlainMove& move, Turning& turn) {
    TurningFrame& frame = turn.frame;
    QuarterHeading now = turn.start;
    int index = frame.sector_of(now);
    for (int i = 0; i <= 4 * frame.per_quarter; ++i) {
        const Sector& sector = frame.at(now.quarter, index);
        Found found;
        const Bearing first =
            first_in_sector(frame, sector, move.problem, turn.x, turn.y, now.quarter, now.c, now.s, found);
        const bool full_circle = i == 4 * frame.per_quarter && first.order() < turn.start.order() + full_circle_slack;
        if (found.meets != Meets::nothing && !full_circle) {
            const QuarterHeading at = {first.c, first.s, now.quarter};
            return {{turned(turn.start, at) / std::abs(move.curvature), found.meets, found.part}, at};
        }
        if (++index == frame.per_quarter) {
            index = 0;
            now = {0.0, 1.0, now.quarter + 1};
            frame.see(turn.shape, now.quarter);
        } else {
            now = {sector.end_c, sector.end_s, now.quarter};
        }
    }
    return {{}, {turn.start.c, turn.start.s, turn.start.quarter + 4}};
}

/// Pose after a distance, well-conditioned for every curvature.
Pose after(const PlainMove& move, double distance) {
    const double turn = move.forward * move.curvature * distance;
    const double half = turn / 2.0;
    const double chord = move.forward * distance * (std::abs(half) > 1e-8 ? angles::sin(half) / half : 1.0);
    const auto [s, c] = angles::sine_cosine(move.start.heading + half);
    return {move.start.x + chord * c, move.start.y + chord * s, move.start.heading + turn};
}

/// Newton's method on the distance between the part and what it meets: takes away the rounding of a far turning centre.
double refined(const PlainMove& move, const Meeting& meeting) {
    const Problem& problem = move.problem;
    const bool edge = meeting.meets == Meets::front_corner || meeting.meets == Meets::rear_corner;
    double distance = meeting.distance;
    for (int i = 0; i < 3; ++i) {
        const Standing car(after(move, distance));
        const double dx = move.forward * car.c;
        const double dy = move.forward * car.s;
        const double turning = move.forward * move.curvature;
        double gap = 0.0;
        double opening = 0.0;  // d gap / d distance
        if (edge) {
            const Point own_normal = outward_normal(problem.body, meeting.part);
            const Point& own = corner_of(problem.body, meeting.part);
            const Point normal = car.turned(own_normal);
            const Point fixed = corner_met(problem, meeting.meets);
            const Point seen = {fixed.x - car.pose.x, fixed.y - car.pose.y};
            gap = seen.x * normal.x + seen.y * normal.y - (own.x * own_normal.x + own.y * own_normal.y);
            opening = turning * (seen.y * normal.x - seen.x * normal.y) - (dx * normal.x + dy * normal.y);
        } else {
            const Outline& outline = meeting.meets == Meets::curb ? problem.at_curb : problem.body;
            const Point point = car.turned(corner_of(outline, meeting.part));
            switch (meeting.meets) {
                case Meets::front_side:
                    gap = -(car.pose.x + point.x);
                    opening = -(dx - turning * point.y);
                    break;
                case Meets::rear_side:
                    gap = car.pose.x + point.x + problem.length;
                    opening = dx - turning * point.y;
                    break;
                default:
                    gap = car.pose.y + point.y +
                          (meeting.meets == Meets::curb        ? problem.width
                           : meeting.meets == Meets::front_top ? problem.front_setback
                                                               : problem.rear_setback);
                    opening = dy + turning * point.x;
                    break;
            }
        }
        const double step = -gap / opening;
        if (!(std::abs(step) < 1e-3 * (1.0 + distance))) break;  // a graze: as good as it gets
        distance = std::max(0.0, distance + step);
    }
    return distance;
}

/// How far an outline at a pose is from what it could touch, and what it touches there first.
struct Apart {
    double distance;
    Meets meets;
    int part;
};

/// To a neighbour: everything to the right of the upright line through `corner` (sign 1), or to its left, below `corner`.
Apart apart_from(const Outline& body, const Standing& car, const Point& corner, double sign) {
    constexpr double far = std::numeric_limits<double>::infinity();
    const std::vector<Point>& own = body.corners();
    const Meets side = sign > 0.0 ? Meets::front_side : Meets::rear_side;
    const Meets edge = sign > 0.0 ? Meets::front_corner : Meets::rear_corner;
    double beside = far;  // of the corner farthest over the line
    double above = far;   // of the lowest
    Apart by_edge = {-far, edge, 0};
    Apart nearest = {far, side, 0};
    std::size_t foremost = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Point point = car.at(own[i]);
        const double off = sign * (corner.x - point.x);
        if (off < beside) foremost = i;
        beside = std::min(beside, off);
        above = std::min(above, point.y - corner.y);
        const double distance = angles::hypot(std::max(off, 0.0), std::max(point.y - corner.y, 0.0));
        if (distance < nearest.distance) nearest = {distance, side, static_cast<int>(i)};
        const Point normal = car.turned(outward_normal(body, static_cast<int>(i)));
        const double gap = (corner.x - point.x) * normal.x + (corner.y - point.y) * normal.y;
        if (sign * normal.x >= 0.0 && normal.y <= 0.0 && gap > by_edge.distance)
            by_edge = {gap, edge, static_cast<int>(i)};
    }
    const double apart = std::max({beside, above, by_edge.distance});
    if (apart < 0.0) {
        const bool below = car.at(own[foremost]).y < corner.y;
        if (by_edge.distance > -far && !below) return {apart, edge, by_edge.part};
        return {apart, side, static_cast<int>(foremost)};
    }
    if (by_edge.distance > 0.0) {  // the neighbour's corner may be nearer than any of the car's
        const Point from = car.at(corner_of(body, by_edge.part));
        const Point to = car.at(next_corner(body, by_edge.part));
        const Point way = {to.x - from.x, to.y - from.y};
        const double along = (corner.x - from.x) * way.x + (corner.y - from.y) * way.y;
        if (along >= 0.0 && along <= way.x * way.x + way.y * way.y && by_edge.distance < nearest.distance)
            return by_edge;
    }
    return nearest;
}

Apart apart_from_curb(const Problem& problem, const Standing& car) {
    Apart nearest = {std::numeric_limits<double>::infinity(), Meets::curb, 0};
    const std::vector<Point>& own = problem.at_curb.corners();
    for (std::size_t i = 0; i < own.size(); ++i) {
        const double distance = car.at(own[i]).y + problem.width;
        if (distance < nearest.distance) nearest = {distance, Meets::curb, static_cast<int>(i)};
    }
    return nearest;
}

/// Does some line beside or above everything keep the body out of both neighbours? Then edges need not be looked at.
bool plainly_apart(const Problem& problem, const Standing& car) {
    double right = -std::numeric_limits<double>::infinity();
    double left = -right;
    double low = -right;
    for (const Point& own : problem.body.corners()) {
        const Point point = car.at(own);
        right = std::max(right, point.x);
        left = std::min(left, point.x);
        low = std::min(low, point.y);
    }
    return (right <= problem.touch || low >= -problem.front_setback - problem.touch) &&
           (left >= -problem.length - problem.touch || low >= -problem.rear_setback - problem.touch);
}

/// What a pose that overlaps already is in contact with.
std::optional<Meeting> overlapped(const PlainMove& move) {
    const Problem& problem = move.problem;
    const Standing car(move.start);
    const Apart curb = apart_from_curb(problem, car);
    if (curb.distance >= -problem.touch && plainly_apart(problem, car)) return std::nullopt;
    for (const Apart& apart : {curb, apart_from(problem.body, car, corner_met(problem, Meets::front_corner), 1.0),
                               apart_from(problem.body, car, corner_met(problem, Meets::rear_corner), -1.0)}) {
        if (apart.distance < -problem.touch) return Meeting{0.0, apart.meets, apart.part};
    }
    return std::nullopt;
}

/// How far a car misses being parked, in the slot frame. [m, rad]
double miss(const Problem& problem, const Pose& pose) {
    const Standing car(pose);
    double worst = -std::numeric_limits<double>::infinity();
    double low = -worst;
    for (const Point& own : problem.frame.corners()) {
        const Point point = car.at(own);
        worst = std::max({worst, point.y, point.x, -problem.length - point.x});
        low = std::min(low, point.y);
    }
    if (!std::isinf(problem.parked.heading)) worst = std::max(worst, std::abs(pose.heading) - problem.parked.heading);
    return std::max(worst, low + problem.width - problem.parked.curb);
}

std::optional<Stretch> inside_turning(const PlainMove& move, const Turning& turn, const TurnMet& met) {
    const std::optional<ParkedTurn> parked =
        first_parked({&turn.frame, &move.problem, turn.x, turn.y}, turn.start, met.at, move.problem.touch);
    if (!parked) return std::nullopt;
    const double bend = std::abs(move.curvature);
    const auto distance = [&](const QuarterHeading& at) {
        return std::clamp(turned(turn.start, at) / bend, 0.0, met.meeting.distance);
    };
    return Stretch{distance(parked->from), distance(parked->to)};
}

std::optional<Stretch> inside_straight(const PlainMove& move, double end) {
    const Standing car(move.start);
    const double dx = move.forward * car.c;
    const double dy = move.forward * car.s;
    Stretch inside{0.0, end};
    const auto narrow = [&](double off, double rising) {
        if (off > move.problem.touch) {
            inside.from = rising < 0.0 ? std::max(inside.from, -off / rising) : std::numeric_limits<double>::infinity();
        } else if (rising > 0.0) {
            inside.to = std::min(inside.to, std::max(0.0, -off / rising));
        }
    };
    for (const Point& own : move.problem.frame.corners()) {
        const Point point = car.at(own);
        narrow(point.y, dy);
        if (by_height_alone(move.problem)) continue;
        narrow(point.x, dx);
        narrow(-move.problem.length - point.x, -dx);
    }
    if (!(inside.from <= inside.to) || std::isinf(inside.from)) return std::nullopt;
    return inside;
}

void check_pose(const Pose& pose) {
    check_between("pose x", pose.x, -1e9, 1e9, " m");
    check_between("pose y", pose.y, -1e9, 1e9, " m");
    check_between("pose heading", pose.heading, -1e9, 1e9, " rad");
}

}  // namespace

FirstContact first_contact(const Car& car, const Slot& slot, const Pose& pose, Direction direction,
                           double steering_angle, const Driving& driving) {
    check_between("steering angle", steering_angle, -car.max_steer(), car.max_steer(), " rad");
    check(driving);
    check_pose(pose);

    const double forward = direction == Direction::forward ? 1.0 : -1.0;
    const double curvature = angles::tan(slot.mirrored(steering_angle)) / car.wheelbase();
    // What turns counter-clockwise is looked at nose first, where it turns clockwise.
    const Enter view = forward * curvature > 0.0 ? Enter::forward : Enter::backward;
    PlainMove move = {entering_problem(car, slot, {driving.clearance, driving.curb_clearance, view}),
                      to_entering(slot, view, pose), view == Enter::forward ? -forward : forward, curvature};
    move.problem.touch = touching_part * car.length();

    const bool straight = std::abs(curvature) < straight_bend;
    std::optional<Turning> turn;
    TurnMet met{};
    if (!straight) {
        const double offset = 1.0 / curvature;
        const auto [sine, cosine] = angles::sine_cosine(move.start.heading);
        turn.emplace(move, offset, move.start.x - offset * sine, move.start.y + offset * cosine);
        met.at = turn->start;
    }
    if (const std::optional<Meeting> already = overlapped(move)) {
        met.meeting = *already;
    } else {
        if (straight) {
            met.meeting = first_met_straight(move);
        } else {
            met = first_met_turning(move, *turn);
        }
        if (met.meeting.meets != Meets::nothing && met.meeting.distance > 0.0)
            met.meeting.distance = refined(move, met.meeting);
    }

    FirstContact result;
    result.distance = met.meeting.distance;
    if (met.meeting.meets != Meets::nothing)
        result.contact = contact_of(car, slot, view, met.meeting.meets, met.meeting.part);
    result.inside = straight ? inside_straight(move, met.meeting.distance) : inside_turning(move, *turn, met);
    return result;
}

Gaps gaps(const Car& car, const Slot& slot, const Pose& pose, const Driving& driving) {
    check(driving);
    check_pose(pose);
    const Problem problem = entering_problem(car, slot, {driving.clearance, driving.curb_clearance, Enter::backward});
    const Standing at(slot.to_slot(pose));
    return {apart_from(problem.body, at, corner_met(problem, Meets::front_corner), 1.0).distance,
            apart_from(problem.body, at, corner_met(problem, Meets::rear_corner), -1.0).distance,
            apart_from_curb(problem, at).distance};
}

bool is_free(const Car& car, const Slot& slot, const Pose& pose, const Driving& driving) {
    const Gaps apart = gaps(car, slot, pose, driving);
    return std::min({apart.front, apart.rear, apart.curb}) >= -touching_part * car.length();
}

bool is_inside(const Car& car, const Slot& slot, const Pose& pose, const Parked& parked) {
    check(parked);
    check_pose(pose);
    return miss(entering_problem(car, slot, {}, parked), slot.to_slot(pose)) <= touching_part * car.length();
}

}  // namespace snug
