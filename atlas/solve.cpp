// One cell of an atlas, and all of them on all cores: batches come from a queue, are solved side by side and go back to it.
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>

#include "snug/atlas_database.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"
#include "sweep/cores.hpp"

namespace snug {

namespace {

/// A contact as it is stored: by the names of its parts.
std::optional<Contact> named(const std::optional<Contact>& contact) {
    return contact ? std::optional(Contact{contact->part, contact->obstacle}) : std::nullopt;
}

void keep(CellAnswer& answer, const std::optional<Maneuver>& maneuver) {
    if (!maneuver) return;
    answer.entry = maneuver->entry();
    for (const Move& move : maneuver->moves)
        answer.moves.push_back({move.direction, move.steering_angle, move.length, named(move.contact)});
}

std::optional<CellAnswer> solve_max_steer(const Car& car, const Slot& slot, const AtlasOptions& options,
                                          const std::function<bool()>& go_on) {
    EntryOptions asked;
    asked.prove = false;
    asked.max_changes = options.max_changes;
    asked.min_range = options.min_range;
    asked.driving.clearance = options.driving.clearance;
    asked.driving.enter = options.driving.enter;
    if (go_on) asked.progress = [&](double) { return go_on(); };
    Answer found = entry(car, slot, asked);
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
    asked.driving.clearance = options.driving.clearance;
    asked.driving.enter = options.driving.enter;
    bool given_up = false;
    if (go_on)
        asked.progress = [&](const FewestProgress&) {
            given_up = given_up || !go_on();
            return !given_up;
        };
    const Answer found = fewest(car, slot, asked);
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
    return options.strategy == Strategy::fewest ? solve_fewest(car, slot, options, go_on)
                                                : solve_max_steer(car, slot, options, go_on);
}

void solve_all(const AtlasPlan& plan, const CellQueue& queue, int threads, const std::function<bool()>& go_on) {
    std::mutex at_next;
    bool none_left = false;
    std::mutex at_store;
    std::atomic<bool> failed = false;
    const auto wanted = [&] { return !failed && (!go_on || go_on()); };
    // Each thread takes a batch, solves it and brings it back, until there is none: nobody waits for anybody else's cells.
    const auto solve_batches = [&](int) {
        try {
            while (wanted()) {
                SolvedBatch solved;
                {
                    const std::lock_guard lock(at_next);
                    if (!none_left) solved.cells = queue.next();
                    none_left = solved.cells.lengths.empty();
                }
                if (solved.cells.lengths.empty()) return;
                solved.answers.reserve(solved.cells.lengths.size());
                for (const double length : solved.cells.lengths) {
                    if (!wanted()) break;
                    std::optional<CellAnswer> answer =
                        solve(plan.cars[solved.cells.car], solved.cells.width, length, plan.options, wanted);
                    if (!answer) break;
                    solved.answers.push_back(std::move(*answer));
                }
                const std::lock_guard lock(at_store);
                if (!failed) queue.store(solved);
            }
        } catch (...) {
            failed = true;
            throw;
        }
    };
    tbb::task_arena arena(threads_at_once(threads));
    arena.execute([&] { tbb::parallel_for(0, arena.max_concurrency(), solve_batches, tbb::simple_partitioner{}); });
}

}  // namespace snug
