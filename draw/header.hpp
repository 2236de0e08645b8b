// The head of a picture: which car, which slot, and the answer in one line.
#pragma once

#include <cairo.h>

#include "canvas.hpp"
#include "labels.hpp"
#include "view.hpp"

namespace snug::drawing {

inline constexpr double page_width = 1000.0;
inline constexpr double margin = 28.0;
inline constexpr double header_height = 78.0;
/// Where the scene lies; to its right stands the width of the slot.
inline constexpr Panel stage_panel = {{margin, header_height}, page_width - 2 * margin - 74.0, 560.0};

std::string name_of(const Car& car);
void draw_header(cairo_t* canvas, std::string_view title, std::string_view answer, std::string_view facts);
void draw_header(cairo_t* canvas, const Car& car, const Slot& slot, const Unit& unit, std::string_view answer,
                 const PictureOptions& options);
/// "renault-zoe, slot 4.50 m × 2.00 m"
std::string picture_title(const Car& car, const Slot& slot, const Unit& unit);
/// What an answer without a maneuver means.
std::string verdict(const Car& car, const Slot& slot, const Answer& answer, const PictureOptions& options);

}  // namespace snug::drawing
