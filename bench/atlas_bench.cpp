// A car asks its atlas: does it park, with how many changes, from where, and what is its first move?
//
// The atlas has ten million cells, made up, in a file of 1.2 GB that is written at first use and removed at the end; its
// pages are in memory, as after a while of use. Each question waits for the answer to the one before, so that the times
// are those of one alone. `hot` asks for the same 64 slots over and over, `random` anywhere. Beside the look-up stands
// what one would write without it: all cells in one sorted array, 64 bytes each, searched for width and then length.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "snug/atlas.hpp"
#include "snug/atlas_build.hpp"
#include "snug/car.hpp"

namespace snug {

void add_atlases();

namespace {

AtlasPlan plan() {
    AtlasPlan plan;
    plan.cars = catalogue();
    std::sort(plan.cars.begin(), plan.cars.end(), [](const Car& a, const Car& b) { return a.name() < b.name(); });
    for (int i = 0; i < 1000; ++i) plan.widths.push_back(1.5 + 0.001 * i);
    for (int i = 0; i < 2000; ++i) plan.lengths.push_back(4.0 + 0.001 * i);
    return plan;
}

std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 31)) * 0x9e3779b97f4a7c15U;
    return bits ^ (bits >> 29);
}

/// One to eight moves at full steering, and a range of headings.
CellAnswer made_up(std::uint64_t cell, const Car& car) {
    const std::uint64_t bits = mixed(cell + 1);
    CellAnswer answer;
    answer.direction_changes = static_cast<int>(bits % 8);
    answer.ranges.push_back({0.4, 0.41, *answer.direction_changes, 0});
    answer.entry = {-3.0, 0.5, 0.4};
    for (int i = 0; i <= *answer.direction_changes; ++i) {
        const bool backward = i % 2 == 0;
        answer.moves.push_back(
            {backward ? Direction::backward : Direction::forward, backward ? car.max_steer() : -car.max_steer(),
             0.1 + static_cast<double>(bits >> 40) * 1e-8, Contact{CarPart::rear_left_corner, Obstacle::rear_side}});
    }
    return answer;
}

class LargeAtlas {
public:
    LargeAtlas() {
        std::string pattern = std::filesystem::temp_directory_path() / "snug-bench-XXXXXX";
        if (mkdtemp(pattern.data()) == nullptr) throw std::filesystem::filesystem_error(pattern, {});
        folder_ = pattern;
        std::ofstream file(path(), std::ios::binary);
        const AtlasPlan what = plan();
        AtlasWriter writer(what, "bench", [&](std::string_view bytes) {
            file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        });
        std::uint64_t cell = 0;
        for (const Car& car : what.cars)
            for (std::size_t i = 0; i < what.widths.size() * what.lengths.size(); ++i) writer.add(made_up(cell++, car));
        writer.finish();
    }
    ~LargeAtlas() { std::filesystem::remove_all(folder_); }
    LargeAtlas(const LargeAtlas&) = delete;
    LargeAtlas& operator=(const LargeAtlas&) = delete;

    [[nodiscard]] std::string path() const { return folder_ / "large.atlas"; }

private:
    std::filesystem::path folder_;
};

const LargeAtlas& large_atlas() {
    static const LargeAtlas atlas;
    return atlas;
}

const Atlas& checked_atlas() {
    static const Atlas atlas = [] {
        Atlas opened(large_atlas().path());
        for (std::size_t block = 0; block < opened.blocks(); ++block)
            if (!opened.block_is_whole(block)) std::abort();
        return opened;
    }();
    return atlas;
}

/// The baseline's cell.
struct Row {
    std::uint32_t car;
    std::int32_t direction_changes;
    double width;
    double length;
    Pose entry;
    double first_length;
    double first_steering;
};

const std::vector<Row>& sorted_rows() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> all;
        const AtlasPlan what = plan();
        all.reserve(what.cars.size() * what.widths.size() * what.lengths.size());
        for (std::uint32_t car = 0; car < what.cars.size(); ++car)
            for (const double width : what.widths)
                for (const double length : what.lengths) {
                    const CellAnswer answer = made_up(all.size(), what.cars[car]);
                    const AtlasMove& first = answer.moves.front();
                    all.push_back({car, *answer.direction_changes, width, length, answer.entry,
                                   static_cast<double>(first.direction) * first.length, first.steering_angle});
                }
        return all;
    }();
    return rows;
}

