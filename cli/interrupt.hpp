// Ctrl-C for work that ends in good order: what is finished is kept.
#pragma once

namespace snug::cli {

/// While one lives, the first Ctrl-C (or SIGTERM, or SIGHUP) is a wish to end, which whoever works asks about; a second one
/// ends the process at once.
class Interruptible {
public:
    Interruptible();
    ~Interruptible();
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;
};

/// The exit code that such a signal asks for, 128 and its number; 0 when there was none. For any thread.
int interruption();

}  // namespace snug::cli
