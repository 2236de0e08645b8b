// What the command writes: standard output, and files that appear whole or not at all.
#pragma once

#include <string>
#include <string_view>

namespace snug::cli {

/// Once, before anything is opened: keeps closed standard streams from being taken by other files, makes a closed pipe
/// an error instead of a silent death, and on Ctrl-C removes a file being written and exits with 130.
void prepare_process();

/// All of it to standard output. Throws Error when it cannot take it.
void print(std::string_view bytes);

/// One line of UTF-8 to standard error, whatever the bytes.
void complain(std::string_view text);

/// Throws Error, beginning with the option, when a file cannot be written there: said before the work, not after it.
void check_writable(const std::string& option, const std::string& path);

/// Whether a file's name ends so (".csv"), in capitals or not, with something before it.
bool ends_with(std::string_view path, std::string_view ending);

/// A file written in parts: a temporary file next to `path` that takes its name when it is complete; devices and pipes are
/// written directly. Whatever fails throws Error, beginning with the option, and leaves nothing behind. One at a time.
class FileInParts {
public:
    FileInParts(const std::string& option, const std::string& path);
    ~FileInParts();  ///< without finish(), nothing remains
    FileInParts(const FileInParts&) = delete;
    FileInParts& operator=(const FileInParts&) = delete;

    void write(std::string_view bytes);
    void finish();

private:
    void abandon();
    [[noreturn]] void fail(int error);

    std::string option_;
    std::string path_;
    std::string target_;  ///< what the temporary file becomes; empty when there is none
    int descriptor_ = -1;
};

/// All of it at once.
void write_file(const std::string& option, const std::string& path, std::string_view bytes);

/// The answer of a command: to the file of `-o`, or to standard output when `path` is empty.
void put_out(const std::string& path, std::string_view answer);

}  // namespace snug::cli
