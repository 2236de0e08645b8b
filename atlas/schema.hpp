// What the database holds: tables that people can ask as well (docs/atlas.md), and the plan written there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "snug/atlas_database.hpp"
#include "sqlite.hpp"

namespace snug {

/// The plan of a database, its cars with their numbers there.
struct StoredPlan {
    AtlasPlan plan;                     ///< cars in alphabetical order, widths and lengths rising
    std::vector<std::int64_t> car_ids;  ///< of each car of the plan
    std::string made_by;                ///< version of snug
};

/// Makes the tables of an empty database.
void create_tables(Connection& connection, const AtlasOptions& options);

/// Opens an atlas's database; one without anything in it only where it may be new. Throws Error that says what else it is.
Connection open_database(const std::string& path, bool may_be_empty);
bool is_empty(const Connection& connection);

/// Throws Error when what is written there cannot be.
StoredPlan read_plan(const Connection& connection, const std::string& path);

std::uint64_t count_cells(const AtlasPlan& plan);

}  // namespace snug
