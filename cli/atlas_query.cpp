// snug atlas query: one car and one slot, from the database or from an exported file.
#include <algorithm>
#include <memory>
#include <optional>

#include "cli/atlas.hpp"
#include "cli/entry.hpp"
#include "cli/groups.hpp"
#include "cli/json.hpp"
#include "cli/output.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/atlas_database.hpp"
#include "snug/draw.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "What an atlas says of one car and one slot. Between grid points the answer is\n"
    "safe: it is the maneuver of the nearest stored slot that is no longer and no\n"
    "wider, which therefore fits, in slots larger than all that are stored, too.";

constexpr const char* examples =
    "Lengths are in metres, angles in radians. FILE is a database that snug atlas\n"
    "build has made, or a file that snug atlas export has written from one.\n\n"
    "Examples:\n"
    "  snug atlas query --db five.sqlite --car renault-zoe --length 5.03 --width 2.07\n"
    "  snug atlas query --db five.atlas --car opel-corsa --length 4.5 --width 2 --side left\n\n"
    "Exit codes: 0 the car parks; 1 it cannot; 2 bad input, with one line that says\n"
    "what is wrong; 3 undecided: too little room in the stored slot, and nothing is\n"
    "proved of the one asked for.";

std::string size(double metres) { return spelled(metres) + " m"; }

/// Where to look: what is larger than all that is stored is answered by the largest, which fits into it.
double in_grid(const std::string& option, double asked, double least, double most) {
    if (asked >= least) return std::min(asked, most);
    const std::string what = option.substr(2);
    throw Error(option + ": " + size(asked) + " is outside the atlas, which has " + what + "s from " + size(least) +
                " to " + size(most) + "; smaller slots have to be built first");
}

/// The stored values next to the one asked for, which lies among them: two, or one where it is stored itself.
std::vector<double> around(const std::vector<double>& sizes, double asked) {
    const auto above = std::lower_bound(sizes.begin(), sizes.end(), asked);
    return *above == asked ? std::vector<double>{asked} : std::vector<double>{*(above - 1), *above};
}

/// The cells around a slot, copied out of a database into a little exported atlas, so that there is one way to look up.
std::string copied(const AtlasDatabase& database, std::size_t car, double length, double width) {
    AtlasPlan little = database.plan();
    little.cars = {database.plan().cars[car]};
    little.lengths = around(database.plan().lengths, length);
    little.widths = around(database.plan().widths, width);
    std::string bytes;
    AtlasWriter writer(little, database.made_by(), [&](std::string_view part) { bytes += part; });
    for (const double stored_width : little.widths) {
        for (const double stored_length : little.lengths) {
            const std::optional<CellAnswer> answer = database.cell(car, stored_width, stored_length);
            if (!answer)
                throw Error("the slot of " + size(stored_length) + " x " + size(stored_width) +
                            " is not solved yet; run the same snug atlas build again to complete the atlas");
            writer.add(*answer);
        }
    }
    writer.finish();
    return bytes;
}

/// What is looked up, however it is stored.
struct Asked {
    std::string bytes;  ///< behind `atlas` when it comes from a database
    std::unique_ptr<Atlas> atlas;
    std::size_t car = 0;
    double length = 0.0;  ///< where to look [m]
    double width = 0.0;
};

struct Question {
    Car car;
    Slot slot;
    Asked asked;
};

/// The options of `snug atlas query`, in the order of its help text.
struct QueryOptions {
    explicit QueryOptions(Options& options)
        : file(options, "The atlas: a database, or an exported file."),
          car(options.group("Car").text("--car", "CAR", "A name of the atlas.")),
          slot(options),
          output(options, "text (default) or json."),
          draw(draw_option(options)) {}

    AtlasFile file;
    Option<std::string> car;
    SlotOptions slot;
    OutputOptions output;
    Option<std::string> draw;
};

Question open(const QueryOptions& options) {
    const std::string path = options.file.path();
    if (!options.car) throw Error(options.car.name() + " is missing; give a name of the atlas");
    const std::string name = *options.car;
    Asked asked;
    if (is_exported(path)) {
        asked.atlas = std::make_unique<Atlas>(path);
        const Atlas& atlas = *asked.atlas;
        std::vector<std::string> names;
        for (std::size_t i = 0; i < atlas.cars(); ++i) names.emplace_back(atlas.car_name(i));
        asked.car = find_in_atlas(name, names);
        const Car car = atlas.car(asked.car);
        const Slot wanted(options.slot.dimensions(car));
        asked.length = in_grid("--length", wanted.length(), atlas.length(0), atlas.length(atlas.lengths() - 1));
        asked.width = in_grid("--width", wanted.width(), atlas.width(0), atlas.width(atlas.widths() - 1));
        return {car, wanted, std::move(asked)};
    }
    const AtlasDatabase database(path);
    const AtlasPlan& plan = database.plan();
    std::vector<std::string> names;
    for (const Car& each : plan.cars) names.push_back(each.name());
    const std::size_t place = find_in_atlas(name, names);
    const Car car = plan.cars[place];
    const Slot wanted(options.slot.dimensions(car));
    asked.length = in_grid("--length", wanted.length(), plan.lengths.front(), plan.lengths.back());
    asked.width = in_grid("--width", wanted.width(), plan.widths.front(), plan.widths.back());
    asked.bytes = copied(database, place, asked.length, asked.width);
    asked.atlas = std::make_unique<Atlas>(std::as_bytes(std::span<const char>(asked.bytes)));
    return {car, wanted, std::move(asked)};
}

