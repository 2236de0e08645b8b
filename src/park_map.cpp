// From every pose into a place: what one sweep outward from the parked poses holds, looked up.
#include "snug/park_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/few_pieces.hpp"
#include "all_maneuvers/sets/map_sets.hpp"
#include "all_maneuvers/sets/packing.hpp"
#include "all_maneuvers/sets/route.hpp"
#include "all_maneuvers/sets/way_lists.hpp"
#include "contact/place_contact.hpp"
#include "in_world.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"
#include "snug/version.hpp"

namespace snug {

using namespace detail::sets;
using detail::GivenUp;
using detail::Watch;

namespace {

using limits::half_turn;
using limits::touching;

ParkMapOptions of_street(const Street& street, const ParkMapOptions& options) {
    ParkMapOptions mine = options;
    if (!mine.heading) mine.heading = street.heading;
    return mine;
}

double coarsest_spacing(const Car& car) { return car.turning_radius() / 32.0; }
double usual_spacing(const Car& car) { return std::min(0.08, coarsest_spacing(car)); }

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

    Swept(const Car& of, const Place& in, const ParkMapOptions& how, const Watch& watch)
        : car(of),
          place(in),
          options(how),
          here(chart_place(of, in, anywhere(in, how.heading.value_or(heading_of(in))), how.clearance, chart)),
          outer(here, how.spacing, watch),
          inner(here, how.spacing, watch) {
        outer.settle();
        inner.settle();
    }
    Swept(const Car& of, const Place& in, const ParkMapOptions& how, detail::Unpacking& from)
        : car(of),
          place(in),
          options(how),
          here(chart_place(of, in, anywhere(in, how.heading.value_or(heading_of(in))), how.clearance, chart)),
          outer(from),
          inner(here, from) {}

    /// One level more, of those that are counted.
    template <class Map>
    bool sweep_on(Map& map, const Watch& watch) {
        return map.most() < options.max_changes && map.sweep_on(watch);
    }
    /// As far as it takes to know of a free pose in the chart.
    void sweep_for(const Pose& pose, const Watch& watch) {
        while (outer.changes_at(pose) > outer.most() && sweep_on(outer, watch)) outer.settle();
        while (!inner.joining(pose) && sweep_on(inner, watch)) inner.settle();
    }
    void sweep(const Watch& watch) {
        while (sweep_on(outer, watch)) {
        }
        while (sweep_on(inner, watch)) {
        }
        outer.finish();
        inner.finish();
    }

    /// In the chart; where the heading is not covered the cosine is not positive.
    [[nodiscard]] Pose in_chart(const Pose& pose) const {
        Pose at = chart.to_chart(pose);
        at.heading = std::remainder(at.heading, 2.0 * half_turn);
        return at;
    }
};

namespace {

/// Tells who can read what follows, what was asked, and whether the bytes are the same still.
struct PackedHead {
    std::uint64_t version = 0, asked = 0, sum = 0;
};

PackedHead head_of(const Car& car, const Place& place, const ParkMapOptions& options) {
    Fingerprint version, asked;
    for (const char c : std::string("snug map " SNUG_VERSION)) version.add(static_cast<std::uint64_t>(c));
    version.add(static_cast<std::uint64_t>(sizeof(std::size_t)));
    version.add(1.0);  // the order of its bytes
    asked.add(ParkMap::fingerprint(car, place, options.clearance));
    asked.add(options.spacing);
    asked.add(static_cast<std::uint64_t>(options.max_changes));
    asked.add(options.heading);
    return {version.value(), asked.value(), 0};
}

/// Eight bytes at a time.
std::uint64_t sum_of(const std::byte* from, std::size_t size) {
    std::uint64_t sum = size, word = 0;
    const auto add = [&] {
        sum = (sum ^ word) * 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio: no bit of the word is lost
        sum ^= sum >> 32;
    };
    std::size_t i = 0;
    for (; i + sizeof word <= size; i += sizeof word) {
        std::memcpy(&word, from + i, sizeof word);
        add();
    }
    word = 0;
    std::memcpy(&word, from + i, size - i);
    add();
    return sum;
}

}  // namespace

std::vector<std::byte> ParkMap::packed() const {
    PackedHead head = head_of(swept_->car, swept_->place, swept_->options);
    detail::Packing pack(this->bytes() + 65536);
    pack(head, swept_->outer, swept_->inner);
    head.sum = sum_of(pack.bytes.data() + sizeof head, pack.bytes.size() - sizeof head);
    std::memcpy(pack.bytes.data(), &head, sizeof head);
    return std::move(pack.bytes);
}

ParkMap ParkMap::unpacked(const Car& car, const Place& place, const ParkMapOptions& options,
                          std::span<const std::byte> bytes) {
    ParkMapOptions asked = options;
    if (asked.spacing == 0.0) asked.spacing = usual_spacing(car);
    detail::Unpacking unpack(bytes);
    PackedHead head;
    unpack(head);
    const PackedHead expected = head_of(car, place, asked);
    if (head.version != expected.version)
        throw Error("these bytes are no map of this version (" SNUG_VERSION ") on this kind of machine; pack it anew");
    if (head.asked != expected.asked)
        throw Error("the packed map is another one; unpack it with what it was made with");
    if (head.sum != sum_of(bytes.data() + sizeof head, bytes.size() - sizeof head))
        throw Error("the packed map is damaged; pack it again");
    ParkMap map(std::make_shared<const Swept>(car, place, asked, unpack));
    if (unpack.left() > 0) throw Error("the packed map is longer than a map; pack it again");
    return map;
}

ParkMap ParkMap::unpacked(const Car& car, const Street& street, const ParkMapOptions& options,
                          std::span<const std::byte> bytes) {
    return unpacked(car, street_place(street), of_street(street, options), bytes);
}

ParkMap::ParkMap(const Car& car, const Place& place, const ParkMapOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check_between("clearance", options.clearance, 0.0, limits::longest, " m");
    constexpr double finest = 0.001;  // [m]
    ParkMapOptions asked = options;
    asked.progress = {};
    asked.first = {};
    if (asked.spacing == 0.0) asked.spacing = usual_spacing(car);
    check_between("spacing", asked.spacing, finest, coarsest_spacing(car), " m");
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
    const Watch watch = [&] {
        if (options.progress && !options.progress()) throw GivenUp{};
    };
    try {
        const auto swept = std::make_shared<Swept>(car, place, asked, watch);
        swept_ = swept;
        if (options.first) {
            const Pose& pose = options.first->pose;
            if (const MapBounds none = at(pose); none.where == MapBounds::free && none.direction_changes != 0)
                swept->sweep_for(swept->in_chart(pose), watch);
            options.first->known(*this);
        }
        swept->sweep(watch);
    } catch (const GivenUp&) {
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
    if (bounds.impossible) bounds.lower_bound = map.options.max_changes + 1;
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
