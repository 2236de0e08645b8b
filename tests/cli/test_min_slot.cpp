// The answers of `snug min-slot`: their form, and that they agree with `snug entry`. Minima are attacked elsewhere.
#include <pty.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "questions.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

const std::string smallest = "min-slot --car renault-zoe ";

/// Does `snug entry` park in the slot of a row, made longer and wider by a little, with the changes allowed?
bool parks(const Json& row, double longer, double wider) {
    const Json answer = Json::parse(run("entry --car renault-zoe --format json --length " +
                                        write(row["length"].get<double>() + longer) + " --width " +
                                        write(row["width"].get<double>() + wider))
                                        .out);
    return answer["parkable"] == true && answer["direction_changes"] <= row["max_changes"];
}

TEST(MinSlot, JsonHasTheDocumentedKeysInOrder) {
    const Result result = run(smallest + "--max-changes 2,0 --width 1.75,1.9:2.1:0.1 --format json");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json answer = Json::parse(result.out);
    EXPECT_EQ(write(answer), result.out);
    EXPECT_EQ(keys(answer), (std::vector<std::string>{"schema", "car", "strategy", "rows"}));
    EXPECT_EQ(answer["schema"], 1);
    EXPECT_EQ(answer["car"]["name"], "renault-zoe");
    EXPECT_EQ(answer["strategy"], "max-steer");
    ASSERT_EQ(answer["rows"].size(), 8U);
    for (std::size_t i = 0; i < 8; ++i) {
        const Json& row = answer["rows"][i];
        EXPECT_EQ(keys(row), (std::vector<std::string>{"max_changes", "width", "length", "entry_heading"}));
        EXPECT_EQ(row["max_changes"], i % 2 == 0 ? 2 : 0) << "counts inside, in the order given";
        EXPECT_EQ(row["length"].is_null(), i < 2) << "a slot narrower than the car is a row without an answer";
        EXPECT_EQ(row["entry_heading"].is_null(), i < 2);
    }
    EXPECT_EQ(answer["rows"][4]["width"], 2.0);
}

TEST(MinSlot, TheSlotsAreThoseThatEntryParksIn) {
    const Json rows = Json::parse(run(smallest + "--max-changes 0,5 --width 1.9,2.2 --format json").out)["rows"];
    for (const Json& row : rows) {
        EXPECT_TRUE(parks(row, 1e-6, 0)) << row;
        EXPECT_FALSE(parks(row, -1e-6, 0)) << row;
    }
    const Json widths = Json::parse(run(smallest + "--max-changes 3,5 --length 4.9,5 --format json").out)["rows"];
    ASSERT_EQ(widths.size(), 4U);
    for (const Json& row : widths) {
        EXPECT_TRUE(parks(row, 0, 1e-6)) << row;
        EXPECT_FALSE(parks(row, 0, -1e-6)) << row;
    }
}

TEST(MinSlot, CsvHasTheSameColumns) {
    const std::string question = smallest + "--max-changes 0,3 --width 1.7,2 --format ";
    const std::vector<std::string> rows = lines(run(question + "csv").out);
    const Json json = Json::parse(run(question + "json").out)["rows"];
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0], "max_changes,width,length,entry_heading");
    EXPECT_EQ(rows[1], "0,1.7,,");
    EXPECT_EQ(rows[4], "3,2.0," + json[3]["length"].dump() + ',' + json[3]["entry_heading"].dump());
}

TEST(MinSlot, ExtraSizesAreBeyondTheCars) {
    const std::string form = " --max-changes 4 --format csv";
    EXPECT_EQ(run(smallest + "--extra-width 0.129:0.329:0.1" + form).out,
              run(smallest + "--width 1.9,2,2.1" + form).out);
    EXPECT_EQ(run(smallest + "--extra-length 0.816" + form).out, run(smallest + "--length 4.9" + form).out);
}

TEST(MinSlot, AnswersDoNotDependOnThreads) {
    const std::string question = smallest + "--max-changes 0:4:1 --extra-width 0.1:0.3:0.01 --format csv ";
    EXPECT_EQ(run(question + "--threads 1").out, run(question + "--threads 3").out);
}

