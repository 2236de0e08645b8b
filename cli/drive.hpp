// What `snug drive` is asked, and how its answer reads.
#pragma once

#include <string>

#include "cli/park.hpp"
#include "snug/drive.hpp"

namespace snug::cli {

/// What a person needs: how many runs park, what looking again costs, and how near things come. At most 80 columns.
std::string drive_text(const ParkQuestion& question, const DriveOptions& options, const DriveAnswer& answer);

}  // namespace snug::cli
