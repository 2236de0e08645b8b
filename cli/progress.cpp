// The line of progress: overwritten in place for who watches, now and then a new one for a log.
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

/// Writes a line when it is time for one: on a terminal from half a second on, in a log every minute.
class Line {
public:
    void write(const std::function<std::string(double seconds)>& text) {
        using namespace std::chrono_literals;
        if (const Clock::time_point now = Clock::now(); now >= next_) {
            next_ = now + (overwritten_ ? Clock::duration(100ms) : Clock::duration(1min));
            const double spent = std::chrono::duration<double>(now - begin_).count();
            std::fprintf(stderr, overwritten_ ? "\r%s\x1b[K" : "%s\n", text(spent).c_str());
        }
    }

private:
    using Clock = std::chrono::steady_clock;
    bool overwritten_ = watched();
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_ + std::chrono::milliseconds(overwritten_ ? 500 : 60'000);
};

}  // namespace

bool watched() { return isatty(STDERR_FILENO) != 0; }

std::function<bool(double)> show_progress() {
    if (!watched()) return {};
    return [line = Line()](double done) mutable {
        line.write([&](double spent) {
            const std::string left = done > 0.0 ? ", " + duration(spent * (1.0 - done) / done) + " left" : "";
            return fixed(100.0 * done, 0) + " %" + left;
        });
        return true;
    };
}

std::function<bool(const FewestProgress&)> show_bounds() {
    if (!watched()) return {};
    return [line = Line()](const FewestProgress& so_far) mutable {
        line.write([&](double spent) {
            std::string text = std::to_string(so_far.lower_bound) + " direction changes or more";
            if (so_far.direction_changes)
                text = std::to_string(so_far.lower_bound) + " to " + std::to_string(*so_far.direction_changes) +
                       " direction changes";
            if (so_far.direction_changes == so_far.lower_bound) text = "proved; looking for the roomiest maneuver";
            if (so_far.spacing > 0.0) text += ", lattice " + fixed(1e3 * so_far.spacing, 2) + " mm";
            return text + ", " + duration(spent);
        });
        return true;
    };
}

std::function<void(const AtlasProgress&)> show_cells() {
    return [line = Line()](const AtlasProgress& so_far) mutable {
        line.write([&](double spent) {
            std::string text = std::to_string(so_far.stored) + " of " + std::to_string(so_far.cells) + " cells";
            if (so_far.solved == 0) return text;
            const double rate = static_cast<double>(so_far.solved) / spent;
            const double left = static_cast<double>(so_far.cells - so_far.stored) / rate;
            return text + ", " + fixed(rate, rate < 10.0 ? 1 : 0) + " a second, " + duration(left) + " left";
        });
    };
}

void wipe_progress() {
    if (watched()) {
        std::fputs("\r\x1b[K", stderr);
    }
}

}  // namespace snug::cli
