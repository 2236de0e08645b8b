// StreetSizes are proved impossible range by range. Seen from where the car starts, every line of a street moves evenly with the size
// sought; so what all streets of a range have in common is what its two ends have in common, and a car that cannot park between
// those obstacles, in a slot that holds both slots, can park in none of them.
#include "snug/min_street.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "all_maneuvers/watch.hpp"
#include "model/polygon.hpp"
#include "sentences/check.hpp"
#include "snug/contact.hpp"
#include "snug/limits.hpp"
#include "snug/park.hpp"

namespace snug {

namespace {

constexpr double usual_street_part = 1.0 / 200;  ///< of the car's length: the usual resolution
constexpr double usual_road = 20.0, usual_more = 4.0;
using limits::touching;

/// What of a convex polygon lies within another, both counter-clockwise; fewer than three corners when they have no area in common.
std::vector<Point> in_common(std::vector<Point> corners, const std::vector<Point>& other) {
    for (std::size_t i = 0; i < other.size() && !corners.empty(); ++i) {
        const Point &from = other[i], &to = other[(i + 1) % other.size()];
        std::vector<Point> kept;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Point &a = corners[k], &b = corners[(k + 1) % corners.size()];
            const double at_a = detail::turn(from, to, a), at_b = detail::turn(from, to, b);
            if (at_a >= 0.0) kept.push_back(a);
            if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) {
                const double part = at_a / (at_a - at_b);
                kept.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
            }
        }
        corners = std::move(kept);
    }
    corners = detail::without_idle_corners(corners);
    if (corners.size() < 3 || !(detail::area(corners) > 1e-9)) corners.clear();
    return corners;
}

