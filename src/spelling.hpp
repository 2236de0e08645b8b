// What somebody typed, in a sentence about it: quoted, and next to the words that would be right.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace snug {

/// Levenshtein's distance: how many letters to insert, delete or replace.
inline std::size_t spelling_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row[b.size()];
}

/// The word that was probably meant: one that holds what was typed, else the closest in spelling; the first of several.
/// There must be one.
inline std::string nearest_word(std::string_view typed, const std::vector<std::string>& words) {
    const auto distance = [&](const std::string& word) {
        return typed.size() > 1 && word.find(typed) != word.npos ? 0 : spelling_distance(word, typed);
    };
    return *std::min_element(words.begin(), words.end(),
                             [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
}

/// "a, b or c"
inline std::string either(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    }
    return text;
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
