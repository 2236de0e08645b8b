// The next move from a measured pose.
#include "snug/assistant.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/way_lists.hpp"
#include "contact/edge_gaps.hpp"
#include "contact/few.hpp"
#include "contact/place_contact.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {
namespace {

/// A convex polygon with every edge moved inward.
std::vector<Point> shrunk(std::vector<Point> corners, double by) {
    double area = 0.0;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point& a = corners[i];
        const Point& b = corners[(i + 1) % n];
        area += a.x * b.y - a.y * b.x;
    }
    if (area < 0.0) std::reverse(corners.begin(), corners.end());
    struct Line {
        Point normal;  ///< outward
        double offset;
    };
    std::vector<Line> lines;
    for (std::size_t i = 0; i < n; ++i) {
        const Point& a = corners[i];
        const Point& b = corners[(i + 1) % n];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const Point normal = {(b.y - a.y) / length, (a.x - b.x) / length};
        lines.push_back({normal, normal.x * a.x + normal.y * a.y - by});
    }
    std::vector<Point> inner;
    for (std::size_t i = 0; i < n; ++i) {
        const Line& p = lines[(i + n - 1) % n];
        const Line& q = lines[i];
        const double cross = p.normal.x * q.normal.y - p.normal.y * q.normal.x;
        inner.push_back({(p.offset * q.normal.y - q.offset * p.normal.y) / cross,
                         (p.normal.x * q.offset - q.normal.x * p.offset) / cross});
    }
    return inner;
}

/// The place in which the car has to stand farther inside to be parked.
Place planned_place(const Place& place, double inside_by) {
    PlaceDescription planned = {place.obstacles(), place.parked(), place.region()};
    if (auto* inside = std::get_if<ParkedInside>(&planned.parked)) {
        inside->corners = shrunk(inside->corners, inside_by);
    } else {
        auto& at = std::get<ParkedAt>(planned.parked);
        at.along = std::max(0.0, at.along - inside_by);
        at.across = std::max(0.0, at.across - inside_by);
    }
    return Place(std::move(planned));
}

Car planned_car(const Car& car, double steering_reserve) {
    if (steering_reserve == 0.0) return car;
    return Car(car.outline(), car.wheelbase(), car.max_steer() - steering_reserve, car.name());
}

void check(const Car& car, const AssistantOptions& options) {
    check_between("margin", options.margin, 0.0, limits::longest, " m");
    check_between("steering reserve", options.steering_reserve, 0.0, car.max_steer() / 2.0, " rad");
}

ParkMap planned_map(const Car& car, const Place& place, const AssistantOptions& options) {
    check(car, options);
    ParkMapOptions map;
    map.spacing = options.spacing;
    map.clearance = options.margin;
    map.heading = options.heading;
    return ParkMap(planned_car(car, options.steering_reserve), planned_place(place, options.margin / 2.0), map);
}

constexpr int most_halvings = 8;  ///< of 2 cm of a way out, until it is shown that nothing grows

AssistantOptions of_street(const Street& street, AssistantOptions options) {
    if (!options.heading) options.heading = street.heading;
    return options;
}

}  // namespace

struct AssistantMemory::Lists {
    detail::WayLists way;
    std::vector<double> here, before, now;  ///< gaps along all edges
    std::vector<double> floors;             ///< gaps that may not fall
    std::vector<double> halves;             ///< gaps along the edges of one, in between
    Instruction told;
    std::size_t looked = 0;

    void reserve(const Assistant& assistant);
};

void AssistantMemory::Lists::reserve(const Assistant& assistant) {
    std::size_t all = 0, most = 0;
    for (const Assistant::Around& around : assistant.around_) {
        const std::size_t edges = around.shape.size() + around.solid.size();
        all += edges;
        most = std::max(most, edges);
    }
    for (std::vector<double>* gaps : {&here, &before, &now}) gaps->resize(all);
    floors.resize(assistant.around_.size());
    halves.resize(most_halvings * most);
}

AssistantMemory::AssistantMemory(const Assistant& assistant) : lists_(std::make_unique<Lists>()) {
    // As long as a way through a large map gets: a node every few centimetres, with three arcs at most.
    constexpr std::size_t most_pieces = 8192;
    lists_->way.steps.reserve(most_pieces);
    lists_->way.few.reserve(most_pieces);
    lists_->told.moves.reserve(most_pieces);
    lists_->reserve(assistant);
}
AssistantMemory::AssistantMemory(AssistantMemory&&) noexcept = default;
AssistantMemory& AssistantMemory::operator=(AssistantMemory&&) noexcept = default;
AssistantMemory::~AssistantMemory() = default;

std::size_t AssistantMemory::poses_looked_at() const { return lists_->looked; }

