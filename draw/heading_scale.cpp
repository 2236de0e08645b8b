// Entry headings on a scale: which are possible, which park, and with how many direction changes.
#include "heading_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "labels.hpp"

namespace snug::drawing {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double band = 12.0;
constexpr TextStyle label = {type::small, palette::faint_ink, true, Align::right};

/// A horizontal axis of headings.
struct Axis {
    double from = 0.0;  ///< [rad]
    double to = 1.0;
    double left = 0.0;  ///< on the page
    double right = 1.0;
    double y = 0.0;

    [[nodiscard]] double at(double heading) const {
        return left + (right - left) * std::clamp((heading - from) / (to - from), 0.0, 1.0);
    }
};

/// 1, 2 or 5 times a power of ten [degrees] so that some seven ticks fit.
double tick_step(double span) {
    const double rough = span / degree / 7.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double lead : {1.0, 2.0, 5.0}) {
        if (lead * power >= rough) {
            return lead * power;
        }
    }
    return 10.0 * power;
}

void draw_ticks(cairo_t* canvas, const Axis& axis) {
    const double step = tick_step(axis.to - axis.from);
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
    const double below = axis.y + band / 2;
    draw_line(canvas, {axis.left, below}, {axis.right, below}, palette::faint_ink, line::hair);
    const double first = std::ceil(axis.from / degree / step - 1e-6);
    for (int i = 0; i < 24; ++i) {
        const double value = (first + i) * step;
        if (value * degree > axis.to + 1e-6 * (axis.to - axis.from)) {
            break;
        }
        const double x = axis.at(value * degree);
        draw_line(canvas, {x, below}, {x, below + 3.5}, palette::faint_ink, line::hair);
        write(canvas, {x, below + 10.5}, number(value, decimals) + "\u00b0",
              {type::tiny, palette::faint_ink, false, Align::center, true});
    }
}

void draw_band(cairo_t* canvas, const Axis& axis, double from, double to, Color color, double least) {
    const double x = axis.at(from);
    const double width = std::max(axis.at(to) - x, least);
    trace_box(canvas, {x, x + width, axis.y - band / 2, axis.y + band / 2});
    fill(canvas, color);
}

void draw_possible(cairo_t* canvas, const Axis& axis, const std::vector<double>& possible) {
    const double spacing = 1.5 * std::numbers::pi / 2 / 4000.0;
    for (std::size_t i = 0; i < possible.size();) {
        std::size_t end = i;
        while (end + 1 < possible.size() && possible[end + 1] - possible[end] < spacing) {
            ++end;
        }
        if (possible[end] >= axis.from && possible[i] <= axis.to) {
            draw_band(canvas, axis, possible[i], possible[end], palette::entry.faded(0.22), 1.0);
        }
        i = end + 1;
    }
}

/// Ranges side by side differ in their count, which is written above where there is room.
void draw_found(cairo_t* canvas, const Axis& axis, const std::vector<HeadingRange>& ranges, bool with_counts) {
    if (ranges.empty()) {
        return;
    }
    int fewest = ranges.front().direction_changes;
    int most = fewest;
    for (const HeadingRange& range : ranges) {
        fewest = std::min(fewest, range.direction_changes);
        most = std::max(most, range.direction_changes);
    }
    const TextStyle style = {type::tiny, palette::ink, true, Align::center};
    double written_to = axis.left - 100.0;
    for (const HeadingRange& range : ranges) {
        const double strength = most == fewest ? 1.0 : 1.0 - 0.6 * (range.direction_changes - fewest) / (most - fewest);
        draw_band(canvas, axis, range.min, range.max, palette::entry.faded(strength), 1.2);
        draw_line(canvas, {axis.at(range.min), axis.y - band / 2}, {axis.at(range.min), axis.y + band / 2},
                  palette::entry_text, line::hair);
        const std::string count = std::to_string(range.direction_changes);
        const double half = text_width(canvas, count, style) / 2 + 2.0;
        const double middle = (axis.at(range.min) + axis.at(range.max)) / 2;
        if (with_counts && middle - half > written_to) {
            write(canvas, {middle, axis.y - band / 2 - 6.0}, count, style);
            written_to = middle + half;
        }
    }
}

/// The part of the axis with the ranges, drawn out below it.
void draw_enlarged_scale(cairo_t* canvas, const Box& box, const Axis& all, const std::vector<double>& possible,
                         const std::vector<HeadingRange>& ranges) {
    const double span = ranges.back().max - ranges.front().min;
    const double rim = std::max(0.15 * span, 1e-13);
    const Axis enlarged = {ranges.front().min - rim, ranges.back().max + rim, all.left, all.right, box.y_max - 18.0};
    for (const auto& [heading, x] : {std::pair{enlarged.from, enlarged.left}, std::pair{enlarged.to, enlarged.right}}) {
        draw_line(canvas, {all.at(heading), all.y + band / 2}, {x, enlarged.y - band / 2}, palette::rule, line::thin);
    }
    write(canvas, {all.left - 12.0, enlarged.y - 5.0}, "enlarged, with the", label);
    write(canvas, {all.left - 12.0, enlarged.y + 6.0}, "direction changes", label);
    draw_possible(canvas, enlarged, possible);
    draw_found(canvas, enlarged, ranges, true);
    draw_ticks(canvas, enlarged);
}

}  // namespace

void draw_heading_scale(cairo_t* canvas, const Box& box, const std::vector<double>& possible,
                        const std::vector<HeadingRange>& ranges) {
    constexpr double labels = 150.0;
    const double largest = std::max(possible.back(), ranges.empty() ? 0.0 : ranges.back().max);
    const Axis all = {
        0.0, std::min(std::numbers::pi / 2, std::max(5.0 * degree, std::ceil(largest / degree / 5.0) * 5.0 * degree)),
        box.x_min + labels, box.x_max - 12.0, box.y_min + 14.0};
    write(canvas, {all.left - 12.0, all.y}, "entry headings", label);
    if (!ranges.empty()) {
        draw_enlarged_scale(canvas, box, all, possible, ranges);
    }
    draw_possible(canvas, all, possible);
    draw_found(canvas, all, ranges, false);
    draw_ticks(canvas, all);
}

}  // namespace snug::drawing
