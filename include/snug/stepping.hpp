// Algorithm 1 of the paper as printed: Euler steps of equation 1. The reference, the baseline and the thing to beat.
#pragma once

#include <string_view>

#include "snug/car.hpp"
#include "snug/max_steer.hpp"
#include "snug/slot.hpp"

namespace snug {

/// When Algorithm 1 looks whether the car is parked.
enum class StopRule {
    inside,   ///< after every step
    contact,  ///< only when a move ends in contact, as the algorithm is printed
};

/// "inside", "contact"
std::string_view to_string(StopRule stop);

/// The options of Algorithm 1 (section 3.1 of the paper).
///
/// It drives the paper's strategy in steps: x += s Delta cos(theta), y += s Delta sin(theta),
/// theta += s Delta tan(phi) / b (equation 1), and after each of them asks whether the frame intersects one of the three
/// non-entry sides of the slot. As printed it does not run; these repairs make it:
///   - the step that intersects is undone: otherwise the car would start its next move, and look whether it is parked,
///     inside the side it hit;
///   - touching p at the start is no intersection: every possible entry position touches it;
///   - a car that cannot move any more, because the first step of a move intersects, is stuck and given up; so is one
///     that circles once without contact.
///
/// Every move stops up to a step short of contact, and the room lost that way at each end costs a little of the next
/// move, so that tight slots take more changes than they need. Hence the paper's 10 (mid-sized vehicle, 5.1 x 2.2 m) and
/// 19 (Renault ZOE, 4.5 x 2.0 m), which Delta = 1 mm reproduces, where exact moves need 9 and 18.
struct Stepping {
    double step = 1e-3;          ///< Delta: path of one Euler step [m], 1e-7 to 1, at most 1e9 of them in a full turn
    double heading_step = 1e-4;  ///< Delta_theta: between neighbouring entry headings [rad], 1e-6 to pi/2
    StopRule stop = StopRule::contact;
};

/// Algorithm 1 from one entry heading, with the words of max_steer(). The moves' ends and lengths are those of the Euler
/// steps, which differ from exact arcs by about half a step; the contact of a move is what the undone step would have
/// hit; the goal is where the algorithm stopped. Throws Error when an option is impossible.
MaxSteerRun stepping(const Car& car, const Slot& slot, double heading, const Stepping& steps = {},
                     const MaxSteerOptions& options = {});

}  // namespace snug
