// `snug park`: the form of its answers, exit codes and bad input.
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "process.hpp"
#include "sample.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

const std::string park = "park --car renault-zoe ";
const std::string street = park + "--length 5.2 --width 2 --road 3.5 ";
const std::string bay = park + "--length 5 --width 2.5 --road 6 --angle 90 ";

const std::string yard = R"({
  "obstacles": [ [[0, 0], [5, 0], [5, 2], [0, 2]],
                 {"polygon": [[11, 0], [16, 0], [16, 2], [11, 2]], "name": "van"},
                 {"polygon": [[-5, -1], [21, -1], [21, 0], [-5, 0]], "low": true, "name": "curb"} ],
  "parked": {"inside": [[5, 0], [11, 0], [11, 2], [5, 2]], "heading": 0, "heading_tolerance": 0.5},
  "start": [12, 4, 0] })";

/// The yard with one thing said otherwise.
std::string yard_with(const std::string& what, const std::string& instead) {
    std::string text = yard;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, text.npos) << what;
    return text.replace(at, what.size(), instead);
}

/// The moves lead from the start to the goal.
void expect_connected(const Json& json) {
    const Json& maneuver = json["maneuver"];
    ASSERT_FALSE(maneuver["moves"].empty());
    Json at = json["start"];
    EXPECT_EQ(maneuver["start"], at);
    double length = 0.0;
    int changes = 0;
    std::string direction;
    for (const Json& move : maneuver["moves"]) {
        EXPECT_EQ(move["start"], at);
        changes += !direction.empty() && move["direction"] != direction;
        direction = move["direction"];
        length += move["length"].get<double>();
        at = move["end"];
    }
    EXPECT_EQ(maneuver["goal"], at);
    EXPECT_EQ(maneuver["direction_changes"], changes);
    EXPECT_NEAR(maneuver["length"].get<double>(), length, 1e-9);
}

TEST(ParkCommand, SaysThatItEndsAcrossABayWhoseSidesWereTakenForOneAnother) {
    const Result across = run(park + "--length 2.3 --width 5 --road 4 --angle 90");
    ASSERT_EQ(across.exit_code, 0) << across.err;
    EXPECT_NE(across.out.find("ends across the slot: --length is measured along the parked car"), across.out.npos)
        << across.out;
    EXPECT_EQ(run(bay).out.find("ends across"), std::string::npos);
}

TEST(ParkCommand, SteersOnlyWhileItRolls) {
    const Folder folder;
    const std::string file = folder.file("way.json");
    const Result result = run(bay + "--steer moving --format json --trajectory " + file);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["steer"], "moving");
    EXPECT_GE(json["direction_changes"], json["lower_bound"]);
    expect_connected(json);
    double angle = 0.0;
    for (const Json& move : json["maneuver"]["moves"]) {
        EXPECT_NEAR(move["steering_angle"].get<double>(), angle, 1e-9);
        angle = move["steering_angle_end"].get<double>();
        EXPECT_LE(std::abs(angle), json["car"]["max_steer"].get<double>() + 1e-9);
    }
    std::ifstream stream(file);
    const Json timed = Json::parse(stream);
    EXPECT_EQ(timed["standing_steers"], 0);
    EXPECT_EQ(timed["seconds"], json["maneuver"]["seconds"]);
    for (const Json& point : timed["trajectory"]) {
        EXPECT_LE(std::abs(point["steering_rate"].get<double>()), 0.5 + 1e-9);
        if (point["speed"] == 0.0) {
            EXPECT_EQ(point["steering_rate"], 0.0);
        }
    }
    EXPECT_NE(run(bay + "--steer moving").out.find("steers only while it rolls"), std::string::npos);
}

TEST(ParkCommand, AnswersWithManeuverAndProof) {
    const Result result = run(street + "--format json");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.err, "");
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["schema"], 1);
    EXPECT_EQ(json["car"]["name"], "renault-zoe");
    EXPECT_EQ(json["slot"]["road"], 3.5);
    EXPECT_EQ(json["slot"]["angle"], 0.0);
    EXPECT_EQ(json["slot"]["stretch"], 10.0);
    EXPECT_EQ(json["parkable"], true);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["direction_changes"], json["lower_bound"]);
    EXPECT_GT(json["spacing"], 0.0);
    expect_connected(json);
    for (const Json& move : json["maneuver"]["moves"]) EXPECT_GE(move["nearest"]["distance"], 0.0);
}

