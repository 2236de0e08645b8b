// Ink on a page: text, lines and arrows in points (y downwards), and the page as the bytes of a file.
#pragma once

#include <cairo.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "palette.hpp"
#include "snug/draw.hpp"
#include "snug/geometry.hpp"

namespace snug::drawing {

struct PageSize {
    double width = 0.0;
    double height = 0.0;
};

/// The page that `paint` draws, as a file with the given title.
std::string to_bytes(PageSize size, PictureFormat format, std::string_view title,
                     const std::function<void(cairo_t*)>& paint);

/// Restores the state of the canvas when it leaves the scope.
class Saved {
public:
    explicit Saved(cairo_t* canvas) : canvas_(canvas) { cairo_save(canvas_); }
    ~Saved() { cairo_restore(canvas_); }
    Saved(const Saved&) = delete;
    Saved& operator=(const Saved&) = delete;

private:
    cairo_t* canvas_;
};

void fill(cairo_t* canvas, Color color);
void stroke(cairo_t* canvas, Color color, double width);
/// Fills and outlines one path.
void fill_and_stroke(cairo_t* canvas, Color inside, Color outline, double width);

void trace(cairo_t* canvas, const std::vector<Point>& points, bool closed = false);
void trace_box(cairo_t* canvas, const Box& box);
void trace_rounded(cairo_t* canvas, const Box& box, double radius);
void draw_line(cairo_t* canvas, Point from, Point to, Color color, double width);
/// A triangle with its tip at `tip`, pointing along (dx, dy).
void trace_arrow_head(cairo_t* canvas, Point tip, double dx, double dy, double size);

enum class Align { left, center, right };

struct TextStyle {
    double size = type::normal;
    Color color = palette::ink;
    bool bold = false;
    Align align = Align::left;
    bool halo = false;  ///< a white rim, for text on top of lines
};

double text_width(cairo_t* canvas, std::string_view text, const TextStyle& style);
/// Text whose middle line runs through `at`. Anything that is no text in UTF-8 shows as a replacement sign.
void write(cairo_t* canvas, Point at, std::string_view text, const TextStyle& style = {});
/// The text, cut with an ellipsis to fit the width.
std::string fitted(cairo_t* canvas, std::string_view text, const TextStyle& style, double width);

/// Valid UTF-8 without control characters.
std::string clean_text(std::string_view text);

}  // namespace snug::drawing
