// Maneuvers: where the car is along its moves, and the box it sweeps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>

#include "numbers.hpp"
#include "random_maneuvers.hpp"
#include "refusals.hpp"
#include "sample.hpp"

namespace model {
namespace {

using snug::Direction;

snug::Car renault() { return snug::Car({1.771, 3.427, 0.657, 2.588, 33 * degree}); }

void expect_same(const snug::Pose& a, const snug::Pose& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.heading, b.heading, tolerance);
}

void expect_same(const snug::Box& a, const snug::Box& b, double tolerance) {
    EXPECT_NEAR(a.x_min, b.x_min, tolerance);
    EXPECT_NEAR(a.x_max, b.x_max, tolerance);
    EXPECT_NEAR(a.y_min, b.y_min, tolerance);
    EXPECT_NEAR(a.y_max, b.y_max, tolerance);
}

double apart(const snug::Pose& a, const snug::Pose& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The corners of every frame along a maneuver, seen closely.
snug::Box sampled_box(const snug::Maneuver& maneuver, double spacing) {
    snug::Box box{1e9, -1e9, 1e9, -1e9};
    for (const snug::Pose& pose : maneuver.poses(spacing)) {
        for (const snug::Point& corner : frame(maneuver.car, pose)) {
            box.x_min = std::min(box.x_min, corner.x);
            box.x_max = std::max(box.x_max, corner.x);
            box.y_min = std::min(box.y_min, corner.y);
            box.y_max = std::max(box.y_max, corner.y);
        }
    }
    return box;
}

TEST(Drive, StraightKeepsTheHeading) {
    const snug::Pose start{1.0, 2.0, 0.6};
    const snug::Pose ahead = drive(renault(), start, Direction::forward, 0.0, 5.0);
    expect_same(ahead, {1.0 + 5.0 * std::cos(0.6), 2.0 + 5.0 * std::sin(0.6), 0.6}, 1e-15);
    const snug::Pose behind = drive(renault(), start, Direction::backward, 0.0, 5.0);
    expect_same(behind, {1.0 - 5.0 * std::cos(0.6), 2.0 - 5.0 * std::sin(0.6), 0.6}, 1e-15);
}

TEST(Drive, TurnsAboutTheCentreOfItsCircle) {
    Random random(1);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        const snug::Pose start = random_pose(random);
        const double radius = (random.chance(0.5) ? 1.0 : -1.0) * car.turning_radius() * random.between(1.0, 10.0);
        const double turn = random.between(0.0, 9.0);
        const auto direction = random.chance(0.5) ? Direction::forward : Direction::backward;
        const double steering = std::atan(car.wheelbase() / radius);
        const snug::Pose end = drive(car, start, direction, steering, turn * std::abs(radius));

        const double sense = (direction == Direction::forward ? 1.0 : -1.0) * (radius > 0.0 ? 1.0 : -1.0);
        EXPECT_NEAR(end.heading, start.heading + sense * turn, 1e-12);
        // The centre lies abeam, to the left for steering to the left; it is the same seen from both ends.
        EXPECT_NEAR(start.x - radius * std::sin(start.heading), end.x - radius * std::sin(end.heading), 1e-10);
        EXPECT_NEAR(start.y + radius * std::cos(start.heading), end.y + radius * std::cos(end.heading), 1e-10);
    }
}

TEST(Drive, SolvesTheKinematicsOfThePaper) {
    // Equation 1 with the heading of the middle of each step converges quadratically.
    Random random(2);
    for (int i = 0; i < snug::test::sample(20, 200); ++i) {
        const snug::Car car = random_car(random);
        const snug::Pose start = random_pose(random);
        const double steering = random_steering(random, car);
        const double s = random.chance(0.5) ? 1.0 : -1.0;
        const int steps = 20000;
        const double delta = 4.0 / steps;
        const double turn = s * delta / car.wheelbase() * std::tan(steering);
        snug::Pose at = start;
        for (int k = 0; k < steps; ++k) {
            at.x += s * delta * std::cos(at.heading + turn / 2);
            at.y += s * delta * std::sin(at.heading + turn / 2);
            at.heading += turn;
        }
        expect_same(drive(car, start, s > 0 ? Direction::forward : Direction::backward, steering, 4.0), at, 1e-7);
    }
}

TEST(Drive, TwoStretchesAreOneLongStretch) {
    Random random(3);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        const snug::Pose start = random_pose(random);
        const auto direction = random.chance(0.5) ? Direction::forward : Direction::backward;
        const double steering = random_steering(random, car);
        const double first = random.between(0.0, 10.0);
        const double second = random.between(0.0, 10.0);
        const snug::Pose between = drive(car, start, direction, steering, first);
        expect_same(drive(car, between, direction, steering, second),
                    drive(car, start, direction, steering, first + second), 1e-12);
    }
}

TEST(Drive, ForwardUndoesBackward) {
    Random random(4);
    for (int i = 0; i < snug::test::sample(1000, 100000); ++i) {
        const snug::Car car = random_car(random);
        const snug::Pose start = random_pose(random);
        const double steering = random_steering(random, car);
        const double distance = random.between(0.0, 10.0);
        const snug::Pose away = drive(car, start, Direction::backward, steering, distance);
        expect_same(drive(car, away, Direction::forward, steering, distance), start, 1e-12);
    }
}

