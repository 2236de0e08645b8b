#include "sqlite.hpp"

#include "atlas/damage.hpp"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "sentences/spelling.hpp"

namespace snug {

namespace {

constexpr int patience = 20000;  // for a commit or a reader in another process [ms]

/// What to do about it, where SQLite's own words leave that open.
std::string advice(int code) {
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) return "; it is damaged: " + after_damage;
    return code == SQLITE_CANTOPEN ? "; the folder it is in has to be writable, for the journal beside it" : "";
}

[[noreturn]] void fail(sqlite3* connection, int code) {
    const std::string path = sqlite3_db_filename(connection, "main");
    throw SqliteError(code,
                      in_quotes(path.substr(path.rfind('/') + 1)) + ": " + sqlite3_errmsg(connection) + advice(code));
}

}  // namespace

Connection::Connection(const std::string& path) {
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::status(path, none);
    if (std::filesystem::is_other(status))
        throw Error(in_quotes(path) + " is no file; give a database that snug atlas build has made");
    // The name is a path, whatever it looks like: "./" keeps SQLite from taking ":memory:" or "file:..." for more.
    const std::string name = path.substr(0, 1) == "/" ? path : "./" + path;
    const int code = sqlite3_open_v2(name.c_str(), &handle_, SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOMUTEX, nullptr);
    if (code != SQLITE_OK) {
        const int reason = handle_ == nullptr ? ENOMEM : sqlite3_system_errno(handle_);
        sqlite3_close(handle_);
        throw SqliteError(code, in_quotes(path) + " cannot be read: " + std::generic_category().message(reason) +
                                    "; give a file that snug atlas build has made");
    }
    sqlite3_busy_timeout(handle_, patience);
}

void Connection::run(const std::string& statements) {
    const int code = sqlite3_exec(handle_, statements.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) fail(handle_, code);
}

Statement::Statement(const Connection& connection, std::string_view text) : connection_(connection.handle()) {
    check(sqlite3_prepare_v2(connection_, text.data(), static_cast<int>(text.size()), &handle_, nullptr));
}

bool Statement::row() {
    const int code = sqlite3_step(handle_);
    if (code == SQLITE_ROW) return true;
    sqlite3_reset(handle_);
    if (code != SQLITE_DONE) fail(connection_, code);
    return false;
}

std::string Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column));
    return bytes == nullptr ? std::string()
                            : std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(handle_, column)));
}

void Statement::bind(int at, std::string_view text) {
    check(sqlite3_bind_text(handle_, at, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT));
}

void Statement::check(int code) const {
    if (code != SQLITE_OK) fail(connection_, code);
}

}  // namespace snug
