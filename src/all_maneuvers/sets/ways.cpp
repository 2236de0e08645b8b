#include "all_maneuvers/sets/ways.hpp"

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
            if (!has_no_cells(left_.moves.of(look.last).back())) look.found = looked_for(look.grown, look.last, watch);
        });
    }
    Found& found_by(Look& look) {
        if (!look.found) look.found = looked_for(look.grown, look.last, watch_);
        updates_ += look.found->lattice.updates;
        return *look.found;
    }
    /// Whether the car gets to the start along the lattice; and how, if that can be driven.
    bool gets_there(Look& look, std::vector<Path>& way) {
        if (has_no_cells(left_.moves.of(look.last).back())) return false;
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
        if (has_no_cells(left_.moves.of(last).back())) return std::nullopt;
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

constexpr double most_map_cells = 3e5;  ///< about 500 bytes each

}  // namespace

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

std::vector<Path> any_way(const ChartPlace& place, double h0, const Left& left, const Watch& watch,
                          std::size_t& updates) {
    return WaySearch(place, h0, left, watch, updates).any();
}

std::vector<Path> way_to_drive(const ChartPlace& place, double h0, const Left& left, const Watch& watch,
                               std::size_t& updates) {
    for (const ChartPlace& better : better_parked(place, left.h)) {
        std::vector<Path> way = WaySearch(better, h0, left, watch, updates).roomiest();
        if (!way.empty() && is_drivable(place, way)) return way;
    }
    return {};
}

bool worth_a_change(const ChartPlace& place, const std::vector<Path>& one, const std::vector<Path>& other) {
    constexpr double much = 0.8, much_distance = 0.05, much_heading = 0.02;  // of the length, [m] and [rad]
    const double before = distance_kept(place, other);
    if (before < much_distance && distance_kept(place, one) >= before + much_distance - 0.021) return true;
    const auto aslant = [&](const std::vector<Path>& way) {
        const double parked = -place.start.heading;  // the chart lies halfway
        return way.empty() ? 0.0 : std::abs(way.back().at(way.back().length).heading - parked);
    };
    return length_of(one) < much * length_of(other) || aslant(one) < aslant(other) - much_heading;
}

}  // namespace snug::detail::sets
