// The lattices behind both bounds: no real motion is ever above the lower one, and a plain loop gives the upper one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "all_maneuvers/lattice.hpp"
#include "all_maneuvers/right_side.hpp"
#include "contact/entering.hpp"
#include "oracle/driving.hpp"
#include "oracle/random_outlines.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace {

using namespace snug::detail;
using oracle::Case;
using oracle::Random;
using snug::Direction;
using snug::Pose;

constexpr double nowhere = Heights::nowhere;
const Watch no_watch = [] {};

/// A car in front of a slot on the right that takes a few changes.
struct Place {
    Case asked;
    snug::Car car;
    snug::Slot slot;
    Problem problem;
    oracle::Problem<double> judged;

    explicit Place(const Case& from)
        : asked(from),
          car(from.made_car()),
          slot(from.made_slot()),
          problem(entering_problem(car, slot, from.driving, from.parked)),
          judged(oracle::make_problem<double>(from)) {}
};

/// Half of them rectangles in the paper's slots, the others any outline between any neighbours.
std::vector<Place> places(int count) {
    std::vector<Place> found;
    for (std::uint64_t i = 0; static_cast<int>(found.size()) < count; ++i) {
        Case asked = found.size() % 2 == 0 ? oracle::random_case(11, i) : oracle::random_outline_case(11, i);
        if (asked.kind != "tight" && asked.kind != "thin" && asked.kind != "roomy") continue;
        asked.driving.enter = snug::Enter::backward;
        const snug::SlotDimensions chosen = asked.slot;
        asked.slot = {.length = chosen.length,
                      .width = chosen.width,
                      .front_setback = chosen.front_setback,
                      .rear_setback = chosen.rear_setback,
                      .curb = chosen.curb};
        found.emplace_back(asked);
    }
    return found;
}

/// Somewhere parked, most often as high as can be.
std::optional<Pose> parked(Random& random, const Place& place) {
    const double tilt = std::min(0.3, place.asked.parked.heading);
    Pose pose{0.0, 0.0, random.between(-tilt, tilt) * (random.chance(0.5) ? 1.0 : 0.1)};
    double top = -1e9, low = 1e9, left = 1e9, right = -1e9;
    for (const snug::Point& p : placed(place.car.outline(), pose)) {
        top = std::max(top, p.y);
        low = std::min(low, p.y);
        left = std::min(left, p.x);
        right = std::max(right, p.x);
    }
    pose.y = std::min(-top, -place.slot.width() + place.asked.parked.curb - low);
    if (random.chance(0.2)) pose.y -= random.between(0.0, 0.1);
    const double from = -place.slot.length() - left, to = -right;
    if (from > to) return std::nullopt;
    pose.x = std::clamp(from + (to - from) * random.between(-0.2, 1.2), from, to);
    const oracle::Place<double> there{pose.x, pose.y, pose.heading};
    if (oracle::depth(place.judged, there) > 0.0) return std::nullopt;
    return pose;
}

TEST(LowerBound, NoRealMotionIsHigherThanItAllows) {
    const int tries = snug::test::sample(400, 20000);
    constexpr int most = 8;
    Random random(3);
    for (const Place& place : places(snug::test::sample(6, 40))) {
        SCOPED_TRACE(oracle::command_line(place.asked));
        const RightSide side(place.problem.body);
        const double spacing = std::min(random.between(1e-3, 8e-3) * place.car.length(), place.problem.radius / 64.0);
        const Lattice lattice(place.problem, snug::Enter::backward, Bound::lower, spacing, {}, nullptr, no_watch);
        for (const int first : {0, 1}) {
            std::vector<Heights> levels;
            std::vector<bool> out;
            Heights heights(lattice, no_watch);
            heights.start_parked();
            for (int k = 0; k <= most; ++k) {
                out.push_back(heights.sweep((k + first) % 2 == 0 ? Direction::forward : Direction::backward, no_watch));
                levels.push_back(heights);
            }
            for (int t = 0; t < tries; ++t) {
                const std::optional<Pose> start = parked(random, place);
                if (!start) continue;
                Pose pose = *start;
                bool gone = false;
                for (int k = 0; k <= most && !gone; ++k) {
                    const Direction direction = (k + first) % 2 == 0 ? Direction::forward : Direction::backward;
                    // Left and then right climbs best; now and then anything else.
                    const bool best = random.chance(0.8);
                    const int pieces = best ? 2 : 1 + random.below(4);
                    for (int piece = 0; piece < pieces && !gone; ++piece) {
                        const double limit = place.car.max_steer();
                        const double steering = best                 ? (piece == 0 ? limit : -limit)
                                                : random.chance(0.7) ? (random.chance(0.5) ? limit : -limit)
                                                                     : random.between(-1.0, 1.0) * limit;
                        const oracle::Path<double> path{{pose.x, pose.y, pose.heading},
                                                        place.car.wheelbase() / std::tan(steering),
                                                        direction == Direction::forward ? 1 : -1};
                        double length = std::min(oracle::first_contact(place.judged, path, 2.0), 2.0);
                        if (random.chance(best && piece == 0 ? 1.0 : 0.4)) length *= random.unit();
                        const int steps = std::max(2, static_cast<int>(length / spacing));
                        for (int i = 0; i <= steps && !gone; ++i) {
                            const Pose at = drive(place.car, pose, direction, steering, length * i / steps);
                            const double c = std::cos(at.heading), s = std::sin(at.heading);
                            const auto x_of = [&](const snug::Point& p) { return at.x + p.x * c - p.y * s; };
                            gone = std::abs(at.heading) > 1.2 || x_of(side.front) > 1e-6 ||
                                   x_of(side.rear) < -place.slot.length() - 1e-6;
                            if (gone) break;
                            const double across = place.problem.radius * s;
                            const int a = static_cast<int>(std::floor((at.x - across) / spacing + 0.5));
                            const int b = static_cast<int>(std::floor((at.x + across) / spacing + 0.5));
                            ASSERT_LE(at.y + place.problem.radius * c,
                                      levels[static_cast<std::size_t>(k)].at(a + b, b - a) + 1e-11)
                                << "after " << k << " changes at " << at.x << ' ' << at.y << ' ' << at.heading;
                        }
                        pose = drive(place.car, pose, direction, steering, length);
                    }
                }
            }
        }
    }
}

