// How many threads work at once.
#pragma once

#include <algorithm>
#include <thread>

namespace snug {

/// So many, if there are as many cores (oneTBB complains when it is asked for more); 0: one on each core.
inline int threads_at_once(int asked) {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return asked > 0 ? std::min(asked, cores) : cores;
}

}  // namespace snug
