// snug drive says how many runs park, in every format, or what is wrong with the question.
#include <nlohmann/json.hpp>

#include "process.hpp"

namespace snug::test {
namespace {

const std::string perpendicular = "drive --car renault-zoe --length 5 --width 2.5 --angle 90 --road 6 ";
const std::string few = "--margin 0.05 --runs 5 ";

TEST(Drive, AnswersInEveryFormat) {
    const Folder folder;
    const Result json = run(perpendicular + few + "--format json --trajectory " + folder.file("t.csv") + " --draw " +
                            folder.file("tracks.svg"));
    EXPECT_EQ(json.exit_code, 0) << json.err;
    const auto answer = nlohmann::json::parse(json.out);
    for (const char* key : {"schema",
                            "car",
                            "slot",
                            "start",
                            "sensing",
                            "bias",
                            "actuation",
                            "lag",
                            "slot_error",
                            "runs",
                            "seed",
                            "margin",
                            "parked",
                            "contacts",
                            "planned_changes",
                            "lower_bound",
                            "direction_changes",
                            "seconds",
                            "smallest_distance",
                            "steer",
                            "standing_steers"})
        EXPECT_TRUE(answer.contains(key)) << key;
    EXPECT_EQ(answer["runs"], 5);
    EXPECT_EQ(answer["parked"], 5);
    EXPECT_EQ(answer["contacts"], 0);
    EXPECT_LE(answer["lower_bound"], answer["planned_changes"]);
    EXPECT_LE(answer["direction_changes"]["mean"].get<double>(), answer["direction_changes"]["max"].get<double>());
    EXPECT_GT(answer["smallest_distance"].get<double>(), 0.0);
    EXPECT_NE(contents(folder.file("tracks.svg")).find("<svg"), std::string::npos);
    EXPECT_EQ(contents(folder.file("t.csv")).find("time,x,y,heading"), 0U);

    const Result csv = run(perpendicular + few + "--format csv");
    EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 6);
    const Result text = run(perpendicular + few);
    EXPECT_NE(text.out.find("renault-zoe parks in 5 of 5 runs."), std::string::npos) << text.out;
    EXPECT_EQ(run(perpendicular + few + "--threads 1").out, text.out);
    EXPECT_NE(run(perpendicular + few + "--seed 2 --format csv").out, csv.out);
}

TEST(Drive, TakesErrorsOfTheSlotAndALag) {
    const auto answer =
        nlohmann::json::parse(run(perpendicular + few + "--lag 0.2 --slot-error 0.03,0.02 --format json").out);
    EXPECT_EQ(answer["lag"], 0.2);
    EXPECT_EQ(answer["slot_error"], nlohmann::json::parse("[0.03, 0.02]"));
    EXPECT_EQ(answer["runs"], 5);
    EXPECT_NE(run(perpendicular + few + "--format csv").out,
              run(perpendicular + few + "--slot-error 0.03,0.02 --format csv").out);
    EXPECT_NE(run(perpendicular + few + "--format csv").out, run(perpendicular + few + "--lag 0 --format csv").out);
}

TEST(Drive, SteersOnlyWhileItRolls) {
    const Folder folder;
    const Result json = run(perpendicular + few + "--steer moving --format json --trajectory " + folder.file("t.json") +
                            " --draw " + folder.file("t.svg"));
    EXPECT_EQ(json.exit_code, 0) << json.err;
    const auto answer = nlohmann::json::parse(json.out);
    EXPECT_EQ(answer["steer"], "moving");
    EXPECT_EQ(answer["parked"], 5);
    EXPECT_EQ(answer["standing_steers"]["planned"], 0);
    EXPECT_LE(answer["standing_changes"], answer["planned_changes"]);
    EXPECT_EQ(nlohmann::json::parse(contents(folder.file("t.json")))["standing_steers"], 0);
    EXPECT_NE(contents(folder.file("t.svg")).find("<svg"), std::string::npos);
    const Result text = run(perpendicular + few + "--steer moving");
    EXPECT_NE(text.out.find("planned never, with no more direction changes than with it"), std::string::npos)
        << text.out;
}

TEST(Drive, WithoutAPlanIsNo) {
    const Result none = run("drive --car renault-zoe --length 4.2 --width 1.8 --runs 3");
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_NE(none.out.find("has no way into the place"), std::string::npos) << none.out;
}

TEST(Drive, RefusesWhatIsImpossible) {
    const auto refused = [&](const std::string& options, const std::vector<std::string>& named) {
        expect_refusal(run(perpendicular + options), named);
    };
    refused("--runs 0", {"--runs"});
    refused("--rate 2", {"--rate"});
    refused("--margin -1", {"--margin"});
    refused("--sensing 0.1,0.1", {"--sensing"});
    refused("--sensing=-0.1,0,0 --runs 1", {"sensing error"});
    refused("--actuation 0.1", {"--actuation"});
    refused("--lag -1", {"--lag"});
    refused("--slot-error 0.1", {"--slot-error"});
    refused("--slot-error 0.1,-1", {"error of the slot's size"});
    const Folder folder;
    const std::string yard = folder.with(
        "yard.json",
        R"({"obstacles": [[[5, 5], [6, 5], [6, 6]]], "parked": {"pose": [-3, 0, 0], "tolerance": [0.5, 0.5, 0.1]}, )"
        R"("start": [3, 0, 0]})");
    expect_refusal(run("drive --car renault-zoe --scene " + yard + " --slot-error 0.1,0.1"),
                   {"--slot-error", "--scene"});
    refused("--steer sideways", {"--steer", "moving"});
    refused("--clearance 0.1", {"--clearance", "--margin"});
    refused("--from 0.5,-1,0 --runs 1", {"in contact with", "m deep"});
    refused("--speed 1", {"--speed", "--trajectory"});
}

}  // namespace
}  // namespace snug::test
