// One slot judged: how many direction changes it takes, and what a little more or less room would change.
#include <algorithm>
#include <cmath>

#include "cli/min_slot.hpp"
#include "cli/words.hpp"
#include "snug/limits.hpp"

namespace snug::cli {
namespace {

/// The slot of that size, with the neighbours asked about.
Slot in_question(double length, double width, const MinSlotOptions& like) {
    return Slot({.length = length,
                 .width = width,
                 .front_setback = like.front_setback,
                 .rear_setback = like.rear_setback,
                 .curb = like.curb});
}

/// The fewest direction changes for a slot.
std::optional<int> fewest(const Car& car, double length, double width, const MinSlotOptions& like) {
    const double narrowest = std::max({limits::shortest, like.front_setback, like.rear_setback});
    if (length < limits::shortest || width < narrowest) return std::nullopt;
    EntryOptions options;
    options.prove = false;
    options.min_range = like.min_range;
    options.driving = like.driving;
    options.parked = like.parked;
    return entry(car, in_question(length, width, like), options).direction_changes;
}

}  // namespace

OneSlot one_slot(const Car& car, double length, double width, const MinSlotOptions& options) {
    OneSlot one{car,
                length,
                width,
                fewest(car, length, width, options),
                limits::usual_changes,
                shortfall(car, in_question(length, width, options), options.driving),
                options.driving.clearance,
                {},
                {}};
    for (const bool vary_length : {true, false}) {
        const double size = vary_length ? length : width;
        const auto least = [&](int changes) {
            MinSlotOptions allowed = options;
            allowed.max_changes = changes;
            allowed.sought = vary_length ? Sought::length : Sought::width;
            const MinSlot slot = min_slot(car, vary_length ? width : length, allowed);
            if (vary_length) one.rows.push_back(slot);
            return slot.size(allowed.sought);
        };
        // Sizes are said in whole millimetres, and what such a slot needs is looked up, not concluded.
        const auto vary = [&](double by, const char* how) {
            const std::optional<int> changes =
                vary_length ? fewest(car, length + by, width, options) : fewest(car, length, width + by, options);
            one.variations.push_back({std::abs(by), how, changes});
        };
        if (!one.changes || *one.changes > 0) {
            if (const auto enough = least(one.changes ? *one.changes - 1 : one.most_changes))
                vary(millimetre * std::max(1.0, std::ceil((*enough - size) / millimetre)),
                     vary_length ? "longer" : "wider");
        }
        if (!one.changes) continue;
        if (const auto enough = least(*one.changes)) {
            vary(-millimetre * (std::floor((size - *enough) / millimetre) + 1.0), vary_length ? "shorter" : "narrower");
            if (vary_length && one.variations.back().changes) least(*one.variations.back().changes);
        }
    }
    return one;
}

}  // namespace snug::cli
