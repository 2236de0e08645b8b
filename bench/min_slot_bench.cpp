// How long the paper's figure of minimum dimensions takes: a Renault ZOE, 60 widths, 16 maximums of direction changes.
#include <benchmark/benchmark.h>

#include <vector>

#include "snug/car.hpp"
#include "snug/sweep.hpp"

namespace snug {
namespace {

std::vector<double> widths(const Car& car, int from, int to, int by) {
    std::vector<double> all;
    for (int i = from; i <= to; i += by) all.push_back(car.width() + 0.01 * i);
    return all;
}

const std::vector<int> counts = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 30, 40, 50, 100};

void figure(benchmark::State& state, int threads) {
    const Car car = find_car("renault-zoe").value();
    SweepOptions sweep;
    sweep.threads = threads;
    for (auto _ : state) benchmark::DoNotOptimize(min_slots(car, widths(car, 1, 60, 1), counts, {}, sweep));
}
BENCHMARK_CAPTURE(figure, one, 1)
    ->Name("min-slot/max-steer/renault-zoe-60-widths-1-thread")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(figure, two, 2)
    ->Name("min-slot/max-steer/renault-zoe-60-widths-2-threads")
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// One width, for the paper's loop needs minutes for them all.
void one_width(benchmark::State& state) {
    const Car car = find_car("renault-zoe").value();
    for (auto _ : state) benchmark::DoNotOptimize(min_slots(car, widths(car, 30, 30, 1), counts));
}
BENCHMARK(one_width)->Name("min-slot/max-steer/renault-zoe-one-width")->Unit(benchmark::kMillisecond);

void one_width_by_stepping(benchmark::State& state) {
    const Car car = find_car("renault-zoe").value();
    const double length_step = 0.01;
    for (auto _ : state)
        benchmark::DoNotOptimize(min_slots_by_stepping(car, widths(car, 30, 30, 1), counts, Stepping{}, length_step));
}
BENCHMARK(one_width_by_stepping)->Name("min-slot/stepping-1mm/renault-zoe-one-width")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace snug
