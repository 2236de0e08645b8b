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

/// What was typed in quotes, fit for one line: its first 60 bytes, without control characters.
inline std::string in_quotes(std::string_view typed) {
    constexpr std::size_t most = 60;
    std::string shown(typed.substr(0, most));
    std::replace_if(shown.begin(), shown.end(), is_control, '?');
    return '"' + shown + (typed.size() > most ? "...\"" : "\"");
}

}  // namespace snug
