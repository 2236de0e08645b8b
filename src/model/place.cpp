// Which places can exist, and the places that are bays at a street.
#include "snug/place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "model/angles.hpp"
#include "model/polygon.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {
namespace {

using limits::farthest;
using limits::quarter_turn;
constexpr std::size_t most_polygon_corners = 10000;
constexpr double endless = 200.0;  ///< how far the street's edges go on beyond the region [m]

/// Counter-clockwise and without idle corners. Throws Error unless the corners make a polygon.
std::vector<Point> checked_polygon(const std::vector<Point>& corners, const std::string& what) {
    for (const Point& corner : corners) {
        check_between(what + ": corner x", corner.x, -farthest, farthest, " m");
        check_between(what + ": corner y", corner.y, -farthest, farthest, " m");
    }
    if (corners.size() < 3)
        throw Error(what + " has " + spelled(static_cast<double>(corners.size())) + " corners, but needs at least 3");
    std::vector<Point> kept = detail::without_idle_corners(corners);
    if (detail::crosses_itself(kept)) throw Error(what + " crosses itself; cut it into polygons that do not");
    const double area = detail::area(kept);
    if (!(std::abs(area) > 1e-9)) throw Error(what + " has no area");
    if (area < 0.0) std::reverse(kept.begin(), kept.end());
    return kept;
}

std::vector<Point> checked_convex(const std::vector<Point>& corners, const std::string& what) {
    std::vector<Point> kept = checked_polygon(corners, what);
    if (!detail::is_convex(kept)) throw Error(what + " must be convex");
    return kept;
}

}  // namespace

Place::Place(PlaceDescription description) : description_(std::move(description)) {
    std::size_t corners = 0;
    for (const PlaceObstacle& obstacle : description_.obstacles) corners += obstacle.corners.size();
    if (corners > most_polygon_corners)
        throw Error("the obstacles have " + spelled(static_cast<double>(corners)) + " corners, but at most " +
                    spelled(static_cast<double>(most_polygon_corners)) + " are allowed");
    for (std::size_t i = 0; i < description_.obstacles.size(); ++i) {
        const PlaceObstacle& obstacle = description_.obstacles[i];
        if (obstacle.clearance)
            check_between("clearance of an obstacle", *obstacle.clearance, 0.0, limits::longest, " m");
        const std::string what =
            "obstacle [" + std::to_string(i) + "]" + (obstacle.name.empty() ? "" : " (" + obstacle.name + ")");
        for (std::vector<Point>& piece : detail::convex_pieces(checked_polygon(obstacle.corners, what)))
            pieces_.push_back({std::move(piece), i, obstacle.low});
    }
    description_.region = checked_convex(description_.region, "the region");
    if (auto* inside = std::get_if<ParkedInside>(&description_.parked)) {
        inside->corners = checked_convex(inside->corners, "the polygon to park in");
        check_between("parked heading", inside->heading, -farthest, farthest, " rad");
        check_between("tolerance of the parked heading", inside->heading_tolerance, 0.0, quarter_turn, " rad");
        if (inside->beside) {
            check_between("distance from the curb when parked", inside->beside->distance, 0.0, farthest, " m");
            const Point &from = inside->beside->from, &to = inside->beside->to;
            if (!(angles::hypot(to.x - from.x, to.y - from.y) > 1e-9))
                throw Error("the line to park beside has no direction");
        }
    } else {
        const auto& at = std::get<ParkedAt>(description_.parked);
        check_between("parked x", at.pose.x, -farthest, farthest, " m");
        check_between("parked y", at.pose.y, -farthest, farthest, " m");
        check_between("parked heading", at.pose.heading, -farthest, farthest, " rad");
        check_between("tolerance along", at.along, 0.0, farthest, " m");
        check_between("tolerance across", at.across, 0.0, farthest, " m");
        check_between("tolerance of the parked heading", at.heading, 0.0, quarter_turn, " rad");
    }
}

std::string Place::name_of(std::size_t obstacle) const {
    const std::string& name = description_.obstacles[obstacle].name;
    return name.empty() ? "obstacle [" + std::to_string(obstacle) + "]" : name;
}