EntryOptions entry_options(const AtlasOptions& options) {
    EntryOptions entry;
    entry.prove = false;
    entry.max_changes = options.max_changes;
    entry.min_range = options.min_range;
    entry.driving = options.driving;
    return entry;
}

Answer as_entry(const AtlasAnswer& found, const Question& question) {
    Answer answer;
    answer.cancelled = found.verdict == AtlasVerdict::undecided;  // which JSON calls null
    if (found.verdict != AtlasVerdict::parks) return answer;
    answer.direction_changes = found.cell.direction_changes();
    for (std::size_t i = 0; i < found.cell.ranges(); ++i) answer.ranges.push_back(found.cell.range(i));
    answer.maneuver = maneuver(found.cell, question.car, question.slot);
    return answer;
}

Answer as_fewest(const AtlasAnswer& found, const Question& question) {
    Answer answer;
    answer.lower_bound = found.lower_bound;
    if (found.verdict == AtlasVerdict::parks) {
        answer.direction_changes = found.cell.direction_changes();
        answer.maneuver = maneuver(found.cell, question.car, question.slot);
    }
    answer.proved =
        found.verdict == AtlasVerdict::cannot_park || answer.direction_changes == std::optional<int>(found.lower_bound);
    return answer;
}

bool is_stored(const Question& question, const AtlasCell& cell) {
    return cell.length() == question.slot.length() && cell.width() == question.slot.width();
}

std::string used(const Question& question, const AtlasCell& cell) {
    const std::string stored = "the stored slot of " + size(cell.length()) + " x " + size(cell.width());
    if (is_stored(question, cell)) return "From " + stored + ", which is the one asked for.\n";
    const auto smaller = [](double by, const char* how) { return fixed(by, 3) + " m " + how; };
    const double shorter = question.slot.length() - cell.length();
    const double narrower = question.slot.width() - cell.width();
    std::string by = shorter > 0.0 ? smaller(shorter, "shorter") : "";
    by += shorter > 0.0 && narrower > 0.0 ? " and " : "";
    by += narrower > 0.0 ? smaller(narrower, "narrower") : "";
    return "From " + stored + ", " + by + ":\nmoves end where its sides would be, not at contact.\n";
}

std::string text(const Question& question, const AtlasAnswer& found) {
    const AtlasOptions& options = question.asked.atlas->options();
    const EntryQuestion asked = {question.car, question.slot, entry_options(options)};
    if (found.verdict == AtlasVerdict::undecided)
        return name(question.car) + " may park in the " + fixed(question.slot.length(), 3) + " x " +
               fixed(question.slot.width(), 3) + " m slot: the atlas does not know.\n" + "In the stored slot of " +
               size(found.cell.length()) + " x " + size(found.cell.width()) + " it does not park with up to " +
               changes(options.max_changes.value_or(200)) + ".\n";
    const std::string answer = options.strategy == Strategy::fewest
                                   ? fewest_text(asked, options.max_changes.value_or(200), as_fewest(found, question))
                                   : entry_text(asked, as_entry(found, question));
    return answer + '\n' + used(question, found.cell);
}

std::string json(const Question& question, const AtlasAnswer& found) {
    const AtlasOptions& options = question.asked.atlas->options();
    const Answer answer = options.strategy == Strategy::fewest ? as_fewest(found, question) : as_entry(found, question);
    return atlas_json({question.car, question.slot, entry_options(options)}, options.strategy, answer, found.cell);
}

std::string drawn(const Question& question, const AtlasAnswer& found, PictureFormat format) {
    const AtlasOptions& options = question.asked.atlas->options();
    const Answer answer = options.strategy == Strategy::fewest ? as_fewest(found, question) : as_entry(found, question);
    return draw_maneuver(question.car, question.slot, answer, format, {options.driving});
}

int exit_code(AtlasVerdict verdict) {
    return verdict == AtlasVerdict::parks ? solved : verdict == AtlasVerdict::cannot_park ? cannot_park : undecided;
}

}  // namespace

Action parse_atlas_query(const Arguments& arguments) {
    Options options("snug atlas query", purpose, examples);
    const QueryOptions asked_for(options);
    if (!options.read(arguments)) return say(options.help());
    const Format format =
        asked_for.output.format_without_csv("csv is for whole tables, which snug atlas export writes");
    const std::string file = asked_for.file.path();
    const std::string path = asked_for.output.path();
    refuse_atlas_itself(path, file);
    const std::optional<PictureFile> picture = picture_file(asked_for.draw, asked_for.output);
    if (picture) refuse_atlas_itself(picture->path, file);
    return [question = std::make_shared<const Question>(open(asked_for)), format, file, path, picture] {
        const Asked& asked = question->asked;
        AtlasAnswer found = asked.atlas->look_up(asked.car, asked.length, asked.width);
        if (found.verdict == AtlasVerdict::damaged)
            throw Error(in_quotes(file) + ": the part that holds the answer is damaged; copy or export it again");
        if (question->slot.length() > asked.length || question->slot.width() > asked.width) {
            found.lower_bound = 0;  // nothing is known of larger slots but that what is stored fits
            if (found.verdict == AtlasVerdict::cannot_park) found.verdict = AtlasVerdict::undecided;
        }
        if (picture && found.verdict == AtlasVerdict::parks)
            write_file("--draw", picture->path, drawn(*question, found, picture->format));
        put_out(path, format == Format::json ? json(*question, found) : text(*question, found));
        return exit_code(found.verdict);
    };
}

}  // namespace snug::cli
