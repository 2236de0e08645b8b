// From node to node of a lattice, the way the car parks: arcs of full steering, and across a cell by turning off on the way.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/place_contact.hpp"
#include "model/angles.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail::sets {

constexpr double worth_a_step = 1e-4;  ///< of room [m]
constexpr double enough_room = 0.05;   ///< to end a move [m]

enum Steering : std::uint8_t { left, right };

struct At {
    int row = 0, column = 0;
    double y = 0.0;
};

/// Steps of full steering from a node towards the parked poses: to the row beside.
template <class Lattice>
struct Stepper {
    const Lattice& lattice;
    int way;  ///< of the rows: -1 where the car, leaving, drives forward

    Stepper(const Lattice& on, Direction leaving) : lattice(on), way(leaving == Direction::forward ? -1 : 1) {}

    [[nodiscard]] At from(const At& at, Steering steering) const {
        const int d = at.column;
        // To the left the car keeps y + r cos, to the right y - r cos. Driving back to the left the heading falls.
        const int to = steering == left ? d + way : d - way;
        const double gain =
            steering == left ? lattice.level(d) - lattice.level(to) : lattice.level(to) - lattice.level(d);
        return {at.row + way, to, at.y + gain};
    }
};

/// Adds an arc from a pose to where the heading has another sine; one with the steering of the piece before makes that longer.
inline void add_arc(std::vector<Path>& way, Pose& pose, double radius, double side, double from_sine, double to_sine,
                    Direction direction) {
    Path piece;
    piece.start = pose;
    piece.way = direction == Direction::forward ? 1.0 : -1.0;
    piece.curvature = side / radius;
    piece.length = std::abs(angles::asin(to_sine) - angles::asin(from_sine)) * radius;
    if (!(piece.length > 0.0)) return;
    if (!way.empty() && way.back().way == piece.way && way.back().curvature == piece.curvature) {
        way.back().length += piece.length;
        pose = way.back().at(way.back().length);
        return;
    }
    way.push_back(piece);
    pose = piece.at(piece.length);
}

/// Drives a step of full steering.
template <class Lattice>
void add_step(const Lattice& lattice, std::vector<Path>& way, Pose& pose, int column, Steering steering,
              Direction direction) {
    const double side = steering == left ? 1.0 : -1.0;
    const int to = column + static_cast<int>(side) * (direction == Direction::forward ? 1 : -1);
    add_arc(way, pose, lattice.radius(), side, lattice.sine(column), lattice.sine(to), direction);
}

/// Drives across a cell so that y becomes `y + wanted`: to the left by a part of an arc, right by a whole one, and left again; what
/// that gains depends on the part.
template <class Lattice>
void add_turn_off(const Lattice& lattice, std::vector<Path>& way, Pose& pose, int column, double wanted,
                  Direction direction) {
    const double r = lattice.radius(), d = lattice.h() / (2.0 * r), s = lattice.sine(column);
    const double turn = direction == Direction::forward ? 1.0 : -1.0;
    const auto cosine = [](double sine) { return std::sqrt((1.0 - sine) * (1.0 + sine)); };
    const auto gain = [&](double part) {
        return 2.0 * r * (cosine(s + turn * (part - 1.0) * d) - cosine(s + turn * part * d));
    };
    // The gain rises or falls all the way from part 0 to part 1.
    double from = 0.0, to = 1.0;
    const double sign = gain(1.0) > gain(0.0) ? 1.0 : -1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (from + to) / 2.0;
        (sign * (gain(middle) - wanted) < 0.0 ? from : to) = middle;
    }
    const double part = (from + to) / 2.0;
    const double first = s + turn * part * d, second = s + turn * (part - 1.0) * d;
    add_arc(way, pose, r, 1.0, s, first, direction);
    add_arc(way, pose, r, -1.0, first, second, direction);
    add_arc(way, pose, r, 1.0, second, s, direction);
}

}  // namespace snug::detail::sets
