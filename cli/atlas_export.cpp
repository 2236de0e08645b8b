// snug atlas export: the database as CSV, or as the compact file that cars read.
#include "cli/atlas.hpp"
#include "cli/output.hpp"
#include "io/csv.hpp"
#include "sentences/spelling.hpp"
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

void write_csv(const AtlasDatabase& database, const AtlasWriter::Sink& sink) {
    constexpr std::size_t enough = 1 << 16;
    Csv csv({"car", "width", "length", "direction_changes", "lower_bound", "proved", "heading_min", "heading_max",
             "entry_x", "entry_y", "entry_heading"});
    each_cell(database, [&](std::size_t car, double width, double length, const CellAnswer& answer) {
        const bool parks = answer.direction_changes.has_value();
        const HeadingRange* widest = parks ? widest_range(answer.ranges, *answer.direction_changes) : nullptr;
        const auto known = [](bool is_known, double value) { return is_known ? std::optional(value) : std::nullopt; };
        csv.row(database.plan().cars[car].name(), width, length, answer.direction_changes, answer.lower_bound,
                answer.proved ? 1 : 0, known(widest != nullptr, widest != nullptr ? widest->min : 0.0),
                known(widest != nullptr, widest != nullptr ? widest->max : 0.0), known(parks, answer.entry.x),
                known(parks, answer.entry.y), known(parks, answer.entry.heading));
        if (csv.text().size() >= enough) sink(csv.take());
    });
    sink(csv.text());
}

void write_compact(const AtlasDatabase& database, const AtlasWriter::Sink& sink) {
    AtlasWriter writer(database.plan(), database.made_by(), sink);
    each_cell(database, [&](std::size_t, double, double, const CellAnswer& answer) { writer.add(answer); });
    writer.finish();
}

}  // namespace

Action parse_atlas_export(const Arguments& arguments) {
    Options options("snug atlas export", purpose, examples);
    const AtlasFile file(options, "The database.");
    const Option<std::string> output = options.group("Output").text(
        "-o,--output", "FILE", "Ends with .csv or .atlas; without it, CSV to\nstandard output.");
    if (!options.read(arguments)) return say(options.help());
    const std::string from = file.path();
    const std::string to = output.value_or("");
    if (output) check_writable(output.name(), to);
    refuse_atlas_itself(to, from);
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
            FileInParts out("--output", to);
            const AtlasWriter::Sink sink = [&](std::string_view bytes) { out.write(bytes); };
            csv ? write_csv(database, sink) : write_compact(database, sink);
            out.finish();
        }
        if (!some.empty()) complain("snug atlas: " + some + ", all of which are written");
        return solved;
    };
}

}  // namespace snug::cli