TEST(ParkCommand, FromAheadOfTheSlotOneChangeIsEnough) {
    const Json json = Json::parse(run(street + "--from 2,1.75,0 --format json").out);
    EXPECT_EQ(json["start"], Json({{"x", 2.0}, {"y", 1.75}, {"heading", 0.0}}));
    EXPECT_EQ(json["direction_changes"], 1);
    EXPECT_EQ(json["proved"], true);
}

TEST(ParkCommand, BaysAreEnteredTailAndNoseFirst) {
    for (const char* enter : {"backward", "forward"}) {
        const Json json = Json::parse(run(bay + "--format json --enter " + enter).out);
        EXPECT_EQ(json["parkable"], true) << enter;
        EXPECT_EQ(json["maneuver"]["moves"].back()["direction"], enter);
        expect_connected(json);
    }
}

TEST(ParkCommand, WordsFitTheScreenAndSayWhatIsProved) {
    for (const std::string& question : {street, street + "--clearance 0.05", bay + "--side left"}) {
        const Result result = run(question);
        EXPECT_EQ(result.exit_code, 0);
        for (const char* said : {"renault-zoe parks in the", "Where it stands", "What to do", "backward",
                                 "stop: parked", "How it ends", "No maneuver", "proved"})
            EXPECT_NE(result.out.find(said), std::string::npos) << said << '\n' << result.out;
        std::istringstream lines(result.out);
        for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    }
}

TEST(ParkCommand, CsvHasARowForEveryMove) {
    const Json json = Json::parse(run(street + "--format json").out);
    const std::string csv = run(street + "--format csv").out;
    EXPECT_EQ(csv.substr(0, csv.find('\n')),
              "direction,steering_angle,length,start_x,start_y,start_heading,end_x,end_y,end_heading,nearest_car,"
              "nearest_obstacle,nearest_distance");
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), json["maneuver"]["moves"].size() + 1);
}

TEST(ParkCommand, MirroredStreetsHaveMirroredAnswers) {
    const Json right = Json::parse(run(street + "--format json").out);
    const Json left = Json::parse(run(street + "--side left --format json").out);
    EXPECT_EQ(right["direction_changes"], left["direction_changes"]);
    EXPECT_NEAR(right["start"]["y"].get<double>(), -left["start"]["y"].get<double>(), 1e-12);
}

TEST(ParkCommand, ThatNoNumberOfChangesWillDoIsProved) {
    const std::string narrow = park + "--length 5 --width 2.1 --angle 90 --road 3 --enter forward ";
    const Result result = run(narrow + "--format json");
    EXPECT_EQ(result.exit_code, 1);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["parkable"], false);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["impossible"], true);
    EXPECT_FALSE(json.contains("maneuver"));
    EXPECT_NE(run(narrow).out.find("no number of direction changes"), std::string::npos);
}

TEST(ParkCommand, TooFewChangesAreProvedTooFew) {
    const Result result = run(street + "--max-changes 1 --format json");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(Json::parse(result.out)["lower_bound"], 2);
}

TEST(ParkCommand, SaysHowMuchTheSlotIsTooSmall) {
    const Result result = run(park + "--length 4 --width 1.7");
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("0.084 m too short and 0.071 m too narrow"), std::string::npos) << result.out;
}

TEST(ParkCommand, WithoutTimeNothingIsDecided) {
    const Result result = run(street + "--time-limit 0 --format json");
    EXPECT_EQ(result.exit_code, 3);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["parkable"], nullptr);
    EXPECT_EQ(json["proved"], false);
}

TEST(ParkCommand, CtrlCEndsWithTheBoundsSoFar) {
    using namespace std::chrono_literals;
    const Folder folder;
    const pid_t child = start(words(park + "--length 4.35 --width 1.82 --road 2.3 --resolution 0.0005 --format json"),
                              folder.file("out"), folder.file("err"));
    std::this_thread::sleep_for(3s);
    kill(child, SIGINT);
    EXPECT_EQ(wait_for(child), 130);
    EXPECT_TRUE(Json::parse(contents(folder.file("out"))).contains("lower_bound"));
}

TEST(ParkCommand, ScenesAreReadAndEchoedAsScenes) {
    const Folder folder;
    const Json json = Json::parse(run(park + "--format json --scene " + folder.with("yard.json", yard)).out);
    EXPECT_EQ(json["parkable"], true);
    EXPECT_FALSE(json.contains("slot"));
    expect_connected(json);
    const Json again =
        Json::parse(run(park + "--format json --scene " + folder.with("again.json", json["scene"].dump())).out);
    EXPECT_EQ(again, json);
}

