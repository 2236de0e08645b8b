// One move at full steering, and a thousand headings side by side against one after the other.
//
// An item is a move, so that items per second are moves per second. `max-steer-batch` uses the widest vectors the
// processor has, `max-steer-batch-avx2` those of four.
#include <benchmark/benchmark.h>
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "contact/entering.hpp"
#include "full_steering/cases.hpp"
#include "snug/snug.hpp"

namespace snug {

void add_batches();

namespace {

using namespace detail;

constexpr int most_changes = 200;

/// Drives on until parked, stuck, or out of changes.
template <class AfterMove>
void drive(FullSteeringRun run, AfterMove after_move) {
    for (int n = 0; n <= most_changes; ++n) {
        const FullMove move = run.drive<false>();
        after_move();
        if (move.stuck || move.depth <= 0.0 || move.meets == Meets::nothing) break;
    }
}

/// A thousand headings spread over the possible ones.
struct Spread {
    Car car;
    Slot slot;
    FullSteering steering{entering_problem(car, slot, {})};
    std::vector<double> headings = {};
    std::int64_t moves = 0;

    Spread(const Car& with, const Slot& into) : car(with), slot(into) {
        const Headings possible = possible_headings(steering.problem).front();
        for (int i = 0; i < 1000; ++i) {
            headings.push_back(possible.min + (possible.max - possible.min) * (i + 0.5) / 1000.0);
            drive(FullSteeringRun(steering, headings.back()), [this] { ++moves; });
        }
    }
};

/// The car with its corners rounded by little enough that it drives nearly the same: an outline of 24 corners.
Car rounded(const Car& car) {
    const Outline outline = Outline::rounded(car.front(), car.rear(), car.width() / 2.0, 0.05, 0.05);
    return {outline, car.wheelbase(), car.max_steer(), car.name()};
}

void one_move(benchmark::State& state, const Spread& spread) {
    std::size_t i = 0;
    while (state.KeepRunningBatch(spread.moves)) {
        for (const double heading : spread.headings) drive(FullSteeringRun(spread.steering, heading), [&i] { ++i; });
    }
    benchmark::DoNotOptimize(i);
    state.SetItemsProcessed(static_cast<std::int64_t>(i));
}

void one_by_one(benchmark::State& state, const Spread& spread) {
    std::vector<int> changes(spread.headings.size());
    for (auto _ : state) {
        for (std::size_t i = 0; i < changes.size(); ++i)
            changes[i] = direction_changes_alone(spread.steering, spread.headings[i], most_changes);
        benchmark::DoNotOptimize(changes.data());
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * spread.moves);
}

void batch(benchmark::State& state, const Spread& spread, std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    for (auto _ : state) benchmark::DoNotOptimize(direction_changes(spread.car, spread.slot, spread.headings));
    hwy::SetSupportedTargetsForTest(0);
    state.SetItemsProcessed(state.iterations() * spread.moves);
}

void batch_of_slots(benchmark::State& state, const Spread& spread) {
    const std::vector<Slot> slots(spread.headings.size(), spread.slot);
    for (auto _ : state) benchmark::DoNotOptimize(direction_changes(spread.car, slots, spread.headings));
    state.SetItemsProcessed(state.iterations() * spread.moves);
}

}  // namespace

void add_batches() {
    const auto add = [](const std::string& name, auto measured) {
        benchmark::RegisterBenchmark(name.c_str(), std::move(measured))->Unit(benchmark::kMicrosecond);
    };
    const auto add_case = [&add](const std::string& name, const Spread& spread) {
        const std::string thousand = "/1000-headings-" + name;
        add("run/max-steer-batch" + thousand, [spread](benchmark::State& state) { batch(state, spread, 0); });
        if (const std::int64_t avx2 = hwy::SupportedTargets() & HWY_TARGETS & HWY_AVX2; avx2 != 0)
            add("run/max-steer-batch-avx2" + thousand,
                [spread, avx2](benchmark::State& state) { batch(state, spread, avx2); });
        add("run/max-steer-batch-of-slots" + thousand,
            [spread](benchmark::State& state) { batch_of_slots(state, spread); });
        add("run/max-steer-scalar" + thousand, [spread](benchmark::State& state) { one_by_one(state, spread); });
        add("move/full-steering/" + name, [spread](benchmark::State& state) { one_move(state, spread); });
        const Spread outlined(rounded(spread.car), spread.slot);
        add("move/full-steering-24-corners/" + name,
            [outlined](benchmark::State& state) { one_move(state, outlined); });
    };
    add_case("renault-zoe-4.5x2.0", Spread(find_car("renault-zoe").value(), Slot({.length = 4.5, .width = 2.0})));
    add_case("mid-size-5.1x2.2", Spread(find_car("mid-size").value(), Slot({.length = 5.1, .width = 2.2})));
}

}  // namespace snug
