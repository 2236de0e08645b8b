// Scenes from files: what they say, and what is refused.
#include "snug/scene.hpp"

#include <gtest/gtest.h>

#include <string>

#include "park/judge.hpp"
#include "snug/entry.hpp"
#include "snug/error.hpp"
#include "snug/park.hpp"

namespace {

const std::string parking_lot = R"({
  "obstacles": [ [[0, 0], [5, 0], [5, 2], [0, 2]],
                 {"polygon": [[11, 0], [16, 0], [16, 2], [11, 2]], "name": "van"},
                 {"polygon": [[-5, -1], [21, -1], [21, 0], [-5, 0]], "low": true} ],
  "parked": {"inside": [[5, 0], [11, 0], [11, 2], [5, 2]], "heading": 0, "heading_tolerance": 0.5},
  "start": [12, 4, 0] })";

TEST(Scene, IsReadAndSolved) {
    const snug::Scene scene = snug::scene_from_json(parking_lot, "lot.json");
    EXPECT_EQ(scene.place.obstacles().size(), 3U);
    EXPECT_EQ(scene.place.obstacles()[1].name, "van");
    EXPECT_TRUE(scene.place.obstacles()[2].low);
    EXPECT_EQ(scene.start.x, 12.0);
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const auto answer = park(zoe, scene.place, scene.start);
    ASSERT_TRUE(answer.maneuver);
    EXPECT_TRUE(answer.proved);
    EXPECT_EQ(park_test::verdict(zoe, scene.place, scene.start, answer), "");
}

TEST(Scene, OfTheBenchmarkIsReadAndSolved) {
    // Start, goal, two boxes of four corners.
    const std::string csv = "12,4,0, 6.2,1,0, 2, 4,4, 0,0, 5,0, 5,2, 0,2, 11,0, 16,0, 16,2, 11,2";
    const snug::Scene scene = snug::scene_from_csv(csv, "case.csv");
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const auto answer = park(zoe, scene.place, scene.start);
    ASSERT_TRUE(answer.maneuver);
    EXPECT_EQ(park_test::verdict(zoe, scene.place, scene.start, answer), "");
}

std::string refusal(const std::string& text, bool csv = false) {
    try {
        csv ? snug::scene_from_csv(text, "file") : snug::scene_from_json(text, "file");
    } catch (const snug::Error& error) {
        return error.what();
    }
    return "";
}

TEST(Scene, SaysWhatIsWrong) {
    EXPECT_EQ(refusal("{"), "file: is no valid JSON");
    EXPECT_EQ(refusal("[]"), "file: the scene must be a JSON object");
    EXPECT_EQ(refusal(R"({"obstacle": []})").substr(0, 40), "file: the scene has an unknown key \"obst");
    EXPECT_EQ(refusal(R"({"obstacles": []})"), "file: the scene has no key \"parked\"");
    EXPECT_EQ(refusal(R"({"obstacles": [[[0, 0], [1, "a"], [1, 1]]]})"),
              "file: obstacle [0]: a corner: an entry must be a number");
    EXPECT_EQ(refusal("1, 2, 3, 4, 5", true), "file: value 6 must be a heading");
    EXPECT_EQ(refusal("1, 2, 3, 4, 5, 6, 1.5", true), "file: value 7 is 1.5, but must be the number of obstacles");
}

TEST(Park, RefusesStartsThatMeetSomethingAndSaysWithWhat) {
    const snug::Scene scene = snug::scene_from_json(parking_lot, "lot.json");
    const snug::Car zoe = *snug::find_car("renault-zoe");
    try {
        static_cast<void>(park(zoe, scene.place, {12, 2.5, 0}));
        FAIL();
    } catch (const snug::Error& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 37), "the car starts in contact with the va") << error.what();
    }
    EXPECT_THROW(static_cast<void>(park(zoe, scene.place, {100, 4, 0})), snug::Error);
    EXPECT_THROW(static_cast<void>(park(zoe, scene.place, {12, 4, 3.1})), snug::Error);
}

/// The stops of the paper's maneuver touch a neighbour each; from there it takes no more changes than are left of it.
TEST(Park, FindsTheWayFromAPoseThatTouches) {
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const snug::Slot slot({.length = 4.5, .width = 2.0});
    const std::vector<snug::Move> moves = entry(zoe, slot).maneuver.value().moves;
    const snug::Place place = snug::street_place({.length = 4.5, .width = 2.0});
    snug::ParkOptions options;
    options.roomiest = false;
    for (std::size_t left = 1; left <= 3; ++left) {
        const snug::Move& move = moves[moves.size() - 1 - left];
        ASSERT_TRUE(move.contact);
        const snug::ParkAnswer answer = park(zoe, place, move.end, options);
        ASSERT_TRUE(answer.maneuver) << left;
        EXPECT_LE(*answer.direction_changes, static_cast<int>(left) - 1);
        EXPECT_EQ(park_test::verdict(zoe, place, move.end, answer), "");
    }
}

/// A distance to the curb that no car can keep in the bay is nothing that somebody left in the bay.
TEST(Park, ACurbClearanceThatLeavesNoRoomIsAnAnswer) {
    const snug::Car zoe = *snug::find_car("renault-zoe");
    const snug::Street street{.length = 5.2, .width = 2.0, .road = 3.5, .curb_clearance = 0.3};
    EXPECT_TRUE(park(zoe, street_place(street), standard_start(street, zoe)).impossible);
}

/// 1 m from the neighbours, on whatever side they are, also of a car that is not the same on both.
TEST(Place, TheUsualStartIsMeasuredFromTheSideOfTheSlot) {
    const snug::Car lopsided(snug::Outline({{3.4, 1.1}, {-0.7, 1.1}, {-0.7, -0.8}, {3.4, -0.8}}), 2.5, 0.6);
    EXPECT_DOUBLE_EQ(standard_start({.length = 5.0, .width = 2.5}, lopsided).y, 1.8);
    EXPECT_DOUBLE_EQ(standard_start({.length = 5.0, .width = 2.5, .side = snug::Side::left}, lopsided).y, -2.1);
}

}  // namespace
