#include "all_maneuvers/sets/slot_in_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "all_maneuvers/lattice.hpp"
#include "all_maneuvers/room.hpp"
#include "all_maneuvers/search.hpp"
#include "all_maneuvers/sets/few_pieces.hpp"
#include "all_maneuvers/sets/route.hpp"
#include "contact/entering.hpp"
#include "model/angles.hpp"
#include "model/polygon.hpp"
#include "snug/error.hpp"
#include "snug/limits.hpp"

namespace snug::detail::sets {

namespace {

constexpr double rounding = 1e-9;  ///< of positions [m]
constexpr double unbounded = std::numeric_limits<double>::infinity();

struct Box {
    double x_min = unbounded, x_max = -unbounded, y_min = unbounded, y_max = -unbounded;

    explicit Box(const std::vector<Point>& corners) {
        for (const Point& p : corners) {
            x_min = std::min(x_min, p.x), x_max = std::max(x_max, p.x);
            y_min = std::min(y_min, p.y), y_max = std::max(y_max, p.y);
        }
    }
};

std::vector<Point> to_slot(const Slot& slot, const std::vector<Point>& points) {
    std::vector<Point> there;
    for (const Point& p : points) there.push_back(slot.to_slot(p));
    return there;
}

/// Whether a convex polygon, counter-clockwise, holds everything below `top` between two x, down to `bottom`.
bool fills(const std::vector<Point>& polygon, double from, double to, double bottom, double top) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &one = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const double allowed = -rounding / 2.0 * angles::hypot(next.x - one.x, next.y - one.y);
        for (const Point& p : {Point{from, bottom}, Point{to, bottom}, Point{to, top}, Point{from, top}})
            if (turn(one, next, p) < allowed) return false;
    }
    return true;
}

std::optional<SlotInPlace> slot_on(Side side, const Car& car, const Place& place, const Pose& start, double clearance,
                                   const Chart& chart) {
    const auto* inside = std::get_if<ParkedInside>(&place.parked());
    if (inside == nullptr || inside->corners.size() != 4) return std::nullopt;
    SlotDimensions dimensions;
    dimensions.length = dimensions.width = 1.0;
    dimensions.side = side;
    dimensions.heading = inside->heading;
    dimensions.corner = inside->corners[0];
    const Slot frame(dimensions);
    const std::vector<Point> corners_of_bay = to_slot(frame, inside->corners);
    const Box bay(corners_of_bay);
    for (const Point& p : corners_of_bay)
        if (std::min(p.x - bay.x_min, bay.x_max - p.x) > rounding / 4.0 ||
            std::min(p.y - bay.y_min, bay.y_max - p.y) > rounding / 4.0)
            return std::nullopt;  // it lies aslant
    dimensions.corner = frame.to_world(Point{bay.x_max, bay.y_max});
    dimensions.length = bay.x_max - bay.x_min;
    dimensions.width = bay.y_max - bay.y_min;
    if (std::max(dimensions.length, dimensions.width) > farthest_y ||
        std::min(dimensions.length, dimensions.width) < limits::shortest)
        return std::nullopt;  // nor is it a slot
    const Slot bare(dimensions);

    // Everything the car can ever cover.
    double farthest = clearance;
    for (const Point& p : car.outline().corners()) farthest = std::max(farthest, clearance + angles::hypot(p.x, p.y));
    const Box region(to_slot(bare, place.region()));
    const double ahead = region.x_max + farthest, behind = region.x_min - farthest, bottom = region.y_min - farthest;
    struct Found {
        double top = -unbounded;
        const Place::Piece* piece = nullptr;
    };
    const auto highest = [&](double from, double to, bool curb) {
        Found found;
        for (const Place::Piece& piece : place.pieces()) {
            if (!curb && (piece.low || place.obstacles()[piece.obstacle].clearance)) continue;
            std::vector<Point> corners = to_slot(bare, piece.corners);
            if (side == Side::left) std::reverse(corners.begin(), corners.end());
            const double top = Box(corners).y_max;
            if (top > std::max(bottom, found.top) && fills(corners, from, to, bottom, top)) found = {top, &piece};
        }
        return found;
    };
    const Found curb = highest(behind, ahead, true);
    if (curb.piece == nullptr || curb.top < -dimensions.width - rounding) return std::nullopt;
    const auto setback = [&](double from, double to) {
        const double depth = std::min(-highest(from, to, false).top, dimensions.width);
        return depth > rounding ? depth : 0.0;
    };
    dimensions.front_setback = setback(0.0, ahead);
    dimensions.rear_setback = setback(behind, -dimensions.length);
    if (std::min(dimensions.front_setback, dimensions.rear_setback) >= dimensions.width) return std::nullopt;

    Driving driving;
    driving.clearance = clearance;
    driving.curb_clearance = place.obstacles()[curb.piece->obstacle].clearance;
    if (curb.piece->low) {
        dimensions.curb = Curb::low;
        driving.curb_clearance = 0.0;
    }
    Parked parked;
    parked.heading = inside->heading_tolerance;
    if (inside->beside) {
        const Point from = bare.to_slot(inside->beside->from), to = bare.to_slot(inside->beside->to);
        if (std::abs(from.y - to.y) < rounding / 4.0 * angles::hypot(to.x - from.x, to.y - from.y) &&
            from.y < -dimensions.width / 2.0)
            parked.curb = std::max(0.0, from.y + dimensions.width + inside->beside->distance);
    }
    return SlotInPlace{car, Slot(dimensions), driving, parked, start, chart};
}