TEST(ParkCommand, CasesOfTheBenchmarkAreRead) {
    const Folder folder;
    const std::string file =
        folder.with("case.csv", "12,4,0, 6.2,1,0, 2, 4,4, 0,0, 5,0, 5,2, 0,2, 11,0, 16,0, 16,2, 11,2");
    const Json json = Json::parse(run(park + "--format json --scene " + file).out);
    EXPECT_EQ(json["scene"]["parked"]["pose"], Json({6.2, 1.0, 0.0}));
    expect_connected(json);
}

/// Places like those of the benchmark, whose files have no licence: docs/peers.md has the table.
TEST(ParkCommand, PlacesLikeThoseOfTheBenchmarkTakeWhatTheDocumentSays) {
    const std::filesystem::path docs = std::filesystem::path(SNUG_ROOT) / "docs", scenes = docs / "scenes";
    const std::string table = contents(docs / "peers.md");
    int shown = 0;
    for (const std::string place : {"bay", "narrow-aisle", "slanted", "yard", "kerbside"}) {
        if (place == "kerbside" && !is_set("SNUG_SOAK")) continue;  // takes several seconds
        const Result result = run("park --car " + (scenes / "car.json").string() + " --scene " +
                                  (scenes / (place + ".json")).string() + " --format json");
        ASSERT_EQ(result.exit_code, 0) << place << ": " << result.err;
        const Json json = Json::parse(result.out);
        EXPECT_EQ(json["proved"], true) << place;
        const std::string row =
            "`" + place + "` | " + std::to_string(json["direction_changes"].get<int>()) + ", proved |";
        EXPECT_NE(table.find(row), table.npos) << row;
        ++shown;
    }
    EXPECT_GE(shown, 4);
}

/// Where other planners were set beside it; docs/peers.md has the table.
TEST(ParkCommand, TheStreetsOfThePeersTakeWhatTheDocumentSays) {
    const std::string table = contents(std::filesystem::path(SNUG_ROOT) / "docs" / "peers.md");
    for (const std::string length : {"5.2", "4.8"}) {
        const Result result = run(park + "--length " + length + " --width 2 --road 3.5 --from 2,1.75,0 --format json");
        const Json json = Json::parse(result.out);
        EXPECT_EQ(json["proved"], true) << length;
        const std::string row =
            "| " + length + " x 2.0 m | " + std::to_string(json["direction_changes"].get<int>()) + ", proved |";
        EXPECT_NE(table.find(row), table.npos) << row;
    }
}

/// What stands at the end of a row of "What would do": the option to give; empty where the clock was faster.
std::string would_do(const std::string& text, const std::string& row) {
    const std::size_t at = text.find("\n  " + row);
    if (at == text.npos) return "";
    const std::string line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
    return line.substr(line.find("--"));
}

/// A no says what would do, and what it says does.
TEST(ParkCommand, ANoNamesAWayOutThatDoes) {
    struct Question {
        std::string words, row, without;  ///< `without`: the option that the row says anew
    };
    const std::string from_here = " --from 2,1.5,0 ";
    int told = 0;
    for (const Question& question : std::vector<Question>{
             {"--length 4.8 --width 2 --road 3.5" + from_here + "--max-changes 2", "more changes", "--max-changes 2"},
             {"--length 5.2 --width 2 --road 3.5" + from_here + "--max-changes 0", "a longer slot", "--length 5.2"},
             {"--length 5 --width 2.5 --angle 90 --from 4,1.6,0 --max-changes 1 --road 3.2", "a wider road",
              "--road 3.2"},
             {"--length 5.2 --width 2 --road 3.5" + from_here + "--max-changes 0 --clearance 0.3", "a longer slot",
              "--length 5.2"}}) {
        const Result no = run(park + question.words);
        EXPECT_EQ(no.exit_code, 1) << question.words;
        const std::string instead = would_do(no.out, question.row);
        if (instead.empty()) continue;
        ++told;
        std::string words = question.words;
        words.replace(words.find(question.without), question.without.size(), instead);
        EXPECT_EQ(run(park + words).exit_code, 0) << question.words << " and then " << instead;
    }
    EXPECT_GT(told, 1);
}

