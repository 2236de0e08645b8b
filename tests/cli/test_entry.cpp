// The answer of `snug entry`: its form, and that its parts agree with each other. Numbers are checked elsewhere.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "questions.hpp"
#include "snug/io.hpp"

namespace snug::test {
namespace {

const std::string too_small = "entry --car renault-zoe --extra-length -0.1 --width 2 ";

/// Questions of every kind that a car can answer by parking.
const std::vector<std::string> parkable = {
    zoe,
    zoe + "--side left",
    zoe + "--max-changes 6",
    zoe + "--clearance 0.02",
    zoe + "--strategy stepping --step 0.01 --heading-step 0.001",
    "entry --car renault-zoe --length 7 --width 3.2 --enter forward",
    zoe + "--strategy reversed-trials",
    "entry --car renault-zoe --length 5.9 --width 2.1 --strategy reversed-trials --clearance 0.02",
    zoe + "--strategy parallel-trials --goal=-4.1,-1,0",
};

using Keys = std::vector<std::string>;

TEST(Entry, JsonEchoesWhatIsNotAsUsual) {
    for (const std::string strategy : {"max-steer", "fewest"}) {
        const Result result =
            run(zoe + "--format json --front-setback 0.1 --rear-setback 0.2 --curb low --parked-curb 0.5 " +
                "--parked-heading 90 --curb-clearance 0.05 --strategy " + strategy);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        const Json answer = Json::parse(result.out);
        EXPECT_EQ(answer["slot"], Json::parse(R"({"length": 5.0, "width": 2.0, "side": "right", "corner": [0.0, 0.0],
                              "heading": 0.0, "front_setback": 0.1, "rear_setback": 0.2, "curb": "low"})"));
        EXPECT_EQ(answer["driving"], Json::parse(R"({"enter": "backward", "clearance": 0.0, "curb_clearance": 0.05})"));
        EXPECT_EQ(keys(answer["parked"]), (Keys{"heading", "curb"}));
        EXPECT_NEAR(answer["parked"]["heading"].get<double>(), 1.5707963267948966, 1e-15);
    }
    const Result plain = run(zoe + "--format json --front-setback 0 --curb high");
    EXPECT_EQ(plain.out, run(zoe + "--format json").out);
}

TEST(Entry, JsonHasTheDocumentedKeysInOrder) {
    const Result result = run(zoe + "--format json --side left --corner 3,-4 --heading 0.3");
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Json answer = Json::parse(result.out);
    EXPECT_EQ(keys(answer), (Keys{"schema", "car", "slot", "strategy", "max_changes", "parkable", "direction_changes",
                                  "proved", "undecided", "entry_ranges", "maneuver", "start_tolerance"}));
    EXPECT_EQ(answer["proved"], true);
    EXPECT_EQ(answer["undecided"], Json::array());
    EXPECT_EQ(keys(answer["car"]), (Keys{"name", "width", "front", "rear", "wheelbase", "max_steer"}));
    EXPECT_EQ(answer["slot"], Json::parse(R"({"length": 5.0, "width": 2.0, "side": "left", "corner": [3.0, -4.0],
                                              "heading": 0.3})"));
    EXPECT_EQ(answer["schema"], 1);
    EXPECT_EQ(answer["strategy"], "max-steer");
    EXPECT_TRUE(answer["max_changes"].is_null());
    EXPECT_EQ(answer["parkable"], true);
    const Json& maneuver = answer["maneuver"];
    EXPECT_EQ(keys(maneuver),
              (Keys{"direction_changes", "length", "seconds", "standing_steers", "swept", "entry", "goal", "moves"}));
    EXPECT_EQ(keys(maneuver["swept"]), (Keys{"x_min", "x_max", "y_min", "y_max"}));
    EXPECT_EQ(keys(maneuver["entry"]), (Keys{"x", "y", "heading"}));
    for (const Json& move : maneuver["moves"]) {
        EXPECT_EQ(keys(move), (Keys{"direction", "steering", "steering_angle", "length", "start", "end", "contact"}));
        EXPECT_TRUE(move["contact"].is_null() || keys(move["contact"]) == (Keys{"car", "obstacle"}));
    }
    for (const Json& range : answer["entry_ranges"]) {
        EXPECT_EQ(keys(range), (Keys{"heading_min", "heading_max", "direction_changes", "subrange"}));
    }
}

/// From as far off as it says, along the slot and out, the car still parks; the text rounds down.
TEST(Entry, TellsHowFarTheStartMayBeOff) {
    const Json off = Json::parse(run(zoe + "--format json").out)["start_tolerance"];
    EXPECT_EQ(keys(off), (Keys{"along", "out", "both"}));
    EXPECT_EQ(keys(off["both"]), (Keys{"along", "out"}));
    EXPECT_GT(off["along"], off["both"]["along"]);
    EXPECT_GT(off["both"]["along"], 0.0);
    EXPECT_GT(off["out"], off["both"]["out"]);
    const std::string text = run(zoe).out;
    std::istringstream after(text.substr(text.find("off by     as far as ") + 21));
    double told = 0.0;
    after >> told;
    EXPECT_LE(told, off["along"].get<double>());
    EXPECT_NEAR(told, off["along"].get<double>(), 1e-3);
    EXPECT_NE(run("entry --car renault-zoe --length 9 --width 3 --enter forward").out.find(" m ahead, or "),
              std::string::npos);
    EXPECT_EQ(run(zoe + "--strategy fewest").out.find("off by"), std::string::npos);
    EXPECT_FALSE(Json::parse(run(zoe + "--strategy fewest --format json").out).contains("start_tolerance"));
    EXPECT_FALSE(Json::parse(run(zoe + "--strategy stepping --format json").out).contains("start_tolerance"));
}

/// Straight on in the same direction costs no change, back costs one.
TEST(Entry, TellsWhatEndingInTheMiddleTakes) {
    const std::string mid = "entry --car mid-size --length 5.1 --width 2.2 ";
    EXPECT_NE(run(mid).out.find("centred    after 0.193 m straight back, one change more"), std::string::npos);
    EXPECT_NE(run("entry --car renault-zoe --length 5.5 --width 2.2").out.find("straight ahead, no further change"),
              std::string::npos);
}

/// Where the parallel car has no room it may park all the same; then nothing says that the slot is too small.
TEST(Entry, AShortButDeepSlotHoldsALongCarAslant) {
    const Folder folder;
    const std::string van = folder.file("van.json");
    std::ofstream(van) << R"({"width": 2.215, "front": 5.1, "rear": 0.669, "wheelbase": 4.481, "max_steer": 0.502})";
    const Result entry = run("entry --car " + van + " --length 5.55 --width 7.16");
    EXPECT_EQ(entry.exit_code, 0);
    EXPECT_EQ(entry.out.find("too short"), std::string::npos) << entry.out;
    EXPECT_NE(entry.out.find("Proved: no entry heading needs fewer direction changes"), std::string::npos) << entry.out;
    const Result smaller = run("min-slot --car " + van + " --length 5.55 --width 7.16");
    EXPECT_EQ(smaller.exit_code, 0);
    EXPECT_EQ(smaller.out.find("too short"), std::string::npos) << smaller.out;
    const Result parallel = run("entry --car " + van + " --length 5.55 --width 7.16 --parked-heading 10");
    EXPECT_EQ(parallel.exit_code, 1);
    EXPECT_NE(parallel.out.find("0.219 m too short"), std::string::npos) << parallel.out;
}

TEST(Entry, PartsOfAnAnswerAgree) {
    for (const std::string& question : parkable) {
        const Result result = run(question + " --format json");
        ASSERT_EQ(result.exit_code, 0) << question << ": " << result.err;
        const Json answer = Json::parse(result.out);
        const Json& maneuver = answer["maneuver"];
        const Json& moves = maneuver["moves"];
        ASSERT_FALSE(moves.empty());
        EXPECT_EQ(answer["direction_changes"], maneuver["direction_changes"]);
        EXPECT_EQ(maneuver["entry"], moves.front()["start"]);
        EXPECT_EQ(maneuver["goal"], moves.back()["end"]);
        int changes = 0;
        double length = 0.0;
        for (std::size_t i = 0; i < moves.size(); ++i) {
            const double angle = moves[i]["steering_angle"];
            EXPECT_EQ(moves[i]["steering"], angle > 0 ? "left" : angle < 0 ? "right" : "straight");
            EXPECT_LE(std::abs(angle), answer["car"]["max_steer"].get<double>());
            length += moves[i]["length"].get<double>();
            if (i > 0) {
                changes += moves[i]["direction"] != moves[i - 1]["direction"] ? 1 : 0;
                EXPECT_EQ(moves[i]["start"], moves[i - 1]["end"]);
            }
        }
        EXPECT_EQ(maneuver["direction_changes"], changes);
        EXPECT_NEAR(maneuver["length"].get<double>(), length, 1e-9 * length);

        const bool trials = question.find("trials") != question.npos;
        ASSERT_EQ(answer["entry_ranges"].empty(), trials);
        double last = -1.0;
        for (const Json& range : answer["entry_ranges"]) {
            EXPECT_GE(range["heading_min"].get<double>(), last) << "ranges rise and do not overlap";
            EXPECT_LE(range["heading_min"], range["heading_max"]);
            EXPECT_GE(range["direction_changes"], answer["direction_changes"]);
            last = range["heading_max"];
        }
    }
}

TEST(Entry, NumbersReadBackTheSame) {
    const Result result = run(zoe + "--format json");
    const Json answer = Json::parse(result.out);
    EXPECT_EQ(write(answer), result.out);
    EXPECT_EQ(Json::parse(answer.dump()), answer);
}

TEST(Entry, TheCarOfAnAnswerIsACarFile) {
    const Folder folder;
    const Result named = run(zoe + "--format json");
    const std::string file = folder.with("car.json", Json::parse(named.out)["car"].dump());
    EXPECT_EQ(run("entry --length 5 --width 2 --format json --car " + file).out, named.out);
}

TEST(Entry, CsvHasOneRowPerRange) {
    const Result json = run(zoe + "--format json --max-changes 6");
    const Result csv = run(zoe + "--format csv --max-changes 6");
    EXPECT_EQ(csv.exit_code, 0);
    const std::vector<std::string> rows = lines(csv.out);
    const Json ranges = Json::parse(json.out)["entry_ranges"];
    ASSERT_EQ(rows.size(), ranges.size() + 1);
    EXPECT_EQ(rows[0], "heading_min,heading_max,direction_changes,subrange");
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        EXPECT_EQ(rows[i + 1].substr(0, rows[i + 1].find(',')), ranges[i]["heading_min"].dump());
    }
}

TEST(Entry, CsvHasTheMovesOfTheManeuverOnDemand) {
    const Result csv = run(zoe + "--format csv --view maneuver");
    const std::vector<std::string> rows = lines(csv.out);
    const Json moves = Json::parse(run(zoe + "--format json").out)["maneuver"]["moves"];
    ASSERT_EQ(rows.size(), moves.size() + 1);
    EXPECT_EQ(rows[0].substr(0, 31), "direction,steering_angle,length");
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const std::string begin = moves[i]["direction"].get<std::string>() + ',' + moves[i]["steering_angle"].dump() +
                                  ',' + moves[i]["length"].dump() + ',';
        EXPECT_EQ(rows[i + 1].substr(0, begin.size()), begin);
    }
    EXPECT_EQ(run(zoe + "--format csv --view entries").out, run(zoe + "--format csv").out);
    EXPECT_EQ(lines(run(too_small + "--format csv --view maneuver").out).size(), 1U);
}

