// Ink on a page: what turns shapes into text, strokes and fills.
#include "canvas.hpp"

#include <cmath>
#include <numbers>

namespace snug::drawing {
namespace {

constexpr std::string_view replacement_sign = "\xef\xbf\xbd";

void set(cairo_t* canvas, Color color) {
    cairo_set_source_rgba(canvas, color.red, color.green, color.blue, color.alpha);
}

void set_font(cairo_t* canvas, const TextStyle& style) {
    cairo_select_font_face(canvas, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(canvas, style.size);
}

/// Bytes of the character that starts `text`, or 0 when they are no character.
std::size_t character_length(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) {
        return 1;
    }
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return 0;
        }
    }
    // Overlong forms, surrogates, and beyond the last code point.
    const unsigned char second = byte(1);
    if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second > 0x9f) || (lead == 0xf0 && second < 0x90) ||
        (lead == 0xf4 && second > 0x8f)) {
        return 0;
    }
    return length;
}

void drop_last_character(std::string& text) {
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) {
        text.pop_back();
    }
    if (!text.empty()) {
        text.pop_back();
    }
}

}  // namespace

void fill(cairo_t* canvas, Color color) {
    set(canvas, color);
    cairo_fill(canvas);
}

void stroke(cairo_t* canvas, Color color, double width) {
    set(canvas, color);
    cairo_set_line_width(canvas, width);
    cairo_stroke(canvas);
}

void fill_and_stroke(cairo_t* canvas, Color inside, Color outline, double width) {
    set(canvas, inside);
    cairo_fill_preserve(canvas);
    stroke(canvas, outline, width);
}

void trace(cairo_t* canvas, const std::vector<Point>& points, bool closed) {
    cairo_new_path(canvas);
    for (const Point& p : points) {
        cairo_line_to(canvas, p.x, p.y);
    }
    if (closed) {
        cairo_close_path(canvas);
    }
}

void trace_box(cairo_t* canvas, const Box& box) {
    cairo_new_path(canvas);
    cairo_rectangle(canvas, box.x_min, box.y_min, box.x_max - box.x_min, box.y_max - box.y_min);
}

void trace_rounded(cairo_t* canvas, const Box& box, double radius) {
    constexpr double quarter = std::numbers::pi / 2;
    cairo_new_path(canvas);
    cairo_arc(canvas, box.x_max - radius, box.y_min + radius, radius, -quarter, 0);
    cairo_arc(canvas, box.x_max - radius, box.y_max - radius, radius, 0, quarter);
    cairo_arc(canvas, box.x_min + radius, box.y_max - radius, radius, quarter, 2 * quarter);
    cairo_arc(canvas, box.x_min + radius, box.y_min + radius, radius, 2 * quarter, 3 * quarter);
    cairo_close_path(canvas);
}

void draw_line(cairo_t* canvas, Point from, Point to, Color color, double width) {
    trace(canvas, {from, to});
    stroke(canvas, color, width);
}

void trace_arrow_head(cairo_t* canvas, Point tip, double dx, double dy, double size) {
    const double length = std::hypot(dx, dy);
    if (!(length > 0.0)) {
        return;
    }
    const double ux = dx / length * size;
    const double uy = dy / length * size;
    trace(canvas,
          {tip, {tip.x - ux - 0.42 * uy, tip.y - uy + 0.42 * ux}, {tip.x - ux + 0.42 * uy, tip.y - uy - 0.42 * ux}},
          true);
}

std::string clean_text(std::string_view text) {
    std::string clean;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            clean += replacement_sign;
        } else if (length == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7f)) {
            clean += ' ';
        } else {
            clean += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

double text_width(cairo_t* canvas, std::string_view text, const TextStyle& style) {
    set_font(canvas, style);
    cairo_text_extents_t extents;
    cairo_text_extents(canvas, clean_text(text).c_str(), &extents);
    return extents.x_advance;
}

void write(cairo_t* canvas, Point at, std::string_view text, const TextStyle& style) {
    const std::string clean = clean_text(text);
    const double width = text_width(canvas, clean, style);
    const double x = at.x - (style.align == Align::left ? 0.0 : style.align == Align::center ? width / 2 : width);
    const double y = at.y + 0.36 * style.size;  // from the middle of a capital to the base line
    if (style.halo) {
        cairo_new_path(canvas);
        cairo_move_to(canvas, x, y);
        cairo_text_path(canvas, clean.c_str());
        stroke(canvas, palette::paper.faded(0.85), 3.0);
    }
    set(canvas, style.color);
    cairo_move_to(canvas, x, y);
    cairo_show_text(canvas, clean.c_str());
    cairo_new_path(canvas);
}

std::string fitted(cairo_t* canvas, std::string_view text, const TextStyle& style, double width) {
    std::string whole = clean_text(text.substr(0, 1000));  // no page shows more, and the cut below takes its time
    if (text.size() <= 1000 && text_width(canvas, whole, style) <= width) {
        return whole;
    }
    std::string cut;
    do {
        drop_last_character(whole);
        cut = whole + "\xe2\x80\xa6";
    } while (!whole.empty() && text_width(canvas, cut, style) > width);
    return cut;
}

}  // namespace snug::drawing
