// An exported atlas says what was written into it, and what it says of a slot between its grid points is safe.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "allocations.hpp"
#include "cli/process.hpp"
#include "model/refusals.hpp"
#include "oracle/follower.hpp"
#include "random_atlas.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"

namespace snug {
namespace {

using namespace test;
using model::refusal;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

void expect_same(const WrittenAtlas& written, const Atlas& read) {
    const AtlasPlan& plan = written.plan;
    EXPECT_EQ(read.made_by(), "1.2.3-test");
    EXPECT_EQ(read.options().strategy, plan.options.strategy);
    EXPECT_EQ(read.options().max_changes, plan.options.max_changes);
    EXPECT_EQ(read.options().min_range, plan.options.min_range);
    EXPECT_EQ(read.options().resolution, plan.options.resolution);
    EXPECT_EQ(read.options().driving.clearance, plan.options.driving.clearance);
    EXPECT_EQ(read.options().driving.enter, plan.options.driving.enter);
    ASSERT_EQ(read.cars(), plan.cars.size());
    ASSERT_EQ(read.widths(), plan.widths.size());
    ASSERT_EQ(read.lengths(), plan.lengths.size());
    for (std::size_t w = 0; w < plan.widths.size(); ++w) EXPECT_EQ(read.width(w), plan.widths[w]);
    for (std::size_t l = 0; l < plan.lengths.size(); ++l) EXPECT_EQ(read.length(l), plan.lengths[l]);
    for (std::size_t c = 0; c < plan.cars.size(); ++c) {
        const Car& car = plan.cars[c];
        EXPECT_EQ(read.car_name(c), car.name());
        EXPECT_EQ(read.find_car(car.name()), c);
        EXPECT_EQ(read.find_car(car.name() + ' '), std::nullopt);
        const Car stored = read.car(c);
        EXPECT_EQ(stored, car);
        for (std::size_t w = 0; w < plan.widths.size(); ++w) {
            for (std::size_t l = 0; l < plan.lengths.size(); ++l) {
                const std::optional<AtlasCell> cell = read.cell(c, w, l);
                ASSERT_TRUE(cell) << "car " << c << " width " << w << " length " << l;
                ASSERT_EQ(told(stored_in(*cell)), told(written.answer(c, w, l)));
                ASSERT_EQ(cell->width(), plan.widths[w]);
                ASSERT_EQ(cell->length(), plan.lengths[l]);
            }
        }
    }
    EXPECT_EQ(read.find_car(""), std::nullopt);
    EXPECT_EQ(read.find_car("~"), std::nullopt);
}

TEST(AtlasReader, SaysWhatWasWritten) {
    const int cases = sample(150, 10000);
    for (int i = 0; i < cases; ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        Random random(static_cast<std::uint64_t>(i));
        const WrittenAtlas written = random_atlas(random);
        expect_same(written, Atlas(as_bytes(written.bytes)));
        EXPECT_EQ(test::written(written.plan, written.answers), written.bytes);
        if (HasFailure()) return;
    }
}

TEST(AtlasReader, MapsAFileAndMoves) {
    Random random(5);
    const WrittenAtlas written = random_atlas(random);
    const Folder folder;
    Atlas first(folder.with("fleet.atlas", written.bytes));
    Atlas second(std::move(first));
    expect_same(written, second);
    Random other_random(6);
    const WrittenAtlas other = random_atlas(other_random);
    second = Atlas(folder.with("other.atlas", other.bytes));
    expect_same(other, second);
}

/// The header's words, by looking at every stored slot.
std::pair<AtlasVerdict, std::pair<double, double>> plain_look_up(const WrittenAtlas& atlas, std::size_t car,
                                                                 double length, double width, int& lower_bound) {
    const AtlasPlan& plan = atlas.plan;
    const bool fewest = plan.options.strategy == Strategy::fewest;
    const CellAnswer* below = nullptr;
    const CellAnswer* above = nullptr;
    std::pair<double, double> at_below = {-infinity, -infinity};
    std::pair<double, double> at_above = {infinity, infinity};
    lower_bound = 0;
    if (car >= plan.cars.size()) return {AtlasVerdict::no_such_car, {0.0, 0.0}};
    for (std::size_t w = 0; w < plan.widths.size(); ++w) {
        for (std::size_t l = 0; l < plan.lengths.size(); ++l) {
            const std::pair at = {plan.lengths[l], plan.widths[w]};
            const auto no_smaller = [](auto a, auto b) { return a.first >= b.first && a.second >= b.second; };
            const std::pair asked = {length, width};
            if (no_smaller(asked, at) && no_smaller(at, at_below)) {
                at_below = at;
                below = &atlas.answer(car, w, l);
            }
            if (no_smaller(at, asked) && no_smaller(at_above, at)) {
                at_above = at;
                above = &atlas.answer(car, w, l);
            }
        }
    }
    if (!below || !above) return {AtlasVerdict::outside_grid, {0.0, 0.0}};
    if (fewest) lower_bound = above->lower_bound;
    AtlasVerdict verdict = AtlasVerdict::undecided;
    if (!fewest && below == above && !below->direction_changes) verdict = AtlasVerdict::cannot_park;
    if (fewest && above->lower_bound > plan.options.max_changes.value_or(200)) verdict = AtlasVerdict::cannot_park;
    if (!below->moves.empty()) verdict = AtlasVerdict::parks;
    return {verdict, at_below};
}

double random_query(Random& random, const std::vector<double>& axis) {
    const double stored = axis[static_cast<std::size_t>(random.below(static_cast<int>(axis.size())))];
    switch (random.below(12)) {
        case 0: return std::nextafter(stored, infinity);
        case 1: return std::nextafter(stored, 0.0);
        case 2: return random.between(-10.0, 10.0);
        case 3: return random.chance(0.2) ? no_number : random.chance(0.5) ? infinity : -infinity;
        case 4:
        case 5:
        case 6:
        case 7: return stored;
        default: return random.between(axis.front(), axis.back());
    }
}

TEST(AtlasReader, LooksUpWhatASearchOfAllSlotsFinds) {
    std::set<AtlasVerdict> seen;
    const int cases = sample(60, 3000);
    for (int i = 0; i < cases; ++i) {
        Random random(1000 + static_cast<std::uint64_t>(i));
        const WrittenAtlas written = random_atlas(random);
        const Atlas atlas(as_bytes(written.bytes));
        for (int k = 0; k < 300; ++k) {
            const auto car = static_cast<std::size_t>(random.below(static_cast<int>(atlas.cars()) + 1));
            const double length = random_query(random, written.plan.lengths);
            const double width = random_query(random, written.plan.widths);
            SCOPED_TRACE("case " + std::to_string(i) + " car " + std::to_string(car) + " length " +
                         std::to_string(length) + " width " + std::to_string(width));
            const AtlasAnswer answer = atlas.look_up(car, length, width);
            int lower_bound = 0;
            const auto [verdict, cell] = plain_look_up(written, car, length, width, lower_bound);
            seen.insert(verdict);
            ASSERT_EQ(answer.verdict, verdict);
            ASSERT_EQ(answer.cell.length(), cell.first);
            ASSERT_EQ(answer.cell.width(), cell.second);
            ASSERT_EQ(answer.lower_bound, lower_bound);
            if (verdict != AtlasVerdict::parks) continue;
            ASSERT_LE(answer.cell.length(), length);
            ASSERT_LE(answer.cell.width(), width);
            ASSERT_GT(answer.cell.moves(), 0U);
            ASSERT_TRUE(answer.cell.direction_changes());
        }
    }
    EXPECT_EQ(seen.size(), 5U) << "all but damaged";
}

/// What entry() finds, as a cell.
CellAnswer solved(const Car& car, double length, double width, const AtlasOptions& options) {
    const Answer found = entry(car, Slot({.length = length, .width = width}),
                               {.max_changes = options.max_changes, .driving = options.driving, .prove = false});
    CellAnswer answer;
    answer.direction_changes = found.direction_changes;
    answer.ranges = found.ranges;
    if (!found.maneuver) return answer;
    answer.entry = found.maneuver->entry();
    for (const Move& move : found.maneuver->moves)
        answer.moves.push_back({move.direction, move.steering_angle, move.length, move.contact});
    return answer;
}

WrittenAtlas solved_atlas(Enter enter) {
    WrittenAtlas atlas;
    const CarDimensions zoe = find_car("renault-zoe")->dimensions();
    const Outline round = Outline::rounded(zoe.front, zoe.rear, zoe.width / 2.0, 0.4, 0.2);
    atlas.plan.cars = {*find_car("mid-size"), *find_car("renault-zoe"),
                       Car(round, zoe.wheelbase, zoe.max_steer, "rounded")};
    atlas.plan.options.driving.enter = enter;
    for (int i = 0; i < 6; ++i) atlas.plan.widths.push_back(1.9 + 0.15 * i + (enter == Enter::forward ? 1.5 : 0.0));
    for (int i = 0; i < 8; ++i) atlas.plan.lengths.push_back(4.5 + 0.2 * i + (enter == Enter::forward ? 1.5 : 0.0));
    for (const Car& car : atlas.plan.cars)
        for (const double width : atlas.plan.widths)
            for (const double length : atlas.plan.lengths)
                atlas.answers.push_back(solved(car, length, width, atlas.plan.options));
    atlas.bytes = written(atlas.plan, atlas.answers);
    return atlas;
}

Slot random_slot(Random& random, double length, double width) {
    return Slot({.length = length,
                 .width = width,
                 .side = random.chance(0.5) ? Side::left : Side::right,
                 .corner = {random.between(-50.0, 50.0), random.between(-50.0, 50.0)},
                 .heading = random.between(-7.0, 7.0)});
}

TEST(AtlasReader, AStoredManeuverIsTheSolversInAnySlotOfItsSize) {
    for (const Enter enter : {Enter::backward, Enter::forward}) {
        const WrittenAtlas written = solved_atlas(enter);
        const Atlas atlas(as_bytes(written.bytes));
        Random random(17);
        int parked = 0;
        for (int i = 0; i < sample(100, 2000); ++i) {
            const auto c = static_cast<std::size_t>(random.below(3));
            const AtlasCell cell =
                atlas.cell(c, static_cast<std::size_t>(random.below(6)), static_cast<std::size_t>(random.below(8)))
                    .value();
            const Slot slot = random_slot(random, cell.length(), cell.width());
            const Car car = atlas.car(c);
            const Maneuver stored = maneuver(cell, car, slot);
            const Answer fresh = entry(car, slot, {.driving = {.enter = enter}, .prove = false});
            ASSERT_EQ(fresh.direction_changes, cell.direction_changes());
            ASSERT_EQ(fresh.maneuver ? fresh.maneuver->moves.size() : 0, stored.moves.size());
            if (!fresh.maneuver) continue;
            ++parked;
            for (std::size_t k = 0; k < stored.moves.size(); ++k) {
                SCOPED_TRACE("case " + std::to_string(i) + " move " + std::to_string(k));
                const Move& a = stored.moves[k];
                const Move& b = fresh.maneuver->moves[k];
                ASSERT_EQ(a.direction, b.direction);
                ASSERT_EQ(a.steering_angle, b.steering_angle);
                ASSERT_EQ(a.length, b.length);
                for (const auto& [one, other] : {std::pair{a.start, b.start}, std::pair{a.end, b.end}}) {
                    ASSERT_NEAR(one.x, other.x, 1e-11);
                    ASSERT_NEAR(one.y, other.y, 1e-11);
                    ASSERT_NEAR(one.heading, other.heading, 1e-11);
                }
                ASSERT_EQ(a.contact.has_value(), b.contact.has_value());
                if (!a.contact) continue;
                ASSERT_EQ(*a.contact, *b.contact);
            }
        }
        EXPECT_GT(parked, 5);
    }
}

TEST(AtlasReader, AStoredManeuverIsFreeOfContactInTheRealSlot) {
    for (const Enter enter : {Enter::backward, Enter::forward}) {
        const WrittenAtlas written = solved_atlas(enter);
        const Atlas atlas(as_bytes(written.bytes));
        Random random(18);
        int parked = 0;
        for (int i = 0; i < sample(200, 10000); ++i) {
            SCOPED_TRACE("case " + std::to_string(i));
            const auto c = static_cast<std::size_t>(random.below(2));
            const double length = random.between(atlas.length(0), atlas.length(atlas.lengths() - 1));
            const double width = random.between(atlas.width(0), atlas.width(atlas.widths() - 1));
            const AtlasAnswer answer = atlas.look_up(c, length, width);
            if (answer.verdict != AtlasVerdict::parks) continue;
            ++parked;
            const Slot slot = random_slot(random, length, width);
            const Maneuver driven = maneuver(answer.cell, atlas.car(c), slot);
            oracle::Case asked;
            asked.car = driven.car.dimensions();
            asked.slot = slot.dimensions();
            asked.driving.enter = enter;
            for (const std::string& fault : oracle::faults(asked, driven, *answer.cell.direction_changes()))
                ADD_FAILURE() << fault;
        }
        EXPECT_GT(parked, 5);
    }
}

TEST(AtlasReader, ACellWithoutManeuverHasNone) {
    const AtlasPlan plan = {{*find_car("renault-zoe")}, {2.0}, {4.0}, {}};
    const std::string bytes = written(plan, {CellAnswer{}});
    const Atlas atlas(as_bytes(bytes));
    const AtlasAnswer answer = atlas.look_up(0, 4.0, 2.0);
    EXPECT_EQ(answer.verdict, AtlasVerdict::cannot_park);
    EXPECT_TRUE(maneuver(answer.cell, plan.cars[0], Slot({.length = 4.0, .width = 2.0})).moves.empty());
    EXPECT_TRUE(maneuver(AtlasCell(), plan.cars[0], Slot({.length = 4.0, .width = 2.0})).moves.empty());
}

TEST(AtlasReader, LookUpsAllocateNothing) {
    static_assert(noexcept(std::declval<const Atlas&>().look_up(0, 0.0, 0.0)));
    static_assert(noexcept(std::declval<const Atlas&>().cell(0, 0, 0)));
    static_assert(noexcept(std::declval<const Atlas&>().find_car("")));
    static_assert(noexcept(std::declval<const AtlasCell&>().move(0)));
    Random random(3);
    const WrittenAtlas written = random_atlas(random);
    const Atlas atlas(as_bytes(written.bytes));
    const std::size_t before = allocations();
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double length = random.between(atlas.length(0), atlas.length(atlas.lengths() - 1));
        const double width = random.between(atlas.width(0), atlas.width(atlas.widths() - 1));
        const std::size_t car = *atlas.find_car(atlas.car_name(static_cast<std::size_t>(i) % atlas.cars()));
        const AtlasAnswer answer = atlas.look_up(car, length, width);
        for (std::size_t k = 0; k < answer.cell.ranges(); ++k) sum += answer.cell.range(k).min;
        for (std::size_t k = 0; k < answer.cell.moves(); ++k) sum += answer.cell.move(k).length;
    }
    EXPECT_EQ(allocations(), before);
    EXPECT_GT(sum, 0.0);
}

TEST(AtlasReader, ManyThreadsLookUpInOneFreshAtlas) {
    Random random(4);
    const WrittenAtlas written = random_atlas(random, 8, 20, 60);
    for (int round = 0; round < sample(20, 500); ++round) {
        const Atlas atlas(as_bytes(written.bytes));
        std::atomic<int> wrong = 0;
        const auto read_all = [&](std::size_t thread) {
            const std::size_t cells = written.answers.size();
            for (std::size_t i = 0; i < cells; ++i) {
                const std::size_t at = (i + thread * cells / 4) % cells;
                const std::size_t l = at % atlas.lengths();
                const std::size_t w = at / atlas.lengths() % atlas.widths();
                const std::size_t c = at / atlas.lengths() / atlas.widths();
                const AtlasAnswer answer = atlas.look_up(c, atlas.length(l), atlas.width(w));
                if (answer.cell.direction_changes() != written.answers[at].direction_changes) ++wrong;
            }
        };
        std::vector<std::thread> threads;
        for (std::size_t thread = 0; thread < 4; ++thread) threads.emplace_back(read_all, thread);
        for (std::thread& thread : threads) thread.join();
        ASSERT_EQ(wrong, 0);
    }
}

TEST(AtlasWriter, RefusesPlansThatAreNone) {
    const Car mid_size = *find_car("mid-size");
    const Car zoe = *find_car("renault-zoe");
    const AtlasPlan good = {{mid_size, zoe}, {2.0, 2.1}, {5.0, 5.1}, {}};
    const auto said = [&](const AtlasPlan& plan, std::string_view made_by = "1") {
        return refusal([&] { AtlasWriter(plan, made_by, [](std::string_view) {}); });
    };
    const auto with = [&](auto change) {
        AtlasPlan plan = good;
        change(plan);
        return said(plan);
    };
    EXPECT_EQ(said(good), "");
    EXPECT_EQ(with([](auto& plan) { plan.cars.clear(); }), "the atlas has no cars, but must have at least one");
    EXPECT_EQ(with([](auto& plan) { plan.widths.clear(); }), "the atlas has no widths, but must have at least one");
    EXPECT_EQ(with([](auto& plan) { plan.lengths.clear(); }), "the atlas has no lengths, but must have at least one");
    EXPECT_EQ(with([](auto& plan) { std::swap(plan.cars[0], plan.cars[1]); }),
              "the atlas has the car \"mid-size\" after \"renault-zoe\", but cars must be in alphabetical order");
    EXPECT_EQ(with([](auto& plan) { plan.cars[1] = plan.cars[0]; }),
              "the atlas has two cars named \"mid-size\", but each must have a name of its own");
    EXPECT_EQ(with([](auto& plan) { plan.cars[1] = Car(plan.cars[1].dimensions()); }),
              "car [1] has no name, but must be found by one");
    EXPECT_EQ(with([](auto& plan) { plan.widths[1] = 1.9; }),
              "the atlas has the width 1.9 m after 2 m, but widths must rise");
    EXPECT_EQ(with([](auto& plan) { plan.lengths[1] = plan.lengths[0]; }),
              "the atlas has the length 5 m after 5 m, but lengths must rise");
    EXPECT_EQ(with([](auto& plan) { plan.lengths[1] = no_number; }),
              "slot length is nan m, but must lie between 1e-06 and 1000000 m");
    EXPECT_NE(with([](auto& plan) { plan.options.max_changes = -1; }), "");
    EXPECT_NE(with([](auto& plan) { plan.options.driving.clearance = no_number; }), "");
    EXPECT_NE(said(good, std::string(33, '1')).find("at most 32"), std::string::npos);
    AtlasPlan large = good;
    large.widths.clear();
    for (int i = 1; i <= 1 << 20; ++i) large.widths.push_back(0.5 * i);
    large.lengths = large.widths;
    EXPECT_NE(said(large).find("2^40 cells"), std::string::npos);
}

TEST(AtlasWriter, WantsEveryCellOnce) {
    const AtlasPlan plan = {{*find_car("renault-zoe")}, {2.0}, {5.0, 5.1}, {}};
    AtlasWriter writer(plan, "1", [](std::string_view) {});
    writer.add({});
    EXPECT_THROW(writer.finish(), std::logic_error);
    CellAnswer countless;
    countless.moves.emplace_back();
    EXPECT_THROW(writer.add(countless), std::logic_error);
    writer.add({});
    EXPECT_THROW(writer.add({}), std::logic_error);
    writer.finish();
}

}  // namespace
}  // namespace snug