/// Lowest free height, by clipping the car to what is beyond each wall.
double lowest_free(const Place& place, double x, double heading) {
    const snug::SlotDimensions& slot = place.asked.slot;
    const Pose pose{x, 0.0, heading};
    double needed = -1e9;
    for (const snug::Point& p : placed(place.problem.at_curb, pose)) needed = std::max(needed, -slot.width - p.y);
    const std::vector<snug::Point> corners = placed(place.problem.body, pose);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const snug::Point p = corners[i], q = corners[(i + 1) % corners.size()];
        if (p.x > 0.0) needed = std::max(needed, -slot.front_setback - p.y);
        if (p.x < -slot.length) needed = std::max(needed, -slot.rear_setback - p.y);
        for (const auto& [wall, setback] :
             {std::pair{0.0, slot.front_setback}, std::pair{-slot.length, slot.rear_setback}}) {
            if ((p.x < wall) == (q.x < wall)) continue;
            needed = std::max(needed, -setback - (p.y + (q.y - p.y) * (wall - p.x) / (q.x - p.x)));
        }
    }
    return needed;
}

TEST(UpperBound, APlainLoopGivesTheSameHeights) {
    for (const Place& place : places(snug::test::sample(4, 40))) {
        SCOPED_TRACE(oracle::command_line(place.asked));
        const double spacing = std::min(1e-2 * place.car.length(), place.problem.radius / 64.0);
        const double radius = place.problem.radius;
        const Lattice lattice(place.problem, snug::Enter::backward, Bound::upper, spacing, {}, nullptr, no_watch);
        Heights heights(lattice, no_watch);
        heights.start_parked();
        std::map<std::pair<int, int>, double> plain;  // y + r cos(heading) by row and column
        const int first_row = lattice.rows().first;
        const int rows = static_cast<int>(lattice.rows().windows.size());
        const auto cosine = [&](int d) { return std::sqrt(1.0 - lattice.sine(d) * lattice.sine(d)); };
        const auto value = [&](int s, int d) {
            const auto found = plain.find({s, d});
            return found == plain.end() ? nowhere : found->second;
        };
        const auto columns = [&](int s) {
            const Window& window = lattice.rows().windows[static_cast<std::size_t>(s - first_row)];
            return std::pair{column_of_cell(s, window.from), column_of_cell(s, window.to)};
        };
        const auto needed = [&](int s, int d) {
            return std::isfinite(lattice.needed(s, d))
                       ? lowest_free(place, lattice.x(s), std::asin(lattice.sine(d))) + radius * cosine(d)
                       : 1e9;
        };
        for (int s = first_row; s < first_row + rows; ++s)
            for (auto [d, last] = columns(s); d <= last; d += 2)
                if (heights.at(s, d) > nowhere) plain[{s, d}] = heights.at(s, d);
        for (int k = 0; k < 4; ++k) {
            const Direction direction = k % 2 == 0 ? Direction::forward : Direction::backward;
            heights.sweep(direction, no_watch);
            for (int i = 1; i + 1 < rows; ++i) {
                const int s = direction == Direction::forward ? first_row + i : first_row + rows - 1 - i;
                const int before = direction == Direction::forward ? s - 1 : s + 1;
                for (auto [d, last] = columns(s); d <= last; d += 2) {
                    const int turned_right = direction == Direction::forward ? d + 1 : d - 1;
                    const int turned_left = direction == Direction::forward ? d - 1 : d + 1;
                    const double z =
                        std::max({value(s, d), value(before, turned_left),
                                  value(before, turned_right) + 2.0 * radius * (cosine(d) - cosine(turned_right))});
                    plain[{s, d}] = z >= needed(s, d) - 1e-9 ? z : nowhere;
                }
            }
            for (const auto& [node, z] : plain) {
                const double fast = heights.at(node.first, node.second);
                if (std::abs(z - needed(node.first, node.second)) < 1e-8) continue;  // either will do
                ASSERT_NEAR(std::max(z, -1e3), std::max(fast, -1e3), 1e-9) << node.first << ' ' << node.second;
            }
        }
    }
}

}  // namespace
