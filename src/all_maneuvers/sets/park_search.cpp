#include "all_maneuvers/sets/park_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "all_maneuvers/sets/few_pieces.hpp"
#include "all_maneuvers/sets/left.hpp"
#include "all_maneuvers/sets/route.hpp"
#include "all_maneuvers/sets/ways.hpp"

namespace snug::detail::sets {

namespace {

constexpr int most_looks_at_slot = 3;     ///< each on lattices of four times as many cells as the one before,
constexpr double least_slot_cells = 1e6;  ///< 16 bytes each
constexpr int tried_above = 2;            ///< counts above the lower bound for which a lattice looks for a way
constexpr int far_above = 40;             ///< and how far the coarse ones look for where to begin
constexpr int many_changes = 20;          ///< from so many on finer lattices count first
constexpr std::size_t soon_done =
    400'000'000;                 ///< cells computed: with more, halving the finest spacing again would take minutes
constexpr int others_tried = 2;  ///< with more changes
constexpr std::size_t most_kept = 32'500'000;  ///< bytes of what is left of lattices

}  // namespace

void narrow(const ParkQuestion& question, ParkBounds& bounds, const Watch& watch) {
    if (is_parked(question.place, question.place.start)) {
        bounds.upper = 0;  // there is nothing to do
        return;
    }
    const double h0 = question.coarsest;
    const OuterLattice lattice(question.place, h0, h0, nullptr, watch);
    int looks_at_slot = question.slot ? 0 : most_looks_at_slot;
    bool found_elsewhere = false;  ///< the way, so no lattice of sets has it yet
    const auto take_from_elsewhere = [&](std::vector<Path> way) {
        if (way.empty()) return;
        bounds.upper = changes_of(way);
        bounds.way = std::move(way);
        found_elsewhere = true;
    };
    bool asked_map = false;
    const auto ask_map = [&] {
        asked_map = true;
        take_from_elsewhere(way_on_map(question.place, h0, question.max_changes, watch));
    };
    /// What the slot alone tells, more every time.
    const auto ask_slot = [&] {
        if (looks_at_slot == most_looks_at_slot) return;
        const double cells = std::ldexp(least_slot_cells, 2 * looks_at_slot);
        if (looks_at_slot++ == 0) {
            // Where a narrow road or boxes make it hard, it tells nothing.
            if (2 * question.slot->lower(bounds.lower, cells, watch) < bounds.lower) {
                looks_at_slot = most_looks_at_slot;
                return;
            }
            const int most = bounds.upper.value_or(question.max_changes + 1) - 1;
            const std::vector<Path> from_mouth = question.slot->from_mouth(most, watch);
            if (!from_mouth.empty()) take_from_elsewhere(from_start(question.place, from_mouth, most, watch));
        }
        const int most = bounds.upper.value_or(question.max_changes + 1) - 1;
        bounds.lower = std::max(bounds.lower, question.slot->lower(most, cells, watch));
    };
    // Outward by number and direction of the last move, and inward from the start, by direction of the last move when leaving.
    BothWays<Pairs> out, in;
    // Where it takes many changes, they are counted on finer lattices at once: that is cheap, as nothing needs to be kept.
    for (double h = h0; h > 0.999 * question.finest; h /= 2.0) {
        if (h < h0 && bounds.lower < many_changes) break;
        if (h < h0) ask_slot();
        if (bounds.meet() || bounds.lower > question.max_changes) break;
        std::optional<OuterLattice> finer;
        if (h < h0) finer.emplace(question.place, h, h0, nullptr, watch);
        const OuterLattice& here = finer ? *finer : lattice;
        Counted counted = count_from_below(here, question.max_changes, h == h0, watch);
        bounds.updates += here.take_updates();
        bounds.spacing = h;
        bounds.lower = std::max(bounds.lower, counted.changes);
        bounds.impossible = counted.impossible;
        if (bounds.impossible) bounds.lower = question.max_changes + 1;
        if (bounds.lower > question.max_changes) return;
        if (h == h0) out = std::move(counted.sets);
    }
    if (out.forward.empty()) out = next_moves(lattice, nullptr, nullptr, watch);
    bounds.spacing = h0;

    const auto left_with = [&](int changes) {
        if (!fit(lattice, changes)) throw TooLarge{};
        while (static_cast<int>(out.forward.size()) <= changes) {
            BothWays<Pairs> next = next_moves(lattice, &out.forward.back(), &out.backward.back(), watch);
            for (const Direction direction : both_directions)
                out.of(direction).push_back(std::move(next.of(direction).front()));
        }
        Left left;
        left.h = h0;
        const auto last = static_cast<std::size_t>(changes);
        for (const Direction direction : both_directions) left.moves.of(direction).resize(last + 1);
        for (const Direction at_last : both_directions) {
            if (!lattice.holds_start(out.of(at_last)[last], lattice.free(), at_last)) continue;
            // From the start; driving forward when leaving is driving backward when parking.
            std::vector<Pairs>& moves = in.of(at_last);
            Direction direction = at_last;
            for (std::size_t k = last + 1; k-- > 0; direction = other(direction)) {
                const std::size_t i = last - k;
                if (i == moves.size()) {
                    Pairs pairs;
                    lattice.sweep(pairs, lattice.free(), other(direction), watch, [&](Rows rows) {
                        if (i == 0) {
                            lattice.begin_at_start(rows, pairs, lattice.free(), other(direction));
                        } else {
                            lattice.turn(rows, pairs, lattice.free(), other(direction), moves.back());
                        }
                    });
                    moves.push_back(std::move(pairs));
                }
                const Limits reached = lattice.within(out.of(direction)[k], lattice.free(), direction, watch);
                left.moves.of(direction)[k] = lattice.within(moves[i], reached, other(direction), watch);
            }
        }
        left.hull_of_all = hull_of(left.moves);
        return left;
    };
    const auto try_way = [&](const Left& left) {
        std::vector<Path> way = any_way(question.place, h0, left, watch, bounds.updates);
        if (way.empty()) return false;
        const int changes = changes_of(way);
        if (!bounds.upper || changes < *bounds.upper || found_elsewhere) {
            bounds.upper = changes;
            bounds.way = std::move(way);
            found_elsewhere = false;
        }
        return true;
    };

    double found_at = h0;  ///< spacing of the lattice that has the way
    struct Kept {
        int changes;
        Left left;
    };
    std::vector<Kept> kept;
    const auto left_for = [&](int changes, double h) {
        std::optional<Left> left;
        for (Kept& one : kept) {
            if (one.changes != changes) continue;
            std::swap(one, kept.back());
            if (kept.back().left.h > 0.999 * h) left = std::move(kept.back().left);
            kept.pop_back();
            break;
        }
        if (!left) left = left_with(changes);
        while (left && left->h > 1.001 * h) left = refined(question.place, h0, std::move(*left), bounds.updates, watch);
        return left;
    };
    /// So that it need not be computed from the coarsest lattice on again.
    const auto keep = [&](int changes, Left left) {
        std::size_t bytes = bytes_of(left);
        for (const Kept& one : kept) bytes += bytes_of(one.left);
        if (bytes <= most_kept) kept.push_back({changes, std::move(left)});
    };
    const auto driven_at = [&](int changes, double h) {
        try {
            const std::optional<Left> left = left_for(changes, h);
            if (left) return way_to_drive(question.place, h0, *left, watch, bounds.updates);
        } catch (const TooLarge&) {
        }
        return std::vector<Path>{};
    };
    const auto finish = [&] {
        if (!question.roomiest || !bounds.upper) return;
        // What only just gets out of the slot is not what people would drive: sets may hold a better way.
        for (double h = h0; found_elsewhere && h > 1.9 * question.finest; h /= 2.0) {
            std::optional<Left> left;
            try {
                left = left_for(*bounds.upper, h);
            } catch (const TooLarge&) {
            }
            if (!left) break;
            found_at = h;
            found_elsewhere = !try_way(*left);
        }
        // A lattice that just holds a way may not hold one that keeps a distance, but the next one may.
        std::vector<Path> way;
        for (double h = found_at; way.empty() && h > 0.999 * std::min(question.finest, found_at) && h > 0.4 * found_at;
             h /= 2.0)
            way = driven_at(*bounds.upper, h);
        if (way.empty()) way = polished(question.place, bounds.way);
        if (changes_of(way) == *bounds.upper && is_drivable(question.place, way)) bounds.way = std::move(way);
        bounds.others.reserve(others_tried);
        const std::vector<Path>* best = &bounds.way;
        for (int more = 1; more <= others_tried && *bounds.upper + more <= question.max_changes; ++more) {
            std::vector<Path> other = driven_at(*bounds.upper + more, h0);
            if (other.empty() || changes_of(other) != *bounds.upper + more ||
                !worth_a_change(question.place, other, *best))
                continue;
            bounds.others.push_back(std::move(other));
            best = &bounds.others.back();
        }
    };
    try {
        const double finest = question.finest / std::ldexp(1.0, question.finer);
        for (double h = h0; h > 0.999 * finest && !bounds.meet(); h /= 2.0) {
            if (h < 0.999 * question.finest && bounds.updates > soon_done) break;
            // What is left for the lower bound at this spacing; each count that turns out impossible moves it up.
            std::optional<Left> left;
            while (!left && !bounds.meet() && bounds.lower <= question.max_changes) {
                left = left_for(bounds.lower, h);
                if (left) continue;
                ++bounds.lower;
                bounds.spacing = h;
            }
            if (!left) break;
            bounds.spacing = h;
            const bool is_found = try_way(*left);
            keep(bounds.lower, std::move(*left));
            if (is_found) {
                found_at = h;
                break;
            }
            if (!bounds.upper && h == h0) ask_map();
            // None found with as few as the lower bound: how many may it take?
            int changes = bounds.lower + 1;
            if ((!bounds.upper || found_elsewhere) && h > 0.3 * h0) {
                const OuterLattice all(question.place, h, h0, nullptr, watch);
                const int most = std::min(question.max_changes, bounds.lower + far_above);
                changes = std::max(
                    changes,
                    changes_along(question.place, h, h0, all.free(), most, watch, bounds.updates).value_or(most + 1));
            }
            const int most = std::min(
                {question.max_changes, changes + tried_above, bounds.upper.value_or(question.max_changes + 1) - 1});
            for (; changes <= most; ++changes) {
                std::optional<Left> more = left_for(changes, h);
                if (!more) continue;
                const bool one_is_found = try_way(*more);
                keep(changes, std::move(*more));
                if (!one_is_found) continue;
                found_at = h;
                break;
            }
            if (!bounds.meet()) ask_slot();
        }
    } catch (const TooLarge&) {
    }
    if (!bounds.upper && !bounds.impossible && !asked_map) ask_map();
    finish();
}

}  // namespace snug::detail::sets
