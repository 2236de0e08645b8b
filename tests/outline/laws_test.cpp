// Laws of parking that hold for any outline among any neighbours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "contact/entering.hpp"
#include "full_steering/heading_ranges.hpp"
#include "oracle/random_outlines.hpp"
#include "sample.hpp"

namespace oracle {
namespace {

constexpr std::uint64_t seed = 61;
int cases() { return snug::test::sample(60, 3000); }

snug::Answer entries(const Case& asked) {
    snug::EntryOptions options;
    options.prove = false;
    options.driving = asked.driving;
    options.parked = asked.parked;
    snug::Answer best = snug::entry(asked.made_car(), asked.made_slot(), options);
    if (!best.direction_changes) return best;
    options.max_changes = *best.direction_changes + asked.more_changes;
    return snug::entry(asked.made_car(), asked.made_slot(), options);
}

snug::Answer fewest_of(const Case& asked, double resolution) {
    snug::FewestOptions options;
    options.max_changes = 12;
    options.driving = asked.driving;
    options.parked = asked.parked;
    options.resolution = resolution;
    options.roomiest = false;
    return snug::fewest(asked.made_car(), asked.made_slot(), options);
}

void expect_same_moves(const snug::Answer& one, const snug::Answer& two) {
    ASSERT_EQ(one.maneuver.has_value(), two.maneuver.has_value());
    if (!one.maneuver) return;
    ASSERT_EQ(one.maneuver->moves.size(), two.maneuver->moves.size());
    for (std::size_t i = 0; i < one.maneuver->moves.size(); ++i) {
        const snug::Move &a = one.maneuver->moves[i], &b = two.maneuver->moves[i];
        EXPECT_EQ(a.direction, b.direction);
        EXPECT_EQ(a.steering_angle, b.steering_angle);
        EXPECT_EQ(a.length, b.length);
        EXPECT_EQ(a.start.x, b.start.x);
        EXPECT_EQ(a.start.y, b.start.y);
        EXPECT_EQ(a.start.heading, b.start.heading);
        EXPECT_EQ(a.end.x, b.end.x);
        EXPECT_EQ(a.end.y, b.end.y);
        EXPECT_EQ(a.end.heading, b.end.heading);
    }
}

/// Ranges equal to `tolerance`; one no wider than that may be missing.
void expect_same_ranges(const snug::Answer& one, const snug::Answer& two, double tolerance) {
    const auto wide = [&](const snug::Answer& answer) {
        std::vector<snug::HeadingRange> ranges = answer.ranges;
        std::erase_if(ranges, [&](const snug::HeadingRange& r) { return r.max - r.min <= tolerance; });
        return ranges;
    };
    const auto a = wide(one), b = wide(two);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].direction_changes, b[i].direction_changes);
        EXPECT_NEAR(a[i].min, b[i].min, tolerance);
        EXPECT_NEAR(a[i].max, b[i].max, tolerance);
    }
}

/// The same corners from another one on, now and then the other way round, and some that are none in between.
std::vector<snug::Point> told_otherwise(Random& random, std::vector<snug::Point> corners) {
    std::rotate(corners.begin(), corners.begin() + random.below(int(corners.size())), corners.end());
    if (random.chance(0.5)) std::reverse(corners.begin(), corners.end());
    return corners;
}

std::vector<snug::Point> corners_of(const snug::CarDimensions& car) {
    const double side = car.width / 2;
    return {{car.front, side}, {-car.rear, side}, {-car.rear, -side}, {car.front, -side}};
}

