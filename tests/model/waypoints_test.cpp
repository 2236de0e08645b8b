// Waypoints: they lie on the maneuver, close enough, with the curvature and direction that lead from one to the next.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "oracle/follower.hpp"
#include "random_maneuvers.hpp"
#include "refusals.hpp"
#include "sample.hpp"
#include "snug/io.hpp"

namespace model {
namespace {

using snug::Waypoint;

bool same_place(const snug::Pose& a, const snug::Pose& b) { return a.x == b.x && a.y == b.y && a.heading == b.heading; }

/// Random maneuvers, and every tenth one that parks, over all maneuvers.
snug::Maneuver some_maneuver(Random& random, int i) {
    if (i % 10 != 0) return random_maneuver(random);
    const snug::Car car = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = random.between(4.8, 5.6), .width = random.between(1.85, 2.2)});
    snug::FewestOptions options;
    options.resolution = 0.01;
    const snug::Answer answer = fewest(car, slot, options);
    return answer.maneuver ? *answer.maneuver : random_maneuver(random);
}

TEST(Waypoints, LieOnTheManeuverWhereTheyCountTheDistance) {
    Random random(1);
    for (int i = 0; i < snug::test::sample(200, 10000); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = some_maneuver(random, i);
        const double spacing = random.between(0.01, 2.0);
        std::size_t move = 0;
        double before = 0.0;  // the moves before this one
        for (const Waypoint& waypoint : waypoints(maneuver, spacing)) {
            const auto& moves = maneuver.moves;
            const auto on_move = [&] {
                const oracle::Path<double> path = oracle::path_of({}, maneuver.car.dimensions(), moves[move]);
                const oracle::Place<double> place = path.at(waypoint.distance - before);
                return waypoint.distance <= before + moves[move].length + 1e-9 &&
                       std::hypot(place.x - waypoint.pose.x, place.y - waypoint.pose.y) < 1e-9 &&
                       std::abs(place.heading - waypoint.pose.heading) < 1e-9 &&
                       waypoint.direction == moves[move].direction;
            };
            while (!on_move() && move + 1 < moves.size()) before += moves[move++].length;
            EXPECT_TRUE(on_move()) << waypoint.distance << " m along, spacing " << spacing;
        }
    }
}

TEST(Waypoints, HoldBothEndsOfEveryMoveAndChangesOfDirectionTwice) {
    Random random(2);
    for (int i = 0; i < snug::test::sample(200, 10000); ++i) {
        SCOPED_TRACE(i);
        const snug::Maneuver maneuver = some_maneuver(random, i);
        const std::vector<Waypoint> all = waypoints(maneuver, random.between(0.01, 2.0));
        std::size_t at = 0;
        const snug::Move* last = nullptr;
        for (const snug::Move& move : maneuver.moves) {
            if (move.length == 0.0) continue;
            if (last != nullptr && last->direction != move.direction) ++at;
            ASSERT_LT(at, all.size());
            EXPECT_TRUE(same_place(all[at].pose, move.start));
            EXPECT_EQ(all[at].direction, move.direction);
            EXPECT_DOUBLE_EQ(all[at].curvature * maneuver.car.wheelbase(), std::tan(move.steering_angle));
            while (at + 1 < all.size() && !same_place(all[at].pose, move.end)) ++at;
            EXPECT_TRUE(same_place(all[at].pose, move.end));
            last = &move;
        }
        EXPECT_EQ(at + 1, all.size());
        EXPECT_NEAR(all.back().distance, maneuver.length(), 1e-12);
    }
}

