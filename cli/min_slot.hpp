// What `snug min-slot` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "snug/entry.hpp"
#include "snug/sweep.hpp"

namespace snug::cli {

/// Which of the slot's dimensions is given; the other is sought.
enum class Given { width, length };

struct MinSlotQuestion {
    Car car;
    Given given = Given::width;
    std::vector<double> sizes;  ///< the widths or lengths given
    std::vector<int> max_changes;
    MinSlotOptions options;
    Strategy strategy = MaxSteer{};
    double step = 0.01;  ///< of the paper's loop [m]
    int threads = 0;
};

/// The minimum slots for some given widths (or lengths), counts inside, as a table with a column for every count. At most
/// 80 columns.
std::string min_slot_table(Given given, const std::vector<MinSlotRow>& rows, std::size_t counts);

/// One slot, and what others would need that differ from it a little.
struct OneSlot {
    Car car;
    double length = 0.0;
    double width = 0.0;
    std::optional<int> changes;  ///< the fewest; empty when there are none
    int most_changes = 0;        ///< tried
    Shortfall lacking;           ///< to hold the car at all

    struct Variation {
        double by = 0.0;             ///< whole millimetres [m]
        std::string how;             ///< "shorter", "wider"
        std::optional<int> changes;  ///< what that slot needs
    };
    std::vector<Variation> variations;  ///< the least that make a difference
    std::vector<MinSlotRow> rows;       ///< the shortest slots of its width for the counts in question
};

/// How many changes one slot needs; how much smaller it would have to be to need more, how much larger to need fewer.
OneSlot one_slot(const Car& car, double length, double width, const MinSlotOptions& options);

std::string one_slot_text(const OneSlot& slot);

}  // namespace snug::cli
