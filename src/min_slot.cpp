#include "snug/min_slot.hpp"

#include <limits>

#include "all_maneuvers/smallest_slot.hpp"
#include "contact/sized_slot.hpp"
#include "full_steering/proof/sizes.hpp"
#include "full_steering/smallest_slot.hpp"
#include "sentences/check.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

void check_fewest(const MinSlotOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check_between("precision", options.precision, limits::finest, limits::longest, " m");
    check_between("resolution", options.resolution, 0.0, limits::longest, " m");
    if (options.min_range > 0.0)
        throw Error("a smallest range of headings is asked for, but fewest has no headings; leave it out");
    if (options.sought == Sought::width && options.parked.curb < std::numeric_limits<double>::infinity())
        throw Error(
            "the narrowest slot over all maneuvers is asked for with a distance from the curb that counts as parked, "
            "but then a wider slot can be harder and nothing be proved; leave the distance out, or ask for a length");
}

}  // namespace

MinSlot min_slot(const Car& car, double given, const MinSlotOptions& options) {
    detail::check(options, given);
    if (options.strategy == Strategy::max_steer) {
        MinSlot found = detail::smallest_slots(car, given, {options.max_changes}, options).front();
        if (options.prove && !found.cancelled) detail::prove_smaller(car, given, options, found);
        return found;
    }
    check_fewest(options);
    std::optional<double> known;
    // The paper's strategy is a start.
    if (options.driving.enter == Enter::backward && detail::is_plain(car, given, options)) {
        const MinSlot found = detail::smallest_slots(car, given, {options.max_changes}, options).front();
        if (!found.cancelled) known = found.size(options.sought);
    }
    return detail::smallest_slot(car, given, options, known);
}

std::string_view to_string(Sought sought) { return sought == Sought::length ? "length" : "width"; }

}  // namespace snug
