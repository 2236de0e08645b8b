// snug atlas build: every car in every slot, into a database; whatever ends it, the same command goes on from there.
#include <chrono>
#include <utility>

#include "cli/atlas.hpp"
#include "cli/interrupt.hpp"
#include "cli/numbers.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "model/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"

namespace snug::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* purpose =
    "Solves every car in every slot of a grid, on all cores, into an SQLite database:\n"
    "the fewest direction changes, the entry headings and one maneuver for each.";

constexpr const char* examples =
    "Lengths are in metres, angles in radians. Answers are committed several times a\n"
    "second: whatever ends the work, the same command goes on from there. Cars and\n"
    "sizes that are new are added to those the file has. Under mpirun the work is\n"
    "spread over all its processes; the first one owns the file.\n\n"
    "Examples:\n"
    "  snug atlas build --db five.sqlite --cars all --width 1.6:2.6:0.05 --length 4:6:0.05\n"
    "  snug atlas build --db fleet.sqlite --cars fleet.csv --width 2:2.4:0.1 \\\n"
    "      --length 4.5:6:0.1 --strategy fewest --resolution 0.002\n"
    "  mpirun -n 8 snug atlas build --db fleet.sqlite --cars fleet.csv \\\n"
    "      --width 2:2.4:0.1 --length 4.5:6:0.1\n\n"
    "Exit codes: 0 complete; 2 bad input, or the file cannot be written; 130 or 143\n"
    "interrupted, and what was finished is kept.";

bool is_csv(const std::string& name) { return name.size() > 4 && name.substr(name.size() - 4) == ".csv"; }

std::vector<Car> cars(const Options& options) {
    const std::string* text = options.typed("--cars");
    if (text == nullptr)
        throw Error("--cars is missing; give all, names that `snug cars` lists, car files, or a CSV file");
    if (*text == "all") return catalogue();
    try {
        std::vector<Car> cars;
        for (const std::string& part : split(*text, ',')) {
            if (!is_csv(part)) {
                cars.push_back(find_or_read_car(part));
                continue;
            }
            for (Car& car : read_cars(part)) cars.push_back(std::move(car));
        }
        return cars;
    } catch (const Error& error) {
        throw Error(std::string("--cars: ") + error.what());
    }
}

std::vector<double> sizes(const Options& options, const std::string& option) {
    const std::string* text = options.typed(option);
    if (text == nullptr) throw Error(option + " is missing; give a list or a range in metres, such as 1.8:2.4:0.01");
    return numbers(option, *text, {" m", 1e-6, 1e6});
}

AtlasOptions atlas_options(const Options& options) {
    AtlasOptions atlas;
    const bool fewest = options.choice("--strategy", {"max-steer", "fewest"}) == 1;
    atlas.strategy = fewest ? AtlasStrategy::fewest : AtlasStrategy::max_steer;
    if (const std::string* text = options.typed("--max-changes"))
        atlas.max_changes = whole_number("--max-changes", *text, 0, fewest ? 1000 : 100000);
    for (const char* option : {"--resolution", "--min-range"}) {
        if (options.typed(option) != nullptr && fewest != (option == std::string("--resolution")))
            throw Error(std::string(option) + " belongs to --strategy " + (fewest ? "max-steer" : "fewest") +
                        "; leave it out or give that strategy");
    }
    atlas.resolution = options.number("--resolution", 0.0, 1e-9, 1e6, " m");
    atlas.min_range = options.number("--min-range", 0.0, 0.0, 1.5707963267948966, " rad");
    atlas.driving.clearance = clearance(options);
    atlas.driving.enter = enter(options);
    return atlas;
}

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::string of_cells(const AtlasProgress& progress) {
    return std::to_string(progress.stored) + " of " + std::to_string(progress.cells) + " cells";
}

int build_and_report(const std::string& path, const AtlasPlan& plan, AtlasBuildOptions options, const Build& build) {
    AtlasBuild database(path, plan);
    const Clock::time_point begin = Clock::now();
    const Interruptible interruptible;
    options.progress = show_cells();
    if (watched()) {
        const AtlasPlan& whole = database.plan();
        complain(extent(whole.cars.size(), whole.widths.size(), whole.lengths.size()) + ", of which " +
                 std::to_string(database.progress().stored) + " are stored");
    }
    options.go_on = [] { return interruption() == 0; };
    const bool complete = build(database, options);
    wipe_progress();
    const AtlasProgress progress = database.progress();
    if (!complete && interruption() == 0)
        throw Error(in_quotes(path) + " is damaged: nothing is missing, and yet it has " + of_cells(progress) +
                    "; restore a copy, or build it again");
    if (!complete) {
        complain("snug atlas: interrupted; " + of_cells(progress) + " are stored in " + in_quotes(path) +
                 "; the same command goes on from there");
        return interruption();
    }
    const double seconds = seconds_since(begin);
    const std::string rate =
        progress.solved == 0 ? "" : " (" + fixed(static_cast<double>(progress.solved) / seconds, 0) + " a second)";
    const AtlasPlan& whole = database.plan();
    print(path + ": " + extent(whole.cars.size(), whole.widths.size(), whole.lengths.size()) + ".\nAll are stored, " +
          std::to_string(progress.solved) + " of them solved now, in " + fixed(seconds, 1) + " s" + rate + ".\n");
    return solved;
}

}  // namespace

Action parse_atlas_build(const Arguments& arguments) { return parse_atlas_build(arguments, build_atlas); }

Action parse_atlas_build(const Arguments& arguments, const Build& build) {
    Options options("snug atlas build", purpose, examples);
    add_db(options, "The database, made if it is missing.");
    options.add(
        "--cars", "CARS",
        "all, or names that `snug cars` lists, car files, or\na CSV file as `snug cars --format csv` prints it.");
    options.add("--width", "RANGE",
                "Widths of slots [m]: from:to:step, both ends among them,\nor a list such as 1.8,2,2.5.");
    options.add("--length", "RANGE", "Lengths of slots [m], likewise.");
    options.group("Question");
    options.add("--strategy", "NAME",
                "max-steer (default): full steering until contact;\nfewest: over all maneuvers, with proof.");
    options.add("--max-changes", "N",
                "All headings with at most that many direction\nchanges, instead of the fewest up to 200.");
    options.add("--min-range", "RAD", "max-steer: leave out narrower stretches of headings\n[rad] (0).");
    options.add("--resolution", "M", "fewest: finest lattice [m] (a ten-thousandth of the\ncar's length).");
    add_driving(options);
    options.group("Output");
    options.add("--threads", "N", "At most that many threads, 1 to 1024 (all cores).");
    if (!options.read(arguments)) return say(options.help());
    const std::string path = db(options);
    AtlasPlan plan;
    plan.cars = cars(options);
    plan.widths = sizes(options, "--width");
    plan.lengths = sizes(options, "--length");
    plan.options = atlas_options(options);
    AtlasBuildOptions how;
    if (options.typed("--threads") != nullptr) how.threads = threads(options);
    return [path, plan, how, build] { return build_and_report(path, plan, how, build); };
}

}  // namespace snug::cli