TEST(LeaveCommand, ANoNamesAWayOutThatDoes) {
    const std::string tight = "leave --car renault-zoe --width 2 --gap-front 0.5 --gap-curb 0.1 ";
    const Result no = run(tight + "--length 5.2 --max-changes 2");
    EXPECT_EQ(no.exit_code, 1);
    EXPECT_EQ(run(tight + "--length 5.2 " + would_do(no.out, "more changes")).exit_code, 0) << no.out;
    EXPECT_EQ(run(tight + would_do(no.out, "a longer slot") + " --max-changes 2").exit_code, 0) << no.out;
}

TEST(LeaveCommand, WhereTimeRanOutNothingIsClaimedOfTheWay) {
    const Result found =
        run("leave --car mid-size --length 5.6 --width 2.1 --gap-front 0.4 --gap-curb 0.15 --time-limit 0.01");
    EXPECT_EQ(found.exit_code, 0) << found.out;  // what can be found in a millisecond is found first
    if (found.out.find("not known") != found.out.npos) {
        EXPECT_NE(found.out.find("Found before the time was up"), found.out.npos) << found.out;
        EXPECT_EQ(found.out.find("fewer than 0"), found.out.npos) << found.out;
    }
}

TEST(ParkCommand, PlacesFarOutInTheWorldAreTheSame) {
    const Json here = Json::parse(run(street + "--format json").out);
    const Json there = Json::parse(run(street + "--corner 458123.25,5428377.5 --format json").out);
    EXPECT_EQ(here["direction_changes"], there["direction_changes"]);
    EXPECT_NEAR(here["maneuver"]["length"].get<double>(), there["maneuver"]["length"].get<double>(), 1e-3);
}

TEST(ParkCommand, WritesPicturesAndWaypoints) {
    const Folder folder;
    EXPECT_EQ(run(bay + "--draw " + folder.file("way.svg") + " --waypoints " + folder.file("way.csv")).exit_code, 0);
    EXPECT_NE(contents(folder.file("way.svg")).find("<title>renault-zoe, slot 5.00 m"), std::string::npos);
    const std::string way = contents(folder.file("way.csv"));
    EXPECT_EQ(way.substr(0, way.find('\n')), "x,y,heading,direction,curvature,distance");
    EXPECT_EQ(run(park + "--length 4 --width 2 --draw " + folder.file("none.svg")).exit_code, 1);
    EXPECT_EQ(run(park + "--draw " + folder.file("yard.png") + " --scene " + folder.with("yard.json", yard)).exit_code,
              0);
}

TEST(ParkCommand, DrawsFromWhereHowManyChangesAreNeeded) {
    const Folder folder;
    EXPECT_EQ(run(street + "--from 2,1.75,0 --view map --draw " + folder.file("map.svg")).exit_code, 0);
    const std::string map = contents(folder.file("map.svg"));
    EXPECT_NE(map.find("from where it stands 1 direction change, proved the fewest</title>"), std::string::npos);
    EXPECT_EQ(run(park + "--length 4 --width 2 --view map --draw " + folder.file("none.svg")).exit_code, 1);
    EXPECT_NE(contents(folder.file("none.svg")).find("no number of changes will do</title>"), std::string::npos);
    EXPECT_EQ(run(park + "--view map --draw " + folder.file("yard.png") + " --scene " + folder.with("yard.json", yard))
                  .exit_code,
              0);
    expect_refusal(run(street + "--view map"), {"--view belongs to --draw"});
    expect_refusal(run(street + "--view entries --draw " + folder.file("x.svg")), {"--view", "maneuver", "map"});
}

TEST(LeaveCommand, LeavesBaysAndNarrowRoads) {
    const std::string out = "leave --car renault-zoe --length 5 --width 2.5 --angle 90 --road 5 ";
    const Json json = Json::parse(run(out + "--from -1.25,-4,1.5708 --format json").out);
    EXPECT_EQ(json["direction_changes"], 0);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["slot"]["road"], 5.0);
    expect_connected(json);
    EXPECT_NEAR(json["maneuver"]["goal"]["heading"].get<double>(), 0.0, 0.1);
    const std::string parked = "leave --car renault-zoe --length 5.2 --width 2 --gap-front 0.3 --gap-curb 0.1 ";
    const Json narrow = Json::parse(run(parked + "--road 3 --format json").out);
    const Json open = Json::parse(run(parked + "--format json").out);
    EXPECT_GE(narrow["direction_changes"], open["lower_bound"]);
    EXPECT_NE(run(out + "--from -1.25,-4,1.5708").out.find("stop: out on the road"), std::string::npos);
    expect_refusal(run(out), {"--from is missing"});
    expect_refusal(run(parked + "--from 1,2,3"), {"--gap-front", "--from", "exclude"});
}

