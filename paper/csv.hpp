// A table as CSV: one header, rows of numbers and words, an empty field where there is no answer.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include "paper/paper.hpp"
#include "snug/io.hpp"

namespace snug::paper {

/// A point of a grid, without the digits that counting it out has left. [m]
inline double on_grid(double value) { return std::round(value * 1e9) / 1e9; }

class Csv {
public:
    explicit Csv(std::string header) : text_(std::move(header)) { text_ += '\n'; }

    /// A row; a word must hold no comma.
    template <class First, class... Rest>
    void row(const First& first, const Rest&... rest) {
        text_ += field(first);
        ((text_ += ',', text_ += field(rest)), ...);
        text_ += '\n';
    }

    [[nodiscard]] File file(std::string name) const { return {std::move(name), text_}; }

private:
    static std::string field(const std::string& word) { return word; }
    static std::string field(double number) { return write(number); }
    static std::string field(int number) { return std::to_string(number); }
    template <class Number>
    static std::string field(const std::optional<Number>& number) {
        return number ? field(*number) : std::string();
    }

    std::string text_;
};

}  // namespace snug::paper
