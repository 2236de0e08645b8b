// The line of progress, overwritten in place.
#include "cli/progress.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace snug::cli {

std::function<bool(double)> show_progress() {
    if (isatty(STDERR_FILENO) == 0) {
        return {};
    }
    using namespace std::chrono_literals;
    using Clock = std::chrono::steady_clock;
    return [next = Clock::now() + 500ms](double done) mutable {
        if (const Clock::time_point now = Clock::now(); now >= next) {
            next = now + 100ms;
            std::fprintf(stderr, "\r%3.0f %%", 100.0 * done);
        }
        return true;
    };
}

void wipe_progress() {
    if (isatty(STDERR_FILENO) != 0) {
        std::fputs("\r\x1b[K", stderr);
    }
}

}  // namespace snug::cli