TEST(ParkCommand, BadStreetsAreRefused) {
    expect_refusal(run(park), {"no place is given", "--length", "--scene"});
    expect_refusal(run("park --length 5 --width 2"), {"--car is missing"});
    expect_refusal(run(park + "--length 5"), {"--width is missing"});
    expect_refusal(run(street + "--angle 91"), {"--angle is 91 degrees"});
    expect_refusal(run(street + "--stretch -1"), {"--stretch"});
    expect_refusal(run(street + "--from 1,2"), {"--from", "X,Y,HEADING"});
    expect_refusal(run(street + "--from 0,0,0"), {"in contact with the front neighbour, 0.8855 m deep"});
    expect_refusal(run(street + "--from 0,2.9,0"), {"in contact with the far side"});
    expect_refusal(run(street + "--from 50,2,0"), {"outside the region, by 40 m"});
    expect_refusal(run(street + "--from 2,1.75,3.1"), {"177.6 degrees apart", "150"});
    expect_refusal(run(street + "--spacing 1"), {"--spacing", "--waypoints"});
    expect_refusal(run(street + "--strategy fewest"), {"--strategy"});
    expect_refusal(run(park + "--length 5 --width 2 --stretch 2000"), {"at most 100 are supported", "smaller"});
}

TEST(ParkCommand, BadScenesAreRefused) {
    const Folder folder;
    const auto refuses = [&](const std::string& text, const std::vector<std::string>& named) {
        expect_refusal(run(park + "--scene " + folder.with("bad.json", text)), named);
    };
    refuses("", {"bad.json: is empty"});
    refuses("{", {"bad.json: is no valid JSON"});
    refuses(yard_with("[16, 0], [16, 2]", "[16, 2], [16, 0]"), {"obstacle [1] (van) crosses itself"});
    refuses(yard_with("[[0, 0], [5, 0], [5, 2], [0, 2]]", "[[0, 0], [5, 0]]"), {"obstacle [0] has 2 corners"});
    refuses(yard_with("\"start\": [12, 4, 0]", "\"start\": [12, 2.5, 0]"),
            {"starts in contact with the van, 0.3855 m deep"});
    refuses(yard_with("\"obstacles\": [",
                      "\"obstacles\": [ {\"polygon\": [[6, 0.5], [10, 0.5], [10, 1], [6, 1]], "
                      "\"name\": \"bin\"}, "),
            {"the goal is covered by the bin"});
    refuses(yard_with("\"start\": [12, 4, 0]",
                      "\"start\": [12, 4, 0], \"region\": {\"x_min\": 0, \"x_max\": 9, "
                      "\"y_min\": 0, \"y_max\": 9}"),
            {"outside the region, by 3 m"});
    refuses(R"({"obstacles": [], "parked": {"pose": [0, 0, 0], "tolerance": [0.1, 0.1, 0.1]}, "start": [5, 5, 0]})",
            {"the scene is empty"});
    expect_refusal(run(park + "--scene " + folder.file("none.json")), {"--scene", "none.json", "cannot be read"});
    const std::string good = folder.with("yard.json", yard);
    expect_refusal(run(park + "--length 5 --scene " + good), {"--length", "--scene"});
    expect_refusal(run(park + "--enter forward --scene " + good), {"--enter", "--scene"});
}

TEST(Park, ACarThatStandsParkedIsToldSo) {
    const std::string parked = "park --car renault-zoe --length 5.2 --width 2 --road 3.5 --from -4,-1,0.01 ";
    const Result text = run(parked);
    EXPECT_EQ(text.exit_code, 0) << text.err;
    EXPECT_NE(text.out.find("is parked already"), text.out.npos) << text.out;
    const Json answer = Json::parse(run(parked + "--format json").out);
    EXPECT_EQ(answer["direction_changes"], 0);
    EXPECT_TRUE(answer["maneuver"]["moves"].empty());
    EXPECT_EQ(answer["maneuver"]["goal"], answer["start"]);
    EXPECT_EQ(run(parked + "--format csv").exit_code, 0);
}

}  // namespace
}  // namespace snug::test
