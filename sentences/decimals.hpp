// Numbers as people write them, and back: with a decimal point, whatever the locale. Without streams, which are most of a
// small program where they are linked at all.
#pragma once

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

namespace snug {

/// 12 digits at most, no trailing zeros.
inline std::string spelled(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.12g", value);
    std::string text;
    bool in_point = false;  // which may have several bytes
    for (const char* c = digits; *c != '\0'; ++c) {
        const bool is_point = std::string_view("+-0123456789aefin").find(*c) == std::string_view::npos;
        if (!is_point) text += *c;
        if (is_point && !in_point) text += '.';
        in_point = is_point;
    }
    return text;
}

/// The whole text as a number; empty where it is none, or none that a double can hold.
inline std::optional<double> decimal(std::string_view text) {
    if (text.empty() || text.find_first_not_of("+-.0123456789eE") != text.npos) return std::nullopt;
    std::string local(text);
    const std::size_t point = local.find('.');
    if (point != local.npos) local.replace(point, 1, std::localeconv()->decimal_point);
    char* end = nullptr;
    const double value = std::strtod(local.c_str(), &end);
    return end == local.c_str() + local.size() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace snug
