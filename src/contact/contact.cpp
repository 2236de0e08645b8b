#include "snug/contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "contact/turning.hpp"
#include "model/angles.hpp"
#include "model/check.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr double quarter_turn = 1.57079632679489661923;
constexpr double touching_part = 1e-9;      ///< of the car's length: closer is touching, deeper is overlapping
constexpr double straight_bend = 1e-9;      ///< curvature below which a move starts as a straight line [1/m]
constexpr std::size_t quarters_around = 5;  ///< a full circle touches that many quarter turns
constexpr double full_circle_slack = 1e-9;  ///< how much of one is left when what touched at the start touches again

/// One move in a frame where the car turns clockwise or drives straight: the slot frame or its mirror image in x.
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
    int quarter = 0;
};

QuarterHeading in_quarters(double heading) {
    const double quarter = std::floor(heading / quarter_turn);
    const double within = std::max(0.0, heading - quarter * quarter_turn);
    const auto [s, c] = angles::sine_cosine(within);
    return {std::max(0.0, c), s, static_cast<int>(-quarter)};
}

const QuarterFrame& frame_of(const TurningFrame& frames, int quarter) {
    return frames[static_cast<std::size_t>(quarter & 3)];
}

/// A point of the frame or the slot, moving along a line while the car drives straight.
struct Sliding {
    double x, y;    // at the start
    double dx, dy;  // per metre
};

Meeting first_met_straight(const PlainMove& move, const TurningFrame& frames) {
    const Problem& problem = move.problem;
    const QuarterHeading now = in_quarters(move.start.heading);
    const QuarterFrame& frame = frame_of(frames, now.quarter);
    const auto [sine, cosine] = angles::sine_cosine(move.start.heading);
    const double dx = move.forward * cosine;
    const double dy = move.forward * sine;
    Meeting first;
    first.quarter = now.quarter;
    const auto consider = [&](double gap, double closing, Meets meets, auto touches_at) {
        if (!(closing > 0.0) || gap < -problem.touch) return;
        const double distance = std::max(0.0, gap / closing);
        if (distance < first.distance && touches_at(distance)) {
            first.distance = distance;
            first.meets = meets;
        }
    };
    const auto corner = [&](const TurningCorner& of) {
        return Sliding{move.start.x + of.x * now.c - of.y * now.s, move.start.y + of.x * now.s + of.y * now.c, dx, dy};
    };
    const Sliding right = corner(frame.rightmost);
    const Sliding left = corner(frame.leftmost);
    const Sliding low = corner(frame.lowest);
    // Touching a wall where it ends counts only for what does not slide past the end.
    const auto beside = [&](const Sliding& point) {
        return [&point, &problem](double distance) {
            const double y = point.y + point.dy * distance;
            return y <= -problem.touch || (y <= problem.touch && point.dy < 0.0);
        };
    };
    consider(-right.x, dx, Meets::front_side, beside(right));
    consider(left.x + problem.length, -dx, Meets::rear_side, beside(left));
    consider(low.y + problem.width, -dy, Meets::curb, [](double) { return true; });
    const auto lands = [&problem](double beyond_end, double speed) {
        return beyond_end > problem.touch || (beyond_end >= -problem.touch && speed > 0.0);
    };
    consider(low.y, -dy, Meets::front_top, [&](double distance) { return lands(low.x + dx * distance, dx); });
    consider(low.y, -dy, Meets::rear_top,
             [&](double distance) { return lands(-problem.length - low.x - dx * distance, -dx); });

    const auto seen = [&](double x) {  // a slot corner at (x, 0) seen from the car
        const double gx = x - move.start.x;
        const double gy = -move.start.y;
        return Sliding{gx * now.c + gy * now.s, gy * now.c - gx * now.s, -(dx * now.c + dy * now.s),
                       -(dy * now.c - dx * now.s)};
    };
    const auto between = [&](double at, double speed, double low_end, double high_end) {
        return (at > low_end + problem.touch || (at >= low_end - problem.touch && speed > 0.0)) &&
               (at < high_end - problem.touch || (at <= high_end + problem.touch && speed < 0.0));
    };
    const Sliding front = seen(0.0);
    consider(frame.lowest.y - front.y, front.dy, Meets::front_corner, [&](double distance) {
        return between(front.x + front.dx * distance, front.dx, frame.lowest.x, frame.rightmost.x);
    });
    const Sliding rear = seen(-problem.length);
    consider(frame.lowest.x - rear.x, rear.dx, Meets::rear_corner, [&](double distance) {
        return between(rear.y + rear.dy * distance, rear.dy, frame.lowest.y, frame.leftmost.y);
    });
    return first;
}

