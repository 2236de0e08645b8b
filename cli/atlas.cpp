// snug atlas: which of its four parts is meant.
#include "cli/atlas.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/progress.hpp"
#include "cli/subcommands.hpp"
#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

const Subcommands subcommands = {
    "snug atlas",
    "Answers for many cars and slots, computed beforehand.",
    {
        {"build", "Solves every car in every slot, into a database.", parse_atlas_build},
        {"query", "Answers for one car and one slot from the atlas.", parse_atlas_query},
        {"export", "Writes CSV, or the compact file for cars.", parse_atlas_export},
        {"verify", "Checks a database or an exported file.", parse_atlas_verify},
    },
    "Example:\n"
    "  snug atlas build --db fleet.sqlite --cars all --width 1.8:2.4:0.1 --length 4:6:0.1\n"
    "  snug atlas query --db fleet.sqlite --car renault-zoe --length 5.03 --width 2.07\n"
    "  snug atlas export --db fleet.sqlite -o fleet.atlas\n",
};

}  // namespace

Action parse_atlas(const Arguments& arguments) { return choose(subcommands, arguments); }

AtlasFile::AtlasFile(Options& options, const std::string& help)
    : db(options.group("Atlas").text("--db", "FILE", help)) {}

std::string AtlasFile::path() const {
    if (!db) throw Error(db.name() + " is missing; give the atlas's file");
    return *db;
}

void refuse_atlas_itself(const std::string& output, const std::string& atlas) {
    std::error_code none;
    if (!output.empty() && std::filesystem::equivalent(output, atlas, none))
        throw Error("--output: " + in_quotes(output) + " is the atlas itself; give another file");
}

bool is_exported(const std::string& path) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none)) return false;  // reading a pipe could take for ever
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    char head[8] = {};
    return file && std::fread(head, 1, sizeof head, file.get()) == sizeof head &&
           std::string(head, sizeof head) == "snug-atl";
}

std::string extent(std::size_t cars, std::size_t widths, std::size_t lengths) {
    return std::to_string(cars) + (cars == 1 ? " car in " : " cars in ") + std::to_string(widths) + " x " +
           std::to_string(lengths) + " slots, " + std::to_string(cars * widths * lengths) + " cells";
}

std::size_t find_in_atlas(const std::string& name, const std::vector<std::string>& cars) {
    const auto found = std::find(cars.begin(), cars.end(), name);
    if (found != cars.end()) return static_cast<std::size_t>(found - cars.begin());
    constexpr std::size_t most = 12;
    std::vector<std::string> some(cars.begin(),
                                  cars.begin() + static_cast<std::ptrdiff_t>(std::min(most, cars.size())));
    std::string there = "the atlas has " + std::to_string(cars.size()) + (cars.size() == 1 ? " car: " : " cars: ");
    for (std::size_t i = 0; i < some.size(); ++i) there += (i == 0 ? "" : ", ") + printable(some[i]);
    if (cars.size() > most) there += ", ...";
    const std::optional<std::string> nearest = nearest_word(name, cars);
    throw Error("--car: " + in_quotes(name) + " is not in the atlas; " +
                (nearest ? "did you mean " + printable(*nearest) + "? " : "") + there);
}

void each_cell(const AtlasDatabase& database,
               const std::function<void(std::size_t, double, double, const CellAnswer&)>& take) {
    const std::function<bool(double)> progress = show_progress();
    const double cells = static_cast<double>(database.cells());
    double done = 0.0;
    database.each([&](std::size_t car, double width, double length, const CellAnswer& answer) {
        take(car, width, length, answer);
        if (progress) progress(++done / cells);
        return true;
    });
    if (progress) wipe_progress();
}

}  // namespace snug::cli
