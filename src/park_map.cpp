// From every pose into a place: what one sweep outward from the parked poses holds, looked up.
#include "snug/park_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "all_maneuvers/few_pieces.hpp"
#include "all_maneuvers/map_sets.hpp"
#include "all_maneuvers/route.hpp"
#include "all_maneuvers/way_lists.hpp"
#include "contact/place_contact.hpp"
#include "in_world.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

using namespace detail::sets;

namespace {

using limits::half_turn;
using limits::touching;

ParkMapOptions of_street(const Street& street, const ParkMapOptions& options) {
    ParkMapOptions mine = options;
    if (!mine.heading) mine.heading = street.heading;
    return mine;
}

double heading_of(const Place& place) {
    const auto* inside = std::get_if<ParkedInside>(&place.parked());
    return inside ? inside->heading : std::get<ParkedAt>(place.parked()).pose.heading;
}

/// Somewhere in the region, for there is no start.
Pose anywhere(const Place& place, double heading) {
    const Point& corner = place.region()[0];
    return {corner.x, corner.y, heading};
}

/// Fowler, Noll and Vo's hash of numbers, bit by bit (FNV-1a, 64 bits).
class Fingerprint {
public:
    void add(std::uint64_t bits) {
        for (int i = 0; i < 8; ++i, bits >>= 8) hash_ = (hash_ ^ (bits & 0xFF)) * 0x100000001B3;
    }
    void add(double number) {
        const double same = number == 0.0 ? 0.0 : number;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &same, sizeof bits);
        add(bits);
    }
    void add(const Point& p) {
        add(p.x);
        add(p.y);
    }
    void add(const std::vector<Point>& corners) {
        add(static_cast<std::uint64_t>(corners.size()));
        for (const Point& p : corners) add(p);
    }
    void add(const std::optional<double>& number) {
        add(static_cast<std::uint64_t>(number.has_value()));
        add(number.value_or(0.0));
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xCBF29CE484222325;
};

}  // namespace

struct ParkMap::Swept {
    Car car;
    Place place;
    ParkMapOptions options;
    Chart chart;
    ChartPlace here;
    OuterMap outer;
    InnerMap inner;

    Swept(const Car& of, const Place& in, const ParkMapOptions& how, const Watching& watch)
        : car(of),
          place(in),
          options(how),
          here(chart_place(of, in, anywhere(in, how.heading.value_or(heading_of(in))), how.clearance, chart)),
          outer(here, how.spacing, how.max_changes, watch),
          inner(here, how.spacing, how.max_changes, watch) {}

    /// In the chart; where the heading is not covered the cosine is not positive.
    [[nodiscard]] Pose in_chart(const Pose& pose) const {
        Pose at = chart.to_chart(pose);
        at.heading = std::remainder(at.heading, 2.0 * half_turn);
        return at;
    }
};

ParkMap::ParkMap(const Car& car, const Place& place, const ParkMapOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check_between("clearance", options.clearance, 0.0, limits::longest, " m");
    constexpr double usual = 0.08, finest = 0.001;  // [m]
    const double coarsest = car.turning_radius() / 32.0;
    ParkMapOptions asked = options;
    if (asked.spacing == 0.0) asked.spacing = std::min(usual, coarsest);
    check_between("spacing", asked.spacing, finest, coarsest, " m");
    if (options.heading)
        check_between("heading of the street", *options.heading, -limits::farthest, limits::farthest, " rad");
    Chart chart;
    const double heading = options.heading.value_or(heading_of(place));
    const ChartPlace here = chart_place(car, place, anywhere(place, heading), options.clearance, chart);
    if (std::abs(here.start.heading) > half_turn * 75.0 / 180.0)
        throw Error(
            "the street's heading and the parked one are more than 150 degrees apart; name the nearer of the two "
            "directions of the street");
    constexpr double most_map_cells = 4e6;
    const double cells = (here.x_max - here.x_min) * 2.0 * here.radius / (asked.spacing * asked.spacing);
    if (cells > most_map_cells)
        throw Error("the region is " + spelled(std::round(here.x_max - here.x_min)) + " m long: at a spacing of " +
                    spelled(asked.spacing) + " m its map would take " + spelled(std::round(cells / 1e5) / 10.0) +
                    " million cells, but at most " + spelled(most_map_cells / 1e6) +
                    " million are supported; name a smaller region, or a coarser spacing");
    const double reach = std::max(std::abs(here.y_min), std::abs(here.y_max));
    if (reach > farthest_y || here.radius > 40.0)
        throw Error("the region reaches " + spelled(std::round(reach)) + " m to either side, but at most " +
                    spelled(farthest_y) + " are supported; name a smaller one");
    const Watching watch = [&] {
        if (options.progress && !options.progress()) throw Stopped{};
    };
    try {
        swept_ = std::make_shared<const Swept>(car, place, asked, watch);
    } catch (const Stopped&) {
        throw Error("the map was given up before it was done");
    }
}

ParkMap::ParkMap(const Car& car, const Street& street, const ParkMapOptions& options)
    : ParkMap(car, street_place(street), of_street(street, options)) {}

