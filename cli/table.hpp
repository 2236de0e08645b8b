// Aligned columns of text, and numbers with a fixed number of decimals.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace snug::cli {

/// One row per line, columns two spaces apart; `align` has an 'l' or an 'r' for every column. Ends with a newline.
std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& align, std::size_t indent = 2);

/// "1.250"; never "-0.000".
std::string fixed(double value, int decimals);

// In millimetres: rounded up, so that what has the size shown is large enough; and down, no more than there is. [m]
std::string at_least(double size);
std::string at_most(double size);

}  // namespace snug::cli