TEST(MinSlot, TakesNeighboursCurbAndWhatCountsAsParked) {
    const std::string beside =
        "--front-setback 0.3 --rear-setback 0.1 --curb low --clearance 0.02 --curb-clearance 0.05 --parked-heading 2 "
        "--parked-curb 0.3 ";
    for (const std::string strategy : {"max-steer", "fewest --resolution 0.008"}) {
        const std::string same = beside + "--strategy " + strategy + " --format json ";
        const Json row = Json::parse(run(smallest + "--max-changes 4 --width 2 " + same).out)["rows"][0];
        const double length = row["length"];
        const auto changes = [&](double by) {
            const std::string slot = "entry --car renault-zoe --width 2 --length " + std::to_string(length + by) + ' ';
            const Json answer = Json::parse(run(slot + same).out);
            return answer["parkable"] == true ? answer["direction_changes"].get<int>() : 1000;
        };
        EXPECT_LE(changes(1e-4), 4) << strategy;
        if (strategy == "max-steer") {
            EXPECT_GT(changes(-1e-4), 4);
        } else {
            EXPECT_GT(changes(row["length_lower"].get<double>() - length - 1e-4), 4);
        }
    }
    // Deeper neighbours and a low curb leave more room, a looser condition does no harm.
    const auto length = [](const std::string& more) {
        return Json::parse(run(smallest + "--max-changes 4 --width 2 --format json " + more).out)["rows"][0]["length"]
            .get<double>();
    };
    EXPECT_LT(length("--front-setback 0.3"), length(""));
    EXPECT_LE(length("--curb low"), length("") + 1e-6);
    EXPECT_GE(length("--parked-heading 1"), length("") - 1e-6);
    expect_refusal(run(smallest + "--max-changes 1 --width 1.8:2:0.1 --front-setback 1.9"),
                   {"--front-setback", "1.8 m wide"});
    expect_refusal(run(smallest + "--max-changes 1 --length 5 --strategy fewest --parked-curb 0.2"),
                   {"--parked-curb", "fewest"});
    expect_refusal(run(smallest + "--max-changes 1 --width 2 --strategy stepping --curb low"), {"--curb", "max-steer"});
}

TEST(MinSlot, OfStreetsTheRoadTheWidthOrTheLengthIsFound) {
    const std::string bay = smallest + "--angle 90 --max-changes 3,1 --resolution 0.04 ";
    const Json roads = Json::parse(run(bay + "--length 5 --width 2.5,2.7 --format json").out);
    EXPECT_EQ(keys(roads), (std::vector<std::string>{"schema", "car", "strategy", "slot", "rows"}));
    ASSERT_EQ(roads["rows"].size(), 4U);
    EXPECT_EQ(keys(roads["rows"][0]),
              (std::vector<std::string>{"max_changes", "length", "width", "road", "road_lower"}));
    for (std::size_t i = 0; i < 4; ++i) {
        const Json& row = roads["rows"][i];
        EXPECT_EQ(row["max_changes"], i % 2 == 0 ? 3 : 1);
        EXPECT_LT(row["road_lower"], row["road"]);
        const Json there = Json::parse(run("park --car renault-zoe --angle 90 --length 5 --width " +
                                           row["width"].dump() + " --road " + row["road"].dump() + " --format json")
                                           .out);
        EXPECT_LE(there["direction_changes"], row["max_changes"]) << row;
    }
    EXPECT_LE(roads["rows"][0]["road_lower"], roads["rows"][1]["road"]);
    const std::vector<std::string> widths = lines(run(bay + "--length 5 --road 6 --format csv").out);
    ASSERT_EQ(widths.size(), 3U);
    EXPECT_EQ(widths[0], "max_changes,length,width,road,width_lower");
    const std::string text = run(smallest + "--width 2 --road 3.5 --max-changes 2 --resolution 0.04").out;
    EXPECT_NE(text.find("the shortest slot [m] over all maneuvers"), text.npos) << text;
    EXPECT_EQ(run(smallest + "--angle 90 --length 3 --width 2.5 --max-changes 1").exit_code, 1);
}

TEST(MinSlot, OverAllManeuversWidthsAreFoundToo) {
    const Json row = Json::parse(
        run(smallest + "--max-changes 3 --length 5 --strategy fewest --resolution 0.008 --format json").out)["rows"][0];
    EXPECT_EQ(row["length"], 5.0);
    EXPECT_LT(row["width_lower"], row["width"]);
    const Json exact = Json::parse(run(smallest + "--max-changes 3 --length 5 --format json").out)["rows"][0];
    EXPECT_LE(row["width"], exact["width"]);
    EXPECT_LE(row["width_lower"], exact["width"]);
}

TEST(MinSlot, NothingWithinTheLimitsIsExitOne) {
    EXPECT_EQ(run(smallest + "--max-changes 5 --width 1.78 --format csv").exit_code, 1);
    const Result short_limit = run(smallest + "--max-changes 0 --width 2 --max-length 5.5 --format csv");
    EXPECT_EQ(short_limit.exit_code, 1);
    EXPECT_EQ(short_limit.out, "max_changes,width,length,entry_heading\n0,2.0,,\n");
    EXPECT_EQ(run(smallest + "--max-changes 0 --width 2 --max-length 5.7").exit_code, 0);
}

