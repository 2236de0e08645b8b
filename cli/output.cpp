// How bytes get out, with every failure noticed. POSIX calls, because streams hide what went wrong.
#include "cli/output.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>

#include "sentences/spelling.hpp"
#include "snug/error.hpp"

namespace snug::cli {
namespace {

// The temporary file being written, for the signal handler: nothing else can reach it there.
char temporary[PATH_MAX];
volatile std::sig_atomic_t temporary_exists = 0;

extern "C" void on_signal(int number) {
    if (temporary_exists != 0) {
        unlink(temporary);
    }
    _exit(128 + number);  // as shells say it
}

std::string reason(int error) { return std::generic_category().message(error); }

/// The error number of the first write that failed, 0 for none.
int write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return errno;
        }
        bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
    }
    return 0;
}

Error cannot_write(const std::string& option, const std::string& path, int error) {
    return Error(option + ": cannot write " + in_quotes(path) + ": " + reason(error) +
                 "; give a file in a folder that exists, is writable and has room");
}

/// What symbolic links lead to, so that renaming replaces the file and not the link.
std::string target_of(const std::string& path) {
    const std::unique_ptr<char, void (*)(void*)> resolved(realpath(path.c_str(), nullptr), std::free);
    return resolved ? resolved.get() : path;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == path.npos ? "./" : path.substr(0, slash + 1);
}

mode_t usual_mode() {
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/// Holds signals back while the temporary file and its name are in two minds.
class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t all;
        sigfillset(&all);
        sigprocmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsHeld() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_;
};

/// A descriptor of a new temporary file in the folder, or -1.
int open_temporary(const std::string& folder) {
    const SignalsHeld held;
    const std::string pattern = folder + ".snug-XXXXXX";
    if (pattern.size() >= sizeof temporary) {
        errno = ENAMETOOLONG;
        return -1;
    }
    std::strcpy(temporary, pattern.c_str());
    const int descriptor = mkostemp(temporary, O_CLOEXEC);
    temporary_exists = descriptor >= 0 ? 1 : 0;
    return descriptor;
}

}  // namespace

void prepare_process() {
    // Lattices of many megabytes come and go: their memory is kept for the next one instead of being returned and cleared
    // anew, which takes half as long as the search itself.
    mallopt(M_MMAP_THRESHOLD, 1 << 25);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) == -1) {
            static_cast<void>(open("/dev/null", O_RDONLY));  // takes the number; writing to it stays an error
        }
    }
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (std::signal(number, on_signal) == SIG_IGN) {
            std::signal(number, SIG_IGN);  // a background job stays deaf
        }
    }
}

void print(std::string_view bytes) {
    int error = write_all(STDOUT_FILENO, bytes);
    if (error == 0) {
        const int copy = dup(STDOUT_FILENO);  // some file systems report a full disk only on closing
        error = copy < 0 || close(copy) != 0 ? errno : 0;
    }
    if (error != 0) {
        throw Error("cannot write to standard output: " + reason(error) + "; give it a place that takes the answer");
    }
}

void complain(std::string_view text) { static_cast<void>(write_all(STDERR_FILENO, printable(text) + '\n')); }

void check_writable(const std::string& option, const std::string& path) {
    struct stat status = {};
    int error = 0;
    if (path.empty() || path.find('\0') != path.npos) {
        error = ENOENT;
    } else if (stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) {
            error = EISDIR;
        } else if (access(path.c_str(), W_OK) != 0 ||
                   (S_ISREG(status.st_mode) && access(folder_of(target_of(path)).c_str(), W_OK | X_OK) != 0)) {
            error = errno;
        }
    } else if (errno != ENOENT || access(folder_of(path).c_str(), W_OK | X_OK) != 0) {
        error = errno;
    } else if (path.back() == '/') {
        error = EISDIR;
    }
    if (error != 0) {
        throw cannot_write(option, path, error);
    }
}

bool ends_with(std::string_view path, std::string_view ending) {
    return path.size() > ending.size() &&
           std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

FileInParts::FileInParts(const std::string& option, const std::string& path) : option_(option), path_(path) {
    check_writable(option, path);
    struct stat status = {};
    const bool exists = stat(path.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode)) {
        descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        target_ = target_of(path);
        descriptor_ = open_temporary(folder_of(target_));
    }
    if (descriptor_ < 0) {
        throw cannot_write(option, path, errno);
    }
    if (!target_.empty() && fchmod(descriptor_, exists ? status.st_mode & 07777 : usual_mode()) != 0) {
        fail(errno);
    }
}

FileInParts::~FileInParts() { abandon(); }

void FileInParts::write(std::string_view bytes) {
    if (const int error = write_all(descriptor_, bytes); error != 0) {
        fail(error);
    }
}

void FileInParts::finish() {
    if (close(std::exchange(descriptor_, -1)) != 0) {
        fail(errno);
    }
    const SignalsHeld held;
    if (!target_.empty() && std::rename(temporary, target_.c_str()) != 0) {
        fail(errno);
    }
    temporary_exists = 0;
    target_.clear();
}

void FileInParts::abandon() {
    if (descriptor_ >= 0) {
        close(std::exchange(descriptor_, -1));
    }
    const SignalsHeld held;
    if (!target_.empty()) {
        unlink(temporary);
        temporary_exists = 0;
        target_.clear();
    }
}

void FileInParts::fail(int error) {
    abandon();
    throw cannot_write(option_, path_, error);
}

void write_file(const std::string& option, const std::string& path, std::string_view bytes) {
    FileInParts file(option, path);
    file.write(bytes);
    file.finish();
}

void put_out(const std::string& path, std::string_view answer) {
    if (path.empty()) {
        print(answer);
    } else {
        write_file("--output", path, answer);
    }
}

}  // namespace snug::cli
