// A slot is as small as can be where the least depth over all headings and moves becomes zero. That is a root, and is
// found as one: from a slot that parks and a heading that shows it,
//   - shrink the slot until that heading only just parks, turn the heading to where the slot can be smaller still, and
//     so on: that takes single runs of the strategy,
//   - then look at all headings in a slot smaller by the resolution. Does none park, the root is found; otherwise
//     begin again from the heading that does, and look further down the next time.
//
// A larger slot can be harder for this strategy: it drives on until contact, and what it meets farther back can be worse
// than the neighbour it would have met. So the sizes that park may have gaps, and a root found from above need not be
// the smallest one. Before an answer is given, smaller sizes are tried: close to it, thirty times farther away each
// time, and all others in steps of a hundredth of a metre or so, the largest count first, for where that does not park
// no smaller one does. What parks only between two such steps, or far below the root with more than 20 changes alone, is
// missed.
#include "full_steering/smallest_slot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "contact/entering.hpp"
#include "contact/sized_slot.hpp"
#include "full_steering/heading_ranges.hpp"
#include "full_steering/proof/verdict.hpp"

namespace snug::detail {

namespace {

constexpr double resolution = 5e-8;            ///< of answers [m]
constexpr double farther = 30.0;               ///< each size tried than the one before
constexpr double stride = 0.0025;              ///< between sizes tried, times the car's length
constexpr double growing = 0.025;              ///< and times what the size is more than the least
constexpr int most_looked_for = 20;            ///< changes, far from a root: more take long to rule out
constexpr double fine = 1e-9;                  ///< of roots for one heading [m]
constexpr int most_turns = 40;                 ///< of a heading, before all are looked at again
constexpr double beside = 2.0 * one_subrange;  ///< how far a stretch must reach to be seen by two runs [rad]

/// The asker gave up.
struct GivenUp {};

class SlotSearch {
public:
    SlotSearch(const Car& car, double given, const MinSlotOptions& options)
        : car_(car), given_(given), options_(options) {
        const SizeRange sizes = sizes_to_search(car, given, options);
        least_ = sizes.least;
        most_ = sizes.most;
        hopeless_ = least_ > most_;
    }

    /// The smallest size for this many changes, not less than asked for the last time. `nearby` may come close to an
    /// entry heading.
    MinSlot smallest(int max_changes, std::optional<double> nearby) {
        changes_ = max_changes;
        if (hopeless_) return nothing(max_changes);
        if (!found_) {
            const std::optional<double> any = parks(most_);
            if (!any) return nothing(max_changes);
            found_ = Found{most_, *any};
        }
        if (nearby && any_range_will_do() && parks_around(steering(found_->size), *nearby))
            found_ = Found{smallest_for(*nearby, least_, found_->size), *nearby};
        settle(least_);
        return answer(max_changes);
    }

    /// The smallest size for this many changes, where nothing parks below `clear` and `known` is what smallest() said.
    MinSlot smallest_above(double clear, int max_changes, const MinSlot& known) {
        if (hopeless_) return known;
        changes_ = std::min(max_changes, most_looked_for);
        const double end = known.size(options_.sought).value_or(most_);
        for (double fails = std::max(clear, least_);;) {
            const double size = fails + std::max(stride * car_.length(), growing * (fails - least_));
            if (!(size < end)) return known;
            if (const std::optional<double> heading = parks(size)) {
                changes_ = max_changes;
                found_ = Found{size, *heading};
                settle(fails);
                return answer(max_changes);
            }
            fails = size;
        }
    }

    /// No slot will do.
    [[nodiscard]] MinSlot nothing(int max_changes) const {
        MinSlot slot;
        slot.max_changes = max_changes;
        (options_.sought == Sought::length ? slot.width : slot.length) = given_;
        return slot;
    }

private:
    struct Found {
        double size;
        double heading;
    };

    [[nodiscard]] FullSteering steering(double size) const {
        return FullSteering(entering_problem(car_, slot_of(options_, given_, size), options_.driving, options_.parked));
    }

