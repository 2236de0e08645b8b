// What somebody typed, in a sentence about it: quoted, and next to the words that would be right.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug {

/// Damerau's distance: how many letters to insert, delete, replace or swap with their neighbour.
inline std::size_t spelling_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> starts(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            std::size_t& least = starts[i][j];  // of the first i letters of a to the first j of b
            least = i + j;
            if (i == 0 || j == 0) continue;
            const std::size_t replaced = starts[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            least = std::min({replaced, starts[i - 1][j] + 1, starts[i][j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) least = std::min(least, starts[i - 2][j - 2] + 1);
        }
    }
    return starts[a.size()][b.size()];
}

/// The word that was probably meant: one with a part that begins with what was typed ("renault-zoe" for "zoe"), or the
/// closest in spelling if at most a third of the letters differ; the first of several.
inline std::optional<std::string> nearest_word(std::string_view typed, const std::vector<std::string>& words) {
    std::string lower(typed.substr(0, 100));  // what is longer is near nothing
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    const std::string part = lower.substr(std::min(lower.find_first_not_of('-'), lower.size()));
    std::optional<std::string> nearest;
    std::size_t least = lower.npos;
    for (const std::string& word : words) {
        const bool begins = part.size() > 1 && ('-' + word).find('-' + part) != word.npos;
        const std::size_t distance = begins ? 0 : spelling_distance(word, lower);
        if (3 * distance > std::max(word.size(), lower.size()) || distance >= least) continue;
        least = distance;
        nearest = word;
    }
    return nearest;
}

/// "a, b or c"
inline std::string either(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    return text;
}

/// "did you mean X?" when one of the words is near what was typed, otherwise what to do instead.
inline std::string did_you_mean(const std::optional<std::string>& nearest, const std::string& otherwise) {
    return nearest ? "did you mean " + *nearest + '?' : otherwise;
}

/// A control character of ASCII, which could break or overwrite a line.
inline bool is_control(char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }

/// How many bytes the first character of a text has, as UTF-8; 0 when it is none, or a control character.
inline std::size_t printable_bytes(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(0);
    if (first < 0x80) return is_control(text[0]) ? 0 : 1;
    if (first < 0xc2 || first > 0xf4) return 0;
    const std::size_t count = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    unsigned code = first & (0xffU >> (count + 1));
    for (std::size_t i = 1; i < count; ++i) {
        if ((byte(i) & 0xc0U) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3fU);
    }
    constexpr unsigned least[] = {0, 0, 0xa0, 0x800, 0x10000};  // below are control characters and longer spellings
    const bool surrogate = code >= 0xd800 && code <= 0xdfff;
    return code < least[count] || surrogate || code > 0x10ffff ? 0 : count;
}

/// Any bytes as text for one line: those that are no printable UTF-8 as \xNN.
inline std::string printable(std::string_view bytes) {
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    while (!bytes.empty()) {
        const std::size_t count = printable_bytes(bytes);
        if (count == 0) {
            const auto byte = static_cast<unsigned char>(bytes[0]);
            text += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
        }
        text += bytes.substr(0, count);
        bytes.remove_prefix(std::max<std::size_t>(count, 1));
    }
    return text;
}

/// What was typed in quotes, fit for one line: its first 60 bytes, no character cut in two.
inline std::string in_quotes(std::string_view typed) {
    constexpr std::size_t most = 60;
    std::size_t end = 0;
    while (end < typed.size()) {
        const std::size_t next = end + std::max<std::size_t>(printable_bytes(typed.substr(end)), 1);
        if (next > most) break;
        end = next;
    }
    return '"' + printable(typed.substr(0, end)) + (end < typed.size() ? "...\"" : "\"");
}

}  // namespace snug
