#include "contact/turning.hpp"

#include <algorithm>
#include <utility>

#include "contact/edge.hpp"

namespace snug::detail {

namespace {

constexpr double one_border = 2e-14;  ///< headings this close are one border between sectors [rad]

/// A point seen from the car turned clockwise by whole quarter turns.
Point turned(const Point& point, int quarters) {
    switch (quarters & 3) {
        case 0: return point;
        case 1: return {point.y, -point.x};
        case 2: return {-point.x, -point.y};
        default: return {-point.y, point.x};
    }
}

/// The headings within a quarter turn, from the steepest, at which an edge lies level or upright; the last is the quarter's
/// end.
Few<Border, 4> borders(const Problem& problem) {
    Few<Border, 4> found;
    for (const Outline* outline : {&problem.body, &problem.at_curb, &problem.frame}) {
        const std::vector<Point>& corners = outline->corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point& from = corners[i];
            const Point& to = corners[(i + 1) % corners.size()];
            if (to.x == from.x || to.y == from.y) continue;  // at the quarter's end
            const double length = angles::hypot(to.x - from.x, to.y - from.y);
            // Level where the heading is opposite to the edge's direction, and every quarter turn from there.
            Point border = {(to.x - from.x) / length, (from.y - to.y) / length};
            while (!(border.x > 0.0 && border.y >= 0.0)) border = turned(border, 1);
            if (border.y > one_border && border.x > one_border) found.push_back({border.x, border.y});
        }
    }
    std::sort(found.begin(), found.end(), [](const Border& a, const Border& b) { return a.s - a.c > b.s - b.c; });
    const auto same = [](const Border& a, const Border& b) { return std::abs(a.c * b.s - a.s * b.c) <= one_border; };
    found.resize(static_cast<std::size_t>(std::unique(found.begin(), found.end(), same) - found.begin()));
    found.push_back({1.0, 0.0});
    return found;
}

/// The corner of an outline that leads in a direction, as its own frame sees it; from one sector to the next it is a
/// neighbour of the one before, and mostly the same.
int leading(const Outline& outline, int before, const Point& own) {
    const std::vector<Point>& corners = outline.corners();
    const std::size_t count = corners.size();
    const auto ahead_of = [&](std::size_t a, std::size_t b) {
        return (corners[a].x - corners[b].x) * own.x + (corners[a].y - corners[b].y) * own.y > 0.0;
    };
    std::size_t best = static_cast<std::size_t>(before);
    for (std::size_t next; ahead_of(next = best + 1 == count ? 0 : best + 1, best);) best = next;
    for (std::size_t next; ahead_of(next = best == 0 ? count - 1 : best - 1, best);) best = next;
    return static_cast<int>(best);
}

constexpr double unreached = std::numeric_limits<double>::infinity();

Few<TurningShape::Leading, 4> leading(const Outline& outline, const Few<Border, 4>& ends) {
    Few<TurningShape::Leading, 4> found;
    if (ends.size() == 1) {  // a rectangle, which begins with its front-left corner
        found.push_back({{2, 3, 0, 1}});
        return found;
    }
    TurningShape::Leading now = {};
    Border begin = {0.0, 1.0};
    for (const Border& end : ends) {
        const double c = begin.c + end.c;  // halfway, but for its length
        const double s = begin.s + end.s;
        const std::array<Point, 4> ways = {Point{-s, -c}, Point{c, -s}, Point{s, c}, Point{-c, s}};
        for (std::size_t i = 0; i < ways.size(); ++i) now[i] = leading(outline, now[i], ways[i]);
        found.push_back(now);
        begin = end;
    }
    return found;
}

TurningCorner turned(TurningCorner corner, int quarter) {
    const Point seen = turned(Point{corner.x, corner.y}, quarter);
    corner.x = seen.x;
    corner.y = seen.y;
    return corner;
}

/// order() of the heading at which the corner is straight below the centre, if that lies between two borders.
double below_centre(const TurningCorner& corner, double begin_order, double end_order) {
    if (corner.x > 0.0 || corner.y > 0.0) return unreached;
    const double order = (corner.y - corner.x) / corner.radius;
    return order <= begin_order && order >= end_order ? order : unreached;
}

/// The edges of the body, as far as a point turning counter-clockwise about the centre can enter over them.
Few<TurningEdge, 4> seen_edges(const Few<TurningCorner, 12>& corners, const Few<Point, 4>& ways, double touch) {
    const auto along = [](const TurningCorner& point, const Point& way) { return point.x * way.x + point.y * way.y; };
    const double margin = 4.0 * touch;
    const std::size_t count = ways.size();
    Few<TurningEdge, 4> edges;
    edges.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = i + 1 == count ? 0 : i + 1;
        const Point& way = ways[i];
        const TurningCorner& a = corners[i];
        const TurningCorner& b = corners[next];
        TurningEdge& edge = edges[i];
        edge.distance = a.x * way.y - a.y * way.x;
        edge.from = along(a, way);
        edge.to = along(b, way);
        edge.slips_back = along(a, ways[i == 0 ? count - 1 : i - 1]) <= 0.0;
        edge.slips_on = along(b, ways[next]) <= 0.0;
        edge.index = static_cast<int>(i);
        const double near = std::max(0.0, edge.from - margin);
        const double far = edge.to + margin;
        const double square = edge.distance * edge.distance;
        edge.nearest_square = (near * near + square) * (1.0 - 1e-12);
        edge.farthest_square = edge.to > 0.0 ? (far * far + square) * (1.0 + 1e-12) : -1.0;
    }
    return edges;
}

}  // namespace

