// What `snug park` is asked, and how its answer reads.
#pragma once

#include <optional>
#include <string>

#include "snug/park.hpp"
#include "snug/scene.hpp"

namespace snug::cli {

struct ParkQuestion {
    Car car;
    Scene scene;                   ///< also of a street, with the place it is
    std::optional<Street> street;  ///< when it is one
    ParkOptions options;
};

/// What a person needs: what to do move by move from where the car stands, how it ends, and what is proved. At most 80 columns.
std::string park_text(const ParkQuestion& question, const ParkAnswer& answer);

}  // namespace snug::cli
