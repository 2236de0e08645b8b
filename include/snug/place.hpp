// Place: where a car may drive and where it is to stand: obstacles of any shape, a region, and what counts as parked.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "snug/car.hpp"
#include "snug/driving.hpp"
#include "snug/geometry.hpp"
#include "snug/slot.hpp"

namespace snug {

/// Something to keep clear of.
struct PlaceObstacle {
    std::vector<Point> corners;  ///< a polygon in either order, convex or not [m]
    bool low = false;            ///< stops the wheels only
    std::string name = {};       ///< "curb", "front neighbour", ...
    /// What the body keeps from it [m]; empty: as everywhere. Wheels may touch what is low.
    std::optional<double> clearance = {};
};

/// Parked is: the whole car stands inside a convex polygon, within an angle of a heading.
struct ParkedInside {
    std::vector<Point> corners;          ///< in either order [m]
    double heading = 0.0;                ///< [rad]
    double heading_tolerance = 1.57079;  ///< less than a quarter turn: tail in is not nose in [rad]
    /// And the car's nearest point is at most this far from the line, if one is given.
    struct Beside {
        Point from, to;
        double distance = 0.0;  ///< [m]
    };
    std::optional<Beside> beside = {};
};

/// Parked is: at this pose, within tolerances to either side.
struct ParkedAt {
    Pose pose;
    double along = 0.0;    ///< [m]
    double across = 0.0;   ///< [m]
    double heading = 0.0;  ///< [rad]
};

struct PlaceDescription {
    std::vector<PlaceObstacle> obstacles;
    std::variant<ParkedInside, ParkedAt> parked;
    std::vector<Point> region;  ///< where the middle of the rear axle may be: a convex polygon in either order [m]
};

/// A place that can exist: at most 10,000 corners, each finite and at most 1e9 m away.
class Place {
public:
    /// Throws Error for polygons that cross themselves or have no area, for a region that is not convex, ...
    explicit Place(PlaceDescription description);

    [[nodiscard]] const std::vector<PlaceObstacle>& obstacles() const { return description_.obstacles; }
    /// Its name, or "obstacle [3]".
    [[nodiscard]] std::string name_of(std::size_t obstacle) const;
    [[nodiscard]] const std::variant<ParkedInside, ParkedAt>& parked() const { return description_.parked; }
    /// Counter-clockwise.
    [[nodiscard]] const std::vector<Point>& region() const { return description_.region; }

    /// The obstacles cut into convex pieces.
    struct Piece {
        std::vector<Point> corners;  ///< counter-clockwise
        std::size_t obstacle = 0;    ///< of which it is a part
        bool low = false;
    };
    [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

private:
    PlaceDescription description_;
    std::vector<Piece> pieces_;
};

/// A bay at a street. The slot's rectangle is `length` along the parked car by `width` across it; `angle` is between the
/// parked car and the street: 0 parallel, a quarter turn perpendicular. Entered backward the parked heading is the street's
/// plus the angle (tail in), entered forward the street's less the angle (nose in).
///
/// The slot's corner nearest to the road, of two the one ahead, is `corner`; through it runs the entry side. The neighbours
/// are the same rectangle, shifted along the street by width / sin(angle); at angle 0 they are the street's edge in front
/// and behind. A curb runs along the street at the depth of the deepest corner.
struct Street {
    double length = 0.0;              ///< [m]
    double width = 0.0;               ///< [m]
    double angle = 0.0;               ///< 0 to pi/2 [rad]
    std::optional<double> road = {};  ///< a wall along the street so far beyond the entry side [m]; empty: none
    double stretch = 10.0;          ///< how far beyond the slot, ahead and behind, the rear axle may go; without a wall
                                    ///< also how far beyond the entry side [m]
    Enter enter = Enter::backward;  ///< tail or nose first
    Side side = Side::right;        ///< of the road
    Point corner = {0.0, 0.0};      ///< [m]
    double heading = 0.0;           ///< of the street [rad]
    double front_setback = 0.0;     ///< how much deeper than the entry side the neighbour ahead begins [m]
    double rear_setback = 0.0;      ///< and the one behind [m]
    Curb curb = Curb::high;         ///< what it stops
    std::optional<double> curb_clearance = {};  ///< what the body keeps from it; empty: as everywhere [m]
    Parked parked = {};  ///< heading: off the parked one; curb: the side of the slot away from the road
};

/// The street as a place. Throws Error when a number is impossible.
Place street_place(const Street& street);

/// Where a car begins unless told otherwise: parallel to the street; for a parallel slot beside the front neighbour, 1 m
/// away from it, its rear at the slot's front end; else in the middle of the road, or of its first 6 m, past the slot
/// when it backs in and before it when it noses in.
Pose standard_start(const Street& street, const Car& car);

}  // namespace snug
