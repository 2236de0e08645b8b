#include "snug/leave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "all_maneuvers/search.hpp"
#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr double full_turn = 6.28318530717958647693;
constexpr double most_tilted = 1.2;  ///< the lattices leave out headings next to upright [rad]

Box box_of(const std::vector<Point>& corners) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{infinity, -infinity, infinity, -infinity};
    for (const Point& corner : corners) {
        box.x_min = std::min(box.x_min, corner.x);
        box.x_max = std::max(box.x_max, corner.x);
        box.y_min = std::min(box.y_min, corner.y);
        box.y_max = std::max(box.y_max, corner.y);
    }
    return box;
}

/// Of what is below that height.
Box box_below(const std::vector<Point>& corners, double height) {
    std::vector<Point> below;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& from = corners[i];
        const Point& to = corners[(i + 1) % corners.size()];
        if (from.y <= height) below.push_back(from);
        if ((from.y <= height) == (to.y <= height)) continue;
        below.push_back({from.x + (to.x - from.x) * ((height - from.y) / (to.y - from.y)), height});
    }
    return box_of(below);
}

/// Flush with the curb and parallel: turning takes a corner into the curb at once, but driving raises the car only as
/// it has turned, so it can never begin (docs/fewest.md).
bool flush_with_curb(const Ground& ground, const Pose& pose, double rounding) {
    const double gap = box_of(placed(ground.problem.at_curb, pose)).y_min + ground.problem.width;
    return std::abs(pose.heading) <= rounding && gap <= rounding * ground.car.length() && never_turns(ground.problem);
}

void check_parked(const Ground& ground, const Pose& pose) {
    if (!(std::abs(pose.heading) <= most_tilted))
        throw Error("the car is parked " + spelled(std::abs(pose.heading)) +
                    " rad off the slot's heading, but must be at most " + spelled(most_tilted) + " rad off");
    const double rounding = 1e-9 * ground.car.length();
    const Problem& problem = ground.problem;
    const std::vector<Point> body = placed(problem.body, pose);
    const Box frame = box_of(placed(problem.frame, pose));
    const double out = std::max({frame.y_max, frame.x_max, -problem.length - frame.x_min,
                                 box_below(body, -problem.front_setback).x_max,
                                 -problem.length - box_below(body, -problem.rear_setback).x_min,
                                 -problem.width - box_of(placed(problem.at_curb, pose)).y_min});
    if (out > rounding)
        throw Error("the parked car sticks " + spelled(out) + " m out of the slot" +
                    (ground.driving.clearance > 0.0 || ground.driving.at_curb() > 0.0 ? " or into its clearance" : "") +
                    ", but must be inside");
}

}  // namespace

Pose parked_pose(const Car& car, const Slot& slot, const ParkedGaps& gaps) {
    check_between("gap to the front neighbour", gaps.front, 0.0, 1e6, " m");
    check_between("gap to the curb", gaps.curb, 0.0, 1e6, " m");
    check_between("heading of the parked car", gaps.heading, -1e9, 1e9, " rad");
    // Where the slot is on the left, its frame is the world's mirror image.
    const Box box = box_of(frame(slot.side() == Side::left ? car.mirrored() : car, {0.0, 0.0, gaps.heading}));
    return slot.to_world(Pose{-gaps.front - box.x_max, gaps.curb - slot.width() - box.y_min, gaps.heading});
}

Answer leave(const Car& car, const Slot& slot, const Pose& pose, const FewestOptions& options) {
    check(options);
    for (const double value : {pose.x, pose.y, pose.heading})
        check_between("pose of the parked car", value, -1e9, 1e9, "");
    const Ground ground(car, slot, options.driving);
    Pose start = slot.to_slot(pose);
    start.heading = std::remainder(start.heading, full_turn);
    if (options.driving.enter == Enter::forward) start = {-slot.length() - start.x, start.y, -start.heading};
    check_parked(ground, start);

    // What bringing the pose into the slot's frame may do to it.
    const double rounding = 1e-14 * (1.0 + (std::abs(pose.x) + std::abs(pose.y)) / car.length());
    if (flush_with_curb(ground, start, rounding)) return impossible(options.max_changes);

    const double radius = car.turning_radius();
    // Above what rounding may have put into the curb.
    const double z = start.y + radius * angles::cos(start.heading) + 1e-10 * car.length();
    const LeavingQuestion question{ground,
                                   [z](Heights& heights) { heights.start_at(0, 0, z); },
                                   {start.x, angles::sin(start.heading)},
                                   options.max_changes,
                                   options.resolution,
                                   Finish::tidy};
    LeavingBounds bounds;
    std::vector<Move> at_hand;
    const Watch watch = watch_of(options, bounds);
    try {
        at_hand = moves_at_hand(question, watch);
        narrow(question, sensible_depth(question, watch), bounds, watch);
        make_drivable(question, bounds, options.roomiest, watch);
    } catch (const GivenUp&) {  // the bounds are what is known
    }
    fall_back_on(std::move(at_hand), car, bounds);
    return answer_of(question, std::move(bounds), car, slot, false);
}

Place road_place(const Street& street) {
    constexpr double aslant = 0.1;      // [rad]
    constexpr double endless = 1000.0;  // [m]
    const Place bay = street_place(street);
    // The slot's frame is the street's: x along it, y from the entry side out into the road.
    const Slot frame({.length = street.length,
                      .width = street.width,
                      .side = street.side,
                      .corner = street.corner,
                      .heading = street.heading});
    const double across = street.road.value_or(endless);
    ParkedInside on_road;
    for (const Point& corner :
         {Point{-endless, 0.0}, Point{endless, 0.0}, Point{endless, across}, Point{-endless, across}})
        on_road.corners.push_back(frame.to_world(corner));
    on_road.heading = street.heading;
    on_road.heading_tolerance = aslant;
    PlaceDescription road;
    road.obstacles = bay.obstacles();
    road.parked = on_road;
    road.region = bay.region();
    return Place(std::move(road));
}

ParkAnswer leave(const Car& car, const Street& street, const Pose& pose, const ParkOptions& options) {
    return park(car, road_place(street), pose, options);
}

}  // namespace snug
