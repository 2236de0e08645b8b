// snug atlas verify: is a database or an exported file whole, and does it say what the solver says?
#include <algorithm>
#include <random>

#include "atlas/damage.hpp"
#include "cli/atlas.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

constexpr const char* purpose =
    "Checks that an atlas, a database or an exported file, holds what was stored in it,\n"
    "every cell, and on demand solves some of its cells again.";

constexpr const char* examples =
    "Examples:\n"
    "  snug atlas verify --db five.atlas\n"
    "  snug atlas verify --db five.sqlite --solve 1000\n\n"
    "Exit codes: 0 whole; 2 damaged, or no atlas; 3 whole as far as it goes, but cells\n"
    "are missing.";

/// Cells of a kind of file, by their places in its grid.
struct Cells {
    AtlasOptions options;
    std::vector<Car> cars;
    std::vector<double> widths;
    std::vector<double> lengths;
    std::function<std::optional<CellAnswer>(std::size_t car, std::size_t width, std::size_t length)> at;
};

CellAnswer answer_of(const AtlasCell& cell) {
    CellAnswer answer;
    answer.direction_changes = cell.direction_changes();
    answer.lower_bound = cell.lower_bound();
    answer.proved = cell.proved();
    for (std::size_t i = 0; i < cell.ranges(); ++i) answer.ranges.push_back(cell.range(i));
    answer.entry = cell.entry();
    for (std::size_t i = 0; i < cell.moves(); ++i) answer.moves.push_back(cell.move(i));
    return answer;
}

/// Solves some cells again, drawn at random but the same each time, and throws Error at the first that differs.
void solve_some(const Cells& cells, int count) {
    const std::function<bool(double)> progress = show_progress();
    std::mt19937_64 random(7);
    const auto one_of = [&](std::size_t size) { return static_cast<std::size_t>(random() % size); };
    for (int i = 0; i < count; ++i) {
        const std::size_t car = one_of(cells.cars.size());
        const std::size_t width = one_of(cells.widths.size());
        const std::size_t length = one_of(cells.lengths.size());
        const std::optional<CellAnswer> stored = cells.at(car, width, length);
        const std::optional<CellAnswer> again =
            solve(cells.cars[car], cells.widths[width], cells.lengths[length], cells.options);
        if (stored && *stored != *again)
            throw Error("what is stored of " + in_quotes(cells.cars[car].name()) + " in the slot of " +
                        spelled(cells.lengths[length]) + " x " + spelled(cells.widths[width]) +
                        " m is not what this snug answers; build the atlas again");
        if (progress) progress((i + 1.0) / count);
    }
    if (progress) wipe_progress();
}

std::string again(int count) {
    return count == 0 ? "" : " " + std::to_string(count) + " cells solved again are the same.";
}

int verify_exported(const std::string& path, int count) {
    const Atlas atlas(path);
    for (std::size_t block = 0; block < atlas.blocks(); ++block) {
        if (!atlas.block_is_whole(block))
            throw Error(in_quotes(path) + ": block " + std::to_string(block) + " of " + std::to_string(atlas.blocks()) +
                        " is damaged, perhaps others too; copy or export it again");
    }
    Cells cells;
    cells.options = atlas.options();
    for (std::size_t i = 0; i < atlas.cars(); ++i) cells.cars.push_back(atlas.car(i));
    for (std::size_t i = 0; i < atlas.widths(); ++i) cells.widths.push_back(atlas.width(i));
    for (std::size_t i = 0; i < atlas.lengths(); ++i) cells.lengths.push_back(atlas.length(i));
    cells.at = [&](std::size_t car, std::size_t width, std::size_t length) {
        return std::optional<CellAnswer>(answer_of(*atlas.cell(car, width, length)));
    };
    solve_some(cells, count);
    print(path + ": whole. " + extent(atlas.cars(), atlas.widths(), atlas.lengths()) + " in " +
          std::to_string(atlas.blocks()) + (atlas.blocks() == 1 ? " block." : " blocks.") + again(count) + '\n');
    return solved;
}

int verify_database(const std::string& path, int count) {
    const AtlasDatabase database(path);
    const AtlasPlan& plan = database.plan();
    if (const std::string trouble = database.trouble(); !trouble.empty()) throw damaged(path, trouble);
    each_cell(database, [](std::size_t, double, double, const CellAnswer&) {});  // looks at every one
    Cells cells = {plan.options, plan.cars, plan.widths, plan.lengths, {}};
    cells.at = [&](std::size_t car, std::size_t width, std::size_t length) {
        return database.cell(car, plan.widths[width], plan.lengths[length]);
    };
    solve_some(cells, count);
    const std::uint64_t stored = database.stored();
    const bool complete = stored == database.cells();
    print(path + ": whole. " + extent(plan.cars.size(), plan.widths.size(), plan.lengths.size()) +
          (complete ? "." : ", of which " + std::to_string(stored) + " are stored.") + again(count) + '\n');
    return complete ? solved : undecided;
}

}  // namespace

Action parse_atlas_verify(const Arguments& arguments) {
    Options options("snug atlas verify", purpose, examples);
    const AtlasFile file(options, "The atlas: a database, or an exported file.");
    const Option<int> solve_again =
        options.whole_number("--solve", "N", "Solve so many random cells again and compare (0).", 0, 100'000'000);
    if (!options.read(arguments)) return say(options.help());
    const std::string path = file.path();
    const int count = solve_again.value_or(0);
    return [path, count] { return is_exported(path) ? verify_exported(path, count) : verify_database(path, count); };
}

}  // namespace snug::cli
