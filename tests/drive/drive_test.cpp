// The Assistant and the car that errs: nothing it is told to drive touches, and its runs are what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "atlas/allocations.hpp"
#include "drive/run.hpp"
#include "park/judge.hpp"
#include "park/random_places.hpp"
#include "sample.hpp"
#include "snug/drive.hpp"
#include "snug/error.hpp"
#include "snug/park_map.hpp"
#include "snug/trajectory.hpp"

namespace park_test {
namespace {

using snug::Assistant;
using snug::AssistantOptions;
using snug::Direction;
using snug::DriveAnswer;
using snug::DriveOptions;
using snug::DriveRun;
using snug::Instruction;
using snug::Move;

Car zoe() { return *snug::find_car("renault-zoe"); }

Street usual_street() {
    Street street;
    street.length = 5.2;
    street.width = 2.0;
    street.road = 3.5;
    return street;
}

const Pose usual_start = {2.0, 1.75, 0.0};

DriveOptions without_errors() {
    DriveOptions options;
    options.errors = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0, 0.0, 0.0};
    options.margin = 0.03;
    options.runs = 3;
    return options;
}

/// Drives each of the moves in steps and says how deep the car overlaps something at worst.
double deepest(const Car& car, const Place& place, const Pose& start, const std::vector<Move>& moves,
               double step = 0.02) {
    double worst = depth_in_place(car, place, start);
    Pose at = start;
    for (const Move& move : moves) {
        const double turn =
            static_cast<int>(move.direction) * std::tan(move.steering_angle) / car.wheelbase();  // for each metre
        const int steps = std::max(1, static_cast<int>(std::ceil(move.length / step)));
        for (int i = 0; i < steps; ++i) {
            const double ds = move.length / steps;
            const double middle = at.heading + turn * ds / 2.0;
            const double chord = turn == 0.0 ? ds : 2.0 / turn * std::sin(turn * ds / 2.0);
            at.x += static_cast<int>(move.direction) * chord * std::cos(middle);
            at.y += static_cast<int>(move.direction) * chord * std::sin(middle);
            at.heading += turn * ds;
            worst = std::max(worst, depth_in_place(car, place, at));
        }
    }
    return worst;
}

/// In a soak ten million poses and more: 20,000 in each of the random places that have room for the margin. SNUG_FIRST=I begins with
/// the place I and SNUG_CASES=N ends after N, so that a soak can be had in parts.
TEST(Assistant, TellsNothingThatTouchesFromAnyPose) {
    int driven = 0, parked = 0, escaped = 0, overlapped = 0, stuck = 0, places = 0;
    std::size_t most_looked = 0;
    double slowest = 0.0, sum = 0.0;
    std::string slowest_at, most_at;
    const std::uint64_t first = snug::test::number("SNUG_FIRST", 0);
    const std::uint64_t last =
        first + snug::test::number("SNUG_CASES", std::uint64_t(std::max(4, snug::test::sample(6, 700))));
    for (std::uint64_t i = first; i < last; ++i) {
        SCOPED_TRACE(i);
        const Case one = random_case(i);
        Random random(i + 77);
        AssistantOptions options;
        options.margin = random.between(0.0, 0.1);
        options.heading = one.start.heading;
        std::optional<Assistant> assistant;
        try {
            assistant.emplace(one.car, one.place, options);
        } catch (const snug::Error&) {
            continue;  // too small for the margin, or too large for a map: told in a sentence
        }
        ++places;
        snug::AssistantMemory memory(*assistant);
        const auto& region = one.place.region();
        double x_min = region[0].x, x_max = x_min, y_min = region[0].y, y_max = y_min;
        for (const Point& p : region) {
            x_min = std::min(x_min, p.x), x_max = std::max(x_max, p.x);
            y_min = std::min(y_min, p.y), y_max = std::max(y_max, p.y);
        }
        for (int k = 0; k < std::max(100, snug::test::sample(300, 20000)); ++k) {
            // Any pose at all, or one of a car that is on its way.
            const double beyond = random.chance(0.5) ? 1.0 : 0.0, turned = beyond > 0.0 ? 3.5 : 1.4;
            const Pose pose = {random.between(x_min - beyond, x_max + beyond),
                               random.between(y_min - beyond, y_max + beyond),
                               one.start.heading + random.between(-turned, turned)};
            const std::optional<Direction> driven_last =
                random.chance(0.5) ? std::nullopt
                                   : std::optional(random.chance(0.5) ? Direction::forward : Direction::backward);
            const Instruction* answer = nullptr;
            const auto timed = [&] {
                const auto begin = std::chrono::steady_clock::now();
                answer = &assistant->next(pose, driven_last, memory);
                return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            };
            double took = timed();
            // Slow by chance, for the machine had other work?
            for (int again = 0; again < 9 && took > slowest; ++again) took = std::min(took, timed());
            const Instruction& told = *answer;
            sum += took;
            const auto where = [&] {
                return "\nplace " + std::to_string(i) + " at " + std::to_string(pose.x) + ", " +
                       std::to_string(pose.y) + ", " + std::to_string(pose.heading);
            };
            if (took > slowest) slowest = took, slowest_at = where();
            if (memory.poses_looked_at() > most_looked) most_looked = memory.poses_looked_at(), most_at = where();
            switch (told.what) {
                case Instruction::stuck: ++stuck; continue;
                case Instruction::parked:
                    ++parked;
                    EXPECT_LE(short_of_parked(one.car, one.place, pose), 1e-7) << where();
                    continue;
                case Instruction::escape: ++escaped; break;
                case Instruction::move: ++driven; break;
                case Instruction::overlap: {
                    ++overlapped;
                    const double deep = depth_in_place(one.car, one.place, pose);
                    EXPECT_GT(deep, 0.0) << where();
                    EXPECT_LE(deepest(one.car, one.place, pose, told.moves), deep + 1e-6) << where();
                    EXPECT_LT(depth_in_place(one.car, one.place, told.moves.back().end), deep) << where();
                    continue;
                }
            }
            ASSERT_FALSE(told.moves.empty()) << where();
            EXPECT_EQ(told.moves.front().start, pose) << where();
            for (const Move& move : told.moves) {
                EXPECT_EQ(move.direction, told.moves.front().direction) << where();
                EXPECT_LE(std::abs(move.steering_angle), one.car.max_steer() * (1.0 + 1e-12)) << where();
            }
            EXPECT_LE(deepest(one.car, one.place, pose, told.moves), 1e-7) << where();
        }
    }
    std::cout << driven + parked + escaped + overlapped + stuck << " poses in " << places << " places: " << driven
              << " drive, " << parked << " parked, " << escaped << " escape, " << overlapped << " overlap, " << stuck
              << " stuck; next() took " << 1e6 * sum / (driven + parked + escaped + overlapped + stuck)
              << " us on average, at most " << 1e6 * slowest << " us at" << slowest_at << "\nand looked at most at "
              << most_looked << " poses at" << most_at << "\n";
    EXPECT_GT(driven, 0);
    EXPECT_GT(overlapped, 0);
    EXPECT_GT(stuck, 0);
    EXPECT_GE(parked + escaped, 0);
}

/// A place with posts and slats 4 mm thick strewn about where the car starts.
Place with_thin_things(const Place& place, const Pose& about, Random& random) {
    snug::PlaceDescription scene{place.obstacles(), place.parked(), place.region()};
    for (int i = 0; i < 6; ++i) {
        const double x = about.x + random.between(-5.0, 5.0), y = about.y + random.between(-5.0, 5.0);
        const double turned = random.between(0.0, 3.1), c = std::cos(turned), s = std::sin(turned);
        const double length = random.chance(0.5) ? 0.003 : random.between(0.1, 1.5), width = 0.002;
        std::vector<Point> corners;
        for (const Point& p : {Point{-length, -width}, {length, -width}, {length, width}, {-length, width}})
            corners.push_back({x + p.x * c - p.y * s, y + p.x * s + p.y * c});
        scene.obstacles.push_back({corners, random.chance(0.2), "slat", {}});
    }
    return Place(scene);
}

/// What an arc passes between the poses that are looked at: among thin things, from poses that nearly touch, hardly a margin kept,
/// and followed in steps of less than a millimetre.
TEST(Assistant, PassesNothingBetweenThePosesItLooksAt) {
    int moved = 0, overlapped = 0;
    const int places = snug::test::sample(6, 100), poses = snug::test::sample(500, 2000);
    for (int i = 0; i < places; ++i) {
        const Case one = random_case(3'000'000 + std::uint64_t(i));
        Random random(7'000'000 + std::uint64_t(i));
        const Place place = with_thin_things(one.place, one.start, random);
        AssistantOptions options;
        options.margin = random.chance(0.5) ? 0.0 : random.between(0.0, 0.02);
        options.heading = one.start.heading;
        std::optional<Assistant> assistant;
        try {
            assistant.emplace(one.car, place, options);
        } catch (const snug::Error&) {
            continue;
        }
        snug::AssistantMemory memory(*assistant);
        for (int k = 0; k < poses; ++k) {
            Pose pose = {one.start.x + random.between(-4.0, 4.0), one.start.y + random.between(-4.0, 4.0),
                         one.start.heading + random.between(-1.3, 1.3)};
            for (int t = 0; t < 12 && std::abs(depth_in_place(one.car, place, pose)) > 0.03; ++t)
                pose.x += random.between(-0.4, 0.4), pose.y += random.between(-0.4, 0.4);
            const Instruction& told = assistant->next(pose, std::nullopt, memory);
            if (told.moves.empty()) continue;
            const bool out_of_something = told.what == Instruction::overlap;
            ++(out_of_something ? overlapped : moved);
            const double allowed = out_of_something ? depth_in_place(one.car, place, pose) + 1e-6 : 1e-7;
            EXPECT_LE(deepest(one.car, place, pose, told.moves, 0.0007), allowed)
                << "place " << i << " at " << pose.x << ", " << pose.y << ", " << pose.heading;
        }
    }
    std::cout << moved << " moves, " << overlapped << " ways out\n";
    EXPECT_GT(moved, 0);
    EXPECT_GT(overlapped, 0);
}

TEST(Assistant, AllocatesNothingInMemoryMadeBefore) {
    for (const double angle : {0.0, 1.5707963267948966}) {
        Street street = usual_street();
        street.angle = angle;
        street.width = angle == 0.0 ? 2.0 : 2.5;
        street.road = angle == 0.0 ? 3.5 : 6.0;
        AssistantOptions options;
        options.margin = 0.03;
        const Assistant assistant(zoe(), street, options);
        snug::AssistantMemory memory(assistant);
        Random random(3);
        std::size_t allocated = 0, most_looked = 0;
        double slowest = 0.0, sum = 0.0;
        int answers[5] = {};
        const int poses = snug::test::sample(2000, 100000);
        for (int i = 0; i < poses; ++i) {
            const Pose pose = {random.between(-9.0, 9.0), random.between(-2.5, 5.0), random.between(-0.6, 0.6 + angle)};
            const std::optional<Direction> driven =
                random.chance(0.3) ? std::nullopt
                                   : std::optional(random.chance(0.5) ? Direction::forward : Direction::backward);
            const auto timed = [&] {
                const auto begin = std::chrono::steady_clock::now();
                (void)assistant.next(pose, driven, memory);
                return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            };
            const std::size_t before = snug::test::allocations();
            const Instruction& told = assistant.next(pose, driven, memory);
            allocated += snug::test::allocations() - before;
            double took = timed();
            for (int again = 0; again < 9 && took > slowest; ++again) took = std::min(took, timed());
            most_looked = std::max(most_looked, memory.poses_looked_at());
            slowest = std::max(slowest, took);
            sum += took;
            ++answers[told.what];
            if (i % 50 == 0) {
                EXPECT_EQ(told, assistant.next(pose, driven)) << i;
            }
        }
        EXPECT_EQ(allocated, 0U);
        EXPECT_GT(answers[Instruction::move], 0);
        EXPECT_GT(answers[Instruction::overlap], 0);
        std::cout << "next(): " << 1e3 * sum / poses << " ms on average, at most " << 1e3 * slowest
                  << " ms; it looked at " << most_looked << " poses at most\n";
    }
}

TEST(Assistant, HasNoAnswerToPosesThatAreNoNumbers) {
    const Assistant assistant(zoe(), usual_street());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf, 1e300}) {
        EXPECT_EQ(assistant.next({bad, 0.0, 0.0}).what, Instruction::stuck);
        EXPECT_EQ(assistant.next({0.0, bad, 0.0}).what, Instruction::stuck);
        EXPECT_EQ(assistant.next({0.0, 0.0, bad}).what, Instruction::stuck);
    }
}

