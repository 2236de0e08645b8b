// The head of a picture: which car, which slot, and the answer in one line.
#include "header.hpp"

namespace snug::drawing {

std::string name_of(const Car& car) { return car.name().empty() ? "Unnamed car" : car.name(); }

namespace {

/// Where the slot lies in the world, when that is not the default.
std::string placement(const Slot& slot, const Unit& unit) {
    const Point p = slot.corner();
    std::string text;
    if (p.x != 0.0 || p.y != 0.0) {
        const auto coordinate = [&](double value) { return number(value / unit.metres, unit.decimals); };
        text += ", corner at (" + coordinate(p.x) + ", " + coordinate(p.y) + ") " + std::string(unit.name);
    }
    if (slot.heading() != 0.0) {
        text += ", parallel heading " + degrees_label(slot.heading());
    }
    return text;
}

}  // namespace

std::string picture_title(const Car& car, const Slot& slot, const Unit& unit) {
    return name_of(car) + ", slot " + size_label(slot.length(), slot.width(), unit);
}

void draw_header(cairo_t* canvas, std::string_view title, std::string_view answer, std::string_view facts) {
    const double width = page_width - 2 * margin;
    const TextStyle large = {type::title, palette::ink, true};
    write(canvas, {margin, 26.0}, fitted(canvas, title, large, width), large);
    const TextStyle bold = {type::normal + 1.5, palette::ink, true};
    write(canvas, {margin, 47.0}, fitted(canvas, answer, bold, width), bold);
    const TextStyle plain = {type::normal - 0.5, palette::faint_ink};
    write(canvas, {margin, 64.0}, fitted(canvas, facts, plain, width), plain);
}

void draw_header(cairo_t* canvas, const Car& car, const Slot& slot, const Unit& unit, std::string_view answer,
                 const PictureOptions& options) {
    std::string facts = "car " + size_label(car.length(), car.width(), unit) + ", turning radius " +
                        length_label(car.turning_radius(), unit) + "; slot " +
                        size_label(slot.length(), slot.width(), unit) + " on the " +
                        (slot.side() == Side::left ? "left" : "right");
    const bool tail = options.driving.enter == Enter::backward;
    if (options.leaving) {
        facts += tail ? ", left nose first" : ", left tail first";
    } else {
        facts += tail ? ", entered tail first" : ", entered nose first";
    }
    if (options.driving.clearance > 0.0) {
        facts += ", clearance " + length_label(options.driving.clearance, unit);
    }
    draw_header(canvas, name_of(car), answer, facts + placement(slot, unit));
}

std::string verdict(const Car& car, const Slot& slot, const Answer& answer, const PictureOptions& options) {
    if (answer.cancelled) {
        return "no answer: the question was given up";
    }
    if (answer.parkable()) {
        return "the car can park; no maneuver is given";
    }
    const Shortfall lacking = shortfall(car, slot, options.driving);
    const Unit unit = unit_for(car.length());
    std::string text = "cannot park";
    if (lacking.length > 0.0) {
        text += ", the slot is " + path_label(lacking.length, unit) + " too short";
    }
    if (lacking.width > 0.0) {
        text += (lacking.length > 0.0 ? " and " : ", the slot is ") + path_label(lacking.width, unit) + " too narrow";
    }
    return text;
}

}  // namespace snug::drawing
