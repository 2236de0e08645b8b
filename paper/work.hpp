// Work on all cores, in stages of which the asker hears as one.
#pragma once

#include <cmath>
#include <cstddef>
#include <functional>

#include "paper/paper.hpp"

namespace snug::paper {

/// A point of a grid, without the digits that counting it out has left. [m]
inline double on_grid(double value) { return std::round(value * 1e9) / 1e9; }

/// The asker gave up. Never leaves regenerate().
struct GivenUp {};

class Work {
public:
    explicit Work(const Options& options) : options_(options) {}

    /// The stage that follows ends where that part of everything is done (0 to 1).
    void stage(double ends);
    /// Tells how far the stage is (0 to 1). Throws GivenUp when the asker does.
    void tell(double part_of_stage);
    /// The same for the library's own questions, which are told of giving up by false.
    [[nodiscard]] std::function<bool(double)> teller();
    /// Calls `task` for 0 to `tasks` - 1, from several threads. Throws GivenUp.
    void each(std::size_t tasks, const std::function<void(std::size_t)>& task);

    [[nodiscard]] const Options& options() const { return options_; }

private:
    const Options& options_;
    double from_ = 0.0;
    double to_ = 0.0;
};

}  // namespace snug::paper
