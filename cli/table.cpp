// Text set in columns.
#include "cli/table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace snug::cli {
namespace {

/// Letters, not bytes: names may be UTF-8.
std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

std::string table(const std::vector<std::vector<std::string>>& rows, const std::string& align, std::size_t indent) {
    std::vector<std::size_t> widths(align.size());
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], letters(row[i]));
        }
    }
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        text += std::string(indent, ' ');
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - letters(row[i]), ' ');
            text += (i == 0 ? "" : "  ") + (align[i] == 'r' ? space + row[i] : row[i] + space);
        }
        text.erase(text.find_last_not_of(' ') + 1);
        text += '\n';
    }
    return text;
}

std::string fixed(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    const double shown = std::abs(value) * scale < 0.5 ? 0.0 : value;
    char digits[400];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, shown);
    return digits;
}

std::string at_least(double size) { return fixed(std::ceil(size * 1e3 - 1e-6) / 1e3, 3); }
std::string at_most(double size) { return fixed(std::floor(size * 1e3 + 1e-6) / 1e3, 3); }

}  // namespace snug::cli
