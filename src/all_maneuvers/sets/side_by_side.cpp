#include "all_maneuvers/sets/side_by_side.hpp"

#ifndef __EMSCRIPTEN__
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#endif

namespace snug::detail::sets {

namespace {

void one_after_the_other(const Watching& watch, const std::function<void(int part, const Watching&)>& act) {
    act(0, watch);
    act(1, watch);
}

}  // namespace

#ifdef __EMSCRIPTEN__

void side_by_side(bool, const Watching& watch, const std::function<void(int part, const Watching&)>& act) {
    one_after_the_other(watch, act);
}

#else

void side_by_side(bool may, const Watching& watch, const std::function<void(int part, const Watching&)>& act) {
    if (!may) return one_after_the_other(watch, act);
    struct GivenUp {};
    std::atomic<bool> given_up{false};
    std::exception_ptr trouble;
    std::thread other;
    try {
        other = std::thread([&] {
            try {
                act(1, [&] {
                    if (given_up) throw GivenUp{};
                });
            } catch (...) {
                trouble = std::current_exception();
            }
        });
    } catch (const std::system_error&) {  // there are no more threads
        return one_after_the_other(watch, act);
    }
    try {
        act(0, watch);
    } catch (...) {
        given_up = true;
        other.join();
        throw;
    }
    other.join();
    if (trouble) std::rethrow_exception(trouble);
}

#endif

}  // namespace snug::detail::sets
