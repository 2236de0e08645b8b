// `snug entry --strategy fewest` and `snug leave`: the form of their answers, exit codes and bad input.
#include <nlohmann/json.hpp>
#include <sstream>

#include "process.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

const std::string entry = "entry --car renault-zoe --strategy fewest --length ";
const std::string leave = "leave --car renault-zoe --length 5 --width 2 ";

TEST(FewestCommand, AnswersWithManeuverAndProof) {
    const Result result = run(entry + "5.2 --width 1.9 --format json");
    EXPECT_EQ(result.exit_code, 0);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["strategy"], "fewest");
    EXPECT_EQ(json["max_changes"], nullptr);
    EXPECT_EQ(json["parkable"], true);
    EXPECT_EQ(json["direction_changes"], 2);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["lower_bound"], 2);
    EXPECT_TRUE(json["entry_ranges"].empty());
    EXPECT_EQ(json["maneuver"]["direction_changes"], 2);
}

TEST(FewestCommand, TooFewChangesAreProvedTooFew) {
    const Result result = run(entry + "5.2 --width 1.9 --format json --max-changes 1");
    EXPECT_EQ(result.exit_code, 1);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["max_changes"], 1);
    EXPECT_EQ(json["parkable"], false);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["lower_bound"], 2);
    EXPECT_FALSE(json.contains("direction_changes"));
    EXPECT_FALSE(json.contains("maneuver"));
}

TEST(FewestCommand, WithoutTimeNothingIsDecided) {
    const Result result = run(entry + "4.8 --width 1.84 --format json --time-limit 0");
    EXPECT_EQ(result.exit_code, 3);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["parkable"], nullptr);
    EXPECT_EQ(json["proved"], false);
}

TEST(FewestCommand, AnswersInWords) {
    const Result result = run(entry + "5.2 --width 1.9");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("2 direction changes"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("proved"), std::string::npos) << result.out;
}

TEST(FewestCommand, CsvHasOneRowPerMove) {
    const std::string question = entry + "5.2 --width 1.9 --format ";
    const Json moves = Json::parse(run(question + "json").out)["maneuver"]["moves"];
    std::istringstream rows(run(question + "csv").out);
    std::string row;
    std::getline(rows, row);
    EXPECT_EQ(row,
              "direction,steering_angle,length,start_x,start_y,start_heading,end_x,end_y,end_heading,contact_car,"
              "contact_obstacle");
    for (const Json& move : moves) {
        ASSERT_TRUE(std::getline(rows, row));
        const std::string direction = move["direction"];
        const std::string begins = direction + ',' + move["steering_angle"].dump() + ',' + move["length"].dump() + ',';
        EXPECT_EQ(row.substr(0, begins.size()), begins);
        const Json& contact = move["contact"];
        const std::string ends =
            contact.is_null() ? ",,"
                              : ',' + contact["car"].get<std::string>() + ',' + contact["obstacle"].get<std::string>();
        EXPECT_EQ(row.substr(row.size() - ends.size()), ends);
    }
    EXPECT_FALSE(std::getline(rows, row));
}

TEST(FewestCommand, BadInputIsRefused) {
    const std::string slot = "5.2 --width 1.9 ";
    expect_refusal(run(entry + slot + "--resolution 0"), {"--resolution"});
    expect_refusal(run(entry + slot + "--time-limit -1"), {"--time-limit"});
    expect_refusal(run(entry + slot + "--min-range 0.1"), {"--min-range", "fewest"});
    expect_refusal(run("entry --car renault-zoe --length 5 --width 2 --resolution 0.01"), {"--resolution", "fewest"});
    expect_refusal(run(entry + "4.8 --width 1.84 --resolution 1e-6"), {"resolution", "GB"});
}

TEST(FewestCommand, ShortestSlotsLieBetweenTwoLengths) {
    const std::string sizes =
        "min-slot --car renault-zoe --strategy fewest --max-changes 2,0 --width 1.9:2:0.1 "
        "--resolution 0.008 ";
    const Result result = run(sizes + "--format json");
    EXPECT_EQ(result.exit_code, 0);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["strategy"], "fewest");
    ASSERT_EQ(json["rows"].size(), 4U);
    EXPECT_EQ(json["rows"][0]["max_changes"], 2);
    EXPECT_EQ(json["rows"][2]["width"], 2.0);
    for (const Json& row : json["rows"]) EXPECT_LT(row["length_lower"], row["length"]);
    EXPECT_LT(json["rows"][0]["length"], json["rows"][1]["length"]);
    EXPECT_EQ(run(sizes + "--format csv").out.substr(0, 37), "max_changes,width,length,length_lower");
    expect_refusal(run("min-slot --car renault-zoe --strategy fewest --max-changes 2 --length 5 --min-range 0.1"),
                   {"--min-range", "fewest"});
}

TEST(LeaveCommand, AnswersWithManeuverAndProof) {
    const Result result = run(leave + "--gap-front 0.3 --gap-curb 0.1 --format json");
    EXPECT_EQ(result.exit_code, 0);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["direction_changes"], 5);
    EXPECT_EQ(json["lower_bound"], 5);
    EXPECT_EQ(json["proved"], true);
    EXPECT_EQ(json["maneuver"]["moves"].back()["direction"], "forward");
    EXPECT_NE(run(leave + "--gap-front 0.3 --gap-curb 0.1").out.find("leaves"), std::string::npos);
}

TEST(LeaveCommand, BadInputIsRefused) {
    expect_refusal(run(leave + "--gap-curb 0.1"), {"--gap-front"});
    expect_refusal(run(leave + "--gap-front 0.3"), {"--gap-curb"});
    expect_refusal(run(leave + "--gap-front 2 --gap-curb 0.1"), {"sticks", "out of the slot"});
    expect_refusal(run(leave + "--gap-front 0.3 --gap-curb 0.1 --car-heading 1.6"), {"--car-heading"});
    expect_refusal(run(leave + "--gap-front 0.3 --gap-curb 0.1 --clearance 0.2"), {"clearance"});
}

}  // namespace
}  // namespace snug::test