MapBounds ParkMap::at(const Pose& pose) const {
    const Swept& map = *swept_;
    MapBounds bounds;
    if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) return bounds;
    const Pose here = map.in_chart(pose);
    if (std::abs(here.heading) > half_turn / 2.0 || std::abs(angles::sin(here.heading)) > detail::sets::steepest_sine)
        return bounds;
    for (const HalfPlane& edge : map.here.region)
        if (edge.normal.x * here.x + edge.normal.y * here.y > edge.offset + touching) return bounds;
    bounds.where = MapBounds::blocked;
    if (!is_clear(map.here, here)) return bounds;
    bounds.where = MapBounds::free;
    if (is_parked(map.here, here)) {
        bounds.direction_changes = 0;
        return bounds;
    }
    bounds.lower_bound = map.outer.changes_at(here);
    bounds.impossible = map.outer.complete() && bounds.lower_bound > map.outer.most();
    if (bounds.lower_bound > map.outer.most()) bounds.lower_bound = map.options.max_changes + 1;
    if (const std::optional<Joining> joining = map.inner.joining(here)) {
        bounds.direction_changes = joining->changes;
        bounds.first = joining->direction;
    }
    return bounds;
}

std::optional<Maneuver> ParkMap::maneuver(const Pose& pose) const {
    detail::WayLists lists;
    std::vector<Move> way;
    moves(pose, lists, way);
    if (way.empty()) return std::nullopt;
    return Maneuver{swept_->car, std::move(way)};
}

void ParkMap::moves(const Pose& pose, detail::WayLists& lists, std::vector<Move>& moves) const {
    moves.clear();
    const Swept& map = *swept_;
    const MapBounds bounds = at(pose);
    if (!bounds.first) return;
    const Pose here = map.in_chart(pose);
    const std::optional<Joining> joining = map.inner.joining(here);
    if (!joining) return;
    map.inner.way(here, *joining, lists.steps);
    with_few_pieces(map.here, lists.steps, lists.few);
    const std::vector<detail::Path>& way = lists.few;
    if (way.empty() || !is_parked(map.here, way.back().at(way.back().length))) return;
    for (const detail::Path& piece : way)
        if (!is_free(map.here, piece)) return;
    detail::in_world(map.car, pose, way, moves);
}

bool ParkMap::goes_free(const Pose& pose, Direction direction, double steering_angle, double length) const {
    const Swept& map = *swept_;
    const Pose here = map.in_chart(pose);
    const double curvature =
        steering_angle == 0.0 ? 0.0 : angles::sin(steering_angle) / angles::cos(steering_angle) / map.car.wheelbase();
    return is_clear(map.here, here) &&
           is_free(map.here, detail::Path{here, curvature, direction == Direction::forward ? 1.0 : -1.0, length});
}

const Car& ParkMap::car() const { return swept_->car; }
const Place& ParkMap::place() const { return swept_->place; }
double ParkMap::spacing() const { return swept_->options.spacing; }
double ParkMap::clearance() const { return swept_->options.clearance; }
int ParkMap::max_changes() const { return swept_->options.max_changes; }
double ParkMap::middle_heading() const { return swept_->chart.turned; }
std::size_t ParkMap::bytes() const { return swept_->outer.bytes() + swept_->inner.bytes(); }

std::uint64_t ParkMap::fingerprint() const {
    return fingerprint(swept_->car, swept_->place, swept_->options.clearance);
}

std::uint64_t ParkMap::fingerprint(const Car& car, const Place& place, double clearance) {
    Fingerprint print;
    print.add(car.outline().corners());
    print.add(car.wheels().corners());
    print.add(car.wheelbase());
    print.add(car.max_steer());
    for (const PlaceObstacle& obstacle : place.obstacles()) {
        print.add(obstacle.corners);
        print.add(static_cast<std::uint64_t>(obstacle.low));
        print.add(obstacle.clearance);
    }
    if (const auto* inside = std::get_if<ParkedInside>(&place.parked())) {
        print.add(inside->corners);
        print.add(inside->heading);
        print.add(inside->heading_tolerance);
        if (inside->beside) {
            print.add(inside->beside->from);
            print.add(inside->beside->to);
            print.add(inside->beside->distance);
        }
    } else {
        const auto& parked = std::get<ParkedAt>(place.parked());
        for (const double number :
             {parked.pose.x, parked.pose.y, parked.pose.heading, parked.along, parked.across, parked.heading})
            print.add(number);
    }
    print.add(place.region());
    print.add(clearance);
    return print.value();
}

void ParkMap::expect(const Car& car, const Place& place, double clearance) const {
    if (fingerprint() == fingerprint(car, place, clearance)) return;
    const bool same_car = fingerprint() == fingerprint(car, swept_->place, swept_->options.clearance);
    const bool same_place = fingerprint() == fingerprint(swept_->car, place, swept_->options.clearance);
    const char* differs = same_car && same_place ? "with another clearance"
                          : same_car             ? "of another place"
                          : same_place           ? "of another car"
                                                 : "of another car and place";
    throw Error(std::string("the map is ") + differs + "; make a new one");
}

}  // namespace snug
