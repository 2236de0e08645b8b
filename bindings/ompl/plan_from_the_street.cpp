// From a pose in the street into a slot: OMPL plans to where the car can enter, snug goes on from there.
#include <iostream>

#include "plan.hpp"
#include "snug/snug.hpp"

int main() {
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ompl::RNG::setSeed(1);
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 5.2, .width = 2.0});

    // All headings from which one direction change, the fewest, is enough: a goal that OMPL can sample.
    const snug::Answer answer = snug::entry(car, slot);
    const auto space = snug::street(car, slot);
    const auto entries = std::make_shared<snug::EntryPositions>(space, car, slot, answer.ranges);

    const auto say = [](const char* goal, const std::optional<snug::Plan>& plan) {
        std::cout << goal;
        if (plan) {
            std::cout << snug::direction_changes(plan->path) << " direction changes, found in " << plan->seconds
                      << " s\n";
        } else {
            std::cout << "nothing found\n";
        }
    };
    const snug::Pose start = snug::in_the_street(car);
    const auto by_entry = plan_to_entry(space, start, entries, 5.0);
    say("through an entry position:    ", by_entry);
    say("straight to the parked pose:  ", plan_to_parked(space, start, snug::parked_in_the_middle(car, slot), 5.0));
    return by_entry && by_entry->path.check() ? 0 : 1;
}
