#include "all_maneuvers/sets/park_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "all_maneuvers/sets/few_pieces.hpp"
#include "all_maneuvers/sets/inner_sets.hpp"
#include "all_maneuvers/sets/map_sets.hpp"
#include "all_maneuvers/sets/route.hpp"
#include "all_maneuvers/workers.hpp"
#include "model/angles.hpp"
#include "model/polygon.hpp"

namespace snug::detail::sets {

namespace {

std::size_t bytes_of(const Layer& layer) { return (layer.low.size() + layer.high.size()) * sizeof(Micro); }
std::size_t bytes_of(const Limits& limits) {
    std::size_t bytes = 0;
    for (const Layer& layer : limits) bytes += bytes_of(layer);
    return bytes;
}

bool holds_nothing(const Limits& limits) {
    return std::all_of(limits.begin(), limits.end(), [](const Layer& layer) { return layer.spans.cells == 0; });
}

/// More memory would be needed than anybody expects; what is known by then stands.
struct TooLarge {};
constexpr std::size_t most_bytes = 260'000'000;  ///< of sets, while they are computed

/// Whether the sets of so many changes, both ways, can be held several times over.
bool fit(const OuterLattice& lattice, int changes) {
    return bytes_of(lattice.free()) * 6 * static_cast<std::size_t>(changes + 1) <= most_bytes;
}

/// With how many changes the sets around the parked poses reach the start: no maneuver has fewer.
struct Counted {
    int changes = 0;          ///< more than `most` when they do not
    bool impossible = false;  ///< they never will
    BothWays<Pairs> sets;     ///< with none, with one, and so on, if they are to be kept and fit
};
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

/// What is left of a lattice when only maneuvers with so many changes count: where the car can be in every move of leaving.
struct Left {
    double h = 0.0;
    BothWays<Limits> moves;
    Layer hull_of_all;
};

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

/// From what is left of the lattice twice as coarse to what is left of this one; nothing when the start is out of reach.
/// Throws TooLarge when it is not, but what is left cannot be kept.
std::optional<Left> refined(const ParkQuestion& question, Left left, ParkBounds& bounds, const Watch& watch) {
    const double h = left.h / 2.0;
    const std::size_t moves = left.moves.forward.size();
    // Each cell has four children. What is free in them, and two moves each way, are held beside what is kept.
    if (4 * bytes_of(left.hull_of_all) > most_bytes / 2) throw TooLarge{};
    const OuterLattice lattice(question.place, h, question.coarsest, &left.hull_of_all, watch);
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
    bounds.updates += lattice.take_updates();
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
    bounds.updates += lattice.take_updates();
    left.h = h;
    left.hull_of_all = hull_of(limits);
    return left;
}

/// The place for a car that is larger by so much on every side.
ChartPlace with_grown_car(const ChartPlace& place, double by) {
    ChartPlace grown = place;
    for (std::vector<Point>& shape : grown.shapes) shape = grown_polygon(shape, by);
    return grown;
}

/// The part of the region that is so far around two places.
ChartPlace near_both(const ChartPlace& place, const Pose& one, const Pose& other, double out) {
    ChartPlace part = place;
    part.region.push_back({{1.0, 0.0}, std::max(one.x, other.x) + out});
    part.region.push_back({{-1.0, 0.0}, out - std::min(one.x, other.x)});
    part.region.push_back({{0.0, 1.0}, std::max(one.y, other.y) + out});
    part.region.push_back({{0.0, -1.0}, out - std::min(one.y, other.y)});
    return part;
}

/// Looks for ways with as many changes as the moves that are left allow.
class WaySearch {
public:
    WaySearch(const ChartPlace& place, double h0, const Left& left, const Watch& watch, std::size_t& updates)
        : place_(place), h0_(h0), left_(left), watch_(watch), updates_(updates) {}

    /// Any that can be driven; empty if none is found.
    std::vector<Path> any() {
        Look looks[] = {{0.0, both_directions[0]}, {0.0, both_directions[1]}};
        look_ahead(looks);
        for (Look& look : looks) {
            // What is met between nodes shrinks for a car that is a little larger.
            Look larger[4];
            for (std::size_t i = 0; i < 4; ++i) larger[i] = {left_.h / parts[i], look.last};
            std::vector<Path> way;
            bool gets_through = gets_there(look, way);
            for (std::size_t i = 0; i < 4 && gets_through && way.empty(); ++i) {
                if (i % 2 == 0) look_ahead({larger + i, 2});
                gets_through = gets_there(larger[i], way);
            }
            if (!way.empty()) return way;
        }
        return {};
    }

