// What `snug entry` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "snug/baselines.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"
#include "snug/start_tolerance.hpp"
#include "snug/strategy.hpp"

namespace snug::cli {

struct EntryQuestion {
    Car car;
    Slot slot;
    EntryOptions options;
    std::optional<Baseline> baseline = {};  ///< to answer instead of the solver
};

/// As --strategy names it.
inline std::string_view strategy_name(const std::optional<Baseline>& baseline) {
    return baseline ? to_string(*baseline) : to_string(Strategy::max_steer);
}

/// What a person needs: where to put the car, how exactly, and move by move what to do. At most 80 columns.
std::string entry_text(const EntryQuestion& question, const Answer& answer,
                       const std::optional<StartTolerance>& tolerance = {});

/// The same for the fewest changes over all maneuvers, and what is proved.
std::string fewest_text(const EntryQuestion& question, int max_changes, const Answer& answer);

/// How to leave, move by move, and what is proved.
std::string leave_text(const EntryQuestion& question, const FewestOptions& options, const Answer& answer);

/// One row per range of entry headings.
std::string entry_csv(const Answer& answer);
/// One row per move.
std::string moves_csv(const Answer& answer);

}  // namespace snug::cli