    [[nodiscard]] bool any_range_will_do() const { return options_.min_range <= resolvable_range; }

    /// Looks at all headings: one that parks, in the middle of the widest stretch if `middle`, else any.
    [[nodiscard]] std::optional<double> parks(double size, bool middle = false) const {
        const FullSteering at = steering(size);
        if (any_range_will_do() && !middle) {
            const std::vector<CountedHeadings> shown = looked_at(at, Find::any);
            if (shown.empty()) return std::nullopt;
            if (parks_around(at, shown.front().min)) return shown.front().min;
        }
        std::vector<CountedHeadings> ranges = looked_at(at, Find::all);
        std::vector<Headings> noise;
        leave_out_noise({at}, ranges, noise);
        std::optional<double> heading;
        double widest = 0.0;
        for (const Chain& chain : chains(ranges, changes_, std::max(options_.min_range, resolvable_range))) {
            const double min = ranges[chain.first].min;
            const double width = ranges[chain.last].max - min;
            if (heading && width < widest) continue;
            const double between = min + width / 2.0;
            if (!parks_around(at, between)) continue;
            widest = width;
            heading = between;
        }
        return heading;
    }

    /// Throws GivenUp when the asker does, and where nothing is found because the search reached its bound on work.
    [[nodiscard]] std::vector<CountedHeadings> looked_at(const FullSteering& at, Find find) const {
        bool given_up = false;
        Progress progress;
        SearchWork work;
        if (options_.progress) {
            progress = [&](double) {
                given_up = !options_.progress(0.0);
                return !given_up;
            };
        }
        std::vector<CountedHeadings> ranges = heading_ranges(at, changes_, find, progress, &work);
        if (given_up || (ranges.empty() && !work.complete) || (options_.progress && !options_.progress(0.0)))
            throw GivenUp{};
        return ranges;
    }

    /// How far from parked the car stays in all moves allowed, the least D_n [m]: at most 0 if the heading parks.
    [[nodiscard]] double miss(const FullSteering& at, double heading) const {
        double least = std::numeric_limits<double>::infinity();
        FullSteeringRun run(at, heading);
        if (!is_possible(at.problem, at.entry, heading, run.heading().c, run.heading().s)) return least;
        for (int n = 0; n <= changes_; ++n) {
            const FullMove move = run.drive<false>();
            if (move.stuck) break;
            least = std::min(least, move.depth);
            if (least <= 0.0 || move.meets == Meets::nothing) break;
        }
        return least;
    }

    /// Does the heading park, and a neighbour with it?
    [[nodiscard]] bool parks_around(const FullSteering& at, double heading) const {
        return miss(at, heading) <= 0.0 && (miss(at, heading + beside) <= 0.0 || miss(at, heading - beside) <= 0.0);
    }

    /// From the size found to the smallest, as far as one sees without trying all that are larger than `fails`.
    void settle(double fails) {
        descend(fails);
        for (double away = farther * resolution; away < stride * car_.length() && found_->size - away > fails;
             away *= farther) {
            const double size = found_->size - away;
            const std::optional<double> heading = parks(size);
            if (!heading) continue;
            found_ = Found{size, *heading};
            descend(fails);
            away = resolution;
        }
    }

    /// From the size found to one just above a root: nothing smaller by the resolution parks.
    void descend(double fails) {
        double down = resolution;
        while (found_->size - fails > resolution) {
            if (any_range_will_do()) polish(fails);
            const double half = (found_->size - fails) / 2.0;
            const bool narrowed = fails > least_ && !any_range_will_do();
            const double size = found_->size - (narrowed || down > half ? half : down);
            if (const std::optional<double> heading = parks(size)) {
                found_ = Found{size, *heading};
                down *= 32.0;
            } else {
                if (found_->size - size <= resolution) return;
                fails = size;
                down = resolution;
            }
        }
    }