TEST(MinSlot, RoomForAnImpreciseDriverTakesLonger) {
    const auto length = [](const std::string& more) {
        return Json::parse(run(smallest + "--max-changes 4 --width 2 --format json " + more).out)["rows"][0]["length"]
            .get<double>();
    };
    EXPECT_GT(length("--min-range 0.01"), length("") + 0.001);
    EXPECT_GT(length("--clearance 0.05"), length("") + 0.1);
    EXPECT_EQ(run(smallest + "--max-changes 4 --width 2.4 --enter forward").exit_code, 1)
        << "nose first needs more width";
    EXPECT_EQ(run(smallest + "--max-changes 4 --width 3.2 --enter forward").exit_code, 0);
}

TEST(MinSlot, OneSlotIsAnsweredInWords) {
    const Result result = run(smallest + "--length 5.2 --width 2.1");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out,
              "renault-zoe fits the 5.200 x 2.100 m slot with 1 direction change.\n"
              "  0.455 m longer would do with 0\n"
              "  0.048 m shorter would need 2\n"
              "  1.052 m wider would do with 0\n"
              "  0.133 m narrower would need 2\n");
    const Result hopeless = run(smallest + "--length 4 --width 2");
    EXPECT_EQ(hopeless.exit_code, 1);
    EXPECT_NE(hopeless.out.find("It is 0.084 m too short for the car."), std::string::npos) << hopeless.out;
    EXPECT_NE(run(smallest + "--length 4.1 --width 1.8 --clearance 0.05")
                  .out.find("too narrow for the car with its clearance."),
              std::string::npos);
    EXPECT_NE(hopeless.out.find("m longer would do with"), std::string::npos) << hopeless.out;
    const Json rows = Json::parse(run(smallest + "--length 5.2 --width 2.1 --format json").out)["rows"];
    ASSERT_EQ(rows.size(), 3U);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(rows[std::size_t(i)]["max_changes"], i);
}

TEST(MinSlot, WithTheSlotAndTheChangesItIsTheClearanceThatIsFound) {
    const std::string slot = " --car renault-zoe --length 5 --width 2 ";
    for (const std::string strategy : {"max-steer", "fewest --resolution 0.008"}) {
        const std::string how = slot + "--strategy " + strategy + " --format json ";
        const Result result = run("min-slot --max-changes 1,3,5" + how);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const Json answer = Json::parse(result.out);
        const bool exact = strategy == "max-steer";
        double last = -1.0;
        for (const Json& row : answer["rows"]) {
            EXPECT_EQ(row["length"], 5.0);
            EXPECT_EQ(row["width"], 2.0);
            const std::string most = " --max-changes " + std::to_string(row["max_changes"].get<int>());
            if (row["clearance"].is_null()) {
                EXPECT_EQ(run("entry" + how + most).exit_code, 1) << row;
                continue;
            }
            const double clearance = row["clearance"];
            EXPECT_GT(clearance, last) << "more changes keep more";
            last = clearance;
            EXPECT_EQ(run("entry" + how + most + " --clearance " + write(clearance)).exit_code, 0) << row;
            const double beyond = exact ? clearance + 1e-6 : row["clearance_upper"].get<double>() + 1e-6;
            EXPECT_EQ(run("entry" + how + most + " --clearance " + write(beyond)).exit_code, 1) << row;
        }
        EXPECT_GT(last, 0.05);
    }
    EXPECT_EQ(run("min-slot --max-changes 0" + slot).exit_code, 1);
    EXPECT_EQ(lines(run("min-slot --max-changes 3" + slot + "--format csv").out)[0],
              "max_changes,width,length,clearance");
}

TEST(MinSlot, WhereFullSteeringHasNoSlotOtherManeuversAreTold) {
    const Folder folder;
    const std::string file = folder.with("bus.json",
                                         R"({"name": "bus", "width": 2.55, "length": 12, "front_overhang": 2.8,
                                             "wheelbase": 6, "max_steer_deg": 50})");
    const Result result = run("min-slot --max-changes 0 --width 2.8,3.0 --car " + file);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("Other maneuvers"), std::string::npos) << result.out;
    EXPECT_EQ(run("entry --length 15 --width 3 --strategy fewest --max-changes 0 --car " + file).exit_code, 0);
    EXPECT_EQ(run(smallest + "--max-changes 1 --width 1.6").out.find("Other"), std::string::npos)
        << "narrower than the car";
}

