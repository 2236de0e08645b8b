// What the four parts of `snug atlas` share.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/options.hpp"
#include "snug/atlas.hpp"
#include "snug/atlas_database.hpp"

namespace snug::cli {

/// Solves what is missing, as build_atlas() does on this machine.
using Build = std::function<bool(AtlasBuild& build, const AtlasBuildOptions& options)>;

Action parse_atlas_build(const Arguments& arguments);
Action parse_atlas_build(const Arguments& arguments, const Build& build);
Action parse_atlas_query(const Arguments& arguments);
Action parse_atlas_export(const Arguments& arguments);
Action parse_atlas_verify(const Arguments& arguments);

struct AtlasFile {
    AtlasFile(Options& options, const std::string& help);
    /// The file after --db. Throws Error when it is missing.
    [[nodiscard]] std::string path() const;

    Option<std::string> db;
};

/// Throws Error when the file of --output is the atlas that is read.
void refuse_atlas_itself(const std::string& output, const std::string& atlas);

/// Whether the file begins like an exported atlas; what else it is, whoever opens it will say.
bool is_exported(const std::string& path);

/// "5 cars in 60 x 150 slots, 45000 cells"
std::string extent(std::size_t cars, std::size_t widths, std::size_t lengths);

/// The place of a car among those of an atlas. Throws Error that lists what there is.
std::size_t find_in_atlas(const std::string& name, const std::vector<std::string>& cars);

/// Takes the cells one after the other, as AtlasDatabase::each() does, and shows how far it has come.
void each_cell(const AtlasDatabase& database,
               const std::function<void(std::size_t car, double width, double length, const CellAnswer&)>& take);

}  // namespace snug::cli