QuarterHeading in_quarters(double heading) {
    const double quarter = std::floor(heading / limits::quarter_turn);
    const double within = std::max(0.0, heading - quarter * limits::quarter_turn);
    const auto [s, c] = angles::sine_cosine(within);
    return {std::max(0.0, c), s, static_cast<int>(-quarter)};
}

TurningShape::TurningShape(const Problem& problem)
    : ends(borders(problem)),
      body(leading(problem.body, ends)),
      ways(directions(problem.body)),
      body_at_curb(problem.at_curb == problem.body),
      body_is_frame(problem.frame == problem.body),
      rectangle(ends.size() == 1 &&
                std::all_of(ways.begin(), ways.end(), [](const Point& way) { return way.x == 0.0 || way.y == 0.0; })) {
    if (!body_at_curb) at_curb = leading(problem.at_curb, ends);
    if (!body_is_frame) frame = leading(problem.frame, ends);
}

TurningFrame::TurningFrame(const Problem& problem, const TurningShape& shape, double offset)
    : per_quarter(static_cast<int>(shape.ends.size())), rectangle(shape.rectangle) {
    const auto add = [&](const Outline& outline) {
        for (const Point& corner : outline.corners()) {
            const double across = corner.y - offset;
            const double square = corner.x * corner.x + across * across;
            const int index = static_cast<int>(&corner - outline.corners().data());
            corners_.push_back({corner.x, across, std::sqrt(square), 1.0 / square, index});
        }
    };
    add(problem.body);
    if (!shape.body_at_curb) {
        at_curb_ = corners_.size();
        add(problem.at_curb);
    }
    if (!shape.body_is_frame) {
        frame_ = corners_.size();
        add(problem.frame);
    }
    edges = seen_edges(corners_, shape.ways, problem.touch);
    sectors.resize(4 * shape.ends.size());
}

void TurningFrame::see(const TurningShape& shape, int any_quarter) {
    const int quarter = any_quarter & 3;
    if (seen_[static_cast<std::size_t>(quarter)]) return;
    seen_[static_cast<std::size_t>(quarter)] = true;
    // A quarter turn on, what led to the right leads downward.
    const auto down = static_cast<std::size_t>(quarter);
    const std::size_t right = (down + 1) % 4;
    const std::size_t up = (down + 2) % 4;
    const std::size_t left = (down + 3) % 4;
    const auto seen = [&](std::size_t of, int index) {
        return turned(corners_[of + static_cast<std::size_t>(index)], quarter);
    };
    const auto point = [](const TurningCorner& corner) { return Point{corner.x, corner.y}; };
    const auto& at_curb = shape.body_at_curb ? shape.body : shape.at_curb;
    const auto& of_frame = shape.body_is_frame ? shape.body : shape.frame;
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i].normal[down] = turned(outward(shape.ways[i]), quarter);
    Border begin = {0.0, 1.0};
    for (std::size_t i = 0; i < shape.ends.size(); ++i) {
        const Border& end = shape.ends[i];
        Sector& sector = sectors[down * shape.ends.size() + i];
        sector.end_c = end.c;
        sector.end_s = end.s;
        const double begin_order = begin.s - begin.c;
        const double end_order = end.s - end.c;
        sector.end_order = end.s > 0.0 ? end_order : -2.0;
        sector.lowest = seen(0, shape.body[i][down]);
        sector.leftmost = seen(0, shape.body[i][left]);
        sector.rightmost = seen(0, shape.body[i][right]);
        sector.at_curb = seen(at_curb_, at_curb[i][down]);
        sector.top = seen(frame_, of_frame[i][up]);
        const auto edges_between = [&](const TurningCorner& a, const TurningCorner& b) {
            const int all = static_cast<int>(edges.size());
            Sector::Edges between = {a.index, b.index - a.index + (b.index < a.index ? all : 0), unreached, -1.0};
            for (int k = 0; k < between.count; ++k) {
                const TurningEdge& edge = edges[static_cast<std::size_t>((a.index + k) % all)];
                if (edge.farthest_square < 0.0) continue;
                between.nearest_square = std::min(between.nearest_square, edge.nearest_square);
                between.farthest_square = std::max(between.farthest_square, edge.farthest_square);
            }
            return between;
        };
        sector.front = edges_between(sector.lowest, sector.rightmost);
        sector.rear = edges_between(sector.leftmost, sector.lowest);
        sector.frame_low = point(seen(frame_, of_frame[i][down]));
        sector.frame_left = point(seen(frame_, of_frame[i][left]));
        sector.frame_right = point(seen(frame_, of_frame[i][right]));
        sector.graze_order = below_centre(sector.at_curb, begin_order, end_order);
        sector.dip_order = below_centre(sector.top, begin_order, end_order);
        begin = end;
    }
}

