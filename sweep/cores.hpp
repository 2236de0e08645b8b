// How many threads oneTBB has work at once. For the layers that use it, not for the core.
#pragma once

#include <oneapi/tbb/info.h>

#include <algorithm>

namespace snug {

/// So many, if the process may use as many cores (oneTBB complains when it is asked for more); 0: one on each core.
inline int threads_at_once(int asked) {
    const int cores = tbb::info::default_concurrency();
    return asked > 0 ? std::min(asked, cores) : cores;
}

}  // namespace snug