TEST(Entry, TextFitsEightyColumns) {
    for (const std::string& question : parkable) {
        const Result result = run(question);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_GT(lines(result.out).size(), 10U);
        for (const std::string& line : lines(result.out)) {
            EXPECT_LE(line.size(), 80U) << line;
            EXPECT_TRUE(line.empty() || line.back() != ' ') << '"' << line << '"';
        }
    }
}

TEST(Entry, ACarThatCannotParkIsAnAnswer) {
    const Result json = run(too_small + "--format json");
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_EQ(json.err, "");
    const Json answer = Json::parse(json.out);
    EXPECT_EQ(keys(answer), (Keys{"schema", "car", "slot", "strategy", "max_changes", "parkable", "proved", "undecided",
                                  "proved_changes", "entry_ranges", "any_maneuver"}));
    EXPECT_EQ(answer["any_maneuver"],
              Json::parse(R"({"direction_changes": null, "lower_bound": 201, "proved": true})"));
    EXPECT_EQ(answer["proved"], true);
    EXPECT_EQ(answer["proved_changes"], 200);
    EXPECT_EQ(answer["parkable"], false);
    EXPECT_EQ(answer["entry_ranges"], Json::array());

    const Result text = run(too_small);
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_NE(text.out.find("0.100 m too short"), std::string::npos) << text.out;
    const Result csv = run(too_small + "--format csv");
    EXPECT_EQ(csv.exit_code, 1);
    EXPECT_EQ(lines(csv.out).size(), 1U);

    const Result tight = run("entry --car renault-zoe --extra-length 0.001 --extra-width 0.001");
    EXPECT_EQ(tight.exit_code, 1);
    EXPECT_NE(tight.out.find("up to 200 direction changes"), std::string::npos) << tight.out;
}

