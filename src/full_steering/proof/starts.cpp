// Branch and bound once more (proof.cpp), over boxes of starts instead of headings. Only that all of a box park matters: a
// box of which that cannot be told is halved, and where one start is shown not to park, or halving ends, the tolerance ends.
#include "full_steering/proof/starts.hpp"

#include <algorithm>
#include <vector>

#include "full_steering/proof/driver.hpp"

namespace snug::detail {

namespace {

using proof::Driver;
using proof::Outcome;
using proof::Starts;

constexpr double widest_first = 0.25;          ///< the first box is no wider [m]
constexpr double inward = 1e-9;                ///< ends are moved so far, beyond what rounding car and slot may do [m]
constexpr double narrowest_strip = 1e-10;      ///< strips are not halved further [m]
constexpr double narrowest_of_both = 1e-3;     ///< boxes are not halved further, as a part of the whole
constexpr std::size_t moves_one_way = 50'000;  ///< 20 ms or so
constexpr std::size_t moves_a_box = 20'000;
constexpr int steps_of_both = 64;

bool all_park(Driver& driver, const Starts& starts, int changes, bool& none) {
    const Outcome outcome = driver.look(starts, changes);
    none = outcome.what == Outcome::none;
    return outcome.what == Outcome::parks;
}

/// How far off the start may be one way.
double farthest(const ProofProblem& problem, const StartTolerance& tolerance, double Starts::*least,
                double Starts::*most, double room) {
    Driver driver(problem, tolerance.direction_changes);
    Starts strip{tolerance.heading};
    double step = widest_first;
    double proved = 0.0;
    while (proved < room && driver.moves() < moves_one_way) {
        strip.*least = proved;
        strip.*most = std::min(room, proved + step);
        bool none = false;
        if (all_park(driver, strip, tolerance.direction_changes, none)) {
            proved = strip.*most;
            step = 2.0 * step;
        } else {
            step = (strip.*most - proved) / 2.0;
            if (step < narrowest_strip) break;
        }
    }
    return proved < room ? std::max(0.0, proved - inward) : room;
}

/// Do all starts of a box park?
bool box_parks(const ProofProblem& problem, const StartTolerance& tolerance, double part) {
    Driver driver(problem, tolerance.direction_changes);
    const double along = part * tolerance.along;
    const double out = part * tolerance.out;
    // The far corner first: it is the one that fails.
    std::vector<Starts> boxes = {{tolerance.heading, 0.0, along, 0.0, out},
                                 {tolerance.heading, along, along, out, out}};
    while (!boxes.empty()) {
        const Starts box = boxes.back();
        boxes.pop_back();
        bool none = false;
        if (all_park(driver, box, tolerance.direction_changes, none)) continue;
        const double wide = (box.along_max - box.along_min) / along;
        const double high = (box.out_max - box.out_min) / out;
        if (none || std::max(wide, high) < narrowest_of_both || driver.moves() > moves_a_box) return false;
        Starts near = box;
        Starts far = box;
        if (wide >= high) {
            near.along_max = far.along_min = 0.5 * (box.along_min + box.along_max);
        } else {
            near.out_max = far.out_min = 0.5 * (box.out_min + box.out_max);
        }
        boxes.push_back(near);
        boxes.push_back(far);
    }
    return true;
}

}  // namespace

void prove_starts(const ProofProblem& problem, double room, StartTolerance& tolerance) {
    tolerance.along = farthest(problem, tolerance, &Starts::along_min, &Starts::along_max, room);
    tolerance.out = farthest(problem, tolerance, &Starts::out_min, &Starts::out_max, problem.width);
    if (!(tolerance.along > 0.0 && tolerance.out > 0.0)) return;
    int proved = 0;
    int beyond = steps_of_both + 1;
    while (beyond - proved > 1) {
        const int middle = (proved + beyond) / 2;
        (box_parks(problem, tolerance, static_cast<double>(middle) / steps_of_both) ? proved : beyond) = middle;
    }
    tolerance.both_along = tolerance.along * proved / steps_of_both;
    tolerance.both_out = tolerance.out * proved / steps_of_both;
}

}  // namespace snug::detail
