// Whatever is wrong: exit 2 and one line that says what, where and what would be right.
#include "questions.hpp"

namespace snug::test {
namespace {

TEST(BadInput, CommandsThatDoNotExist) {
    expect_refusal(run(""), {"entry", "cars"});
    expect_refusal(run("entri"), {"\"entri\"", "entry"});
    expect_refusal(run("--verson"), {"--verson", "--version"});
    expect_refusal(run("--version 3"), {"--version", "\"3\""});
    expect_refusal(run(std::vector<std::string>{""}), {"--help"});
}

TEST(BadInput, OptionsThatDoNotExist) {
    expect_refusal(run("entry --car renault-zoe --lenght 4.5 --width 2"), {"snug entry", "--lenght", "--length"});
    expect_refusal(run("entry --car renault-zoe --lenght=4.5 --width 2"), {"--lenght", "--length"});
    expect_refusal(run(zoe + "-x"), {"\"-x\""});
    expect_refusal(run(zoe + "more"), {"\"more\"", "--help"});
    expect_refusal(run("cars --formt json"), {"snug cars", "--formt", "--format"});
    expect_refusal(run("cars renault-zoe opel-corsa"), {"opel-corsa"});
}

TEST(BadInput, OptionsWithoutValueOrTwice) {
    expect_refusal(run("entry --car"), {"--car", "value"});
    expect_refusal(run("entry --car renault-zoe --length="), {"--length="});
    expect_refusal(run(zoe + "--length 6"), {"--length", "twice"});
    expect_refusal(run(zoe + "-o x -o y"), {"--output", "twice"});
    expect_refusal(run({"entry", "--car", "renault-zoe", "--length", "", "--width", "2"}), {"--length", "nothing"});
    expect_refusal(run({"entry", "--car", "", "--length", "5", "--width", "2"}), {"--car"});
}

TEST(BadInput, MissingAndExcludingOptions) {
    expect_refusal(run("entry --length 5 --width 2"), {"--car", "missing"});
    expect_refusal(run("entry --car renault-zoe --width 2"), {"--length", "--extra-length"});
    expect_refusal(run("entry --car renault-zoe --length 5"), {"--width", "--extra-width"});
    expect_refusal(run(zoe + "--extra-length 1"), {"--length", "--extra-length", "exclude"});
    expect_refusal(run(zoe + "--extra-width 1"), {"--width", "--extra-width", "exclude"});
    expect_refusal(run(zoe + "--view entries"), {"--view", "--draw"});
    expect_refusal(run(zoe + "--step 0.01"), {"--step", "stepping"});
    expect_refusal(run(zoe + "--stop inside"), {"--stop", "stepping"});
}

TEST(BadInput, NumbersThatAreNone) {
    for (const char* text : {"nan", "-nan", "inf", "-inf", "1e999", "0x5",   "5m",    "5 m", "five", "--width", "1e",
                             ".",   "-",    "+-5", "5..0", "4,5",   "1_000", "5:6:1", "e5",  "\n5",  "5\n"}) {
        expect_refusal(run({"entry", "--car", "renault-zoe", "--width", "2", "--length", text}), {"--length"});
        expect_refusal(run({"entry", "--car", "renault-zoe", "--length", "5", "--width", text}), {"--width"});
        expect_refusal(run({"entry", "--car", "renault-zoe", "--length", "5", "--width", "2", "--heading", text}),
                       {"--heading"});
    }
    expect_refusal(run("entry --car renault-zoe --width 2 --length 4.5m"), {"--length", "4.5m", "unit", "metres"});
}

TEST(BadInput, CountsAreWholeNumbers) {
    for (const char* text : {"x", "2.5", "1e2", "5m", "0x3", "-", "", "--width"}) {
        for (const char* question :
             {"entry --length 5", "leave --length 5 --gap-front 0.3 --gap-curb 0.1", "min-slot"}) {
            std::vector<std::string> all = words(question);
            all.insert(all.end(), {"--car", "renault-zoe", "--width", "2", "--max-changes", text});
            expect_refusal(run(all), {"--max-changes", "whole number", "from 0 to 1000"});
        }
    }
    for (const char* list : {"0:4:0.5", "0.5:4:1", "1,x", "1,,2", ","})
        expect_refusal(run(std::string("min-slot --car renault-zoe --width 2 --max-changes ") + list),
                       {"--max-changes", "whole number"});
    expect_refusal(run("min-slot --car renault-zoe --width 2 --max-changes 0:4"), {"from:to:step", "0:10:1"});
    expect_refusal(run(zoe + "--threads many"), {"--threads", "whole number", "1 to 1024"});
}

TEST(BadInput, NumbersOutOfRange) {
    const std::string car = "entry --car renault-zoe ";
    expect_refusal(run(car + "--length 0 --width 2"), {"--length is 0 m"});
    expect_refusal(run(car + "--length 5 --width -2"), {"--width is -2 m"});
    expect_refusal(run(car + "--length 1e7 --width 2"), {"--length"});
    expect_refusal(run(car + "--length 5 --extra-width -9"), {"--extra-width"});
    expect_refusal(run(zoe + "--clearance -0.1"), {"--clearance"});
    expect_refusal(run(zoe + "--min-range 2"), {"--min-range"});
    expect_refusal(run(zoe + "--max-changes -1"), {"--max-changes"});
    expect_refusal(run(zoe + "--max-changes 2.5"), {"--max-changes", "whole"});
    expect_refusal(run(zoe + "--max-changes 99999999999999999999"), {"--max-changes"});
    expect_refusal(run(zoe + "--threads 0"), {"--threads"});
    expect_refusal(run(zoe + "--threads 1025"), {"--threads"});
    expect_refusal(run(zoe + "--strategy stepping --step 0"), {"--step"});
    expect_refusal(run(zoe + "--goal=-4,-1,0"), {"--goal", "reversed-trials"});
    expect_refusal(run(zoe + "--strategy reversed-trials --goal=-4,-1"), {"--goal", "X,Y,HEADING"});
    expect_refusal(run(zoe + "--strategy reversed-trials --goal=-4,y,0"), {"--goal", "\"y\"", "metres"});
    expect_refusal(run(zoe + "--strategy reversed-trials --goal=-4,-1,z"), {"--goal", "\"z\"", "radians"});
    expect_refusal(run(zoe + "--strategy reversed-trials --goal=-4,0,0"), {"goal (-4 m, 0 m, 0 rad)", "inside"});
    expect_refusal(run(zoe + "--strategy parallel-trials --goal=-4,-1,0.1"), {"goal", "parallel"});
    expect_refusal(run(zoe + "--strategy parallel-trials --min-range 0.1"), {"--min-range", "trials"});
    expect_refusal(run(zoe + "--strategy stepping --heading-step 7"), {"--heading-step"});
    expect_refusal(run(zoe + "--corner 1"), {"--corner", "X,Y"});
    expect_refusal(run(zoe + "--corner 1,2,3"), {"--corner", "X,Y"});
    expect_refusal(run(zoe + "--corner 1,nan"), {"--corner", "nan"});
}

TEST(BadInput, NeighboursAndCurb) {
    expect_refusal(run(zoe + "--front-setback 2.5"), {"--front-setback is 2.5 m", "2 m wide"});
    expect_refusal(run(zoe + "--rear-setback 2.5"), {"--rear-setback is 2.5 m", "2 m wide"});
    expect_refusal(run(zoe + "--front-setback -0.1"), {"--front-setback", "between 0"});
    expect_refusal(run(zoe + "--curb medium"), {"--curb", "high or low"});
    expect_refusal(run(zoe + "--curb-clearance -1"), {"--curb-clearance"});
    expect_refusal(run(zoe + "--parked-heading 91"), {"--parked-heading is 91 degrees", "between 0 and 90 degrees"});
    expect_refusal(run(zoe + "--parked-curb x"), {"--parked-curb", "metres"});
    for (const char* strategy : {"stepping", "reversed-trials", "parallel-trials"})
        for (const char* option : {"--front-setback 0.1", "--rear-setback 0.1", "--curb low", "--curb-clearance 0",
                                   "--parked-heading 3", "--parked-curb 0.2"})
            expect_refusal(run(zoe + "--strategy " + strategy + " " + option),
                           {words(option)[0], "max-steer or fewest"});
    expect_refusal(run("leave --car renault-zoe --length 5 --width 2 --gap-front 0.3 --gap-curb 0.1 --parked-curb 1"),
                   {"--parked-curb"});
}

TEST(BadInput, DegreesInPlaceOfRadians) {
    expect_refusal(run(zoe + "--heading 90"), {"--heading is 90 rad", "90 degrees are 1.57079632679 rad"});
    expect_refusal(run(zoe + "--heading=-45"), {"--heading is -45 rad", "-45 degrees are -0.785398163397 rad"});
    expect_refusal(run(zoe + "--heading 400"), {"--heading is 400 rad", "between -6.2832 and 6.2832 rad"});
    expect_refusal(run(zoe + "--min-range 2"), {"--min-range is 2 rad", "2 degrees are 0.0349065850399 rad"});
    expect_refusal(run("leave --car renault-zoe --length 5 --width 2 --gap-front 0.3 --gap-curb 0.1 --car-heading 5"),
                   {"--car-heading is 5 rad", "5 degrees are"});
    expect_refusal(run(zoe + "--strategy reversed-trials --goal=-4,-1,30"), {"--goal is 30 rad", "30 degrees are"});
    EXPECT_EQ(run(zoe + "--heading=-6.2832").exit_code, 0);
}

TEST(BadInput, WordsThatAreNotKnown) {
    expect_refusal(run(zoe + "--side rigth"), {"--side", "right or left"});
    expect_refusal(run(zoe + "--enter sideways"), {"--enter", "backward or forward"});
    expect_refusal(run(zoe + "--strategy fastest"), {"--strategy", "max-steer", "stepping"});
    expect_refusal(run(zoe + "--format xml"), {"--format", "text, json or csv"});
    expect_refusal(run(zoe + "--strategy stepping --stop never"), {"--stop", "contact or inside"});
    expect_refusal(run("entry --car renault-zo --length 5 --width 2"), {"--car", "renault-zo", "renault-zoe"});
    expect_refusal(run("cars zoe"), {"\"zoe\"", "renault-zoe"});
}

TEST(BadInput, OnlyWordsThatAreNearAreSuggested) {
    const auto suggests = [](const std::string& line, const std::string& word) {
        expect_refusal(run(line), {"; did you mean " + word + "?\n"});
    };
    const auto suggests_nothing = [](const std::string& line, const std::string& instead) {
        const Result result = run(line);
        expect_refusal(result, {instead});
        EXPECT_EQ(result.err.find("did you mean"), std::string::npos) << result.err;
    };
    suggests("entyr --car mid-size", "entry");
    suggests("slot", "min-slot");
    suggests("--verison", "--version");
    suggests_nothing("drive-in", "write entry, min-slot, park, leave, drive, atlas, cars or paper, or --help");
    suggests_nothing("-x", "--help");
    suggests_nothing(std::string(100'000, 'e'), "--help");
    suggests("cars vw", "vw-transporter");
    suggests("cars Zoe", "renault-zoe");
    suggests("cars opel-crosa", "opel-corsa");
    suggests_nothing("cars golf", "`snug cars`");
    suggests_nothing("entry --car fiat-500 --length 5 --width 2", "`snug cars`");
    suggests(zoe + "--max-chagnes 3", "--max-changes");
    suggests(zoe + "--changes 3", "--max-changes");
    suggests(zoe + "--CAR 3", "--car");
    suggests(zoe + "-widht=3", "--width");
    suggests_nothing(zoe + "--haste 3", "snug entry --help");
    suggests_nothing(zoe + "-x", "snug entry --help");
    const Folder folder;
    suggests("cars " + folder.with("near.json", R"({"wheel-base": 2})"), "\"wheelbase\"");
    suggests_nothing(
        "cars " + folder.with("far.json", R"({"colour": 2})"),
        "write width, front, rear, wheelbase, length, front_overhang, rear_overhang, max_steer, max_steer_deg, "
        "turning_radius, curb_to_curb, wall_to_wall, outline, corner_radius or name");
}

TEST(BadInput, AnOptionOfAnotherCommandIsToldAsSuch) {
    expect_refusal(run(zoe + "--road 4"),
                   {"\"--road\"", "belongs to snug min-slot, snug park, snug leave or snug drive"});
    expect_refusal(run("min-slot --car mid-size --width 2 --from 2,1,0"), {"\"--from\"", "snug park"});
    expect_refusal(run("park --car mid-size --length 6 --width 2 --min-range 0.1"), {"snug entry or snug min-slot"});
    expect_refusal(run(zoe + "--gap-curb=0.1"), {"\"--gap-curb\"", "snug leave"});
}

TEST(BadInput, OfAStreetTwoSizesAreGivenAndOneIsSought) {
    const std::string bay = "min-slot --car renault-zoe --max-changes 1 --angle 90 ";
    expect_refusal(run(bay), {"--length is missing", "the third is sought"});
    expect_refusal(run(bay + "--length 5"), {"--width is missing"});
    expect_refusal(run(bay + "--length 5 --width 2.5 --road 6"), {"--road", "nothing is sought"});
    expect_refusal(run(bay + "--length 5,6 --width 2.5,2.6"), {"--length and --width are both lists"});
    expect_refusal(run(bay + "--length 5 --width 2.5 --strategy max-steer"), {"--strategy", "fewest"});
    expect_refusal(run(bay + "--length 5 --width 2.5 --min-range 0.1"), {"--min-range", "not for streets"});
    expect_refusal(run(bay + "--length 5 --width 2.5 --max-length 8"), {"--max-length"});
    expect_refusal(run("min-slot --car renault-zoe --angle 90 --length 5 --width 2.5"), {"--max-changes is missing"});
}

TEST(BadInput, BytesThatAreNoTextAreShownAsNumbers) {
    const auto shown_as = [](const std::string& typed, const std::string& shown) {
        expect_refusal(run({"entry", "--length", "5", "--width", "2", "--car", typed}), {'"' + shown + '"'});
        expect_refusal(run(std::vector<std::string>{typed}), {'"' + shown + '"'});
        expect_refusal(run({"entry", "--" + typed, "5"}), {"\"--" + shown + '"'});
        expect_refusal(run({"min-slot", "--car", "mid-size", "--max-changes", "1", "--width", typed}),
                       {"--width: \"" + shown + '"'});
    };
    shown_as("Zoé 雪 🚗", "Zoé 雪 🚗");
    shown_as("\xff\xfe", "\\xff\\xfe");
    shown_as("a\xc3", "a\\xc3");
    shown_as("\xe9t\xe9", "\\xe9t\\xe9");
    shown_as("\xc0\xaf\xe0\x80\xaf", "\\xc0\\xaf\\xe0\\x80\\xaf");
    shown_as("\xed\xa0\x80\xf4\x90\x80\x80", "\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80");
    shown_as("\x1b[31m\n\x7f\xc2\x9b", "\\x1b[31m\\x0a\\x7f\\xc2\\x9b");
    const std::string almost = std::string(59, 'a');
    expect_refusal(run(almost + "é"), {'"' + almost + "...\""});
    const Folder folder;
    expect_refusal(run({"cars", folder.file("no\xff\n.json")}), {"no\\xff\\x0a.json"});
    expect_refusal(run({"cars", "-o", folder.file("no\xff/cars")}), {"--output"});
}

TEST(BadInput, FilesThatAreNoCars) {
    const Folder folder;
    const auto refused = [&](const std::string& file, const std::vector<std::string>& named) {
        std::vector<std::string> all = named;
        all.push_back(file);
        expect_refusal(run({"entry", "--length", "5", "--width", "2", "--car", file}), all);
        expect_refusal(run({"cars", file}), all);
    };
    refused(folder.file("none.json"), {"No such file"});
    refused(folder.file(""), {"directory"});
    refused(folder.with("empty.json", ""), {"line 1"});
    refused(folder.with("huge.json", std::string(1'100'000, ' ')), {"1 MB"});
    refused("/dev/zero", {"1 MB"});
    refused(folder.with("deep.json", std::string(900'000, '[')), {"a list"});
    refused(folder.with("binary.json", std::string("\xff\xfe\0\0", 4)), {"line 1"});
    if (geteuid() != 0) {
        const std::string secret = folder.with("secret.json", "{}");
        std::filesystem::permissions(secret, std::filesystem::perms::none);
        refused(secret, {"Permission denied"});
    }
}

}  // namespace
}  // namespace snug::test
