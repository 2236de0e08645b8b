// What `snug min-slot` is asked of streets, and how its answer reads.
#pragma once

#include <string>
#include <vector>

#include "cli/command.hpp"
#include "cli/groups.hpp"
#include "snug/min_street.hpp"

namespace snug::cli {

struct MinStreetQuestion {
    Car car;
    std::vector<Street> streets;  ///< one for each size given; what is sought is not looked at
    MinStreetOptions options;
    StreetSize listed = StreetSize::width;  ///< the size in which the streets differ
    std::vector<int> max_changes;
    int threads = 0;
};

/// Between which sizes the smallest roads and bays lie. At most 80 columns.
std::string min_street_text(const MinStreetQuestion& question, const std::vector<MinStreet>& rows);

/// Answers the question, with what is known when Ctrl-C is pressed.
Action min_street_action(const MinStreetQuestion& question, Format format, const std::string& path);

}  // namespace snug::cli