    /// Makes the slot smaller around the heading found, as far as single runs can see: turns the heading in growing,
    /// then in shrinking steps wherever that allows a smaller slot. Where it would take many a small turn, looking at all
    /// headings is quicker.
    void polish(double fails) {
        found_->size = smallest_for(found_->heading, fails, found_->size);
        double step = 1e-6;
        for (int i = 0; i < most_turns && step > beside; ++i)
            step *= turn(step, fails) || turn(-step, fails) ? 4.0 : 0.3;
    }

    bool turn(double by, double fails) {
        const double heading = found_->heading + by;
        const double smaller = found_->size - fine;
        if (smaller <= fails || !parks_around(steering(smaller), heading)) return false;
        found_ = Found{smallest_for(heading, fails, smaller), heading};
        return true;
    }

    /// The smallest size, as far as one sees, in which this heading parks.
    [[nodiscard]] double smallest_for(double heading, double fails, double works) const {
        double low = fails;
        double high = works;
        double at_low = miss(steering(low), heading);
        double at_high = miss(steering(high), heading);
        const double start = works;
        for (int i = 0; i < 80 && high - low > fine; ++i) {
            double middle = low + (high - low) / 2.0;
            const double secant = high - at_high * (high - low) / (at_high - at_low);
            if (i % 3 != 2 && secant > low && secant < high)
                middle = std::clamp(secant, low + fine / 2, high - fine / 2);
            const double there = miss(steering(middle), heading);
            if (there <= 0.0) {
                high = middle;
                at_high = there;
                at_low /= 2.0;
            } else {
                low = middle;
                at_low = there;
                at_high /= 2.0;
            }
        }
        return parks_around(steering(high), heading) ? high : start;
    }

    /// With the heading in the middle of what parks, in a slot in which looking at all headings finds it: where a corner
    /// passes along a wall, rounding has one heading park in a slot that is too small.
    [[nodiscard]] MinSlot answer(int max_changes) {
        double size = found_->size;
        std::optional<double> heading = parks(size, true);
        for (double more = fine; !heading && more < farther * resolution; more *= 4.0) {
            size = found_->size + more;
            heading = parks(size, true);
        }
        if (!heading) heading = found_->heading;
        MinSlot slot = nothing(max_changes);
        (options_.sought == Sought::length ? slot.length : slot.width) = size;
        slot.entry_heading = *heading;
        return slot;
    }

    const Car& car_;
    double given_;
    const MinSlotOptions& options_;
    double least_ = 0.0;     ///< what holds the car [m]
    double most_ = 0.0;      ///< where the search begins [m]
    bool hopeless_ = false;  ///< the given dimension does not hold the car
    int changes_ = 0;
    std::optional<Found> found_;  ///< a slot that parks
};

}  // namespace

std::vector<MinSlot> smallest_slots(const Car& car, double given, const std::vector<int>& max_changes,
                                    const MinSlotOptions& options, const std::vector<MinSlot>& neighbours) {
    check(options, given);
    for (const int changes : max_changes) check(MaxSteerOptions{changes, options.driving, options.parked});
    SlotSearch search(car, given, options);
    std::vector<MinSlot> slots;
    for (const int changes : max_changes) {
        slots.push_back(search.nothing(changes));
        slots.back().cancelled = true;
    }
    try {
        for (std::size_t i = 0; i < max_changes.size(); ++i) {
            std::optional<double> heading;
            if (i < neighbours.size()) heading = neighbours[i].entry_heading;
            slots[i] = search.smallest(max_changes[i], heading);
        }
        double clear = 0.0;
        for (std::size_t i = max_changes.size(); i-- > 0;) {
            slots[i] = search.smallest_above(clear, max_changes[i], slots[i]);
            clear = slots[i].size(options.sought).value_or(std::numeric_limits<double>::infinity());
        }
    } catch (const GivenUp&) {
        for (MinSlot& slot : slots) slot.cancelled = true;
    }
    return slots;
}

}  // namespace snug::detail
