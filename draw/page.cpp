// A page as the bytes of a file: SVG, PDF and PNG through Cairo, the same bytes for the same drawing.
#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cctype>
#include <map>
#include <memory>
#include <stdexcept>

#include "canvas.hpp"

namespace snug {

std::optional<PictureFormat> picture_format(std::string_view file_name) {
    const auto dot = file_name.rfind('.');
    if (dot == std::string_view::npos) {
        return std::nullopt;
    }
    std::string extension(file_name.substr(dot + 1));
    for (char& letter : extension) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    if (extension == "svg") {
        return PictureFormat::svg;
    }
    if (extension == "pdf") {
        return PictureFormat::pdf;
    }
    if (extension == "png") {
        return PictureFormat::png;
    }
    return std::nullopt;
}

namespace drawing {
namespace {

constexpr double pixels_per_point = 2.0;

struct Release {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* canvas) const { cairo_destroy(canvas); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Canvas = std::unique_ptr<cairo_t, Release>;
using FontOptions = std::unique_ptr<cairo_font_options_t, Release>;

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) {
        throw std::runtime_error(std::string("the picture could not be drawn: ") + cairo_status_to_string(status));
    }
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    try {
        static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    } catch (...) {
        return CAIRO_STATUS_NO_MEMORY;
    }
    return CAIRO_STATUS_SUCCESS;
}

Surface make_surface(PageSize size, PictureFormat format, const std::string& title, std::string& bytes) {
    if (format == PictureFormat::svg) {
        return Surface(cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height));
    }
    if (format == PictureFormat::pdf) {
        Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, size.width, size.height));
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, title.c_str());
        // Without a date of ours Cairo writes today's.
        cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2022-01-01T00:00:00Z");
        return surface;
    }
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(size.width * pixels_per_point),
                                              static_cast<int>(size.height * pixels_per_point)));
}

std::string escaped(std::string_view text) {
    std::string xml;
    for (const char c : text) {
        if (c == '<') {
            xml += "&lt;";
        } else if (c == '>') {
            xml += "&gt;";
        } else if (c == '&') {
            xml += "&amp;";
        } else {
            xml += c;
        }
    }
    return xml;
}

/// Cairo numbers its surfaces through the life of the process; number them through the file instead.
std::string renumbered(const std::string& svg) {
    constexpr std::string_view word = "surface";
    std::map<std::string, std::size_t> numbers;
    std::string out;
    std::size_t done = 0;
    for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, at + 1)) {
        const std::size_t digits = at + word.size();
        const std::size_t end = svg.find_first_not_of("0123456789", digits);
        if (end == digits || end == std::string::npos) {
            continue;
        }
        const auto [number, is_new] = numbers.try_emplace(svg.substr(digits, end - digits), numbers.size() + 1);
        out += svg.substr(done, digits - done) + std::to_string(number->second);
        done = end;
    }
    return out + svg.substr(done);
}

/// Cairo draws letters as shapes; the title says in words what the picture shows.
std::string titled(std::string svg, std::string_view title) {
    const std::size_t root = svg.find("<svg");
    const std::size_t end = root == std::string::npos ? root : svg.find('>', root);
    if (end != std::string::npos) {
        svg.insert(end + 1, "\n<title>" + escaped(title) + "</title>");
    }
    return svg;
}

}  // namespace

std::string to_bytes(PageSize size, PictureFormat format, std::string_view title,
                     const std::function<void(cairo_t*)>& paint) {
    const std::string clean_title = clean_text(title);
    std::string bytes;
    const Surface surface = make_surface(size, format, clean_title, bytes);
    check(cairo_surface_status(surface.get()));
    {
        const Canvas canvas(cairo_create(surface.get()));
        if (format == PictureFormat::png) {
            cairo_scale(canvas.get(), pixels_per_point, pixels_per_point);
        }
        // Letters keep their shape and place at every size.
        const FontOptions options(cairo_font_options_create());
        cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
        cairo_set_font_options(canvas.get(), options.get());
        cairo_set_line_cap(canvas.get(), CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(canvas.get(), CAIRO_LINE_JOIN_ROUND);
        trace_box(canvas.get(), {0.0, size.width, 0.0, size.height});
        fill(canvas.get(), palette::paper);
        paint(canvas.get());
        check(cairo_status(canvas.get()));
    }
    if (format == PictureFormat::png) {
        check(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
    }
    cairo_surface_finish(surface.get());
    check(cairo_surface_status(surface.get()));
    return format == PictureFormat::svg ? titled(renumbered(bytes), clean_title) : bytes;
}

}  // namespace drawing
}  // namespace snug
