#include "cli/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "cli/table.hpp"
#include "cli/words.hpp"
#include "io/csv.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"

namespace snug::cli {
namespace {

constexpr int looks = 100;  // at clearances side by side, before the largest that parks is narrowed down

Driving keeping(const ClearanceQuestion& question, double clearance) {
    Driving driving = question.options.driving;
    driving.clearance = clearance;
    return driving;
}

/// What there is no room for: between the ends of the slot, or between its sides. [m]
double no_room(const ClearanceQuestion& question) {
    const double along = question.slot.length() - question.car.length();
    const double across = question.slot.width() - question.car.width();
    return std::max(0.0, std::max(along, across));
}

KeptClearance by_full_steering(const ClearanceQuestion& question, int max_changes) {
    const auto parks = [&](double clearance) {
        EntryOptions options;
        options.max_changes = max_changes;
        options.min_range = question.options.min_range;
        options.driving = keeping(question, clearance);
        options.parked = question.options.parked;
        return entry(question.car, question.slot, options).parkable();
    };
    const double most = no_room(question);
    int look = looks;
    while (look >= 0 && !parks(most * look / looks)) --look;
    if (look < 0) return {max_changes, std::nullopt, 0.0};
    double less = most * look / looks;
    double more = most * std::min(looks, look + 1) / looks;
    while (more - less > 1e-9) {
        const double middle = less + (more - less) / 2.0;
        (parks(middle) ? less : more) = middle;
    }
    return {max_changes, less, 0.0};
}

/// More clearance is never easier over all maneuvers, so each answer narrows one of the two bounds, or neither.
KeptClearance by_any_maneuver(const ClearanceQuestion& question, int max_changes) {
    constexpr double precision = 1e-4;  // [m]
    const double resolution =
        question.options.resolution > 0.0 ? question.options.resolution : question.car.length() / 2000.0;
    const auto answer = [&](double clearance) {
        FewestOptions options;
        options.max_changes = max_changes;
        options.driving = keeping(question, clearance);
        options.parked = question.options.parked;
        options.resolution = resolution;
        options.roomiest = false;
        return fewest(question.car, question.slot, options);
    };
    KeptClearance kept = {max_changes, std::nullopt, no_room(question)};
    const Answer without = answer(0.0);
    if (!without.parkable()) {
        if (without.proved) kept.upper = 0.0;
        return kept;
    }
    double less = 0.0;
    for (double more = kept.upper; more - less > precision;) {
        const double middle = less + (more - less) / 2.0;
        const Answer there = answer(middle);
        if (there.parkable()) {
            less = middle;
            continue;
        }
        more = middle;
        if (there.proved) kept.upper = std::min(kept.upper, middle);
    }
    kept.clearance = less;
    return kept;
}

}  // namespace

std::vector<KeptClearance> kept_clearances(const ClearanceQuestion& question) {
    const bool full = question.options.strategy == Strategy::max_steer;
    std::vector<KeptClearance> rows;
    for (const int most : question.max_changes)
        rows.push_back(full ? by_full_steering(question, most) : by_any_maneuver(question, most));
    return rows;
}

std::string clearance_text(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows) {
    const bool all = question.options.strategy == Strategy::fewest;
    std::vector<std::vector<std::string>> lines = {{"changes", "clearance"}};
    if (all) lines.front().emplace_back("impossible above");
    for (const KeptClearance& row : rows) {
        lines.push_back({std::to_string(row.max_changes), row.clearance ? at_most(*row.clearance) : "-"});
        if (all) lines.back().push_back(at_least(row.upper));
    }
    return name(question.car) + " in the " + fixed(question.slot.length(), 3) + " x " + metres(question.slot.width()) +
           " slot: the largest clearance [m] it can keep" + (all ? "\nover all maneuvers," : ",") +
           "\nby the most direction changes allowed\n\n" + table(lines, all ? "rrr" : "rr") +
           "\nRounded down to millimetres; - where it does not park without any.\n";
}

std::string clearance_csv(const ClearanceQuestion& question, const std::vector<KeptClearance>& rows) {
    const bool all = question.options.strategy == Strategy::fewest;
    Csv csv;
    for (const char* column : {"max_changes", "width", "length", "clearance"}) csv.add_field(column);
    if (all) csv.add_field("clearance_upper");
    csv.end_row();
    for (const KeptClearance& row : rows) {
        if (all) {
            csv.row(row.max_changes, question.slot.width(), question.slot.length(), row.clearance, row.upper);
        } else {
            csv.row(row.max_changes, question.slot.width(), question.slot.length(), row.clearance);
        }
    }
    return csv.text();
}

}  // namespace snug::cli
