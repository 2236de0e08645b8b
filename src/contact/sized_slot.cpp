#include "contact/sized_slot.hpp"

#include <algorithm>

#include "contact/entering.hpp"
#include "contact/standing_room.hpp"
#include "sentences/check.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"

namespace snug::detail {

void check(const MinSlotOptions& options, double given) {
    check(MaxSteerOptions{options.max_changes, options.driving, options.parked});
    check_between(options.sought == Sought::length ? "slot width" : "slot length", given, limits::shortest,
                  limits::longest, " m");
    check_between("smallest range", options.min_range, 0.0, limits::quarter_turn, " rad");
    if (options.prove && options.min_range > 0.0)
        throw Error("a proof is asked for with a smallest range of headings, but it is about all; leave one out");
    check_between("extra length to search", options.longest, 0.0, limits::longest, " m");
    check_between("extra width to search", options.widest, 0.0, limits::longest, " m");
    const double deepest = options.sought == Sought::length ? given : limits::longest;
    check_between("setback of the front neighbour", options.front_setback, 0.0, deepest, " m");
    check_between("setback of the rear neighbour", options.rear_setback, 0.0, deepest, " m");
}

Slot slot_of(const MinSlotOptions& options, double given, double size) {
    const bool length = options.sought == Sought::length;
    return Slot({.length = length ? size : given,
                 .width = length ? given : size,
                 .front_setback = options.front_setback,
                 .rear_setback = options.rear_setback,
                 .curb = options.curb});
}

SizeRange sizes_to_search(const Car& car, double given, const MinSlotOptions& options) {
    const bool length = options.sought == Sought::length;
    const double deepest = std::max({options.front_setback, options.rear_setback, limits::shortest});
    const Slot slot = slot_of(options, given, length ? limits::shortest : deepest);
    const LeastSlot parallel = least_slot(car, slot, options.driving);
    const Problem problem = entering_problem(car, slot, options.driving, options.parked);
    SizeRange sizes;
    sizes.least = std::max(length ? least_length(problem, given) : least_width(problem, given),
                           length ? limits::shortest : deepest);
    sizes.parallel = length ? parallel.length : std::max(parallel.width, deepest);
    sizes.most = sizes.parallel + (length ? options.longest : options.widest);
    return sizes;
}

}  // namespace snug::detail