Bearing first_in_sector(const TurningFrame& frame, const Sector& sector, const Problem& problem, double x, double y,
                        int quarter, double c, double s, Found& found) {
    const Surroundings<double> around = {
        x, y, problem.length, y + problem.width, y + problem.front_setback, y + problem.rear_setback, problem.touch};
    First<Plain<double>, Found> first(c, s, sector.end_order);
    if (frame.rectangle) {
        first.rectangle_meets(sector.lowest, sector.leftmost, sector.rightmost, sector.at_curb, around);
        found = first.found;
        return {first.c, first.s};
    }
    first.corners_meet(sector.lowest, sector.leftmost, sector.rightmost, sector.at_curb, around);
    const TurningEdge* const edges = frame.edges.data();
    const TurningEdge* const end = frame.edges.end();
    // Inlined twice by force, so that `first` stays in registers.
    const auto edges_meet = [&](const Sector::Edges& some, double gx, double gy, Meets meets)
        __attribute__((always_inline)) {
        const double square = gx * gx + gy * gy;
        if (!(square >= some.nearest_square && square <= some.farthest_square)) return;
        int count = some.count;
        const TurningEdge* edge = edges + some.first;
        for (;;) {
            if (!(square < edge->nearest_square || square > edge->farthest_square)) {
                const Point& outward = edge->normal[static_cast<std::size_t>(quarter & 3)];
                const Normal<Plain<double>> normal = {outward.x, outward.y};
                first.edge_meets_corner(*edge, normal, gx, gy, problem.touch, meets);
            }
            if (--count == 0) return;
            if (++edge == end) edge = edges;
        }
    };
    edges_meet(sector.front, -x, -around.above_front, Meets::front_corner);
    edges_meet(sector.rear, -x - problem.length, -around.above_rear, Meets::rear_corner);
    found = first.found;
    return {first.c, first.s};
}

CarPart corner_at(const Outline& outline, const Point& point) {
    const bool ahead = point.x > (outline.front() - outline.rear()) / 2.0;
    const bool to_the_left = point.y > (outline.left() - outline.right()) / 2.0;
    if (ahead) return to_the_left ? CarPart::front_left_corner : CarPart::front_right_corner;
    return to_the_left ? CarPart::rear_left_corner : CarPart::rear_right_corner;
}

CarPart edge_at(const Outline& outline, const Point& from, const Point& to) {
    const Point normal = {to.y - from.y, from.x - to.x};
    constexpr double slanted = 0.41421356237309505;  // more than an eighth of a turn's half off both ways: a cut corner
    const double least = std::min(std::abs(normal.x), std::abs(normal.y));
    const double most = std::max(std::abs(normal.x), std::abs(normal.y));
    if (least > slanted * most) return corner_at(outline, {(from.x + to.x) / 2.0, (from.y + to.y) / 2.0});
    if (std::abs(normal.x) > std::abs(normal.y)) return normal.x > 0.0 ? CarPart::front_edge : CarPart::rear_edge;
    return normal.y > 0.0 ? CarPart::left_edge : CarPart::right_edge;
}

CarPart wheel(CarPart corner) {
    switch (corner) {
        case CarPart::front_left_corner: return CarPart::front_left_wheel;
        case CarPart::rear_left_corner: return CarPart::rear_left_wheel;
        case CarPart::rear_right_corner: return CarPart::rear_right_wheel;
        default: return CarPart::front_right_wheel;
    }
}

namespace {

Obstacle obstacle_of(Meets meets) {
    switch (meets) {
        case Meets::front_side:
        case Meets::front_top: return Obstacle::front_side;
        case Meets::front_corner: return Obstacle::front_corner;
        case Meets::rear_side:
        case Meets::rear_top: return Obstacle::rear_side;
        case Meets::rear_corner: return Obstacle::rear_corner;
        default: return Obstacle::curb;
    }
}

}  // namespace

Contact contact_of(const Car& car, const Slot& slot, Enter enter, Meets meets, int part) {
    const bool edge = meets == Meets::front_corner || meets == Meets::rear_corner;
    const bool wheels = meets == Meets::curb && slot.curb() == Curb::low;
    const Outline& own = wheels ? car.wheels() : car.outline();
    const std::size_t index = own_part(own, slot, enter, edge, static_cast<std::size_t>(part));
    const Point& corner = own.corners()[index];
    CarPart name =
        edge ? edge_at(own, corner, own.corners()[(index + 1) % own.corners().size()]) : corner_at(own, corner);
    if (wheels) name = wheel(name);
    Obstacle obstacle = obstacle_of(meets);
    if (enter == Enter::forward) obstacle = other_end(obstacle);
    return {name, obstacle, index};
}

}  // namespace snug::detail
