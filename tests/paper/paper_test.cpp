// What `snug paper` computes is complete, readable and says itself what agrees; on a coarse grid, to be quick.
#include "paper/paper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "cli/process.hpp"
#include "snug/car.hpp"

namespace snug::paper {
namespace {

using test::Folder;

Options coarse() {
    Options options;
    options.grids.width_step = 0.25;
    options.grids.widest = 0.5;
    options.grids.length_step = 0.1;
    options.grids.heading_width = 0.05;
    options.grids.steps = {.step = 0.02, .heading_step = 2e-3};
    return options;
}

const std::vector<File>& files() {
    static const std::vector<File> all = regenerate(coarse());
    return all;
}

const std::string& bytes(const std::string& name) {
    const auto found =
        std::find_if(files().begin(), files().end(), [&](const File& file) { return file.name == name; });
    EXPECT_NE(found, files().end()) << name;
    return found->bytes;
}

std::vector<std::vector<std::string>> rows(const std::string& csv) {
    std::vector<std::vector<std::string>> all;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        all.emplace_back(1);
        for (const char c : line) {
            if (c == ',')
                all.back().emplace_back();
            else
                all.back().back() += c;
        }
    }
    return all;
}

nlohmann::json claims() { return nlohmann::json::parse(bytes("claims.json")).at("claims"); }

void expect_columns_and_rows() {
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"cars.csv", "car,width,front,rear,wheelbase,max_steer_deg,turning_radius,curb_to_curb"},
        {"car_paths.csv", "car,line,x,y"},
        {"possible_entries.csv",
         "position,x,y,heading,front_left_x,front_left_y,rear_left_x,rear_left_y,rear_right_x,rear_right_y,"
         "front_right_x,front_right_y"},
        {"entries_and_goals.csv",
         "position,x,y,heading,front_left_x,front_left_y,rear_left_x,rear_left_y,rear_right_x,rear_right_y,"
         "front_right_x,front_right_y"},
        {"reversed_trials.csv", "length,reversed_trials_their_goal,reversed_trials_our_goal,max_steer"},
        {"entry_headings.csv", "extra_width,max_changes,subrange,heading_min,heading_max"},
        {"subranges.csv", "extra_length,extra_width,subranges,subranges_wider_than_heading_step"},
        {"minimum_zoe.csv", "car,max_changes,extra_width,extra_length,width,length,entry_heading"},
        {"minimum_others.csv", "car,max_changes,extra_width,extra_length,width,length,entry_heading"},
        {"minimum_all.csv", "car,max_changes,extra_width,extra_length,width,length,entry_heading"},
        {"minimum_few_changes.csv", "car,max_changes,extra_width,extra_length,width,length,entry_heading"},
        {"minimum_paper_steps.csv", "car,max_changes,extra_width,extra_length"},
        {"extra_lengths.csv", "car,extra_width,max_changes,extra_length"}};
    std::set<std::string> names = {"claims.json", "extra_lengths.md"};
    for (const auto& [name, columns] : expected) {
        names.insert(name);
        const std::string& text = bytes(name);
        EXPECT_EQ(text.substr(0, text.find('\n')), columns) << name;
        const auto table = rows(text);
        EXPECT_GT(table.size(), 5U) << name;
        for (const auto& row : table) EXPECT_EQ(row.size(), table.front().size()) << name;
    }
    for (const File& file : files()) EXPECT_EQ(names.count(file.name), 1U) << file.name;
    EXPECT_EQ(files().size(), names.size());
}

void expect_numbers_words_or_empty() {
    for (const File& file : files()) {
        if (file.name.find(".csv") == file.name.npos) continue;
        for (const auto& row : rows(file.bytes)) {
            for (const std::string& field : row) {
                EXPECT_NE(field, "null") << file.name;
                char* end = nullptr;
                const double value = std::strtod(field.c_str(), &end);
                const bool is_number = !field.empty() && *end == '\0';
                EXPECT_TRUE(!is_number || std::isfinite(value)) << file.name << ": " << field;
            }
        }
    }
}

