// A turning car: its outline seen from the turning centre, sector by sector, and what it meets first.
//
// Both kinds of move of the paper's strategy, backward with full left and forward with full right steering, turn the car
// clockwise; other moves are mirror images. Everything here lives in the entering frame (entering.hpp).
//
// While the heading stays in one sector, between two headings at which an edge lies level or upright, the same corner of the
// outline is the lowest, the same the leftmost, the rightmost and the highest. A rectangle has four sectors, the quarter
// turns.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "contact/crossing.hpp"
#include "contact/entering.hpp"
#include "contact/few.hpp"
#include "model/angles.hpp"
#include "snug/limits.hpp"
#include "snug/maneuver.hpp"

namespace snug::detail {

/// What a turning car meets.
enum class Meets : unsigned char {
    nothing,
    front_side,
    front_corner,
    curb,
    rear_corner,
    rear_side,
    front_top,
    rear_top
};

/// The bit of Found::ahead.
constexpr unsigned bit_of(Meets meets) { return 1U << static_cast<unsigned>(meets); }

/// What touches has its root this near in order(), even where the circle only just crosses.
constexpr double near_start = 1e-2;

/// What a first contact is.
struct Found {
    double across = 0.0;  ///< the root taken: how squarely the circle crosses the line [m]
    Meets meets = Meets::nothing;
    unsigned ahead = 0;  ///< bits of everything that would be met in this sector, were nothing else in the way
    int part = -1;       ///< which corner or edge it is, by its index in the outline

    void lies_ahead(bool, Meets what) { ahead |= bit_of(what); }
    void is_first(bool, double of_across, Meets what, int of_part) {
        across = of_across;
        meets = what;
        part = of_part;
    }
};

// By force, as for vectors: what is found so far stays in registers.
#define SNUG_INLINE inline __attribute__((always_inline))
#define SNUG_LAMBDA
#include "contact/sector.inl"
#undef SNUG_INLINE
#undef SNUG_LAMBDA

/// A heading as its quarter turn and the direction within it: heading = atan2(s, c) - quarter * pi/2, c and s >= 0.
/// Turning clockwise, s falls to 0 and the next quarter begins at s = 1.
struct QuarterHeading {
    double c = 1.0;
    double s = 0.0;
    int quarter = 0;

    [[nodiscard]] double cosine() const {
        switch (quarter & 3) {
            case 0: return c;
            case 1: return s;
            case 2: return -c;
            default: return -s;
        }
    }
    [[nodiscard]] double sine() const {
        switch (quarter & 3) {
            case 0: return s;
            case 1: return -c;
            case 2: return -s;
            default: return c;
        }
    }
    /// Falls with the angle, at an even pace, and needs no trigonometry: sin - cos.
    [[nodiscard]] double order() const { return s - c; }
    [[nodiscard]] double angle() const { return angles::atan2(s, c) - quarter * limits::quarter_turn; }
};

/// That of any heading. [rad]
QuarterHeading in_quarters(double heading);

/// A corner of the outline seen from the turning centre, x along the heading of the quarter.
using TurningCorner = SeenCorner<double>;

/// The outline while the same corners lead.
struct Sector {
    double end_c = 1.0;  ///< where it ends, within its quarter turn
    double end_s = 0.0;
    double end_order = -2.0;  ///< order() there; -2 at the end of the quarter, which rounding must not cut off
    TurningCorner lowest;     ///< of the body
    TurningCorner leftmost;
    TurningCorner rightmost;
    TurningCorner at_curb;  ///< the lowest of what stops at the curb
    TurningCorner top;      ///< the highest of the frame
    /// So many edges in turn, and how near and how far from the centre a point must be to meet any of them.
    struct Edges {
        int first, count;
        double nearest_square, farthest_square;  ///< [m^2]
    };
    Edges front, rear;                         ///< from the lowest corner to the rightmost, and from the leftmost to it
    Point frame_low, frame_left, frame_right;  ///< the others of the frame, for all that counts as parked
    /// order() of the heading at which the corner at the curb is lowest, and the top is lowest; infinite if not in the sector.
    double graze_order = std::numeric_limits<double>::infinity();
    double dip_order = std::numeric_limits<double>::infinity();
};

/// An edge of the body, and how near and how far from the centre a point must be to meet it.
struct TurningEdge : SeenEdge<Plain<double>> {
    double nearest_square, farthest_square;  ///< a little less and a little more; none where nothing can enter [m^2]
    std::array<Point, 4> normal;             ///< outward, in each quarter turn that has been seen
};

/// The direction of a heading at which a sector ends, within its quarter turn.
struct Border {
    double c, s;
};

/// What does not depend on where the turning centre lies.
struct TurningShape {
    explicit TurningShape(const Problem& problem);