struct Asked {
    std::size_t car;
    double length;
    double width;
};

/// Slots between grid points, spread over all cars.
Asked asked(std::uint64_t number) {
    const std::uint64_t bits = mixed(mixed(number + 1));
    return {static_cast<std::size_t>(bits % 5), 4.0 + 1.998 * static_cast<double>(bits >> 11 & 0xfffff) * 0x1p-20,
            1.5 + 0.998 * static_cast<double>(bits >> 40) * 0x1p-24};
}

int changes_in_atlas(const Atlas& atlas, const Asked& slot) {
    const AtlasAnswer answer = atlas.look_up(slot.car, slot.length, slot.width);
    benchmark::DoNotOptimize(answer.verdict);
    return *answer.cell.direction_changes();
}

/// And from which headings, from where, and with which first move.
int all_in_atlas(const Atlas& atlas, const Asked& slot) {
    const AtlasAnswer answer = atlas.look_up(slot.car, slot.length, slot.width);
    benchmark::DoNotOptimize(answer.cell.range(0));
    benchmark::DoNotOptimize(answer.cell.entry());
    benchmark::DoNotOptimize(answer.cell.move(0));
    return *answer.cell.direction_changes();
}

int all_in_rows(const std::vector<Row>& rows, const Asked& slot) {
    const auto upper = [&](double width, double length) {
        return std::upper_bound(rows.begin(), rows.end(), std::tuple(slot.car, width, length),
                                [](const auto& key, const Row& row) {
                                    return key < std::tuple(std::size_t{row.car}, row.width, row.length);
                                });
    };
    const double width = std::prev(upper(slot.width, 1e9))->width;
    const Row& row = *std::prev(upper(width, slot.length));
    benchmark::DoNotOptimize(row.entry);
    benchmark::DoNotOptimize(row.first_length);
    benchmark::DoNotOptimize(row.first_steering);
    return row.direction_changes;
}

template <class Changes>
void look_up(benchmark::State& state, std::uint64_t slots, const Changes& changes) {
    std::uint64_t number = 0;
    for (auto _ : state) {
        const int answer = changes(asked(number % slots));
        number += 1 + (answer > 1000 ? 1 : 0);  // never, but only the answer tells
    }
    benchmark::DoNotOptimize(number);
}

void open(benchmark::State& state) {
    const std::string path = large_atlas().path();
    for (auto _ : state) {
        const Atlas atlas(path);
        benchmark::DoNotOptimize(atlas.blocks());
    }
}

/// In a fresh mapping, so that its pages are first seen too.
void first_use(benchmark::State& state) {
    const auto open_fresh = [] { return Atlas(large_atlas().path()); };
    Atlas atlas = open_fresh();
    std::size_t used = 0;
    for (auto _ : state) {
        if (used == atlas.blocks()) {
            state.PauseTiming();
            atlas = open_fresh();
            used = 0;
            state.ResumeTiming();
        }
        benchmark::DoNotOptimize(atlas.block_is_whole(used * 8191 % atlas.blocks()));  // here and there
        ++used;
    }
    const auto file = static_cast<double>(std::filesystem::file_size(large_atlas().path()));
    state.counters["bytes"] = file / static_cast<double>(atlas.blocks());
}

}  // namespace

void add_atlases() {
    const auto add = [](const std::string& strategy, auto answer_from) {
        constexpr std::uint64_t any = 1ULL << 62;
        for (const auto& [name, slots] : {std::pair{"hot", std::uint64_t{64}}, {"random-of-10-million-cells", any}})
            benchmark::RegisterBenchmark(
                ("atlas/" + strategy + "/" + name).c_str(),
                [answer_from, slots = slots](benchmark::State& state) { look_up(state, slots, answer_from()); });
    };
    add("look-up",
        [] { return [&atlas = checked_atlas()](const Asked& slot) { return changes_in_atlas(atlas, slot); }; });
    add("look-up-and-first-move",
        [] { return [&atlas = checked_atlas()](const Asked& slot) { return all_in_atlas(atlas, slot); }; });
    add("sorted-array", [] { return [&rows = sorted_rows()](const Asked& slot) { return all_in_rows(rows, slot); }; });
    benchmark::RegisterBenchmark("atlas/open/10-million-cells", open)->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("atlas/first-use-of-a-block", first_use)->Unit(benchmark::kMicrosecond);
}

}  // namespace snug
