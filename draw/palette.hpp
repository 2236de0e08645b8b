// Colours, line widths and type sizes of all pictures. [points]
//
// Okabe and Ito's colours, which keep apart for colour-blind readers and in print; what matters is never told by colour
// alone.
#pragma once

namespace snug::drawing {

struct Color {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
    double alpha = 1.0;

    [[nodiscard]] constexpr Color faded(double to) const { return {red, green, blue, to}; }
};

constexpr Color rgb(unsigned hex) {
    return {((hex >> 16) & 255) / 255.0, ((hex >> 8) & 255) / 255.0, (hex & 255) / 255.0, 1.0};
}

namespace palette {

inline constexpr Color paper = rgb(0xffffff);
inline constexpr Color ink = rgb(0x22272e);
inline constexpr Color faint_ink = rgb(0x6b7480);
inline constexpr Color rule = rgb(0xd7dbe0);

inline constexpr Color slot = rgb(0x0072b2);
inline constexpr Color slot_floor = rgb(0xf5f9fc);
inline constexpr Color entry = rgb(0xe08a00);
inline constexpr Color entry_text = rgb(0xa86500);
inline constexpr Color goal = rgb(0x009e73);
inline constexpr Color goal_text = rgb(0x00734f);
inline constexpr Color backward = ink;
inline constexpr Color forward = rgb(0xb0307c);
inline constexpr Color contact = rgb(0xf0e442);

inline constexpr Color road = rgb(0xe6e8eb);
inline constexpr Color blocked = rgb(0xd5d9de);
inline constexpr Color lane_line = rgb(0xffffff);
inline constexpr Color curb = rgb(0xb9b6ae);
inline constexpr Color sidewalk = rgb(0xf3f1ec);
inline constexpr Color neighbour = rgb(0xc3c9d1);
inline constexpr Color neighbour_glass = rgb(0xaab3be);
inline constexpr Color neighbour_line = rgb(0x98a2ae);

}  // namespace palette

namespace line {
inline constexpr double hair = 0.6;
inline constexpr double thin = 0.9;
inline constexpr double frame = 1.8;
inline constexpr double path = 2.2;
}  // namespace line

namespace type {
inline constexpr double title = 20.0;
inline constexpr double normal = 11.5;
inline constexpr double small = 9.5;
inline constexpr double tiny = 8.0;
}  // namespace type

}  // namespace snug::drawing
