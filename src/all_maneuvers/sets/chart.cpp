#include "all_maneuvers/sets/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "model/angles.hpp"
#include "snug/limits.hpp"

namespace snug::detail::sets {

Chart::Chart(const Point& at, double heading) : origin(at), turned(heading) {
    const auto of = angles::sine_cosine(heading);
    sine = of.sine;
    cosine = of.cosine;
}

Point Chart::to_chart(const Point& world) const {
    const double x = world.x - origin.x, y = world.y - origin.y;
    return {x * cosine + y * sine, y * cosine - x * sine};
}

Pose Chart::to_chart(const Pose& world) const {
    const Point at = to_chart(Point{world.x, world.y});
    return {at.x, at.y, world.heading - turned};
}

Pose Chart::to_world(const Pose& here) const {
    return {origin.x + here.x * cosine - here.y * sine, origin.y + here.x * sine + here.y * cosine,
            here.heading + turned};
}

namespace {

using limits::half_turn;

std::vector<HalfPlane> half_planes(const std::vector<Point>& corners) {
    std::vector<HalfPlane> edges;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &from = corners[i], &to = corners[(i + 1) % corners.size()];
        const double along = angles::hypot(to.x - from.x, to.y - from.y);
        const Point normal = {(to.y - from.y) / along, -(to.x - from.x) / along};
        edges.push_back({normal, normal.x * from.x + normal.y * from.y});
    }
    return edges;
}

}  // namespace

ChartPlace chart_place(const Car& car, const Place& place, const Pose& start, double clearance, Chart& chart) {
    ChartPlace here;
    const auto* inside = std::get_if<ParkedInside>(&place.parked());
    const auto* at = std::get_if<ParkedAt>(&place.parked());
    const double parked_heading = inside ? inside->heading : at->pose.heading;
    const double tolerance = inside ? inside->heading_tolerance : at->heading;
    const double between = std::remainder(parked_heading - start.heading, 2.0 * half_turn);
    const std::vector<Point>& region = place.region();
    double x_min = region[0].x, x_max = x_min, y_min = region[0].y, y_max = y_min;
    for (const Point& p : region) {
        x_min = std::min(x_min, p.x), x_max = std::max(x_max, p.x);
        y_min = std::min(y_min, p.y), y_max = std::max(y_max, p.y);
    }
    chart = Chart({(x_min + x_max) / 2.0, (y_min + y_max) / 2.0}, start.heading + between / 2.0);
    const auto to_chart = [&](const std::vector<Point>& corners) {
        std::vector<Point> there;
        for (const Point& p : corners) there.push_back(chart.to_chart(p));
        return there;
    };

    here.frame = car.outline().corners();
    here.radius = car.turning_radius();
    here.shapes = {car.outline().grown(clearance).corners(), car.wheels().corners()};
    for (const Place::Piece& piece : place.pieces()) {
        const std::optional<double>& own = place.obstacles()[piece.obstacle].clearance;
        std::size_t stops = piece.low ? 1 : 0;
        if (own && !piece.low) {
            stops = here.shapes.size();
            here.shapes.push_back(car.outline().grown(*own).corners());
        }
        here.solids.push_back({to_chart(piece.corners), stops});
    }
    const std::vector<Point> edge = to_chart(region);
    here.region = half_planes(edge);
    here.x_min = here.x_max = edge[0].x;
    here.y_min = here.y_max = edge[0].y;
    for (const Point& p : edge) {
        here.x_min = std::min(here.x_min, p.x), here.x_max = std::max(here.x_max, p.x);
        here.y_min = std::min(here.y_min, p.y), here.y_max = std::max(here.y_max, p.y);
    }
    if (inside) {
        for (const HalfPlane& side_of_slot : half_planes(to_chart(inside->corners)))
            here.parked.push_back({side_of_slot, ParkedLimit::whole_car});
        if (inside->beside) {
            // The normal that looks from the car to the line: the polygon lies on its other side.
            const Point from = chart.to_chart(inside->beside->from), to = chart.to_chart(inside->beside->to);
            Point middle{0.0, 0.0};
            for (const Point& p : to_chart(inside->corners)) {
                middle.x += p.x / static_cast<double>(inside->corners.size());
                middle.y += p.y / static_cast<double>(inside->corners.size());
            }
            const double along = angles::hypot(to.x - from.x, to.y - from.y);
            Point normal = {-(to.y - from.y) / along, (to.x - from.x) / along};
            if (normal.x * (middle.x - from.x) + normal.y * (middle.y - from.y) < 0.0) normal = {-normal.x, -normal.y};
            here.parked.push_back({{normal, normal.x * from.x + normal.y * from.y + inside->beside->distance},
                                   ParkedLimit::nearest_point});
        }
    } else {
        const Pose goal = chart.to_chart(at->pose);
        const auto [s, c] = angles::sine_cosine(goal.heading);
        const double ahead = goal.x * c + goal.y * s, aside = goal.y * c - goal.x * s;
        here.parked.push_back({{{c, s}, ahead + at->along}, ParkedLimit::axle});
        here.parked.push_back({{{-c, -s}, at->along - ahead}, ParkedLimit::axle});
        here.parked.push_back({{{-s, c}, aside + at->across}, ParkedLimit::axle});
        here.parked.push_back({{{s, -c}, at->across - aside}, ParkedLimit::axle});
    }
    const double heading = between / 2.0;
    const double quarter = half_turn / 2.0;
    here.parked_from = heading - tolerance <= -quarter ? -1.0 : angles::sin(heading - tolerance);
    here.parked_to = heading + tolerance >= quarter ? 1.0 : angles::sin(heading + tolerance);
    here.start = chart.to_chart(start);
    here.start.heading = -between / 2.0;
    return here;
}

