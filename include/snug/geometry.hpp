// Points and poses: the plain data every other header builds on.
#pragma once

#include "snug/version.hpp"

namespace snug {

/// A point in the plane. [m]
struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
};

/// Where a car stands: the middle of its rear axle [m] and its heading [rad], counter-clockwise from the x axis.
struct Pose {
    double x = 0.0;
    double y = 0.0;
    double heading = 0.0;

    friend bool operator==(const Pose&, const Pose&) = default;
};

/// An axis-parallel rectangle. [m]
struct Box {
    double x_min = 0.0;
    double x_max = 0.0;
    double y_min = 0.0;
    double y_max = 0.0;

    friend bool operator==(const Box&, const Box&) = default;
};

}  // namespace snug