TEST(Drive, NoDistanceIsNoMotion) {
    const snug::Pose start{1.25, -3.5, 0.7};
    for (const double steering : {0.0, 1e-300, 0.3, -33 * degree}) {
        const snug::Pose end = drive(renault(), start, Direction::forward, steering, 0.0);
        EXPECT_EQ(end.x, start.x);
        EXPECT_EQ(end.y, start.y);
        EXPECT_EQ(end.heading, start.heading);
    }
}

TEST(Drive, GentleSteeringBendsTheLineByHalfTheCurvatureTimesTheSquare) {
    // On so large a circle y = distance^2 / 2 radius to the last digits, which a centre far away would have swallowed.
    for (const double curvature : {1e-5, 1e-8, 1e-12, 1e-100, 1e-300}) {
        const snug::Car car = renault();
        const double steering = std::atan(curvature * car.wheelbase());
        const snug::Pose end = drive(car, {}, Direction::forward, steering, 3.0);
        EXPECT_NEAR(end.x, 3.0, 1e-9);
        EXPECT_NEAR(end.y / (curvature * 4.5), 1.0, 1e-9) << curvature;
        EXPECT_NEAR(end.heading / (curvature * 3.0), 1.0, 1e-14) << curvature;
    }
}

TEST(Maneuver, CountsTheChangesOfDirectionOnly) {
    const auto with = [](std::initializer_list<Direction> directions) {
        snug::Maneuver maneuver{renault(), {}};
        for (const Direction direction : directions) {
            snug::Move move;
            move.direction = direction;
            maneuver.moves.push_back(move);
        }
        return maneuver;
    };
    const auto back = Direction::backward;
    const auto forth = Direction::forward;
    EXPECT_EQ(with({}).direction_changes(), 0);
    EXPECT_EQ(with({back}).direction_changes(), 0);
    EXPECT_EQ(with({back, back, back}).direction_changes(), 0);
    EXPECT_EQ(with({back, forth}).direction_changes(), 1);
    EXPECT_EQ(with({back, back, forth, forth, back}).direction_changes(), 2);
}

TEST(Maneuver, StartsAtItsEntryEndsAtItsGoalAndIsAsLongAsItsMoves) {
    Random random(5);
    for (int i = 0; i < snug::test::sample(200, 10000); ++i) {
        const snug::Maneuver maneuver = random_maneuver(random);
        double length = 0.0;
        for (const snug::Move& move : maneuver.moves) {
            length += move.length;
        }
        EXPECT_DOUBLE_EQ(maneuver.length(), length);
        expect_same(maneuver.entry(), maneuver.moves.front().start, 0.0);
        expect_same(maneuver.goal(), maneuver.moves.back().end, 0.0);
    }
}

TEST(Maneuver, PosesFollowItClosely) {
    Random random(6);
    for (int i = 0; i < snug::test::sample(200, 10000); ++i) {
        const snug::Maneuver maneuver = random_maneuver(random);
        const double spacing = random.between(0.01, 2.0);
        const std::vector<snug::Pose> poses = maneuver.poses(spacing);
        expect_same(poses.front(), maneuver.entry(), 0.0);
        expect_same(poses.back(), maneuver.goal(), 0.0);
        for (std::size_t k = 1; k < poses.size(); ++k) {
            EXPECT_LE(apart(poses[k - 1], poses[k]), spacing * (1 + 1e-12));
        }
        // The ends of the moves are among them, in order, with no more between than the spacing asks for.
        std::size_t k = 0;
        double fewest = 1.0;
        for (const snug::Move& move : maneuver.moves) {
            while (k < poses.size() && (poses[k].x != move.end.x || poses[k].y != move.end.y)) {
                ++k;
            }
            ASSERT_LT(k, poses.size());
            fewest += std::max(1.0, std::ceil(move.length / spacing));
        }
        EXPECT_EQ(static_cast<double>(poses.size()), fewest);
    }
}

TEST(Maneuver, PosesAtInfiniteSpacingAreTheEndsOfTheMoves) {
    Random random(7);
    const snug::Maneuver maneuver = random_maneuver(random);
    EXPECT_EQ(maneuver.poses(std::numeric_limits<double>::infinity()).size(), maneuver.moves.size() + 1);
}

