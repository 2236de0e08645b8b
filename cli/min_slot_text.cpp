// Minimum slots for people: a table to look things up in, and a few sentences about one slot.
#include <algorithm>
#include <cmath>

#include "cli/min_slot.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"

namespace snug::cli {
namespace {

constexpr std::size_t columns_in_a_line = 9;

using Rows = std::vector<std::vector<std::string>>;

/// Rounded up, so that a slot of the size shown is large enough. [m]
std::string at_least(double size) { return fixed(std::ceil(size * 1000.0 - 1e-6) / 1000.0, 3); }

}  // namespace

std::string min_slot_table(Given given, const std::vector<MinSlotRow>& rows, std::size_t counts) {
    std::string text;
    for (std::size_t from = 0; from < counts; from += columns_in_a_line) {
        const std::size_t to = std::min(from + columns_in_a_line, counts);
        Rows lines = {{given == Given::width ? "width" : "length"}};
        for (std::size_t k = from; k < to; ++k) lines.back().push_back(std::to_string(rows[k].max_changes));
        for (std::size_t first = 0; first < rows.size(); first += counts) {
            lines.push_back({fixed(rows[first].given, 3)});
            for (std::size_t k = first + from; k < first + to; ++k) {
                const std::optional<MinSlot>& slot = rows[k].slot;
                lines.back().push_back(!slot ? "-" : at_least(given == Given::width ? slot->length : slot->width));
            }
        }
        text += table(lines, std::string(to - from + 1, 'r')) + '\n';
    }
    return text;
}

std::string one_slot_text(const OneSlot& slot) {
    std::string text =
        name(slot.car) + (slot.changes ? " fits" : " does not fit") + " the " + fixed(slot.length, 3) + " x " +
        fixed(slot.width, 3) + " m slot" +
        (slot.changes ? " with " + changes(*slot.changes) : "\nwith up to " + changes(slot.most_changes)) + ".\n";
    if (const std::string lacking = words(slot.lacking); !lacking.empty()) text += "  It is " + lacking + ".\n";
    for (const OneSlot::Variation& variation : slot.variations) {
        const bool easier = variation.changes && variation.changes < slot.changes.value_or(slot.most_changes + 1);
        text +=
            "  " + fixed(variation.by, 3) + " m " + variation.how +
            (!variation.changes ? " is not possible with up to " + std::to_string(slot.most_changes)
                                : (easier ? " would do with " : " would need ") + std::to_string(*variation.changes)) +
            '\n';
    }
    return text;
}

}  // namespace snug::cli
