// snug atlas build: every car in every slot, into a database; whatever ends it, the same command goes on from there.
#include <chrono>
#include <utility>

#include "atlas/damage.hpp"
#include "cli/atlas.hpp"
#include "cli/groups.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/table.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"
#include "snug/io.hpp"
#include "snug/limits.hpp"

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

/// The options of `snug atlas build`, in the order of its help text.
struct Asked {
    explicit Asked(Options& options)
        : file(options, "The database, made if it is missing."),
          cars(options.text(
              "--cars", "CARS",
              "all (the paper's five), names of `snug cars`, car\nfiles, or a CSV file as `snug cars --format csv`\n"
              "prints it.")),
          widths(options.numbers(
              "--width", "RANGE",
              "Widths of slots [m]: from:to:step, both ends among them,\nor a list such as 1.8,2,2.5.", size)),
          lengths(options.numbers("--length", "RANGE", "Lengths of slots [m], likewise.", size)),
          strategy(options.group("Question")
                       .choice<Strategy>(
                           "--strategy", "NAME",
                           "max-steer (default): full steering until contact;\nfewest: over all maneuvers, with proof.",
                           {{"max-steer", Strategy::max_steer}, {"fewest", Strategy::fewest}})),
          max_changes(options.whole_number(
              "--max-changes", "N",
              "All headings with at most that many direction\nchanges, instead of the fewest up to 200.", 0,
              limits::most_changes)),
          min_range(options.number("--min-range", "RAD", "max-steer: leave out narrower ranges of headings\n[rad] (0).",
                                   {" rad", 0.0, limits::quarter_turn})),
          resolution(resolution_option(options, "ten-thousandth")),
          driving(options),
          threads(threads_option(options.group("Output"), " (all cores)")) {}

    static constexpr Quantity size = {" m", limits::shortest, limits::longest};

    AtlasFile file;
    Option<std::string> cars;
    Option<std::vector<double>> widths;
    Option<std::vector<double>> lengths;
    Option<Strategy> strategy;
    Option<int> max_changes;
    Option<double> min_range;
    Option<double> resolution;
    DrivingOptions driving;
    Option<int> threads;
};

std::vector<Car> cars(const Option<std::string>& option) {
    if (!option)
        throw Error(option.name() + " is missing; give all, names that `snug cars` lists, car files, or a CSV file");
    if (*option == "all") return catalogue();
    try {
        std::vector<Car> cars;
        for (const std::string& part : split(*option, ',')) {
            if (!ends_with(part, ".csv")) {
                cars.push_back(find_or_read_car(part));
                continue;
            }
            for (Car& car : read_cars(part)) cars.push_back(std::move(car));
        }
        return cars;
    } catch (const Error& error) {
        throw Error(option.name() + ": " + error.what());
    }
}

std::vector<double> sizes(const Option<std::vector<double>>& option) {
    if (!option) throw Error(option.name() + " is missing; give a list or a range in metres, such as 1.8:2.4:0.01");
    return *option;
}

AtlasOptions atlas_options(const Asked& asked) {
    AtlasOptions atlas;
    atlas.strategy = asked.strategy.value_or(Strategy::max_steer);
    const bool fewest = atlas.strategy == Strategy::fewest;
    if (asked.max_changes) {
        if (fewest) check_between(asked.max_changes.name(), *asked.max_changes, 0.0, limits::most_changes_fewest, "");
        atlas.max_changes = *asked.max_changes;
    }
    belongs_to(asked.resolution, fewest, "fewest");
    belongs_to(asked.min_range, !fewest, "max-steer");
    atlas.resolution = asked.resolution.value_or(0.0);
    atlas.min_range = asked.min_range.value_or(0.0);
    atlas.driving = asked.driving.driving();
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
        throw damaged(path, "nothing is missing, and yet it has " + of_cells(progress));
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
    const Asked asked(options);
    if (!options.read(arguments)) return say(options.help());
    const std::string path = asked.file.path();
    AtlasPlan plan;
    plan.cars = cars(asked.cars);
    plan.widths = sizes(asked.widths);
    plan.lengths = sizes(asked.lengths);
    plan.options = atlas_options(asked);
    AtlasBuildOptions how;
    if (asked.threads) how.threads = *asked.threads;
    return [path, plan, how, build] { return build_and_report(path, plan, how, build); };
}

}  // namespace snug::cli
