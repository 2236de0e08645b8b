// Assistants for a slot whose size is measured with errors: one for each size it may seem to have, made when it is first asked for.
#pragma once

#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "snug/assistant.hpp"
#include "snug/error.hpp"

namespace snug {

class Slots {
public:
    Slots(Car car, const Street& street, const AssistantOptions& options)
        : car_(std::move(car)), street_(street), options_(options) {}

    [[nodiscard]] const Street& street() const { return street_; }
    /// Seeming so much longer and wider than it is.
    [[nodiscard]] Street seeming(double longer, double wider) const {
        Street street = street_;
        street.length += longer;
        street.width += wider;
        return street;
    }
    /// To the nearest centimetre; nothing where the car and its margin have no room to be parked in such a slot. It is the same
    /// whoever asks first.
    const Assistant* seen(double longer, double wider) {
        constexpr double grid = 0.01;  // [m]
        const std::pair<long, long> key = {std::lround(longer / grid), std::lround(wider / grid)};
        const std::lock_guard lock(mutex_);
        const auto [at, added] = known_.try_emplace(key);
        if (added) {
            try {
                at->second.emplace(
                    car_, seeming(static_cast<double>(key.first) * grid, static_cast<double>(key.second) * grid),
                    options_);
            } catch (const Error&) {
                // What counts as parked has no room for such a margin.
            }
        }
        return at->second ? &*at->second : nullptr;
    }

private:
    Car car_;
    Street street_;
    AssistantOptions options_;
    std::mutex mutex_;
    std::map<std::pair<long, long>, std::optional<Assistant>> known_;
};

}  // namespace snug
