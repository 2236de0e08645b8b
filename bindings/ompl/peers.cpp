// Is planning to snug's entry positions better than planning straight to a parked pose, and what does snug do on its own? 50
// tight slots, tried all three ways from the same start.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "plan.hpp"
#include "snug/snug.hpp"

namespace {

struct Try {
    snug::Car car;
    snug::Slot slot;
    snug::Answer answer;
};

/// Slots by how much longer than the car they are. [m]
struct Kind {
    const char* name;
    double least;
    double most;
};

/// Cars of the paper and slots 0.1 to 0.4 m wider than they are, which the paper's strategy parks in with at least one
/// direction change, from ranges of headings at least 1e-4 rad wide.
std::vector<Try> random_slots(const Kind& kind, int count) {
    std::mt19937_64 bits(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    const std::vector<snug::Car> cars = snug::catalogue();
    snug::EntryOptions wide_enough;
    wide_enough.prove = false;
    wide_enough.min_range = 1e-4;
    std::vector<Try> all;
    while (static_cast<int>(all.size()) < count) {
        const snug::Car& car = cars[static_cast<std::size_t>(between(0.0, static_cast<double>(cars.size())))];
        const double length = car.length() + between(kind.least, kind.most);
        const snug::Slot slot({.length = length, .width = car.width() + between(0.1, 0.4)});
        snug::Answer answer = entry(car, slot, wide_enough);
        if (answer.parkable() && *answer.direction_changes > 0) all.push_back({car, slot, std::move(answer)});
    }
    return all;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

struct Tally {
    std::vector<double> seconds;
    std::vector<double> changes;
    int refused = 0;            // by OMPL's own check
    std::optional<int> proved;  // of how many it is, that no way has fewer changes

    void add(std::optional<snug::Plan> plan) {
        if (!plan) return;
        seconds.push_back(plan->seconds);
        changes.push_back(snug::direction_changes(plan->path));
        refused += plan->path.check() ? 0 : 1;
    }

    void print(const char* slots, const char* goal, std::size_t tries) const {
        std::printf("| %s | %s | %zu of %zu |", slots, goal, seconds.size(), tries);
        if (seconds.empty()) {
            std::printf(" | | | |\n");
        } else {
            const std::string fewest = proved ? std::to_string(*proved) + " of " + std::to_string(changes.size()) : "";
            std::printf(" %.2g s | %g | %s | %zu of %zu |\n", median(seconds), median(changes), fewest.c_str(),
                        changes.size() - static_cast<std::size_t>(refused), changes.size());
        }
    }
};

/// park(), from the same start.
std::optional<snug::Plan> plan_by_snug(const ompl::base::SpaceInformationPtr& space, const Try& one,
                                       const snug::Pose& start, double limit, bool& proved) {
    snug::Street street;
    street.length = one.slot.length();
    street.width = one.slot.width();
    snug::ParkOptions options;
    options.time_limit = limit;
    const auto begin = std::chrono::steady_clock::now();
    const snug::ParkAnswer answer = snug::park(one.car, snug::street_place(street), start, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    proved = answer.proved;
    if (!answer.maneuver) return std::nullopt;
    return snug::Plan{as_path(*answer.maneuver, space), seconds};
}

/// Tries every slot in all ways and prints a row for each.
void compare(const Kind& kind, int count, double limit) {
    const std::vector<Try> tries = random_slots(kind, count);
    Tally entries;
    Tally parked;
    Tally alone;
    for (const Try& one : tries) {
        const auto space = snug::street(one.car, one.slot);
        const snug::Pose start = snug::in_the_street(one.car);
        const auto goal = std::make_shared<snug::EntryPositions>(space, one.car, one.slot, one.answer.ranges);
        entries.add(plan_to_entry(space, start, goal, limit));
        bool proved = false;
        alone.add(plan_by_snug(space, one, start, limit, proved));
        alone.proved = alone.proved.value_or(0) + (proved ? 1 : 0);
        parked.add(plan_to_parked(space, start, parked_in_the_middle(one.car, one.slot), limit));
    }
    entries.print(kind.name, "entry positions, then snug's maneuver", tries.size());
    parked.print(kind.name, "parked pose in the middle of the slot", tries.size());
    alone.print(kind.name, "anywhere in the slot, by `snug park` alone", tries.size());
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 50;
    const double limit = argc > 2 ? std::max(0.01, std::atof(argv[2])) : 5.0;
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    ompl::RNG::setSeed(1);
    std::printf(
        "| slots | goal | solved | median time | median direction changes | proved the fewest | accepted by OMPL |\n");
    std::printf("|---|---|---|---|---|---|---|\n");
    compare({"tight: 0.4 to 1 m longer than the car", 0.4, 1.0}, count, limit);
    compare({"1 to 2 m longer", 1.0, 2.0}, (count + 1) / 2, limit);
}
