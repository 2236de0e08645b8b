// The moves as a table: number, direction, steering, length, heading, contact.
#include "moves_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "path.hpp"
#include "snug/draw.hpp"

namespace snug::drawing {
namespace {

constexpr double row_height = 17.0;
constexpr std::size_t most_rows = 60;  ///< longer tables leave out their middle
constexpr std::size_t end_rows = 20;   ///< and show so many rows at either end

std::string steering_label(const Car& car, double angle) {
    if (angle == 0.0) {
        return "straight";
    }
    const std::string side = angle > 0.0 ? "left" : "right";
    if (std::abs(angle) > car.max_steer() * (1.0 - 1e-9)) {
        return "full " + side;
    }
    return degrees_label(std::abs(angle), 1) + " " + side;
}

/// The car in small, its nose where it points in the scene, with a diamond where it touches.
void draw_contact_sign(cairo_t* canvas, Point middle, CarPart part, bool turned) {
    constexpr double length = 22.0;
    constexpr double width = 9.0;
    const Box box = {middle.x - length / 2, middle.x + length / 2, middle.y - width / 2, middle.y + width / 2};
    trace_rounded(canvas, box, 2.5);
    fill_and_stroke(canvas, palette::paper, palette::faint_ink, line::hair);
    const double nose = turned ? -1.0 : 1.0;
    const double windscreen = middle.x + nose * (length / 2 - 6.0);
    draw_line(canvas, {windscreen, box.y_min + 1.5}, {windscreen, box.y_max - 1.5}, palette::faint_ink, line::thin);
    double ahead = 0.0;
    double left = 0.0;
    using enum CarPart;
    if (part == front_left_corner || part == front_edge || part == front_right_corner) {
        ahead = 1.0;
    }
    if (part == rear_left_corner || part == rear_edge || part == rear_right_corner) {
        ahead = -1.0;
    }
    if (part == front_left_corner || part == left_edge || part == rear_left_corner) {
        left = 1.0;
    }
    if (part == front_right_corner || part == right_edge || part == rear_right_corner) {
        left = -1.0;
    }
    draw_contact(canvas, {middle.x + nose * ahead * length / 2, middle.y - nose * left * width / 2});
}

struct Columns {
    double number, direction, steering, length, chart, chart_end, heading, sign, contact, end;
};

/// Where the rear axle centre is along the slot, on the page.
struct Chart {
    double first = 0.0;  ///< slot frame [m]
    double scale = 0.0;  ///< points per metre
    double left = 0.0;   ///< on the page
    bool turned = false;
    double width = 0.0;

