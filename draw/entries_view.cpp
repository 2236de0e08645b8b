// The picture of all entry positions: those that are possible, those found with their goals, and their headings.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "canvas.hpp"
#include "car_shape.hpp"
#include "header.hpp"
#include "heading_scale.hpp"
#include "labels.hpp"
#include "scene.hpp"
#include "snug/draw.hpp"
#include "view.hpp"

namespace snug {
namespace drawing {
namespace {

constexpr std::size_t frames_shown = 14;
constexpr double gutter = 24.0;
constexpr double caption_height = 40.0;
constexpr double scale_height = 128.0;
constexpr double lone_scale_height = 62.0;  ///< with nothing to enlarge

/// The headings that are possible, evenly spread; the parallel one where none is.
std::vector<double> spread_headings(const Car& car, const Slot& slot, const Driving& driving) {
    constexpr double spacing = std::numbers::pi / 8000;
    std::vector<double> spread;
    for (const Headings& range : possible_headings(car, slot, driving)) {
        for (double heading = range.min; heading < range.max; heading += spacing) spread.push_back(heading);
        spread.push_back(range.max);
    }
    if (spread.empty()) spread.push_back(0.0);
    return spread;
}

std::vector<double> picked(const std::vector<double>& all, std::size_t most) {
    if (all.size() <= most) {
        return all;
    }
    std::vector<double> some;
    for (std::size_t i = 0; i < most; ++i) {
        some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    }
    return some;
}

/// Headings spread over all ranges as their widths ask for, at least the middle of each.
std::vector<double> found_headings(const std::vector<HeadingRange>& ranges) {
    double total = 0.0;
    for (const HeadingRange& range : ranges) {
        total += range.max - range.min;
    }
    std::vector<double> headings;
    for (const HeadingRange& range : ranges) {
        const double share = total > 0.0 ? (range.max - range.min) / total : 0.0;
        const int count = std::max(1, static_cast<int>(std::lround(share * static_cast<double>(frames_shown))));
        for (int i = 0; i < count; ++i) {
            headings.push_back(range.min + (range.max - range.min) * (count == 1 ? 0.5 : i / (count - 1.0)));
        }
    }
    return picked(headings, 2 * frames_shown);
}

/// Where the car ends up from each of the headings, as far as it does.
std::vector<Pose> goals_of(const Car& car, const Slot& slot, const std::vector<double>& headings, const Answer& answer,
                           const PictureOptions& options) {
    MaxSteerOptions asked;
    asked.driving.clearance = options.driving.clearance;
    asked.driving.enter = options.driving.enter;
    for (const HeadingRange& range : answer.ranges) {
        asked.max_changes = std::max(asked.max_changes, range.direction_changes);
    }
    std::vector<Pose> goals;
    for (const double heading : headings) {
        const MaxSteerRun run = max_steer(car, slot, heading, asked);
        if (run.outcome == Outcome::parked) {
            goals.push_back(run.maneuver.goal());
        }
    }
    return goals;
}

void draw_frames(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const std::vector<Pose>& poses,
                 Color color, Color cross) {
    const double alpha = poses.size() > 6 ? 0.75 : 1.0;
    for (const Pose& pose : poses) {
        trace_frame(canvas, view, car, slot, pose);
        stroke(canvas, color.faded(alpha), line::thin + 0.3);
    }
    for (const Pose& pose : poses) {
        draw_cross(canvas, view, slot, pose, cross);
    }
}

struct Panes {
    Panel possible;
    Panel found;
};

Panes panes() {
    const double width = (page_width - 2 * margin - gutter) / 2;
    const double top = header_height + caption_height - 8.0;
    return {{{margin, top}, width, 420.0}, {{margin + width + gutter, top}, width, 420.0}};
}

void draw_caption(cairo_t* canvas, const View& view, std::string_view title, std::string_view detail) {
    const Box page = view.page();
    const TextStyle bold = {type::normal, palette::ink, true};
    write(canvas, {page.x_min, page.y_min - 26.0}, title, bold);
    const TextStyle plain = {type::small, palette::faint_ink};
    write(canvas, {page.x_min, page.y_min - 11.0}, fitted(canvas, detail, plain, page.x_max - page.x_min), plain);
}

/// One of the two scenes; `goals` lie below `entries`.
void draw_pane(cairo_t* canvas, const View& view, const Car& car, const Slot& slot, const std::vector<Pose>& entries,
               const std::vector<Pose>& goals) {
    draw_ground(canvas, view, car, slot);
    const Saved saved(canvas);
    clip_to(canvas, view);
    draw_frames(canvas, view, car, slot, goals, palette::goal, palette::goal_text);
    draw_frames(canvas, view, car, slot, entries, palette::entry, palette::entry_text);
    draw_slot(canvas, view, slot);
}

/// Headings from the first range to the last, with as many digits as tell them apart.
std::string headings_label(const std::vector<HeadingRange>& ranges) {
    if (ranges.empty()) {
        return "none";
    }
    double narrowest = std::numbers::pi;
    for (const HeadingRange& range : ranges) {
        narrowest = std::min(narrowest, range.max - range.min);
    }
    const double digits = 2.0 - std::log10(std::max(narrowest, 1e-12) * 180.0 / std::numbers::pi);
    const int decimals = std::clamp(static_cast<int>(digits), 2, 14);
    const std::string ends = "headings from " + degrees_label(ranges.front().min, decimals) + " to " +
                             degrees_label(ranges.back().max, decimals);
    return ranges.size() == 1 ? ends : ends + " in " + std::to_string(ranges.size()) + " ranges";
}

std::string headline_of(const Car& car, const Slot& slot, const Answer& answer, const PictureOptions& options) {
    if (answer.ranges.empty()) {
        return verdict(car, slot, answer, options);
    }
    int fewest = answer.ranges.front().direction_changes;
    int most = fewest;
    for (const HeadingRange& range : answer.ranges) {
        fewest = std::min(fewest, range.direction_changes);
        most = std::max(most, range.direction_changes);
    }
    return "parks with " + (fewest == most ? "" : std::to_string(fewest) + " to ") + changes_label(most);
}

}  // namespace
}  // namespace drawing

std::string draw_entries(const Car& car, const Slot& slot, const Answer& answer, PictureFormat format,
                         const PictureOptions& options) {
    using namespace drawing;
    const std::vector<double> possible = spread_headings(car, slot, options.driving);
    const std::vector<double> found = found_headings(answer.ranges);
    const auto entries_at = [&](const std::vector<double>& headings) {
        std::vector<Pose> poses;
        poses.reserve(headings.size());
        for (const double heading : headings) {
            poses.push_back(entry_position(car, slot, heading, options.driving));
        }
        return poses;
    };
    const std::vector<Pose> possible_entries = entries_at(picked(possible, frames_shown));
    const std::vector<Pose> found_entries = entries_at(found);
    const std::vector<Pose> goals = goals_of(car, slot, found, answer, options);

    Box needed = box_of(car, slot, possible_entries.front());
    for (const Pose& pose : possible_entries) {
        needed = joined(needed, box_of(car, slot, pose));
    }
    for (const Pose& pose : goals) {
        needed = joined(needed, box_of(car, slot, pose));
    }
    const View left = view_of(car, slot, needed, panes().possible);
    const View right = view_of(car, slot, needed, panes().found);
    const double scale_top = left.page().y_max + 22.0;
    const double bottom = scale_top + (answer.ranges.empty() ? lone_scale_height : scale_height);

    const Unit unit = unit_for(car.length());
    const std::string headline = headline_of(car, slot, answer, options);
    const std::string largest = degrees_label(possible.back());
    return to_bytes(
        {page_width, bottom}, format, picture_title(car, slot, unit) + ": " + headline, [&](cairo_t* canvas) {
            draw_header(canvas, car, slot, unit, headline, options);
            draw_caption(
                canvas, left, "Possible entry positions",
                possible.size() > 1 ? "headings from parallel, 0\u00b0, to " + largest : "the parallel heading alone");
            draw_pane(canvas, left, car, slot, possible_entries, {});
            draw_caption(canvas, right,
                         goals.empty() ? "Entry positions found" : "Entry positions found, with their goals in green",
                         headings_label(answer.ranges));
            draw_pane(canvas, right, car, slot, found_entries, goals);
            for (const View& view : {left, right}) {
                draw_length(canvas, view, slot, unit);
                draw_scale(canvas, view, slot);
            }
            draw_heading_scale(canvas, {margin, page_width - margin, scale_top, bottom - margin}, possible,
                               answer.ranges);
        });
}

}  // namespace snug
