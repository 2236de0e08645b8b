// How long each question takes, and how many times as long stepping takes for the same answer.
//
// Names are <question>/<strategy>/<case>. After the run, a table on stderr compares the strategies of each question and
// case with the first one measured, all from this run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "snug/snug.hpp"

namespace snug {

void add_atlases();  // atlas_bench.cpp
void add_batches();  // batch_bench.cpp

namespace {

struct Case {
    std::string name;
    Car car;
    Slot slot;
    double heading;  ///< parks with the fewest changes, whatever the strategy [rad]
};

/// The two slots the paper compares itself on, and one that takes a single change.
std::vector<Case> cases() {
    const Car zoe = find_car("renault-zoe").value();
    const Car mid_size = find_car("mid-size").value();
    return {{"renault-zoe-4.5x2.0", zoe, Slot({.length = 4.5, .width = 2.0}), 0.486},
            {"mid-size-5.1x2.2", mid_size, Slot({.length = 5.1, .width = 2.2}), 0.4625},
            {"renault-zoe-5.2x2.0", zoe, Slot({.length = 5.2, .width = 2.0}), 0.42}};
}

struct NamedStrategy {
    std::string name;
    std::optional<Stepping> steps;  ///< of Algorithm 1; none: the solver
};

const std::vector<NamedStrategy> strategies = {
    {"max-steer", {}}, {"stepping-1mm", Stepping{.step = 1e-3}}, {"stepping-0.1mm", Stepping{.step = 1e-4}}};

/// Problem 1: all ranges and the best maneuver. Stepping samples headings 1e-4 rad apart.
void entry_of(benchmark::State& state, const Case& c, const std::optional<Stepping>& steps, bool prove = false) {
    EntryOptions options;
    options.prove = prove;
    Answer answer;
    for (auto _ : state) {
        answer = steps ? entry(c.car, c.slot, options, *steps) : entry(c.car, c.slot, options);
        benchmark::DoNotOptimize(answer);
    }
    state.counters["changes"] = answer.direction_changes.value_or(-1);
    state.counters["ranges"] = static_cast<double>(answer.ranges.size());
}

/// Ordinary slots of the paper's cars, 0.3 to 1.8 m longer and 0.02 to 0.8 m wider than the car: the time told is the median of
/// them, each the least of three.
void entry_of_random_slots(benchmark::State& state) {
    const std::vector<Car> cars = catalogue();
    std::mt19937_64 bits(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    };
    std::vector<std::pair<const Car*, Slot>> asked;
    while (asked.size() < 200) {
        const Car& car = cars[bits() % cars.size()];
        const double length = car.length() + between(0.3, 1.8);
        asked.emplace_back(&car, Slot({.length = length, .width = car.width() + between(0.02, 0.8)}));
    }
    for (auto _ : state) {
        std::vector<double> seconds;
        for (const auto& [car, slot] : asked) {
            double least = 1e9;
            for (int i = 0; i < 3; ++i) {
                const auto begin = std::chrono::steady_clock::now();
                benchmark::DoNotOptimize(entry(*car, slot));
                least =
                    std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            }
            seconds.push_back(least);
        }
        std::nth_element(seconds.begin(), seconds.begin() + 100, seconds.end());
        state.SetIterationTime(seconds[100]);
    }
}

/// One heading driven until parked: an item is a move,
void run_exactly(benchmark::State& state, const Case& c) {
    std::size_t moves = 0;
    for (auto _ : state) {
        const MaxSteerRun run = max_steer(c.car, c.slot, c.heading);
        moves += run.maneuver.moves.size();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(moves));
}

/// or an Euler step.
void run_stepping(benchmark::State& state, const Case& c, const Stepping& steps) {
    double length = 0.0;
    for (auto _ : state) {
        length += stepping(c.car, c.slot, c.heading, steps).maneuver.length();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(length / steps.step));
}

/// The first contact of one move, from each direction change of a maneuver in turn.
void move_of(benchmark::State& state, const Case& c) {
    const std::vector<Move> moves = max_steer(c.car, c.slot, c.heading).maneuver.moves;
    std::size_t i = 0;
    for (auto _ : state) {
        const Move& move = moves[i];
        benchmark::DoNotOptimize(first_contact(c.car, c.slot, move.start, move.direction, move.steering_angle));
        i = i + 1 == moves.size() ? 0 : i + 1;
    }
}

template <typename Measured>
void add(const std::string& question, const std::string& strategy, const Case& c, Measured measured) {
    benchmark::RegisterBenchmark((question + "/" + strategy + "/" + c.name).c_str(), std::move(measured))
        ->Unit(benchmark::kMicrosecond);
}

void add_all() {
    benchmark::RegisterBenchmark("entry/proved/median-of-random-slots", entry_of_random_slots)
        ->Unit(benchmark::kMicrosecond)
        ->UseManualTime()
        ->Iterations(1);
    for (const Case& c : cases()) {
        for (const NamedStrategy& s : strategies) {
            add("entry", s.name, c, [c, s](benchmark::State& state) { entry_of(state, c, s.steps); });
        }
        add("entry", "proved", c, [c](benchmark::State& state) { entry_of(state, c, {}, true); });
        add("run", "max-steer", c, [c](benchmark::State& state) { run_exactly(state, c); });
        add("run", "stepping-1mm", c, [c](benchmark::State& state) { run_stepping(state, c, {.step = 1e-3}); });
        add("move", "exact", c, [c](benchmark::State& state) { move_of(state, c); });
    }
}

/// Reports as usual, and remembers what the table needs.
class WithRatios : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context& context) override { return usual_->ReportContext(context); }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                measured_.push_back(
                    {run.run_name.function_name, run.real_accumulated_time / static_cast<double>(run.iterations)});
            }
        }
        usual_->ReportRuns(runs);
    }
    void Finalize() override {
        usual_->Finalize();
        print_ratios();
    }

private:
    struct Measured {
        std::string name;
        double seconds;

        [[nodiscard]] std::string strategy() const {
            return name.substr(name.find('/') + 1, name.rfind('/') - name.find('/') - 1);
        }
        [[nodiscard]] std::string question() const {
            return name.substr(0, name.find('/')) + " " + name.substr(name.rfind('/') + 1);
        }
    };

    void print_ratios() const {
        std::fflush(stdout);
        for (const Measured& one : measured_) {
            for (const Measured& first : measured_) {
                if (first.question() != one.question()) {
                    continue;
                }
                if (&first != &one) {
                    std::fprintf(stderr, "%-28s %-15s takes %10.1f times as long as %s\n", one.question().c_str(),
                                 one.strategy().c_str(), one.seconds / first.seconds, first.strategy().c_str());
                }
                break;
            }
        }
    }

    std::unique_ptr<BenchmarkReporter> usual_{benchmark::CreateDefaultDisplayReporter()};
    std::vector<Measured> measured_;
};

}  // namespace
}  // namespace snug

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 1;
    }
    snug::add_all();
    snug::add_batches();
    snug::add_atlases();
    snug::WithRatios reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
}
