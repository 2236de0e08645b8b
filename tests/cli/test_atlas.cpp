// snug atlas as people use it: built, cut off at any moment, asked, exported, checked.
#include <sys/resource.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "oracle/random_cases.hpp"
#include "process.hpp"
#include "sample.hpp"

namespace snug::test {
namespace {

using namespace std::chrono_literals;

std::string build(const std::string& file, const std::string& rest = "") {
    return "atlas build --db " + file + " --cars renault-zoe,opel-corsa --width 1.8:2.2:0.1 --length 4.4:5.2:0.1 " +
           rest;
}

std::string csv(const std::string& file) { return run("atlas export --db " + file).out; }

TEST(Atlas, BuiltAskedExportedChecked) {
    const Folder folder;
    const std::string database = folder.file("two.sqlite");
    const std::string atlas = folder.file("two.atlas");
    const Result built = run(build(database));
    EXPECT_EQ(built.exit_code, 0) << built.err;
    EXPECT_NE(built.out.find("2 cars in 5 x 9 slots, 90 cells"), std::string::npos) << built.out;
    EXPECT_NE(run(build(database)).out.find(" 0 of them solved now"), std::string::npos);
    EXPECT_EQ(run("atlas export --db " + database + " -o " + atlas).exit_code, 0);
    EXPECT_EQ(run("atlas export --db " + database + " -o " + folder.file("two.csv")).exit_code, 0);
    const std::string rows = contents(folder.file("two.csv"));
    EXPECT_EQ(rows, csv(database));
    EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 91);
    EXPECT_EQ(folder.files(), 3U) << "nothing else remains";
    for (const std::string& file : {database, atlas}) {
        const Result checked = run("atlas verify --db " + file + " --solve 30");
        EXPECT_EQ(checked.exit_code, 0) << checked.err;
        EXPECT_NE(checked.out.find("30 cells solved again are the same"), std::string::npos) << checked.out;
    }
}

TEST(Atlas, StoredSlotsAreAnsweredAsByEntry) {
    const Folder folder;
    run(build(folder.file("a.sqlite")));
    run("atlas export --db " + folder.file("a.sqlite") + " -o " + folder.file("a.atlas"));
    for (const std::string where :
         {"--length 4.7 --width 2", "--length 5.1 --width 1.8 --side left --corner 3,4 --heading 0.5",
          "--length 4.4 --width 1.8"}) {
        const std::string slot = " --car renault-zoe --format json " + where;
        const Result fresh = run("entry" + slot);
        nlohmann::json wanted = nlohmann::json::parse(fresh.out);
        for (const char* key : {"proved", "undecided", "proved_changes", "any_maneuver", "start_tolerance"})
            wanted.erase(key);  // an atlas holds quick answers
        for (const std::string file : {"a.sqlite", "a.atlas"}) {
            SCOPED_TRACE(file + slot);
            const Result asked = run("atlas query --db " + folder.file(file) + slot);
            EXPECT_EQ(asked.exit_code, fresh.exit_code) << asked.err;
            nlohmann::json got = nlohmann::json::parse(asked.out);
            EXPECT_EQ(got["cell"]["shorter"], 0.0);
            EXPECT_EQ(got["cell"]["narrower"], 0.0);
            got.erase("cell");
            ASSERT_EQ(got.size(), wanted.size());
            for (const char* key : {"schema", "car", "slot", "strategy", "max_changes", "parkable", "entry_ranges"})
                EXPECT_EQ(got[key], wanted[key]) << key;
            if (!wanted.contains("maneuver")) continue;
            EXPECT_EQ(got["direction_changes"], wanted["direction_changes"]);
            const nlohmann::json &moves = got["maneuver"]["moves"], &wanted_moves = wanted["maneuver"]["moves"];
            ASSERT_EQ(moves.size(), wanted_moves.size());
            for (std::size_t i = 0; i < moves.size(); ++i) {
                for (const char* key : {"direction", "steering", "steering_angle", "length", "contact"})
                    EXPECT_EQ(moves[i][key], wanted_moves[i][key]) << key;
                for (const char* at : {"start", "end"})
                    for (const char* key : {"x", "y", "heading"})
                        EXPECT_NEAR(moves[i][at][key].get<double>(), wanted_moves[i][at][key].get<double>(), 1e-11);
            }
        }
    }
}

TEST(Atlas, IsNotOverwrittenByItsAnswers) {
    const Folder folder;
    const std::string database = folder.file("a.sqlite");
    const std::string exported = folder.file("a.atlas");
    run(build(database));
    run("atlas export --db " + database + " -o " + exported);
    for (const std::string& file : {database, exported}) {
        const std::string before = contents(file);
        for (const std::string ending : {".csv", ".atlas"}) {
            const std::string link = file + ending;
            std::filesystem::create_symlink(file, link);
            for (const std::string& to : {file, link, folder.file("./" + file.substr(file.rfind('/') + 1))}) {
                expect_refusal(run("atlas query --db " + file + " --car opel-corsa --length 5 --width 2 -o " + to),
                               {"--output", "is the atlas itself"});
                if (to.find(ending) != to.npos) {
                    EXPECT_EQ(run("atlas export --db " + file + " -o " + to).exit_code, 2) << to;
                }
            }
        }
        EXPECT_EQ(contents(file), before);
    }
}

TEST(Atlas, SaysWhatIsMissing) {
    const Folder folder;
    const std::string file = folder.file("a.sqlite");
    run(build(file));
    ASSERT_EQ(std::system(("sqlite3 " + file +
                           " 'DELETE FROM move WHERE cell = 5; DELETE FROM entry_range WHERE cell = 5; "
                           "DELETE FROM cell WHERE id = 5'")
                              .c_str()),
              0);
    EXPECT_EQ(run("atlas verify --db " + file).exit_code, 3);
    const Result rows = run("atlas export --db " + file);
    EXPECT_EQ(std::count(rows.out.begin(), rows.out.end(), '\n'), 90);
    EXPECT_NE(rows.err.find("89 of 90 cells"), std::string::npos) << rows.err;
    expect_refusal(run("atlas export --db " + file + " -o " + folder.file("a.atlas")),
                   {"89 of 90 cells", "complete it"});
}

TEST(Atlas, BetweenGridPointsItSaysWhichCellItUsed) {
    const Folder folder;
    run(build(folder.file("a.sqlite")));
    const std::string ask = "atlas query --db " + folder.file("a.sqlite") + " --car opel-corsa ";
    const nlohmann::json answer = nlohmann::json::parse(run(ask + "--length 4.76 --width 2.03 --format json").out);
    EXPECT_EQ(answer["cell"]["length"], 4.7);
    EXPECT_EQ(answer["cell"]["width"], 2.0);
    EXPECT_NEAR(answer["cell"]["shorter"].get<double>(), 0.06, 1e-12);
    EXPECT_EQ(answer["parkable"], true);
    EXPECT_NE(run(ask + "--length 4.76 --width 2.03").out.find("0.060 m shorter and 0.030 m narrower"),
              std::string::npos);
    const std::string renault = "atlas query --db " + folder.file("a.sqlite") + " --car renault-zoe ";
    const Result unknown = run(renault + "--length 4.45 --width 1.85");
    EXPECT_EQ(unknown.exit_code, 3) << "too small a cell says nothing of a larger slot: " << unknown.out;
    EXPECT_EQ(nlohmann::json::parse(run(renault + "--length 4.45 --width 1.85 --format json").out)["parkable"],
              nullptr);
    EXPECT_EQ(run(renault + "--length 4.4 --width 1.8").exit_code, 1);
}

TEST(Atlas, BeyondItsGridTheLargestSlotThatFitsAnswers) {
    const Folder folder;
    for (const std::string strategy : {"max-steer", "fewest --resolution 0.02"}) {
        const std::string file = folder.file("a.sqlite");
        std::filesystem::remove(file);
        ASSERT_EQ(run("atlas build --db " + file +
                      " --cars renault-zoe --width 1.9:2.1:0.1 --length 5:5.4:0.2 --strategy " + strategy)
                      .exit_code,
                  0);
        run("atlas export --db " + file + " -o " + folder.file("a.atlas"));
        for (const std::string& atlas : {file, folder.file("a.atlas")}) {
            const std::string ask = "atlas query --db " + atlas + " --car renault-zoe --format json ";
            const nlohmann::json within = nlohmann::json::parse(run(ask + "--length 5.4 --width 2.1").out);
            const Result result = run(ask + "--length 9 --width 2.5");
            ASSERT_EQ(result.exit_code, 0) << result.err;
            const nlohmann::json beyond = nlohmann::json::parse(result.out);
            EXPECT_EQ(beyond["slot"]["length"], 9.0);
            EXPECT_EQ(beyond["cell"]["length"], 5.4);
            EXPECT_EQ(beyond["direction_changes"], within["direction_changes"]);
            EXPECT_EQ(beyond["maneuver"]["entry"], within["maneuver"]["entry"]);
            if (strategy != "max-steer") {
                EXPECT_EQ(beyond["lower_bound"], 0) << "nothing is proved of larger slots";
            }
            expect_refusal(run(ask + "--length 4.9 --width 2.5"), {"--length", "outside the atlas"});
        }
        EXPECT_EQ(
            run("atlas query --db " + file + " --car renault-zoe --length 9 --width 2 --draw " + folder.file("a.svg"))
                .exit_code,
            0);
        EXPECT_EQ(contents(folder.file("a.svg")).substr(0, 5), "<?xml");
    }
}

TEST(Atlas, FewestTellsWhatIsProved) {
    const Folder folder;
    const std::string file = folder.file("f.sqlite");
    ASSERT_EQ(run("atlas build --db " + file +
                  " --cars renault-zoe --width 1.84,1.9,2 --length 4.2:5.2:0.5 --strategy fewest --max-changes 8 "
                  "--resolution 0.01")
                  .exit_code,
              0);
    const std::string ask = "atlas query --db " + file + " --car renault-zoe --format json ";
    const nlohmann::json exact = nlohmann::json::parse(run(ask + "--length 5.2 --width 1.9").out);
    EXPECT_EQ(exact["direction_changes"], 2);
    EXPECT_EQ(exact["lower_bound"], 2);
    EXPECT_EQ(exact["proved"], true);
    const nlohmann::json small = nlohmann::json::parse(run(ask + "--length 4.2 --width 1.84").out);
    EXPECT_EQ(small["parkable"], false);
    EXPECT_EQ(small["proved"], true);
    const nlohmann::json between = nlohmann::json::parse(run(ask + "--length 4.9 --width 1.95").out);
    EXPECT_EQ(between["cell"]["length"], 4.7);
    EXPECT_LE(between["lower_bound"], nlohmann::json::parse(run(ask + "--length 4.7 --width 1.9").out)["lower_bound"]);
}

// The work is killed while it goes on, again and again, until it is done: at other moments each time, because how far it comes
// in a given time is nobody's to say.
TEST(Atlas, KilledAtAnyMomentItGoesOn) {
    const Folder folder;
    const std::string grid =
        std::string(" --cars all --width 1.7:2.4:0.05 --length 4:6.5:") + (is_set("SNUG_SMALL") ? "0.1" : "0.05");
    ASSERT_EQ(run("atlas build --db " + folder.file("whole") + grid).exit_code, 0);
    const std::string wanted = csv(folder.file("whole"));
    const std::string file = folder.file("killed");
    oracle::Random random(6);
    const int kills = sample(20, 200);
    for (int i = 0; i < kills; ++i) {
        const pid_t child = start(words("atlas build --db " + file + grid), folder.file("out"), folder.file("err"));
        std::this_thread::sleep_for(std::chrono::microseconds(random.below(i % 2 == 0 ? 20'000 : 500'000)));
        kill(child, SIGKILL);
        wait_for(child);
        const Result checked = run("atlas verify --db " + file);
        // Killed before there was anything in it, the file is missing or empty.
        ASSERT_TRUE(checked.exit_code == 0 || checked.exit_code == 3 ||
                    checked.err.find("empty") != std::string::npos ||
                    checked.err.find("No such file") != std::string::npos)
            << checked.out << checked.err;
    }
    ASSERT_EQ(run("atlas build --db " + file + grid).exit_code, 0);
    EXPECT_EQ(csv(file), wanted);
    for (const std::string name : {"whole", "killed"})
        EXPECT_EQ(run("atlas export --db " + folder.file(name) + " -o " + folder.file(name + ".atlas")).exit_code, 0);
    EXPECT_EQ(contents(folder.file("whole.atlas")), contents(folder.file("killed.atlas")));
}

TEST(Atlas, CtrlCKeepsWhatIsFinished) {
    const Folder folder;
    const std::string file = folder.file("a.sqlite");
    const std::string long_work = "atlas build --db " + file + " --cars all --width 1.8:2.4:0.0001 --length 4:7:0.001";
    const pid_t child = start(words(long_work), folder.file("out"), folder.file("err"));
    while (!std::filesystem::exists(file) || std::filesystem::file_size(file) < 500'000)
        std::this_thread::sleep_for(5ms);
    const Result second = run(long_work);  // while the first one works
    expect_refusal(second, {"is being built by another process"});
    kill(child, SIGINT);
    EXPECT_EQ(wait_for(child), 130);
    const std::string said = contents(folder.file("err"));
    EXPECT_NE(said.find("interrupted; "), std::string::npos) << said;
    const std::string stored = said.substr(said.find("; ") + 2, said.find(" of ") - said.find("; ") - 2);
    EXPECT_NE(run("atlas verify --db " + file).out.find("of which " + stored + " are stored"), std::string::npos)
        << said;
}

/// Runs the command with files that may not grow beyond a size.
Result run_with_room(const std::string& line, rlim_t bytes) {
    rlimit before = {};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit room = {bytes, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &room);
    Result result = run(line);
    setrlimit(RLIMIT_FSIZE, &before);
    return result;
}

TEST(Atlas, WithoutRoomItKeepsWhatThereIs) {
    const Folder folder;
    const std::string file = folder.file("a.sqlite");
    const std::string grid = "atlas build --db " + file + " --cars all --width 3:3.3:0.1 --length 7:8:0.005";
    for (const rlim_t room : {1000U, 50'000U, 150'000U}) {
        const Result full = run_with_room(grid, room);
        EXPECT_EQ(full.exit_code, 2);
        EXPECT_EQ(std::count(full.err.begin(), full.err.end(), '\n'), 1) << full.err;
    }
    const std::string exported = folder.with("old.atlas", "old");
    ASSERT_EQ(run(grid).exit_code, 0);
    EXPECT_EQ(run_with_room("atlas export --db " + file + " -o " + exported, 50'000).exit_code, 2);
    EXPECT_EQ(contents(exported), "old");
    const std::string fresh = folder.file("fresh.sqlite");
    ASSERT_EQ(run("atlas build --db " + fresh + grid.substr(grid.find(" --cars"))).exit_code, 0);
    EXPECT_EQ(csv(file), csv(fresh));
}

// On a file system of 300 kB, where mounting one is allowed.
TEST(Atlas, OnAFullDiskItSaysSo) {
    const Folder folder;
    const std::string disk = folder.file("disk");
    std::filesystem::create_directory(disk);
    const auto mounted = [&](const std::string& command) {
        return std::system(("unshare --user --map-root-user --mount sh -c 'mount -t tmpfs -o size=300k tmpfs " + disk +
                            " && { " + command + "; }' >" + folder.file("out") + " 2>" + folder.file("err"))
                               .c_str());
    };
    if (mounted("true") != 0) GTEST_SKIP() << contents(folder.file("err"));
    const std::string grid = " --cars all --width 3:3.3:0.1 --length 7:8:0.001";
    mounted(std::string(snug_command()) + " atlas build --db " + disk + "/a.sqlite" + grid + "; cp " + disk +
            "/a.sqlite " + folder.file("a.sqlite"));
    const std::string said = contents(folder.file("err"));
    EXPECT_NE(said.find("disk is full; "), std::string::npos) << said;
    EXPECT_NE(said.find("make room, then run the same command again"), std::string::npos) << said;
    EXPECT_EQ(run("atlas verify --db " + folder.file("a.sqlite")).exit_code, 3) << "what there is, is whole";
}

TEST(Atlas, WrongInputIsToldAndNothingIsStarted) {
    const Folder folder;
    const std::string file = folder.file("a.sqlite");
    const std::string sizes = " --width 2 --length 5";
    expect_refusal(run("atlas"), {"build, query, export or verify"});
    expect_refusal(run("atlas bulid"), {"did you mean build?"});
    expect_refusal(run("atlas build --cars all" + sizes), {"--db is missing"});
    expect_refusal(run("atlas build --db " + file + sizes), {"--cars is missing"});
    expect_refusal(run("atlas build --db " + file + " --cars zoe" + sizes), {"--cars", "did you mean renault-zoe?"});
    expect_refusal(run("atlas build --db " + file + " --cars all,x.json" + sizes), {"--cars", "\"all\""});
    expect_refusal(run("atlas build --db " + file + " --cars all --width 2"), {"--length is missing"});
    expect_refusal(run("atlas build --db " + file + " --cars all --width nan --length 5"), {"--width", "nan"});
    expect_refusal(run("atlas build --db " + file + " --cars all --resolution 0.1" + sizes),
                   {"--resolution", "fewest"});
    expect_refusal(run("atlas build --db " + file + " --cars all --strategy fewest --min-range 0.1" + sizes),
                   {"--min-range", "max-steer"});
    expect_refusal(run("atlas build --db " + file + " --cars all --strategy stepping" + sizes),
                   {"max-steer or fewest"});
    expect_refusal(run("atlas build --db " + folder.file("none/a.sqlite") + " --cars all" + sizes),
                   {"none/a.sqlite", "No such file"});
    const std::string bad =
        folder.with("bad.csv", "name,width,front,rear,wheelbase,max_steer\na,1.8,3.6,0.8,abc,0.6\n");
    expect_refusal(run("atlas build --db " + file + " --cars " + bad + sizes),
                   {"bad.csv", "line 2", "wheelbase", "abc"});
    EXPECT_FALSE(std::filesystem::exists(file));

    ASSERT_EQ(run(build(file)).exit_code, 0);
    const std::string ask = "atlas query --db " + file + " --car ";
    expect_refusal(run(ask + "mid-size" + sizes), {"mid-size", "not in the atlas", "opel-corsa, renault-zoe"});
    expect_refusal(run(ask + "opel-corsa --width 2 --length 4.3"), {"--length", "from 4.4 m to 5.2 m", "built first"});
    expect_refusal(run(ask + "opel-corsa --width 1 --length 5"), {"--width", "from 1.8 m to 2.2 m"});
    expect_refusal(run(ask + "opel-corsa --format csv" + sizes), {"--format", "export"});
    expect_refusal(run("atlas export --db " + file + " -o " + folder.file("a.txt")), {".csv or .atlas"});
    expect_refusal(run("atlas export --db " + folder.file("none")), {"none", "No such file"});
    expect_refusal(run("atlas verify --db " + bad), {"bad.csv", "no database"});
    ASSERT_EQ(run("atlas export --db " + file + " -o " + folder.file("a.atlas")).exit_code, 0);
    expect_refusal(run("atlas export --db " + folder.file("a.atlas")), {"exported already"});
    expect_refusal(run("atlas query --db /dev/zero --car opel-corsa" + sizes), {"/dev/zero", "is no file"});
    expect_refusal(run("atlas build --db " + file + " --cars all --width 1:1000:0.001 --length 1:1000:0.001"),
                   {"2^40"});
    std::string damaged = contents(folder.file("a.atlas"));
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
    expect_refusal(run("atlas verify --db " + folder.with("b.atlas", damaged)), {"b.atlas", "damaged"});
    expect_refusal(run("atlas verify --db " + folder.with("c.atlas", damaged.substr(0, 900))),
                   {"c.atlas", "cut short"});
}

}  // namespace
}  // namespace snug::test
