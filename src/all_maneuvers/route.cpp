#include "all_maneuvers/route.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/angles.hpp"

namespace snug::detail::sets {

namespace {

constexpr double touch = 1e-9;  ///< deeper is contact [m]

enum Steering : std::uint8_t { left, straight, right };

struct At {
    int row = 0, column = 0;
    double y = 0.0;
};

/// Steps from a node towards the parked poses. A step of full steering leads to the row beside, a straight one across a cell.
struct Stepper {
    const InnerLattice& lattice;
    int way;  ///< of the rows: -1 where the car, leaving, drives forward

    Stepper(const InnerLattice& on, Direction leaving) : lattice(on), way(leaving == Direction::forward ? -1 : 1) {}

    [[nodiscard]] At from(const At& at, Steering steering) const {
        const int d = at.column;
        if (steering == straight) {
            const double sine = lattice.sine(d);
            return {at.row + 2 * way, d, at.y + way * lattice.h() * sine / std::sqrt((1.0 - sine) * (1.0 + sine))};
        }
        // To the left the car keeps y + r cos, to the right y - r cos. Driving back to the left the heading falls.
        const int to = steering == left ? d + way : d - way;
        const double gain = steering == left ? lattice.level(d) - lattice.level(to) : lattice.level(to) - lattice.level(d);
        return {at.row + way, to, at.y + gain};
    }
};

/// Adds a piece of so many steps to the way; a piece of the same kind grows.
void drive_on(const InnerLattice& lattice, std::vector<Path>& way, Pose& pose, int& column, Steering steering, int steps,
              Direction direction) {
    Path piece;
    piece.start = pose;
    piece.way = direction == Direction::forward ? 1.0 : -1.0;
    const double sine = lattice.sine(column);
    if (steering == straight) {
        piece.length = steps * lattice.h() / std::sqrt((1.0 - sine) * (1.0 + sine));
    } else {
        const double sense = (steering == left ? 1.0 : -1.0) * piece.way;
        const int to = column + static_cast<int>(sense) * steps;
        piece.curvature = (steering == left ? 1.0 : -1.0) / lattice.radius();
        piece.length = std::abs(angles::asin(lattice.sine(to)) - angles::asin(sine)) * lattice.radius();
        column = to;
    }
    if (!(piece.length > 0.0)) return;
    if (!way.empty() && way.back().way == piece.way && way.back().curvature == piece.curvature) {
        way.back().length += piece.length;
        pose = way.back().at(way.back().length);
        return;
    }
    way.push_back(piece);
    pose = piece.at(piece.length);
}

/// The places one piece more leads to, for every node and steering of the last piece: of several the roomiest.
class Reached {
public:
    struct Place {
        double y = 0.0;
        float room = -1.0F;    ///< least on the way; negative: not reached
        std::int8_t from = 0;  ///< 3: the same piece goes on; else the steering of the piece before
    };
    using Places = std::array<Place, 3>;

    explicit Reached(const Spans& spans) : spans_(spans), places_(spans.cells), live_(spans.rows.size()) {}

