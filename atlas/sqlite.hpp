// SQLite with errors as exceptions: a connection and its statements.
#pragma once

#include <sqlite3.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "snug/error.hpp"

namespace snug {

/// What SQLite refused, with the file's name and the reason.
class SqliteError : public Error {
public:
    SqliteError(int code, const std::string& reason) : Error(reason), code_(code) {}
    [[nodiscard]] int code() const { return code_; }

private:
    int code_;
};

/// An open database.
class Connection {
public:
    /// An existing file; for reading only where it may not be written.
    explicit Connection(const std::string& path);
    ~Connection() { sqlite3_close(handle_); }
    Connection(Connection&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    Connection& operator=(Connection&&) = delete;

    void run(const std::string& statements);
    [[nodiscard]] sqlite3* handle() const { return handle_; }

private:
    sqlite3* handle_ = nullptr;
};

/// A prepared statement: values in, rows out.
class Statement {
public:
    Statement(const Connection& connection, std::string_view text);
    ~Statement() { sqlite3_finalize(handle_); }
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    /// Sets the parameters from the first on, as many as there are, after those of an earlier run.
    template <class... Values>
    Statement& with(Values... values) {
        sqlite3_reset(handle_);
        int at = 0;
        (bind(++at, values), ...);
        return *this;
    }
    /// Goes to the next row; false when there is none.
    bool row();
    /// Runs a statement that gives no rows.
    template <class... Values>
    void run(Values... values) {
        with(values...);
        while (row()) {
        }
    }

    // Columns of the row, from 0 on.
    [[nodiscard]] bool is_null(int column) const { return sqlite3_column_type(handle_, column) == SQLITE_NULL; }
    [[nodiscard]] std::int64_t integer(int column) const { return sqlite3_column_int64(handle_, column); }
    [[nodiscard]] int small(int column) const { return sqlite3_column_int(handle_, column); }
    [[nodiscard]] double real(int column) const { return sqlite3_column_double(handle_, column); }
    [[nodiscard]] std::string text(int column) const;

private:
    void bind(int at, std::nullptr_t) { check(sqlite3_bind_null(handle_, at)); }
    void bind(int at, std::int64_t value) { check(sqlite3_bind_int64(handle_, at, value)); }
    void bind(int at, int value) { check(sqlite3_bind_int(handle_, at, value)); }
    void bind(int at, bool value) { check(sqlite3_bind_int(handle_, at, value ? 1 : 0)); }
    void bind(int at, double value) { check(sqlite3_bind_double(handle_, at, value)); }
    void bind(int at, std::string_view text);
    template <class T>
    void bind(int at, const std::optional<T>& value) {
        value ? bind(at, *value) : bind(at, nullptr);
    }
    void check(int code) const;

    sqlite3* connection_ = nullptr;
    sqlite3_stmt* handle_ = nullptr;
};

}  // namespace snug
