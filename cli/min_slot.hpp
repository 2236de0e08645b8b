// What `snug min-slot` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/entry.hpp"
#include "snug/sweep.hpp"

namespace snug::cli {

struct MinSlotQuestion {
    Car car;
    MinSlotOptions options;
    std::vector<double> sizes;  ///< the widths or lengths given
    std::vector<int> max_changes;
    std::optional<Stepping> stepping = {};  ///< the paper's loop instead of the exact search
    double step = 0.01;                     ///< of the paper's loop [m]
    int threads = 0;
};

/// The minimum slots for some given widths (or lengths), counts inside, as a table with a column for every count. At most
/// 80 columns.
std::string min_slot_table(Sought sought, const std::vector<MinSlot>& rows, std::size_t counts);
/// Those over all maneuvers: between which sizes.
std::string fewest_slot_table(Sought sought, const std::vector<MinSlot>& rows);
/// What is proved of the slots smaller than one found with full steering.
std::string size_proof(Sought sought, const MinSlot& row);

/// How the slots asked for are found, as --strategy names it.
inline std::string_view strategy_name(const MinSlotQuestion& question) {
    return question.stepping ? "stepping" : to_string(question.options.strategy);
}

/// One slot, and what others would need that differ from it a little.
struct OneSlot {
    Car car;
    double length = 0.0;
    double width = 0.0;
    std::optional<int> changes;  ///< the fewest; empty when there are none
    int most_changes = 0;        ///< tried
    Shortfall lacking;           ///< to hold the parallel car, with this clearance
    double clearance = 0.0;      ///< [m]

    struct Variation {
        double by = 0.0;             ///< whole millimetres [m]
        std::string how;             ///< "shorter", "wider"
        std::optional<int> changes;  ///< what that slot needs
    };
    std::vector<Variation> variations;  ///< the least that make a difference
    std::vector<MinSlot> rows;          ///< the shortest slots of its width for the counts in question
};

/// How many changes one slot needs; how much smaller it would have to be to need more, how much larger to need fewer.
OneSlot one_slot(const Car& car, double length, double width, const MinSlotOptions& options);

std::string one_slot_text(const OneSlot& slot);

}  // namespace snug::cli
