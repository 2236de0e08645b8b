// The paper again: the data of every figure and table of it, and every claim it makes beside the exact answer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "snug/stepping.hpp"

namespace snug::paper {

/// How finely the figures are computed. As it stands: the paper's own grids and steps.
struct Grids {
    double width_step = 0.01;     ///< between slot widths [m]
    double widest = 0.60;         ///< extra slot width where the figures end [m]
    double length_step = 0.01;    ///< between slot lengths [m]
    double heading_width = 2e-3;  ///< between slot widths in the figures about headings, where it costs little [m]
    Stepping steps;               ///< of Algorithm 1, for the values with the paper's own steps
};

struct File {
    std::string name;
    std::string bytes;
};

struct Options {
    Grids grids;
    int threads = 0;  ///< 0: all cores
    /// Told the part done (0 to 1) from time to time, never from two threads at once; returning false gives up.
    std::function<bool(double)> progress;
};

/// One CSV file for each figure and table, claims.json, and extra_lengths.md and .csv: for each car, how much longer than
/// itself the slot must be. The same options give the same bytes. Empty when the progress callback gave up.
std::vector<File> regenerate(const Options& options = {});

}  // namespace snug::paper
