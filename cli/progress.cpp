// The line of progress, overwritten in place.
#include "cli/progress.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

#include "cli/table.hpp"

namespace snug::cli {
namespace {

/// "90 s", "12 min", "3 h"
std::string duration(double seconds) {
    const auto in = [](double amount, const char* unit) { return fixed(std::ceil(amount), 0) + unit; };
    if (seconds < 120.0) return in(seconds, " s");
    if (seconds < 7200.0) return in(seconds / 60.0, " min");
    return in(seconds / 3600.0, " h");
}

}  // namespace

std::function<bool(double)> show_progress() {
    if (isatty(STDERR_FILENO) == 0) {
        return {};
    }
    using namespace std::chrono_literals;
    using Clock = std::chrono::steady_clock;
    return [begin = Clock::now(), next = Clock::now() + 500ms](double done) mutable {
        if (const Clock::time_point now = Clock::now(); now >= next) {
            next = now + 100ms;
            const double spent = std::chrono::duration<double>(now - begin).count();
            const std::string left = done > 0.0 ? ", " + duration(spent * (1.0 - done) / done) + " left" : "";
            std::fprintf(stderr, "\r%3.0f %%%s\x1b[K", 100.0 * done, left.c_str());
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