    [[nodiscard]] double at(const Slot& slot, const Pose& pose) const {
        const double along = (slot.to_slot(pose).x - first) * scale;
        return left + (turned ? width - along : along);
    }
};

Chart chart_of(const Columns& x, const Slot& slot, const std::vector<Leg>& legs) {
    double least = slot.to_slot(legs.front().move->start).x;
    double most = least;
    for (const Leg& leg : legs) {
        const double end = slot.to_slot(leg.move->end).x;
        least = std::min(least, end);
        most = std::max(most, end);
    }
    Chart chart;
    chart.first = least;
    chart.left = x.chart;
    chart.width = x.chart_end - x.chart;
    chart.scale = most > least ? chart.width / (most - least) : 0.0;
    chart.turned = slot.side() == Side::left;
    return chart;
}

void draw_row(cairo_t* canvas, const Columns& x, double y, const Chart& chart, const Maneuver& maneuver,
              const Slot& slot, const Leg& leg, const std::string& end_in_words, bool last, const Unit& unit) {
    const Move& move = *leg.move;
    const TextStyle plain = {type::small, palette::ink};
    const TextStyle figures = {type::small, palette::ink, false, Align::right};
    const Color badge = move.direction == Direction::backward ? palette::backward : palette::forward;
    draw_badge(canvas, {x.number, y}, leg.label, badge);
    write(canvas, {x.direction, y}, to_string(move.direction), plain);
    write(canvas, {x.steering, y}, steering_label(maneuver.car, move.steering_angle), plain);
    write(canvas, {x.length, y}, path_label(move.length, unit), figures);
    const double end = chart.at(slot, move.end);
    if (!last) {
        draw_line(canvas, {end, y}, {end, y + row_height}, palette::faint_ink.faded(0.6), line::hair);
    }
    draw_path_sample(canvas, {chart.at(slot, move.start), y}, {end, y}, move.direction);
    const double heading = std::remainder(slot.to_slot(move.end).heading, 2.0 * std::numbers::pi);
    write(canvas, {x.heading, y}, degrees_label(std::abs(heading) < 1e-12 ? 0.0 : heading), figures);
    if (move.contact) {
        draw_contact_sign(canvas, {x.sign, y}, move.contact->part, slot.side() == Side::left);
        const std::string contact =
            std::string(to_string(move.contact->part)) + " meets " + std::string(called(move.contact->obstacle));
        write(canvas, {x.contact, y}, fitted(canvas, contact, plain, x.end - x.contact), plain);
    } else if (!end_in_words.empty()) {
        write(canvas, {x.contact, y}, fitted(canvas, end_in_words, plain, x.end - x.contact), plain);
    } else {
        const TextStyle stop = {type::small, last ? palette::goal_text : palette::faint_ink, last};
        write(canvas, {x.contact, y}, last ? "goal position" : "stop", stop);
    }
}

}  // namespace

double table_height(std::size_t moves) {
    const std::size_t rows = moves > most_rows ? 2 * end_rows + 1 : moves;
    return row_height * (static_cast<double>(rows) + 1.5);
}

void draw_table(cairo_t* canvas, Point top_left, double width, const Maneuver& maneuver, const Slot& slot,
                const std::vector<Leg>& legs, const Unit& unit, const std::vector<std::string>& ends) {
    const double left = top_left.x;
    const auto column = [&](double part) { return left + part * width; };
    const Columns x = {left + 7.0,    left + 22.0,   column(0.10), column(0.245), column(0.275),
                       column(0.575), column(0.665), column(0.72), column(0.745), left + width};
    const TextStyle head = {type::small, palette::faint_ink, true};
    const TextStyle head_right = {type::small, palette::faint_ink, true, Align::right};
    double y = top_left.y + row_height / 2;
    write(canvas, {left, y}, "Move", head);
    write(canvas, {x.steering, y}, "Steering", head);
    write(canvas, {x.length, y}, "Length", head_right);
    write(canvas, {x.chart, y}, "Rear axle along the slot", head);
    write(canvas, {x.heading, y}, "Heading", head_right);
    write(canvas, {x.contact, y}, "Ends where", head);
    y += row_height * 0.75;
    draw_line(canvas, {left, y}, {x.end, y}, palette::rule, line::thin);
    y += row_height * 0.75;

    const Chart chart = chart_of(x, slot, legs);
    const std::size_t left_out = legs.size() > most_rows ? legs.size() - 2 * end_rows : 0;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        if (left_out > 0 && i == end_rows) {
            write(canvas, {x.direction, y}, std::to_string(left_out) + " more moves of this kind",
                  {type::small, palette::faint_ink});
            i += left_out;
            y += row_height;
        }
        draw_row(canvas, x, y, chart, maneuver, slot, legs[i], i < ends.size() ? ends[i] : "", i + 1 == legs.size(),
                 unit);
        y += row_height;
    }
}

}  // namespace snug::drawing

namespace snug {

std::string_view called(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::front_side: return "front neighbour";
        case Obstacle::rear_side: return "rear neighbour";
        case Obstacle::front_corner: return "front slot corner";
        case Obstacle::rear_corner: return "rear slot corner";
        case Obstacle::curb: break;
    }
    return "curb";
}

}  // namespace snug