namespace {

/// The street as if on the right, along x, with the corner at the origin; and the way into the world.
struct StreetFrame {
    explicit StreetFrame(const Street& asked) : street(asked) {
        check_between("slot length", street.length, limits::shortest, limits::longest, " m");
        check_between("slot width", street.width, limits::shortest, limits::longest, " m");
        check_between("angle", street.angle, 0.0, quarter_turn, " rad");
        if (street.road) check_between("road", *street.road, limits::shortest, limits::longest, " m");
        check_between("stretch", street.stretch, 0.0, 1e4, " m");
        check_between("slot corner x", street.corner.x, -farthest, farthest, " m");
        check_between("slot corner y", street.corner.y, -farthest, farthest, " m");
        check_between("slot heading", street.heading, -farthest, farthest, " rad");
        check_between("front setback", street.front_setback, 0.0, street.width, " m");
        check_between("rear setback", street.rear_setback, 0.0, street.width, " m");
        if (street.curb_clearance) check_between("curb clearance", *street.curb_clearance, 0.0, limits::longest, " m");
        check(street.parked);
        parked = street.enter == Enter::backward ? street.angle : -street.angle;
        const auto [sine, cosine] = angles::sine_cosine(parked);
        const auto at = [&, s = sine, c = cosine](double along, double across) {
            return Point{along * c - across * s, along * s + across * c};
        };
        bay = {at(0.0, 0.0), at(street.length, 0.0), at(street.length, street.width), at(0.0, street.width)};
        Point top = bay[0];
        for (const Point& corner : bay) {
            const double level = 1e-9 * (street.length + street.width);
            if (corner.y > top.y + level || (corner.y > top.y - level && corner.x > top.x)) top = corner;
        }
        for (Point& corner : bay) {
            corner = {corner.x - top.x, corner.y - top.y};
            low = std::min(low, corner.y);
            rear = std::min(rear, corner.x);
            front = std::max(front, corner.x);
        }
    }

    [[nodiscard]] Slot slot() const {
        return Slot({.length = street.length,
                     .width = street.width,
                     .side = street.side,
                     .corner = street.corner,
                     .heading = street.heading});
    }
    [[nodiscard]] std::vector<Point> to_world(const std::vector<Point>& corners) const {
        std::vector<Point> there;
        for (const Point& corner : corners) there.push_back(slot().to_world(corner));
        return there;
    }

    const Street& street;
    double parked = 0.0;                        ///< heading
    std::vector<Point> bay;                     ///< rear right corner first, counter-clockwise
    double low = 0.0, rear = 0.0, front = 0.0;  ///< extents
};

std::vector<Point> box(double x_min, double x_max, double y_min, double y_max) {
    return {{x_min, y_min}, {x_max, y_min}, {x_max, y_max}, {x_min, y_max}};
}

}  // namespace

Place street_place(const Street& street) {
    const StreetFrame frame(street);
    const double ahead = frame.front + street.stretch;
    const double behind = frame.rear - street.stretch;
    const double across = street.road.value_or(street.stretch);
    PlaceDescription place;
    const auto add = [&](const std::vector<Point>& corners, bool low, const char* name) {
        place.obstacles.push_back({frame.to_world(corners), low, name, {}});
    };
    const double sine = angles::sin(street.angle);
    if (street.angle == 0.0) {
        add(box(0.0, ahead + endless, frame.low - endless, -street.front_setback), false, "front neighbour");
        add(box(behind - endless, frame.rear, frame.low - endless, -street.rear_setback), false, "rear neighbour");
    } else {
        const auto neighbour = [&](double by, double setback) {
            std::vector<Point> corners = frame.bay;
            const double deeper = setback / sine;
            const double way = street.enter == Enter::backward ? -1.0 : 1.0;
            for (Point& corner : corners)
                corner = {corner.x + by + way * deeper * angles::cos(frame.parked),
                          corner.y + way * deeper * angles::sin(frame.parked)};
            return corners;
        };
        add(neighbour(street.width / sine, street.front_setback), false, "front neighbour");
        add(neighbour(-street.width / sine, street.rear_setback), false, "rear neighbour");
    }
    add(box(behind - endless, ahead + endless, frame.low - endless, frame.low), street.curb == Curb::low, "curb");
    place.obstacles.back().clearance = street.curb_clearance;
    if (street.road) add(box(behind - endless, ahead + endless, across, across + endless), false, "far side");

    ParkedInside parked;
    parked.corners = frame.to_world(frame.bay);
    parked.heading = street.heading + frame.slot().mirrored(frame.parked);
    parked.heading_tolerance = std::min(street.parked.heading, 1.57079);
    if (std::isfinite(street.parked.curb)) {
        // The side away from the road: along the car when it stands parallel, across it else.
        const std::size_t at = street.angle == 0.0 ? 0 : street.enter == Enter::backward ? 3 : 1;
        parked.beside = ParkedInside::Beside{parked.corners[at], parked.corners[(at + 1) % 4], street.parked.curb};
    }
    place.parked = parked;
    place.region = frame.to_world(box(behind, ahead, frame.low, across));
    return Place(std::move(place));
}

Pose standard_start(const Street& street, const Car& car) {
    const StreetFrame frame(street);
    if (street.angle == 0.0) {
        // Where the road is too narrow for that, in the middle of it.
        const bool right = street.side == Side::right;
        const double slot_side = right ? car.outline().right() : car.outline().left();
        const double road_side = right ? car.outline().left() : car.outline().right();
        const double aside = slot_side + 1.0;
        const bool fits = !street.road || aside + road_side <= *street.road;
        return frame.slot().to_world(Pose{car.rear(), fits ? aside : *street.road / 2.0, 0.0});
    }
    const double middle = std::min(street.road.value_or(6.0), 6.0) / 2.0;
    const double x = street.enter == Enter::backward ? car.rear() : frame.rear - car.front();
    return frame.slot().to_world(Pose{x, middle, 0.0});
}

}  // namespace snug