void expect_all_claims() {
    const std::vector<std::string> expected = {"mid-size-5.1x2.2",
                                               "zips-goal-not-optimal",
                                               "zoe-4.5x2.0",
                                               "reversed-trials-goal",
                                               "zoe-40cm",
                                               "zoe-100-changes",
                                               "corsa-40cm",
                                               "transporter-40cm",
                                               "amg-40cm",
                                               "beyond-25cm-width",
                                               "beyond-20-changes",
                                               "headings-wider-with-width",
                                               "even-and-odd",
                                               "headings-in-subranges",
                                               "subranges-rise-and-fall",
                                               "headings-wider-with-changes",
                                               "length-over-width",
                                               "one-subrange-when-wide",
                                               "transporter-40cm-width",
                                               "narrower-slots-with-changes",
                                               "transporter-and-sports-car"};
    std::set<std::string> ids;
    for (const auto& claim : claims()) ids.insert(claim.at("id").get<std::string>());
    EXPECT_EQ(ids, std::set<std::string>(expected.begin(), expected.end()));
    EXPECT_EQ(claims().size(), expected.size()) << "no claim is there twice";
}

void expect_claims_to_say_what_agrees() {
    for (const auto& claim : claims()) {
        const std::string id = claim.at("id");
        EXPECT_FALSE(claim.at("claim").get<std::string>().empty()) << id;
        EXPECT_FALSE(claim.at("finding").get<std::string>().empty()) << id;
        const auto& published = claim.at("published");
        const auto& exact = claim.at("exact");
        for (const char* value : {"paper_steps", "exact"})
            EXPECT_TRUE(claim.at(value).is_null() || claim.at(value).is_boolean() == published.is_boolean()) << id;
        bool same = published == exact;
        if (claim.at("unit") == "m")
            same = exact.is_number() && std::abs(exact.get<double>() - published.get<double>()) <= 0.05;
        EXPECT_EQ(claim.at("agrees").get<bool>(), same) << id;
    }
}

void expect_every_car_in_the_table() {
    const std::string& text = bytes("extra_lengths.md");
    EXPECT_EQ(text.find("nan"), text.npos);
    for (const Car& car : catalogue()) EXPECT_NE(text.find(car.name()), text.npos) << car.name();
    const std::string results = test::contents(std::filesystem::path(SNUG_ROOT) / "docs/results.md");
    EXPECT_NE(results.find(text.substr(text.find("| car"))), results.npos)
        << "docs/results.md shows another table than\n"
        << text;
}

// One test, because each runs as a process of its own and computes everything.
TEST(Paper, FiguresAndClaimsAreCompleteAndReadable) {
    expect_columns_and_rows();
    expect_numbers_words_or_empty();
    expect_all_claims();
    expect_claims_to_say_what_agrees();
    expect_every_car_in_the_table();
}

TEST(Paper, GivesUpWhenTold) {
    Options options = coarse();
    int told = 0;
    options.progress = [&](double part) {
        EXPECT_GE(part, 0.0);
        EXPECT_LE(part, 1.0);
        return ++told < 5;
    };
    EXPECT_TRUE(regenerate(options).empty());
}

TEST(PaperCommand, SaysWhyAFolderWillNotDo) {
    const Folder folder;
    test::expect_refusal(test::run("paper --out " + folder.with("file", "old")), {"--out", "is a file"});
    test::expect_refusal(test::run("paper --out " + folder.file("none/folder")), {"--out", "none/folder"});
    test::expect_refusal(test::run("paper --threads 0 --out " + folder.file("new")), {"--threads"});
    test::expect_refusal(test::run({"paper", "--out", ""}), {"--out"});
    EXPECT_EQ(folder.files(), 1U) << "nothing was made";
}

TEST(PaperCommand, InterruptedItLeavesNoFile) {
    const Folder folder;
    const pid_t child = test::start({"paper", "--out", folder.file("out")}, "/dev/null", "/dev/null");
    usleep(300'000);
    kill(child, SIGINT);
    EXPECT_NE(test::wait_for(child), 0);
    const std::filesystem::path out = folder.file("out");
    EXPECT_TRUE(!std::filesystem::exists(out) || std::filesystem::is_empty(out));
}

}  // namespace
}  // namespace snug::paper
