#include "cli/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace snug::cli {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

using Handler = void (*)(int);
Handler before[3];
std::atomic<int> wanted = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // a signal handler may use it

extern "C" void on_wish(int number) {
    wanted = 128 + number;
    for (int i = 0; i < 3; ++i) {
        if (signals[i] == number) std::signal(number, before[i]);
    }
}

}  // namespace

Interruptible::Interruptible() {
    wanted = 0;
    for (int i = 0; i < 3; ++i) {
        before[i] = std::signal(signals[i], on_wish);
        if (before[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);  // a background job stays deaf
    }
}

Interruptible::~Interruptible() {
    for (int i = 0; i < 3; ++i) std::signal(signals[i], before[i]);
}

int interruption() { return wanted; }

}  // namespace snug::cli
