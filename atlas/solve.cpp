// One cell of an atlas, and all of them on all cores: batches come from a desk, are solved side by side and go back to it.
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <utility>

#include "cores.hpp"
#include "snug/atlas_database.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"

namespace snug {

namespace {

void keep(CellAnswer& answer, const std::optional<Maneuver>& maneuver) {
    if (!maneuver) return;
    answer.entry = maneuver->entry();
    for (const Move& move : maneuver->moves)
        answer.moves.push_back({move.direction, move.steering_angle, move.length, move.contact});
}

std::optional<CellAnswer> solve_max_steer(const Car& car, const Slot& slot, const AtlasOptions& options,
                                          const std::function<bool()>& go_on) {
    EntryOptions asked;
    asked.max_changes = options.max_changes;
    asked.min_range = options.min_range;
    asked.clearance = options.clearance;
    asked.enter = options.enter;
    if (go_on) asked.progress = [&](double) { return go_on(); };
    EntryAnswer found = entry(car, slot, asked);
    if (found.cancelled) return std::nullopt;
    CellAnswer answer;
    answer.direction_changes = found.direction_changes;
    answer.ranges = std::move(found.ranges);
    keep(answer, found.maneuver);
    return answer;
}

std::optional<CellAnswer> solve_fewest(const Car& car, const Slot& slot, const AtlasOptions& options,
                                       const std::function<bool()>& go_on) {
    FewestOptions asked;
    if (options.max_changes) asked.max_changes = *options.max_changes;
    asked.resolution = options.resolution;
    asked.clearance = options.clearance;
    asked.enter = options.enter;
    bool given_up = false;
    if (go_on)
        asked.progress = [&](const FewestProgress&) {
            given_up = given_up || !go_on();
            return !given_up;
        };
    const FewestAnswer found = fewest(car, slot, asked);
    if (given_up) return std::nullopt;  // what it had by then depends on the moment
    CellAnswer answer;
    answer.direction_changes = found.direction_changes;
    answer.lower_bound = found.lower_bound;
    answer.proved = found.proved;
    keep(answer, found.maneuver);
    return answer;
}

}  // namespace

std::optional<CellAnswer> solve(const Car& car, double width, double length, const AtlasOptions& options,
                                const std::function<bool()>& go_on) {
    const Slot slot({.length = length, .width = width});
    return options.strategy == AtlasStrategy::fewest ? solve_fewest(car, slot, options, go_on)
                                                     : solve_max_steer(car, slot, options, go_on);
}

void solve_all(const AtlasPlan& plan, const CellDesk& desk, int threads, const std::function<bool()>& go_on) {
    // oneTBB drops what is under way when an exception crosses it, without freeing it. So none does: the first one is kept, and
    // what is under way runs out.
    std::mutex mutex;
    std::exception_ptr failure;
    std::atomic<bool> failed = false;
    const auto guarded = [&](const auto& work) {
        try {
            work();
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure) failure = std::current_exception();
            failed = true;
        }
    };
    const auto wanted = [&] { return !failed && (!go_on || go_on()); };
    const auto next = [&](tbb::flow_control& flow) {
        CellBatch batch;
        guarded([&] {
            if (wanted()) batch = desk.next();
        });
        if (batch.lengths.empty()) flow.stop();
        return batch;
    };
    const auto solve_batch = [&](CellBatch batch) {
        SolvedBatch solved;
        guarded([&] {
            solved.answers.reserve(batch.lengths.size());
            for (const double length : batch.lengths) {
                if (!wanted()) break;
                std::optional<CellAnswer> answer =
                    solve(plan.cars[batch.car], batch.width, length, plan.options, wanted);
                if (!answer) break;
                solved.answers.push_back(std::move(*answer));
            }
        });
        solved.cells = std::move(batch);
        return solved;
    };
    const auto store = [&](const SolvedBatch& solved) {
        guarded([&] {
            if (!failed) desk.store(solved);
        });
    };
    tbb::task_arena arena(threads_at_once(threads));
    arena.execute([&] {
        const auto at_once =
            static_cast<std::size_t>(2 * arena.max_concurrency());  // nobody waits, and memory is bounded
        constexpr auto one_at_a_time = tbb::filter_mode::serial_out_of_order;
        tbb::parallel_pipeline(at_once,
                               tbb::make_filter<void, CellBatch>(one_at_a_time, next) &
                                   tbb::make_filter<CellBatch, SolvedBatch>(tbb::filter_mode::parallel, solve_batch) &
                                   tbb::make_filter<SolvedBatch, void>(one_at_a_time, store));
    });
    if (failure) std::rethrow_exception(failure);
}

}  // namespace snug