TEST(MinSlot, OneSlotIsDrawn) {
    const Folder folder;
    const std::string slot = " --car renault-zoe --length 5.2 --width 2.1 ";
    EXPECT_EQ(run("min-slot" + slot + "--draw " + folder.file("a.svg")).exit_code, 0);
    EXPECT_EQ(run("entry" + slot + "--draw " + folder.file("b.svg")).exit_code, 0);
    EXPECT_EQ(contents(folder.file("a.svg")), contents(folder.file("b.svg")));
}

TEST(MinSlot, ThePapersLoopIsCoarserAndNeverShorter) {
    const std::string stepping = "--strategy stepping --step 0.01 --heading-step 0.002 ";
    const Json loop =
        Json::parse(run(smallest + "--max-changes 2,0 --width 2 --length-step 0.05 --format json " + stepping).out);
    const Json exact = Json::parse(run(smallest + "--max-changes 2,0 --width 2 --format json").out);
    EXPECT_EQ(loop["strategy"], "stepping");
    for (std::size_t i = 0; i < 2; ++i) {
        const double steps = (loop["rows"][i]["length"].get<double>() - 4.084) / 0.05;
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
        EXPECT_GT(loop["rows"][i]["length"], exact["rows"][i]["length"]);
        EXPECT_LT(loop["rows"][i]["length"].get<double>(), exact["rows"][i]["length"].get<double>() + 0.1);
    }
    EXPECT_EQ(run(smallest + "--max-changes 2 --length 5 --width-step 0.05 " + stepping).exit_code, 0);
}

TEST(MinSlot, TextFitsEightyColumns) {
    for (const std::string question : {"--max-changes 0:10:1,100 --width 1.7:2.2:0.1", "--max-changes 3 --length 4.9",
                                       "--length 4.8 --width 2.05", "--length 3 --width 1"}) {
        for (const std::string& line : lines(run(smallest + question).out)) EXPECT_LE(line.size(), 80U) << line;
    }
}

TEST(MinSlot, HelpHasAnExample) {
    const Result result = run("min-slot --help");
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("snug min-slot --car renault-zoe"), std::string::npos);
    EXPECT_NE(result.out.find("Exit codes"), std::string::npos);
    for (const std::string& line : lines(result.out)) EXPECT_LE(line.size(), 80U) << line;
}

TEST(MinSlot, BadInputIsNamed) {
    expect_refusal(run(smallest), {"--width is missing"});
    expect_refusal(run("min-slot --width 2 --max-changes 1"), {"--car is missing"});
    expect_refusal(run(smallest + "--width 2"), {"--max-changes is missing"});
    expect_refusal(run(smallest + "--width 2 --length 5 --max-changes 1 --clearance 0.1"),
                   {"--clearance", "leave it out"});
    expect_refusal(run(smallest + "--width 2 --length 5,6 --max-changes 1"), {"--length is a list"});
    expect_refusal(run(smallest + "--width 2 --length 5 --max-changes 1 --strategy stepping"),
                   {"--strategy", "fewest"});
    expect_refusal(run(smallest + "--width 2 --max-changes 2-5"), {"--max-changes", "write 2:5:1"});
    expect_refusal(run(smallest + "--width 1.8-2.4 --max-changes 2"), {"--width", "write 1.8:2.4:0.01"});
    expect_refusal(run(smallest + "--width 2 --max-changes 2 --draw x.svg"), {"--draw", "one slot"});
    expect_refusal(run(smallest + "--width 2,3 --length 5"), {"--width is a list"});
    expect_refusal(run(smallest + "--width 2 --extra-width 1 --max-changes 1"),
                   {"--width", "--extra-width", "exclude"});
    for (const char* bad : {"2.4:1.8:0.1", "1.8:2.4:0", "1.8:2.4:-0.1", "1.8:2.4", "nan", "nan:2:0.1", "1.8:inf:0.1",
                            "-2", "0", "2,,3", ",", "2m", "1.8:2.4:0.1:1", "1:2:1e-9", "1e7"})
        expect_refusal(run({"min-slot", "--car", "renault-zoe", "--max-changes", "1", "--width", bad}), {"--width"});
    expect_refusal(run({"min-slot", "--car", "renault-zoe", "--max-changes", "1", "--width", ""}), {"--width"});
    for (const char* bad : {"", "-1", "1.5", "1e1", "5:1:1", "0:5:0", "100001", "nan", "one"})
        expect_refusal(run({"min-slot", "--car", "renault-zoe", "--width", "2", "--max-changes", bad}),
                       {"--max-changes"});
    const std::string asked = smallest + "--width 2 --max-changes 1 ";
    expect_refusal(run(asked + "--min-range 2"), {"--min-range", "1.57"});
    expect_refusal(run(asked + "--min-range nan"), {"--min-range"});
    expect_refusal(run(asked + "--clearance -1"), {"--clearance"});
    expect_refusal(run(asked + "--max-length 0"), {"--max-length"});
    expect_refusal(run(asked + "--threads 0"), {"--threads"});
    expect_refusal(run(asked + "--enter sideways"), {"--enter", "backward or forward"});
    expect_refusal(run(asked + "--strategy reversed-trials"), {"--strategy", "max-steer, fewest or stepping"});
    expect_refusal(run(asked + "--length-step 0.1"), {"--length-step", "stepping"});
    expect_refusal(run(asked + "--strategy stepping --length-step 0"), {"--length-step"});
    expect_refusal(run(asked + "--strategy stepping --width-step 0.1"), {"--width-step", "--length-step"});
    expect_refusal(run(smallest + "--length 5 --max-changes 1 --max-length 6"), {"--max-length", "--width"});
    expect_refusal(run(smallest + "--length 5 --width 2 --strategy stepping"), {"--strategy"});
    expect_refusal(run(asked + "--format xml"), {"--format", "text, json or csv"});
}

