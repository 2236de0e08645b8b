// What all computations of one question share.
#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "all_maneuvers/numbers.hpp"

namespace snug::detail {

class Workers;

/// Something to be called as long as it is there: what std::function would copy.
template <class... Given>
class Call {
public:
    template <class Callee>
    Call(const Callee& callee)  // NOLINT(google-explicit-constructor)
        : callee_(&callee),
          call_([](const void* it, Given... given) { (*static_cast<const Callee*>(it))(given...); }) {}

    void operator()(Given... given) const { call_(callee_, given...); }

private:
    const void* callee_;
    void (*call_)(const void*, Given...);
};

struct GivenUp {};
/// Called, it looks whether time is up or the caller has had enough, and throws GivenUp if so.
class Watch {
public:
    /// Workers, if there are any, must outlive it.
    template <class Look, class = std::enable_if_t<std::is_invocable_v<Look&>>>
    Watch(Look look, Workers* workers = nullptr)  // NOLINT(google-explicit-constructor)
        : look_(std::move(look)), workers_(workers) {}

    void operator()() const { look_(); }
    /// The same with another look.
    template <class Look>
    [[nodiscard]] Watch with(Look look) const {
        Watch other = *this;
        other.look_ = std::move(look);
        return other;
    }
    /// The memory of the question.
    [[nodiscard]] const std::shared_ptr<NumberStore>& store() const { return store_; }
    /// Null where one thread does everything.
    [[nodiscard]] Workers* workers() const { return workers_; }

private:
    std::function<void()> look_;
    std::shared_ptr<NumberStore> store_ = new_store();
    Workers* workers_ = nullptr;
};

}  // namespace snug::detail