Meeting first_met_turning(const PlainMove& move, const TurningFrame& frames, double centre_x, double centre_y) {
    const QuarterHeading start = in_quarters(move.start.heading);
    QuarterHeading now = start;
    for (std::size_t i = 0; i < quarters_around; ++i) {
        const QuarterContact contact =
            first_contact_in_quarter(frame_of(frames, now.quarter), centre_x, centre_y, move.problem, now.c, now.s);
        const bool full_circle = i + 1 == quarters_around && contact.order < start.order() + full_circle_slack;
        if (contact.meets != Meets::nothing && !full_circle) {
            const double turned = (now.quarter - start.quarter) * quarter_turn + angles::atan2(start.s, start.c) -
                                  angles::atan2(contact.s, contact.c);
            return {turned / std::abs(move.curvature), contact.meets, now.quarter};
        }
        now = {0.0, 1.0, now.quarter + 1};
    }
    return {};
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
double refined(const PlainMove& move, const TurningFrame& frames, const Meeting& meeting) {
    const QuarterFrame& frame = frame_of(frames, meeting.quarter);
    double distance = meeting.distance;
    for (int i = 0; i < 3; ++i) {
        const Pose pose = after(move, distance);
        const double within = pose.heading + meeting.quarter * quarter_turn;
        const auto [s, c] = angles::sine_cosine(within);
        const auto [sine, cosine] = angles::sine_cosine(pose.heading);
        const double dx = move.forward * cosine;
        const double dy = move.forward * sine;
        const double turning = move.forward * move.curvature;
        double gap = 0.0;
        double opening = 0.0;  // d gap / d distance
        if (meeting.meets == Meets::front_corner || meeting.meets == Meets::rear_corner) {
            const bool front = meeting.meets == Meets::front_corner;
            const double gx = (front ? 0.0 : -move.problem.length) - pose.x;
            const double gy = -pose.y;
            const double x = gx * c + gy * s;
            const double y = gy * c - gx * s;
            gap = front ? frame.lowest.y - y : frame.lowest.x - x;
            opening = front ? (dy * c - dx * s) + turning * x : (dx * c + dy * s) - turning * y;
        } else {
            const TurningCorner& corner = meeting.meets == Meets::front_side  ? frame.rightmost
                                          : meeting.meets == Meets::rear_side ? frame.leftmost
                                                                              : frame.lowest;
            const double x = corner.x * c - corner.y * s;
            const double y = corner.x * s + corner.y * c;
            switch (meeting.meets) {
                case Meets::front_side:
                    gap = -(pose.x + x);
                    opening = -(dx - turning * y);
                    break;
                case Meets::rear_side:
                    gap = pose.x + x + move.problem.length;
                    opening = dx - turning * y;
                    break;
                default:
                    gap = pose.y + y + (meeting.meets == Meets::curb ? move.problem.width : 0.0);
                    opening = dy + turning * x;
                    break;
            }
        }
        const double step = -gap / opening;
        if (!(std::abs(step) < 1e-3 * (1.0 + distance))) break;  // a graze: as good as it gets
        distance = std::max(0.0, distance + step);
    }
    return distance;
}

/// Lowest point of the frame to the right of an upright line (sign 1) or to its left (sign -1); infinity if there is none.
double lowest_beyond(const std::array<Point, 4>& corners, double line, double sign) {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        const double before = sign * (from.x - line);
        const double after = sign * (to.x - line);
        if (before > 0.0) lowest = std::min(lowest, from.y);
        if ((before > 0.0) != (after > 0.0))
            lowest = std::min(lowest, from.y + (to.y - from.y) * (before / (before - after)));
    }
    return lowest;
}