namespace {

constexpr double upright = 1e-7;    ///< steeper edges are taken for upright ones
constexpr double tallest = 1000.0;  ///< no y is farther from the origin [m]

double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }

Point rotated(const Point& p, double sine, double cosine) {
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
}

/// Half planes as lines. Upright ones are moved out (`grows` 1) or in (-1) by what they may lean.
struct BandBuilder {
    Band band;
    double grows;

    BandBuilder(double out, std::size_t edges) : grows(out) {
        band.from = -std::numeric_limits<double>::infinity();
        band.to = -band.from;
        band.lower.reserve(edges);
        band.upper.reserve(edges);
    }
    void add(const Point& normal, double offset) {
        if (std::abs(normal.y) <= upright) {
            const double at = offset + grows * std::abs(normal.y) * tallest;
            if (normal.x > 0.0) band.to = std::min(band.to, at / normal.x);
            if (normal.x < 0.0) band.from = std::max(band.from, at / normal.x);
            return;
        }
        (normal.y > 0.0 ? band.upper : band.lower).push_back({offset / normal.y, -normal.x / normal.y});
    }
    /// Where the lines leave no room, so that most of a row need not look at them.
    void close() {
        for (const Band::Line& low : band.lower) {
            for (const Band::Line& high : band.upper) {
                const double slope = high.slope - low.slope;  // low <= high where slope x >= low.at_0 - high.at_0
                const double at = (low.at_0 - high.at_0) / slope;
                const double slack = 1e-9 * (1.0 + std::abs(at));
                if (slope > 0.0) band.from = std::max(band.from, at - slack);
                if (slope < 0.0) band.to = std::min(band.to, at + slack);
            }
        }
    }
};

/// How far points of the car can move within a cell, in the direction of a normal.
struct Spread {
    double half = 0.0;      ///< of the spacing
    double per_turn = 0.0;  ///< half of it as an angle
    double curved = 0.0;    ///< what turning adds to turning along the tangent

    [[nodiscard]] double of_point(const Point& normal, const Point& from_axle) const {
        const double turning = std::abs(normal.y * from_axle.x - normal.x * from_axle.y);
        return std::max(half * std::abs(normal.x), per_turn * turning) + curved * per_turn * per_turn;
    }
};

