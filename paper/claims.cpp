#include "paper/claims.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "snug/baselines.hpp"
#include "snug/io.hpp"

namespace snug::paper {

namespace {

constexpr double tight = 0.4;  ///< the extra slot length the paper calls hard [m]

// Claims.

struct Claim {
    std::string id;
    std::string section;
    std::string claim;
    std::string unit;  ///< empty for a statement
    Json published;
    Json paper_steps;
    Json exact;
    std::string finding;
};

/// A length agrees when it is the same on the paper's grid, anything else when it is the same.
bool agrees(const Claim& claim, double grid_step) {
    if (claim.unit != "m") return claim.exact == claim.published;
    return claim.exact.is_number() &&
           std::abs(claim.exact.get<double>() - claim.published.get<double>()) <= grid_step / 2.0;
}

Json as_json(const Claim& claim, double grid_step) {
    return {{"id", claim.id},       {"section", claim.section},           {"claim", claim.claim},
            {"unit", claim.unit},   {"published", claim.published},       {"paper_steps", claim.paper_steps},
            {"exact", claim.exact}, {"agrees", agrees(claim, grid_step)}, {"finding", claim.finding}};
}

/// A length from the paper's grid.
Json on_grid_json(const std::optional<double>& value) { return value ? Json(on_grid(*value)) : Json(); }

template <class Number>
Json json_of(const std::optional<Number>& number) {
    return number ? Json(*number) : Json();
}

// Words.

std::string fixed(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value);
    return text;
}

std::string metres(double value) { return fixed(value, 3) + " m"; }

std::string metres(const std::optional<double>& value) { return value ? metres(*value) : "no length"; }

std::string count(const std::optional<int>& value) { return value ? std::to_string(*value) : "none up to 200"; }

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

std::string shown_name(const Car& car) {
    if (car.name() == "renault-zoe") return "ZOE";
    if (car.name() == "opel-corsa") return "Corsa";
    if (car.name() == "vw-transporter") return "transporter";
    return "AMG GT";
}

const CarMinima& of(const Evidence& evidence, const char* name) {
    return *std::find_if(evidence.minima.begin(), evidence.minima.end(),
                         [&](const CarMinima& one) { return one.car.name() == name; });
}

std::optional<double> difference(const std::optional<double>& a, const std::optional<double>& b) {
    return a && b ? std::optional(*a - *b) : std::nullopt;
}

std::optional<int> fewest(const Car& car, double length, double width, const std::optional<Stepping>& steps) {
    EntryOptions options;
    options.prove = false;
    const Slot slot({.length = length, .width = width});
    return (steps ? entry(car, slot, options, *steps) : entry(car, slot, options)).direction_changes;
}

// Section 4.1: comparison to related works.

/// The fewest changes in one slot: published, by Algorithm 1, by it with a tenth of the step, and exactly.
Claim one_slot(const Claim& claim, const Car& car, double length, double width, Work& work) {
    const Stepping steps = work.options().grids.steps;
    Stepping fine = steps;
    fine.step /= 10.0;
    const std::vector<std::optional<Stepping>> strategies = {steps, fine, std::nullopt};
    std::vector<std::optional<int>> changes(strategies.size());
    work.each(strategies.size(), [&](std::size_t i) { changes[i] = fewest(car, length, width, strategies[i]); });
    Claim judged = claim;
    judged.paper_steps = json_of(changes[0]);
    judged.exact = json_of(changes[2]);
    if (changes[0] == changes[2]) {
        judged.finding = count(changes[2]) + " changes are the fewest.";
    } else {
        judged.finding =
            "Moves of Algorithm 1 stop up to a step short of contact and lose that room again and again: with steps "
            "of " +
            fixed(1e3 * steps.step, 1) + " mm it needs " + count(changes[0]) + " changes, with " +
            fixed(1e3 * fine.step, 1) + " mm " + count(changes[1]) + ", driven exactly " + count(changes[2]) + ".";
    }
    return judged;
}

void add_related_works(std::vector<Claim>& claims, const Evidence& evidence, Work& work) {
    const Car mid_size = find_car("mid-size").value();
    const Car zoe = find_car("renault-zoe").value();
    claims.push_back(one_slot({"mid-size-5.1x2.2",
                               "4.1",
                               "The mid-sized vehicle parks in a slot of 5.1 m by 2.2 m with 10 direction changes.",
                               "direction changes",
                               10,
                               {},
                               {},
                               {}},
                              mid_size, 5.1, 2.2, work));
    const Claim ours = claims.back();
    const auto beats = [](const Json& changes, int theirs) {
        return changes.is_number() && changes.get<int>() < theirs;
    };
    claims.push_back({"zips-goal-not-optimal", "4.1",
                      "Zips et al. need 12 direction changes there, so their goal position is not optimal.", "", true,
                      beats(ours.paper_steps, 12), beats(ours.exact, 12),
                      "Full steering from the best entry needs " + ours.exact.dump() + " changes, not 12."});
    claims.push_back(one_slot({"zoe-4.5x2.0",
                               "4.1",
                               "The ZOE needs 19 direction changes in a slot of 4.5 m by 2.0 m, as many as Li et al.",
                               "direction changes",
                               19,
                               {},
                               {},
                               {}},
                              zoe, 4.5, 2.0, work));

    int both = 0;
    int fewer = 0;
    int more = 0;
    int ours_only = 0;
    int theirs_only = 0;
    for (const TrialsInSlot& one : evidence.trials) {
        const auto& [deduced, found] = one.trials;
        ours_only += found && !deduced ? 1 : 0;
        theirs_only += deduced && !found ? 1 : 0;
        if (!deduced || !found) continue;
        ++both;
        fewer += *found < *deduced ? 1 : 0;
        more += *found > *deduced ? 1 : 0;
    }
    const auto slots = [](int number) { return std::to_string(number) + (number == 1 ? " slot" : " slots"); };
    claims.push_back(
        {"reversed-trials-goal", "4.1",
         "Several reversed trials need fewer direction changes from the paper's goal positions than from the "
         "goal Vorobieva et al. use (ZOE, slot 2.0 m wide, up to 5.8 m long).",
         "", true, Json(), fewer > 0 && more == 0 && theirs_only == 0,
         "Of " + slots(both) + " where both goals work, the paper's needs fewer changes in " + std::to_string(fewer) +
             ", as many in " + std::to_string(both - fewer - more) + ", more in " + std::to_string(more) + "; " +
             slots(ours_only) + " only the paper's goal fits, " + slots(theirs_only) + " only the other."});
}

// Section 4.2: limit on the direction changes.

double total_width(const std::vector<Subrange>& ranges) {
    double sum = 0.0;
    for (const Subrange& range : ranges) sum += range.max - range.min;
    return sum;
}

/// How often the headings that park get fewer from one width to the next, `slack` apart [rad].
template <class Ranges>
int shrinks(const std::vector<SlotHeadings>& over_width, Ranges ranges, double slack) {
    int times = 0;
    for (std::size_t i = 1; i < over_width.size(); ++i) {
        const bool next = over_width[i].max_changes == over_width[i - 1].max_changes;
        if (next && total_width(ranges(over_width[i])) < total_width(ranges(over_width[i - 1])) - slack) ++times;
    }
    return times;
}

/// Seen from wide to narrow slots of one length: one subrange, then more, then fewer again.
struct RiseAndFall {
    bool one_when_wide = true;
    bool rises = false;
    bool falls = false;
    int most = 0;
};

template <class Ranges>
RiseAndFall rise_and_fall(std::vector<SlotHeadings>::const_iterator from, std::vector<SlotHeadings>::const_iterator to,
                          Ranges ranges) {
    RiseAndFall seen;
    std::vector<int> numbers;
    for (auto at = from; at != to; ++at) numbers.push_back(static_cast<int>(ranges(*at).size()));
    const auto narrowest = std::find_if(numbers.begin(), numbers.end(), [](int number) { return number > 0; });
    if (narrowest == numbers.end()) return {false, false, false, 0};
    seen.most = *std::max_element(numbers.begin(), numbers.end());
    seen.one_when_wide = numbers.back() == 1;
    seen.rises = seen.most > 1;
    seen.falls = *narrowest < seen.most;
    return seen;
}

const std::vector<Subrange>& exact_ranges(const SlotHeadings& at) { return at.exact; }
const std::vector<Subrange>& sampled_ranges(const SlotHeadings& at) { return at.sampled; }

void add_headings(std::vector<Claim>& claims, const Evidence& evidence, Work& work) {
    const std::vector<SlotHeadings>& over_width = evidence.over_width;
    const int shrunk = shrinks(over_width, exact_ranges, 1e-9);
    const double sampling = 2.0 * work.options().grids.steps.heading_step;
    claims.push_back({"headings-wider-with-width", "4.2", "A wider slot can be entered from a wider range of headings.",
                      "", true, shrinks(evidence.stepped_over_width, sampled_ranges, sampling) == 0, shrunk == 0,
                      shrunk == 0
                          ? "All entry headings together never get fewer from one width to the next, at each limit."
                          : "All entry headings together shrink at " + std::to_string(shrunk) + " of " +
                                std::to_string(over_width.size() - 4) +
                                " steps of the width; the upper end of the range keeps rising, but where two "
                                "subranges meet or the lowest subrange appears the order of contacts changes."});

    // The headings of a lower limit are part of those of a higher one.
    const std::size_t widths = over_width.size() / 4;
    bool nested = true;
    for (std::size_t i = widths; i < over_width.size(); ++i)
        nested = nested && total_width(over_width[i].exact) >= total_width(over_width[i - widths].exact) - 1e-9;
    claims.push_back({"headings-wider-with-changes", "4.2", "More direction changes widen the range of entry headings.",
                      "", true, Json(), nested,
                      "Headings that park with a few changes also park when more are allowed."});

    std::vector<std::string> narrowest;
    std::vector<double> least;
    for (std::size_t i = 0; i < over_width.size(); ++i) {
        const bool first_of_limit = i % widths == 0 || over_width[i - 1].exact.empty();
        if (over_width[i].exact.empty() || !first_of_limit || least.size() > i / widths) continue;
        least.push_back(over_width[i].extra_width);
        narrowest.push_back(metres(over_width[i].extra_width) + " for " + std::to_string(over_width[i].max_changes));
    }
    claims.push_back({"narrower-slots-with-changes", "4.2",
                      "With more direction changes narrower slots can be entered.", "", true, Json(),
                      std::is_sorted(least.rbegin(), least.rend()) && least.front() > least.back(),
                      "At the extra length 1.1 m the ZOE needs an extra width of " + listed(narrowest) + " changes."});

    const auto split = [](const std::vector<SlotHeadings>& all, auto ranges) {
        return std::count_if(all.begin(), all.end(), [&](const SlotHeadings& at) { return ranges(at).size() > 1; });
    };
    const auto split_exactly = split(over_width, exact_ranges);
    claims.push_back({"headings-in-subranges", "4.2", "The entry headings of one slot may fall into several subranges.",
                      "", true, split(evidence.stepped_over_width, sampled_ranges) > 0, split_exactly > 0,
                      "They do in " + std::to_string(split_exactly) + " of the " + std::to_string(over_width.size()) +
                          " slots and limits of the figure."});

    const std::vector<SlotHeadings>& over_length = evidence.over_length;
    const auto lengths = static_cast<std::ptrdiff_t>(over_length.size() / widths);
    int one_when_wide = 0;
    int rise_fall = 0;
    int sampled_rise_fall = 0;
    int most = 0;
    for (std::ptrdiff_t i = 0; i < lengths; ++i) {
        const auto from = over_length.begin() + i * static_cast<std::ptrdiff_t>(widths);
        const auto to = from + static_cast<std::ptrdiff_t>(widths);
        const RiseAndFall seen = rise_and_fall(from, to, exact_ranges);
        const RiseAndFall seen_by_sampling = rise_and_fall(from, to, sampled_ranges);
        sampled_rise_fall += seen_by_sampling.rises && seen_by_sampling.falls ? 1 : 0;
        one_when_wide += seen.one_when_wide ? 1 : 0;
        rise_fall += seen.rises && seen.falls ? 1 : 0;
        most = std::max(most, seen.most);
    }
    const RiseAndFall stepped =
        rise_and_fall(evidence.stepped_over_width.begin(), evidence.stepped_over_width.end(), sampled_ranges);
    const std::string all_lengths = std::to_string(lengths);
    claims.push_back(
        {"one-subrange-when-wide", "4.2", "In wide enough slots there is one range of entry headings only.", "", true,
         stepped.one_when_wide, one_when_wide == lengths,
         "True of " + std::to_string(one_when_wide) + " of the " + all_lengths +
             " extra lengths from 0.5 m to 1.9 m, at an extra width of " + metres(work.options().grids.widest) + "."});
    claims.push_back(
        {"subranges-rise-and-fall", "4.2",
         "Towards narrower slots the number of subranges rises, and falls again in those that are too narrow.", "",
         true, stepped.rises && stepped.falls, rise_fall == lengths,
         "It rises and falls again at " + std::to_string(rise_fall) + " of the " + all_lengths +
             " extra lengths, to at most " + std::to_string(most) + " subranges" +
             (rise_fall == lengths ? "."
                                   : "; at the others no subrange is lost down to the narrowest slot. Without those "
                                     "narrower than the paper's heading step it falls again at " +
                                         std::to_string(sampled_rise_fall) + ": sampled headings miss them.")});
}

// Section 4.3: minimum slot dimensions.

struct FewestWhenTight {
    std::optional<int> exact;    ///< at any of the grid's widths
    std::optional<int> stepped;  ///< at the widest, where the exact answer is as low as anywhere
};

/// The fewest changes in a slot 0.4 m longer than each car.
std::vector<FewestWhenTight> fewest_when_tight(const Evidence& evidence, Work& work) {
    const Grids& grids = work.options().grids;
    const std::vector<double> widths = extra_widths(grids, grids.width_step);
    const std::size_t per_car = widths.size() + 1;
    std::vector<std::optional<int>> changes(evidence.minima.size() * per_car);
    work.each(changes.size(), [&](std::size_t i) {
        const Car& car = evidence.minima[i / per_car].car;
        const std::size_t width = i % per_car;
        const bool exactly = width < widths.size();
        changes[i] = fewest(car, car.length() + tight, car.width() + (exactly ? widths[width] : widths.back()),
                            exactly ? std::nullopt : std::optional(grids.steps));
    });
    std::vector<FewestWhenTight> all(evidence.minima.size());
    for (std::size_t i = 0; i < changes.size(); ++i) {
        FewestWhenTight& one = all[i / per_car];
        if (i % per_car == widths.size())
            one.stepped = changes[i];
        else if (changes[i] && (!one.exact || *changes[i] < *one.exact))
            one.exact = changes[i];
    }
    return all;
}

/// The narrowest slot, 0.4 m longer than the car, for at most 30 changes: exactly, and the first width of the paper's grid.
struct Narrowest {
    std::optional<double> exact;
    std::optional<double> stepped;
};

Narrowest narrowest_when_tight(const Car& car, Work& work) {
    const Grids& grids = work.options().grids;
    const auto width = min_slot(car, car.length() + tight, {.max_changes = 30, .sought = Sought::width}).width;
    if (!width) return {};
    Narrowest found{*width - car.width(), {}};
    EntryOptions options;
    options.prove = false;
    options.max_changes = 30;
    const double before = std::floor(*found.exact / grids.width_step) - 1.0;
    for (double i = std::max(0.0, before); i < before + 20.0 && !found.stepped; i += 1.0) {
        const double extra = i * grids.width_step;
        const Slot wider({.length = car.length() + tight, .width = car.width() + extra});
        if (entry(car, wider, options, grids.steps).parkable()) found.stepped = extra;
    }
    return found;
}

constexpr const char* between_counts =
    "the paper looked at 20 and 30 changes and at nothing between: 20 are too few, 30 more than enough";

void add_tight_slots(std::vector<Claim>& claims, const Evidence& evidence, Work& work) {
    const std::vector<FewestWhenTight> when_tight = fewest_when_tight(evidence, work);
    const double widest = work.options().grids.widest;
    const auto claim_about = [&](std::size_t car, const char* id, const char* sentence, int published) {
        const FewestWhenTight& found = when_tight[car];
        const bool same = found.exact == published;
        claims.push_back(
            {id, "4.3", sentence, "direction changes", published, json_of(found.stepped), json_of(found.exact),
             "The fewest are " + count(found.exact) + (same ? "." : std::string("; ") + between_counts + ".")});
    };
    claim_about(0, "zoe-40cm", "The ZOE needs at least 30 direction changes in a slot 0.4 m longer than itself.", 30);

    const CarMinima& zoe = of(evidence, "renault-zoe");
    const std::optional<double> gain = difference(zoe.extra_length(30, widest), zoe.extra_length(100, widest));
    claims.push_back(
        {"zoe-100-changes", "4.3", "Going from 30 to 100 direction changes shortens the ZOE's slot by 0.02 m.", "m",
         0.02, on_grid_json(difference(zoe.stepped_extra_length(30, widest), zoe.stepped_extra_length(100, widest))),
         json_of(gain),
         "From " + metres(zoe.extra_length(30, widest)) + " to " + metres(zoe.extra_length(100, widest)) +
             " of extra length."});
    claim_about(1, "corsa-40cm", "The Corsa parks in a slot 0.4 m longer than itself with 10 direction changes.", 10);
    claim_about(2, "transporter-40cm",
                "The transporter needs 30 direction changes in a slot 0.4 m longer than itself, as the ZOE does.", 30);

    const CarMinima& transporter = of(evidence, "vw-transporter");
    std::vector<Narrowest> narrow(2);
    work.each(2, [&](std::size_t i) { narrow[i] = narrowest_when_tight((i == 0 ? zoe : transporter).car, work); });
    const auto wider = [&](std::optional<double> Narrowest::*width) {
        return narrow[0].*width && narrow[1].*width ? Json(narrow[1].*width > narrow[0].*width) : Json();
    };
    claims.push_back(
        {"transporter-40cm-width", "4.3",
         "With those 30 direction changes the transporter needs more extra width than the ZOE.", "", true,
         wider(&Narrowest::stepped), wider(&Narrowest::exact),
         "It needs " + metres(narrow[1].exact) + " more than its own width, the ZOE " + metres(narrow[0].exact) + "."});

    const CarMinima& amg = of(evidence, "mercedes-amg-gt");
    const auto beyond_reason = [](const std::optional<int>& changes) { return !changes || *changes > 100; };
    claims.push_back(
        {"amg-40cm", "4.3",
         "The AMG GT does not get into a slot 0.4 m longer than itself with a reasonable number of direction changes.",
         "", true, beyond_reason(when_tight[3].stepped), beyond_reason(when_tight[3].exact),
         "With 100 changes its slot must be " + metres(amg.extra_length(100, widest)) + " longer; 0.4 m take " +
             count(when_tight[3].exact) + " changes."});
}

void add_little_gained(std::vector<Claim>& claims, const Evidence& evidence, Work& work) {
    const Grids& grids = work.options().grids;
    const double widest = grids.widest;
    bool small = true;
    std::vector<std::string> gains;
    double largest = 0.0;
    std::string where;
    for (const CarMinima& car : evidence.minima) {
        const std::optional<double> gain = difference(car.extra_length(20, widest), car.extra_length(100, widest));
        small = small && gain && *gain < 0.1;
        gains.push_back(metres(gain) + " (" + shown_name(car.car) + ")");
        for (const double width : extra_widths(grids, grids.width_step)) {
            const auto here = difference(car.extra_length(20, width), car.extra_length(100, width));
            if (!here || *here <= largest) continue;
            largest = *here;
            where = shown_name(car.car) + " at an extra width of " + fixed(width, 2) + " m";
        }
    }
    Json small_stepped = true;
    for (const CarMinima& car : evidence.minima) {
        const auto gain = difference(car.stepped_extra_length(20, widest), car.stepped_extra_length(100, widest));
        small_stepped = small_stepped.get<bool>() && gain && *gain < 0.1;
    }
    claims.push_back({"beyond-20-changes", "4.3",
                      "More than 20 direction changes shorten the slot only by something of the order of 0.01 m.", "",
                      true, small_stepped, small,
                      "In wide slots 100 changes instead of 20 gain " + listed(gains) + "; the most in any slot is " +
                          metres(largest) + " (" + where + ")."});

    const CarMinima& zoe = of(evidence, "renault-zoe");
    double lost_stepped = 0.0;
    double lost = 0.0;
    double lost_with_changes = 0.0;
    int at = 0;
    for (const int changes : counts()) {
        const double one =
            difference(zoe.extra_length(changes, wide_enough), zoe.extra_length(changes, widest)).value_or(0.0);
        if (one > lost) at = changes;
        lost = std::max(lost, one);
        if (changes > 0) lost_with_changes = std::max(lost_with_changes, one);
        lost_stepped = std::max(lost_stepped, difference(zoe.stepped_extra_length(changes, wide_enough),
                                                         zoe.stepped_extra_length(changes, widest))
                                                  .value_or(0.0));
    }
    claims.push_back({"beyond-25cm-width", "appendix",
                      "More than 0.25 m of extra width does not shorten the ZOE's slot.", "m", 0.0,
                      on_grid(lost_stepped), lost,
                      std::abs(lost) < grids.length_step / 2.0
                          ? "The most gained at any count is " + metres(lost) + "."
                          : "True once the car may change direction (at most " + metres(lost_with_changes) +
                                "); with " + (at == 0 ? "no change" : std::to_string(at) + " changes") +
                                " the slot still gets " + metres(lost) + " shorter up to " + metres(widest) +
                                ", because in one move a car enters the more steeply the deeper the slot is."});

    const auto changes_at = [&](double extra_length, double extra_width) {
        return fewest(zoe.car, zoe.car.length() + extra_length, zoe.car.width() + extra_width, {});
    };
    const auto base = changes_at(0.5, wide_enough);
    const auto wider = changes_at(0.5, wide_enough + 0.1);
    const auto longer = changes_at(0.6, wide_enough);
    claims.push_back({"length-over-width", "appendix", "Extra slot length matters more than extra slot width.", "",
                      true, Json(), base && wider && longer && *base - *longer > *base - *wider,
                      "A slot 0.5 m longer and 0.25 m wider than the ZOE takes " + count(base) +
                          " changes; 0.1 m more width leave " + count(wider) + ", 0.1 m more length " + count(longer) +
                          "."});
}

void add_shapes(std::vector<Claim>& claims, const Evidence& evidence, Work& work) {
    const Grids& grids = work.options().grids;
    // In narrow slots an even number of changes gains nothing over the odd one below it.
    const auto in_pairs = [](const auto& length_with) {
        for (int odd = 3; odd < 10; odd += 2) {
            const auto here = length_with(odd);
            const auto even = length_with(odd + 1);
            const auto below = length_with(odd - 1);
            if (!here || !even || !below || *here - *even > 1e-3 || *below - *here < 1e-3) return false;
        }
        return true;
    };
    std::vector<std::string> stretches;
    bool zoe_in_pairs = false;
    for (const CarMinima& car : evidence.minima) {
        double first = 0.0;
        double last = 0.0;
        for (const double width : extra_widths(grids, grids.width_step)) {
            if (!in_pairs([&](int changes) { return car.extra_length(changes, width); })) continue;
            if (last == 0.0) first = width;
            last = width;
        }
        if (last == 0.0) continue;
        zoe_in_pairs = zoe_in_pairs || car.car.name() == "renault-zoe";
        stretches.push_back(fixed(first, 2) + " to " + fixed(last, 2) + " m (" + shown_name(car.car) + ")");
    }
    const CarMinima& zoe = of(evidence, "renault-zoe");
    claims.push_back(
        {"even-and-odd", "4.3",
         "Whether the number of direction changes is even or odd decides the shape of the minimum curves.", "", true,
         in_pairs([&](int changes) { return zoe.stepped_extra_length(changes, 0.1); }), zoe_in_pairs,
         stretches.empty() ? "No stretch of widths was found where it does."
                           : "At extra widths of " + listed(stretches) +
                                 " the curves run in pairs: 4, 6, 8 and 10 changes need the same length as 3, 5, "
                                 "7 and 9; in wider slots every further change helps."});

    const CarMinima& transporter = of(evidence, "vw-transporter");
    const CarMinima& amg = of(evidence, "mercedes-amg-gt");
    std::vector<std::string> pairs;
    bool less = true;
    Json less_stepped = true;
    int longer = 0;
    int compared = 0;
    double longer_up_to = 0.0;
    for (int changes = 0; changes <= 4; ++changes) {
        const auto lead =
            difference(amg.extra_length(changes, grids.widest), transporter.extra_length(changes, grids.widest));
        less = less && lead && *lead > 0.0;
        pairs.push_back(metres(transporter.extra_length(changes, grids.widest)) + " against " +
                        metres(amg.extra_length(changes, grids.widest)));
        const auto lead_stepped = difference(amg.stepped_extra_length(changes, grids.widest),
                                             transporter.stepped_extra_length(changes, grids.widest));
        less_stepped = less_stepped.get<bool>() && lead_stepped && *lead_stepped > 0.0;
        for (const double width : extra_widths(grids, grids.width_step)) {
            const auto here = difference(amg.extra_length(changes, width), transporter.extra_length(changes, width));
            if (!here) continue;
            ++compared;
            if (*here > 0.0) continue;
            ++longer;
            longer_up_to = std::max(longer_up_to, width);
        }
    }
    claims.push_back(
        {"transporter-and-sports-car", "appendix",
         "Parking the transporter takes less extra slot length than parking the sports car.", "", true, less_stepped,
         less,
         "In slots " + metres(grids.widest) + " wider than the car, with 0 to 4 changes: " + listed(pairs) + "." +
             (less_stepped.get<bool>() ? std::string()
                                       : " On the paper's grid of lengths not all of these pairs differ.") +
             (longer == 0 ? std::string(" So it is at every width where both can park.")
                          : " In " + std::to_string(longer) + " of the " + std::to_string(compared) +
                                " widths and counts where both can park it is the other way round, all up to " +
                                metres(longer_up_to) + " of extra width.")});
}

}  // namespace

File claims(const Evidence& evidence, Work& work) {
    std::vector<Claim> all;
    add_related_works(all, evidence, work);
    add_headings(all, evidence, work);
    add_tight_slots(all, evidence, work);
    add_little_gained(all, evidence, work);
    add_shapes(all, evidence, work);

    const Grids& grids = work.options().grids;
    Json list = Json::array();
    for (const Claim& claim : all) list.push_back(as_json(claim, grids.length_step));
    const Json json = {{"schema", 1},
                       {"paper_steps",
                        {{"step", grids.steps.step},
                         {"heading_step", grids.steps.heading_step},
                         {"width_step", grids.width_step},
                         {"length_step", grids.length_step}}},
                       {"claims", list}};
    return {"claims.json", write(json)};
}

}  // namespace snug::paper
