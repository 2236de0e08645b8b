// Algorithm 1 as printed: the fast simulation agrees with the plain one, and the answers are those of the paper.
#include "snug/stepping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "baselines/stepping_entry.hpp"
#include "literal.hpp"
#include "sample.hpp"
#include "snug/error.hpp"

namespace snug {
namespace {

using test::literal_run;
using test::LiteralRun;
using test::sample;

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return low + (high - low) * unit_(engine_); }
    bool coin() { return unit_(engine_) < 0.5; }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

struct Case {
    Car car;
    Slot slot;
    Stepping steps;
    double clearance;
};

/// Cars from city car to van, slots from too tight to roomy, half of them tight.
Case any_case(Dice& dice) {
    const double wheelbase = dice.between(1.8, 3.6);
    const Car car({.width = dice.between(1.4, 2.1),
                   .front = wheelbase + dice.between(0.3, 1.2),
                   .rear = dice.between(0.3, 1.4),
                   .wheelbase = wheelbase,
                   .max_steer = dice.between(0.35, 0.9)});
    const double clearance = dice.coin() ? 0.0 : dice.between(0.0, 0.1);
    const double room = dice.coin() ? 1.0 : 4.0;
    const Slot slot({.length = car.length() + 2 * clearance + dice.between(-0.05, room),
                     .width = car.width() + clearance + dice.between(-0.05, 1.0)});
    const Stepping steps{.step = std::pow(10.0, dice.between(-3.0, -1.5)),
                         .heading_step = dice.between(0.004, 0.02),
                         .stop = dice.coin() ? StopRule::inside : StopRule::contact};
    return {car, slot, steps, clearance};
}

/// A heading that often is an entry: up to where the rear corner meets the curb.
double any_heading(Dice& dice, const Case& c) {
    return dice.between(0.3, std::min(1.05 * std::asin(std::min(1.0, c.slot.width() / c.car.length())), 1.57));
}

TEST(Stepping, RotatedHeadingsAndSkippedLooksChangeNothing) {
    Dice dice(2022);
    int parked = 0;
    for (int i = 0; i < sample(4000, 200000); ++i) {
        const Case c = any_case(dice);
        const double heading = any_heading(dice, c);
        SCOPED_TRACE(i);
        const LiteralRun plain = literal_run(c.car, c.slot, heading, c.steps, 60, c.clearance);
        const MaxSteerRun fast = stepping(c.car, c.slot, heading, c.steps, {60, {c.clearance, {}, Enter::backward}});
        ASSERT_EQ(fast.outcome, plain.outcome);
        ASSERT_EQ(fast.maneuver.moves.size(), plain.steps.size());
        for (std::size_t m = 0; m < plain.steps.size(); ++m) {
            ASSERT_EQ(std::lround(fast.maneuver.moves[m].length / c.steps.step), plain.steps[m]);
        }
        if (!plain.steps.empty()) {
            ASSERT_NEAR(fast.maneuver.goal().x, plain.goal.x, 1e-9);
            ASSERT_NEAR(fast.maneuver.goal().y, plain.goal.y, 1e-9);
            ASSERT_NEAR(fast.maneuver.goal().heading, plain.goal.heading, 1e-9);
        }
        parked += plain.outcome == Outcome::parked ? 1 : 0;
    }
    EXPECT_GT(parked, sample(4000, 200000) / 10) << "the cases no longer test parking";
}

TEST(Stepping, AnEntryListsTheSampledHeadingsThatPark) {
    Dice dice(31);
    for (int i = 0; i < sample(40, 1000); ++i) {
        SCOPED_TRACE(i);
        const Case c = any_case(dice);
        EntryOptions options;
        options.driving.clearance = c.clearance;
        if (dice.coin()) {
            options.max_changes = 12;
        }
        const Answer answer = stepping_entry(c.car, c.slot, options, c.steps);
        std::vector<int> needed;
        int fewest = 1000;
        for (double heading = 0.0; heading <= std::numbers::pi / 2;
             heading = static_cast<double>(needed.size()) * c.steps.heading_step) {
            const LiteralRun run =
                literal_run(c.car, c.slot, heading, c.steps, options.max_changes.value_or(200), c.clearance);
            const int changes = run.outcome == Outcome::parked ? static_cast<int>(run.steps.size()) - 1 : 1000;
            needed.push_back(changes);
            fewest = std::min(fewest, changes);
        }
        ASSERT_EQ(answer.parkable(), fewest < 1000);
        std::size_t listed = 0;
        for (const HeadingRange& range : answer.ranges) {
            for (auto h = std::lround(range.min / c.steps.heading_step);
                 h <= std::lround(range.max / c.steps.heading_step); ++h, ++listed) {
                ASSERT_EQ(needed.at(static_cast<std::size_t>(h)), range.direction_changes);
            }
        }
        const int most = options.max_changes ? 999 : std::min(fewest, 999);
        ASSERT_EQ(static_cast<long>(listed),
                  std::count_if(needed.begin(), needed.end(), [&](int n) { return n <= most; }));
        if (answer.parkable()) {
            ASSERT_EQ(answer.direction_changes, fewest);
            ASSERT_EQ(answer.maneuver->direction_changes(), fewest);
        }
    }
}

TEST(Stepping, GivesThePapersTenAndNineteen) {
    for (const StopRule stop : {StopRule::inside, StopRule::contact}) {
        const Stepping as_printed{.step = 1e-3, .heading_step = 1e-4, .stop = stop};
        EXPECT_EQ(stepping_entry(*find_car("mid-size"), Slot({5.1, 2.2}), {}, as_printed).direction_changes, 10);
        EXPECT_EQ(stepping_entry(*find_car("renault-zoe"), Slot({4.5, 2.0}), {}, as_printed).direction_changes, 19);
    }
}

TEST(Stepping, NeedsOneChangeLessWithTenTimesFinerSteps) {
    for (const StopRule stop : {StopRule::inside, StopRule::contact}) {
        const Stepping finer{.step = 1e-4, .heading_step = 5e-4, .stop = stop};
        EXPECT_EQ(stepping_entry(*find_car("mid-size"), Slot({5.1, 2.2}), {}, finer).direction_changes, 9);
        EXPECT_EQ(stepping_entry(*find_car("renault-zoe"), Slot({4.5, 2.0}), {}, finer).direction_changes, 18);
    }
}

TEST(Stepping, LooksOnlyAtContactsAndSoFindsNoMoreHeadings) {
    EntryOptions up_to_15;
    up_to_15.max_changes = 15;
    const auto headings = [&](StopRule stop) {
        double sum = 0.0;
        for (const HeadingRange& range :
             stepping_entry(*find_car("mid-size"), Slot({5.1, 2.2}), up_to_15, {1e-3, 1e-4, stop}).ranges) {
            sum += range.max - range.min;
        }
        return sum;
    };
    EXPECT_LT(headings(StopRule::contact), headings(StopRule::inside));
}

/// Any slot of that size in the world.
Slot placed(Dice& dice, const Slot& slot) {
    return Slot({slot.length(),
                 slot.width(),
                 dice.coin() ? Side::left : Side::right,
                 {dice.between(-50.0, 50.0), dice.between(-50.0, 50.0)},
                 dice.between(-4.0, 4.0)});
}

/// The frame grown by the clearance, seen in the slot frame.
test::Corners seen_from_slot(const Case& c, const Slot& slot, const Pose& in_world) {
    test::Corners corners = test::grown_frame(c.car, c.clearance, in_world);
    for (Point& corner : corners) {
        corner = slot.to_slot(corner);
    }
    if (slot.side() == Side::left) {  // keep them counter-clockwise
        std::reverse(corners.begin(), corners.end());
    }
    return corners;
}

TEST(Stepping, EveryManeuverObeysEquationOneInTheWorld) {
    Dice dice(5);
    for (int i = 0; i < sample(300, 10000); ++i) {
        SCOPED_TRACE(i);
        const Case c = any_case(dice);
        const Slot slot = placed(dice, c.slot);
        const Enter enter = dice.coin() ? Enter::backward : Enter::forward;
        const MaxSteerRun run = stepping(c.car, slot, any_heading(dice, c), c.steps, {40, {c.clearance, {}, enter}});
        for (const Move& move : run.maneuver.moves) {
            ASSERT_EQ(std::abs(move.steering_angle), c.car.max_steer());
            const auto step = [&](const Pose& pose) {
                return test::euler_step(c.car, pose, static_cast<int>(move.direction), move.steering_angle,
                                        c.steps.step);
            };
            Pose pose = move.start;
            for (long k = std::lround(move.length / c.steps.step); k > 0; --k) {
                pose = step(pose);
            }
            ASSERT_NEAR(pose.x, move.end.x, 1e-9);
            ASSERT_NEAR(pose.y, move.end.y, 1e-9);
            ASSERT_NEAR(pose.heading, move.end.heading, 1e-9);
            ASSERT_FALSE(test::hits(seen_from_slot(c, slot, move.end), slot));
            ASSERT_TRUE(!move.contact || test::hits(seen_from_slot(c, slot, step(move.end)), slot));
        }
        if (run.outcome == Outcome::parked) {
            ASSERT_TRUE(test::inside(seen_from_slot({c.car, c.slot, c.steps, 0.0}, slot, run.maneuver.goal()), slot));
        }
    }
}

TEST(Stepping, EnteringNoseFirstIsTheSwappedCarEnteringBackward) {
    Dice dice(77);
    for (int i = 0; i < sample(20, 500); ++i) {
        const Case c = any_case(dice);
        const Car swapped({c.car.width(), c.car.rear(), c.car.front(), c.car.wheelbase(), c.car.max_steer()});
        EntryOptions forward;
        forward.driving.enter = Enter::forward;
        const Answer nose = stepping_entry(c.car, placed(dice, c.slot), forward, c.steps);
        const Answer tail = stepping_entry(swapped, placed(dice, c.slot), {}, c.steps);
        ASSERT_EQ(nose.direction_changes, tail.direction_changes);
        ASSERT_EQ(nose.ranges.size(), tail.ranges.size());
        for (std::size_t r = 0; r < nose.ranges.size(); ++r) {
            ASSERT_EQ(nose.ranges[r].min, tail.ranges[r].min);
            ASSERT_EQ(nose.ranges[r].max, tail.ranges[r].max);
        }
        if (nose.maneuver) {
            ASSERT_EQ(nose.maneuver->moves.front().direction, Direction::forward);
        }
    }
}

/// Where on the frame a part is, as its one or two corners.
std::vector<Point> part_of(const Car& car, CarPart part, const Pose& pose) {
    const test::Corners f = test::grown_frame(car, 0.0, pose);
    switch (part) {
        case CarPart::front_left_corner: return {f[0]};
        case CarPart::rear_left_corner: return {f[1]};
        case CarPart::rear_right_corner: return {f[2]};
        case CarPart::front_right_corner: return {f[3]};
        case CarPart::front_edge: return {f[3], f[0]};
        case CarPart::left_edge: return {f[0], f[1]};
        case CarPart::rear_edge: return {f[1], f[2]};
        case CarPart::right_edge: return {f[2], f[3]};
        default: return {};  // wheels meet low curbs only
    }
}

TEST(Stepping, TheNamedPartIsAStepFromTheNamedObstacle) {
    Dice dice(8);
    int corners_of_the_slot = 0;
    for (int i = 0; i < sample(1000, 20000); ++i) {
        SCOPED_TRACE(i);
        const Case c = any_case(dice);
        const Slot slot = placed(dice, c.slot);
        const Enter enter = dice.coin() ? Enter::backward : Enter::forward;
        const MaxSteerRun run = stepping(c.car, slot, any_heading(dice, c), c.steps, {40, {0.0, {}, enter}});
        for (const Move& move : run.maneuver.moves) {
            if (!move.contact) {
                continue;
            }
            if (std::abs(slot.to_slot(move.end).heading) > std::numbers::pi / 2) {
                break;  // gone round over a neighbour: no way to park
            }
            std::vector<Point> part = part_of(c.car, move.contact->part, move.end);
            std::transform(part.begin(), part.end(), part.begin(), [&](const Point& p) { return slot.to_slot(p); });
            const double in_a_step = 6.0 * c.steps.step;  // no point of these cars moves farther
            const auto on_line = [&](const Point& p) {
                const double edge = std::hypot(part[1].x - part[0].x, part[1].y - part[0].y);
                return std::abs(test::left_of(part[0], part[1], p)) / edge;
            };
            switch (move.contact->obstacle) {
                case Obstacle::front_side: ASSERT_NEAR(part.at(0).x, 0.0, in_a_step); break;
                case Obstacle::rear_side: ASSERT_NEAR(part.at(0).x, -slot.length(), in_a_step); break;
                case Obstacle::curb: ASSERT_NEAR(part.at(0).y, -slot.width(), in_a_step); break;
                case Obstacle::front_corner: ASSERT_LE(on_line({0.0, 0.0}), in_a_step); break;
                case Obstacle::rear_corner: ASSERT_LE(on_line({-slot.length(), 0.0}), in_a_step); break;
            }
            const bool at_corner =
                move.contact->obstacle == Obstacle::front_corner || move.contact->obstacle == Obstacle::rear_corner;
            ASSERT_EQ(part.size(), at_corner ? 2U : 1U);
            corners_of_the_slot += at_corner ? 1 : 0;
        }
    }
    EXPECT_GT(corners_of_the_slot, 0);
}

TEST(Stepping, AMinimumRangeLeavesOutNarrowerStretches) {
    Dice dice(12);
    for (int i = 0; i < sample(60, 1000); ++i) {
        SCOPED_TRACE(i);
        Case c = any_case(dice);
        c.steps.heading_step = 1e-3;
        EntryOptions all;
        all.max_changes = 200;
        EntryOptions wide;
        wide.min_range = dice.between(0.0, 0.1);
        const Answer every = stepping_entry(c.car, c.slot, all, c.steps);
        const Answer answer = stepping_entry(c.car, c.slot, wide, c.steps);
        // The widest stretch of headings that need at most n changes, for rising n.
        const auto widest_with = [&](int n) {
            double widest = -1.0;
            double start = 0.0;
            double last = -1.0;
            for (const HeadingRange& range : every.ranges) {
                if (range.direction_changes <= n) {
                    start = last >= 0.0 && range.min - last < 1.5e-3 ? start : range.min;
                    last = range.max;
                    widest = std::max(widest, last - start);
                }
            }
            return widest;
        };
        int expected = 0;
        while (expected <= 200 && widest_with(expected) < wide.min_range - 1e-9) {
            ++expected;
        }
        ASSERT_EQ(answer.parkable(), expected <= 200);
        if (answer.parkable()) {
            ASSERT_EQ(answer.direction_changes, expected);
            ASSERT_EQ(answer.maneuver->direction_changes(), expected);
        }
    }
}

TEST(Stepping, StopsWhenToldTo) {
    double last = 0.0;
    int calls = 0;
    EntryOptions options;
    options.progress = [&](double part) {
        EXPECT_GE(part, last);
        EXPECT_LE(part, 1.0);
        last = part;
        return ++calls < 3;
    };
    const Answer answer = stepping_entry(*find_car("renault-zoe"), Slot({4.5, 2.0}), options, {});
    EXPECT_TRUE(answer.cancelled);
    EXPECT_FALSE(answer.parkable());
    EXPECT_EQ(calls, 3);
}

TEST(Stepping, ACarThatCirclesFreelyInAHugeSlotEnds) {
    const Car car = *find_car("mid-size");
    EXPECT_EQ(stepping(car, Slot({100.0, 100.0}), 0.5, {.stop = StopRule::contact}).outcome, Outcome::never_touches);
    EXPECT_EQ(stepping(car, Slot({100.0, 100.0}), 0.5, {.stop = StopRule::inside}).outcome, Outcome::parked);
}

TEST(Stepping, RefusesImpossibleOptions) {
    const Car car = *find_car("renault-zoe");
    const Slot slot({4.5, 2.0});
    for (const double step : {0.0, -1.0, 2.0, 1e-8, std::nan("")}) {
        EXPECT_THROW((void)stepping(car, slot, 0.4, {.step = step}), Error) << step;
        EXPECT_THROW((void)stepping_entry(car, slot, {}, {.heading_step = step}), Error) << step;
    }
    EXPECT_THROW((void)stepping(car, slot, -0.1), Error);
    EXPECT_THROW((void)stepping(car, slot, 1.6), Error);
    EXPECT_THROW((void)stepping(car, slot, 0.4, {}, {-1, {0.0, {}, Enter::backward}}), Error);
    const Car large({.width = 1e5, .front = 1e5, .rear = 1e5, .wheelbase = 1e5, .max_steer = 0.5});
    EXPECT_THROW((void)stepping(large, Slot({3e5, 2e5}), 0.4, {.step = 1e-7}), Error);
}

TEST(Stepping, RefusesWhatItWouldLeaveOut) {
    const Car car = *find_car("renault-zoe");
    const Car rounded(Outline::rounded(3.4, 0.7, 0.9, 0.4, 0.25), 2.6, 0.5, "rounded");
    const auto refuses = [](const Car& asked, const SlotDimensions& dimensions, const Driving& driving,
                            const Parked& parked) {
        const Slot slot(dimensions);
        EXPECT_THROW((void)stepping(asked, slot, 0.4, {}, {200, driving, parked}), Error);
        EntryOptions options;
        options.driving = driving;
        options.parked = parked;
        EXPECT_THROW((void)stepping_entry(asked, slot, options, {}), Error);
    };
    refuses(rounded, {4.5, 2.0}, {}, {});
    refuses(car, {.length = 4.5, .width = 2.0, .front_setback = 0.1}, {}, {});
    refuses(car, {.length = 4.5, .width = 2.0, .rear_setback = 0.1}, {}, {});
    refuses(car, {.length = 4.5, .width = 2.0, .curb = Curb::low}, {}, {});
    refuses(car, {4.5, 2.0}, {.curb_clearance = 0.1}, {});
    refuses(car, {4.5, 2.0}, {}, {.heading = 0.1});
    refuses(car, {4.5, 2.0}, {}, {.curb = 0.1});
    EXPECT_NO_THROW((void)stepping(car, Slot({4.5, 2.0}), 0.4, {}, {200, {0.05, 0.05}, {}}));
}

}  // namespace
}  // namespace snug
