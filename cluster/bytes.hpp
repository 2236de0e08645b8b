// What processes of one build tell each other, as bytes: numbers as they are in memory, so that doubles stay exact, and lists
// with their lengths before them. All processes of a build run on machines of one kind, and the same version of snug.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "snug/atlas_database.hpp"

namespace snug::cluster {

/// What a worker needs to know; a plan goes without its grid, because batches bring their slots.
struct Task {
    AtlasPlan plan;
    int threads = 0;  ///< 0: all cores
};

std::string to_bytes(const Task& task);
std::string to_bytes(const CellBatch& batch);
std::string to_bytes(const SolvedBatch& solved);

// Each throws Error unless the bytes are what the function above makes of a plan with so many cars.
Task task_from(std::string_view bytes);
CellBatch batch_from(std::string_view bytes, std::size_t cars);
SolvedBatch solved_from(std::string_view bytes, std::size_t cars);

}  // namespace snug::cluster