/// The question in a slot a little larger, for what rounding may have done.
Problem loosened(const SlotInPlace& given) {
    SlotDimensions dimensions = given.slot.dimensions();
    dimensions.corner = given.slot.to_world(Point{rounding, rounding});
    dimensions.length += 2.0 * rounding;
    dimensions.width += 2.0 * rounding;
    dimensions.front_setback += 2.0 * rounding;
    dimensions.rear_setback += 2.0 * rounding;
    Parked parked = given.parked;
    parked.heading += rounding;
    parked.curb += 2.0 * rounding;
    return entering_problem(given.car, Slot(dimensions), given.driving, parked);
}

/// The cell of the lattice that holds a pose; where two do, both.
template <class Use>
void for_cells_at(const Lattice& lattice, const Pose& pose, const Use& use) {
    const double row = (pose.x - lattice.x(0)) / (lattice.x(1) - lattice.x(0));
    const double column = (angles::sin(pose.heading) - lattice.sine(0)) / (lattice.sine(1) - lattice.sine(0));
    for (int s = static_cast<int>(std::floor(row)); s <= std::floor(row) + 1.0; ++s)
        for (int d = static_cast<int>(std::floor(column)); d <= std::floor(column) + 1.0; ++d)
            if (((s + d) & 1) == 0 && std::abs(row - s) + std::abs(column - d) < 1.0 + 1e-6) use(s, d);
}

struct OutOfSlot {
    int changes = 0;     ///< the car cannot come to the start with fewer; more than `last` when it does not get out
    detail::Rows cells;  ///< within as many and `further` ones, or `last`
};

/// Leaving from wherever the car is parked, beginning in a direction. Once it is out, the car may drive on to the start in the
/// same move only if that lies ahead; which is told where all `headings` are less than a quarter turn off parallel.
OutOfSlot leave(const Lattice& lattice, const Pose& start, Direction direction, int last, int further, bool headings,
                const Watch& watch) {
    OutOfSlot reach;
    reach.changes = last + 1;
    Heights heights(lattice, watch);
    heights.start_parked();
    const double radius = lattice.problem().radius, half = lattice.spacing() / 2.0 + rounding;
    const double sine = angles::sin(start.heading);
    const double high = start.y + radius * angles::cos(start.heading) - rounding;
    for (int k = 0; k <= last && k < reach.changes + further; ++k, direction = other(direction)) {
        const bool out = heights.sweep(direction, watch);
        if (k >= reach.changes) continue;
        bool there = false;
        for_cells_at(lattice, start, [&](int s, int d) { there = there || heights.at(s, d) >= high; });
        const double way = direction == Direction::forward ? 1.0 : -1.0;
        if (out && !there) {
            for (const Lattice::Goal& goal : lattice.goals()) {
                const int column = column_of_cell(goal.row, goal.cell);
                if (!(heights.at(goal.row, column) > Heights::nowhere)) continue;
                const double along = way * (start.x - lattice.x(goal.row));
                const double turned = way * radius * (sine - lattice.sine(column));
                there = there || !headings || goal.where == Lattice::Goal::upright ||
                        std::min(along - turned, along + turned) >= -half;
            }
            reach.changes = std::min(reach.changes, k + 1);
        }
        if (there) reach.changes = k;
    }
    reach.cells = heights.reached();
    return reach;
}

constexpr double finest_part = 1e-4, finest_way = 1e-4;  ///< of the car's length: the finest spacings

/// Ways in one move, or in two, from the start to where a way into the slot begins, or to a place farther out from there.
class Connection {
public:
    Connection(const ChartPlace& place, const std::vector<Path>& into_slot, int most, const Watch& watch)
        : place_(place), into_slot_(into_slot), most_(most), watch_(watch) {}

    std::vector<Path> best() {
        const Path& first = into_slot_.front();
        const double longest = 0.8 * place_.radius;
        std::vector<Path> farther_out = free_pieces(first.start, -first.way, longest, 32);
        farther_out.insert(farther_out.begin(), {first.start, 0.0, -first.way, 0.0});
        for (const Path& out : farther_out)
            for (const double way : {first.way, -first.way}) consider({}, out, way);
        if (!best_.empty()) return best_;
        for (const double way : {1.0, -1.0})
            for (const Path& before : free_pieces(place_.start, way, longest / 2.0, 16))
                for (const Path& out : farther_out) consider({before}, out, -way);
        return best_;
    }

private:
    /// Of several bends and lengths, as far as nothing is met.
    std::vector<Path> free_pieces(const Pose& from, double way, double longest, int steps) const {
        std::vector<Path> free;
        for (const double bend : {1.0, 0.75, 0.5, 0.25, 0.0, -0.25, -0.5, -0.75, -1.0}) {
            for (int i = 1; i <= steps; ++i) {
                const Path piece{from, bend / place_.radius, way, longest * i / steps};
                if (!is_free(place_, piece)) break;
                free.push_back(piece);
            }
        }
        return free;
    }