TEST(OutlineLaws, ARectangleGivenAsAnOutlineAnswersBitForBitLikeTheRectangle) {
    for (int i = 0; i < cases(); ++i) {
        Case rectangle = random_case(seed, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        choose_neighbours(random, rectangle);
        Case outline = rectangle;
        outline.outline = told_otherwise(random, corners_of(rectangle.car));
        SCOPED_TRACE(command_line(outline));
        const snug::Answer one = entries(rectangle), two = entries(outline);
        EXPECT_EQ(one.direction_changes, two.direction_changes);
        EXPECT_TRUE(one.ranges == two.ranges);
        expect_same_moves(one, two);
    }
}

TEST(OutlineLaws, ARectangleGivenAsAnOutlineNeedsNoOtherFewest) {
    for (int i = 0; i < snug::test::sample(10, 300); ++i) {
        const Case rectangle = random_case(seed + 1, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        Case outline = rectangle;
        outline.outline = told_otherwise(random, corners_of(rectangle.car));
        SCOPED_TRACE(command_line(outline));
        const double resolution = 1e-3 * rectangle.car_length();
        const snug::Answer one = fewest_of(rectangle, resolution), two = fewest_of(outline, resolution);
        EXPECT_EQ(one.direction_changes, two.direction_changes);
        EXPECT_EQ(one.lower_bound, two.lower_bound);
        EXPECT_EQ(one.proved, two.proved);
        expect_same_moves(one, two);
    }
}

TEST(OutlineLaws, TheOrderInWhichCornersAreToldDoesNotMatter) {
    for (int i = 0; i < cases(); ++i) {
        const Case asked = random_outline_case(seed + 2, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        Case otherwise = asked;
        otherwise.outline = told_otherwise(random, asked.outline);
        SCOPED_TRACE(command_line(otherwise));
        const snug::Answer one = entries(asked), two = entries(otherwise);
        EXPECT_EQ(one.direction_changes, two.direction_changes);
        EXPECT_TRUE(one.ranges == two.ranges);
        expect_same_moves(one, two);
    }
}

/// The car seen in a mirror, in a slot on the other side.
Case in_the_mirror(Case asked) {
    for (snug::Point& p : asked.outline) p.y = -p.y;
    asked.slot.side = asked.slot.side == snug::Side::left ? snug::Side::right : snug::Side::left;
    return asked;
}

/// The slot elsewhere in the world.
Case elsewhere(Random& random, Case asked) {
    asked.slot.corner = {random.between(-100, 100), random.between(-100, 100)};
    asked.slot.heading = random.between(-10, 10);
    return asked;
}

Case scaled(Case asked, double scale) {
    for (double* length : asked.lengths()) *length *= scale;
    return asked;
}

/// Nose first is tail first for the car turned about, between the neighbours exchanged.
Case turned_about(Case asked) {
    for (snug::Point& p : asked.outline) p.x = -p.x;
    std::swap(asked.car.front, asked.car.rear);
    std::swap(asked.slot.front_setback, asked.slot.rear_setback);
    asked.driving.enter = asked.driving.enter == snug::Enter::forward ? snug::Enter::backward : snug::Enter::forward;
    return asked;
}

TEST(OutlineLaws, TheMirroredCarHasTheSameEntriesOnTheOtherSide) {
    for (int i = 0; i < cases(); ++i) {
        const Case asked = random_outline_case(seed + 3, std::uint64_t(i));
        SCOPED_TRACE(command_line(asked));
        expect_same_ranges(entries(asked), entries(in_the_mirror(asked)), 1e-12);
    }
}

TEST(OutlineLaws, ContactsNameTheCornerThatTouches) {
    int touched[2][2] = {};  // by full steering and in the fewest changes, tail and nose first
    for (int i = 0; i < cases(); ++i) {
        Case asked = random_outline_case(seed + 13, std::uint64_t(i));
        if (i % 2 != 0) {  // nose first takes more room
            asked.driving.enter = snug::Enter::forward;
            asked.slot.length *= 1.2;
            asked.slot.width *= 1.4;
        }
        SCOPED_TRACE("case " + std::to_string(i) + ": " + command_line(asked));
        const snug::Car car = asked.made_car();
        const snug::Slot slot = asked.made_slot();
        const bool low = slot.curb() == snug::Curb::low;
        for (const bool least : {false, true}) {
            const snug::Answer answer = least ? fewest_of(asked, 4e-3 * asked.car_length()) : entries(asked);
            if (!answer.maneuver) continue;
            for (const snug::Move& move : answer.maneuver->moves) {
                if (!move.contact) continue;
                const snug::Obstacle met = move.contact->obstacle;
                const bool curb = met == snug::Obstacle::curb;
                const snug::Outline outline = (curb && low ? car.wheels() : car.outline())
                                                  .grown(curb ? asked.driving.at_curb() : asked.driving.clearance);
                ASSERT_LT(move.contact->part_index, outline.corners().size());
                const double c = std::cos(move.end.heading), s = std::sin(move.end.heading);
                const auto placed = [&](std::size_t index) {
                    const snug::Point& corner = outline.corners()[index % outline.corners().size()];
                    return slot.to_slot(snug::Point{move.end.x + c * corner.x - s * corner.y,
                                                    move.end.y + s * corner.x + c * corner.y});
                };
                const snug::Point at = placed(move.contact->part_index);
                const snug::Point next = placed(move.contact->part_index + 1);
                const auto off_the_edge = [&](const snug::Point& point) {
                    const double x = next.x - at.x, y = next.y - at.y;
                    return std::abs(x * (point.y - at.y) - y * (point.x - at.x)) / std::hypot(x, y);
                };
                const double in_front = std::abs(at.x), behind = std::abs(at.x + slot.length());
                double apart = 0.0;
                switch (met) {  // a neighbour is met at its side or, from the road, at its top
                    case snug::Obstacle::curb: apart = at.y + slot.width(); break;
                    case snug::Obstacle::front_side:
                        apart = std::min(in_front, std::abs(at.y + slot.front_setback()));
                        break;
                    case snug::Obstacle::rear_side:
                        apart = std::min(behind, std::abs(at.y + slot.rear_setback()));
                        break;
                    case snug::Obstacle::front_corner: apart = off_the_edge({0.0, -slot.front_setback()}); break;
                    case snug::Obstacle::rear_corner:
                        apart = off_the_edge({-slot.length(), -slot.rear_setback()});
                        break;
                }
                EXPECT_NEAR(apart, 0.0, 1e-6) << to_string(move.contact->part) << ' ' << to_string(met);
                ++touched[least][asked.driving.enter == snug::Enter::forward];
            }
        }
    }
    std::printf("contacts: %d and %d by full steering, %d and %d in the fewest changes\n", touched[0][0], touched[0][1],
                touched[1][0], touched[1][1]);
    EXPECT_GT(touched[0][0], 0);
}

TEST(OutlineLaws, MovingTheWorldChangesNoEntry) {
    for (int i = 0; i < cases(); ++i) {
        const Case asked = random_outline_case(seed + 4, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        SCOPED_TRACE(command_line(asked));
        expect_same_ranges(entries(asked), entries(elsewhere(random, asked)), 1e-12);
    }
}

TEST(OutlineLaws, TwiceTheSizeHasTheSameEntries) {
    for (int i = 0; i < cases(); ++i) {
        const Case asked = random_outline_case(seed + 5, std::uint64_t(i));
        SCOPED_TRACE(command_line(asked));
        // By a power of two, so that rounding is the same.
        expect_same_ranges(entries(asked), entries(scaled(asked, i % 2 == 0 ? 4.0 : 0.125)), 1e-12);
    }
}

TEST(OutlineLaws, NeitherPlaceNorSideNorScaleChangesTheFewest) {
    for (int i = 0; i < snug::test::sample(10, 300); ++i) {
        Case asked = random_outline_case(seed + 6, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        SCOPED_TRACE(command_line(asked));
        const double resolution = 1e-3 * asked.car_length();
        const snug::Answer answer = fewest_of(asked, resolution);
        for (const snug::Answer& same :
             {fewest_of(in_the_mirror(asked), resolution), fewest_of(elsewhere(random, asked), resolution),
              fewest_of(scaled(asked, 2.0), 2.0 * resolution)}) {
            EXPECT_EQ(same.lower_bound, answer.lower_bound);
            EXPECT_EQ(same.proved, answer.proved);
            EXPECT_EQ(same.direction_changes, answer.direction_changes);
        }
    }
}

TEST(OutlineLaws, NoseFirstIsTailFirstForTheCarTurnedAboutBetweenTheNeighboursExchanged) {
    for (int i = 0; i < cases(); ++i) {
        Case asked = random_outline_case(seed + 7, std::uint64_t(i));
        asked.slot.curb = snug::Curb::high;  // the wheels do not turn about: the front axle stays where it is
        SCOPED_TRACE(command_line(asked));
        expect_same_ranges(entries(asked), entries(turned_about(asked)), 1e-12);
    }
}

/// Bounds of one question never contradict those of a question that is no harder.
void expect_no_harder(const Case& easier, const Case& harder) {
    const double resolution = 1e-3 * harder.car_length();
    const snug::Answer easy = fewest_of(easier, resolution), hard = fewest_of(harder, resolution);
    SCOPED_TRACE(command_line(easier) + "\nis no harder than\n" + command_line(harder));
    if (hard.direction_changes) {
        EXPECT_LE(easy.lower_bound, *hard.direction_changes);
    }
    if (easy.proved && hard.proved && hard.direction_changes) {
        ASSERT_TRUE(easy.direction_changes);
        EXPECT_LE(*easy.direction_changes, *hard.direction_changes);
    }
}

int comparisons() { return snug::test::sample(15, 500); }

TEST(OutlineLaws, ACarInsideAnotherCarNeedsNoMoreChanges) {
    for (int i = 0; i < comparisons(); ++i) {
        Case asked = random_outline_case(seed + 8, std::uint64_t(i));
        asked.parked.curb = std::numeric_limits<double>::infinity();  // the smaller one has farther to go there
        asked.driving.enter = snug::Enter::backward;                  // nose first, of a smaller nose less stays in
        Random random(std::uint64_t(i) + 1);
        Case smaller = asked;
        // Towards the rear axle's middle, each corner as much as it likes: what remains convex is inside.
        outlines::Points points = asked.outline;
        for (snug::Point& p : points) {
            const double part = random.chance(0.5) ? 1.0 : random.between(0.8, 1.0);
            p.x *= part, p.y *= part;
        }
        smaller.outline = outlines::hull(points);
        if (!outlines::is_a_car(smaller.outline, asked.car.wheelbase)) continue;
        expect_no_harder(smaller, asked);
    }
}

TEST(OutlineLaws, ACarWithItsCornersCutNeedsNoMoreChangesThanItsRectangle) {
    for (int i = 0; i < comparisons(); ++i) {
        Case asked = random_outline_case(seed + 9, std::uint64_t(i));
        asked.driving.enter = snug::Enter::backward;
        Case rectangle = asked;
        double left = 0;
        for (const snug::Point& p : asked.outline) left = std::max(left, p.y);
        rectangle.outline = {{asked.car.front, left},
                             {-asked.car.rear, left},
                             {-asked.car.rear, left - asked.car.width},
                             {asked.car.front, left - asked.car.width}};
        asked.parked.curb = rectangle.parked.curb = std::numeric_limits<double>::infinity();
        expect_no_harder(asked, rectangle);
    }
}

TEST(OutlineLaws, ADeeperNeighbourIsNoHarder) {
    for (int i = 0; i < comparisons(); ++i) {
        const Case asked = random_outline_case(seed + 10, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        Case deeper = asked;
        double& setback = random.chance(0.5) ? deeper.slot.front_setback : deeper.slot.rear_setback;
        setback += random.unit() * (asked.slot.width - setback);
        expect_no_harder(deeper, asked);
    }
}

TEST(OutlineLaws, ALowCurbIsNoHarder) {
    for (int i = 0; i < comparisons(); ++i) {
        Case high = random_outline_case(seed + 11, std::uint64_t(i));
        high.slot.curb = snug::Curb::high;
        high.driving.curb_clearance = 0;  // grown by a clearance, wheels may stick out of a body grown as much
        Case low = high;
        low.slot.curb = snug::Curb::low;
        expect_no_harder(low, high);
    }
}

TEST(OutlineLaws, AskingLessOfTheParkedCarIsNoHarder) {
    for (int i = 0; i < comparisons(); ++i) {
        Case strict = random_outline_case(seed + 12, std::uint64_t(i));
        Random random(std::uint64_t(i) + 1);
        strict.parked.heading = std::min(strict.parked.heading, random.between(0.01, 0.2));
        strict.parked.curb = std::min(strict.parked.curb, random.between(0.05, 0.5));
        Case loose = strict;
        loose.parked.heading *= random.between(1, 3);
        loose.parked.curb += random.between(0, 0.3);
        expect_no_harder(loose, strict);
    }
}

/// A rounded car has many more sectors than a rectangle, each with kinks at its borders; the search must not drown in them.
TEST(OutlineLaws, RoundedCarsAreSearchedInFewMoves) {
    const snug::Car car(snug::Outline::rounded(3.427, 0.657, 0.8855, 0.4, 0.25), 2.588, 33.0 * 0.017453292519943295,
                        "");
    for (const snug::Enter enter : {snug::Enter::backward, snug::Enter::forward}) {
        for (const double longer : {0.3, 0.5, 0.9, 1.3}) {
            const snug::Slot slot({.length = car.length() + longer, .width = car.width() + 0.1});
            const snug::detail::FullSteering steering(snug::detail::entering_problem(car, slot, {.enter = enter}));
            for (const int most : {4, 8, 14}) {
                snug::detail::SearchWork work;
                snug::detail::heading_ranges(steering, most, snug::detail::Find::all, {}, &work);
                SCOPED_TRACE(testing::Message() << longer << ' ' << most << ' ' << int(enter));
                EXPECT_TRUE(work.complete);
                EXPECT_LT(work.moves, 50'000U);
            }
        }
    }
}

}  // namespace
}  // namespace oracle