Assistant::Assistant(const Car& car, const Place& place, const AssistantOptions& options)
    : Assistant(car, place, planned_map(car, place, options), options) {}

Assistant::Assistant(const Car& car, const Street& street, const AssistantOptions& options)
    : Assistant(car, street_place(street), of_street(street, options)) {}

Assistant::Assistant(const Car& car, const Place& place, ParkMap map, const AssistantOptions& options)
    : car_(car), place_(place), map_(std::move(map)) {
    check(car, options);
    map_.expect(planned_car(car, options.steering_reserve), planned_place(place, options.margin / 2.0), options.margin);
    for (const Place::Piece& piece : place_.pieces()) {
        const double keeps = piece.low ? 0.0 : place_.obstacles()[piece.obstacle].clearance.value_or(0.0);
        const Outline shape = piece.low ? car_.wheels() : car_.outline().grown(keeps);
        Around around = {
            shape.corners(),
            piece.corners,
            detail::outward_normals(shape.corners()),
            detail::outward_normals(piece.corners),
            around_.empty() ? 0 : around_.back().begin + around_.back().shape.size() + around_.back().solid.size(),
            piece.corners[0],
            piece.corners[0]};
        for (const Point& p : around.solid) {
            around.low = {std::min(around.low.x, p.x), std::min(around.low.y, p.y)};
            around.high = {std::max(around.high.x, p.x), std::max(around.high.y, p.y)};
        }
        for (const Point& p : around.shape) around.reach = std::max(around.reach, std::hypot(p.x, p.y));
        around_.push_back(std::move(around));
    }
}

/// From one of those, negative in it.
double Assistant::gap(const Around& around, const Pose& pose) {
    const auto [s, c] = angles::sine_cosine(pose.heading);
    // About the car's own place, where numbers stay small even if the place lies far out in the world.
    detail::Few<Point, 64> shape, solid;
    for (const Point& p : around.shape) shape.push_back({p.x * c - p.y * s, p.x * s + p.y * c});
    for (const Point& p : around.solid) solid.push_back({p.x - pose.x, p.y - pose.y});
    return detail::distance(shape.data(), shape.size(), solid.data(), solid.size());
}

void Assistant::gaps_along_edges(const Around& around, const Pose& pose, double* gaps) {
    const auto [s, c] = angles::sine_cosine(pose.heading);
    detail::for_each_edge_gap(around.shape, around.shape_normals, around.solid, around.solid_normals, pose, s, c,
                              [&gaps](double gap) { *gaps++ = gap; });
}

double Assistant::nearest(const Pose& pose) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Around& around : around_) {
        const double apart =
            std::max({around.low.x - pose.x, pose.x - around.high.x, around.low.y - pose.y, pose.y - around.high.y}) -
            around.reach;
        if (apart > 0.0 && apart >= least) continue;  // none of it is nearer
        least = std::min(least, gap(around, pose));
    }
    return least;
}

std::optional<Maneuver> Assistant::plan(const Pose& measured) const { return map_.maneuver(measured); }

/// On average over where the car may truly come to rest.
double Assistant::expected_changes(const Pose& end, Direction driven, std::size_t& looked) const {
    constexpr double along = 0.02, across = 0.012, turned = 0.006;
    constexpr double unknown = 4.0;
    const double s = angles::sin(end.heading), c = angles::cos(end.heading);
    const auto changes_at = [&](double x, double y, double heading) {
        ++looked;
        const MapBounds bounds = map_.at({end.x + x * c - y * s, end.y + x * s + y * c, end.heading + heading});
        if (!bounds.direction_changes) return unknown;
        return *bounds.direction_changes + (bounds.first && *bounds.first != driven ? 1.0 : 0.0);
    };
    double sum = 2.0 * changes_at(0.0, 0.0, 0.0);
    for (const double way : {1.0, -1.0})
        sum +=
            changes_at(way * along, 0.0, 0.0) + changes_at(0.0, way * across, 0.0) + changes_at(0.0, 0.0, way * turned);
    return sum / 8.0;
}

/// Ends an arc where coming to rest a little off does the least harm.
void Assistant::settle(Move& last, std::size_t& looked) const {
    const Move meant = last;
    constexpr double step = 0.01, farthest = 0.3;  // [m]
    constexpr double worth_a_metre = 0.2;          // of direction changes
    double least = expected_changes(meant.end, meant.direction, looked);
    for (const double way : {-1.0, 1.0}) {
        for (int i = 1; i * step <= farthest; ++i) {
            Move other = meant;
            other.length = meant.length + way * i * step;
            if (!(other.length > 0.0)) break;
            other.end = drive(car_, meant.start, meant.direction, meant.steering_angle, other.length);
            if (way > 0.0 && map_.at(other.end).where != MapBounds::free) break;
            const double cost = expected_changes(other.end, other.direction, looked) + worth_a_metre * i * step;
            if (cost >= least) continue;
            if (way > 0.0 && !map_.goes_free(meant.start, meant.direction, meant.steering_angle, other.length)) break;
            least = cost;
            last = other;
        }
    }
}

