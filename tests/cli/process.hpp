// Runs the command as people do: as a process of its own.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace snug::test {

struct Result {
    int exit_code = -1;  ///< -1 when it died of a signal
    std::string out;
    std::string err;
};

inline std::string contents(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder that goes away with its owner.
class Folder {
public:
    Folder() {
        std::string pattern = std::filesystem::temp_directory_path() / "snug-test-XXXXXX";
        path_ = mkdtemp(pattern.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::string file(const std::string& name) const { return path_ / name; }
    [[nodiscard]] std::string with(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
        return file(name);
    }
    [[nodiscard]] std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
    }

private:
    std::filesystem::path path_;
};

/// The command that was built with the tests, or the one that SNUG_COMMAND names: one with sanitizers, say.
inline const char* snug_command() {
    const char* named = std::getenv("SNUG_COMMAND");
    return named == nullptr ? SNUG_COMMAND : named;
}

/// Starts `snug` with the arguments; standard output goes to the file `out` ("-" leaves it closed).
inline pid_t start(const std::vector<std::string>& arguments, const std::string& out, const std::string& err) {
    // Looking for leaks takes longer than most answers: each test has it done in its first run, and in every eighth.
    static int runs = 0;
    const bool leaks = runs++ % 8 == 0;
    const pid_t child = fork();
    if (child == -1) {
        std::abort();  // never to be taken for the number of a process
    }
    if (child != 0) {
        return child;
    }
    if (!leaks) {
        setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
    }
    std::signal(SIGINT, SIG_DFL);  // whatever the tests were started with
    const auto send = [](int stream, const std::string& file) {
        close(stream);
        if (file != "-" && open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600) != stream) {
            _exit(99);
        }
    };
    send(STDERR_FILENO, err);  // first: opening takes the lowest free number
    send(STDOUT_FILENO, out);
    std::vector<std::string> words = arguments;
    words.insert(words.begin(), "snug");
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    execv(snug_command(), pointers.data());
    _exit(98);
}

inline int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

inline Result run(const std::vector<std::string>& arguments, const std::string& out = "") {
    const Folder folder;
    const std::string err = folder.file("err");
    Result result;
    result.exit_code = wait_for(start(arguments, out.empty() ? folder.file("out") : out, err));
    result.out = out.empty() ? contents(folder.file("out")) : "";
    result.err = contents(err);
    return result;
}

inline std::vector<std::string> words(const std::string& line) {
    std::vector<std::string> all;
    for (std::size_t from = 0; from < line.size();) {
        const std::size_t end = std::min(line.find(' ', from), line.size());
        if (end > from) {
            all.push_back(line.substr(from, end - from));
        }
        from = end + 1;
    }
    return all;
}

inline Result run(const std::string& line, const std::string& out = "") { return run(words(line), out); }

/// Exit 2, nothing on standard output, and one line on standard error that holds every one of the words.
inline void expect_refusal(const Result& result, const std::vector<std::string>& named) {
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(!result.err.empty() && result.err.back() == '\n') << result.err;
    for (const std::string& word : named) {
        EXPECT_NE(result.err.find(word), std::string::npos) << '"' << word << "\" is not in: " << result.err;
    }
}

}  // namespace snug::test
