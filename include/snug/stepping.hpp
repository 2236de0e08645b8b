// Algorithm 1 of the paper as printed: Euler steps of equation 1. The reference, the baseline and the thing to beat.
#pragma once

namespace snug {

/// When Algorithm 1 looks whether the car is parked.
enum class StopRule {
    inside,   ///< after every step
    contact,  ///< only when a move ends in contact, as the algorithm is printed
};

/// The options of Algorithm 1.
struct Stepping {
    double step = 1e-3;          ///< Delta: path of one Euler step [m], 1e-7 to 1
    double heading_step = 1e-4;  ///< Delta_theta: between neighbouring entry headings [rad], 1e-8 to pi/2
    StopRule stop = StopRule::contact;
};

}  // namespace snug
