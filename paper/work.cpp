#include "paper/work.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <mutex>

#include "sweep/cores.hpp"

namespace snug::paper {

void Work::stage(double ends) {
    from_ = to_;
    to_ = ends;
    tell(0.0);
}

void Work::tell(double part_of_stage) {
    if (options_.progress && !options_.progress(from_ + (to_ - from_) * part_of_stage)) throw GivenUp();
}

std::function<bool(double)> Work::teller() {
    if (!options_.progress) return {};
    return [this](double part) { return options_.progress(from_ + (to_ - from_) * part); };
}

void Work::each(std::size_t tasks, const std::function<void(std::size_t)>& task) {
    std::mutex mutex;
    std::size_t finished = 0;
    tbb::task_group_context context;  // of its own: GivenUp stops this loop alone
    const auto one = [&](std::size_t i) {
        task(i);
        const std::lock_guard lock(mutex);
        tell(static_cast<double>(++finished) / static_cast<double>(tasks));
    };
    tbb::task_arena arena(threads_at_once(options_.threads));
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, tasks, one, tbb::simple_partitioner{}, context); });
}

}  // namespace snug::paper
