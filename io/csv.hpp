// Rows of CSV (RFC 4180): numbers with all their digits, an empty field where there is none, quotes where they are needed.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "snug/io.hpp"

namespace snug {

/// A table: the names of its columns, then row after row.
class Csv {
public:
    Csv() = default;
    Csv(std::initializer_list<std::string_view> columns) {
        for (const std::string_view column : columns) add(std::string(column));
        end_row();
    }

    template <class... Fields>
    void row(const Fields&... fields) {
        (add(field(fields)), ...);
        end_row();
    }
    /// Field by field, where their number is not known before.
    template <class Field>
    void add_field(const Field& value) {
        add(field(value));
    }
    void end_row() {
        text_ += '\n';
        in_row_ = false;
    }

    [[nodiscard]] const std::string& text() const { return text_; }
    /// What has been written since the last time.
    std::string take() { return std::exchange(text_, {}); }

private:
    static std::string field(std::string_view text);  ///< quoted where it has to be
    static std::string field(const char* text) { return field(std::string_view(text)); }
    static std::string field(const std::string& text) { return field(std::string_view(text)); }
    template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
    static std::string field(Number number) {
        if constexpr (std::is_floating_point_v<Number>)
            return write(static_cast<double>(number));
        else
            return std::to_string(number);
    }
    template <class Value>
    static std::string field(const std::optional<Value>& value) {
        return value ? field(*value) : std::string();
    }
    void add(const std::string& field) {
        if (std::exchange(in_row_, true)) text_ += ',';
        text_ += field;
    }

    std::string text_;
    bool in_row_ = false;
};

}  // namespace snug
