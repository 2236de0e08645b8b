#include "paper/minima.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>

#include "io/csv.hpp"
#include "snug/baselines.hpp"

namespace snug::paper {

namespace {

constexpr double same = 1e-9;  ///< two grid points no further apart are one [m]

bool contains(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

/// The paper's loop over slot lengths for one width. It begins one step below the exact answer, not at the car's length:
/// Algorithm 1 stops short of every contact and needs more room, not less.
std::optional<double> first_length(const Car& car, double extra_width, int max_changes, const Grids& grids) {
    const auto exact = min_slot(car, car.width() + extra_width, {.max_changes = max_changes}).length;
    if (!exact) return std::nullopt;
    EntryOptions options;
    options.prove = false;
    options.max_changes = max_changes;
    const double steps_to_exact = std::floor((*exact - car.length()) / grids.length_step);
    for (double step = std::max(0.0, steps_to_exact - 1.0); step < steps_to_exact + 50.0; step += 1.0) {
        const double extra = on_grid(step * grids.length_step);
        const Slot slot({.length = car.length() + extra, .width = car.width() + extra_width});
        if (entry(car, slot, options, grids.steps).parkable()) return extra;
    }
    return std::nullopt;
}

File curves(const std::string& name, const std::vector<CarMinima>& minima, std::initializer_list<const char*> cars,
            const std::vector<int>& changes) {
    Csv csv({"car", "max_changes", "extra_width", "extra_length", "width", "length", "entry_heading"});
    for (const CarMinima& of : minima) {
        if (std::find(cars.begin(), cars.end(), of.car.name()) == cars.end()) continue;
        for (const MinSlot& row : of.exact) {
            if (!contains(changes, row.max_changes)) continue;
            std::optional<double> extra_length;
            if (row.length) extra_length = *row.length - of.car.length();
            csv.row(of.car.name(), row.max_changes, on_grid(*row.width - of.car.width()), extra_length, row.width,
                    row.length, row.entry_heading);
        }
    }
    return {name, csv.text()};
}

std::string metres(const std::optional<double>& length, const Car& car) {
    if (!length) return "–";
    char text[32];
    // A slot must be at least that long: rounded up.
    std::snprintf(text, sizeof text, "%.2f", std::ceil((*length - car.length()) * 100.0 - 1e-4) / 100.0);
    return text;
}

}  // namespace

const std::vector<int>& counts() {
    static const std::vector<int> all = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 30, 40, 50, 100};
    return all;
}

std::vector<double> extra_widths(const Grids& grids, double step) {
    std::vector<double> widths;
    for (int i = 1; i <= std::lround(grids.widest / step); ++i) widths.push_back(on_grid(i * step));
    return widths;
}

std::optional<double> CarMinima::extra_length(int max_changes, double extra_width) const {
    for (const MinSlot& row : exact) {
        const bool asked = row.max_changes == max_changes && std::abs(*row.width - car.width() - extra_width) < same;
        if (asked && row.length) return *row.length - car.length();
    }
    return std::nullopt;
}

std::optional<double> CarMinima::stepped_extra_length(int max_changes, double extra_width) const {
    for (const SteppedMinimum& one : stepped)
        if (one.max_changes == max_changes && std::abs(one.extra_width - extra_width) < same) return one.extra_length;
    return std::nullopt;
}

std::vector<CarMinima> minima(Work& work) {
    std::vector<CarMinima> all;
    const Grids& grids = work.options().grids;
    const std::vector<Car> cars = catalogue();
    for (std::size_t i = 1; i < cars.size(); ++i) {  // all but the mid-sized vehicle
        const Car& car = cars[i];
        std::vector<double> widths = extra_widths(grids, grids.width_step);
        for (double& width : widths) width += car.width();
        SweepOptions sweep;
        sweep.threads = work.options().threads;
        sweep.progress = [&, tell = work.teller(), done = static_cast<double>(i - 1)](double part) {
            return !tell || tell((done + part) / static_cast<double>(cars.size() - 1));
        };
        all.push_back({car, min_slots(car, widths, counts(), {}, sweep), {}});
        if (all.back().exact.empty()) throw GivenUp();
    }
    return all;
}

void add_stepped(std::vector<CarMinima>& minima, Work& work) {
    const Grids& grids = work.options().grids;
    for (CarMinima& of : minima) {
        const bool zoe = of.car.name() == "renault-zoe";
        for (const int changes : counts()) {
            if (zoe) of.stepped.push_back({changes, 0.1, {}});
            if (zoe || changes <= 4) of.stepped.push_back({changes, wide_enough, {}});
            if (zoe || changes <= 4 || contains({10, 20, 30, 100}, changes))
                of.stepped.push_back({changes, grids.widest, {}});
        }
    }
    std::vector<std::pair<const Car*, SteppedMinimum*>> points;
    for (CarMinima& of : minima)
        for (SteppedMinimum& one : of.stepped) points.emplace_back(&of.car, &one);
    work.each(points.size(), [&](std::size_t i) {
        const auto& [car, point] = points[i];
        point->extra_length = first_length(*car, point->extra_width, point->max_changes, grids);
    });
}

std::vector<File> minima_files(const std::vector<CarMinima>& minima) {
    const auto everyone = {"renault-zoe", "opel-corsa", "vw-transporter", "mercedes-amg-gt"};
    Csv stepped({"car", "max_changes", "extra_width", "extra_length"});
    for (const CarMinima& of : minima)
        for (const SteppedMinimum& one : of.stepped)
            stepped.row(of.car.name(), one.max_changes, one.extra_width, one.extra_length);
    return {curves("minimum_zoe.csv", minima, {"renault-zoe"}, counts()),
            curves("minimum_others.csv", minima, {"opel-corsa", "vw-transporter", "mercedes-amg-gt"}, counts()),
            curves("minimum_all.csv", minima, everyone, {1, 2, 5, 10}),
            curves("minimum_few_changes.csv", minima, everyone, {0, 1, 2, 3, 4}),
            File{"minimum_paper_steps.csv", stepped.text()}};
}

std::vector<File> extra_length_table(Work& work) {
    const std::vector<int> changes = {0, 1, 2, 3, 5, 10};
    const std::vector<double> extra_width = {0.2, 0.6};
    const std::vector<Car> cars = catalogue();
    std::vector<std::optional<double>> slots(cars.size() * extra_width.size() * changes.size());
    const auto index = [&](std::size_t car, std::size_t width, std::size_t change) {
        return (car * extra_width.size() + width) * changes.size() + change;
    };
    work.each(slots.size(), [&](std::size_t i) {
        const Car& car = cars[i / changes.size() / extra_width.size()];
        const double width = car.width() + extra_width[i / changes.size() % extra_width.size()];
        slots[i] = min_slot(car, width, {.max_changes = changes[i % changes.size()]}).length;
    });

    Csv csv({"car", "extra_width", "max_changes", "extra_length"});
    std::string text =
        "How much longer than the car must the slot be? In metres, rounded up to the next centimetre; – where no "
        "length "
        "will do.\n\n| car | slot wider by |";
    for (const int change : changes) {
        text += ' ';
        text += change == 0 ? "no" : std::to_string(change);
        text += change == 1 ? " change |" : " changes |";
    }
    text += "\n|---|---|---:|---:|---:|---:|---:|---:|\n";
    for (std::size_t c = 0; c < cars.size(); ++c) {
        for (std::size_t w = 0; w < extra_width.size(); ++w) {
            char by[32];
            std::snprintf(by, sizeof by, "%.1f m", extra_width[w]);
            text += "| ";
            if (w == 0) text += cars[c].name();
            text += std::string(" | ") + by + " |";
            for (std::size_t n = 0; n < changes.size(); ++n) {
                const std::optional<double>& slot = slots[index(c, w, n)];
                text += ' ' + metres(slot, cars[c]) + " |";
                std::optional<double> extra;
                if (slot) extra = *slot - cars[c].length();
                csv.row(cars[c].name(), extra_width[w], changes[n], extra);
            }
            text += '\n';
        }
    }
    return {{"extra_lengths.md", text}, File{"extra_lengths.csv", csv.text()}};
}

}  // namespace snug::paper
