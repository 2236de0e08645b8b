// Under mpirun, an atlas is built by all of its processes together.
#pragma once

#include "cli/command.hpp"

namespace snug::cli {

/// Whether this is one of several processes that mpirun started with the same `atlas build`.
bool is_one_of_many(const Arguments& arguments);

/// Goes on as snug-mpi, the program next to this one that can do that; where there is none, says so and returns the exit code.
int go_on_with_mpi(const Arguments& arguments);

}  // namespace snug::cli