/// A car file for tests: a bus, and a car with a sheet's words.
const char* const bus =
    R"({"name": "bus", "width": 2.55, "length": 12, "front_overhang": 2.8, "wheelbase": 6, "max_steer_deg": 50})";

TEST(Entry, WhereFullSteeringCannotAnyManeuverIsTold) {
    const Folder folder;
    const std::string file = folder.with("bus.json", bus);
    for (const std::string& question :
         {"entry --length 15 --width 3 --car " + file,
          std::string("entry --car vw-transporter --length 6.3 --width 2.2"),
          std::string("entry --car renault-zoe --length 4.8 --width 1.84"),
          std::string("entry --car renault-zoe --length 4.8 --width 1.84 --strategy reversed-trials")}) {
        const Result result = run(question + " --format json");
        ASSERT_EQ(result.exit_code, 1) << question << result.err;  // the strategy's own answer and exit code stay
        const Json answer = Json::parse(result.out);
        EXPECT_EQ(answer["parkable"], false);
        const Json& any = answer["any_maneuver"];
        EXPECT_EQ(keys(any), (Keys{"direction_changes", "lower_bound", "proved"}));
        const std::string plain = question.substr(0, question.find(" --strategy"));
        const Json fewest = Json::parse(run(plain + " --strategy fewest --format json").out);
        ASSERT_TRUE(any["direction_changes"].is_number()) << question;
        EXPECT_GE(any["direction_changes"], fewest["lower_bound"]) << question;
        EXPECT_LE(any["lower_bound"], fewest["direction_changes"]) << question;
        EXPECT_LE(any["lower_bound"], any["direction_changes"]) << question;
        EXPECT_EQ(any["proved"], any["lower_bound"] == any["direction_changes"]) << question;
        const Result text = run(question);
        EXPECT_EQ(text.exit_code, 1);
        EXPECT_NE(text.out.find("--strategy fewest"), std::string::npos) << text.out;
    }
    EXPECT_EQ(Json::parse(run("entry --length 15 --width 3 --format json --car " + file).out)["any_maneuver"],
              Json::parse(R"({"direction_changes": 0, "lower_bound": 0, "proved": true})"));
    EXPECT_FALSE(Json::parse(run(zoe + "--format json").out).contains("any_maneuver"));
}

