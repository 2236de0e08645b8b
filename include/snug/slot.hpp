// Slot: the gap between two parked cars, and the frame of reference the solver works in.
#pragma once

#include <string_view>

#include "snug/geometry.hpp"

namespace snug {

/// The side of the road the slot lies on, seen in the driving direction.
enum class Side { right, left };

/// What the curb stops: the whole car, or only its wheels, so that the body may pass over it.
enum class Curb { high, low };

/// "right", "left"; "high", "low"
std::string_view to_string(Side side);
std::string_view to_string(Curb curb);

/// The paper's parallel parking slot P = (p, delta, W, L), section 2.1, and what real ones have beside it.
struct SlotDimensions {
    double length = 0.0;         ///< L: along the road [m]
    double width = 0.0;          ///< W: from the road to the curb [m]
    Side side = Side::right;     ///< which side of the road
    Point corner = {0.0, 0.0};   ///< p: the front corner on the entry side [m]
    double heading = 0.0;        ///< heading of a car parked parallel, delta + pi [rad]
    double front_setback = 0.0;  ///< how much deeper than the entry side the front neighbour begins, 0 to the width [m]
    double rear_setback = 0.0;   ///< likewise the rear neighbour [m]
    Curb curb = Curb::high;      ///< what the curb stops

    friend bool operator==(const SlotDimensions&, const SlotDimensions&) = default;
};

/// A slot that can exist: length and width lie between 1e-6 and 1e6 m, corner and heading are finite (at most 1e9).
///
/// The slot frame has its origin at the corner p, x along the parallel heading and y towards the road. There every slot
/// is [-L, 0] x [-W, 0] with the neighbours {x > 0, y < -front setback} and {x < -L, y < -rear setback} and the curb
/// {y < -W}; a slot on the left is its mirror image, with headings and steering angles negated.
class Slot {
public:
    /// Throws Error when a dimension is impossible.
    explicit Slot(const SlotDimensions& dimensions);

    [[nodiscard]] double length() const { return dimensions_.length; }
    [[nodiscard]] double width() const { return dimensions_.width; }
    [[nodiscard]] Side side() const { return dimensions_.side; }
    [[nodiscard]] Point corner() const { return dimensions_.corner; }
    [[nodiscard]] double heading() const { return dimensions_.heading; }
    [[nodiscard]] double front_setback() const { return dimensions_.front_setback; }
    [[nodiscard]] double rear_setback() const { return dimensions_.rear_setback; }
    [[nodiscard]] Curb curb() const { return dimensions_.curb; }
    [[nodiscard]] const SlotDimensions& dimensions() const { return dimensions_; }

    /// From the slot frame to the world and back. Headings are not wrapped.
    [[nodiscard]] Pose to_world(const Pose& in_slot) const;
    [[nodiscard]] Pose to_slot(const Pose& in_world) const;
    [[nodiscard]] Point to_world(const Point& in_slot) const;
    [[nodiscard]] Point to_slot(const Point& in_world) const;
    /// A steering angle (positive to the left) in the world for one in the slot frame, or the reverse. [rad]
    [[nodiscard]] double mirrored(double steering_angle) const {
        return dimensions_.side == Side::left ? -steering_angle : steering_angle;
    }

    friend bool operator==(const Slot&, const Slot&) = default;

private:
    SlotDimensions dimensions_;
};

}  // namespace snug