TEST(MinSlot, PlacesThatCannotBeWritten) {
    const Folder folder;
    const std::string asked = smallest + "--width 2 --max-changes 1 ";
    expect_refusal(run(asked + "-o " + folder.file("none/x")), {"--output", "none/x"});
    expect_refusal(run(asked + "-o /dev/full"), {"--output", "No space left"});
    expect_refusal(run(asked, "/dev/full"), {"standard output", "No space left"});
    EXPECT_EQ(run(asked + "-o " + folder.file("answer")).exit_code, 0);
    EXPECT_EQ(contents(folder.file("answer")), run(asked).out);
    EXPECT_EQ(folder.files(), 1U);
}

/// Interrupts a question that would take hours when it has begun its file; what it used of memory, in bytes.
long interrupted(const std::string& question, const Folder& folder, useconds_t after) {
    const std::size_t files = folder.files() + 3;  // what it says, and the file in parts
    const pid_t child = start(words(question), folder.file("out"), folder.file("err"));
    for (int i = 0; i < 20000 && folder.files() < files; ++i) usleep(1000);
    usleep(after);
    kill(child, SIGINT);
    int status = 0;
    rusage used = {};
    wait4(child, &status, 0, &used);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 130) << status;
    EXPECT_EQ(folder.files(), files - 1) << "the file in parts is gone";
    EXPECT_EQ(contents(folder.file("out")), "");
    return used.ru_maxrss * 1024;
}

TEST(MinSlot, MillionsOfPointsAreWarnedOfAndFitInMemory) {
    const Folder folder;
    const std::string file = folder.file("answer.csv");
    const long memory =
        interrupted(smallest + "--max-changes 0,1 --width 1.9:2.9:0.000001 --format csv -o " + file, folder, 300'000);
    EXPECT_LT(memory, 1'000'000'000L);
    EXPECT_NE(contents(folder.file("err")).find("2000002 points"), std::string::npos) << contents(folder.file("err"));
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(MinSlot, CtrlCLeavesAFileAsItWas) {
    for (const useconds_t after : {0U, 20'000U, 200'000U}) {
        const Folder folder;
        const std::string file = folder.with("answer.json", "old");
        interrupted(smallest + "--max-changes 100 --width 1.9:2.9:0.0001 --format json -o " + file, folder, after);
        EXPECT_EQ(contents(file), "old");
    }
}

TEST(MinSlot, ATerminalIsToldTheTimeLeft) {
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == -1) GTEST_SKIP() << "this machine has no pseudoterminals";
    if (child == 0) {
        std::signal(SIGINT, SIG_DFL);
        execl(snug_command(), "snug", "min-slot", "--car", "renault-zoe", "--max-changes", "0:20:1", "--width",
              "1.9:2.9:0.0001", "-o", "/dev/null", nullptr);
        _exit(98);
    }
    std::string said;
    for (char part[256]; said.find("left") == said.npos;) {
        const ssize_t count = read(terminal, part, sizeof part);
        if (count <= 0) break;
        said.append(part, static_cast<std::size_t>(count));
    }
    kill(child, SIGINT);
    EXPECT_EQ(wait_for(child), 130);
    close(terminal);  // only now: a closed terminal is a signal, too
    EXPECT_NE(said.find('%'), std::string::npos) << said;
    EXPECT_NE(said.find("left"), std::string::npos) << said;
}

}  // namespace
}  // namespace snug::test
