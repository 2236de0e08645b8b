#include "contact/turning.hpp"

#include <algorithm>
#include <utility>

namespace snug::detail {

namespace {

constexpr double quarter_turn = 1.57079632679489661923;
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
std::vector<Border> borders(const Problem& problem) {
    std::vector<Border> found;
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
    found.reserve(found.size() + 1);
    std::sort(found.begin(), found.end(), [](const Border& a, const Border& b) { return a.s - a.c > b.s - b.c; });
    const auto same = [](const Border& a, const Border& b) { return std::abs(a.c * b.s - a.s * b.c) <= one_border; };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    found.push_back({1.0, 0.0});
    return found;
}

/// Moves on to the corner of an outline that leads in a direction of the turned car's quarter; from one sector to the next
/// it is a neighbour, and mostly the same.
void lead(TurningCorner& corner, const Outline& outline, int quarter, const Point& centre, const Point& towards) {
    const std::vector<Point>& corners = outline.corners();
    const std::size_t count = corners.size();
    const Point own = turned(towards, -quarter);
    const auto ahead_of = [&](std::size_t a, std::size_t b) {
        return (corners[a].x - corners[b].x) * own.x + (corners[a].y - corners[b].y) * own.y > 0.0;
    };
    std::size_t best = static_cast<std::size_t>(corner.index);
    for (std::size_t next; ahead_of(next = best + 1 == count ? 0 : best + 1, best);) best = next;
    for (std::size_t next; ahead_of(next = best == 0 ? count - 1 : best - 1, best);) best = next;
    if (corner.radius > 0.0 && static_cast<int>(best) == corner.index) return;
    const Point seen = turned(corners[best], quarter);
    corner = {seen.x - centre.x, seen.y - centre.y, static_cast<int>(best)};
}

/// The most that a c + b s is between two borders.
double most_between(double a, double b, const Border& begin, const Border& end) {
    const double radius = std::sqrt(a * a + b * b);
    const double order = (b - a) / radius;
    if (a >= 0.0 && b >= 0.0 && order <= begin.s - begin.c && order >= end.s - end.c) return radius;
    return std::max(a * begin.c + b * begin.s, a * end.c + b * end.s);
}

/// order() of the heading at which the corner is straight below the centre, if that lies between two borders.
double below_centre(const TurningCorner& corner, double begin_order, double end_order) {
    constexpr double never = std::numeric_limits<double>::infinity();
    if (corner.x > 0.0 || corner.y > 0.0) return never;
    const double order = (corner.y - corner.x) / corner.radius;
    return order <= begin_order && order >= end_order ? order : never;
}

/// The directions of the body's edges.
std::vector<Point> directions(const Outline& body) {
    const std::vector<Point>& corners = body.corners();
    std::vector<Point> ways(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point& next = corners[i + 1 == corners.size() ? 0 : i + 1];
        const double x = next.x - corners[i].x;
        const double y = next.y - corners[i].y;
        const double length = x == 0.0 ? std::abs(y) : y == 0.0 ? std::abs(x) : angles::hypot(x, y);
        ways[i] = {x / length, y / length};
    }
    return ways;
}

/// The edges of the body from one corner on to another that a point turning counter-clockwise about the centre can enter over.
void add_edges(TurningFrame& frame, const Problem& problem, const std::vector<Point>& ways, int quarter,
               const Point& centre, int from, int to, std::uint32_t& begin, std::uint32_t& end) {
    const std::vector<Point>& corners = problem.body.corners();
    const std::size_t count = corners.size();
    const auto seen = [&](std::size_t i) {
        const Point corner = turned(corners[i], quarter);
        return Point{corner.x - centre.x, corner.y - centre.y};
    };
    const auto along = [](const Point& point, const Point& way) { return point.x * way.x + point.y * way.y; };
    const double margin = 4.0 * problem.touch;
    begin = static_cast<std::uint32_t>(frame.edges.size());
    for (std::size_t i = static_cast<std::size_t>(from); i != static_cast<std::size_t>(to);) {
        const std::size_t next = i + 1 == count ? 0 : i + 1;
        const Point way = turned(ways[i], quarter);
        const Point a = seen(i);
        const Point b = seen(next);
        const double last = along(b, way);
        if (last > 0.0) {
            const double first = along(a, way);
            const double distance = a.x * way.y - a.y * way.x;
            const double near = std::max(0.0, first - margin);
            const double far = last + margin;
            TurningEdge& edge = frame.edges.emplace_back();
            edge.nx = way.y;
            edge.ny = -way.x;
            edge.distance = distance;
            edge.from = first;
            edge.to = last;
            edge.slips_back = along(a, turned(ways[i == 0 ? count - 1 : i - 1], quarter)) <= 0.0;
            edge.slips_on = along(b, turned(ways[next], quarter)) <= 0.0;
            edge.nearest_square = (near * near + distance * distance) * (1.0 - 1e-12);
            edge.farthest_square = (far * far + distance * distance) * (1.0 + 1e-12);
            edge.index = static_cast<int>(i);
        }
        i = next;
    }
    end = static_cast<std::uint32_t>(frame.edges.size());
}

}  // namespace

QuarterHeading in_quarters(double heading) {
    const double quarter = std::floor(heading / quarter_turn);
    const double within = std::max(0.0, heading - quarter * quarter_turn);
    const auto [s, c] = angles::sine_cosine(within);
    return {std::max(0.0, c), s, static_cast<int>(-quarter)};
}

TurningFrame::TurningFrame(const Problem& problem, double offset)
    : ends_(borders(problem)), ways_(directions(problem.body)), offset_(offset) {
    per_quarter = static_cast<int>(ends_.size());
    sectors.resize(4 * ends_.size());
    edges.reserve(4 * ends_.size() + 4 * ways_.size());
}

void TurningFrame::see(const Problem& problem, int any_quarter) {
    const int quarter = any_quarter & 3;
    if (seen_[static_cast<std::size_t>(quarter)]) return;
    seen_[static_cast<std::size_t>(quarter)] = true;
    const double margin = 4.0 * problem.touch;
    const Point centre = turned({0.0, offset_}, quarter);
    std::size_t index = static_cast<std::size_t>(quarter) * ends_.size();
    Border begin = {0.0, 1.0};
    bool another_quarter = true;
    const bool body_at_curb = problem.at_curb == problem.body;
    const bool body_is_frame = problem.frame == problem.body;
    for (const Border& end : ends_) {
        Sector& sector = sectors[index];
        const Sector& before = another_quarter ? sector : sectors[index - 1];
        ++index;
        sector.end_c = end.c;
        sector.end_s = end.s;
        const double begin_order = begin.s - begin.c;
        const double end_order = end.s - end.c;
        if (end.s > 0.0) sector.end_order = end_order;
        const double c = begin.c + end.c;  // halfway, but for its length
        const double s = begin.s + end.s;
        const Point down = {-s, -c};  // as the car sees it
        const Point right = {c, -s};
        const Point left = {-c, s};
        const Point up = {s, c};
        const auto leads = [&](TurningCorner Sector::*corner, const Outline& outline, const Point& towards) {
            sector.*corner = before.*corner;
            if (another_quarter) (sector.*corner).radius = 0.0;
            lead(sector.*corner, outline, quarter, centre, towards);
        };
        leads(&Sector::lowest, problem.body, down);
        leads(&Sector::leftmost, problem.body, left);
        leads(&Sector::rightmost, problem.body, right);
        if (body_at_curb) {
            sector.at_curb = sector.lowest;
        } else {
            leads(&Sector::at_curb, problem.at_curb, down);
        }
        leads(&Sector::top, problem.frame, up);
        if (body_is_frame) {
            sector.frame_low = sector.lowest;
            sector.frame_left = sector.leftmost;
            sector.frame_right = sector.rightmost;
        } else {
            leads(&Sector::frame_low, problem.frame, down);
            leads(&Sector::frame_left, problem.frame, left);
            leads(&Sector::frame_right, problem.frame, right);
        }
        sector.reaches_right = most_between(sector.rightmost.x, -sector.rightmost.y, begin, end) + margin;
        sector.reaches_left = most_between(-sector.leftmost.x, sector.leftmost.y, begin, end) + margin;
        sector.reaches_down = most_between(-sector.at_curb.y, -sector.at_curb.x, begin, end) + margin;
        sector.graze_order = below_centre(sector.at_curb, begin_order, end_order);
        sector.dip_order = below_centre(sector.top, begin_order, end_order);
        add_edges(*this, problem, ways_, quarter, centre, sector.lowest.index, sector.rightmost.index,
                  sector.front_edges, sector.front_edges_end);
        add_edges(*this, problem, ways_, quarter, centre, sector.leftmost.index, sector.lowest.index, sector.rear_edges,
                  sector.rear_edges_end);
        begin = end;
        another_quarter = false;
    }
}

TurningFrame turning_frame(const Problem& problem, double offset) {
    TurningFrame frame(problem, offset);
    for (int quarter = 0; quarter < 4; ++quarter) frame.see(problem, quarter);
    return frame;
}

int part_met(const TurningFrame& frame, const Sector& sector, Meets meets, int edge) {
    switch (meets) {
        case Meets::front_side: return sector.rightmost.index;
        case Meets::rear_side: return sector.leftmost.index;
        case Meets::front_corner:
        case Meets::rear_corner: return frame.edges[static_cast<std::size_t>(edge)].index;
        case Meets::front_top:
        case Meets::rear_top: return sector.lowest.index;
        default: return sector.at_curb.index;
    }
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

Contact contact_of(const Car& car, const Slot& slot, Enter enter, const Problem& problem, Meets meets, int part) {
    const bool edge = meets == Meets::front_corner || meets == Meets::rear_corner;
    const bool wheels = meets == Meets::curb && slot.curb() == Curb::low;
    const Outline& own = wheels ? car.wheels() : car.outline();
    const bool flipped_y = slot.side() == Side::left;
    const bool flipped_x = enter == Enter::forward;
    // The corner as the car's own outline counts it; an edge seen in a mirror follows its other corner.
    const std::vector<Point>& seen = (wheels ? problem.at_curb : problem.body).corners();
    std::size_t index = static_cast<std::size_t>(part);
    if (flipped_x != flipped_y) {
        const Outline image = flipped_y ? own.mirrored() : own.turned_about();
        const std::size_t from = edge ? (index + 1) % seen.size() : index;
        const Point first = image.corners().front();
        const Point original = {flipped_x ? -first.x : first.x, flipped_y ? -first.y : first.y};
        const auto start = std::find(own.corners().begin(), own.corners().end(), original) - own.corners().begin();
        index = (static_cast<std::size_t>(start) + seen.size() - from) % seen.size();
    } else if (flipped_x) {
        const Outline image = own.mirrored().turned_about();
        const Point first = image.corners().front();
        const auto start =
            std::find(own.corners().begin(), own.corners().end(), Point{-first.x, -first.y}) - own.corners().begin();
        index = (static_cast<std::size_t>(start) + index) % seen.size();
    }
    const Point& corner = own.corners()[index];
    CarPart name =
        edge ? edge_at(own, corner, own.corners()[(index + 1) % own.corners().size()]) : corner_at(own, corner);
    if (wheels) name = wheel(name);
    Obstacle obstacle = obstacle_of(meets);
    if (flipped_x) obstacle = other_end(obstacle);
    return {name, obstacle, index};
}

}  // namespace snug::detail