TEST(Maneuver, PosesAtAnImpossibleSpacingAreRefused) {
    Random random(8);
    const snug::Maneuver maneuver = random_maneuver(random);
    for (const double bad : {0.0, -1.0, 1e-10, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(refusal([&] { (void)maneuver.poses(bad); }).find("spacing of poses is "), 0U) << bad;
    }
}

TEST(Maneuver, WithoutMovesHasNoPosesAndSweepsNothing) {
    const snug::Maneuver maneuver{renault(), {}};
    EXPECT_TRUE(maneuver.poses(0.1).empty());
    expect_same(swept(maneuver), {}, 0.0);
}

TEST(Swept, ContainsEveryFrameAndTouchesThem) {
    Random random(9);
    const double spacing = 1e-3;
    for (int i = 0; i < snug::test::sample(200, 5000); ++i) {
        const snug::Maneuver maneuver = random_maneuver(random);
        const snug::Box box = swept(maneuver);
        const snug::Box sampled = sampled_box(maneuver, spacing);
        EXPECT_LE(box.x_min, sampled.x_min + 1e-12);
        EXPECT_GE(box.x_max, sampled.x_max - 1e-12);
        EXPECT_LE(box.y_min, sampled.y_min + 1e-12);
        EXPECT_GE(box.y_max, sampled.y_max - 1e-12);
        // Between two samples a corner rises by no more than the sagitta of its arc.
        const snug::Car& car = maneuver.car;
        const double turn = spacing / car.turning_radius();
        const double reach = std::hypot(car.turning_radius() + car.width() / 2, std::max(car.front(), car.rear()));
        expect_same(box, sampled, reach * turn * turn / 8 + 1e-12);
    }
}

TEST(Swept, ByAFullCircleIsTheSquareAroundTheFarthestCorner) {
    const snug::Car car = renault();
    const double r = car.turning_radius();
    snug::Move circle;
    circle.direction = Direction::forward;
    circle.steering_angle = car.max_steer();
    circle.length = 2.0 * std::numbers::pi * r;
    for (const double heading : {0.0, 0.4, 2.0, -5.0}) {
        circle.start = {0.0, 0.0, heading};
        circle.end = drive(car, circle.start, circle.direction, circle.steering_angle, circle.length);
        expect_same(circle.end, {0.0, 0.0, heading + 2.0 * std::numbers::pi}, 1e-14);
        const double far = std::hypot(r + car.width() / 2, car.front());
        const snug::Point centre{-r * std::sin(heading), r * std::cos(heading)};
        expect_same(snug::swept({car, {circle}}), {centre.x - far, centre.x + far, centre.y - far, centre.y + far},
                    1e-13);
    }
}

TEST(Swept, ByAStandingCarIsItsFrame) {
    const snug::Car car = renault();
    snug::Move standing;
    standing.steering_angle = car.max_steer();
    expect_same(snug::swept({car, {standing}}), {-0.657, 3.427, -1.771 / 2, 1.771 / 2}, 1e-15);
}

TEST(Swept, InASlotDoesNotDependOnWhereTheSlotIs) {
    Random random(10);
    for (int i = 0; i < snug::test::sample(500, 20000); ++i) {
        const snug::Maneuver maneuver = random_maneuver(random);  // read as driven in the slot frame
        const snug::Slot slot = random_slot(random);
        snug::Maneuver in_world = maneuver;
        for (snug::Move& move : in_world.moves) {
            move.start = slot.to_world(move.start);
            move.end = slot.to_world(move.end);
            move.steering_angle = slot.mirrored(move.steering_angle);
        }
        expect_same(swept(in_world, slot), swept(maneuver), 1e-11);
    }
}

TEST(Words, NameEveryPartObstacleAndDirection) {
    using enum snug::CarPart;
    std::set<std::string_view> parts;
    for (const snug::CarPart part : {front_left_corner, rear_left_corner, rear_right_corner, front_right_corner,
                                     front_edge, left_edge, rear_edge, right_edge}) {
        parts.insert(to_string(part));
    }
    EXPECT_EQ(parts,
              (std::set<std::string_view>{"front-left corner", "rear-left corner", "rear-right corner",
                                          "front-right corner", "front edge", "left edge", "rear edge", "right edge"}));
    EXPECT_EQ(to_string(rear_right_corner), "rear-right corner");
    EXPECT_EQ(to_string(left_edge), "left edge");
    EXPECT_EQ(to_string(snug::Obstacle::front_side), "front side");
    EXPECT_EQ(to_string(snug::Obstacle::rear_side), "rear side");
    EXPECT_EQ(to_string(snug::Obstacle::curb), "curb");
    EXPECT_EQ(to_string(snug::Obstacle::front_corner), "front corner");
    EXPECT_EQ(to_string(snug::Obstacle::rear_corner), "rear corner");
    EXPECT_EQ(to_string(Direction::backward), "backward");
    EXPECT_EQ(to_string(Direction::forward), "forward");
}

TEST(Words, MirroringAPartSwapsLeftAndRight) {
    using enum snug::CarPart;
    for (const snug::CarPart part : {front_left_corner, rear_left_corner, rear_right_corner, front_right_corner,
                                     front_edge, left_edge, rear_edge, right_edge}) {
        std::string expected(to_string(part));
        if (const auto left = expected.find("left"); left != std::string::npos) {
            expected.replace(left, 4, "right");
        } else if (const auto right = expected.find("right"); right != std::string::npos) {
            expected.replace(right, 5, "left");
        }
        EXPECT_EQ(to_string(mirrored(part)), expected);
        EXPECT_EQ(mirrored(mirrored(part)), part);
    }
}

}  // namespace
}  // namespace model