TEST(Entry, ACountThatIsNotTheFewestSaysSo) {
    EXPECT_NE(run("entry --car renault-zoe --length 5.2 --width 1.9").out.find("do with 2 direction changes"),
              std::string::npos);
    EXPECT_EQ(run("entry --car renault-zoe --length 5.2 --width 2").out.find("Other maneuvers"), std::string::npos);
}

/// What stands in the last column of the "What would do" that names it.
std::string way_out(const std::string& text, const std::string& what) {
    for (const std::string& line : lines(text))
        if (line.rfind("  " + what, 0) == 0) return line.substr(line.find("--"));
    return "";
}

TEST(Entry, ANoNamesTheWayOut) {
    const std::string slot = "entry --car renault-zoe --length 4.5 --width 2 ";
    const std::string length = "entry --car renault-zoe --width 2 ";
    const std::string width = "entry --car renault-zoe --length 4.5 ";
    for (const std::string& strategy : {std::string(), std::string("--strategy fewest --resolution 0.008 ")}) {
        const Result no = run(slot + strategy + "--max-changes 5");
        EXPECT_EQ(no.exit_code, 1);
        const std::string more = way_out(no.out, "more changes");
        ASSERT_NE(more, "") << no.out;
        EXPECT_EQ(run(slot + strategy + more).exit_code, 0) << more;
        const std::string longer = way_out(no.out, "a longer slot");
        ASSERT_NE(longer, "") << no.out;
        EXPECT_EQ(run(length + strategy + "--max-changes 5 " + longer).exit_code, 0) << longer;
        const std::string wider = way_out(no.out, "a wider slot");
        ASSERT_NE(wider, "") << no.out;
        EXPECT_EQ(run(width + strategy + "--max-changes 5 " + wider).exit_code, 0) << wider;
        EXPECT_EQ(way_out(no.out, "less clearance"), "");
        const std::string roomy = "entry --car renault-zoe --length 5 --width 2 --max-changes 5 " + strategy;
        const std::string less = way_out(run(roomy + "--clearance 0.09").out, "less clearance");
        ASSERT_NE(less, "");
        EXPECT_EQ(run(roomy + less).exit_code, 0) << less;
        EXPECT_GT(std::stod(less.substr(12)), 0.05);
    }
    const Result small = run("entry --car renault-zoe --length 4 --width 2");
    EXPECT_NE(way_out(small.out, "a longer slot"), "") << small.out;
    const std::string any = way_out(small.out, "any maneuver");
    EXPECT_NE(any.find("--strategy fewest"), std::string::npos) << small.out;
    EXPECT_EQ(run("entry --car renault-zoe --width 2 " + any).exit_code, 0) << any;
    EXPECT_NE(small.out.find("No other maneuver parks either"), std::string::npos) << small.out;
    const Result keeping = run("entry --car renault-zoe --length 4.2 --width 2 --clearance 0.1 --strategy fewest");
    EXPECT_NE(keeping.out.find("too short for the car with its clearance"), std::string::npos) << keeping.out;
}

