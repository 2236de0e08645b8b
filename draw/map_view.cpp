// The picture of a map: for one heading, from where in the place how many direction changes are needed.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "car_shape.hpp"
#include "header.hpp"
#include "labels.hpp"
#include "place_ground.hpp"
#include "scene.hpp"
#include "snug/draw.hpp"
#include "snug/park_map.hpp"
#include "view.hpp"

namespace snug {
namespace drawing {
namespace {

struct MapPicture {
    const ParkMap& map;
    Pose start;
    Slot frame;
    std::string facts;
};

constexpr double key_row = 34.0;
constexpr double swatch = 16.0;

/// Few changes are light, many dark: one hue, so that the order shows in print.
constexpr std::array<unsigned, 8> shades = {0xd8f0e6, 0xa9dcc8, 0x74c3ad, 0x3fa79a,
                                            0x238589, 0x1c6478, 0x1b4562, 0x172a45};
constexpr Color impossible_color = rgb(0x9b3a2f);
constexpr Color unknown_color = rgb(0xf4efe2);

/// What a field of the picture shows.
struct Shown {
    enum Kind { nothing, changes, unknown, impossible } kind = nothing;
    int count = 0;
    bool proved = false;

    friend bool operator==(const Shown&, const Shown&) = default;
};

Shown shown(const MapBounds& bounds) {
    if (bounds.where != MapBounds::free) return {};
    if (bounds.impossible) return {Shown::impossible, 0, true};
    if (!bounds.direction_changes) return {Shown::unknown, 0, false};
    return {Shown::changes, *bounds.direction_changes, bounds.proved()};
}

/// Where the middle of the rear axle may be, in the frame.
Box region_of(const MapPicture& picture) {
    std::optional<Box> box;
    for (const Point& corner : picture.map.place().region()) {
        const Point p = picture.frame.to_slot(corner);
        const Box one = {p.x, p.x, p.y, p.y};
        box = box ? joined(*box, one) : one;
    }
    return *box;
}

View view_of(const MapPicture& picture) {
    const double around = 0.1 * picture.map.car().length();
    Box seen = joined(region_of(picture), box_of(picture.map.car(), picture.frame, picture.start));
    seen = {seen.x_min - around, seen.x_max + around, seen.y_min - around, seen.y_max + around};
    return fitted(picture.frame, seen, {{margin, header_height}, page_width - 2 * margin, 640.0});
}

/// The fields of one row of the picture that show the same, from and to in the frame.
struct Run {
    Box box;
    Shown what;
};

std::vector<Run> runs_of(const MapPicture& picture, const Box& seen) {
    const double step =
        std::max({picture.map.spacing(), (seen.x_max - seen.x_min) / 600.0, (seen.y_max - seen.y_min) / 400.0});
    const int columns = static_cast<int>((seen.x_max - seen.x_min) / step),
              rows = static_cast<int>((seen.y_max - seen.y_min) / step);
    std::vector<Run> runs;
    for (int row = 0; row < rows; ++row) {
        const double y = seen.y_min + row * step;
        Shown last;
        for (int column = 0; column < columns; ++column) {
            const double x = seen.x_min + column * step;
            Pose pose = picture.start;
            const Point at = picture.frame.to_world(Point{x + step / 2, y + step / 2});
            pose.x = at.x;
            pose.y = at.y;
            const Shown here = shown(picture.map.at(pose));
            if (here.kind == Shown::nothing) {
                last = here;
                continue;
            }
            if (here == last) {
                runs.back().box.x_max = x + step;
            } else {
                runs.push_back({{x, x + step, y, y + step}, here});
            }
            last = here;
        }
    }
    return runs;
}

Color color_of(const Shown& what) {
    if (what.kind == Shown::impossible) return impossible_color;
    if (what.kind == Shown::unknown) return unknown_color;
    return rgb(shades[std::min(static_cast<std::size_t>(what.count), shades.size() - 1)]);
}

/// Lines aslant over what is not proved, so that it is not told by colour alone.
void draw_stripes(cairo_t* canvas, const Box& box, Color color) {
    const Saved saved(canvas);
    trace_box(canvas, box);
    cairo_clip(canvas);
    const double height = box.y_max - box.y_min, apart = 6.0;
    // All lines lie on one grid of the page, so that those of neighbouring fields meet.
    for (double at = std::floor((box.x_min + box.y_min) / apart) * apart; at < box.x_max + box.y_max + apart;
         at += apart)
        draw_line(canvas, {at - box.y_min, box.y_min}, {at - box.y_min - height, box.y_max}, color, line::hair);
}

Box on_page(const View& view, const Box& box) {
    const Point one = view({box.x_min, box.y_min}), other = view({box.x_max, box.y_max});
    return {std::min(one.x, other.x), std::max(one.x, other.x), std::min(one.y, other.y), std::max(one.y, other.y)};
}

void draw_fields(cairo_t* canvas, const View& view, const std::vector<Run>& runs) {
    cairo_set_antialias(canvas, CAIRO_ANTIALIAS_NONE);
    for (const Run& run : runs) {
        trace_box(canvas, on_page(view, run.box));
        fill(canvas, color_of(run.what));
    }
    cairo_set_antialias(canvas, CAIRO_ANTIALIAS_DEFAULT);
    for (const Run& run : runs)
        if (!run.what.proved) draw_stripes(canvas, on_page(view, run.box), palette::ink.faded(0.35));
}

void draw_map_key(cairo_t* canvas, Point at, const std::vector<Run>& runs, int most) {
    std::vector<bool> counts(shades.size());
    bool unproved = false, unknown = false, impossible = false;
    for (const Run& run : runs) {
        if (run.what.kind == Shown::changes)
            counts[std::min(static_cast<std::size_t>(run.what.count), shades.size() - 1)] = true;
        unproved = unproved || (run.what.kind == Shown::changes && !run.what.proved);
        unknown = unknown || run.what.kind == Shown::unknown;
        impossible = impossible || run.what.kind == Shown::impossible;
    }
    const auto entry = [&](Color color, bool striped, const std::string& text) {
        const Box box = {at.x, at.x + swatch, at.y - swatch / 2, at.y + swatch / 2};
        trace_box(canvas, box);
        fill_and_stroke(canvas, color, palette::neighbour_line, line::hair);
        if (striped) draw_stripes(canvas, box, palette::ink.faded(0.35));
        const TextStyle style = {type::small, palette::ink};
        write(canvas, {at.x + swatch + 5.0, at.y}, text, style);
        at.x += swatch + 5.0 + text_width(canvas, text, style) + 16.0;
    };
    for (std::size_t count = 0; count < counts.size(); ++count)
        if (counts[count])
            entry(color_of({Shown::changes, static_cast<int>(count), true}), false,
                  std::to_string(count) + (count + 1 == counts.size() ? " or more" : ""));
    if (unproved) entry(palette::paper, true, "so many will do; fewer not ruled out");
    if (unknown) entry(unknown_color, true, "none known with up to " + std::to_string(most));
    if (impossible) entry(impossible_color, false, "no number will do");
}

std::string answer_at_start(const MapBounds& bounds) {
    if (bounds.where == MapBounds::blocked) return "the car meets something where it stands";
    if (bounds.where == MapBounds::outside) return "the car stands outside of the map";
    if (bounds.impossible) return "from where it stands no number of changes will do";
    if (!bounds.direction_changes) return "from where it stands at least " + changes_label(bounds.lower_bound);
    return "from where it stands " + changes_label(*bounds.direction_changes) +
           (bounds.proved() ? ", proved the fewest" : ", at least " + std::to_string(bounds.lower_bound));
}

std::string drawn(const MapPicture& picture, PictureFormat format) {
    const Car& car = picture.map.car();
    const View view = view_of(picture);
    const Box page = view.page();
    const std::vector<Run> runs = runs_of(picture, region_of(picture));
    const std::string answer = answer_at_start(picture.map.at(picture.start));
    return to_bytes({page_width, page.y_max + key_row + margin}, format,
                    name_of(car) + ", " + picture.facts + ": " + answer, [&](cairo_t* canvas) {
                        draw_header(canvas, name_of(car), answer, picture.facts);
                        {
                            const Saved saved(canvas);
                            clip_to(canvas, view);
                            draw_obstacles(canvas, view, picture.frame, picture.map.place());
                            draw_fields(canvas, view, runs);
                            draw_target(canvas, view, picture.frame, picture.map.place(), false);
                            trace_frame(canvas, view, car, picture.frame, picture.start);
                            stroke(canvas, palette::entry, line::frame);
                            draw_cross(canvas, view, picture.frame, picture.start, palette::entry_text);
                        }
                        draw_scale_bar(canvas, view, {page.x_max - 12.0, page.y_max - 12.0});
                        const Point key = {page.x_min, page.y_max + key_row / 2 + 4.0};
                        const std::string title = "Changes from where the rear axle's middle is, at this heading:";
                        const TextStyle style = {type::small, palette::ink, true};
                        write(canvas, key, title, style);
                        draw_map_key(canvas, {key.x + text_width(canvas, title, style) + 12.0, key.y}, runs,
                                     picture.map.max_changes());
                    });
}

}  // namespace
}  // namespace drawing

std::string draw_map(const ParkMap& map, const Street& street, const Pose& start, PictureFormat format) {
    using namespace drawing;
    return drawn({map, start, frame_of(street), facts_of(street, unit_for(map.car().length()))}, format);
}

std::string draw_map(const ParkMap& map, const Scene& scene, PictureFormat format) {
    using namespace drawing;
    return drawn({map, scene.start, frame_of(scene), facts_of(scene)}, format);
}

}  // namespace snug
