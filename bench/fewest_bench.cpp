// What the fewest changes over all maneuvers cost: whole questions, and the inner loop beside a plain one over the
// same row.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "all_maneuvers/lattice.hpp"
#include "snug/snug.hpp"
#include "snug/sweep.hpp"

namespace snug {
namespace {

struct Case {
    std::string name;
    Car car;
    Slot slot;
};

std::vector<Case> cases() {
    const Car zoe = find_car("renault-zoe").value();
    const Car mid_size = find_car("mid-size").value();
    return {{"renault-zoe-4.5x2.0", zoe, Slot({.length = 4.5, .width = 2.0})},
            {"mid-size-5.1x2.2", mid_size, Slot({.length = 5.1, .width = 2.2})},
            {"renault-zoe-4.8x1.84", zoe, Slot({.length = 4.8, .width = 1.84})}};
}

void whole(benchmark::State& state, const Case& c) {
    Answer answer;
    for (auto _ : state) answer = fewest(c.car, c.slot);
    state.counters["changes"] = answer.direction_changes.value_or(-1);
    state.counters["proved"] = answer.proved;
}

/// The bounds alone, on lattices down to a given spacing; without looking for the roomiest maneuver.
void bounds(benchmark::State& state, const Case& c, double resolution) {
    FewestOptions options;
    options.resolution = resolution;
    options.roomiest = false;
    Answer answer;
    for (auto _ : state) answer = fewest(c.car, c.slot, options);
    state.counters["lower"] = answer.lower_bound;
    state.counters["upper"] = answer.direction_changes.value_or(-1);
    state.counters["spacing_mm"] = 1e3 * answer.spacing;
}

/// One row of cells, as often as it takes: an item is a cell.
struct Row {
    static constexpr std::size_t cells = 256;
    std::vector<double> row, left, right, keep, from_left, from_right, needed;

    Row() {
        const auto filled = [](double from, double by) {
            std::vector<double> numbers(cells + detail::row_padding);
            for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = from + by * static_cast<double>(i % 17);
            return numbers;
        };
        row = filled(0.0, 1e-3), left = filled(1e-3, 7e-4), right = filled(2e-3, 5e-4), keep = filled(0.0, 0.0);
        from_left = filled(1e-4, 1e-6), from_right = filled(-1e-4, 1e-6), needed = filled(-1.0, 1e-3);
    }
};

void in_vectors(benchmark::State& state) {
    Row r;
    for (auto _ : state) {
        detail::sweep_row(r.row.data(), r.left.data(), r.right.data(), r.keep.data(), r.from_left.data(),
                          r.from_right.data(), r.needed.data(), detail::Above::allowed, nullptr, Row::cells);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(Row::cells));
}

void plain(benchmark::State& state) {
    Row r;
    for (auto _ : state) {
        for (std::size_t i = 0; i < Row::cells; ++i) {
            const double highest =
                std::max({r.row[i] + r.keep[i], r.left[i] + r.from_left[i], r.right[i] + r.from_right[i]});
            r.row[i] = highest >= r.needed[i] ? highest : detail::Heights::nowhere;
        }
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(Row::cells));
}

void shortest_slots(benchmark::State& state) {
    const Car car = find_car("renault-zoe").value();
    std::vector<double> widths;
    for (int i = 1; i <= 30; ++i) widths.push_back(car.width() + 0.02 * i);
    MinSlotOptions options;
    options.strategy = Strategy::fewest;
    options.resolution = 2e-3;
    for (auto _ : state) benchmark::DoNotOptimize(min_slots(car, widths, {0, 1, 2, 3, 4, 5, 6, 8, 10, 20}, options));
}

/// What the outline and a neighbour set back change: the table of docs/fewest.md, with its bounds as counters.
std::vector<Case> outlines() {
    std::vector<Case> all;
    const auto add = [&](const char* name, double length, double width, double front, double rear, double setback) {
        const Car car = find_car(name).value();
        const Outline outline = Outline::rounded(car.front(), car.rear(), car.width() / 2.0, front, rear);
        const auto two = [](double metres) { return std::to_string(metres).substr(0, 4); };
        all.push_back(
            {std::string(name) + "+" + two(length) + "x" + two(width) + "/" +
                 (setback > 0.0 ? "front-setback-" + two(setback) : two(front) + "-" + two(rear)),
             Car(outline, car.wheelbase(), car.max_steer(), name),
             Slot({.length = car.length() + length, .width = car.width() + width, .front_setback = setback})});
    };
    for (const auto& [name, length, width] :
         {std::tuple{"renault-zoe", 0.5, 0.1}, std::tuple{"renault-zoe", 0.7, 0.2},
          std::tuple{"vw-transporter", 0.5, 0.2}, std::tuple{"mercedes-amg-gt", 0.5, 0.2}})
        for (const auto& [front, rear] : {std::pair{0.0, 0.0}, std::pair{0.15, 0.15}, std::pair{0.4, 0.25}})
            add(name, length, width, front, rear, 0.0);
    add("renault-zoe", 0.5, 0.1, 0.0, 0.0, 0.3);
    add("vw-transporter", 0.5, 0.2, 0.0, 0.0, 0.3);
    return all;
}

void outline(benchmark::State& state, const Case& c) {
    Answer answer;
    for (auto _ : state) answer = fewest(c.car, c.slot);
    state.counters["lower"] = answer.lower_bound;
    state.counters["changes"] = answer.direction_changes.value_or(-1);
    state.counters["spacing_mm"] = 1e3 * answer.spacing;
}

[[maybe_unused]] const bool added = [] {
    for (const Case& c : outlines())
        benchmark::RegisterBenchmark(("outline/fewest/" + c.name).c_str(),
                                     [c](benchmark::State& state) { outline(state, c); })
            ->Unit(benchmark::kMillisecond)
            ->Iterations(1);
    for (const Case& c : cases())
        benchmark::RegisterBenchmark(("entry/fewest/" + c.name).c_str(), [c](benchmark::State& state) {
            whole(state, c);
        })->Unit(benchmark::kMillisecond);
    for (const Case& c : cases()) {
        for (const auto& [name, resolution] : {std::pair{"4mm", 4e-3}, std::pair{"0.5mm", 5e-4}}) {
            benchmark::RegisterBenchmark(
                (std::string("bounds/fewest/") + name + "/" + c.name).c_str(),
                [c, spacing = resolution](benchmark::State& state) { bounds(state, c, spacing); })
                ->Unit(benchmark::kMillisecond);
        }
    }
    benchmark::RegisterBenchmark("sweep/vectors/256-cells", in_vectors);
    benchmark::RegisterBenchmark("sweep/plain/256-cells", plain);
    benchmark::RegisterBenchmark("min-slot/fewest/renault-zoe-30-widths", shortest_slots)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->Iterations(1);
    return true;
}();

}  // namespace
}  // namespace snug
