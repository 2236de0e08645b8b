// Many slots at once, on all cores.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "snug/baselines.hpp"
#include "snug/batch.hpp"
#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/min_slot.hpp"
#include "snug/min_street.hpp"

namespace snug {

struct SweepOptions {
    int threads = 0;  ///< 0: all cores
    /// Told the part done (0 to 1) from time to time, never from two threads at once; returning false gives up.
    std::function<bool(double)> progress = {};
};

/// What entry() answers for one of many slots, in short.
struct EntryRow {
    std::optional<int> direction_changes;  ///< the fewest; empty where the car cannot park
    std::optional<HeadingRange> widest;    ///< the widest range with so many; trials have none

    friend bool operator==(const EntryRow&, const EntryRow&) = default;
};

/// entry() for every slot, of the solver or of a baseline. `options.progress` is not looked at. Empty when the progress
/// callback gave up. Throws Error when an option is impossible.
std::vector<EntryRow> entries(const Car& car, const std::vector<Slot>& slots, const EntryOptions& options = {},
                              const SweepOptions& sweep = {}, const std::optional<Baseline>& baseline = {});

/// direction_changes() of batch.hpp on all cores. Empty when the progress callback gave up.
std::vector<int> direction_changes(const Car& car, const Slot& slot, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep);
std::vector<int> direction_changes(const Car& car, const std::vector<Slot>& slots, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep);

/// min_slot() for every width (or length) given and every maximum of direction changes, row by row as given: counts outside,
/// sizes inside. `options.max_changes` and `options.progress` are not looked at. Empty when the progress callback gave up.
/// Throws Error when an option is impossible.
std::vector<MinSlot> min_slots(const Car& car, const std::vector<double>& given, const std::vector<int>& max_changes,
                               const MinSlotOptions& options = {}, const SweepOptions& sweep = {});

/// min_street() in every street for every maximum of direction changes: streets outside, counts inside, as given.
/// `options.max_changes` and `options.progress` are not looked at. When the progress callback gives up, rows are as far as they had
/// come. Throws Error when an option is impossible, or where park() would.
std::vector<MinStreet> min_streets(const Car& car, const std::vector<Street>& streets,
                                   const std::vector<int>& max_changes, const MinStreetOptions& options = {},
                                   const SweepOptions& sweep = {});

/// The paper's own loop (section 3.3): slots larger and larger by `step` [m] from the car's size on, Algorithm 1 in each.
/// The first that parks is the answer; its entry heading is the middle of the widest best range. The reference for
/// min_slots(), thousands of times slower. `options.strategy` is not looked at.
std::vector<MinSlot> min_slots_by_stepping(const Car& car, const std::vector<double>& given,
                                           const std::vector<int>& max_changes, const Stepping& stepping, double step,
                                           const MinSlotOptions& options = {}, const SweepOptions& sweep = {});

}  // namespace snug
