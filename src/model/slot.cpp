// Which slots can exist, and the way from the world into the slot frame and back.
#include "snug/slot.hpp"

#include <cmath>

#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

Slot::Slot(const SlotDimensions& dimensions) : dimensions_(dimensions) {
    using namespace limits;
    check_between("slot length", dimensions.length, shortest, longest, " m");
    check_between("slot width", dimensions.width, shortest, longest, " m");
    check_between("slot corner x", dimensions.corner.x, -farthest, farthest, " m");
    check_between("slot corner y", dimensions.corner.y, -farthest, farthest, " m");
    check_between("slot heading", dimensions.heading, -farthest, farthest, " rad");
    check_between("setback of the front neighbour", dimensions.front_setback, 0.0, dimensions.width, " m");
    check_between("setback of the rear neighbour", dimensions.rear_setback, 0.0, dimensions.width, " m");
}

Point Slot::to_world(const Point& in_slot) const {
    const auto [s, c] = angles::sine_cosine(dimensions_.heading);
    const double y = mirrored(in_slot.y);
    return {dimensions_.corner.x + in_slot.x * c - y * s, dimensions_.corner.y + in_slot.x * s + y * c};
}

Point Slot::to_slot(const Point& in_world) const {
    const auto [s, c] = angles::sine_cosine(dimensions_.heading);
    const double x = in_world.x - dimensions_.corner.x;
    const double y = in_world.y - dimensions_.corner.y;
    return {x * c + y * s, mirrored(y * c - x * s)};
}

Pose Slot::to_world(const Pose& in_slot) const {
    const Point at = to_world(Point{in_slot.x, in_slot.y});
    return {at.x, at.y, dimensions_.heading + mirrored(in_slot.heading)};
}

Pose Slot::to_slot(const Pose& in_world) const {
    const Point at = to_slot(Point{in_world.x, in_world.y});
    return {at.x, at.y, mirrored(in_world.heading - dimensions_.heading)};
}

}  // namespace snug