/// The smallest convex polygon around both, counter-clockwise.
std::vector<Point> around(std::vector<Point> corners, const std::vector<Point>& others) {
    corners.insert(corners.end(), others.begin(), others.end());
    std::sort(corners.begin(), corners.end(),
              [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t begin = hull.size();
        for (const Point& corner : corners) {
            while (hull.size() >= begin + 2 && detail::turn(hull[hull.size() - 2], hull.back(), corner) <= 0.0)
                hull.pop_back();
            hull.push_back(corner);
        }
        hull.pop_back();
        std::reverse(corners.begin(), corners.end());
    }
    return hull;
}

/// Streets of two sizes at once, in which the car starts at the same place: only what stands in both stops it.
Place easier_than_both(const Place& one, const Place& other) {
    PlaceDescription easier;
    for (std::size_t i = 0; i < one.pieces().size(); ++i) {
        const Place::Piece& piece = one.pieces()[i];
        std::vector<Point> corners = in_common(piece.corners, other.pieces()[i].corners);
        if (corners.empty()) continue;
        PlaceObstacle obstacle = one.obstacles()[piece.obstacle];
        obstacle.corners = std::move(corners);
        easier.obstacles.push_back(std::move(obstacle));
    }
    ParkedInside parked = std::get<ParkedInside>(one.parked());
    const ParkedInside& also = std::get<ParkedInside>(other.parked());
    parked.corners = around(parked.corners, also.corners);
    if (parked.beside) {
        const Point &from = parked.beside->from, &to = parked.beside->to;
        const double apart = detail::turn(from, to, also.beside->from) / std::hypot(to.x - from.x, to.y - from.y);
        parked.beside->distance += std::abs(apart) + touching;
    }
    easier.parked = parked;
    easier.region = around(one.region(), other.region());
    return Place(std::move(easier));
}

using detail::GivenUp;

class StreetSizes {
public:
    StreetSizes(const Car& car, const Street& street, const MinStreetOptions& options)
        : car_(car), street_(street), options_(options) {
        const double more = options.sought == StreetSize::width ? car.width() : car.length();
        largest_ = options.largest > 0.0                ? options.largest
                   : options.sought == StreetSize::road ? usual_road
                                                        : more + usual_more;
        // From there on the start no longer moves with the road.
        still_ = options.sought != StreetSize::road ? 0.0
                 : street.angle > 0.0               ? 6.0
                                                    : car.outline().right() + 1.0 + car.outline().left();
        found_.max_changes = options.max_changes;
        found_.lower = least();
    }

    MinStreet found() {
        try {
            raise();
            reach();
        } catch (const GivenUp&) {
            found_.cancelled = true;
        }
        return found_;
    }

private:
    /// No slot can be smaller, nor any road.
    [[nodiscard]] double least() const {
        if (options_.sought != StreetSize::width) return limits::shortest;
        return std::max({limits::shortest, street_.front_setback, street_.rear_setback});
    }

    [[nodiscard]] Street sized(double size) const { return with_size(street_, options_.sought, size); }

    /// Moved so that the car starts at `start`, where it would start at `at`.
    [[nodiscard]] Place seen_from(const Pose& start, Street street, const Pose& at) const {
        street.corner = {street.corner.x + start.x - at.x, street.corner.y + start.y - at.y};
        return street_place(street);
    }

    /// Where it starts in a street of that size, as the sizes up to it tell: the usual start may jump there.
    [[nodiscard]] Pose start_at(double size, double below) const {
        if (size < still_ || below >= still_) return standard_start(sized(size), car_);
        const Pose before = standard_start(sized(below), car_);
        const double aside = (street_.side == Side::right ? 0.5 : -0.5) * (size - below);
        const Slot frame({.length = 1.0, .width = 1.0, .heading = street_.heading});
        const Point from = frame.to_world(Point{0.0, 0.0}), to = frame.to_world(Point{0.0, aside});
        return {before.x + to.x - from.x, before.y + to.y - from.y, before.heading};
    }

    enum class Verdict { parks, impossible, undecided };

    [[nodiscard]] Verdict verdict(const Place& place, const Pose& start) const {
        for (const PlaceGap& gap : gaps(car_, place, start, options_.clearance))
            if (gap.distance < -touching) return Verdict::impossible;  // there is no room even to stand
        ParkOptions options;
        options.max_changes = options_.max_changes;
        options.clearance = options_.clearance;
        options.resolution = options_.resolution > 0.0 ? options_.resolution : usual_street_part * car_.length();
        options.roomiest = false;
        bool given_up = false;
        options.progress = [&](const ParkProgress& so_far) {
            given_up = options_.progress && !options_.progress(part_);
            return !given_up && !so_far.direction_changes;
        };
        const ParkAnswer answer = park(car_, place, start, options);
        if (answer.direction_changes) return Verdict::parks;
        if (given_up) throw GivenUp{};
        return answer.lower_bound > options_.max_changes ? Verdict::impossible : Verdict::undecided;
    }

    [[nodiscard]] bool parks(double size) const {
        const Street street = sized(size);
        return verdict(street_place(street), standard_start(street, car_)) == Verdict::parks;
    }

    [[nodiscard]] bool none_parks(double from, double to) const {
        const Pose start = start_at(to, from);
        const Place easier =
            easier_than_both(seen_from(start, sized(from), start_at(from, from)), seen_from(start, sized(to), start));
        return verdict(easier, start) == Verdict::impossible;
    }

    /// Proves sizes impossible from the smallest on, in steps as large as will do.
    void raise() {
        double& lower = found_.lower;
        for (double step = (largest_ - lower) / 8.0; lower < largest_;) {
            double to = std::min(lower + step, largest_);
            if (lower < still_) to = std::min(to, still_);
            part_ = 0.6 * lower / largest_;
            if (none_parks(lower, to)) {
                lower = to;
                step *= 2.0;
            } else if (step > options_.precision) {
                step = std::max(options_.precision, (to - lower) / 2.0);
            } else {
                return;
            }
        }
    }

    /// The first size above that is found to do.
    void reach() {
        double not_found = found_.lower;
        if (not_found >= largest_) return;
        for (double step = options_.precision; !found_.size && not_found < largest_; step *= 2.0) {
            const double size = std::min(found_.lower + step, largest_);
            part_ = 0.6 + 0.3 * size / largest_;
            if (parks(size)) {
                found_.size = size;
            } else {
                not_found = size;
            }
        }
        while (found_.size && *found_.size - not_found > options_.precision) {
            const double middle = not_found + (*found_.size - not_found) / 2.0;
            if (parks(middle)) {
                found_.size = middle;
            } else {
                not_found = middle;
            }
        }
    }

    const Car& car_;
    const Street& street_;
    const MinStreetOptions& options_;
    double largest_ = 0.0;
    double still_ = 0.0;  ///< in larger streets the car starts at the same place
    double part_ = 0.0;   ///< done
    MinStreet found_;
};

}  // namespace

MinStreet min_street(const Car& car, const Street& street, const MinStreetOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check_between("clearance", options.clearance, 0.0, limits::longest, " m");
    check_between("largest size", options.largest, 0.0, limits::longest, " m");
    check_between("precision", options.precision, limits::finest, limits::longest, " m");
    check_between("resolution", options.resolution, 0.0, limits::longest, " m");
    return StreetSizes(car, street, options).found();
}

std::optional<double> size_of(const Street& street, StreetSize which) {
    switch (which) {
        case StreetSize::road: return street.road;
        case StreetSize::width: return street.width;
        case StreetSize::length: break;
    }
    return street.length;
}

Street with_size(Street street, StreetSize which, double size) {
    switch (which) {
        case StreetSize::road: street.road = size; break;
        case StreetSize::width: street.width = size; break;
        case StreetSize::length: street.length = size; break;
    }
    return street;
}

std::string_view to_string(StreetSize sought) {
    switch (sought) {
        case StreetSize::road: return "road";
        case StreetSize::width: return "width";
        case StreetSize::length: break;
    }
    return "length";
}

}  // namespace snug