    /// One that keeps a distance, if it can be had half that of the largest car that gets through, and that is short. Empty if
    /// none is found.
    std::vector<Path> roomiest() {
        std::optional<Found> best;
        double too_large = largest;
        for (double by = smallest; by < largest; by *= 3.0) {
            std::optional<Found> found = find_either(by);
            if (!found) {
                too_large = by;
                break;
            }
            best = std::move(found);
        }
        for (int i = 0; best && i < 3; ++i) {
            const double middle = (best->grown + too_large) / 2.0;
            std::optional<Found> found = find(middle, best->chain.last);
            if (found) {
                best = std::move(found);
            } else {
                too_large = middle;
            }
        }
        if (!best) return {};
        std::vector<Path> way = driven_well(*best);
        if (way.empty()) return way;
        std::vector<Path> other = shortest(best->grown / 2.0, way.back().at(way.back().length));
        return other.empty() || trouble(other, place_.radius) >= trouble(way, place_.radius) ? way : other;
    }

    /// One within as small a part of the region around the start and a goal as will do; empty if none is found.
    std::vector<Path> shortest(double grown, const Pose& goal) {
        const ChartPlace whole = place_;
        const double all = std::max(whole.x_max - whole.x_min, whole.y_max - whole.y_min);
        std::optional<Found> best;
        double too_small = 0.0, enough = all;
        for (int i = 0; i < 6; ++i) {
            const double out = i == 0 ? all / 2.0 : (too_small + enough) / 2.0;
            place_ = near_both(whole, whole.start, goal, out);
            std::optional<Found> found = find_either(grown);
            (found ? enough : too_small) = out;
            if (found) best = std::move(found);
        }
        place_ = whole;
        return best ? driven_well(*best) : std::vector<Path>{};
    }

private:
    static constexpr double parts[] = {32.0, 8.0, 4.0, 2.0};  ///< of the spacing, by which the car is made larger
    static constexpr double smallest = 0.003, largest = 0.2;  ///< by which the car is grown [m]
    static constexpr double worth_of_distance = 25.0;         ///< of length, per metre of distance kept

    struct Found {
        double grown = 0.0;
        InnerLattice lattice;
        InnerChain chain;
        bool gets_through = false;
    };

    /// Lattices that are likely to be asked for.
    struct Look {
        double grown = 0.0;
        Direction last = Direction::forward;
        std::optional<Found> found = {};
    };
    /// Computes them at the same time if there are workers; else they are computed when they are asked for.
    void look_ahead(std::span<Look> looks) {
        if (!watch_.workers()) return;
        in_parts(watch_, true, static_cast<int>(looks.size()), [&](int i, const Watch& watch) {
            Look& look = looks[static_cast<std::size_t>(i)];
            if (!holds_nothing(left_.moves.of(look.last).back())) look.found = looked_for(look.grown, look.last, watch);
        });
    }
    Found& found_by(Look& look) {
        if (!look.found) look.found = looked_for(look.grown, look.last, watch_);
        updates_ += look.found->lattice.updates;
        return *look.found;
    }
    /// Whether the car gets to the start along the lattice; and how, if that can be driven.
    bool gets_there(Look& look, std::vector<Path>& way) {
        if (holds_nothing(left_.moves.of(look.last).back())) return false;
        const Found& found = found_by(look);
        const bool gets_through = found.gets_through;
        if (gets_through) way = drivable(found);
        look.found.reset();
        return gets_through;
    }

    std::optional<Found> find_either(double grown) {
        for (const Direction last : both_directions)
            if (std::optional<Found> found = find(grown, last)) return found;
        return std::nullopt;
    }

    std::optional<Found> find(double grown, Direction last) {
        if (holds_nothing(left_.moves.of(last).back())) return std::nullopt;
        Look look{grown, last};
        if (!found_by(look).gets_through) return std::nullopt;
        return std::move(look.found);
    }

