// The inner loops of the sweeps of sets: a stretch of a row, in vectors.
#pragma once

#include <cstddef>

#include "all_maneuvers/sets/outer_sets.hpp"

namespace snug::detail::sets {

/// A stretch of cells that takes in pairs (z, w): those that fit its intervals, clipped to them, and the hull of these.
struct Taking {
    Micro *z, *w;
    const Micro *low, *high;
    const Micro *up, *down, *z_high, *w_low, *apart;
};

/// Pairs z + more_z, w + more_w.
struct Given {
    const Micro *z, *w;
    const Micro *more_z, *more_w;  ///< null for nothing
};

/// `count` cells take in what is given. Whole vectors are read beyond the end: up to `vector_padding` numbers more.
void take_in(const Taking& taking, const Given& given, std::size_t count);

/// Of so many cells the intervals cut down to others: low + more_low to high + more_high, nothing added if these are null. Each
/// takes them into the hull that it has. Whole vectors are read, as above.
struct Cutting {
    Micro *low, *high;
    const Micro *free_low, *free_high;
    const Micro *limit_low, *limit_high;
    const Micro *more_low, *more_high;
};
void cut(const Cutting& cutting, std::size_t count);

constexpr std::size_t vector_padding = 16;

/// From the first to before the last of so many cells that hold anything; `from` is `to` where none does.
struct Stretch {
    std::size_t from, to;
};
Stretch reached(const Micro* z, std::size_t count);

}  // namespace snug::detail::sets