/// What a pose that overlaps already is in contact with.
std::optional<Meeting> overlapped(const PlainMove& move, const TurningFrame& frames) {
    const QuarterHeading now = in_quarters(move.start.heading);
    const QuarterFrame& frame = frame_of(frames, now.quarter);
    const Problem& problem = move.problem;
    const auto at = [&](double x, double y) {
        return Point{move.start.x + x * now.c - y * now.s, move.start.y + x * now.s + y * now.c};
    };
    const std::array<Point, 4> corners = {at(frame.lowest.x, frame.lowest.y), at(frame.rightmost.x, frame.rightmost.y),
                                          at(frame.rightmost.x, frame.leftmost.y),
                                          at(frame.leftmost.x, frame.leftmost.y)};
    if (corners[0].y < -problem.width - problem.touch) return Meeting{0.0, Meets::curb, now.quarter};
    if (lowest_beyond(corners, problem.touch, 1.0) < -problem.touch)
        return Meeting{0.0, corners[1].y < 0.0 ? Meets::front_side : Meets::front_corner, now.quarter};
    if (lowest_beyond(corners, -problem.length - problem.touch, -1.0) < -problem.touch)
        return Meeting{0.0, corners[3].y < 0.0 ? Meets::rear_side : Meets::rear_corner, now.quarter};
    return std::nullopt;
}

/// First stretch with the highest corner at or below the entry side, up to `end`. Between the corners of two quarter
/// turns its height only rises and then falls, so it is inside from the start to a first crossing, or from a second one.
std::optional<Stretch> inside_turning(const PlainMove& move, const TurningFrame& frames, double y, double end) {
    const QuarterHeading start = in_quarters(move.start.heading);
    const double bend = std::abs(move.curvature);
    const double start_angle = angles::atan2(start.s, start.c);
    const auto distance_to = [&](double c, double s, int quarter) {
        return ((quarter - start.quarter) * quarter_turn + start_angle - angles::atan2(s, c)) / bend;
    };
    std::optional<Stretch> inside;
    QuarterHeading now = start;
    for (std::size_t i = 0; i < quarters_around; ++i) {
        const QuarterFrame& frame = frame_of(frames, now.quarter);
        const TurningCorner& top = frame.top;
        const double begin = distance_to(now.c, now.s, now.quarter);
        if (begin > end) break;
        const double finish = std::min(end, distance_to(1.0, 0.0, now.quarter));
        const double square = (top.radius - y) * (top.radius + y);
        const auto crossing = [&](double along) {
            return distance_to((along * top.x - y * top.y) * top.per_square,
                               (-y * top.x - along * top.y) * top.per_square, now.quarter);
        };
        const double rises = square >= 0.0 ? crossing(-std::sqrt(square)) : begin - 1.0;
        const double sinks = square >= 0.0 ? crossing(std::sqrt(square)) : begin - 1.0;
        if (!inside && top_height(frame, y, now.c, now.s) <= move.problem.touch) inside = Stretch{begin, begin};
        if (inside) {
            if (rises >= begin && rises < finish) return Stretch{inside->from, rises};
            inside->to = finish;
        } else if (square >= 0.0 && sinks >= begin && sinks <= finish) {
            inside = Stretch{sinks, finish};
        }
        now = {0.0, 1.0, now.quarter + 1};
    }
    return inside;
}

