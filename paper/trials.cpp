#include "paper/trials.hpp"

#include <cmath>

#include "io/csv.hpp"
#include "snug/entry.hpp"

namespace snug::paper {

namespace {

constexpr double width_of_all = 2.0;  // [m]
constexpr double longest = 5.8;       // [m]

}  // namespace

std::vector<TrialsInSlot> trials_over_length(Work& work) {
    const Car zoe = find_car("renault-zoe").value();
    const double step = work.options().grids.length_step;
    std::vector<TrialsInSlot> all;
    // Down from 5.8 m, so that the lengths are round, to the car's own.
    for (int i = static_cast<int>(std::floor((longest - zoe.length()) / step)); i >= 0; --i)
        all.push_back({on_grid(longest - i * step), {}, {}});
    work.each(all.size(), [&](std::size_t i) {
        const Slot slot({.length = all[i].length, .width = width_of_all});
        all[i].trials = reversed_trials_by_goal(zoe, slot);
        all[i].max_steer = entry(zoe, slot, {.prove = false}).direction_changes;
    });
    return all;
}

File trials_file(const std::vector<TrialsInSlot>& all) {
    Csv csv({"length", "reversed_trials_their_goal", "reversed_trials_our_goal", "max_steer"});
    for (const TrialsInSlot& one : all) csv.row(one.length, one.trials.deduced, one.trials.found, one.max_steer);
    return {"reversed_trials.csv", csv.text()};
}

}  // namespace snug::paper
