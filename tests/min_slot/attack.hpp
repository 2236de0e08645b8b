// Attacks a slot size with nothing of the solver: is there a heading that parks in it, and how wide are the stretches
// that do?
#pragma once

#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/random_outlines.hpp"
#include "snug/min_slot.hpp"

namespace oracle {

/// One question of Problem 3: the shortest slot for a width, or the narrowest for a length.
struct MinSlotCase {
    Case asked;  // its slot holds the given dimension; the other one is not looked at
    bool length_sought = true;
    int max_changes = 0;
    double min_range = 0.0;

    double given() const { return length_sought ? asked.slot.width : asked.slot.length; }
    /// What holds the parallel car, with what it keeps from neighbours that are not set back and from the curb.
    double least() const {
        const auto kept = [&](double setback) { return setback > 0 ? 0.0 : asked.driving.clearance; };
        if (length_sought) return asked.car_length() + (kept(asked.slot.front_setback) + kept(asked.slot.rear_setback));
        double across = asked.car.width;
        if (asked.slot.curb == snug::Curb::low) {
            const snug::Car car = asked.made_car();
            across = car.outline().left() + car.wheels().right();
        }
        return std::max({across + asked.driving.at_curb(), asked.slot.front_setback, asked.slot.rear_setback});
    }
    Case in_slot_of(double size) const {
        Case sized = asked;
        (length_sought ? sized.slot.length : sized.slot.width) = size;
        return sized;
    }
    template <class Real>
    Problem<Real> problem(double size) const {
        return make_problem<Real>(in_slot_of(size));
    }
    std::string line(double size) const {
        std::ostringstream text;
        text.precision(17);
        text << (length_sought ? "shortest: " : "narrowest: ") << command_line(in_slot_of(size)) << " --max-changes "
             << max_changes;
        if (min_range > 0) text << " --min-range " << min_range;
        return text.str();
    }
};

enum class Cars { any, of_the_paper };

/// Any width (or length), mostly few changes.
inline MinSlotCase random_min_slot_case(std::uint64_t seed, std::uint64_t index, Cars cars) {
    Random random(seed * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL + 7);
    MinSlotCase chosen;
    do choose_car(random, chosen.asked);
    while (cars == Cars::of_the_paper && chosen.asked.car_name.empty());
    if (random.chance(0.1)) chosen.asked.driving.enter = snug::Enter::forward;
    if (random.chance(0.1)) chosen.asked.driving.clearance = random.between(0.005, 0.1);
    chosen.length_sought = random.chance(0.7);
    const double room = chosen.asked.driving.enter == snug::Enter::forward ? 1.5 : 0.65;
    chosen.asked.slot.width = chosen.asked.car.width + chosen.asked.driving.clearance + random.between(0.05, room);
    chosen.asked.slot.length =
        chosen.asked.car_length() + 2 * chosen.asked.driving.clearance + random.between(0.4, 2.0);
    chosen.max_changes = random.chance(0.8) ? random.below(13) : random.below(60);
    return chosen;
}

/// The same between any neighbours, half of them with any outline.
inline MinSlotCase random_neighbours_case(std::uint64_t seed, std::uint64_t index) {
    MinSlotCase chosen = random_min_slot_case(seed, index, Cars::any);
    Random random(seed * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL + 11);
    if (random.chance(0.5)) {
        const double wider = chosen.asked.slot.width - chosen.asked.car.width;
        const double longer = chosen.asked.slot.length - chosen.asked.car_length();
        choose_outline(random, chosen.asked);
        chosen.asked.slot.width = chosen.asked.car.width + wider;
        chosen.asked.slot.length = chosen.asked.car_length() + longer;
    }
    chosen.max_changes = random.below(9);
    choose_neighbours(random, chosen.asked);
    return chosen;
}

/// Does the heading park in a slot of this size, beyond what rounding could do?
inline bool parks(const MinSlotCase& asked, double size, double heading) {
    const Decided exact =
        decide(asked.problem<long double>(size), static_cast<long double>(heading), asked.max_changes);
    return exact.certain && exact.count >= 0;
}

/// A heading that parks, searched for at `step` over all of them, then a hundred and ten thousand times finer where the
/// car comes closest to being parked.
inline std::optional<double> parking_heading(const MinSlotCase& asked, double size, double step, double offset) {
    struct Sample {
        double heading, height;
    };
    const Problem<double> problem = asked.problem<double>(size);
    Run<double> result;
    std::optional<double> found;
    const auto look = [&](double heading) {
        run(problem, heading, asked.max_changes, result, Look::at_depths_too);
        if (result.parked() && !found && parks(asked, size, heading)) found = heading;
        return Sample{heading, result.least()};
    };
    std::vector<Sample> lowest;
    const auto scan = [&](double from, double to, double by) {
        Sample before{from, std::numeric_limits<double>::infinity()}, here = before;
        for (double k = 0; from + k * by <= to + by && !found; ++k) {
            const Sample after = look(from + k * by);
            if (here.height <= before.height && here.height < after.height) lowest.push_back(here);
            before = here;
            here = after;
        }
    };
    scan(offset * step, std::numbers::pi / 2, step);
    for (int level = 0; level < 3 && !found; ++level) {
        std::sort(lowest.begin(), lowest.end(), [](const Sample& a, const Sample& b) { return a.height < b.height; });
        lowest.resize(std::min<std::size_t>(lowest.size(), 8));
        for (const Sample& place : std::vector<Sample>(lowest))
            scan(place.heading - 1.5 * step, place.heading + 1.5 * step, step / 50);
        step /= 50;
    }
    return found;
}

/// The widest stretch of headings that park, from samples so close that none as wide as `least` can be missed. The ends
/// of those that may be that wide are halved down to; so is every place inside where the count changes, for there
/// stretches may part without a sample showing it.
inline double widest_stretch(const MinSlotCase& asked, double size, double least) {
    const Problem<double> problem = asked.problem<double>(size);
    Run<double> result;
    constexpr int none = -1;
    const auto count = [&](double heading) {
        run(problem, heading, asked.max_changes, result);
        return result.parked() ? result.changes : none;
    };
    /// The last heading from `in` towards `out` with the count of `in`, and the first without it.
    const auto change = [&](double in, double out) {
        const int same = count(in);
        while (std::abs(out - in) > 1e-12) {
            const double middle = (in + out) / 2;
            (count(middle) == same ? in : out) = middle;
        }
        return std::pair{in, out};
    };
    const double step = std::min(least / 20, 1e-3), end = std::numbers::pi / 2;
    double widest = 0;
    for (double heading = 0; heading <= end; heading += step) {
        if (count(heading) == none) continue;
        const double first = heading;
        while (heading <= end && count(heading) != none) heading += step;
        if (heading - first < least - 2 * step) continue;
        double start = first > 0 ? change(first - step, first).second : first;
        for (double h = first; h < heading;) {
            const double next = std::min(h + step / 50, heading);
            if (count(next) == count(h)) {
                h = next;
                continue;
            }
            const auto [last, other] = change(h, next);
            if (count(h) != none) widest = std::max(widest, last - start);
            if (count(h) == none) start = other;
            h = other;
        }
        widest = std::max(widest, count(heading) == none ? 0 : heading - start);
    }
    return widest;
}

}  // namespace oracle