TEST(Assistant, LeadsOutOfWhatItOverlapsByMeasurement) {
    const Assistant assistant(zoe(), usual_street());
    // Its front right corner is 2 cm in the front neighbour.
    const Pose deep = {2.0, 3.427 * std::sin(0.15) + 1.771 / 2.0 * std::cos(0.15) - 0.02, -0.15};
    const Instruction told = assistant.next(deep);
    ASSERT_EQ(told.what, Instruction::overlap);
    EXPECT_LE(depth_in_place(zoe(), street_place(usual_street()), told.moves.back().end), 0.0);
}

TEST(Assistant, RefusesTheMapOfAnotherCarPlaceOrMargin) {
    const Place place = street_place(usual_street());
    AssistantOptions options;
    options.heading = 0.0;
    const Assistant made(zoe(), place, options);
    const Assistant same(zoe(), place, made.map(), options);
    EXPECT_EQ(same.next(usual_start), made.next(usual_start));
    const auto refused = [&](const Car& car, const Place& in, const AssistantOptions& with) {
        try {
            const Assistant other(car, in, made.map(), with);
        } catch (const snug::Error& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    Street wider = usual_street();
    wider.width = 2.1;
    AssistantOptions more = options;
    more.margin = 0.06;
    EXPECT_NE(refused(*snug::find_car("opel-corsa"), place, options).find("of another car"), std::string::npos);
    EXPECT_NE(refused(zoe(), street_place(wider), options).find("of another place"), std::string::npos);
    EXPECT_NE(refused(zoe(), place, more).find("the map is "), std::string::npos);
}

TEST(Assistant, LeadsAwayFromWhatIsNearerThanTheMargin) {
    AssistantOptions options;
    options.margin = 0.1;
    const Assistant assistant(zoe(), usual_street(), options);
    // 3 cm from the far side of the road.
    const Pose near = {2.0, 3.5 - 1.771 / 2.0 - 0.03, 0.0};
    Pose at = near;
    int arcs = 0;
    while (assistant.map().at(at).where != snug::MapBounds::free) {
        ASSERT_LT(++arcs, 10);
        const Instruction told = assistant.next(at);
        ASSERT_TRUE(told.what == Instruction::escape || (arcs > 1 && told.what == Instruction::move));
        EXPECT_LE(deepest(zoe(), street_place(usual_street()), at, told.moves), 0.0);
        at = told.moves.back().end;
    }
    EXPECT_GT(arcs, 0);
}

TEST(Drive, WithoutErrorsIsThePlan) {
    const Place place = street_place(usual_street());
    const DriveAnswer answer = drive_runs(zoe(), place, usual_start, without_errors());
    ASSERT_TRUE(answer.plannable);
    EXPECT_EQ(answer.parked(), 3);
    EXPECT_EQ(answer.contacts(), 0);
    for (const DriveRun& run : answer.runs) {
        EXPECT_LE(run.direction_changes, answer.planned_changes);
        EXPECT_GE(run.direction_changes, answer.lower_bound);
        // It turns back from what is nearer than a third of the margin.
        EXPECT_GE(run.smallest_distance, 0.03 / 3.0 - 1e-9);
    }
}

TEST(Drive, RunsAreWhatTheySay) {
    for (const snug::Steer steer : {snug::Steer::standing, snug::Steer::moving}) {
        SCOPED_TRACE(steer == snug::Steer::moving ? "moving" : "standing");
        const Street street = usual_street();
        const Place place = street_place(street);
        DriveOptions options;
        options.margin = 0.03;
        options.steer = steer;
        options.runs = snug::test::sample(20, 1000);
        const DriveAnswer answer = drive_runs(zoe(), place, usual_start, options);
        ASSERT_TRUE(answer.plannable);
        int parked = 0;
        for (std::size_t i = 0; i < answer.runs.size(); ++i) {
            SCOPED_TRACE(i);
            const DriveRun& run = answer.runs[i];
            parked += run.parked ? 1 : 0;
            ASSERT_FALSE(run.track.empty());
            double deepest_overlap = -1e300, nearest = 1e300;
            for (const Pose& pose : run.track) {
                deepest_overlap = std::max(deepest_overlap, depth_in_place(zoe(), place, pose));
                nearest = std::min(nearest, distance_in_place(zoe(), place, pose));
            }
            EXPECT_EQ(run.contact, deepest_overlap > 1e-12) << deepest_overlap;
            if (run.contact) {
                EXPECT_NEAR(run.smallest_distance, -deepest_overlap, 1e-9);
            } else {
                EXPECT_NEAR(run.smallest_distance, nearest, 1e-9);
            }
            if (run.parked) {
                EXPECT_LE(short_of_parked(zoe(), place, run.track.back()), 1e-9);
                EXPECT_FALSE(run.contact);
            }
            // Which way it rolled, from the track alone.
            int changes = 0;
            int last = 0;
            for (std::size_t k = 1; k < run.track.size(); ++k) {
                const Pose &a = run.track[k - 1], &b = run.track[k];
                const double along = (b.x - a.x) * std::cos(a.heading) + (b.y - a.y) * std::sin(a.heading);
                if (std::abs(along) < 0.048) continue;  // coming to rest, it slips a little either way
                const int way = along > 0.0 ? 1 : -1;
                changes += last != 0 && way != last ? 1 : 0;
                last = way;
            }
            EXPECT_LE(changes, run.direction_changes);
        }
        EXPECT_EQ(parked, answer.parked());
        EXPECT_GT(parked, options.runs * 9 / 10);
    }
}

/// Curvatures from the track alone: where the steering never turned at standstill they do not jump, beyond what the errors of a new move
/// and corrections make of them.
TEST(Drive, SteersOnlyWhileItRollsWhereItSaysSo) {
    Street street = usual_street();
    street.length = 5.0;
    street.width = 2.5;
    street.angle = 1.5707963267948966;
    street.road = 6.0;
    DriveOptions options = without_errors();
    options.steer = snug::Steer::moving;
    const DriveAnswer answer = drive_runs(zoe(), street, standard_start(street, zoe()), options);
    ASSERT_TRUE(answer.rolling);
    EXPECT_TRUE(answer.rolling->standing_steers().empty());
    EXPECT_EQ(answer.planned_changes, answer.rolling->direction_changes());
    EXPECT_GE(answer.planned_changes, *answer.standing_changes);
    EXPECT_EQ(answer.parked(), options.runs);
    for (const DriveRun& run : answer.runs) {
        EXPECT_EQ(run.standing_steers, 0);
        // The angle of the wheels in the middle of a step is no farther from that of the next than they turn in both at the least
        // speed that is planned with, 0.03 m/s.
        double last = 0.0, before = 0.0;
        for (std::size_t k = 1; k < run.track.size(); ++k) {
            const Pose &a = run.track[k - 1], &b = run.track[k];
            const double middle = (a.heading + b.heading) / 2.0;
            const double along = (b.x - a.x) * std::cos(middle) + (b.y - a.y) * std::sin(middle);
            if (std::abs(along) < 1e-6) continue;
            const double angle = std::atan(zoe().wheelbase() * (b.heading - a.heading) / along);
            EXPECT_LE(std::abs(angle - last),
                      options.limits.steering_rate * (std::abs(along) + before) / 2.0 / 0.03 + 1e-6)
                << k;
            last = angle;
            before = std::abs(along);
        }
    }
    DriveOptions standing = options;
    standing.steer = snug::Steer::standing;
    EXPECT_GT(drive_runs(zoe(), street, standard_start(street, zoe()), standing).runs[0].standing_steers, 0);
}

/// A margin that is found does, and what is told of it are the runs it has, whatever it was chosen by.
TEST(Drive, MarginsFoundAreThoseOfAllRuns) {
    DriveOptions options;
    options.runs = 120;
    options.rate = 0.99;
    const Street street = usual_street();
    const DriveAnswer found = drive_runs(zoe(), street, usual_start, options);
    ASSERT_EQ(found.runs.size(), 120U);
    EXPECT_GE(found.parked(), 119);
    options.margin = found.margin;
    EXPECT_EQ(found.runs, drive_runs(zoe(), street, usual_start, options).runs);
}

TEST(Drive, IsTheSameForOneSeedOnAnyNumberOfCores) {
    const Place place = street_place(usual_street());
    DriveOptions options;
    options.margin = 0.04;
    options.runs = 8;
    options.threads = 1;
    const DriveAnswer one = drive_runs(zoe(), place, usual_start, options);
    options.threads = 3;
    EXPECT_EQ(one.runs, drive_runs(zoe(), place, usual_start, options).runs);
    options.seed = 2;
    EXPECT_NE(one.runs, drive_runs(zoe(), place, usual_start, options).runs);
}

TEST(Drive, LookingAgainParksMoreOftenThanNot) {
    const Place place = street_place(usual_street());
    DriveOptions options;
    options.margin = 0.03;
    options.runs = snug::test::sample(40, 1000);
    const DriveAnswer looking = drive_runs(zoe(), place, usual_start, options);
    options.blind = true;
    const DriveAnswer blind = drive_runs(zoe(), place, usual_start, options);
    EXPECT_GT(looking.parked(), 2 * blind.parked());
}

TEST(Drive, ASlotSeenWithErrorsIsParkedInAllTheSame) {
    DriveOptions options;
    options.errors.slot_place = 0.03;
    options.errors.slot_size = 0.02;
    options.margin = 0.03;
    options.runs = snug::test::sample(16, 200);
    options.threads = 1;
    const DriveAnswer one = drive_runs(zoe(), usual_street(), usual_start, options);
    EXPECT_GT(one.parked(), options.runs * 8 / 10);
    options.threads = 3;
    EXPECT_EQ(one.runs, drive_runs(zoe(), usual_street(), usual_start, options).runs);
    options.errors.slot_place = options.errors.slot_size = 0.0;
    EXPECT_NE(one.runs, drive_runs(zoe(), usual_street(), usual_start, options).runs);
    EXPECT_EQ(drive_runs(zoe(), street_place(usual_street()), usual_start, options).runs,
              drive_runs(zoe(), usual_street(), usual_start, options).runs);
}

TEST(Drive, EachErrorAloneIsBorne) {
    for (const int which : {0, 1, 2, 3, 4, 5}) {
        SCOPED_TRACE(which);
        DriveOptions options = without_errors();
        const snug::CarErrors usual;
        if (which == 0) options.errors.sensing = usual.sensing;
        if (which == 1) options.errors.bias = {0.005, 0.005, 0.002};
        if (which == 2) options.errors.distance = usual.distance;
        if (which == 3) options.errors.steering = usual.steering;
        if (which == 4) options.errors.lag = 0.2;
        if (which == 5) options.errors.slot_place = options.errors.slot_size = 0.02;
        options.runs = snug::test::sample(10, 200);
        const DriveAnswer answer = drive_runs(zoe(), usual_street(), usual_start, options);
        EXPECT_GE(answer.parked(), options.runs * 8 / 10);
    }
}

TEST(Drive, FindsAMarginThatDoes) {
    Street street = usual_street();
    street.length = 5.0;
    street.width = 2.5;
    street.angle = 1.5707963267948966;
    street.road = 6.0;
    DriveOptions options;
    options.runs = 30;
    options.rate = 0.9;
    const DriveAnswer answer = drive_runs(zoe(), street_place(street), standard_start(street, zoe()), options);
    ASSERT_TRUE(answer.plannable);
    EXPECT_GT(answer.margin, 0.0);
    EXPECT_EQ(answer.runs.size(), 30U);
    EXPECT_GE(answer.parked(), 27);
    EXPECT_EQ(answer.planned->entry(), standard_start(street, zoe()));
}

TEST(Drive, SaysWhereNoPlanHasSuchAMargin) {
    DriveOptions options;
    options.margin = 0.2;
    const DriveAnswer answer = drive_runs(zoe(), street_place(usual_street()), usual_start, options);
    EXPECT_FALSE(answer.plannable);
    EXPECT_TRUE(answer.runs.empty());
}

TEST(Drive, GivesUpWhenToldTo) {
    DriveOptions options = without_errors();
    options.threads = 1;
    options.runs = 100;
    options.progress = [](double, int runs) { return runs < 2; };
    const DriveAnswer answer = drive_runs(zoe(), street_place(usual_street()), usual_start, options);
    EXPECT_TRUE(answer.cancelled);
    EXPECT_EQ(answer.runs.size(), 2U);
}

TEST(Drive, RefusesWhatIsImpossible) {
    const Place place = street_place(usual_street());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [&](const DriveOptions& options, const Pose& start = usual_start) {
        EXPECT_THROW((void)drive_runs(zoe(), place, start, options), snug::Error);
    };
    for (const double bad : {-1.0, nan, 1e9}) {
        DriveOptions options = without_errors();
        options.errors.sensing.x = bad;
        refused(options);
        options = without_errors();
        options.errors.steering = bad;
        refused(options);
        options = without_errors();
        options.margin = bad;
        refused(options);
        options = without_errors();
        options.limits.speed = bad;
        refused(options);
        options = without_errors();
        options.rate = bad;
        refused(options);
        options = without_errors();
        options.errors.lag = bad;
        refused(options);
        options = without_errors();
        options.errors.slot_size = bad;
        EXPECT_THROW((void)drive_runs(zoe(), usual_street(), usual_start, options), snug::Error);
    }
    DriveOptions of_a_slot = without_errors();
    of_a_slot.errors.slot_place = 0.01;
    refused(of_a_slot);                             // there is none
    refused(without_errors(), {2.0, 0.0, 0.0});     // in the front neighbour
    refused(without_errors(), {500.0, 1.75, 0.0});  // far out of the region
}

}  // namespace
}  // namespace park_test
