// Numbers as people write them.
#include "labels.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <locale>
#include <numbers>
#include <sstream>

namespace snug::drawing {
namespace {

constexpr std::array<Unit, 5> units = {
    {{"km", 1e3, 2}, {"m", 1.0, 2}, {"cm", 1e-2, 1}, {"mm", 1e-3, 2}, {"\u00b5m", 1e-6, 2}}};

std::string without_zeros(std::string digits, int keep) {
    const auto point = digits.find('.');
    if (point == std::string::npos || digits.find('e') != std::string::npos) {
        return digits;
    }
    while (digits.back() == '0' && digits.size() > point + 1 + static_cast<std::size_t>(keep)) {
        digits.pop_back();
    }
    if (digits.back() == '.') {
        digits.pop_back();
    }
    return digits;
}

/// The unit, or for what would vanish in it one of its own.
Unit fitting(double metres, const Unit& unit, int decimals) {
    return metres > 0.0 && metres < std::pow(0.1, decimals) * unit.metres ? unit_for(metres) : unit;
}

std::string dimension(double metres, const Unit& unit) {
    const double value = metres / unit.metres;
    return value >= 1000.0 ? number(value, 0) : without_zeros(number(value, unit.decimals + 1), unit.decimals);
}

}  // namespace

Unit unit_for(double size) {
    if (size >= 2000.0) {
        return units[0];
    }
    if (size >= 1.0) {
        return units[1];
    }
    if (size >= 0.05) {
        return units[2];
    }
    return size >= 1e-4 ? units[3] : units[4];
}

std::string number(double value, int decimals) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    const double size = std::abs(value);
    if (size >= 1e7 || (size > 0.0 && size < 1e-7)) {
        out << std::setprecision(4) << value;
        return out.str();
    }
    out << std::fixed << std::setprecision(decimals) << value;
    const std::string digits = out.str();
    const bool is_zero = digits.find_first_of("123456789") == std::string::npos;
    return is_zero && digits.front() == '-' ? digits.substr(1) : digits;
}

std::string length_label(double metres, const Unit& unit) {
    const Unit own = fitting(metres, unit, unit.decimals);
    return dimension(metres, own) + " " + std::string(own.name);
}

std::string size_label(double length, double width, const Unit& unit) {
    return length_label(length, unit) + " \u00d7 " + length_label(width, unit);
}

std::string path_label(double metres, const Unit& unit) {
    const Unit own = fitting(metres, unit, unit.decimals + 1);
    return number(metres / own.metres, own.decimals + 1) + " " + std::string(own.name);
}

std::string degrees_label(double radians, int decimals) {
    return number(radians * 180.0 / std::numbers::pi, decimals) + "\u00b0";
}

std::string changes_label(int direction_changes) {
    if (direction_changes == 0) {
        return "no direction change";
    }
    return std::to_string(direction_changes) + (direction_changes == 1 ? " direction change" : " direction changes");
}

RoundLength round_length(double metres) {
    const double power = std::pow(10.0, std::floor(std::log10(metres)));
    const double lead = metres / power;
    const double round = (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0) * power;
    for (const Unit& unit : units) {
        if (round >= 0.999 * unit.metres) {
            return {round, without_zeros(number(round / unit.metres, 3), 0) + " " + std::string(unit.name)};
        }
    }
    return {round, without_zeros(number(round / 1e-6, 6), 0) + " \u00b5m"};
}

}  // namespace snug::drawing
