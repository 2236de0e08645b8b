#include "cli/way_out.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "cli/interrupt.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "sentences/check.hpp"
#include "snug/any_maneuver.hpp"
#include "snug/error.hpp"
#include "snug/leave.hpp"
#include "snug/limits.hpp"
#include "snug/min_slot.hpp"

namespace snug::cli {
namespace {

/// For each of the answers: a lattice so coarse takes some hundredths of it. It is the processor's time that counts, so that the
/// answers of a busy machine are the same.
class Patience {
public:
    explicit Patience(double times = 1.0)
        : end_(std::clock() + static_cast<std::clock_t>(times * 2.0 * CLOCKS_PER_SEC)) {}
    [[nodiscard]] bool left() const { return std::clock() < end_; }

private:
    std::clock_t end_;
};

/// Coarse enough to be quick: the spacing decides where the search ends, and hardly ever the clock.
double coarse(const Car& car) { return std::max(limits::finest, car.length() / 500.0); }

/// Whether the car parks with that strategy in that slot, keeping that clearance.
bool parks(const EntryQuestion& question, Strategy strategy, int most_changes, const Slot& slot,
           const Driving& driving) {
    if (strategy == Strategy::fewest) {
        const auto any = snug::any_maneuver(question.car, slot, driving, question.options.parked, most_changes);
        return any && any->parkable();
    }
    EntryOptions options = question.options;
    options.max_changes = most_changes;
    options.prove = false;
    options.driving = driving;
    return entry(question.car, slot, options).parkable();
}

Slot resized(const Slot& slot, double longer, double wider) {
    return Slot({.length = slot.length() + longer,
                 .width = slot.width() + wider,
                 .side = slot.side(),
                 .corner = slot.corner(),
                 .heading = slot.heading(),
                 .front_setback = slot.front_setback(),
                 .rear_setback = slot.rear_setback(),
                 .curb = slot.curb()});
}

/// By how much the slot would have to be longer (or wider), in whole millimetres, and tried; sought that many times as coarsely.
std::optional<double> enlarged(const EntryQuestion& question, Strategy strategy, int most_changes, Sought sought,
                               double coarser = 1.0) {
    const bool length = sought == Sought::length;
    const Slot& slot = question.slot;
    MinSlotOptions options;
    options.max_changes = most_changes;
    options.strategy = strategy;
    options.sought = sought;
    options.driving = question.options.driving;
    options.parked = question.options.parked;
    options.min_range = strategy == Strategy::fewest ? 0.0 : question.options.min_range;
    options.front_setback = slot.front_setback();
    options.rear_setback = slot.rear_setback();
    options.curb = slot.curb();
    options.resolution = coarser * coarse(question.car);
    options.precision = coarser * 0.01;
    options.progress = [patience = Patience()](double) { return patience.left(); };
    if (strategy == Strategy::fewest && !length && std::isfinite(options.parked.curb)) return std::nullopt;
    const MinSlot found = min_slot(question.car, length ? slot.width() : slot.length(), options);
    if (!found.size(sought)) return std::nullopt;
    const double size = length ? slot.length() : slot.width();
    const double by = millimetre * std::max(1.0, std::ceil((*found.size(sought) - size) / millimetre - 1e-6));
    const Slot larger = length ? resized(slot, by, 0.0) : resized(slot, 0.0, by);
    if (!parks(question, strategy, most_changes, larger, options.driving)) return std::nullopt;
    return by;
}

/// The largest clearance in whole millimetres that parks, below the one asked for.
std::optional<double> less_clearance(const EntryQuestion& question, Strategy strategy, int most_changes) {
    const auto keeping = [&](double millimetres) {
        Driving driving = question.options.driving;
        driving.clearance = millimetres * millimetre;
        return parks(question, strategy, most_changes, question.slot, driving);
    };
    double less = 0.0;
    double more = std::ceil(question.options.driving.clearance / millimetre);
    if (more == 0.0 || !keeping(less)) return std::nullopt;
    while (more - less > 1.0) {
        const double middle = std::floor((less + more) / 2.0);
        (keeping(middle) ? less : more) = middle;
    }
    return less * millimetre;
}

using Rows = std::vector<std::vector<std::string>>;

/// By how much more it will do, in whole centimetres and at most so many metres; each is tried.
std::optional<double> least_more(double most, const std::function<bool(double)>& will_do) {
    constexpr double centimetre = 0.01;
    double less = 0.0, more = std::round(most / centimetre);
    if (!will_do(most)) return std::nullopt;
    while (more - less > 1.0) {
        const double middle = std::floor((less + more) / 2.0);
        (will_do(middle * centimetre) ? more : less) = middle;
    }
    return more * centimetre;
}

/// A size to type, without what adding binary numbers leaves behind.
std::string exactly(double size) { return spelled(std::round(size * 1e9) / 1e9); }

/// What an answer over all maneuvers says of its count.
std::string count_words(const Answer& any) {
    return changes(*any.direction_changes) + (any.proved ? ", the fewest: proved"
                                              : any.lower_bound > 0
                                                  ? ", at least " + std::to_string(any.lower_bound) + " proved"
                                                  : "");
}

}  // namespace

std::optional<Answer> any_maneuver(const EntryQuestion& question) {
    return snug::any_maneuver(question.car, question.slot, question.options.driving, question.options.parked);
}

WayOut way_out(const EntryQuestion& question, Strategy strategy, int most_changes) {
    WayOut out;
    const auto try_out = [](const std::function<void()>& attempt) {
        try {
            attempt();
        } catch (const Error&) {  // beyond what can be asked: no way out is told
        }
    };
    const int most = strategy == Strategy::fewest ? std::min(most_changes, limits::most_changes_fewest) : most_changes;
    if (strategy != Strategy::fewest) out.any = any_maneuver(question);
    if (question.baseline) return out;
    try_out([&] {
        if (most >= limits::usual_changes) return;
        EntryOptions options = question.options;
        options.max_changes.reset();
        options.prove = false;
        if (strategy != Strategy::fewest) {
            out.changes = entry(question.car, question.slot, options).direction_changes;
        } else if (const auto any = any_maneuver(question)) {
            out.changes = any->direction_changes;
        }
    });
    try_out([&] { out.longer = enlarged(question, strategy, most, Sought::length); });
    try_out([&] { out.wider = enlarged(question, strategy, most, Sought::width); });
    try_out([&] { out.clearance = less_clearance(question, strategy, most); });
    if (!out.any || out.any->parkable()) return out;
    try_out([&] {
        const int fewest = std::min(most, limits::most_changes_fewest);
        const std::optional<double> longer = enlarged(question, Strategy::fewest, fewest, Sought::length, 3.0);
        if (longer && (!out.longer || *longer < *out.longer)) out.longer_any = longer;
    });
    return out;
}

std::string way_out_text(const EntryQuestion& question, const WayOut& out) {
    Rows rows;
    if (out.changes)
        rows.push_back({"more changes", changes(*out.changes), "--max-changes " + std::to_string(*out.changes)});
    if (out.any && out.any->direction_changes)
        rows.push_back({"any maneuver", count_words(*out.any), "--strategy fewest"});
    if (out.longer)
        rows.push_back({"a longer slot", "by " + metres(*out.longer),
                        "--length " + exactly(question.slot.length() + *out.longer)});
    if (out.longer_any)
        rows.push_back({"any maneuver", "in a slot longer by " + metres(*out.longer_any),
                        "--length " + exactly(question.slot.length() + *out.longer_any) + " --strategy fewest"});
    if (out.wider)
        rows.push_back(
            {"a wider slot", "by " + metres(*out.wider), "--width " + exactly(question.slot.width() + *out.wider)});
    if (out.clearance)
        rows.push_back({"less clearance", metres(*out.clearance), "--clearance " + fixed(*out.clearance, 3)});
    std::string text;
    if (!rows.empty()) text = "\nWhat would do\n" + table(rows, "lll");
    if (out.any && !out.any->direction_changes && out.any->proved)
        text += "\nNo other maneuver parks either, with up to " + changes(limits::usual_changes) + ": proved.\n";
    return text;
}

namespace {

constexpr double much_slot = 1.0, much_road = 4.0;  ///< more is not thought of [m]

/// The fewest changes if more than `allowed` do, as a row.
template <class Options, class Solve>
void add_more_changes(Rows& rows, Options options, const Solve& solve) {
    if (options.max_changes >= limits::usual_changes) return;
    options.max_changes = limits::usual_changes;
    options.progress = [patience = Patience(2.0)](const auto&) { return interruption() == 0 && patience.left(); };
    if (const auto count = solve(options).direction_changes)
        rows.push_back({"more changes", changes(*count), "--max-changes " + std::to_string(*count)});
}

/// The largest clearance in whole centimetres that does, as a row.
void add_less_clearance(Rows& rows, double asked, const std::function<bool(double)>& will_do) {
    if (asked <= 0.0 || !will_do(0.0)) return;
    const auto given_up = [&](double less) { return asked - less <= 0.0 || will_do(asked - less); };
    const std::optional<double> less = least_more(asked, given_up);
    const double kept = less ? std::max(0.0, std::floor((asked - *less) / millimetre + 0.5) * millimetre) : 0.0;
    rows.push_back({"less clearance", metres(kept), "--clearance " + fixed(kept, 3)});
}

void add(Rows& rows, const char* what, const char* option, double size, const std::optional<double>& by) {
    if (by) rows.push_back({what, "by " + metres(*by), std::string(option) + " " + exactly(size + *by)});
}

std::string what_would_do(const Rows& rows) { return rows.empty() ? "" : "\nWhat would do\n" + table(rows, "lll"); }

}  // namespace

std::string way_out_text(const ParkQuestion& question) {
    ParkOptions options = question.options;
    if (options.time_limit < std::numeric_limits<double>::infinity()) return "";
    options.roomiest = false;
    options.resolution = std::max(options.resolution, coarse(question.car));
    options.progress = [](const ParkProgress&) { return interruption() == 0; };
    const Pose& start = question.scene.start;
    Rows rows;
    const auto solve = [&](const ParkOptions& asked) { return park(question.car, question.scene.place, start, asked); };
    add_more_changes(rows, options, solve);
    options.resolution = std::max(options.resolution, question.car.length() / 200.0);
    // A place in which the car would collide at the start is one that will not do.
    const auto parks = [&](const Place& place, ParkOptions asked) {
        asked.progress = [patience = Patience()](const ParkProgress&) {
            return interruption() == 0 && patience.left();
        };
        try {
            return park(question.car, place, start, asked).parkable();
        } catch (const Error&) {
            return false;
        }
    };
    if (question.street) {
        const Street& street = *question.street;
        const auto in = [&](const Street& larger) {
            return parks(question.leaving ? road_place(larger) : street_place(larger), options);
        };
        const auto enlarged = [&](double Street::*size) {
            return least_more(much_slot, [&](double by) {
                Street larger = street;
                larger.*size += by;
                return in(larger);
            });
        };
        if (street.road)
            add(rows, "a wider road", "--road", *street.road, least_more(much_road, [&](double by) {
                    Street larger = street;
                    *larger.road += by;
                    return in(larger);
                }));
        // In a slot too small one way, more room the other way would only let the car stand askew.
        const double room = 2.0 * options.clearance;
        if (street.width >= question.car.width() + room)
            add(rows, "a longer slot", "--length", street.length, enlarged(&Street::length));
        if (street.length >= question.car.length() + room)
            add(rows, "a wider slot", "--width", street.width, enlarged(&Street::width));
    }
    add_less_clearance(rows, options.clearance, [&](double clearance) {
        ParkOptions nearer = options;
        nearer.clearance = clearance;
        return parks(question.scene.place, nearer);
    });
    return what_would_do(rows);
}

std::string way_out_text(const EntryQuestion& question, const Pose& parked, const FewestOptions& asked) {
    FewestOptions options = asked;
    if (options.time_limit < std::numeric_limits<double>::infinity()) return "";
    options.roomiest = false;
    options.resolution = std::max(options.resolution, coarse(question.car));
    options.progress = nullptr;
    const auto leaves = [&](const Slot& slot, FewestOptions limited) {
        limited.progress = [patience = Patience()](const FewestProgress&) { return patience.left(); };
        try {
            return leave(question.car, slot, parked, limited).parkable();
        } catch (const Error&) {
            return false;
        }
    };
    Rows rows;
    add_more_changes(rows, options,
                     [&](const FewestOptions& more) { return leave(question.car, question.slot, parked, more); });
    add(rows, "a longer slot", "--length", question.slot.length(),
        least_more(much_slot, [&](double by) { return leaves(resized(question.slot, by, 0.0), options); }));
    add_less_clearance(rows, options.driving.clearance, [&](double clearance) {
        FewestOptions nearer = options;
        nearer.driving.clearance = clearance;
        return leaves(question.slot, nearer);
    });
    return what_would_do(rows);
}

std::string fewer_text(int changes_needed, const std::optional<Answer>& any) {
    if (!any || !any->direction_changes || *any->direction_changes >= changes_needed) return "";
    return "Other maneuvers do with " + count_words(*any) + ";\n--strategy fewest shows one.\n";
}

std::string other_maneuvers(const MinSlotQuestion& question, const std::vector<MinSlot>& rows) {
    constexpr std::size_t most_rows = 8;
    const Sought sought = question.options.sought;
    MinSlotOptions options = question.options;
    options.strategy = Strategy::fewest;
    options.min_range = 0.0;
    options.resolution = coarse(question.car);
    options.precision = 0.01;
    if (sought == Sought::width && std::isfinite(options.parked.curb)) return "";
    options.progress = [patience = Patience(2.0)](double) { return patience.left(); };
    std::vector<MinSlot> others;
    std::size_t left_out = 0;
    for (const MinSlot& row : rows) {
        if (row.max_changes > limits::most_changes_fewest) continue;
        if (others.size() == most_rows) {
            ++left_out;
            continue;
        }
        options.max_changes = row.max_changes;
        try {
            const MinSlot found =
                min_slot(question.car, *row.size(sought == Sought::length ? Sought::width : Sought::length), options);
            if (found.size(sought)) others.push_back(found);
        } catch (const Error&) {  // beyond what a lattice holds
        }
    }
    if (others.empty()) return "";
    std::string text = "\nOther maneuvers park where full steering cannot (--strategy fewest):\n\n" +
                       fewest_slot_table(sought, others);
    if (left_out > 0)
        text += "\n" + std::to_string(left_out) + (left_out == 1 ? " more row was" : " more rows were") +
                " not tried: --strategy fewest answers all.\n";
    return text;
}

}  // namespace snug::cli