Instruction Assistant::next(const Pose& measured, std::optional<Direction> driven) const {
    Lists lists;
    lists.reserve(*this);
    answer(measured, driven, lists);
    return std::move(lists.told);
}

const Instruction& Assistant::next(const Pose& measured, std::optional<Direction> driven,
                                   AssistantMemory& memory) const {
    answer(measured, driven, *memory.lists_);
    return memory.lists_->told;
}

void Assistant::answer(const Pose& measured, std::optional<Direction> driven, Lists& lists) const {
    Instruction& told = lists.told;
    told.what = Instruction::stuck;
    told.moves.clear();
    told.direction_changes = 0;
    lists.looked = 1;
    const auto tell = [&](const Arc& arc) {
        told.what = arc.what;
        told.direction_changes = arc.changes;
        told.moves.clear();
        if (arc.what != Instruction::stuck) told.moves.push_back(arc.move);
    };
    if (std::abs(measured.heading) > limits::farthest) return;  // no heading
    const MapBounds bounds = map_.at(measured);
    if (bounds.where == MapBounds::outside) return;
    if (bounds.where == MapBounds::free && bounds.direction_changes == 0 && !bounds.first) {
        told.what = Instruction::parked;
        return;
    }
    std::vector<Move>& moves = told.moves;
    map_.moves(measured, lists.way, moves);
    if (bounds.first) lists.looked += lists.way.steps.size();
    if (moves.empty()) {
        tell(short_way(measured, driven, std::numeric_limits<int>::max(), lists));
        return;
    }
    int changes = driven && *driven != moves.front().direction ? 1 : 0;
    std::size_t first = moves.size();  // of one direction
    for (std::size_t i = moves.size(); i-- > 1;) {
        if (moves[i].direction == moves[i - 1].direction) continue;
        ++changes;
        first = i;
    }
    moves.resize(first);
    told.what = Instruction::move;
    told.direction_changes = changes;
    if (driven && changes > 0) {
        const Arc farther = short_way(measured, driven, changes - 1, lists);
        if (farther.what != Instruction::stuck) tell(farther);
    }
    settle(moves.back(), lists.looked);
}

/// In the direction of one edge the gap is that of the nearest corner, and of each corner it changes along an arc with a second
/// derivative of at most curvature^2 times its distance from the arc's centre. So in between it is at least the lesser of those at
/// the ends less an eighth of that times length^2, and the widest gap is at least the greatest of these.
bool Assistant::never_deeper(const Around& around, const Move& arc, double from, const double* gaps_from, double to,
                             const double* gaps_to, double floor, int halvings, double* room,
                             std::size_t& looked) const {
    constexpr double tolerance = 2e-7;  // [m]
    const std::size_t edges = around.shape.size() + around.solid.size();
    double surely = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < edges; ++i) surely = std::max(surely, std::min(gaps_from[i], gaps_to[i]));
    const double length = to - from;
    // A corner is no farther from the centre than from where the arc begins, and that from the centre.
    const double curvature = std::abs(angles::tan(arc.steering_angle)) / car_.wheelbase();
    const double off = std::max(
        around.reach, std::max(std::abs(around.low.x - arc.start.x), std::abs(around.high.x - arc.start.x)) +
                          std::max(std::abs(around.low.y - arc.start.y), std::abs(around.high.y - arc.start.y)));
    const double sag = (curvature + curvature * curvature * off) * length * length / 8.0;
    if (surely - sag >= floor - tolerance) return true;
    if (halvings == 0) return false;
    const double middle = (from + to) / 2.0;
    gaps_along_edges(around, drive(car_, arc.start, arc.direction, arc.steering_angle, middle), room);
    ++looked;
    if (*std::max_element(room, room + edges) < floor - tolerance) return false;
    return never_deeper(around, arc, from, gaps_from, middle, room, floor, halvings - 1, room + edges, looked) &&
           never_deeper(around, arc, middle, room, to, gaps_to, floor, halvings - 1, room + edges, looked);
}

