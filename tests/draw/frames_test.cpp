// Pictures show what the solver says: the frames drawn are those of the answer's poses, and the title has its count.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "snug/draw.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

using Place2 = std::complex<double>;
using Polygon = std::vector<Place2>;

/// Closed paths of so many corners that are stroked, in page coordinates.
std::vector<Polygon> polygons(const std::string& svg, std::size_t corners) {
    std::vector<Polygon> found;
    for (std::size_t at = svg.find("<path "); at != std::string::npos; at = svg.find("<path ", at + 1)) {
        const std::string tag = svg.substr(at, svg.find('>', at) - at);
        if (tag.find("fill:none") == std::string::npos) continue;
        std::istringstream path(tag.substr(tag.find(" d=\"") + 4));
        Polygon polygon(corners);
        bool whole = true;
        for (std::size_t i = 0; i < corners; ++i) {
            std::string letter;
            double x = 0.0, y = 0.0;
            path >> letter >> x >> y;
            polygon[i] = {x, y};
            whole = whole && path && letter == (i == 0 ? "M" : "L");
        }
        std::string end;
        path >> end;
        if (whole && end[0] == 'Z') found.push_back(polygon);
    }
    return found;
}

/// The corners of a car's outline in the world, in the order in which they are drawn.
Polygon frame_of(const Car& car, const Pose& pose) {
    const Place2 rear_axle(pose.x, pose.y);
    const Place2 turned = std::polar(1.0, pose.heading);
    Polygon frame;
    for (const Point& corner : car.outline().corners())
        frame.push_back(rear_axle + turned * Place2(corner.x, corner.y));
    return frame;
}

double apart(const Polygon& a, const Polygon& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

/// Of its longest side to all around.
double proportion(const Polygon& frame) {
    double longest = 0.0;
    double around = 0.0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const double side = std::abs(frame[(i + 1) % frame.size()] - frame[i]);
        longest = std::max(longest, side);
        around += side;
    }
    return longest / around;
}

/// Of all polygons in the picture those that have the car's proportions are its frames. The first pose tells where the page
/// lies in the world (its y runs down); every pose must then be there, and nothing else.
void expect_frames(const std::string& svg, const Car& car, const Maneuver& maneuver, int direction_changes) {
    std::vector<Pose> poses = {maneuver.entry(), maneuver.goal()};
    for (std::size_t i = 1; i < maneuver.moves.size(); ++i) {
        if (maneuver.moves[i].direction != maneuver.moves[i - 1].direction) poses.push_back(maneuver.moves[i].start);
    }
    const Polygon first = frame_of(car, poses.front());
    std::vector<Polygon> frames;
    for (const Polygon& polygon : polygons(svg, first.size())) {
        if (std::abs(proportion(polygon) / proportion(first) - 1.0) < 1e-3) frames.push_back(polygon);
    }
    ASSERT_GE(frames.size(), poses.size());
    double least = INFINITY;  // [m], over all frames that may be the first pose
    for (const Polygon& drawn : frames) {
        const std::size_t across = first.size() / 2;
        const Place2 scale = (drawn[0] - drawn[across]) / std::conj(first[0] - first[across]);
        const auto on_page = [&](const Pose& pose) {
            Polygon page = frame_of(car, pose);
            for (Place2& corner : page) corner = drawn[0] + scale * std::conj(corner - first[0]);
            return page;
        };
        double most = 0.0;
        const auto nearest = [&](const Polygon& to, const auto& among, const auto& as_polygon) {
            double distance = INFINITY;
            for (const auto& one : among) distance = std::min(distance, apart(to, as_polygon(one)));
            most = std::max(most, distance / std::abs(scale));
        };
        for (const Pose& pose : poses) nearest(on_page(pose), frames, [](const Polygon& frame) { return frame; });
        for (const Polygon& frame : frames) nearest(frame, poses, on_page);
        least = std::min(least, most);
    }
    EXPECT_LT(least, 1e-3) << "some frame is so far from where the car is";
    const std::string number = direction_changes == 0 ? "no" : std::to_string(direction_changes);
    const std::string count = number + " direction change" + (direction_changes > 1 ? "s" : "");
    const std::string title = svg.substr(svg.find("<title>"), svg.find("</title>") - svg.find("<title>"));
    EXPECT_NE(title.find(' ' + count), std::string::npos) << title;
    EXPECT_EQ(maneuver.direction_changes(), direction_changes);
}

TEST(DrawnFrames, AreThoseOfAnEntry) {
    const Car zoe = *find_car("renault-zoe");
    const Car mid = *find_car("mid-size");
    const Car round(Outline::rounded(zoe.front(), zoe.rear(), zoe.width() / 2.0, 0.4, 0.2), zoe.wheelbase(),
                    zoe.max_steer());
    struct Asked {
        Car car;
        Slot slot;
        Driving driving;
    };
    for (const Asked& asked : {Asked{zoe, Slot({.length = 4.5, .width = 2.0}), {}},
                               Asked{mid, Slot({5.1, 2.2, Side::left, {3.0, -4.0}, 0.7}), {}},
                               Asked{zoe, Slot({.length = 5.2, .width = 2.2}), {.clearance = 0.02}},
                               Asked{round, Slot({.length = 4.5, .width = 2.0}), {}},
                               Asked{zoe, Slot({.length = 7.0, .width = 3.2}), {.enter = Enter::forward}}}) {
        EntryOptions options;
        options.driving = asked.driving;
        options.prove = false;
        const Answer answer = entry(asked.car, asked.slot, options);
        ASSERT_TRUE(answer.parkable());
        PictureOptions picture;
        picture.driving = asked.driving;
        expect_frames(draw_maneuver(asked.car, asked.slot, answer, PictureFormat::svg, picture), asked.car,
                      *answer.maneuver, *answer.direction_changes);
    }
}

TEST(DrawnFrames, AreThoseOfTheWayOut) {
    const Car zoe = *find_car("renault-zoe");
    const Slot slot({.length = 5.0, .width = 2.0});
    FewestOptions options;
    options.resolution = 0.004;
    const Answer answer =
        leave(zoe, slot, {-zoe.front() - 0.3, -slot.width() + zoe.width() / 2.0 + 0.05, 0.0}, options);
    ASSERT_TRUE(answer.parkable());
    PictureOptions picture;
    picture.leaving = true;
    expect_frames(draw_maneuver(zoe, slot, answer, PictureFormat::svg, picture), zoe, *answer.maneuver,
                  *answer.direction_changes);
}

TEST(DrawnFrames, AreThoseOfTheWayInFromTheStreet) {
    const Car zoe = *find_car("renault-zoe");
    Street slot;
    slot.length = 5.2;
    slot.width = 2.0;
    slot.road = 3.5;
    Street bay = slot;
    bay.length = 5.0;
    bay.width = 2.5;
    bay.road = 6.0;
    bay.angle = 1.5707963267948966;
    bay.side = Side::left;
    for (const Street& street : {slot, bay}) {
        const Pose start = standard_start(street, zoe);
        const ParkAnswer answer = park(zoe, street_place(street), start);
        ASSERT_TRUE(answer.parkable());
        expect_frames(draw_park(zoe, street, start, answer, PictureFormat::svg), zoe, *answer.maneuver,
                      *answer.direction_changes);
    }
}

}  // namespace
}  // namespace snug
