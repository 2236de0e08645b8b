#include "contact/entering.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

namespace {

CarPart front_and_rear_swapped(CarPart part) {
    switch (part) {
        case CarPart::front_left_corner: return CarPart::rear_left_corner;
        case CarPart::rear_left_corner: return CarPart::front_left_corner;
        case CarPart::rear_right_corner: return CarPart::front_right_corner;
        case CarPart::front_right_corner: return CarPart::rear_right_corner;
        case CarPart::front_edge: return CarPart::rear_edge;
        case CarPart::rear_edge: return CarPart::front_edge;
        case CarPart::front_left_wheel: return CarPart::rear_left_wheel;
        case CarPart::rear_left_wheel: return CarPart::front_left_wheel;
        case CarPart::rear_right_wheel: return CarPart::front_right_wheel;
        case CarPart::front_right_wheel: return CarPart::rear_right_wheel;
        case CarPart::left_edge:
        case CarPart::right_edge: break;
    }
    return part;
}

}  // namespace

Obstacle other_end(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::front_side: return Obstacle::rear_side;
        case Obstacle::rear_side: return Obstacle::front_side;
        case Obstacle::front_corner: return Obstacle::rear_corner;
        case Obstacle::rear_corner: return Obstacle::front_corner;
        case Obstacle::curb: break;
    }
    return obstacle;
}

Problem entering_problem(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked) {
    const bool low_curb = slot.curb() == Curb::low;
    const auto seen = [&](const Outline& outline) {
        Outline in_slot = slot.side() == Side::left ? outline.mirrored() : outline;
        if (driving.enter == Enter::forward) in_slot = in_slot.turned_about();
        return in_slot;
    };
    Outline frame = seen(car.outline());
    Outline body = frame.grown(driving.clearance);
    Outline at_curb = low_curb ? seen(car.wheels()).grown(driving.at_curb()) : frame.grown(driving.at_curb());
    Problem problem{std::move(body),
                    std::move(at_curb),
                    std::move(frame),
                    car.turning_radius(),
                    slot.length(),
                    slot.width(),
                    slot.front_setback(),
                    slot.rear_setback(),
                    parked,
                    1e-13 * (car.length() + car.width() + driving.clearance + car.turning_radius())};
    if (driving.enter == Enter::forward) std::swap(problem.front_setback, problem.rear_setback);
    return problem;
}

LeastSlot least_slot(const Car& car, const Slot& slot, const Driving& driving) {
    const auto kept_from = [&](double setback) { return setback > 0.0 ? 0.0 : driving.clearance; };
    const Outline& stops = slot.curb() == Curb::low ? car.wheels() : car.outline();
    const bool right = slot.side() == Side::right;
    const double width = slot.curb() == Curb::low
                             ? (right ? car.outline().left() + stops.right() : car.outline().right() + stops.left())
                             : car.width();
    return {car.length() + (kept_from(slot.front_setback()) + kept_from(slot.rear_setback())),
            width + driving.at_curb()};
}

Pose to_world(const Slot& slot, Enter enter, const Pose& pose) {
    return slot.to_world(enter == Enter::backward ? pose : Pose{-slot.length() - pose.x, pose.y, -pose.heading});
}

Pose to_entering(const Slot& slot, Enter enter, const Pose& pose) {
    const Pose in_slot = slot.to_slot(pose);
    return enter == Enter::backward ? in_slot : Pose{-slot.length() - in_slot.x, in_slot.y, -in_slot.heading};
}

std::size_t own_part(const Outline& own, const Slot& slot, Enter enter, bool edge, std::size_t part) {
    const bool flipped_y = slot.side() == Side::left;
    const bool flipped_x = enter == Enter::forward;
    if (!flipped_x && !flipped_y) return part;
    Outline image = flipped_y ? own.mirrored() : own;
    if (flipped_x) image = image.turned_about();
    const Point first = image.corners().front();
    const Point original = {flipped_x ? -first.x : first.x, flipped_y ? -first.y : first.y};
    const std::vector<Point>& corners = own.corners();
    const auto start = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), original) - corners.begin());
    if (flipped_x && flipped_y) return (start + part) % corners.size();
    const std::size_t from = edge ? (part + 1) % corners.size() : part;  // seen in a mirror it follows its other corner
    return (start + corners.size() - from) % corners.size();
}

Contact to_world(const Car& car, const Slot& slot, Enter enter, const Contact& contact) {
    Contact seen = contact;
    if (enter == Enter::forward) seen = {front_and_rear_swapped(seen.part), other_end(seen.obstacle)};
    if (slot.side() == Side::left) seen.part = mirrored(seen.part);
    const bool edge = contact.obstacle == Obstacle::front_corner || contact.obstacle == Obstacle::rear_corner;
    const bool wheels = contact.obstacle == Obstacle::curb && slot.curb() == Curb::low;
    seen.part_index = own_part(wheels ? car.wheels() : car.outline(), slot, enter, edge, contact.part_index);
    return seen;
}

void check(const MaxSteerOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes, "");
    snug::check(options.driving);
    snug::check(options.parked);
}

void check_entry_heading(double heading) { check_between("entry heading", heading, 0.0, limits::quarter_turn, " rad"); }

}  // namespace snug::detail
