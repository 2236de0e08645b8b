#include "cli/min_street.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/interrupt.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "snug/io.hpp"
#include "snug/sweep.hpp"

namespace snug::cli {
namespace {

/// "the narrowest road", "the shortest bay"
std::string superlative(StreetSize sought, bool parallel) {
    const std::string place = parallel ? "slot" : "bay";
    switch (sought) {
        case StreetSize::road: return "narrowest road";
        case StreetSize::width: return "narrowest " + place;
        case StreetSize::length: break;
    }
    return "shortest " + place;
}

/// Rounded up or down, so that what is claimed of the number shown is true. [m]
std::string up(double size) { return fixed(std::ceil(size * 1e3 - 1e-6) / 1e3, 3); }
std::string down(double size) { return fixed(std::floor(size * 1e3 + 1e-6) / 1e3, 3); }

}  // namespace

std::string min_street_text(const MinStreetQuestion& question, const std::vector<MinStreet>& rows) {
    const StreetSize sought = question.options.sought;
    const Street& street = question.streets.front();
    const bool parallel = street.angle == 0.0;
    std::string given;
    for (const StreetSize which : {StreetSize::length, StreetSize::width, StreetSize::road}) {
        if (which == sought || which == question.listed) continue;
        const std::optional<double> size = size_of(street, which);
        const std::string name(to_string(which));
        given += ", " + name + ' ' + (size ? metres(*size) : std::string("open"));
    }
    std::string text = name(question.car) + " (" + fixed(question.car.length(), 3) + " x " +
                       metres(question.car.width()) + "): the " + superlative(sought, parallel) +
                       " [m] over all maneuvers\n" +
                       (parallel ? "from beside the front neighbour"
                                 : "at " + fixed(street.angle * 180.0 / std::numbers::pi, 1) + " deg, " +
                                       (street.enter == Enter::backward ? "tail first" : "nose first")) +
                       given + "\n\n";
    std::vector<std::vector<std::string>> lines = {
        {std::string(to_string(question.listed)), "changes", "impossible below", "parks in"}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const MinStreet& row = rows[i];
        const std::optional<double> size = size_of(question.streets[i / question.max_changes.size()], question.listed);
        lines.push_back({size ? fixed(*size, 3) : "open", std::to_string(row.max_changes), down(row.lower),
                         row.size ? up(*row.size) : "-"});
    }
    text += table(lines, "rrrr");
    if (std::any_of(rows.begin(), rows.end(), [](const MinStreet& row) { return row.cancelled; }))
        text += "\nGiven up before the end: the bounds are those found so far.\n";
    return text;
}

Action min_street_action(const MinStreetQuestion& question, Format format, const std::string& path) {
    return [question, format, path] {
        const std::function<bool(double)> show = show_progress();
        SweepOptions sweep;
        sweep.threads = question.threads;
        sweep.progress = [&](double done) {
            if (show) show(done);
            return interruption() == 0;
        };
        std::vector<MinStreet> rows;
        {
            const Interruptible interruptible;
            rows = min_streets(question.car, question.streets, question.max_changes, question.options, sweep);
        }
        if (show) wipe_progress();
        put_out(path, format == Format::json  ? min_street_json(question, rows)
                      : format == Format::csv ? min_streets_as_csv(question.streets, question.options.sought, rows)
                                              : min_street_text(question, rows));
        if (interruption() != 0) return interruption();
        if (std::any_of(rows.begin(), rows.end(), [](const MinStreet& row) { return row.size.has_value(); }))
            return solved;
        const double largest = question.options.largest;
        const bool none =
            std::all_of(rows.begin(), rows.end(), [&](const MinStreet& row) { return row.lower >= largest - 1e-9; });
        return none ? cannot_park : undecided;
    };
}

}  // namespace snug::cli
