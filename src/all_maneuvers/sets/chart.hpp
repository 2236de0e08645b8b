// The plane turned and moved so that all headings needed lie well within a quarter turn of x, and in it, for every heading,
// where along y the car may be. docs/park.md has the reasons.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "snug/geometry.hpp"
#include "snug/place.hpp"

namespace snug::detail::sets {

/// Steeper headings are not in the chart: the sine of 80 degrees.
constexpr double steepest_sine = 0.984807753012208;

/// Where the chart lies in the world.
struct Chart {
    Point origin;
    double turned = 0.0;  ///< heading of its x axis [rad]
    double sine = 0.0, cosine = 1.0;

    Chart() = default;
    Chart(const Point& at, double heading);
    [[nodiscard]] Point to_chart(const Point& world) const;
    [[nodiscard]] Pose to_chart(const Pose& world) const;
    [[nodiscard]] Pose to_world(const Pose& here) const;
};

/// All p with normal . p <= offset.
struct HalfPlane {
    Point normal;  ///< unit length
    double offset = 0.0;
};

/// What must lie in a half plane when the car is parked.
struct ParkedLimit {
    HalfPlane within;
    enum Of { whole_car, nearest_point, axle } of = whole_car;
};

/// The question in the chart.
struct ChartPlace {
    std::vector<std::vector<Point>> shapes;  ///< what stops at solids, about the rear axle, counter-clockwise
    std::vector<Point> frame;                ///< must be inside when parked
    double radius = 0.0;                     ///< turning radius
    struct Solid {
        std::vector<Point> corners;  ///< counter-clockwise
        std::size_t stops = 0;       ///< which of the shapes
    };
    std::vector<Solid> solids;
    std::vector<HalfPlane> region;  ///< of the rear axle's middle
    std::vector<ParkedLimit> parked;
    double parked_from = 0.0, parked_to = 0.0;                  ///< sines of headings
    double x_min = 0.0, x_max = 0.0, y_min = 0.0, y_max = 0.0;  ///< around the region
    Pose start;
};

/// Turned halfway between the heading at the start and the parked one. What stops is the outline grown by the clearance [m],
/// or by that of an obstacle, and at low ones the wheels.
ChartPlace chart_place(const Car& car, const Place& place, const Pose& start, double clearance, Chart& chart);

/// A convex set cut by lines along y: for x between `from` and `to` it lies between the highest of the lower and the lowest
/// of the upper lines.
struct Band {
    struct Line {
        double at_0, slope;
    };
    double from = 0.0, to = 0.0;
    std::vector<Line> lower, upper;

    /// Empty (low > high) where there is nothing.
    void at(double x, double& low, double& high) const {
        low = std::numeric_limits<double>::infinity();
        high = -low;
        if (x < from || x > to) return;
        std::swap(low, high);
        for (const Line& line : lower) low = std::max(low, line.at_0 + line.slope * x);
        for (const Line& line : upper) high = std::min(high, line.at_0 + line.slope * x);
    }
};

/// For one heading: where solids stop the car, where its rear axle may be and where it is parked.
struct Bands {
    std::vector<Band> solids;
    Band region, parked;
};

/// Of the very heading with this sine.
Bands bands_at(const ChartPlace& place, double sine);
/// Of a cell of the lattice around that heading: |dx| + r |d sine| <= h / 2. What is outside these solids holds every free
/// place in the cell, and the parked ones are within the band.
Bands bands_of_cell(const ChartPlace& place, double sine, double h);

}  // namespace snug::detail::sets
