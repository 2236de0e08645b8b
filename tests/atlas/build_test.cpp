// What is built is what the questions answer, however often the work is cut off and on however many threads.
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <map>
#include <tuple>

#include "cli/process.hpp"
#include "model/refusals.hpp"
#include "oracle/follower.hpp"
#include "sample.hpp"
#include "snug/atlas_database.hpp"
#include "snug/entry.hpp"
#include "snug/fewest.hpp"

namespace snug::test {
namespace {

using model::refusal;
using oracle::Random;

std::vector<double> steps(double from, double step, int count) {
    std::vector<double> sizes;
    for (int i = 0; i < count; ++i) sizes.push_back(std::round((from + i * step) * 1e9) / 1e9);
    return sizes;
}

AtlasPlan small_plan() {
    return {{*find_car("renault-zoe"), *find_car("opel-corsa")}, steps(1.8, 0.1, 4), steps(4.4, 0.1, 9), {}};
}

/// Everything a database says, in words that can be compared; with the cars' names, because their numbers may differ.
std::vector<std::string> contents_of(const std::string& path) {
    const AtlasDatabase database(path);
    std::vector<std::string> all;
    database.each([&](std::size_t car, double width, double length, const CellAnswer& answer) {
        std::ostringstream text;
        text.precision(17);
        text << database.plan().cars[car].name() << ' ' << width << ' ' << length << ' '
             << answer.direction_changes.value_or(-1) << ' ' << answer.lower_bound << answer.proved << ' '
             << answer.entry.x << ' ' << answer.entry.y << ' ' << answer.entry.heading;
        for (const HeadingRange& range : answer.ranges)
            text << " (" << range.min << ' ' << range.max << ' ' << range.direction_changes << ' ' << range.subrange
                 << ')';
        for (const AtlasMove& move : answer.moves) {
            text << " [" << static_cast<int>(move.direction) << ' ' << move.steering_angle << ' ' << move.length;
            if (move.contact) text << ' ' << to_string(move.contact->part) << ' ' << to_string(move.contact->obstacle);
            text << ']';
        }
        all.push_back(text.str());
        return true;
    });
    return all;
}

std::vector<std::string> built(const std::string& path, const AtlasPlan& plan, int threads = 0) {
    {
        AtlasBuild build(path, plan);
        EXPECT_TRUE(build_atlas(build, {.threads = threads}));
    }
    return contents_of(path);
}

void expect_same_moves(const std::vector<AtlasMove>& stored, const std::optional<Maneuver>& fresh) {
    ASSERT_EQ(stored.size(), fresh ? fresh->moves.size() : 0);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const Move& move = fresh->moves[i];
        ASSERT_EQ(stored[i].direction, move.direction);
        ASSERT_EQ(stored[i].steering_angle, move.steering_angle);
        ASSERT_EQ(stored[i].length, move.length);
        ASSERT_EQ(stored[i].contact.has_value(), move.contact.has_value());
        if (!move.contact) continue;
        ASSERT_EQ(stored[i].contact->part, move.contact->part);
        ASSERT_EQ(stored[i].contact->obstacle, move.contact->obstacle);
    }
}

/// The five cars of the paper in slots from too small to roomy: many in a soak, few where sanitizers look on.
AtlasPlan five_cars(Strategy strategy) {
    const bool fewest = strategy == Strategy::fewest;
    int widths = fewest ? 4 : 8, lengths = fewest ? 5 : 15;
    if (is_set("SNUG_SOAK")) {
        widths = fewest ? 12 : 60, lengths = fewest ? 30 : 150;
    } else if (is_set("SNUG_SMALL")) {
        widths = fewest ? 2 : 4, lengths = fewest ? 3 : 8;
    }
    AtlasPlan plan = {catalogue(), steps(1.6, 1.2 / widths, widths), steps(4.0, 3.0 / lengths, lengths), {}};
    plan.options.strategy = strategy;
    if (fewest) {
        plan.options.resolution = 0.01;
        plan.options.max_changes = 12;
    }
    return plan;
}

TEST(AtlasBuild, CellsAreWhatEntryAnswers) {
    const Folder folder;
    const AtlasPlan plan = five_cars(Strategy::max_steer);
    built(folder.file("db"), plan);
    const AtlasDatabase database(folder.file("db"));
    EXPECT_EQ(database.stored(), database.cells());
    Random random(1);
    int parked = 0;
    for (int i = 0; i < sample(300, 1000); ++i) {
        const auto car = static_cast<std::size_t>(random.below(5));
        const double width = plan.widths[static_cast<std::size_t>(random.below(static_cast<int>(plan.widths.size())))];
        const double length =
            plan.lengths[static_cast<std::size_t>(random.below(static_cast<int>(plan.lengths.size())))];
        SCOPED_TRACE(database.plan().cars[car].name() + " " + std::to_string(length) + " x " + std::to_string(width));
        const std::optional<CellAnswer> stored = database.cell(car, width, length);
        ASSERT_TRUE(stored);
        const Answer fresh =
            entry(*find_car(database.plan().cars[car].name()), Slot({length, width}), {.prove = false});
        ASSERT_EQ(stored->direction_changes, fresh.direction_changes);
        ASSERT_EQ(stored->ranges.size(), fresh.ranges.size());
        for (std::size_t k = 0; k < fresh.ranges.size(); ++k) {
            ASSERT_EQ(stored->ranges[k].min, fresh.ranges[k].min);
            ASSERT_EQ(stored->ranges[k].max, fresh.ranges[k].max);
            ASSERT_EQ(stored->ranges[k].direction_changes, fresh.ranges[k].direction_changes);
            ASSERT_EQ(stored->ranges[k].subrange, fresh.ranges[k].subrange);
        }
        ASSERT_NO_FATAL_FAILURE(expect_same_moves(stored->moves, fresh.maneuver));
        if (!fresh.maneuver) continue;
        ++parked;
        ASSERT_EQ(stored->entry.x, fresh.maneuver->entry().x);
        ASSERT_EQ(stored->entry.y, fresh.maneuver->entry().y);
        ASSERT_EQ(stored->entry.heading, fresh.maneuver->entry().heading);
    }
    EXPECT_GT(parked, 5);
}

TEST(AtlasBuild, CellsAreWhatFewestAnswers) {
    const Folder folder;
    const AtlasPlan plan = five_cars(Strategy::fewest);
    built(folder.file("db"), plan);
    const AtlasDatabase database(folder.file("db"));
    Random random(2);
    int parked = 0;
    for (int i = 0; i < sample(50, 1000); ++i) {
        const auto car = static_cast<std::size_t>(random.below(5));
        const double width = plan.widths[static_cast<std::size_t>(random.below(static_cast<int>(plan.widths.size())))];
        const double length =
            plan.lengths[static_cast<std::size_t>(random.below(static_cast<int>(plan.lengths.size())))];
        SCOPED_TRACE(database.plan().cars[car].name() + " " + std::to_string(length) + " x " + std::to_string(width));
        const std::optional<CellAnswer> stored = database.cell(car, width, length);
        ASSERT_TRUE(stored);
        const Answer fresh = fewest(*find_car(database.plan().cars[car].name()), Slot({length, width}),
                                    {.max_changes = 12, .resolution = 0.01});
        ASSERT_EQ(stored->direction_changes, fresh.direction_changes);
        ASSERT_EQ(stored->lower_bound, fresh.lower_bound);
        ASSERT_EQ(stored->proved, fresh.proved);
        ASSERT_TRUE(stored->ranges.empty());
        ASSERT_NO_FATAL_FAILURE(expect_same_moves(stored->moves, fresh.maneuver));
        parked += fresh.maneuver ? 1 : 0;
    }
    EXPECT_GT(parked, 0);
}

/// The database as an exported file in memory.
std::string exported(const std::string& path) {
    const AtlasDatabase database(path);
    std::string bytes;
    AtlasWriter writer(database.plan(), database.made_by(), [&](std::string_view part) { bytes += part; });
    database.each([&](std::size_t, double, double, const CellAnswer& answer) {
        writer.add(answer);
        return true;
    });
    writer.finish();
    return bytes;
}

TEST(AtlasBuild, BetweenGridPointsWhatIsDrivenIsFreeOfContact) {
    for (const Strategy strategy : {Strategy::max_steer, Strategy::fewest}) {
        const Folder folder;
        built(folder.file("db"), five_cars(strategy));
        const std::string bytes = exported(folder.file("db"));
        const Atlas atlas(std::as_bytes(std::span(bytes)));
        Random random(3);
        int parked = 0;
        for (int i = 0; i < sample(1000, 10000); ++i) {
            const auto c = static_cast<std::size_t>(random.below(5));
            const double length = random.between(atlas.length(0), atlas.length(atlas.lengths() - 1));
            const double width = random.between(atlas.width(0), atlas.width(atlas.widths() - 1));
            const AtlasAnswer answer = atlas.look_up(c, length, width);
            if (answer.verdict != AtlasVerdict::parks) continue;
            ++parked;
            const Car car = atlas.car(c);
            SCOPED_TRACE(car.name() + " " + std::to_string(length) + " x " + std::to_string(width));
            const SlotDimensions slot = {.length = length, .width = width};
            const Maneuver driven = maneuver(answer.cell, car, Slot(slot));
            oracle::Case asked;
            asked.car = car.dimensions();
            asked.slot = slot;
            const auto problem = oracle::make_problem<double>(asked);
            int changes = 0;
            for (std::size_t k = 0; k < driven.moves.size(); ++k) {
                const Move& move = driven.moves[k];
                changes += k > 0 && move.direction != driven.moves[k - 1].direction ? 1 : 0;
                const auto path = oracle::path_of(slot, car.dimensions(), move);
                ASSERT_TRUE(oracle::is_free(problem, path, move.length, 1e-9)) << "move " << k;
            }
            const auto goal = oracle::into_slot(slot, driven.moves.back().end);
            ASSERT_LE(oracle::outside(problem, goal), 1e-9);
            ASSERT_EQ(changes, answer.cell.direction_changes());
            ASSERT_LE(answer.lower_bound, changes);
        }
        EXPECT_GT(parked, 5);
    }
}

TEST(AtlasBuild, IsTheSameOnAnyNumberOfThreads) {
    const Folder folder;
    const std::vector<std::string> alone = built(folder.file("1"), small_plan(), 1);
    EXPECT_EQ(alone.size(), 2U * 4 * 9);
    for (const int threads : {2, 3, 8}) {
        const std::string file = folder.file(std::to_string(threads));
        EXPECT_EQ(built(file, small_plan(), threads), alone);
        EXPECT_EQ(exported(file), exported(folder.file("1")));
    }
}

TEST(AtlasBuild, GoesOnWhereItWasCutOff) {
    const Folder folder;
    const std::vector<std::string> whole = built(folder.file("whole"), small_plan());
    Random random(4);
    for (int i = 0; i < sample(10, 200); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const std::string file = folder.file(std::to_string(i));
        std::uint64_t solved = 0;
        std::uint64_t before = 0;
        for (bool complete = false; !complete;) {
            AtlasBuild build(file, small_plan());
            ASSERT_EQ(build.progress().stored, before) << "nothing is lost, nothing is solved twice";
            std::atomic<int> looks = random.below(300);
            complete = build_atlas(build, {.threads = 1 + random.below(2), .go_on = [&] { return --looks > 0; }});
            before = build.progress().stored;
            solved += build.progress().solved;
            ASSERT_EQ(complete, before == build.progress().cells);
        }
        ASSERT_EQ(solved, whole.size());
        ASSERT_EQ(contents_of(file), whole);
        std::filesystem::remove(file);
    }
}

TEST(AtlasBuild, WhatIsNotCommittedIsMissing) {
    const Folder folder;
    {
        AtlasBuild build(folder.file("db"), small_plan());
        const CellBatch first = build.next();
        build.store({first, {CellAnswer{}}});
        build.commit();
        build.store({build.next(), {CellAnswer{}}});
        EXPECT_EQ(build.progress().stored, 2U);
    }
    EXPECT_EQ(AtlasDatabase(folder.file("db")).stored(), 1U);
}

TEST(AtlasBuild, GrowsByCarsAndSizes) {
    const Folder folder;
    AtlasPlan plan = {{*find_car("renault-zoe")}, {2.0, 2.2}, {4.8, 5.0}, {}};
    built(folder.file("db"), plan);
    plan.cars = {*find_car("opel-corsa")};
    plan.widths = {1.9, 2.0, 2.1, 2.2};
    plan.lengths = {5.0, 4.8, 5.2};  // in any order
    const std::vector<std::string> grown = built(folder.file("db"), plan);
    EXPECT_EQ(grown.size(), 2U * 4 * 3) << "the car that was there gets the new sizes as well";
    plan.cars.push_back(*find_car("renault-zoe"));
    EXPECT_EQ(grown, built(folder.file("at once"), plan));
}

/// Which sentence a plan is refused with where this one was built.
std::string refused(const std::string& path, const AtlasPlan& plan) {
    return refusal([&] { const AtlasBuild build(path, plan); });
}

TEST(AtlasBuild, NeverMixes) {
    const Folder folder;
    const std::string file = folder.file("db");
    const std::vector<std::string> before = built(file, small_plan());
    const auto expect = [&](const std::string& words, const auto& change) {
        AtlasPlan plan = small_plan();
        change(plan);
        const std::string said = refused(file, plan);
        EXPECT_NE(said.find(words), said.npos) << words << " is not in: " << said;
    };
    expect("another strategy: max-steer, not fewest",
           [](AtlasPlan& plan) { plan.options.strategy = Strategy::fewest; });
    expect("maximum of direction changes: none given, not 10", [](AtlasPlan& plan) { plan.options.max_changes = 10; });
    expect("clearance: 0 m, not 0.1 m", [](AtlasPlan& plan) { plan.options.driving.clearance = 0.1; });
    expect("least range of headings: 0 rad, not 0.001 rad", [](AtlasPlan& plan) { plan.options.min_range = 0.001; });
    expect("way in: backward, not forward", [](AtlasPlan& plan) { plan.options.driving.enter = Enter::forward; });
    expect("the width 1.9 m", [](AtlasPlan& plan) { plan.widths.erase(plan.widths.begin() + 1); });
    expect("the length 4.4 m", [](AtlasPlan& plan) { plan.lengths = {5.0}; });
    expect("another car called \"renault-zoe\"",
           [](AtlasPlan& plan) { plan.cars = {Car(find_car("mid-size")->dimensions(), "renault-zoe")}; });
    expect("no name", [](AtlasPlan& plan) { plan.cars = {Car(plan.cars[0].dimensions())}; });
    expect("two cars", [](AtlasPlan& plan) { plan.cars.push_back(plan.cars[0]); });
    expect("needs a car", [](AtlasPlan& plan) { plan.cars.clear(); });
    expect("widths and lengths", [](AtlasPlan& plan) { plan.widths.clear(); });
    expect("slot width is nan", [](AtlasPlan& plan) { plan.widths.push_back(std::nan("")); });
    expect("slot length is -1 m", [](AtlasPlan& plan) { plan.lengths.push_back(-1.0); });
    EXPECT_EQ(contents_of(file), before) << "what was refused has changed nothing";
}

TEST(AtlasBuild, OneAtATime) {
    const Folder folder;
    const std::string file = folder.file("db");
    {
        AtlasBuild build(file, small_plan());
        EXPECT_NE(refused(file, small_plan()).find("is being built"), std::string::npos);
        EXPECT_EQ(AtlasDatabase(file).stored(), 0U) << "it can be read meanwhile";
        EXPECT_TRUE(build_atlas(build)) << "and goes on undisturbed";
    }
    EXPECT_EQ(refused(file, small_plan()), "");
}

TEST(AtlasDatabase, RefusesWhatIsNone) {
    const Folder folder;
    const auto read = [](const std::string& path) { return refusal([&] { const AtlasDatabase database(path); }); };
    const auto expect = [](const std::string& said, const std::string& words) {
        EXPECT_NE(said.find(words), said.npos) << words << " is not in: " << said;
    };
    expect(read(folder.file("none")), "No such file");
    expect(read(folder.file("")), "directory");
    expect(read(folder.with("empty", "")), "is empty");
    expect(read(folder.with("text", std::string(5000, 'x'))), "is no database");
    expect(refused(folder.with("text", "short"), small_plan()), "is no database");
    expect(refused(folder.file(""), small_plan()), "is no file");
    expect(refused(folder.file("none/db"), small_plan()), "No such file");
    expect(refused("/dev/full", small_plan()), "is no file");
    const auto with_sql = [&](const std::string& statements) {
        std::string file = folder.file("altered");
        std::filesystem::remove(file);
        built(file, {{*find_car("renault-zoe")}, {2.0}, {5.0}, {}});
        EXPECT_EQ(std::system(("sqlite3 " + file + " \"" + statements + "\"").c_str()), 0);
        return file;
    };
    expect(read(with_sql("PRAGMA application_id = 5")), "another program");
    expect(read(with_sql("PRAGMA user_version = 1")), "version 1 of the atlas's tables");
    expect(refused(with_sql("UPDATE provenance SET value = '0.0.1' WHERE key = 'snug'"), small_plan()),
           "answers of snug 0.0.1");
    const AtlasDatabase damaged(with_sql("DELETE FROM car"));
    expect(damaged.trouble(), "cell");
    const auto read_all = [](const std::string& path) { return refusal([&] { contents_of(path); }); };
    for (const char* altered :
         {"UPDATE cell SET direction_changes = direction_changes + 1", "UPDATE cell SET proved = 1 - proved",
          "UPDATE cell SET entry_y = 1", "UPDATE move SET length = 1 WHERE number = 1",
          "DELETE FROM move WHERE number = 0", "UPDATE entry_range SET heading_max = heading_max + 1e-9",
          "DELETE FROM entry_range", "UPDATE cell SET checksum = 0", "UPDATE car SET wheelbase = 2.5",
          "UPDATE car SET name = 'zoe'", "UPDATE provenance SET value = 0.1 WHERE key = 'clearance'"})
        expect(read_all(with_sql(altered)), "is not what was stored; restore a copy");
    expect(read_all(with_sql("UPDATE car SET width = -1")), "is damaged");
    expect(read_all(with_sql("UPDATE slot_width SET width = -1")), "is damaged");
    expect(refused(with_sql("DELETE FROM slot_length"), {{*find_car("renault-zoe")}, {2.0}, {6.0}, {}}), "");
    expect(refused(with_sql("INSERT INTO cell SELECT 9, car, 3.0, length, 1, 0, 0, 0, 0, 0, 0 FROM cell"),
                   {{*find_car("renault-zoe")}, {2.0}, {5.0}, {}}),
           "2 cells for 1 slots; restore a copy");
    expect(refused(folder.file("large"),
                   {catalogue(), std::vector<double>(1 << 20, 2.0), std::vector<double>(1 << 20, 5.0), {}}),
           "at most 2^40");
    EXPECT_FALSE(std::filesystem::exists(folder.file("large")));
}

TEST(AtlasBuild, AsksNoMoreWhenNothingIsLeft) {
    const AtlasPlan plan = small_plan();
    for (int threads = 1; threads <= 8; ++threads) {
        int batches = 5;
        int stored = 0;
        const CellQueue queue = {
            [&] {
                EXPECT_GE(batches, 0) << "asked again";  // where next() waits, that is for ever
                return --batches < 0 ? CellBatch{} : CellBatch{0, plan.widths[0], {plan.lengths[0]}};
            },
            [&](const SolvedBatch& solved) { stored += static_cast<int>(solved.answers.size()); }};
        solve_all(plan, queue, threads, {});
        EXPECT_EQ(stored, 5);
        EXPECT_EQ(batches, -1);
    }
}

TEST(AtlasBuild, SaysThatItsFileWasTakenAway) {
    const Folder folder;
    const std::string file = folder.file("db");
    AtlasBuild build(file, small_plan());
    std::filesystem::remove(file);
    EXPECT_NE(refusal([&] { build_atlas(build); }).find("was removed or replaced"), std::string::npos);
}

TEST(AtlasDatabase, DamagedFilesAreSeenOrRefused) {
    const Folder folder;
    std::vector<std::string> stored = built(folder.file("db"), small_plan());
    std::sort(stored.begin(), stored.end());
    const std::string whole = contents(folder.file("db"));
    Random random(5);
    for (int i = 0; i < sample(200, 20000); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        std::string bytes = whole;
        if (random.chance(0.3)) {
            bytes.resize(static_cast<std::size_t>(random.below(static_cast<int>(bytes.size()))));
        } else {
            for (int k = random.below(i % 2 == 0 ? 4 : 200); k >= 0; --k)
                bytes[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] =
                    static_cast<char>(random.below(256));
        }
        const std::string file = folder.with("damaged", bytes);
        // Whatever it says, it is a sentence or the answers that were stored: never a crash, never other answers.
        const std::string said = refusal([&] {
            for (const std::string& answer : contents_of(file))
                ASSERT_TRUE(std::binary_search(stored.begin(), stored.end(), answer)) << answer;
            static_cast<void>(AtlasDatabase(file).trouble());
        });
        const std::string said_to_build = refusal([&] {
            AtlasBuild build(file, small_plan());
            build_atlas(build);
        });
        ASSERT_TRUE(said.empty() || said.find(' ') != said.npos);
        ASSERT_TRUE(said_to_build.empty() || said_to_build.find(' ') != said_to_build.npos);
    }
}

}  // namespace
}  // namespace snug::test
