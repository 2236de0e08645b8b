// --waypoints and --trajectory write what path followers read, or say why not before anything is written.
#include <nlohmann/json.hpp>

#include "questions.hpp"

namespace snug::test {
namespace {

const std::string out = "leave --car renault-zoe --length 5 --width 2 --gap-front 0.3 --gap-curb 0.1 ";

std::size_t rows(const std::string& csv) {
    return static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) - 1;
}

TEST(Waypoints, AreWrittenBesideTheAnswer) {
    const Folder folder;
    for (const std::string& question : {zoe, zoe + "--strategy fewest ", out}) {
        const std::string csv = folder.file("w.csv");
        const std::string json = folder.file("w.JSON");
        const Result result = run(question + "--format json --waypoints " + csv);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(run(question + "--format json --waypoints " + json + " --spacing 0.05").out, result.out);
        const auto answer = nlohmann::json::parse(result.out);
        const auto all = nlohmann::json::parse(contents(json))["waypoints"];
        EXPECT_EQ(rows(contents(csv)), all.size()) << "the usual spacing is 0.05 m";
        for (const char* key : {"x", "y", "heading"}) {
            EXPECT_EQ(all.front()[key], answer["maneuver"]["entry"][key]);
            EXPECT_EQ(all.back()[key], answer["maneuver"]["goal"][key]);
        }
        EXPECT_NEAR(all.back()["distance"].get<double>(), answer["maneuver"]["length"].get<double>(), 1e-12);
        run(question + "--waypoints " + csv + " --spacing 0.01");
        EXPECT_GT(rows(contents(csv)), 3 * all.size());
    }
    EXPECT_EQ(folder.files(), 2U);
}

TEST(Waypoints, OfACarThatCannotParkAreNone) {
    const Folder folder;
    const std::string file = folder.with("w.csv", "those of yesterday");
    EXPECT_EQ(run("entry --car renault-zoe --length 4.1 --width 2 --waypoints " + file).exit_code, 1);
    EXPECT_EQ(contents(file), "x,y,heading,direction,curvature,distance\n");
}

TEST(Waypoints, ThatCannotBeWrittenAreRefused) {
    const Folder folder;
    for (const std::string& question : {zoe, out}) {
        const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
            expect_refusal(run(question + options), named);
        };
        refused("--spacing 0.1", {"--spacing", "--waypoints"});
        refused("--waypoints " + folder.file("w.txt"), {"--waypoints", "w.txt", ".csv or .json"});
        refused("--waypoints " + folder.file("none/w.csv"), {"--waypoints", "none/w.csv"});
        refused("--waypoints .csv", {"--waypoints", ".csv or .json"});
        refused("--waypoints w.json -o w.json", {"--waypoints", "--output", "same file"});
        const std::string there = "--waypoints " + folder.file("w.csv") + " --spacing ";
        for (const char* bad : {"0", "-1", "nan", "inf", "1e-12", "5cm", "1e7"}) refused(there + bad, {"--spacing"});
        refused(there + "1e-8", {"--spacing", "more than 1000000", "take a larger spacing"});
    }
    EXPECT_EQ(folder.files(), 0U);
}

TEST(Trajectory, IsWrittenBesideTheAnswer) {
    const Folder folder;
    const std::string way = "park --car renault-zoe --length 5.2 --width 2 --road 3.5 ";
    for (const std::string& question : {zoe, zoe + "--strategy fewest ", out, way}) {
        const std::string csv = folder.file("t.csv");
        const std::string json = folder.file("t.json");
        const std::string scenario = folder.file("t.xosc");
        const Result result = run(question + "--format json --trajectory " + json);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(run(question + "--format json --trajectory " + csv + " --period 0.05").out, result.out);
        run(question + "--trajectory " + scenario + " --speed 0.5");
        const auto maneuver = nlohmann::json::parse(result.out)["maneuver"];
        const auto timed = nlohmann::json::parse(contents(json));
        EXPECT_EQ(timed["seconds"], maneuver["seconds"]) << "the usual limits";
        EXPECT_EQ(timed["seconds"], timed["trajectory"].back()["time"]);
        EXPECT_EQ(rows(contents(csv)), timed["trajectory"].size()) << "the usual period is 0.05 s";
        for (const char* key : {"x", "y", "heading"}) EXPECT_EQ(timed["trajectory"].back()[key], maneuver["goal"][key]);
        EXPECT_EQ(contents(scenario).find("<?xml"), 0U);
        EXPECT_NE(contents(scenario).find("maxSpeed=\"0.5\""), std::string::npos);
        EXPECT_NE(contents(scenario).find("<Vertex time=\"0.05\"><Position><WorldPosition"), std::string::npos);
        EXPECT_NE(contents(scenario).find("</OpenSCENARIO>"), std::string::npos);
    }
    EXPECT_EQ(folder.files(), 3U);
}

TEST(Trajectory, OfACarThatCannotParkIsEmpty) {
    const Folder folder;
    const std::string file = folder.with("t.csv", "that of yesterday");
    EXPECT_EQ(run("entry --car renault-zoe --length 4.1 --width 2 --trajectory " + file).exit_code, 1);
    EXPECT_EQ(contents(file),
              "time,x,y,heading,direction,speed,acceleration,steering_angle,steering_rate,curvature,distance\n");
}

TEST(Trajectory, ThatCannotBeWrittenIsRefused) {
    const Folder folder;
    const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
        expect_refusal(run(zoe + options), named);
    };
    refused("--speed 1", {"--speed", "--trajectory"});
    refused("--trajectory t.txt", {"--trajectory", "t.txt", ".csv, .json or .xosc"});
    refused("--trajectory t.csv --waypoints t.csv", {"--trajectory", "--waypoints", "same file"});
    refused("--trajectory t.json -o t.json", {"--trajectory", "--output", "same file"});
    refused("--trajectory " + folder.file("none/t.csv"), {"--trajectory", "none/t.csv"});
    const std::string there = "--trajectory " + folder.file("t.csv") + " ";
    for (const std::string limit : {"--speed ", "--acceleration ", "--deceleration ", "--steering-rate ", "--period "})
        for (const char* bad : {"0", "-1", "nan", "inf", "1e9", "fast"})
            refused(there + limit + bad, {limit.substr(0, limit.size() - 1)});
    refused(there + "--period 1e-6", {"--period", "take a longer period"});
    EXPECT_EQ(folder.files(), 0U);
}

}  // namespace
}  // namespace snug::test
