// Where a car is along its moves, and the box it sweeps.
#include "snug/maneuver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/angles.hpp"
#include "sentences/check.hpp"

namespace snug {
namespace {

constexpr double quarter_turn = std::numbers::pi / 2.0;

/// sin(u) / u: a chord's length over its arc's, u being half the turn.
double chord_over_arc(double u) { return u == 0.0 ? 1.0 : angles::sin(u) / u; }

/// A box that grows with every point it is shown.
struct GrowingBox {
    Box box{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void cover(const Point& point) {
        box.x_min = std::min(box.x_min, point.x);
        box.x_max = std::max(box.x_max, point.x);
        box.y_min = std::min(box.y_min, point.y);
        box.y_max = std::max(box.y_max, point.y);
    }
};

/// Covers everything the frame covers on one move. The frame is the hull of its corners, and each corner runs on a
/// circle: it is farthest along an axis at an end of the move or where its velocity is square to that axis.
void cover_move(GrowingBox& swept, const Car& car, const Move& move) {
    for (const Pose& pose : {move.start, move.end}) {
        for (const Point& corner : frame(car, pose)) {
            swept.cover(corner);
        }
    }
    const double curvature = angles::tan(move.steering_angle) / car.wheelbase();
    if (curvature == 0.0) {
        return;
    }
    const double turn = static_cast<double>(move.direction) * curvature * move.length;
    const double lowest = std::min(move.start.heading, move.start.heading + turn);
    const double highest = std::max(move.start.heading, move.start.heading + turn);

    for (const Point& corner : car.outline().corners()) {
        // Seen from the car, the corner always moves the same way; it moves along an axis of the world whenever
        // heading + drift is a whole number of quarter turns.
        const double drift = angles::atan2(curvature * corner.x, 1.0 - curvature * corner.y);
        const double first = std::ceil((lowest + drift) / quarter_turn);
        for (int k = 0; k < 4; ++k) {  // a full circle has four such points
            const double heading = (first + k) * quarter_turn - drift;
            if (heading > highest) {
                break;
            }
            const double distance = std::abs((heading - move.start.heading) / curvature);
            const Pose pose = drive(car, move.start, move.direction, move.steering_angle, distance);
            const auto [s, c] = angles::sine_cosine(pose.heading);
            swept.cover({pose.x + corner.x * c - corner.y * s, pose.y + corner.x * s + corner.y * c});
        }
    }
}

}  // namespace

std::string_view to_string(CarPart part) {
    switch (part) {
        case CarPart::front_left_corner: return "front-left corner";
        case CarPart::rear_left_corner: return "rear-left corner";
        case CarPart::rear_right_corner: return "rear-right corner";
        case CarPart::front_right_corner: return "front-right corner";
        case CarPart::front_edge: return "front edge";
        case CarPart::left_edge: return "left edge";
        case CarPart::rear_edge: return "rear edge";
        case CarPart::right_edge: return "right edge";
        case CarPart::front_left_wheel: return "front-left wheel";
        case CarPart::rear_left_wheel: return "rear-left wheel";
        case CarPart::rear_right_wheel: return "rear-right wheel";
        case CarPart::front_right_wheel: return "front-right wheel";
    }
    return "";
}

std::string_view to_string(Obstacle obstacle) {
    switch (obstacle) {
        case Obstacle::front_side: return "front side";
        case Obstacle::rear_side: return "rear side";
        case Obstacle::curb: return "curb";
        case Obstacle::front_corner: return "front corner";
        case Obstacle::rear_corner: return "rear corner";
    }
    return "";
}

std::string_view to_string(Direction direction) { return direction == Direction::backward ? "backward" : "forward"; }

CarPart mirrored(CarPart part) {
    switch (part) {
        case CarPart::front_left_corner: return CarPart::front_right_corner;
        case CarPart::rear_left_corner: return CarPart::rear_right_corner;
        case CarPart::rear_right_corner: return CarPart::rear_left_corner;
        case CarPart::front_right_corner: return CarPart::front_left_corner;
        case CarPart::left_edge: return CarPart::right_edge;
        case CarPart::right_edge: return CarPart::left_edge;
        case CarPart::front_left_wheel: return CarPart::front_right_wheel;
        case CarPart::rear_left_wheel: return CarPart::rear_right_wheel;
        case CarPart::rear_right_wheel: return CarPart::rear_left_wheel;
        case CarPart::front_right_wheel: return CarPart::front_left_wheel;
        case CarPart::front_edge:
        case CarPart::rear_edge: break;
    }
    return part;
}

Pose drive(const Car& car, const Pose& start, Direction direction, double steering_angle, double distance) {
    // An arc's chord points along its mean heading; nothing here divides by the curvature, so that lines are arcs too.
    const double path = static_cast<double>(direction) * distance;
    const double turn = path * angles::tan(steering_angle) / car.wheelbase();
    const double chord = path * chord_over_arc(turn / 2.0);
    const auto [s, c] = angles::sine_cosine(start.heading + turn / 2.0);
    return {start.x + chord * c, start.y + chord * s, start.heading + turn};
}

int Maneuver::direction_changes() const {
    int changes = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        changes += moves[i].direction != moves[i - 1].direction ? 1 : 0;
    }
    return changes;
}

double Maneuver::length() const {
    double sum = 0.0;
    for (const Move& move : moves) {
        sum += move.length;
    }
    return sum;
}

std::vector<Pose> Maneuver::poses(double spacing) const {
    check_between("spacing of poses", spacing, 1e-9, std::numeric_limits<double>::infinity(), " m");
    std::vector<Pose> along;
    for (const Move& move : moves) {
        if (along.empty()) {
            along.push_back(move.start);
        }
        const double pieces = std::max(1.0, std::ceil(move.length / spacing));
        for (double i = 1.0; i < pieces; ++i) {
            along.push_back(drive(car, move.start, move.direction, move.steering_angle, move.length * (i / pieces)));
        }
        along.push_back(move.end);
    }
    return along;
}

Box swept(const Maneuver& maneuver) {
    if (maneuver.moves.empty()) {
        return {};
    }
    GrowingBox swept;
    for (const Move& move : maneuver.moves) {
        cover_move(swept, maneuver.car, move);
    }
    return swept.box;
}

Box swept(const Maneuver& maneuver, const Slot& slot) {
    Maneuver in_slot = maneuver;
    if (slot.side() == Side::left) in_slot.car = maneuver.car.mirrored();
    for (Move& move : in_slot.moves) {
        move.start = slot.to_slot(move.start);
        move.end = slot.to_slot(move.end);
        move.steering_angle = slot.mirrored(move.steering_angle);
    }
    return swept(in_slot);
}

}  // namespace snug
