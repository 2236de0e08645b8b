// What parking from the street costs: until there is a maneuver, until it is proved, and the sweep of sets by the cell.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "all_maneuvers/chart.hpp"
#include "all_maneuvers/outer_sets.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

struct Case {
    std::string name;
    Street street;
    Pose start;
};

std::vector<Case> cases() {
    const auto parallel = [](std::string name, double length, double width, double road) {
        Street street;
        street.length = length;
        street.width = width;
        street.road = road;
        return Case{std::move(name), street, {2.0, road / 2.0, 0.0}};
    };
    const auto perpendicular = [](std::string name, double width, double road, Enter enter) {
        Street street;
        street.length = 5.0;
        street.width = width;
        street.road = road;
        street.angle = 1.5707963267948966;
        street.enter = enter;
        return Case{std::move(name), street, standard_start(street, find_car("renault-zoe").value())};
    };
    return {parallel("parallel-6.0x2.0-3.5", 6.0, 2.0, 3.5),
            parallel("parallel-5.2x2.0-3.5", 5.2, 2.0, 3.5),
            parallel("parallel-4.8x2.0-3.5", 4.8, 2.0, 3.5),
            parallel("parallel-5.2x2.0-2.5", 5.2, 2.0, 2.5),
            perpendicular("perpendicular-2.5-6.0", 2.5, 6.0, Enter::backward),
            perpendicular("perpendicular-2.5-6.0-nose", 2.5, 6.0, Enter::forward),
            perpendicular("perpendicular-2.3-5.0-nose", 2.3, 5.0, Enter::forward),
            perpendicular("perpendicular-2.3-4.0", 2.3, 4.0, Enter::backward),
            perpendicular("perpendicular-2.1-3.0-nose", 2.1, 3.0, Enter::forward)};
}

void ask(benchmark::State& state, const Case& c, const ParkOptions& options) {
    const Car car = find_car("renault-zoe").value();
    const Place place = street_place(c.street);
    ParkAnswer answer;
    for (auto _ : state) answer = park(car, place, c.start, options);
    state.counters["lower"] = answer.lower_bound;
    state.counters["upper"] = answer.direction_changes.value_or(-1);
    state.counters["spacing_mm"] = 1e3 * answer.spacing;
}

/// Until some maneuver is found.
void first(benchmark::State& state, const Case& c) {
    ParkOptions options;
    options.roomiest = false;
    options.progress = [](const ParkProgress& progress) { return !progress.direction_changes; };
    ask(state, c, options);
}

void proved(benchmark::State& state, const Case& c) {
    ParkOptions options;
    options.roomiest = false;
    ask(state, c, options);
}

void whole(benchmark::State& state, const Case& c) { ask(state, c, {}); }

/// One sweep of the lower bound over the whole lattice; an item is a cell and predecessor.
void sweep(benchmark::State& state, const Case& c, double spacing) {
    using namespace detail::sets;
    Chart chart;
    const ChartPlace place = chart_place(find_car("renault-zoe").value(), street_place(c.street), c.start, 0.0, chart);
    const OuterLattice lattice(place, spacing, spacing, nullptr, [] {});
    const Pairs begin = lattice.begin_at_start(lattice.free(), Direction::forward);
    Pairs pairs;
    for (auto _ : state) {
        pairs = begin;
        lattice.sweep(pairs, lattice.free(), Direction::forward, [] {});
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(lattice.updates));
}

[[maybe_unused]] const bool added = [] {
    for (const Case& c : cases()) {
        benchmark::RegisterBenchmark(("park/first/" + c.name).c_str(), [c](benchmark::State& state) {
            first(state, c);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/proved/" + c.name).c_str(), [c](benchmark::State& state) {
            proved(state, c);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/whole/" + c.name).c_str(), [c](benchmark::State& state) {
            whole(state, c);
        })->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark("park/sweep/parallel-4.8x2.0-3.5/20mm", [](benchmark::State& state) {
        sweep(state, cases()[2], 0.02);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("park/sweep/perpendicular-2.5-6.0/20mm", [](benchmark::State& state) {
        sweep(state, cases()[4], 0.02);
    })->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace snug