    /// Cells of the row that anything was noted for.
    [[nodiscard]] Span live(int row) const {
        const int i = row - spans_.first;
        return i < 0 || i >= static_cast<int>(live_.size()) ? Span{} : live_[static_cast<std::size_t>(i)];
    }
    [[nodiscard]] const Places& at(int row, int cell) const {
        static constexpr Places nothing{};
        const Span span = spans_.of(row);
        return cell < span.from || cell > span.to ? nothing : places_[span.at(cell)];
    }
    void note(int row, int cell, Steering steering, const Place& place) {
        Place& noted = places_[spans_.of(row).at(cell)][steering];
        if (!(place.room > noted.room)) return;
        noted = place;
        Span& live = live_[static_cast<std::size_t>(row - spans_.first)];
        live = live.empty() ? Span{cell, cell} : Span{std::min(live.from, cell), std::max(live.to, cell)};
    }

private:
    Spans spans_;
    std::vector<Places> places_;
    std::vector<Span> live_;
};

constexpr std::size_t most_pieces = 7;

/// Drives one move; false when it finds no way of few pieces.
bool drive_move(const InnerLattice& lattice, const InnerSet& begins, const InnerSet& reaches, Direction leaving, At& at,
                std::vector<Path>& way, Pose& pose) {
    const Stepper stepper(lattice, leaving);
    const Direction direction = leaving == Direction::forward ? Direction::backward : Direction::forward;
    if (reaches.at(at.row, at.column).empty()) return false;
    std::vector<Reached> layers;
    const int beyond = stepper.way > 0 ? reaches.spans.last() + 1 : reaches.spans.first - 1;
    for (std::size_t pieces = 1; pieces <= most_pieces; ++pieces) {
        layers.emplace_back(reaches.spans);
        Reached& now = layers.back();
        const Reached* before = pieces > 1 ? &layers[pieces - 2] : nullptr;
        struct Best {
            double score = -std::numeric_limits<double>::infinity();
            At at;
            Steering steering = left;
        } best;
        for (int row = at.row; row != beyond; row += stepper.way) {
            // The rows ahead are filled from this one.
            Span span = now.live(row);
            if (before) {
                const Span other = before->live(row);
                if (!other.empty()) span = span.empty() ? other : Span{std::min(span.from, other.from), std::max(span.to, other.to)};
            } else if (row == at.row) {
                span = {cell_of(at.column), cell_of(at.column)};
            }
            for (int cell = span.from; cell <= span.to; ++cell) {
                const int column = column_of(row, cell);
                const Reached::Places& places = now.at(row, cell);
                for (const Steering steering : {left, straight, right}) {
                    const Reached::Place& place = places[steering];
                    if (place.room >= 0.0F) {
                        const double deep = begins.at(row, column).room(place.y);
                        const double far = std::abs(row - at.row) * lattice.h() / 2.0;
                        const double score = std::min(static_cast<double>(place.room), 0.3) + std::min(deep, 0.05) - 0.01 * far;
                        if (deep >= 0.0 && score > best.score) best = {score, {row, column, place.y}, steering};
                    }
                    // The roomiest of going on and of turning to this steering here.
                    Reached::Place from = {place.y, place.room, 3};
                    if (before) {
                        for (const Steering other : {left, straight, right}) {
                            const Reached::Place& turning = before->at(row, cell)[other];
                            if (other != steering && turning.room > from.room) from = {turning.y, turning.room, static_cast<std::int8_t>(other)};
                        }
                    } else if (row == at.row) {
                        from = {at.y, 1e6F, 0};
                    }
                    if (from.room < 0.0F) continue;
                    const At next = stepper.from({row, column, from.y}, steering);
                    if (reaches.at(next.row, next.column).room(next.y) < 0.0) continue;
                    const auto room = static_cast<float>(lattice.free().at(next.row, next.column).room(next.y));
                    now.note(next.row, cell_of(next.column), steering, {next.y, std::min(from.room, room), from.from});
                }
            }
        }
        if (!(best.score > -1e9)) continue;
        // Back to the origin.
        struct Run {
            Steering steering;
            int steps;
        };
        std::vector<Run> runs;
        At back = best.at;
        Steering steering = best.steering;
        for (std::size_t layer = pieces; layer > 0;) {
            const Reached::Place& place = layers[layer - 1].at(back.row, cell_of(back.column))[steering];
            if (runs.empty() || runs.back().steering != steering) runs.push_back({steering, 0});
            ++runs.back().steps;
            back.row -= steering == straight ? 2 * stepper.way : stepper.way;
            back.column -= steering == straight ? 0 : steering == left ? stepper.way : -stepper.way;
            if (place.from == 3) continue;
            steering = static_cast<Steering>(place.from);
            --layer;
        }
        int column = at.column;
        for (auto run = runs.rbegin(); run != runs.rend(); ++run)
            drive_on(lattice, way, pose, column, run->steering, run->steps, direction);
        at = best.at;
        return true;
    }
    return false;
}

}  // namespace

std::vector<Path> way_of_few_pieces(const InnerLattice& lattice, const InnerChain& chain, const ChartPlace& place) {
    std::vector<Path> way;
    Pose pose = place.start;
    At at = {0, 0, place.start.y};
    for (std::size_t k = chain.reaches.size(); k-- > 0;) {
        if (chain.begins[k].at(at.row, at.column).room(at.y) >= 0.0 && k > 0) continue;  // this move is not needed
        if (k == 0 && chain.begins[0].at(at.row, at.column).room(at.y) >= 0.0) break;
        if (!drive_move(lattice, chain.begins[k], chain.reaches[k], chain.direction(k), at, way, pose)) return {};
    }
    return way;
}

std::vector<Path> way_by_steps(const InnerLattice& lattice, const InnerChain& chain, const ChartPlace& place) {
    std::vector<Path> way;
    Pose pose = place.start;
    At at = {0, 0, place.start.y};
    for (std::size_t k = chain.reaches.size(); k-- > 0;) {
        const Direction leaving = chain.direction(k);
        const Direction direction = leaving == Direction::forward ? Direction::backward : Direction::forward;
        const Stepper stepper(lattice, leaving);
        const InnerSet &begins = chain.begins[k], &reaches = chain.reaches[k];
        while (begins.at(at.row, at.column).room(at.y) < 0.0) {
            const auto room_at = [&](const At& next) { return reaches.at(next.row, next.column).room(next.y); };
            const At to_left = stepper.from(at, left), to_right = stepper.from(at, right);
            const double left_room = room_at(to_left), right_room = room_at(to_right);
            // Across the cell, turning off after a part of the first arc: what that gains depends on where.
            At across = {at.row + 2 * stepper.way, at.column, at.y};
            double across_room = -1.0;
            const double one = 2.0 * (to_left.y - at.y), other = 2.0 * (to_right.y - at.y);
            for (const Interval& interval : reaches.at(across.row, across.column)) {
                const double from = std::max(at.y + std::min(one, other), interval.low);
                const double to = std::min(at.y + std::max(one, other), interval.high);
                if (from > to) continue;
                const double y = std::clamp((interval.low + interval.high) / 2.0, from, to);
                const double room = std::min(y - interval.low, interval.high - y);
                if (room > across_room) {
                    across_room = room;
                    across.y = y;
                }
            }
            if (left_room < 0.0 && right_room < 0.0 && across_room < 0.0) return {};
            int column = at.column;
            if (left_room >= right_room && left_room >= across_room) {
                drive_on(lattice, way, pose, column, left, 1, direction);
                at = to_left;
            } else if (right_room >= across_room) {
                drive_on(lattice, way, pose, column, right, 1, direction);
                at = to_right;
            } else {
                // First to the left by a part of an arc, right by a whole one, and left again; y falls or rises with the part.
                const double r = lattice.radius(), d = lattice.h() / (2.0 * r), s = lattice.sine(at.column);
                const auto cosine = [](double sine) { return std::sqrt((1.0 - sine) * (1.0 + sine)); };
                const double way_of = stepper.way;
                const auto gain = [&](double part) {
                    return 2.0 * r * (cosine(s + way_of * (part - 1.0) * d) - cosine(s + way_of * part * d));
                };
                // The gain rises or falls all the way from part 0 to part 1.
                double from = 0.0, to = 1.0;
                const double wanted = across.y - at.y;
                const double sign = gain(1.0) > gain(0.0) ? 1.0 : -1.0;
                for (int i = 0; i < 60; ++i) {
                    const double middle = (from + to) / 2.0;
                    (sign * (gain(middle) - wanted) < 0.0 ? from : to) = middle;
                }
                const double part = (from + to) / 2.0;
                const double turn = direction == Direction::forward ? 1.0 : -1.0;
                double here = s;
                const auto arc = [&](double curvature, double to_sine) {
                    Path piece;
                    piece.start = pose;
                    piece.way = turn;
                    piece.curvature = curvature / r;
                    piece.length = std::abs(angles::asin(to_sine) - angles::asin(here)) * r;
                    here = to_sine;
                    if (!(piece.length > 0.0)) return;
                    way.push_back(piece);
                    pose = piece.at(piece.length);
                };
                arc(1.0, s + turn * part * d);
                arc(-1.0, s + turn * (part - 1.0) * d);
                arc(1.0, s);
                at = across;
            }
        }
    }
    return way;
}

namespace {

/// The most of normal . p along the path of the rear axle's middle.
double farthest_along(const Path& path, const Point& normal) {
    const Pose end = path.at(path.length);
    double most = std::max(normal.x * path.start.x + normal.y * path.start.y, normal.x * end.x + normal.y * end.y);
    if (path.curvature == 0.0) return most;
    // On the circle it is where the heading is at a right angle to the normal.
    const double change = path.way * path.length * path.curvature;
    for (const double quarter : {1.0, -1.0}) {
        const double heading = angles::atan2(normal.y, normal.x) + quarter * 1.5707963267948966;
        double turned = std::remainder(heading - path.start.heading, 6.283185307179586);
        if (change > 0.0 && turned < 0.0) turned += 6.283185307179586;
        if (change < 0.0 && turned > 0.0) turned -= 6.283185307179586;
        if (std::abs(turned) > std::abs(change)) continue;
        const Pose there = path.at(turned / (path.way * path.curvature));
        most = std::max(most, normal.x * there.x + normal.y * there.y);
    }
    return most;
}

bool is_parked(const ChartPlace& place, const Pose& pose) {
    const double sine = angles::sin(pose.heading);
    if (sine < place.parked_from - touch || sine > place.parked_to + touch) return false;
    const std::vector<Point> frame = placed(place.frame, pose);
    for (const ParkedLimit& limit : place.parked) {
        const Point& n = limit.within.normal;
        double least = std::numeric_limits<double>::infinity(), most = -least;
        if (limit.of == ParkedLimit::axle) {
            least = most = n.x * pose.x + n.y * pose.y;
        } else {
            for (const Point& p : frame) {
                least = std::min(least, n.x * p.x + n.y * p.y);
                most = std::max(most, n.x * p.x + n.y * p.y);
            }
        }
        const double at = limit.of == ParkedLimit::nearest_point ? least : most;
        if (at > limit.within.offset + touch) return false;
    }
    return true;
}

}  // namespace

bool is_drivable(const ChartPlace& place, const std::vector<Path>& way) {
    if (way.empty() && !is_parked(place, place.start)) return false;
    Pose end = place.start;
    for (const ChartPlace::Solid& solid : place.solids)
        if (overlap(placed(solid.low ? place.wheels : place.body, place.start), solid.corners) > touch) return false;
    for (const Path& piece : way) {
        for (const HalfPlane& edge : place.region)
            if (farthest_along(piece, edge.normal) > edge.offset + 1e-6) return false;
        for (const ChartPlace::Solid& solid : place.solids)
            if (first_contact(solid.low ? place.wheels : place.body, piece, solid.corners, touch) < piece.length) return false;
        end = piece.at(piece.length);
    }
    return is_parked(place, end);
}

}  // namespace snug::detail::sets