Bands bands(const ChartPlace& place, double sine, double h) {
    const double s = std::clamp(sine, -1.0, 1.0);
    const double c = std::sqrt((1.0 - s) * (1.0 + s));
    Spread spread;
    if (h > 0.0) {
        const double steep = std::min(std::abs(sine) + h / (2.0 * place.radius), steepest_sine);
        spread.half = h / 2.0;
        spread.per_turn = h / (2.0 * place.radius * std::sqrt((1.0 - steep) * (1.0 + steep)));
        for (const std::vector<Point>& shape : place.shapes)
            for (const Point& p : shape) spread.curved = std::max(spread.curved, angles::hypot(p.x, p.y) / 2.0);
        for (const Point& p : place.frame) spread.curved = std::max(spread.curved, angles::hypot(p.x, p.y) / 2.0);
    }
    const auto turned = [&](const std::vector<Point>& shape) {
        std::vector<Point> there;
        there.reserve(shape.size());
        for (const Point& p : shape) there.push_back(rotated(p, s, c));
        return there;
    };
    std::vector<std::vector<Point>> shapes;
    shapes.reserve(place.shapes.size());
    for (const std::vector<Point>& shape : place.shapes) shapes.push_back(turned(shape));
    const std::vector<Point> frame = turned(place.frame);

    Bands all;
    all.solids.reserve(place.solids.size());
    for (const ChartPlace::Solid& solid : place.solids) {
        // Where the axle is when the car touches: the solid widened by the car. Its edges belong to one or the other.
        const std::vector<Point>& car = shapes[solid.stops];
        const std::size_t n = solid.corners.size();
        BandBuilder widened(-1.0, n + car.size());
        for (std::size_t i = 0; i < n; ++i) {
            const Point &from = solid.corners[i], &to = solid.corners[(i + 1) % n];
            const double along = angles::hypot(to.x - from.x, to.y - from.y);
            const Point normal = {(to.y - from.y) / along, -(to.x - from.x) / along};
            const Point* nearest = &car[0];
            for (const Point& p : car)
                if (dot(normal, p) < dot(normal, *nearest)) nearest = &p;
            double moved = 0.0;
            // Corners that are as near but for rounding move, too.
            for (const Point& p : car)
                if (dot(normal, p) < dot(normal, *nearest) + 1e-9) moved = std::max(moved, spread.of_point(normal, p));
            widened.add(normal, dot(normal, from) - dot(normal, *nearest) - (h > 0.0 ? moved : 0.0));
        }
        for (std::size_t i = 0; i < car.size(); ++i) {
            const Point &from = car[i], &to = car[(i + 1) % car.size()];
            const double along = angles::hypot(to.x - from.x, to.y - from.y);
            const Point normal = {-(to.y - from.y) / along, (to.x - from.x) / along};  // into the car
            double farthest = -std::numeric_limits<double>::infinity();
            for (const Point& p : solid.corners) farthest = std::max(farthest, dot(normal, p));
            const double moved = std::max(spread.of_point(normal, from), spread.of_point(normal, to));
            widened.add(normal, farthest - dot(normal, from) - (h > 0.0 ? moved : 0.0));
        }
        widened.close();
        all.solids.push_back(std::move(widened.band));
    }
    BandBuilder region(1.0, place.region.size());
    for (const HalfPlane& edge : place.region)
        region.add(edge.normal, edge.offset + spread.half * std::abs(edge.normal.x));
    region.close();
    all.region = std::move(region.band);

    BandBuilder parked(1.0, place.parked.size());
    const double within = h / (2.0 * place.radius);
    if (sine + within < place.parked_from || sine - within > place.parked_to) {
        parked.band.to = parked.band.from;
    } else {
        for (const ParkedLimit& limit : place.parked) {
            const Point& normal = limit.within.normal;
            double offset = std::numeric_limits<double>::infinity();
            if (limit.of == ParkedLimit::axle) offset = limit.within.offset + spread.half * std::abs(normal.x);
            if (limit.of == ParkedLimit::whole_car) {
                for (const Point& p : frame)
                    offset = std::min(
                        offset, limit.within.offset - dot(normal, p) + (h > 0.0 ? spread.of_point(normal, p) : 0.0));
            }
            if (limit.of == ParkedLimit::nearest_point) {
                offset = -offset;
                for (const Point& p : frame)
                    offset = std::max(
                        offset, limit.within.offset - dot(normal, p) + (h > 0.0 ? spread.of_point(normal, p) : 0.0));
            }
            parked.add(normal, offset);
        }
        parked.close();
    }
    all.parked = std::move(parked.band);
    return all;
}

}  // namespace

Bands bands_at(const ChartPlace& place, double sine) { return bands(place, sine, 0.0); }

Bands bands_of_cell(const ChartPlace& place, double sine, double h) { return bands(place, sine, h); }

}  // namespace snug::detail::sets
