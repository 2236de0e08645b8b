#include "paper/headings.hpp"

#include "io/csv.hpp"
#include "paper/minima.hpp"
#include "snug/baselines.hpp"

namespace snug::paper {

namespace {

constexpr double figure_length = 1.1;  ///< extra slot length [m]

Slot slot_of(const Car& car, const SlotHeadings& at) {
    return Slot({.length = car.length() + at.extra_length, .width = car.width() + at.extra_width});
}

std::vector<Subrange> found(const Car& car, const SlotHeadings& at, double min_range,
                            const std::optional<Stepping>& steps = {}) {
    EntryOptions options;
    options.prove = false;
    options.max_changes = at.max_changes;
    options.min_range = min_range;
    const Slot slot = slot_of(car, at);
    return subranges((steps ? entry(car, slot, options, *steps) : entry(car, slot, options)).ranges);
}

void solve(std::vector<SlotHeadings>& all, Work& work) {
    const Car zoe = find_car("renault-zoe").value();
    work.each(all.size(), [&](std::size_t i) {
        all[i].exact = found(zoe, all[i], 0.0);
        all[i].sampled = found(zoe, all[i], work.options().grids.steps.heading_step);
    });
}

}  // namespace

std::vector<Subrange> subranges(const std::vector<HeadingRange>& ranges) {
    std::vector<Subrange> joined;
    int last = -1;
    for (const HeadingRange& range : ranges) {
        if (range.subrange != last) joined.push_back({range.min, range.max});
        joined.back().max = range.max;
        last = range.subrange;
    }
    return joined;
}

std::vector<SlotHeadings> headings_over_width(Work& work) {
    const Grids& grids = work.options().grids;
    std::vector<SlotHeadings> all;
    for (const int changes : {1, 2, 5, 10})
        for (const double width : extra_widths(grids, grids.heading_width))
            all.push_back({figure_length, width, changes, {}, {}});
    solve(all, work);
    return all;
}

std::vector<SlotHeadings> headings_over_length(Work& work) {
    const Grids& grids = work.options().grids;
    std::vector<SlotHeadings> all;
    for (int tenths = 5; tenths <= 19; ++tenths)
        for (const double width : extra_widths(grids, grids.heading_width))
            all.push_back({tenths / 10.0, width, 10, {}, {}});
    solve(all, work);
    return all;
}

std::vector<SlotHeadings> stepped_headings(Work& work) {
    const Grids& grids = work.options().grids;
    const Car zoe = find_car("renault-zoe").value();
    std::vector<SlotHeadings> all;
    for (const double width : extra_widths(grids, grids.width_step)) all.push_back({figure_length, width, 10, {}, {}});
    work.each(all.size(), [&](std::size_t i) { all[i].sampled = found(zoe, all[i], 0.0, grids.steps); });
    return all;
}

std::vector<File> headings_files(const std::vector<SlotHeadings>& over_width,
                                 const std::vector<SlotHeadings>& over_length) {
    Csv headings({"extra_width", "max_changes", "subrange", "heading_min", "heading_max"});
    for (const SlotHeadings& at : over_width)
        for (std::size_t i = 0; i < at.exact.size(); ++i)
            headings.row(at.extra_width, at.max_changes, static_cast<int>(i), at.exact[i].min, at.exact[i].max);
    Csv numbers({"extra_length", "extra_width", "subranges", "subranges_wider_than_heading_step"});
    for (const SlotHeadings& at : over_length)
        numbers.row(at.extra_length, at.extra_width, static_cast<int>(at.exact.size()),
                    static_cast<int>(at.sampled.size()));
    return {File{"entry_headings.csv", headings.text()}, File{"subranges.csv", numbers.text()}};
}

}  // namespace snug::paper
