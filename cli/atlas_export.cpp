// snug atlas export: the database as CSV, or as the compact file that cars read.
#include "cli/atlas.hpp"
#include "cli/output.hpp"
#include "cli/table.hpp"
#include "full_steering/widest_range.hpp"
#include "model/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "Writes an atlas's database as CSV, a row for each car and slot, or as one compact\n"
    "file that a car looks up in (snug::Atlas in C++).";

constexpr const char* examples =
    "The file's ending decides: .csv or .atlas. In CSV the heading range is the widest\n"
    "with the fewest direction changes, and cells that are not solved are left out;\n"
    "lower_bound and proved tell of fewest and are 0 with max-steer. A compact file\n"
    "holds all cells, with their maneuvers.\n\n"
    "Examples:\n"
    "  snug atlas export --db five.sqlite > five.csv\n"
    "  snug atlas export --db five.sqlite -o five.atlas\n\n"
    "Exit codes: 0 done; 2 bad input, or the file cannot be written.";

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() > end.size() && text.substr(text.size() - end.size()) == end;
}

void write_csv(const AtlasDatabase& database, const AtlasWriter::Sink& sink) {
    constexpr std::size_t enough = 1 << 16;
    std::string text =
        "car,width,length,direction_changes,lower_bound,proved,heading_min,heading_max,entry_x,entry_y,entry_heading\n";
    const auto number = [](bool known, double value) { return ',' + (known ? write(value) : std::string()); };
    each_cell(database, [&](std::size_t car, double width, double length, const CellAnswer& answer) {
        const bool parks = answer.direction_changes.has_value();
        const HeadingRange* widest = parks ? widest_range(answer.ranges, *answer.direction_changes) : nullptr;
        text += csv_field(database.plan().cars[car].name()) + number(true, width) + number(true, length) + ',' +
                (parks ? std::to_string(*answer.direction_changes) : "") + ',' + std::to_string(answer.lower_bound) +
                ',' + (answer.proved ? '1' : '0') + number(widest != nullptr, widest != nullptr ? widest->min : 0.0) +
                number(widest != nullptr, widest != nullptr ? widest->max : 0.0) + number(parks, answer.entry.x) +
                number(parks, answer.entry.y) + number(parks, answer.entry.heading) + '\n';
        if (text.size() < enough) return;
        sink(text);
        text.clear();
    });
    sink(text);
}

void write_compact(const AtlasDatabase& database, const AtlasWriter::Sink& sink) {
    AtlasWriter writer(database.plan(), database.made_by(), sink);
    each_cell(database, [&](std::size_t, double, double, const CellAnswer& answer) { writer.add(answer); });
    writer.finish();
}

}  // namespace

Action parse_atlas_export(const Arguments& arguments) {
    Options options("snug atlas export", purpose, examples);
    add_db(options, "The database.");
    options.group("Output");
    options.add("-o,--output", "FILE", "Ends with .csv or .atlas; without it, CSV to\nstandard output.");
    if (!options.read(arguments)) return say(options.help());
    const std::string from = db(options);
    const std::string to = output_beside(options, from);
    const bool csv = to.empty() || ends_with(to, ".csv");
    if (!csv && !ends_with(to, ".atlas"))
        throw Error("--output: " + in_quotes(to) + " has no known ending; end it with .csv or .atlas");
    if (is_exported(from)) throw Error("--db: " + in_quotes(from) + " is exported already; give the database");
    return [from, to, csv] {
        const AtlasDatabase database(from);
        const std::uint64_t stored = database.stored();
        const std::string some = stored == database.cells() ? ""
                                                            : in_quotes(from) + " has " + std::to_string(stored) +
                                                                  " of " + std::to_string(database.cells()) + " cells";
        if (!csv && !some.empty()) throw Error(some + "; complete it with snug atlas build first");
        if (to.empty()) {
            write_csv(database, print);
        } else {
            FileInParts file("--output", to);
            const AtlasWriter::Sink sink = [&](std::string_view bytes) { file.write(bytes); };
            csv ? write_csv(database, sink) : write_compact(database, sink);
            file.finish();
        }
        if (!some.empty()) complain("snug atlas: " + some + ", all of which are written");
        return solved;
    };
}

}  // namespace snug::cli