TEST(Waypoints, AreNoFartherApartThanAskedAndTurnAsTheirCurvatureSays) {
    Random random(3);
    for (int i = 0; i < snug::test::sample(200, 10000); ++i) {
        SCOPED_TRACE(i);
        const double spacing = random.between(0.01, 2.0);
        const std::vector<Waypoint> all = waypoints(some_maneuver(random, i), spacing);
        for (std::size_t k = 1; k < all.size(); ++k) {
            const Waypoint& a = all[k - 1];
            const Waypoint& b = all[k];
            const double driven = b.distance - a.distance;
            EXPECT_LE(driven, spacing * (1.0 + 1e-12));
            EXPECT_LE(std::hypot(b.pose.x - a.pose.x, b.pose.y - a.pose.y), driven + 1e-12);
            if (a.direction != b.direction) {
                EXPECT_TRUE(same_place(a.pose, b.pose));
                EXPECT_EQ(driven, 0.0);
            } else {
                EXPECT_GT(driven, 0.0);
                const double turn = static_cast<int>(a.direction) * a.curvature * driven;
                EXPECT_NEAR(b.pose.heading - a.pose.heading, turn, 1e-12);
            }
        }
    }
}

TEST(Waypoints, AtInfiniteSpacingAreTheEndsOfTheMoves) {
    const snug::Maneuver maneuver =
        *entry(*snug::find_car("renault-zoe"), snug::Slot({.length = 4.5, .width = 2.0})).maneuver;
    EXPECT_EQ(waypoints(maneuver, std::numeric_limits<double>::infinity()).size(), 2 * maneuver.moves.size());
}

TEST(Waypoints, OfACarThatStandsAreOneAndWithoutMovesNone) {
    const snug::Car car = *snug::find_car("renault-zoe");
    EXPECT_TRUE(snug::waypoints({car, {}}, 0.05).empty());
    snug::Move standing;
    standing.start = standing.end = {1.0, 2.0, 3.0};
    const std::vector<Waypoint> all = snug::waypoints({car, {standing, standing}}, 0.05);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(same_place(all[0].pose, standing.start));
}

TEST(Waypoints, AtAnImpossibleSpacingAreRefused) {
    Random random(4);
    const snug::Maneuver maneuver = random_maneuver(random);
    for (const double bad :
         {0.0, -0.05, 1e-10, std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(refusal([&] { (void)waypoints(maneuver, bad); }).find("spacing of waypoints is "), 0U) << bad;
    }
    const std::string sentence = refusal([&] { (void)waypoints(maneuver, 1e-9); });
    EXPECT_NE(sentence.find("more than 1000000"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("take a larger spacing"), std::string::npos) << sentence;
}

TEST(Waypoints, ReadBackFromJsonAndCsvAreTheSameNumbers) {
    Random random(5);
    for (int i = 0; i < snug::test::sample(50, 1000); ++i) {
        SCOPED_TRACE(i);
        const std::vector<Waypoint> all = waypoints(some_maneuver(random, i), random.between(0.01, 2.0));
        const snug::Json json = snug::Json::parse(snug::write(snug::as_json(all)));
        EXPECT_EQ(json["schema"], 1);
        ASSERT_EQ(json["waypoints"].size(), all.size());
        std::istringstream csv(as_csv(all));
        std::string line;
        std::getline(csv, line);
        EXPECT_EQ(line, "x,y,heading,direction,curvature,distance");
        for (std::size_t k = 0; k < all.size(); ++k) {
            const Waypoint& one = all[k];
            const snug::Json& read = json["waypoints"][k];
            const double values[] = {one.pose.x,    one.pose.y,  one.pose.heading, static_cast<double>(one.direction),
                                     one.curvature, one.distance};
            EXPECT_EQ(read["x"].get<double>(), values[0]);
            EXPECT_EQ(read["y"].get<double>(), values[1]);
            EXPECT_EQ(read["heading"].get<double>(), values[2]);
            EXPECT_EQ(read["direction"], to_string(one.direction));
            EXPECT_EQ(read["curvature"].get<double>(), values[4]);
            EXPECT_EQ(read["distance"].get<double>(), values[5]);
            ASSERT_TRUE(std::getline(csv, line));
            std::istringstream cells(line);
            std::string cell;
            for (const double value : values) {
                ASSERT_TRUE(std::getline(cells, cell, ','));
                EXPECT_EQ(std::stod(cell), value) << line;
            }
            EXPECT_FALSE(std::getline(cells, cell, ',')) << line;
        }
        EXPECT_FALSE(std::getline(csv, line));
    }
}

}  // namespace
}  // namespace model
