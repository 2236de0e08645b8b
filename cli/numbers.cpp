// Which numbers were typed, and if none, what would have been right.
#include "cli/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "cli/words.hpp"
#include "sentences/check.hpp"
#include "sentences/spelling.hpp"

namespace snug::cli {
namespace {

constexpr double most_numbers = 1e7;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// How much of the text, from its start, is a decimal number: [+-]digits[.digits][e[+-]digits]
std::size_t decimal_prefix(std::string_view text) {
    const auto digits = [&](std::size_t from) {
        std::size_t end = from;
        while (end < text.size() && is_digit(text[end])) {
            ++end;
        }
        return end;
    };
    const auto is = [&](std::size_t at, std::string_view any) {
        return at < text.size() && any.find(text[at]) != any.npos;
    };
    const std::size_t start = is(0, "+-") ? 1 : 0;
    std::size_t end = digits(start);
    std::size_t count = end - start;
    if (is(end, ".")) {
        const std::size_t fraction = digits(end + 1);
        count += fraction - (end + 1);
        end = fraction;
    }
    if (count == 0) {
        return 0;
    }
    if (is(end, "eE")) {
        const std::size_t exponent = end + (is(end + 1, "+-") ? 2 : 1);
        if (digits(exponent) > exponent) {
            end = digits(exponent);
        }
    }
    return end;
}

/// Is it [+-]digits?
bool is_whole(std::string_view text) {
    const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    return text.size() > sign && std::all_of(text.begin() + sign, text.end(), is_digit);
}

std::string unit_name(std::string_view unit) {
    return unit == " m"         ? "metres"
           : unit == " rad"     ? "radians, or in degrees as 1deg"
           : unit == " degrees" ? "degrees, or in radians as 0.02rad"
                                : "seconds";
}

/// What a number followed by `suffix` is to be multiplied with to be in `unit`: angles say deg or rad.
std::optional<double> factor(std::string_view unit, std::string_view suffix) {
    if (unit == " rad" && (suffix == "deg" || suffix == "\u00b0")) return degree;
    if (unit == " degrees" && suffix == "rad") return 1.0 / degree;
    if ((unit == " rad" && suffix == "rad") || (unit == " degrees" && (suffix == "deg" || suffix == "\u00b0")))
        return 1.0;
    return std::nullopt;
}

/// Two whole numbers with a dash between them, as in 2-5.
bool is_dashed(std::string_view text) {
    const std::size_t dash = text.find('-', 1);
    return dash != text.npos && dash + 1 < text.size() && is_digit(text[dash + 1]) &&
           decimal_prefix(text.substr(dash + 1)) + dash + 1 == text.size() && decimal_prefix(text) == dash;
}

std::string shown(const std::string& text) { return text.empty() ? "nothing" : in_quotes(text); }

/// Digits after the point, so that ranges give the numbers people expect (1.79, not 1.7900000000000003).
int decimals(std::string_view text) {
    const std::size_t point = text.find('.');
    if (text.find_first_of("eE") != text.npos) {
        return 15;
    }
    return point == text.npos ? 0 : static_cast<int>(std::min<std::size_t>(15, text.size() - point - 1));
}

/// Appends the numbers of from:to:step.
void add_range(const std::string& option, const std::string& text, const Quantity& quantity, std::vector<double>& all) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 3) {
        throw Error(option + ": " + in_quotes(text) + " is no range; write from:to:step, for example " +
                    (quantity.unit.empty() ? "0:10:1" : "1.8:2.4:0.01"));
    }
    const double from = number(option, parts[0], quantity);
    const double to = number(option, parts[1], quantity);
    const double step = number(option + " (step)", parts[2], {quantity.unit, 0.0, quantity.high - quantity.low});
    if (!(from <= to) || !(step > 0.0)) {
        throw Error(option + ": " + in_quotes(text) + " goes nowhere; write from:to:step with from <= to and step > 0");
    }
    const double steps = (to - from) / step;
    if (!(static_cast<double>(all.size()) + steps < most_numbers)) {
        throw Error(option + ": " + in_quotes(text) + " has more than ten million numbers; take a larger step");
    }
    const double scale = std::pow(10.0, std::max(decimals(parts[0]), decimals(parts[2])));
    for (int i = 0; i + 1e-9 < steps; ++i) {
        const double value = from + i * step;
        const double tidy = std::round(value * scale) / scale;
        all.push_back(std::isfinite(tidy) && std::abs(tidy - value) < 1e-6 * step ? tidy : value);
    }
    all.push_back(to);
}

}  // namespace

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    for (std::size_t from = 0;;) {
        const std::size_t end = text.find(at, from);
        parts.push_back(text.substr(from, end - from));
        if (end == text.npos) {
            return parts;
        }
        from = end + 1;
    }
}

