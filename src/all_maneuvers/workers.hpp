// Threads that compute the parts of something large. A browser's module has none.
#pragma once

#include <functional>
#include <memory>

#include "all_maneuvers/watch.hpp"

namespace snug::detail {

/// Of one search, on whose thread they are asked for work.
class Workers {
public:
    /// With the thread that asks; 0: all cores, as far as they are of use. Fewer if the system has no more.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Does every part from 0 to before `parts`, in any order and at the same time; the thread that asks does some, too, and is
    /// the only one that watches: `work` is told how to on whatever thread it is. What is thrown ends it. Within a part
    /// everything is done by the thread that does it.
    void share(int parts, const Watch& watch, const std::function<void(int part, const Watch& watch)>& work);

    /// Prepares steps 0 to before `steps` in any order and at the same time, and takes each in order once it is prepared.
    void share_in_order(int steps, const Watch& watch, const std::function<void(int step)>& prepare,
                        const std::function<void(int step)>& take);

private:
    struct Crew;
    std::unique_ptr<Crew> crew_;
};

/// None for one thread.
std::unique_ptr<Workers> workers_for(int threads);

/// The same; one after the other if there are no workers, or it is not worth their while.
template <class Work>
void in_parts(const Watch& watch, [[maybe_unused]] bool worth_while, int parts, const Work& work) {
#ifndef __EMSCRIPTEN__
    if (worth_while && watch.workers() && parts > 1) return watch.workers()->share(parts, watch, work);
#endif
    for (int part = 0; part < parts; ++part) {
        watch();
        work(part, watch);
    }
}

template <class Prepare, class Take>
void in_order(const Watch& watch, [[maybe_unused]] bool worth_while, int steps, const Prepare& prepare,
              const Take& take) {
#ifndef __EMSCRIPTEN__
    if (worth_while && watch.workers() && steps > 1)
        return watch.workers()->share_in_order(steps, watch, prepare, take);
#endif
    for (int step = 0; step < steps; ++step) {
        watch();
        prepare(step);
        take(step);
    }
}

}  // namespace snug::detail
