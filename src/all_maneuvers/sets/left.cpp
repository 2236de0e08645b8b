#include "all_maneuvers/sets/left.hpp"

#include <algorithm>
#include <utility>

#include "all_maneuvers/workers.hpp"

namespace snug::detail::sets {

namespace {

constexpr std::size_t most_bytes = 260'000'000;  ///< of sets, while they are computed

std::size_t bytes_of(const Layer& layer) { return (layer.low.size() + layer.high.size()) * sizeof(Micro); }
std::size_t bytes_of(const Limits& limits) {
    std::size_t bytes = 0;
    for (const Layer& layer : limits) bytes += bytes_of(layer);
    return bytes;
}

}  // namespace

bool has_no_cells(const Limits& limits) {
    return std::all_of(limits.begin(), limits.end(), [](const Layer& layer) { return layer.spans.cells == 0; });
}

bool fit(const OuterLattice& lattice, int changes) {
    return bytes_of(lattice.free()) * 6 * static_cast<std::size_t>(changes + 1) <= most_bytes;
}

Counted count_from_below(const OuterLattice& lattice, int most, bool keep, const Watch& watch) {
    Counted counted;
    auto& [forward, backward] = counted.sets;
    for (; counted.changes <= most; ++counted.changes) {
        const bool first = forward.empty();
        BothWays<Pairs> next =
            next_moves(lattice, first ? nullptr : &forward.back(), first ? nullptr : &backward.back(), watch);
        counted.impossible =
            !first && same(next.forward.back(), forward.back()) && same(next.backward.back(), backward.back());
        if (!keep || !fit(lattice, counted.changes)) forward.clear(), backward.clear();
        bool reached = false;
        for (const Direction direction : both_directions) {
            reached = reached || lattice.holds_start(next.of(direction).back(), lattice.free(), direction);
            counted.sets.of(direction).push_back(std::move(next.of(direction).back()));
        }
        if (reached || counted.impossible) break;
    }
    if (!keep || !fit(lattice, counted.changes)) counted.sets = {};
    if (counted.impossible) counted.changes = most + 1;
    return counted;
}

std::size_t bytes_of(const Left& left) {
    std::size_t bytes = bytes_of(left.hull_of_all);
    for (const Direction direction : both_directions)
        for (const Limits& limits : left.moves.of(direction)) bytes += bytes_of(limits);
    return bytes;
}

Layer hull_of(const BothWays<Limits>& moves) {
    std::vector<const Limits*> several;
    for (const Direction direction : both_directions)
        for (const Limits& limits : moves.of(direction)) several.push_back(&limits);
    return hull(several);
}

std::optional<Left> refined(const ChartPlace& place, double h0, Left left, std::size_t& updates, const Watch& watch) {
    const double h = left.h / 2.0;
    const std::size_t moves = left.moves.forward.size();
    // Each cell has four children. What is free in them, and two moves each way, are held beside what is kept.
    if (4 * bytes_of(left.hull_of_all) > most_bytes / 2) throw TooLarge{};
    const OuterLattice lattice(place, h, h0, &left.hull_of_all, watch);
    BothWays<Limits>& limits = left.moves;
    /// A move of either direction, and that before it.
    struct Move {
        Limits limits;
        Pairs pairs;
    };
    Move now[2], before[2];  // forward and backward
    /// Drives move k both ways, at the same time where there is about as much to do.
    const auto drive = [&](std::size_t k, const auto& one_way) {
        const std::size_t forward = bytes_of(limits.forward[k]), backward = bytes_of(limits.backward[k]);
        const bool balanced = 2 * std::min(forward, backward) > std::max(forward, backward);
        in_parts(watch, balanced, 2, [&](int part, const Watch& watched) {
            one_way(both_directions[part], now[part], before[1 - part], watched);
        });
        std::swap(now, before);
    };
    // Outward from the parked poses.
    std::size_t bytes = bytes_of(lattice.free());
    bool all_kept = true;
    for (std::size_t k = 0; k < moves; ++k) {
        drive(k, [&](Direction direction, Move& move, const Move& last, const Watch& watched) {
            Limits& mine = limits.of(direction)[k];
            lattice.room_for_clipped(mine, move.limits, watched);
            lattice.sweep(move.pairs, move.limits, direction, watched, [&](Rows rows) {
                lattice.clip(rows, mine, move.limits);
                if (k == 0) {
                    lattice.begin(rows, move.pairs, move.limits, direction, lattice.parked());
                } else {
                    lattice.turn(rows, move.pairs, move.limits, direction, last.pairs);
                }
            });
            mine = lattice.within(move.pairs, move.limits, direction, watched);
        });
        for (const Direction direction : both_directions) {
            const std::size_t of_move = bytes_of(limits.of(direction)[k]);
            bytes += of_move;
            all_kept = all_kept && bytes + 4 * of_move <= most_bytes;
        }
        if (all_kept) continue;
        for (const Direction direction : both_directions) std::fill_n(limits.of(direction).begin(), k, Limits{});
    }
    bool reached = false;
    for (const int part : {0, 1})
        reached = reached || lattice.holds_start(before[part].pairs, before[part].limits, both_directions[part]);
    updates += lattice.take_updates();
    if (!reached) return std::nullopt;
    if (!all_kept) throw TooLarge{};
    // Then from the start. Driving forward when leaving is driving backward when parking, and move k is the last but k.
    for (std::size_t k = moves; k-- > 0;) {
        drive(k, [&](Direction direction, Move& move, const Move& last, const Watch& watched) {
            Limits& mine = limits.of(other(direction))[k];
            move.limits = std::move(mine);
            lattice.sweep(move.pairs, move.limits, direction, watched, [&](Rows rows) {
                if (k + 1 == moves) {
                    lattice.begin_at_start(rows, move.pairs, move.limits, direction);
                } else {
                    lattice.turn(rows, move.pairs, move.limits, direction, last.pairs);
                }
            });
            mine = lattice.within(move.pairs, move.limits, direction, watched);
        });
    }
    updates += lattice.take_updates();
    left.h = h;
    left.hull_of_all = hull_of(limits);
    return left;
}

}  // namespace snug::detail::sets