Assistant::Arc Assistant::way_out(const Pose& measured, Lists& lists) const {
    constexpr double step = 0.02, farthest = 1.0;  // [m]
    constexpr double grown = 1e-9;
    const auto edges_of = [](const Around& around) { return around.shape.size() + around.solid.size(); };
    const auto widest = [&](const Around& around, const std::vector<double>& gaps) {
        const double* first = gaps.data() + around.begin;
        return *std::max_element(first, first + edges_of(around));
    };
    for (const Around& around : around_) gaps_along_edges(around, measured, lists.here.data() + around.begin);
    Arc best;
    double least = -nearest(measured), shortest = farthest;
    for (const Direction direction : {Direction::backward, Direction::forward}) {
        for (const double part : {0.0, -1.0, 1.0, -0.5, 0.5, -0.2, 0.2}) {
            Move arc = {direction, part * car_.max_steer(), 0.0, measured, measured, {}};
            lists.before = lists.here;
            for (std::size_t k = 0; k < around_.size(); ++k)
                lists.floors[k] = std::min(0.0, widest(around_[k], lists.here));
            for (int i = 1; i * step <= farthest; ++i) {
                const double before = arc.length;
                arc.length = i * step;
                arc.end = drive(car_, measured, direction, arc.steering_angle, arc.length);
                ++lists.looked;
                double left = 0.0;
                bool grows = false;
                for (std::size_t k = 0; k < around_.size() && !grows; ++k) {
                    const Around& around = around_[k];
                    gaps_along_edges(around, arc.end, lists.now.data() + around.begin);
                    grows = !never_deeper(around, arc, before, lists.before.data() + around.begin, arc.length,
                                          lists.now.data() + around.begin, lists.floors[k], most_halvings,
                                          lists.halves.data(), lists.looked);
                    const double gap = widest(around, lists.now);
                    lists.floors[k] = std::min(0.0, std::max(lists.floors[k], gap));
                    left = std::max(left, -gap);
                }
                if (grows) break;
                std::swap(lists.before, lists.now);
                if (left > least - grown && !(left == 0.0 && least == 0.0 && arc.length < shortest)) continue;
                least = left;
                shortest = arc.length;
                best = {Instruction::overlap, arc, 0};
                if (left == 0.0) break;
            }
        }
    }
    return best;
}

double Assistant::free_length(const Move& arc) const {
    const detail::Path path = {arc.start, angles::tan(arc.steering_angle) / car_.wheelbase(),
                               arc.direction == Direction::forward ? 1.0 : -1.0, arc.length};
    double least = detail::never;
    for (const Around& around : around_)
        least = std::min(least, detail::first_contact(around.shape, path, around.solid, limits::touching));
    return least;
}

Assistant::Arc Assistant::short_way(const Pose& measured, std::optional<Direction> driven, int most_changes,
                                    Lists& lists) const {
    constexpr double step = 0.02;  // [m]
    // A car that has a way gains little beyond a metre; one beside a wall has to creep off it.
    const double farthest = most_changes == std::numeric_limits<int>::max() ? 2.5 : 1.0;  // [m]
    constexpr double least_gain = 0.01;  // of an arc that only leads away: else two of them could lead to and fro [m]
    const double room = nearest(measured);
    if (!(room >= -limits::touching)) return way_out(measured, lists);
    const double kept = std::min(room, map_.clearance()) / 2.0 - limits::touching;
    Arc best, away;
    double best_cost = std::numeric_limits<double>::infinity();
    double most_room = room + least_gain;
    for (const Direction direction : {Direction::backward, Direction::forward}) {
        const int turn = driven && *driven != direction ? 1 : 0;
        for (const double part : {0.0, -1.0, 1.0, -0.5, 0.5, -0.2, 0.2}) {
            const double steering = part * map_.car().max_steer();
            const double goes = free_length({direction, steering, farthest, measured, measured, {}});
            for (double length = step; length <= std::min(farthest, goes); length += step) {
                const Pose there = drive(car_, measured, direction, steering, length);
                const double left = nearest(there);
                ++lists.looked;
                if (left < kept) break;
                if (left > most_room && room < map_.clearance() && map_.at(there).where != MapBounds::outside) {
                    most_room = left;
                    away = {Instruction::escape, {direction, steering, length, measured, there, {}}, 0};
                }
                const MapBounds bounds = map_.at(there);
                if (bounds.where != MapBounds::free || !bounds.direction_changes) continue;
                const int changes =
                    *bounds.direction_changes + turn + (bounds.first && *bounds.first != direction ? 1 : 0);
                const double cost = changes + length / 10.0;
                if (changes > most_changes || cost >= best_cost) continue;
                best_cost = cost;
                best = {room < map_.clearance() ? Instruction::escape : Instruction::move,
                        {direction, steering, length, measured, there, {}},
                        changes};
            }
        }
    }
    return best.what == Instruction::stuck ? away : best;
}

}  // namespace snug