    Found looked_for(double grown, Direction last, const Watch& watch) const {
        const ChartPlace place = with_grown_car(place_, grown);
        Found found{grown, InnerLattice(place, left_.h, h0_, left_.hull_of_all, watch), {}, false};
        const std::size_t moves = left_.moves.forward.size();
        found.chain.last = last;
        found.chain.parked = found.lattice.parked();
        found.chain.reaches.resize(moves);  // so that directions can be told
        for (std::size_t k = 0; k < moves; ++k) {
            const Direction direction = found.chain.direction(k);
            found.chain.reaches[k] =
                found.lattice.sweep(found.chain.begins(k), left_.moves.of(direction)[k], direction, watch);
        }
        found.gets_through = found.lattice.holds_start(found.chain.reaches.back());
        return found;
    }

    /// Few pieces; empty if the steps along the lattice meet something.
    std::vector<Path> drivable(const Found& found) {
        const std::vector<Path> steps = way_by_steps(found.lattice, found.chain, place_);
        if (!is_drivable(place_, steps)) return {};
        return with_few_pieces(place_, steps);
    }

    /// The same polished: of several distances that the steps along the lattice keep the one at which that gives the least
    /// trouble, where distance makes up for some.
    std::vector<Path> driven_well(const Found& found) {
        const std::vector<Path> steps = way_by_steps(found.lattice, found.chain, place_);
        if (!is_drivable(place_, steps)) return {};
        std::vector<Path> best;
        double least = std::numeric_limits<double>::infinity();
        for (const double part : {1.0, 0.5, 0.25, 0.0}) {
            const double keeps = part * found.grown;
            const ChartPlace wary = with_grown_car(place_, keeps);
            if (!is_drivable(wary, steps)) continue;
            std::vector<Path> way = polished(wary, with_few_pieces(wary, steps));
            const double minds = trouble(way, place_.radius) - worth_of_distance * keeps;
            if (minds < least && is_drivable(place_, way)) {
                least = minds;
                best = std::move(way);
            }
        }
        return best;
    }

