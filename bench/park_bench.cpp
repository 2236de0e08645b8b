// What parking from the street costs: until there is a maneuver, until it is proved, and the sweep of sets by the cell.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/workers.hpp"
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
            parallel("parallel-5.2x1.9-3.5", 5.2, 1.9, 3.5),
            parallel("parallel-5.2x2.0-2.5", 5.2, 2.0, 2.5),
            parallel("parallel-5.2x2.0-2.2", 5.2, 2.0, 2.2),
            perpendicular("perpendicular-2.5-6.0", 2.5, 6.0, Enter::backward),
            perpendicular("perpendicular-2.5-6.0-nose", 2.5, 6.0, Enter::forward),
            perpendicular("perpendicular-2.3-5.0", 2.3, 5.0, Enter::backward),
            perpendicular("perpendicular-2.3-5.0-nose", 2.3, 5.0, Enter::forward),
            perpendicular("perpendicular-2.3-4.0", 2.3, 4.0, Enter::backward),
            perpendicular("perpendicular-2.3-4.0-nose", 2.3, 4.0, Enter::forward),
            perpendicular("perpendicular-2.1-3.5-nose", 2.1, 3.5, Enter::forward),
            perpendicular("perpendicular-2.1-3.0-nose", 2.1, 3.0, Enter::forward)};
}

Case named(const std::string& name) {
    const std::vector<Case> all = cases();
    return *std::find_if(all.begin(), all.end(), [&](const Case& c) { return c.name == name; });
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

void proved(benchmark::State& state, const Case& c, int threads) {
    ParkOptions options;
    options.roomiest = false;
    options.threads = threads;
    ask(state, c, options);
}

void whole(benchmark::State& state, const Case& c) { ask(state, c, {}); }

/// One sweep of the lower bound over the whole lattice;
void sweep(benchmark::State& state, const Case& c, double spacing) {
    using namespace detail::sets;
    Chart chart;
    const ChartPlace place = chart_place(find_car("renault-zoe").value(), street_place(c.street), c.start, 0.0, chart);
    const OuterLattice lattice(place, spacing, spacing, nullptr, [] {});
    Pairs pairs;
    for (auto _ : state) {
        lattice.sweep(
            pairs, lattice.free(), Direction::forward, [] {},
            [&](Rows rows) { lattice.begin_at_start(rows, pairs, lattice.free(), Direction::forward); });
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(lattice.take_updates()));
}

/// A fine lattice: what is free is measured, and it is swept both ways with none, one and two changes.
void lattice(benchmark::State& state, const Case& c, double spacing, int threads) {
    using namespace detail::sets;
    Chart chart;
    const ChartPlace place = chart_place(find_car("renault-zoe").value(), street_place(c.street), c.start, 0.0, chart);
    const auto workers = detail::workers_for(threads);
    const detail::Watch watch([] {}, workers.get());
    for (auto _ : state) {
        const OuterLattice lattice(place, spacing, spacing, nullptr, watch);
        BothWays<Pairs> moves = next_moves(lattice, nullptr, nullptr, watch);
        for (int changes = 1; changes <= 2; ++changes)
            moves = next_moves(lattice, &moves.forward.back(), &moves.backward.back(), watch);
        benchmark::DoNotOptimize(moves);
    }
}

/// The map of a street, swept whole.
void map(benchmark::State& state, const Case& c, double spacing) {
    const Car car = find_car("renault-zoe").value();
    ParkMapOptions options;
    options.spacing = spacing;
    std::size_t bytes = 0;
    for (auto _ : state) bytes = ParkMap(car, c.street, options).bytes();
    state.counters["MB"] = 1e-6 * static_cast<double>(bytes);
}

/// Poses all over the street, one after the other.
std::vector<Pose> poses_of(const Case& c) {
    std::vector<Pose> poses;
    std::uint64_t state = 1;
    const auto next = [&] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 11) * 0x1p-53;
    };
    for (int i = 0; i < 4096; ++i)
        poses.push_back({-8.0 + 14.0 * next(), c.street.road.value_or(6.0) * next(), next() - 0.5});
    return poses;
}

void look_up(benchmark::State& state, const Case& c) {
    const ParkMap of(find_car("renault-zoe").value(), c.street);
    const std::vector<Pose> poses = poses_of(c);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(of.at(poses[i++ % poses.size()]));
}

void next_maneuver(benchmark::State& state, const Case& c) {
    const ParkMap of(find_car("renault-zoe").value(), c.street);
    std::vector<Pose> poses;
    for (const Pose& pose : poses_of(c))
        if (of.at(pose).first) poses.push_back(pose);
    if (poses.empty()) return state.SkipWithError("no maneuver is known from anywhere");
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(of.maneuver(poses[i++ % poses.size()]));
}

[[maybe_unused]] const bool added = [] {
    for (const Case& c : cases()) {
        benchmark::RegisterBenchmark(("park/first/" + c.name).c_str(), [c](benchmark::State& state) {
            first(state, c);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/proved/" + c.name).c_str(), [c](benchmark::State& state) {
            proved(state, c, 1);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/proved-on-two-threads/" + c.name).c_str(),
                                     [c](benchmark::State& state) { proved(state, c, 2); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
        benchmark::RegisterBenchmark(("park/whole/" + c.name).c_str(), [c](benchmark::State& state) {
            whole(state, c);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/map/" + c.name).c_str(), [c](benchmark::State& state) {
            map(state, c, 0.0);
        })->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("park/look-up/" + c.name).c_str(), [c](benchmark::State& state) {
            look_up(state, c);
        })->Unit(benchmark::kMicrosecond);
        benchmark::RegisterBenchmark(("park/next-maneuver/" + c.name).c_str(), [c](benchmark::State& state) {
            next_maneuver(state, c);
        })->Unit(benchmark::kMillisecond);
    }
    for (const std::string name : {"parallel-5.2x2.0-2.2", "perpendicular-2.3-4.0-nose"}) {
        for (const int threads : {1, 2}) {
            const std::string title = threads == 1 ? "park/lattice/" : "park/lattice-on-two-threads/";
            benchmark::RegisterBenchmark(
                (title + name + "/10mm").c_str(),
                [name, threads](benchmark::State& state) { lattice(state, named(name), 0.01, threads); })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
    benchmark::RegisterBenchmark("park/map/parallel-5.2x2.0-3.5/40mm", [](benchmark::State& state) {
        map(state, named("parallel-5.2x2.0-3.5"), 0.04);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("park/sweep/parallel-4.8x2.0-3.5/20mm", [](benchmark::State& state) {
        sweep(state, named("parallel-4.8x2.0-3.5"), 0.02);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("park/sweep/perpendicular-2.5-6.0/20mm", [](benchmark::State& state) {
        sweep(state, named("perpendicular-2.5-6.0"), 0.02);
    })->Unit(benchmark::kMillisecond);
    return true;
}();

}  // namespace
}  // namespace snug