    /// From where the pieces before end to the end of `out`, back along it, and in.
    void consider(const std::vector<Path>& before, const Path& out, double way) {
        watch_();
        const Pose from = before.empty() ? place_.start : before.back().at(before.back().length);
        const Pose at = out.at(out.length);
        for (const std::vector<Path>& between : shortest_ways(from, at, way, place_.radius)) {
            std::vector<Path> all = before;
            all.insert(all.end(), between.begin(), between.end());
            if (out.length > 0.0) all.push_back({at, out.curvature, -out.way, out.length});
            double length = 0.0;
            for (const Path& piece : all) length += piece.length;
            all.insert(all.end(), into_slot_.begin(), into_slot_.end());
            const int changes = changes_of(all);
            if (changes > most_ || (changes == most_ && !best_.empty() && length >= length_)) continue;
            if (!is_drivable(place_, all)) continue;
            most_ = changes;
            length_ = length;
            best_ = std::move(all);
        }
    }

    const ChartPlace& place_;
    const std::vector<Path>& into_slot_;
    int most_;
    const Watch& watch_;
    double length_ = 0.0;
    std::vector<Path> best_;
};

}  // namespace

std::optional<SlotInPlace> slot_in(const Car& car, const Place& place, const Pose& start, double clearance,
                                   const Chart& chart) {
    for (const Side side : {Side::right, Side::left})
        if (std::optional<SlotInPlace> slot = slot_on(side, car, place, start, clearance, chart)) return slot;
    return std::nullopt;
}

int SlotInPlace::lower(int most, double most_cells, const Watch& watch) const {
    const Problem problem = loosened(*this);
    Pose here = slot.to_slot(start);
    here.x -= rounding;
    here.y -= rounding;
    here.heading = std::remainder(here.heading, 2.0 * limits::half_turn);
    // The chart's headings reach 80 degrees to either side of halfway between.
    const bool headings = std::abs(here.heading) < 0.34;
    std::optional<detail::Rows> reached;
    constexpr int further = 10;  ///< finer lattices seldom count so many more than the first
    int fewest = 0;
    for (double spacing = coarsest_sensible(problem, car); fewest <= most && spacing > finest_part * car.length();
         spacing /= 2.0) {
        if ((reached ? 4.0 * static_cast<double>(reached->cells()) : Lattice::most_cells(problem, spacing)) >
            most_cells)
            break;
        const Lattice lattice(problem, Enter::backward, Bound::lower, spacing, {}, reached ? &*reached : nullptr,
                              watch);
        if (lattice.may_park_upright()) break;
        // Who begins the other way has reached no more cells than with one move more.
        OutOfSlot reach = leave(lattice, here, Direction::forward, most + 1, further + 2, headings, watch);
        const int others = std::min(reach.changes, most + 1);
        if (others > 0)
            reach.changes = std::min(reach.changes,
                                     leave(lattice, here, Direction::backward, others - 1, 0, headings, watch).changes);
        fewest = std::max(fewest, std::min(reach.changes, most + 1));
        most = std::min(most, reach.changes + further);
        reached = std::move(reach.cells);
    }
    return fewest;
}

std::vector<Path> SlotInPlace::from_mouth(int most, const Watch& watch) const {
    Driving keeping = driving;
    keeping.clearance += 1e-6;  // so that no corner begins at another one
    LeavingQuestion question = entering_question(car, slot, keeping, parked);
    if (!has_room(question.ground, slot.length(), slot.width())) return {};
    question.max_changes = most;
    question.resolution = finest_way * car.length();
    LeavingBounds bounds;
    try {
        narrow(question, sensible_depth(question, watch), bounds, watch);
    } catch (const Error&) {  // the finest lattice would take too much memory
    }
    const Answer answer = answer_of(question, std::move(bounds), car, slot, true);
    if (!answer.maneuver) return {};
    std::vector<Path> into_slot;
    for (const Move& move : answer.maneuver->moves) {
        Pose from = chart.to_chart(move.start);
        from.heading = std::remainder(from.heading, 2.0 * limits::half_turn);
        into_slot.push_back({from, angles::tan(move.steering_angle) / car.wheelbase(),
                             move.direction == Direction::forward ? 1.0 : -1.0, move.length});
    }
    return into_slot;
}

std::vector<Path> from_start(const ChartPlace& place, const std::vector<Path>& from_mouth, int most,
                             const Watch& watch) {
    return Connection(place, from_mouth, most, watch).best();
}

}  // namespace snug::detail::sets
