// Many slots at once, on all cores.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "snug/batch.hpp"
#include "snug/car.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"
#include "snug/min_slot.hpp"
#include "snug/stepping.hpp"

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

/// entry() for every slot. `options.progress` is not looked at. Empty when the progress callback gave up. Throws Error
/// when an option is impossible.
std::vector<EntryRow> entries(const Car& car, const std::vector<Slot>& slots, const EntryOptions& options = {},
                              const SweepOptions& sweep = {});

/// direction_changes() of batch.hpp on all cores. Empty when the progress callback gave up.
std::vector<int> direction_changes(const Car& car, const Slot& slot, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep);
std::vector<int> direction_changes(const Car& car, const std::vector<Slot>& slots, const std::vector<double>& headings,
                                   const MaxSteerOptions& options, const SweepOptions& sweep);

/// One point of a minimum slot curve; `slot` is empty where nothing within the limits will do.
struct MinSlotRow {
    int max_changes = 0;
    double given = 0.0;  ///< the slot's width, or its length, that was asked for [m]
    std::optional<MinSlot> slot;

    friend bool operator==(const MinSlotRow&, const MinSlotRow&) = default;
};

/// min_length() for every width and every maximum of direction changes, row by row as given: counts outside, widths
/// inside. `options.max_changes` is not looked at. Empty when the progress callback gave up. Throws Error when an option
/// is impossible.
std::vector<MinSlotRow> min_lengths(const Car& car, const std::vector<double>& widths,
                                    const std::vector<int>& max_changes, const MinSlotOptions& options = {},
                                    const SweepOptions& sweep = {});

/// min_width() for every length, likewise.
std::vector<MinSlotRow> min_widths(const Car& car, const std::vector<double>& lengths,
                                   const std::vector<int>& max_changes, const MinSlotOptions& options = {},
                                   const SweepOptions& sweep = {});

/// The paper's own loop (section 3.3): slots longer and longer by `step` [m] from the car's length on, Algorithm 1 in each.
/// The first that parks is the row's slot; its entry heading is the middle of the widest best range. The reference for
/// min_lengths(), thousands of times slower.
std::vector<MinSlotRow> min_lengths_by_stepping(const Car& car, const std::vector<double>& widths,
                                                const std::vector<int>& max_changes, const Stepping& stepping,
                                                double step, const MinSlotOptions& options = {},
                                                const SweepOptions& sweep = {});

/// The same for min_widths().
std::vector<MinSlotRow> min_widths_by_stepping(const Car& car, const std::vector<double>& lengths,
                                               const std::vector<int>& max_changes, const Stepping& stepping,
                                               double step, const MinSlotOptions& options = {},
                                               const SweepOptions& sweep = {});

/// One point of a curve of shortest slots over all maneuvers.
struct FewestLengthRow {
    int max_changes = 0;
    double width = 0.0;  ///< of the slot [m]
    FewestLength found;

    friend bool operator==(const FewestLengthRow&, const FewestLengthRow&) = default;
};

/// min_length_fewest() for every width and every maximum of direction changes, widths outside, counts inside.
/// `options.max_changes` and `options.progress` are not looked at. Empty when the progress callback gave up. Throws
/// Error when an option is impossible.
std::vector<FewestLengthRow> min_lengths_fewest(const Car& car, const std::vector<double>& widths,
                                                const std::vector<int>& max_changes,
                                                const FewestLengthOptions& options = {},
                                                const SweepOptions& sweep = {});

}  // namespace snug