TEST(Entry, AnglesAreRadiansOrDegrees) {
    const std::string form = "--format json ";
    EXPECT_EQ(run(zoe + form + "--heading 90deg").out, run(zoe + form + "--heading 1.5707963267948966").out);
    EXPECT_EQ(run(zoe + form + "--heading 0.5rad").out, run(zoe + form + "--heading 0.5").out);
    EXPECT_EQ(run(zoe + form + "--min-range 0.1deg").out, run(zoe + form + "--min-range 0.0017453292519943296").out);
    const auto parked = [&](const std::string& angle) {
        return Json::parse(run(zoe + form + "--parked-heading " + angle).out)["parked"]["heading"].get<double>();
    };
    EXPECT_DOUBLE_EQ(parked("0.05rad"), 0.05);
    EXPECT_EQ(parked("3deg"), parked("3"));
    expect_refusal(run(zoe + "--heading 100grad"), {"--heading", "radians", "1deg"});
    expect_refusal(run(zoe + "--min-range 200deg"), {"--min-range", "between 0 and 1.57"});
    expect_refusal(run(zoe + "--length 5m"), {"--length"});
}

TEST(Entry, TheCarMayComeOnStandardInput) {
    const Folder folder;
    const std::string file = folder.with("bus.json", bus);
    const auto piped = [&](const std::string& line) {
        const std::string out = folder.file("out");
        EXPECT_EQ(std::system((std::string(snug_command()) + ' ' + line + " < " + file + " > " + out).c_str()), 0);
        return contents(out);
    };
    EXPECT_EQ(piped("entry --car - --length 16 --width 4"), run("entry --length 16 --width 4 --car " + file).out);
    EXPECT_EQ(piped("cars -"), run("cars " + file).out);
}

TEST(Entry, PicturesAreWrittenInTheFormatOfTheirName) {
    const Folder folder;
    for (const std::string view : {"maneuver", "entries"}) {
        for (const auto& [extension, magic] :
             std::vector<std::pair<std::string, std::string>>{{"svg", "<?xml"}, {"pdf", "%PDF"}, {"png", "\x89PNG"}}) {
            const std::string file = folder.file(view + "." + extension);
            const Result result = run(zoe + "--view " + view + " --draw " + file);
            EXPECT_EQ(result.exit_code, 0) << result.err;
            EXPECT_EQ(contents(file).substr(0, magic.size()), magic);
        }
    }
    EXPECT_EQ(run(too_small + "--draw " + folder.file("none.svg")).exit_code, 1);
    EXPECT_EQ(folder.files(), 7U);
}

TEST(Help, ExplainsUnitsAndExitCodesInEightyColumns) {
    for (const std::string command : {"--help", "-h", "entry --help", "min-slot --help", "park --help", "cars --help",
                                      "entry --car renault-zoe -h"}) {
        const Result result = run(command);
        EXPECT_EQ(result.exit_code, 0);
        EXPECT_EQ(result.err, "");
        EXPECT_NE(result.out.find("Exit codes"), std::string::npos);
        EXPECT_NE(result.out.find("Example"), std::string::npos);
        for (const std::string& line : lines(result.out)) {
            EXPECT_LE(line.size(), 80U) << line;
        }
    }
    const Result version = run("--version");
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_EQ(version.out.rfind("snug ", 0), 0U);
}

}  // namespace
}  // namespace snug::test
