// A slot's smallest length is where the least depth over all headings and moves becomes zero: a root, found by halving an
// interval whose one end parks and whose other end does not.
//
// Nobody has proved that a longer slot is never harder for this strategy. So before an answer is given, lengths below it
// are tried, ever closer to it; whatever parks there becomes the new upper end.
#include "snug/min_slot.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "entering.hpp"
#include "heading_ranges.hpp"

namespace snug {

namespace {

using namespace detail;

constexpr double resolution = 5e-8;  ///< [m]

void check(const MinSlotOptions& options) {
    detail::check(MaxSteerOptions{options.max_changes, options.clearance, options.enter});
    check_between("smallest range", options.min_range, 0.0, 1.5707963267948966, " rad");
    check_between("extra length to search", options.longest, 0.0, 1e6, " m");
    check_between("extra width to search", options.widest, 0.0, 1e6, " m");
}

/// The middle of the widest stretch of headings that park in the slot, if there is any.
std::optional<double> parks(const Car& car, double length, double width, const MinSlotOptions& options) {
    const Slot slot({.length = length, .width = width});
    const FullSteering steering(entering_problem(car, slot, options.enter, options.clearance));
    const double stretch_width = std::max(options.min_range, resolvable_range);
    const bool any = options.min_range <= resolvable_range;
    std::vector<CountedHeadings> ranges = heading_ranges(steering, options.max_changes, any ? Find::any : Find::all);
    if (any && !ranges.empty() && stretches(ranges, options.max_changes, stretch_width).empty())
        ranges = heading_ranges(steering, options.max_changes, Find::all);  // what showed first was too thin to tell
    std::optional<double> middle;
    double widest = 0.0;
    for (const Stretch& stretch : stretches(ranges, options.max_changes, stretch_width)) {
        const double min = ranges[stretch.first].min;
        const double max = ranges[stretch.last].max;
        if (max - min < widest) continue;
        widest = max - min;
        middle = min + (max - min) / 2.0;
    }
    return middle;
}

/// The smallest value in (low, high] for which `parks_with` gives a heading.
template <class ParksWith>
std::optional<std::pair<double, double>> smallest(double low, double high, ParksWith parks_with) {
    std::optional<double> heading = parks_with(high);
    if (!heading) return std::nullopt;
    const auto halve = [&](double below) {
        while (high - below > resolution) {
            const double middle = below + (high - below) / 2.0;
            if (const std::optional<double> found = parks_with(middle)) {
                high = middle;
                heading = found;
            } else {
                below = middle;
            }
        }
    };
    halve(low);
    for (double below = high - low; below > 4.0 * resolution; below *= 0.6) {
        const double tried = high - below;
        if (tried <= low) continue;
        const std::optional<double> found = parks_with(tried);
        if (!found) continue;
        high = tried;
        heading = found;
        halve(low);
        below = high - low;
    }
    return std::pair{high, *heading};
}

}  // namespace

std::optional<MinSlot> min_length(const Car& car, double width, const MinSlotOptions& options) {
    check(options);
    check_between("slot width", width, 1e-6, 1e6, " m");
    if (width < car.width() + options.clearance) return std::nullopt;
    const double least = car.length() + 2.0 * options.clearance;
    const auto found =
        smallest(least, least + options.longest, [&](double length) { return parks(car, length, width, options); });
    if (!found) return std::nullopt;
    return MinSlot{found->first, width, found->second};
}

std::optional<MinSlot> min_width(const Car& car, double length, const MinSlotOptions& options) {
    check(options);
    check_between("slot length", length, 1e-6, 1e6, " m");
    if (length < car.length() + 2.0 * options.clearance) return std::nullopt;
    const double least = car.width() + options.clearance;
    const auto found =
        smallest(least, least + options.widest, [&](double width) { return parks(car, length, width, options); });
    if (!found) return std::nullopt;
    return MinSlot{length, found->first, found->second};
}

}  // namespace snug
