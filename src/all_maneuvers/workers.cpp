#include "all_maneuvers/workers.hpp"

#ifdef __EMSCRIPTEN__

namespace snug::detail {

struct Workers::Crew {};
Workers::~Workers() = default;
std::unique_ptr<Workers> workers_for(int) { return nullptr; }

}  // namespace snug::detail

#else

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace snug::detail {

using Work = std::function<void(int, const Watch&)>;

namespace {

constexpr int most_of_use = 8;

/// Waits a while for what is likely to come sooner than a thread wakes up.
template <class Has>
void soon(const Has& has_come) {
    for (int i = 0; i < 200 && !has_come(); ++i) std::this_thread::yield();
}

}  // namespace

struct Workers::Crew {
    std::mutex mutex;
    std::condition_variable begin, end;
    const Work* work = nullptr;     ///< that is open to whoever has time
    const Watch* watch = nullptr;   ///< of the thread that asks
    std::atomic<unsigned> jobs{0};  ///< begun so far
    std::atomic<int> at_work{0};    ///< threads other than the one that asks
    int wanted = 1;                 ///< threads, with the one that asks
    bool over = false;
    bool shared = false;  ///< until all parts are done
    int parts = 0;
    std::atomic<int> next{0};
    std::atomic<bool> given_up{false};
    std::exception_ptr trouble;
    std::vector<std::thread> threads;

    /// Those that are wanted, once there is work for them.
    void come() {
        try {
            while (static_cast<int>(threads.size()) + 1 < wanted) threads.emplace_back([this] { stay(); });
        } catch (const std::system_error&) {
            wanted = static_cast<int>(threads.size()) + 1;
        }
    }

    void do_parts(const Work& what, const Watch& looks) {
        try {
            for (int part = next++; part < parts; part = next++) {
                looks();
                what(part, looks);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!given_up.exchange(true)) trouble = std::current_exception();
        }
    }

    void stay() {
        std::unique_lock lock(mutex);
        for (unsigned seen = 0;;) {
            lock.unlock();
            soon([&] { return jobs != seen; });
            lock.lock();
            begin.wait(lock, [&] { return over || (work && jobs != seen); });
            if (over) return;
            seen = jobs;
            const Work& what = *work;
            const Watch mine = watch->with([this] {
                if (given_up) throw GivenUp{};
            });
            ++at_work;
            lock.unlock();
            do_parts(what, mine);
            lock.lock();
            if (--at_work == 0) end.notify_one();
        }
    }
};

Workers::Workers(int threads) : crew_(std::make_unique<Crew>()) {
    if (threads == 0) threads = std::min(most_of_use, static_cast<int>(std::thread::hardware_concurrency()));
    crew_->wanted = std::max(threads, 1);
}

Workers::~Workers() {
    {
        const std::lock_guard lock(crew_->mutex);
        crew_->over = true;
    }
    crew_->begin.notify_all();
    for (std::thread& thread : crew_->threads) thread.join();
}

std::unique_ptr<Workers> workers_for(int threads) {
    return threads == 1 ? nullptr : std::make_unique<Workers>(threads);
}

void Workers::share(int parts, const Watch& watch, const Work& work) {
    Crew& crew = *crew_;
    if (!crew.shared) crew.come();
    if (crew.shared || crew.threads.empty()) {
        for (int part = 0; part < parts; ++part) {
            watch();
            work(part, watch);
        }
        return;
    }
    {
        const std::lock_guard lock(crew.mutex);
        crew.shared = true;
        crew.work = &work;
        crew.watch = &watch;
        crew.parts = parts;
        crew.next = 0;
        crew.given_up = false;
        crew.trouble = nullptr;
        ++crew.jobs;
    }
    crew.begin.notify_all();
    crew.do_parts(work, watch);
    std::unique_lock lock(crew.mutex);
    crew.work = nullptr;  // who has not begun comes too late
    lock.unlock();
    soon([&] { return crew.at_work == 0; });
    lock.lock();
    crew.end.wait(lock, [&] { return crew.at_work == 0; });
    crew.shared = false;
    if (crew.trouble) std::rethrow_exception(crew.trouble);
}

void Workers::share_in_order(int steps, const Watch& watch, const std::function<void(int)>& prepare,
                             const std::function<void(int)>& take) {
    std::vector<std::atomic<bool>> prepared(static_cast<std::size_t>(steps));
    std::atomic<int> next{0};
    std::atomic<bool> failed{false};
    const auto is_prepared = [&](int step) -> std::atomic<bool>& { return prepared[static_cast<std::size_t>(step)]; };
    const auto prepare_next = [&] {
        const int step = next++;
        if (step >= steps) return false;
        try {
            prepare(step);
        } catch (...) {
            failed = true;
            is_prepared(step) = true;
            is_prepared(step).notify_all();
            throw;
        }
        is_prepared(step) = true;
        is_prepared(step).notify_all();
        return true;
    };
    // One thread takes, and helps where nothing is to be taken yet; the others prepare.
    share(crew_->wanted, watch, [&](int part, const Watch& watched) {
        if (part > 0) {
            while (prepare_next()) watched();
            return;
        }
        for (int step = 0; step < steps; ++step) {
            watched();
            while (!is_prepared(step))
                if (!prepare_next()) is_prepared(step).wait(false);
            if (failed) return;  // what was thrown there ends it
            take(step);
        }
    });
}

}  // namespace snug::detail

#endif
