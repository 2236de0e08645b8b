// The paper's section 4.3: how short a slot may be, over its width and over the direction changes allowed.
#pragma once

#include <optional>
#include <vector>

#include "paper/work.hpp"
#include "snug/sweep.hpp"

namespace snug::paper {

/// What the paper's loop finds: the first slot length of its grid in which Algorithm 1 parks.
struct SteppedMinimum {
    int max_changes = 0;
    double extra_width = 0.0;            ///< [m]
    std::optional<double> extra_length;  ///< [m]
};

struct CarMinima {
    Car car;
    std::vector<MinSlot> exact;
    std::vector<SteppedMinimum> stepped;  ///< at a few widths only

    /// Shortest slot beyond the car's length, at one of the grid's widths. [m]
    [[nodiscard]] std::optional<double> extra_length(int max_changes, double extra_width) const;
    [[nodiscard]] std::optional<double> stepped_extra_length(int max_changes, double extra_width) const;
};

/// 0 to 10, 20, 30, 40, 50 and 100: the lines of the paper's figures.
const std::vector<int>& counts();

/// Extra widths from the grid's first step to its end. [m]
std::vector<double> extra_widths(const Grids& grids, double step);

/// The grid's extra width from which on the paper sees nothing gained, 25 cm. [m]
inline constexpr double wide_enough = 0.25;

/// The four cars of the paper's figures, in its order.
std::vector<CarMinima> minima(Work& work);
/// The same points by the paper's own loop, where they matter.
void add_stepped(std::vector<CarMinima>& minima, Work& work);

/// One CSV for each of the paper's figures and for its appendix, and the points by the paper's own loop.
std::vector<File> minima_files(const std::vector<CarMinima>& minima);

/// How much longer than the car the slot must be, for each car and a few counts, in a wide and in a usual slot.
std::vector<File> extra_length_table(Work& work);

}  // namespace snug::paper
