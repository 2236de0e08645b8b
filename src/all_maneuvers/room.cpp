#include "all_maneuvers/room.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/angles.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

/// How far the outline reaches at a heading, along the slot and across it, from what touches the curb to its highest point.
struct Reach {
    double along, across;

    Reach(const Problem& problem, double sine, double cosine) {
        double front = -1e9, rear = -1e9, top = -1e9, below = -1e9;
        for (const Point& corner : problem.frame.corners()) {
            front = std::max(front, corner.x * cosine - corner.y * sine);
            rear = std::max(rear, corner.y * sine - corner.x * cosine);
            top = std::max(top, corner.x * sine + corner.y * cosine);
        }
        for (const Point& corner : problem.at_curb.corners())
            below = std::max(below, -(corner.x * sine + corner.y * cosine));
        along = front + rear;
        across = top + below;
    }
};

/// Whether the slot may hold the car at another heading than parallel. Between two headings at which a lower or an upper edge
/// lies level, how far the car reaches across is a cosine, greater than at one of the two: so only those are looked at.
bool may_stand_tilted(const Problem& problem, double width) {
    const auto fits = [&](double sine, double cosine) {
        return std::abs(sine) > 1e-12 && Reach(problem, sine, cosine).across <= width;
    };
    if (fits(1.0, 0.0) || fits(-1.0, 0.0)) return true;
    for (const Outline* outline : {&problem.frame, &problem.at_curb}) {
        const std::vector<Point>& corners = outline->corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point& from = corners[i];
            const Point& to = corners[(i + 1) % corners.size()];
            const double edge = angles::hypot(to.x - from.x, to.y - from.y);
            const double sign = to.x >= from.x ? 1.0 : -1.0;  // at most a quarter turn
            if (fits(-sign * (to.y - from.y) / edge, sign * (to.x - from.x) / edge)) return true;
        }
    }
    return false;
}

bool begins_at_entry_side(const Problem& problem) {
    return problem.front_setback == 0.0 && problem.rear_setback == 0.0;
}

}  // namespace

bool has_room(const Ground& ground, double length, double width) {
    const Problem& problem = ground.problem;
    const Reach parallel(problem, 0.0, 1.0);
    const Car& car = ground.car;
    if (width < parallel.across || (width == parallel.across && never_turns(problem)))
        return may_stand_tilted(problem, width);
    if (!car.is_rectangle() || !begins_at_entry_side(problem)) return true;
    const double least_length = problem.body.front() + problem.body.rear();
    if (length > least_length || (length == least_length && (!never_turns(problem) || car.length() <= car.width())))
        return true;
    // Least heading at which it is so short.
    const double tilt = 2.0 * angles::atan((problem.body.left() + problem.body.right()) / least_length);
    const double height = car.length() * angles::sin(tilt) + car.width() * angles::cos(tilt);
    return width >= std::min(height, car.length()) + (parallel.across - car.width());
}

double shorter_than_any(const Ground& ground, double width) {
    constexpr double least = limits::shortest;
    if (!has_room(ground, least, width)) return ground.problem.body.front() + ground.problem.body.rear();
    double narrowest = ground.car.length();  // of all directions from which the outline is looked at
    const std::vector<Point>& corners = ground.problem.frame.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        const double edge = angles::hypot(to.x - from.x, to.y - from.y);
        narrowest = std::min(narrowest, Reach(ground.problem, (to.x - from.x) / edge, (to.y - from.y) / edge).along);
    }
    return std::max(least, narrowest * (1.0 - 1e-12));
}

double narrower_than_any(const Ground& ground) {
    const double parallel = Reach(ground.problem, 0.0, 1.0).across * (1.0 - 1e-12);
    const double deepest = std::max(ground.problem.front_setback, ground.problem.rear_setback);
    const double least = may_stand_tilted(ground.problem, parallel) ? limits::shortest : parallel;
    return std::max(least, deepest);
}

bool is_plain(const Ground& ground) {
    return ground.car.is_rectangle() && begins_at_entry_side(ground.problem) && ground.slot.curb() == Curb::high;
}

LeavingQuestion entering_question(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked) {
    return {Ground(car, slot, driving, parked), [](Heights& heights) { heights.start_parked(); }};
}

}  // namespace snug::detail
