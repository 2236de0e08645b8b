#include "contact/entering.hpp"

#include <utility>

#include "model/check.hpp"

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
        case CarPart::left_edge:
        case CarPart::right_edge: break;
    }
    return part;
}

Obstacle front_and_rear_swapped(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::front_side: return Obstacle::rear_side;
        case Obstacle::rear_side: return Obstacle::front_side;
        case Obstacle::front_corner: return Obstacle::rear_corner;
        case Obstacle::rear_corner: return Obstacle::front_corner;
        case Obstacle::curb: break;
    }
    return obstacle;
}

}  // namespace

Problem entering_problem(const Car& car, const Slot& slot, Enter enter, double clearance) {
    Problem problem;
    const double side = car.width() / 2.0;
    problem.parked = {car.front(), side, car.rear(), side};
    if (enter == Enter::forward) std::swap(problem.parked.front, problem.parked.rear);
    problem.touching = {problem.parked.front + clearance, side + clearance, problem.parked.rear + clearance,
                        side + clearance};
    problem.radius = car.turning_radius();
    problem.length = slot.length();
    problem.width = slot.width();
    problem.touch = 1e-13 * (car.length() + car.width() + clearance + car.turning_radius());
    return problem;
}

Pose to_world(const Slot& slot, Enter enter, const Pose& pose) {
    return slot.to_world(enter == Enter::backward ? pose : Pose{-slot.length() - pose.x, pose.y, -pose.heading});
}

Contact to_world(const Slot& slot, Enter enter, const Contact& contact) {
    Contact seen = contact;
    if (enter == Enter::forward) seen = {front_and_rear_swapped(seen.part), front_and_rear_swapped(seen.obstacle)};
    if (slot.side() == Side::left) seen.part = mirrored(seen.part);
    return seen;
}

void check(const MaxSteerOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, 100000.0, "");
    check_between("clearance", options.driving.clearance, 0.0, 1e6, " m");
}

void check_entry_heading(double heading) { check_between("entry heading", heading, 0.0, 1.5707963267948966, " rad"); }

}  // namespace snug::detail
