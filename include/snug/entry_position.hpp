// Entry positions: where the car stands when the paper's strategy begins, and at which headings it can.
#pragma once

#include <vector>

#include "snug/answer.hpp"
#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/slot.hpp"

namespace snug {

/// The pose (world frame) at the entry position with a heading in [0, pi/2], measured like that of max_steer() [rad]: of the
/// outline, grown by the clearance, the point ahead of the rear axle (entering forward: behind it) that is farthest from the
/// centre of the first move touches the front (rear) neighbour's corner. Of a rectangle that is the front-right (rear-right)
/// corner. Throws Error when the heading or the driving is impossible.
Pose entry_position(const Car& car, const Slot& slot, double heading, const Driving& driving = {});

/// The headings in [0, pi/2] at which the car overlaps nothing there and the first move can start, in rising order; none
/// where it cannot fit into the slot. Throws Error when the driving is impossible.
std::vector<Headings> possible_headings(const Car& car, const Slot& slot, const Driving& driving = {});

}  // namespace snug