std::optional<Stretch> inside_straight(const PlainMove& move, const TurningFrame& frames, double end) {
    const QuarterHeading now = in_quarters(move.start.heading);
    const QuarterFrame& frame = frame_of(frames, now.quarter);
    const double height = top_height(frame, move.start.y, now.c, now.s);
    const double rising = move.forward * angles::sin(move.start.heading);
    const double crossing = -height / rising;
    Stretch inside{0.0, end};
    if (height > move.problem.touch) {
        if (!(rising < 0.0)) return std::nullopt;
        inside.from = crossing;
    } else if (rising > 0.0) {
        inside.to = std::min(end, std::max(0.0, crossing));
    }
    if (inside.from > end) return std::nullopt;
    return inside;
}

Contact mirrored_in_x(const Contact& contact) {
    constexpr auto other_end = [](Obstacle obstacle) {
        switch (obstacle) {
            case Obstacle::front_side: return Obstacle::rear_side;
            case Obstacle::rear_side: return Obstacle::front_side;
            case Obstacle::front_corner: return Obstacle::rear_corner;
            case Obstacle::rear_corner: return Obstacle::front_corner;
            default: return Obstacle::curb;
        }
    };
    return {mirrored(contact.part), other_end(contact.obstacle)};
}

}  // namespace

FirstContact first_contact(const Car& car, const Slot& slot, const Pose& pose, Direction direction,
                           double steering_angle, double clearance) {
    check_between("steering angle", steering_angle, -car.max_steer(), car.max_steer(), " rad");
    check_between("clearance", clearance, 0.0, 1e6, " m");
    check_between("pose x", pose.x, -1e9, 1e9, " m");
    check_between("pose y", pose.y, -1e9, 1e9, " m");
    check_between("pose heading", pose.heading, -1e9, 1e9, " rad");

    PlainMove move{entering_problem(car, slot, {.clearance = clearance}), {}};
    move.problem.touch = touching_part * car.length();
    move.start = slot.to_slot(pose);
    move.forward = direction == Direction::forward ? 1.0 : -1.0;
    move.curvature = angles::tan(slot.mirrored(steering_angle)) / car.wheelbase();
    const bool turn_round = move.forward * move.curvature > 0.0;  // counter-clockwise: look at it in a mirror
    if (turn_round) {
        move.start = {-slot.length() - move.start.x, move.start.y, 2.0 * quarter_turn - move.start.heading};
        move.curvature = -move.curvature;
    }
    const TurningFrame about_axle = turning_frame(move.problem.body, move.problem.frame, 0.0);
    const bool straight = std::abs(move.curvature) < straight_bend;
    const double offset = straight ? 0.0 : 1.0 / move.curvature;
    const TurningFrame frames = straight ? about_axle : turning_frame(move.problem.body, move.problem.frame, offset);
    const auto [sine, cosine] = angles::sine_cosine(move.start.heading);
    const double centre_x = move.start.x - offset * sine;
    const double centre_y = move.start.y + offset * cosine;

    Meeting met;
    if (const std::optional<Meeting> already = overlapped(move, about_axle)) {
        met = *already;
    } else {
        met = straight ? first_met_straight(move, frames) : first_met_turning(move, frames, centre_x, centre_y);
        if (met.meets != Meets::nothing && met.distance > 0.0) met.distance = refined(move, about_axle, met);
    }

    FirstContact result;
    result.distance = met.distance;
    if (met.meets != Meets::nothing) {
        Contact contact = contact_of(met.meets, met.quarter);
        if (turn_round) contact = mirrored_in_x(contact);
        if (slot.side() == Side::left) contact.part = mirrored(contact.part);
        result.contact = contact;
    }
    result.inside =
        straight ? inside_straight(move, frames, met.distance) : inside_turning(move, frames, centre_y, met.distance);
    return result;
}

}  // namespace snug