    ChartPlace place_;
    double h0_;
    const Left& left_;
    const Watch& watch_;
    std::size_t& updates_;
};

/// The fewest changes along the lattice of upper bounds, up to `most`, whatever is met between its nodes.
std::optional<int> changes_along(const ChartPlace& place, double h, double h0, const Limits& limits, int most,
                                 const Watch& watch, std::size_t& updates) {
    const Layer cells = hull({&limits});
    InnerLattice lattice(place, h, h0, cells, watch);
    BothWays<InnerSet> now;
    std::optional<int> changes;
    for (int k = 0; k <= most && !changes; ++k) {
        BothWays<InnerSet> next;
        for (const Direction direction : both_directions) {
            const InnerSet& begin = k == 0 ? lattice.parked() : now.of(other(direction)).front();
            next.of(direction).push_back(lattice.sweep(begin, limits, direction, watch));
            if (lattice.holds_start(next.of(direction).front())) changes = k;
        }
        now = std::move(next);
    }
    updates += lattice.updates;
    return changes;
}

constexpr double most_map_cells = 3e5;  ///< about 500 bytes each

/// The way that a map of the place has from the start (map_sets.hpp): seldom the one with the fewest changes, but a map has one
/// where the arcs between the nodes of as coarse a lattice of sets meet something. Empty if it has none with at most so many.
std::vector<Path> way_on_map(const ChartPlace& place, double h, int most, const Watch& watch) {
    const double cells = (place.x_max - place.x_min) * 2.0 * place.radius / (h * h);
    if (cells > most_map_cells) return {};
    InnerMap map(place, h, watch);
    std::optional<Joining> joining;
    while (!joining && map.most() < most && map.sweep_on(watch)) {
        map.settle();
        joining = map.joining(place.start);
    }
    if (!joining) return {};
    std::vector<Path> steps;
    map.way(place.start, *joining, steps);
    if (!is_drivable(place, steps)) return {};
    return with_few_pieces(place, steps);
}

constexpr int most_looks_at_slot = 3;     ///< each on lattices of four times as many cells as the one before,
constexpr double least_slot_cells = 1e6;  ///< 16 bytes each
constexpr int tried_above = 2;            ///< counts above the lower bound for which a lattice looks for a way
constexpr int far_above = 40;             ///< and how far the coarse ones look for where to begin
constexpr int many_changes = 20;          ///< from so many on finer lattices count first
constexpr std::size_t soon_done =
    400'000'000;  ///< cells computed: with more, halving the finest spacing again would take minutes

/// Places that want the car parked better: close to the parked heading, and well inside; the last is as asked.
std::vector<ChartPlace> better_parked(const ChartPlace& place, double h) {
    std::vector<ChartPlace> places;
    const double middle = (std::max(place.parked_from, -1.0) + std::min(place.parked_to, 1.0)) / 2.0;
    const double heading = place.start.heading * -1.0;  // the chart lies halfway
    const double sine = angles::sin(heading), cosine = angles::cos(heading);
    const double close = 0.6 * h / (2.0 * place.radius);
    const bool has_middle = sine - close >= place.parked_from && sine + close <= place.parked_to;
    for (const double inside : {0.7, 0.3, 0.0}) {
        ChartPlace better = place;
        better.parked_from = std::max(place.parked_from, (has_middle ? sine : middle) - close);
        better.parked_to = std::min(place.parked_to, (has_middle ? sine : middle) + close);
        for (ParkedLimit& limit : better.parked) {
            if (limit.of != ParkedLimit::whole_car) continue;
            // Half of what the opposite side leaves when the car stands at the parked heading.
            double slack = std::numeric_limits<double>::infinity();
            for (const ParkedLimit& opposite : place.parked) {
                const Point &n = limit.within.normal, &m = opposite.within.normal;
                if (opposite.of != ParkedLimit::whole_car || n.x * m.x + n.y * m.y > -0.999999) continue;
                double least = std::numeric_limits<double>::infinity(), most = -least;
                for (const Point& p : place.frame) {
                    const double at = n.x * (p.x * cosine - p.y * sine) + n.y * (p.x * sine + p.y * cosine);
                    least = std::min(least, at);
                    most = std::max(most, at);
                }
                slack = std::min(slack, (limit.within.offset + opposite.within.offset - (most - least)) / 2.0);
            }
            if (slack > 0.0 && slack < std::numeric_limits<double>::infinity()) limit.within.offset -= inside * slack;
        }
        places.push_back(std::move(better));
    }
    places.push_back(place);
    return places;
}

/// Of the ways with as many changes as are left one that ends well and keeps a distance; empty if none is found.
std::vector<Path> way_to_drive(const ParkQuestion& question, const Left& left, const Watch& watch,
                               std::size_t& updates) {
    for (const ChartPlace& place : better_parked(question.place, left.h)) {
        std::vector<Path> way = WaySearch(place, question.coarsest, left, watch, updates).roomiest();
        if (!way.empty() && is_drivable(question.place, way)) return way;
    }
    return {};
}

constexpr int others_tried = 2;  ///< with more changes

double length_of(const std::vector<Path>& way) {
    double length = 0.0;
    for (const Path& piece : way) length += piece.length;
    return length;
}

/// The distance that is kept from everything all the way, as far as it matters. [m]
double distance_kept(const ChartPlace& place, const std::vector<Path>& way) {
    for (const double distance : {0.1, 0.05, 0.02})
        if (is_drivable(with_grown_car(place, distance), way)) return distance;
    return 0.0;
}

/// Whether a way with a change more saves a detour, keeps a distance or ends better: less aslant.
bool worth_a_change(const ParkQuestion& question, const std::vector<Path>& one, const std::vector<Path>& other) {
    constexpr double much = 0.8, much_distance = 0.05, much_heading = 0.02;  // of the length, [m] and [rad]
    const double before = distance_kept(question.place, other);
    if (before < much_distance && distance_kept(question.place, one) >= before + much_distance - 0.021) return true;
    const auto aslant = [&](const std::vector<Path>& way) {
        const double parked = -question.place.start.heading;  // the chart lies halfway
        return way.empty() ? 0.0 : std::abs(way.back().at(way.back().length).heading - parked);
    };
    return length_of(one) < much * length_of(other) || aslant(one) < aslant(other) - much_heading;
}

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
        std::vector<Path> way = WaySearch(question.place, h0, left, watch, bounds.updates).any();
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
        while (left && left->h > 1.001 * h) left = refined(question, std::move(*left), bounds, watch);
        return left;
    };
    /// So that it need not be computed from the coarsest lattice on again.
    const auto keep = [&](int changes, Left left) {
        std::size_t bytes = bytes_of(left);
        for (const Kept& one : kept) bytes += bytes_of(one.left);
        if (bytes <= most_bytes / 8) kept.push_back({changes, std::move(left)});
    };
    const auto driven_at = [&](int changes, double h) {
        try {
            const std::optional<Left> left = left_for(changes, h);
            if (left) return way_to_drive(question, *left, watch, bounds.updates);
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
            if (other.empty() || changes_of(other) != *bounds.upper + more || !worth_a_change(question, other, *best))
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
