// A checksum over all that a cell says and what it was asked: a value altered anywhere in the database is seen.
#pragma once

#include <cstdint>
#include <string_view>

#include "snug/atlas_build.hpp"

namespace snug {

std::int64_t checksum_of_cell(const AtlasOptions& options, std::string_view made_by, const Car& car, double width,
                              double length, const CellAnswer& answer);

}  // namespace snug