double number(const std::string& option, const std::string& text, const Quantity& quantity) {
    if (quantity.unit.empty() && !is_whole(text)) {
        throw Error(option + ": " + shown(text) + " is no whole number; write one from " + spelled(quantity.low) +
                    " to " + spelled(quantity.high));
    }
    const std::size_t end = decimal_prefix(text);
    const std::optional<double> in_unit = end == 0 ? std::nullopt : factor(quantity.unit, text.substr(end));
    if (end == 0 || (end < text.size() && !in_unit)) {
        const std::string rest = text.substr(end);
        std::string right = "write a decimal number, in " + unit_name(quantity.unit);
        if (end > 0 && rest[0] == ',') {
            right = "write one number, with a decimal point";
        } else if (end > 0 && std::isalpha(static_cast<unsigned char>(rest[0])) != 0 && rest[0] != 'x') {
            right = "leave out the unit and write the number in " + unit_name(quantity.unit);
        }
        throw Error(option + ": " + shown(text) + " is no number; " + right);
    }
    // The process keeps the C locale: a point is a point.
    const double value = std::strtod(text.c_str(), nullptr) * in_unit.value_or(1.0);
    if (std::isinf(value)) {
        throw Error(option + ": " + in_quotes(text) + " is too large; it must lie between " + spelled(quantity.low) +
                    " and " + spelled(quantity.high) + std::string(quantity.unit));
    }
    try {
        check_between(option, value, quantity.low, quantity.high, quantity.unit);
    } catch (const Error& error) {
        const double from_degrees = value * degree;
        if (in_unit || quantity.unit != " rad" || !(from_degrees >= quantity.low && from_degrees <= quantity.high))
            throw;
        throw Error(std::string(error.what()) + "; " + spelled(value) + " degrees are " + spelled(from_degrees) +
                    " rad, and may be written " + spelled(value) + "deg");
    }
    return value;
}

int whole_number(const std::string& option, const std::string& text, int low, int high) {
    return static_cast<int>(number(option, text, {"", static_cast<double>(low), static_cast<double>(high)}));
}

std::vector<double> numbers(const std::string& option, const std::string& text, const Quantity& quantity) {
    std::vector<double> all;
    for (const std::string& part : split(text, ',')) {
        if (is_dashed(part)) {
            const std::size_t dash = part.find('-', 1);
            throw Error(option + ": " + in_quotes(part) + " is no range; write " + part.substr(0, dash) + ':' +
                        part.substr(dash + 1) + (quantity.unit.empty() ? ":1" : ":0.01"));
        }
        if (part.find(':') == part.npos) {
            all.push_back(number(option, part, quantity));
        } else {
            add_range(option, part, quantity, all);
        }
    }
    return all;
}

std::size_t choice(const std::string& option, const std::string& text, const std::vector<std::string>& words) {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) {
        throw Error(option + ": " + shown(text) + " is not known; write " + either(words));
    }
    return static_cast<std::size_t>(found - words.begin());
}

}  // namespace snug::cli