    /// Which corners lead downward, to the right, upward and to the left, as the car sees it in the first quarter turn; a
    /// quarter turn on each leads where the one before it did.
    using Leading = std::array<int, 4>;

    Few<Border, 4> ends;                   ///< of the sectors of any quarter
    Few<Leading, 4> body, at_curb, frame;  ///< in each sector; the latter two empty if they are the body
    Few<Point, 4> ways;                    ///< directions of the body's edges
    bool body_at_curb;                     ///< the body is what stops at the curb
    bool body_is_frame;
    bool rectangle;  ///< the body is one
};

/// The outline all around one turning centre, or as much of it as has been looked at.
struct TurningFrame {
    TurningFrame() = default;
    /// No sector seen yet. `offset`: how far the turning centre lies to the left of the rear axle's middle (negative: to the
    /// right). [m]
    TurningFrame(const Problem& problem, const TurningShape& shape, double offset);
    /// Works out the sectors of a quarter turn, unless that is done.
    void see(const TurningShape& shape, int any_quarter);

    Few<Sector, 4> sectors;     ///< quarter by quarter, as many in each, in the order of falling headings
    Few<TurningEdge, 4> edges;  ///< as the outline counts them
    int per_quarter = 1;
    bool rectangle = false;  ///< the body is one: first contacts are found more simply

    /// The sector of a quarter, counted on from the quarter's first.
    [[nodiscard]] const Sector& at(int quarter, int sector) const {
        const int counted = (quarter & 3) * per_quarter + sector;
        return sectors[static_cast<std::size_t>(counted)];
    }
    /// In which sector of its quarter a heading lies; at a border in the one that begins there.
    [[nodiscard]] int sector_of(const QuarterHeading& heading) const {
        int sector = 0;
        while (sector + 1 < per_quarter && heading.order() <= at(heading.quarter, sector).end_order) ++sector;
        return sector;
    }
    /// Outward normal of an edge in a quarter turn.
    [[nodiscard]] const Point& normal(int quarter, int edge) const {
        return edges[static_cast<std::size_t>(edge)].normal[static_cast<std::size_t>(quarter & 3)];
    }

private:
    Few<TurningCorner, 12> corners_;       ///< of the body, what stops at the curb and the frame, in the first quarter
    std::size_t at_curb_ = 0, frame_ = 0;  ///< where theirs begin
    std::array<bool, 4> seen_ = {};
};

/// Height of a corner at a heading of its quarter, the centre being at y.
inline double height_of(const TurningCorner& corner, double y, double c, double s) {
    return y + corner.x * s + corner.y * c;
}

/// First contact while turning clockwise about (x, y) within a sector of a quarter turn, from the heading (c, s): where it
/// is, if it is `found`.
Bearing first_in_sector(const TurningFrame& frame, const Sector& sector, const Problem& problem, double x, double y,
                        int quarter, double c, double s, Found& found);

/// The part of an outline at one of its corners, or along one of its edges, named by where it is.
CarPart corner_at(const Outline& outline, const Point& point);
CarPart edge_at(const Outline& outline, const Point& from, const Point& to);
/// The wheel in that quarter of the car.
CarPart wheel(CarPart corner);
/// What is met is called so in the world.
Contact contact_of(const Car& car, const Slot& slot, Enter enter, Meets meets, int part);

}  // namespace snug::detail
