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

}  // namespace

std::string min_slot_table(Sought sought, const std::vector<MinSlot>& rows, std::size_t counts) {
    const Sought given = sought == Sought::length ? Sought::width : Sought::length;
    std::string text;
    for (std::size_t from = 0; from < counts; from += columns_in_a_line) {
        const std::size_t to = std::min(from + columns_in_a_line, counts);
        Rows lines = {{std::string(to_string(given))}};
        for (std::size_t k = from; k < to; ++k) lines.back().push_back(std::to_string(rows[k].max_changes));
        for (std::size_t first = 0; first < rows.size(); first += counts) {
            lines.push_back({fixed(*rows[first].size(given), 3)});
            for (std::size_t k = first + from; k < first + to; ++k) {
                const std::optional<double>& size = rows[k].size(sought);
                lines.back().push_back(size ? at_least(*size) : "-");
            }
        }
        text += table(lines, std::string(to - from + 1, 'r')) + '\n';
    }
    return text;
}

std::string fewest_slot_table(Sought sought, const std::vector<MinSlot>& rows) {
    const auto down = [](double size) { return fixed(std::floor(size * 1e3 + 1e-6) / 1e3, 3); };
    const Sought given = sought == Sought::length ? Sought::width : Sought::length;
    Rows lines = {{std::string(to_string(given)), "changes", "impossible below", "parks in"}};
    for (const MinSlot& row : rows) {
        const std::optional<double>& size = row.size(sought);
        lines.push_back({fixed(*row.size(given), 3), std::to_string(row.max_changes), down(row.lower),
                         size ? at_least(*size) : "-"});
    }
    return table(lines, "rrrr");
}

std::string size_proof(Sought sought, const MinSlot& row) {
    const Sought given = sought == Sought::length ? Sought::width : Sought::length;
    double open = 0.0;
    for (const Sizes& sizes : row.open) open += sizes.max - sizes.min;
    std::string text = "Proved for " + std::string(to_string(given)) + ' ' + fixed(*row.size(given), 3) + ", " +
                       changes(row.max_changes) + ": no smaller slot will do";
    if (row.open.empty()) return text + ".\n";
    return text + ", but of\n" + fixed(std::ceil(open * 1e6) * 1e-6, 6) + " m from " + fixed(row.lower, 6) +
           " on nothing is known.\n";
}

std::string one_slot_text(const OneSlot& slot) {
    std::string text =
        name(slot.car) + (slot.changes ? " fits" : " does not fit") + " the " + fixed(slot.length, 3) + " x " +
        fixed(slot.width, 3) + " m slot" +
        (slot.changes ? " with " + changes(*slot.changes) : "\nwith up to " + changes(slot.most_changes)) + ".\n";
    if (const std::string lacking = words(slot.lacking, slot.clearance); !slot.changes && !lacking.empty())
        text += "  It is " + lacking + ".\n";
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
