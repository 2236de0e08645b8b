// How far a long question has come, on standard error.
#pragma once

#include <functional>

#include "snug/atlas_database.hpp"
#include "snug/fewest.hpp"

namespace snug::cli {

/// Whether standard error is a terminal.
bool watched();

/// A progress callback that shows the part done and the time left, from half a second on and ten times a second at most;
/// empty when standard error is no terminal.
std::function<bool(double)> show_progress();

/// The same for the fewest changes over all maneuvers: shows the bounds so far and the lattice they come from.
std::function<bool(const FewestProgress&)> show_bounds();

/// The same for an atlas: cells, how many a second, and the time left; without a terminal, as under mpirun or in a job's
/// log, a line every minute.
std::function<void(const AtlasProgress&)> show_cells();

/// Wipes it away again.
void wipe_progress();

}  // namespace snug::cli
