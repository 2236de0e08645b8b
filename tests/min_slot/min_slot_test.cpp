// Is every minimum slot large enough, and no smaller one? Both sides attacked by the oracle, which shares nothing with
// the solver; and what minimum slots must obey whatever their size.
//
// SNUG_SOAK=1 runs hundreds of cases; SNUG_SEED, SNUG_FIRST and SNUG_CASES choose which.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <mutex>
#include <thread>

#include "attack.hpp"
#include "oracle/follower.hpp"
#include "oracle/plain_search.hpp"
#include "sample.hpp"
#include "snug/snug.hpp"
#include "snug/sweep.hpp"

namespace oracle {
namespace {

constexpr double tenth_of_a_millimetre = 1e-4;
constexpr double resolution = 1e-7;  // what the solver promises [m]

/// Empty where nothing within the limits will do.
std::optional<snug::MinSlot> smallest(const MinSlotCase& asked) {
    snug::MinSlotOptions options;
    options.max_changes = asked.max_changes;
    options.min_range = asked.min_range;
    options.driving = asked.asked.driving;
    options.parked = asked.asked.parked;
    options.front_setback = asked.asked.slot.front_setback;
    options.rear_setback = asked.asked.slot.rear_setback;
    options.curb = asked.asked.slot.curb;
    options.sought = asked.length_sought ? snug::Sought::length : snug::Sought::width;
    const snug::MinSlot slot = min_slot(asked.asked.made_car(), asked.given(), options);
    return slot.size(options.sought) ? std::optional(slot) : std::nullopt;
}

double size_of(const MinSlotCase& asked, const snug::MinSlot& slot) {
    return asked.length_sought ? slot.length.value() : slot.width.value();
}

/// Runs `attack`, which answers with what is wrong, on random cases on all cores.
template <class Choose, class Attack>
void attack_chosen(int usual, int full, std::uint64_t stream, const Choose& choose, const Attack& attack) {
    const std::uint64_t seed = snug::test::number("SNUG_SEED", 1) + stream, first = snug::test::number("SNUG_FIRST", 0);
    const std::uint64_t cases =
        snug::test::number("SNUG_CASES", std::uint64_t(snug::test::sample(usual, full, std::max(3, usual / 10))));
    std::atomic<std::uint64_t> next{0};
    std::mutex mutex;
    const auto work = [&] {
        for (std::uint64_t i = next++; i < cases; i = next++) {
            const std::string wrong = attack(choose(seed, first + i), first + i);
            const std::lock_guard lock(mutex);
            if (!wrong.empty()) ADD_FAILURE() << "case " << first + i << ": " << wrong;
            if (i % 50 == 49) std::printf("%d of %d\n", int(i + 1), int(cases)), std::fflush(stdout);
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
}

template <class Attack>
void attack_all(int usual, int full, Cars cars, std::uint64_t stream, const Attack& attack) {
    attack_chosen(
        usual, full, stream,
        [cars](std::uint64_t seed, std::uint64_t index) { return random_min_slot_case(seed, index, cars); }, attack);
}

/// A tenth of a millimetre more room, and a maneuver exists: driven by the oracle, and followed pose by pose. The solver
/// only proposes it, for the headings that park are few, and move while the slot grows.
std::string attack_from_above(const MinSlotCase& asked, double size) {
    const Case sized = asked.in_slot_of(size + tenth_of_a_millimetre);
    snug::EntryOptions options;
    options.prove = false;
    options.max_changes = asked.max_changes;
    options.driving = sized.driving;
    options.parked = sized.parked;
    const snug::Answer answer = snug::entry(sized.made_car(), sized.made_slot(), options);
    if (!answer.maneuver) return "no maneuver in a slot 0.1 mm larger, " + asked.line(size);
    const double sign = sized.driving.enter == snug::Enter::backward ? 1.0 : -1.0;
    const double heading = sign * into_slot(sized.slot, answer.maneuver->entry()).heading;
    if (!parks(asked, size + tenth_of_a_millimetre, heading))
        return "the oracle does not park in a slot 0.1 mm larger, " + asked.line(size);
    for (const std::string& fault : faults(sized, *answer.maneuver, *answer.direction_changes))
        return fault + ", " + asked.line(size);
    return {};
}

/// The heading reported parks in the very slot reported, to the oracle's rounding.
std::string attack_in_place(const MinSlotCase& asked, double size, double heading) {
    auto problem = asked.problem<long double>(size);
    problem.car = problem.car.grown(-1e-12L);
    problem.parked_curb += 2e-12L;
    problem.parked_heading += 1e-12L;
    const auto driven = run(problem, static_cast<long double>(heading), asked.max_changes);
    return driven.parked() ? "" : "the reported heading does not park, " + asked.line(size);
}

/// In no smaller slot does sampling find a heading that parks: just below densely, farther below sparsely. Under sanitizers the
/// steps are ten times wider, for nearly all of the work is the oracle's.
std::string attack_from_below(const MinSlotCase& asked, double fails, std::uint64_t index) {
    Random random(index + 1000);
    const double wider = snug::test::is_set("SNUG_SMALL") ? 10.0 : 1.0;
    std::vector<std::pair<double, double>> attacks = {{fails, 1e-5}, {fails - 1e-3, 1e-4}, {fails - 0.02, 1e-4}};
    for (int i = 0; i < 2; ++i)
        attacks.emplace_back(random.between(asked.least(), std::max(asked.least(), fails)), 1e-4);
    for (const auto& [size, step] : attacks) {
        if (size <= asked.least()) continue;
        if (const std::optional<double> heading = parking_heading(asked, size, wider * step, random.unit())) {
            std::ostringstream text;
            text.precision(17);
            text << "the smallest is said to lie " << fails - size << " m above, but the heading " << *heading
                 << " parks: " << asked.line(size);
            return text.str();
        }
    }
    return {};
}

TEST(MinSlot, AreLargeEnoughAndNoneSmallerIs) {
    std::atomic<int> answers{0};
    attack_all(6, 400, Cars::any, 0, [&](const MinSlotCase& asked, std::uint64_t index) -> std::string {
        const std::optional<snug::MinSlot> slot = smallest(asked);
        if (!slot) return attack_from_below(asked, asked.least() + 4.0, index);
        ++answers;
        const double size = size_of(asked, *slot);
        if (std::string wrong = attack_in_place(asked, size, slot->entry_heading.value()); !wrong.empty()) return wrong;
        if (std::string wrong = attack_from_above(asked, size); !wrong.empty()) return wrong;
        return attack_from_below(asked, size - tenth_of_a_millimetre, index);
    });
    std::printf("%d minima\n", answers.load());
}

TEST(MinSlot, AreSoBetweenAnyNeighboursToo) {
    std::atomic<int> answers{0};
    attack_chosen(10, 600, 4, random_neighbours_case,
                  [&](const MinSlotCase& asked, std::uint64_t index) -> std::string {
                      const std::optional<snug::MinSlot> slot = smallest(asked);
                      if (!slot) return attack_from_below(asked, asked.least() + 4.0, index);
                      ++answers;
                      const double size = size_of(asked, *slot);
                      if (std::string wrong = attack_in_place(asked, size, *slot->entry_heading); !wrong.empty())
                          return wrong;
                      if (std::string wrong = attack_from_above(asked, size); !wrong.empty()) return wrong;
                      return attack_from_below(asked, size - tenth_of_a_millimetre, index);
                  });
    std::printf("%d minima\n", answers.load());
    EXPECT_GT(answers, 0);
}

/// Over all maneuvers: a way in is followed pose by pose at the size found, and below the other a plain search, which knows
/// nothing of lattices, finds none.
TEST(MinSlot, OverAllManeuversLieBetweenTwoSizes) {
    std::atomic<int> answers{0};
    attack_chosen(6, 60, 5, random_neighbours_case, [&](MinSlotCase asked, std::uint64_t index) -> std::string {
        asked.max_changes %= 4;
        asked.asked.driving.enter = snug::Enter::backward;
        if (!asked.length_sought) asked.asked.parked.curb = std::numeric_limits<double>::infinity();
        snug::MinSlotOptions options;
        options.strategy = snug::Strategy::fewest;
        options.sought = asked.length_sought ? snug::Sought::length : snug::Sought::width;
        options.max_changes = asked.max_changes;
        options.driving = asked.asked.driving;
        options.parked = asked.asked.parked;
        options.front_setback = asked.asked.slot.front_setback;
        options.rear_setback = asked.asked.slot.rear_setback;
        options.curb = asked.asked.slot.curb;
        options.precision = 2e-2;
        options.resolution = 2e-3 * asked.asked.car_length();
        const snug::MinSlot slot = min_slot(asked.asked.made_car(), asked.given(), options);
        const std::optional<double>& size = slot.size(options.sought);
        if (size) {
            ++answers;
            if (!(slot.lower <= *size)) return "the sizes are the wrong way round, " + asked.line(*size);
            const Case sized = asked.in_slot_of(*size + 1e-9);
            snug::FewestOptions there;
            there.max_changes = asked.max_changes;
            there.driving = sized.driving;
            there.parked = sized.parked;
            there.resolution = options.resolution / 2;
            there.roomiest = false;
            const snug::Answer answer = fewest(sized.made_car(), sized.made_slot(), there);
            if (!answer.maneuver) return "no maneuver in the slot found, " + asked.line(*size);
            for (const std::string& fault : faults(sized, *answer.maneuver, *answer.direction_changes)) {
                // It may begin with any steering, and above the corner.
                const bool of_full_steering = fault.find("the first move steers") == 0 ||
                                              fault.find("the entry position is") == 0 ||
                                              fault.find("entry heading") == 0;
                if (!of_full_steering) return fault + ", " + asked.line(*size);
            }
        }
        Random random(index + 2000);
        const double below = slot.lower - random.between(1e-6, 0.1);
        const Case small = asked.in_slot_of(below);
        const double deepest = std::max(small.slot.front_setback, small.slot.rear_setback);
        if (below <= asked.asked.car_length() / 2 || small.slot.width <= std::max(deepest, small.car.width / 2))
            return {};
        PlainSearch search(small, asked.max_changes);
        if (search.changes()) return "parks in a slot proved too small:\n" + search.way_out() + asked.line(below);
        return {};
    });
    std::printf("%d sizes\n", answers.load());
    EXPECT_GT(answers, 0);
}

TEST(MinSlot, WithRoomForADriverHoldAStretchAndNoneSmallerDoes) {
    attack_all(15, 150, Cars::any, 1, [](MinSlotCase asked, std::uint64_t index) -> std::string {
        asked.min_range = std::pow(10.0, Random(index).between(-3.5, -1.3));
        const std::optional<snug::MinSlot> slot = smallest(asked);
        const double size = slot ? size_of(asked, *slot) : asked.least() + 4.0;
        const double narrower = slot ? size - tenth_of_a_millimetre : size;
        if (slot) {
            const auto problem = asked.problem<long double>(size);
            for (int i = -100; i <= 100; ++i) {
                const double heading = *slot->entry_heading + asked.min_range / 2 * (i / 100.0) * (1 - 1e-5);
                if (!run(problem, static_cast<long double>(heading), asked.max_changes).parked()) {
                    std::ostringstream text;
                    text.precision(17);
                    text << "does not park with " << heading << ", off " << *slot->entry_heading << ": "
                         << asked.line(size);
                    return text.str();
                }
            }
        }
        if (widest_stretch(asked, narrower, asked.min_range) >= asked.min_range)
            return "a smaller slot has a stretch that wide, " + asked.line(narrower);
        return {};
    });
}

// The fewest count falls with the room for the paper's cars, as far as anybody has seen. For others it does not:
TEST(MinSlot, AreFoundWhereALongerSlotIsHarder) {
    MinSlotCase asked;
    asked.asked.car = {2.062, 4.504, 1.326, 3.650, 0.860};
    asked.asked.slot.width = 2.43;
    asked.max_changes = 2;
    // Farther back the car meets the curb, where the rear neighbour would have stopped it in time.
    EXPECT_FALSE(parking_heading(asked, 6.49, 1e-4, 0.5));
    EXPECT_TRUE(parking_heading(asked, 6.52, 1e-4, 0.5));
    EXPECT_FALSE(parking_heading(asked, 6.60, 1e-4, 0.5));
    EXPECT_TRUE(parking_heading(asked, 6.70, 1e-4, 0.5));
    const std::optional<snug::MinSlot> slot = smallest(asked);
    ASSERT_TRUE(slot);
    EXPECT_NEAR(*slot->length, 6.50, 0.01);

    // And a wider one is, for a car that turns on the spot, almost.
    asked.asked.car = {2.352, 2.194, 1.246, 1.721, 0.9155};
    asked.max_changes = 8;
    asked.asked.slot.width = 2.7;
    const std::optional<snug::MinSlot> narrow = smallest(asked);
    asked.asked.slot.width = 3.2;
    const std::optional<snug::MinSlot> wide = smallest(asked);
    ASSERT_TRUE(narrow && wide);
    EXPECT_GT(*wide->length, *narrow->length + 0.05);
    EXPECT_FALSE(parking_heading(asked, *wide->length - 0.05, 1e-4, 0.5));
}

TEST(MinSlot, ShortestAndNarrowestAreEachOthersInverse) {
    attack_all(30, 2000, Cars::of_the_paper, 2, [](const MinSlotCase& asked, std::uint64_t) -> std::string {
        const std::optional<snug::MinSlot> slot = smallest(asked);
        if (!slot) return {};
        MinSlotCase other = asked;
        other.asked.slot.length = *slot->length;
        other.asked.slot.width = *slot->width;
        other.length_sought = !asked.length_sought;
        const std::optional<snug::MinSlot> back = smallest(other);
        // It cannot need more than what was given; what it needs instead cannot do with less than what was found.
        if (!back || size_of(other, *back) > asked.given() + resolution)
            return "the slot found is said to be too small for the car: " + asked.line(size_of(asked, *slot));
        MinSlotCase again = asked;
        (asked.length_sought ? again.asked.slot.width : again.asked.slot.length) = size_of(other, *back);
        const std::optional<snug::MinSlot> there = smallest(again);
        if (!there || size_of(again, *there) > size_of(asked, *slot) + resolution)
            return "and back again it needs more: " + again.line(size_of(asked, *slot));
        return {};
    });
}

TEST(MinSlot, NeedsNoMoreForAWiderSlotOrMoreChanges) {
    attack_all(60, 2000, Cars::of_the_paper, 3, [](const MinSlotCase& asked, std::uint64_t index) -> std::string {
        Random random(index);
        const std::optional<snug::MinSlot> slot = smallest(asked);
        if (!slot) return {};
        MinSlotCase easier = asked;
        (asked.length_sought ? easier.asked.slot.width : easier.asked.slot.length) +=
            std::pow(10.0, random.between(-6.0, 0.0));
        const std::optional<snug::MinSlot> less = smallest(easier);
        if (!less || size_of(easier, *less) > size_of(asked, *slot) + resolution)
            return "more room makes it harder: " + easier.line(size_of(asked, *slot));
        easier = asked;
        easier.max_changes += 1 + random.below(4);
        const std::optional<snug::MinSlot> longer = smallest(easier);
        if (!longer || size_of(easier, *longer) > size_of(asked, *slot) + resolution)
            return "more changes make it harder: " + easier.line(size_of(asked, *slot));
        return {};
    });
}

TEST(MinSlot, ACurveIsMadeOfTheSameAnswers) {
    const std::vector<int> counts = {7, 0, 2, 30};
    const std::vector<snug::Car> cars = snug::catalogue();
    for (int at = 0; at < snug::test::sample(5, 5); ++at) {
        const snug::Car& car = cars[std::size_t(at)];
        std::vector<double> widths, lengths;
        for (const double extra : {0.45, 0.12, 0.13, 0.14, 0.3}) {
            widths.push_back(car.width() + extra);
            lengths.push_back(car.length() + 3 * extra);
        }
        const auto compare = [&](snug::Sought sought) {
            const bool length = sought == snug::Sought::length;
            const std::vector<double>& given = length ? widths : lengths;
            const std::vector<snug::MinSlot> rows = snug::min_slots(car, given, counts, {.sought = sought});
            ASSERT_EQ(rows.size(), counts.size() * widths.size());
            for (std::size_t i = 0; i < rows.size(); ++i) {
                snug::MinSlotOptions options;
                options.max_changes = rows[i].max_changes;
                EXPECT_EQ(rows[i].max_changes, counts[i / widths.size()]);
                options.sought = sought;
                const double asked = given[i % given.size()];
                EXPECT_EQ(length ? rows[i].width : rows[i].length, asked);
                const snug::MinSlot alone = min_slot(car, asked, options);
                ASSERT_EQ(rows[i].size(sought).has_value(), alone.size(sought).has_value())
                    << car.name() << ' ' << asked;
                if (!alone.size(sought)) continue;
                EXPECT_NEAR(*rows[i].length, *alone.length, resolution) << car.name() << ' ' << asked;
                EXPECT_NEAR(*rows[i].width, *alone.width, resolution) << car.name() << ' ' << asked;
            }
        };
        compare(snug::Sought::length);
        compare(snug::Sought::width);
    }
}

TEST(MinSlot, ThePapersLoopNeedsMore) {
    const snug::Stepping coarse{.step = 5e-3, .heading_step = 1e-3};
    for (const snug::Car& car : snug::catalogue()) {
        const std::vector<double> widths = {car.width() + 0.25, car.width() + 0.4};
        const std::vector<int> counts = {1, 4};
        const auto loop = snug::min_slots_by_stepping(car, widths, counts, coarse, 0.02);
        const auto exact = snug::min_slots(car, widths, counts);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            if (!loop[i].length) continue;
            ASSERT_TRUE(exact[i].length);
            EXPECT_GT(*loop[i].length, *exact[i].length) << car.name() << ' ' << *exact[i].width;
        }
    }
}

TEST(MinSlot, ValuesOfTheTheoryNotes) {
    // Extra length in a slot 0.6 m wider than the car.
    const auto extra = [](const char* name, int changes) {
        const snug::Car car = *snug::find_car(name);
        snug::MinSlotOptions options;
        options.max_changes = changes;
        return *min_slot(car, car.width() + 0.6, options).length - car.length();
    };
    constexpr double millimetre = 1e-3;
    EXPECT_NEAR(extra("renault-zoe", 20), 0.4094, millimetre);
    EXPECT_NEAR(extra("renault-zoe", 30), 0.3918, millimetre);
    EXPECT_NEAR(extra("renault-zoe", 100), 0.3713, millimetre);
    EXPECT_NEAR(extra("opel-corsa", 10), 0.3981, millimetre);
    EXPECT_NEAR(extra("vw-transporter", 20), 0.4001, millimetre);
    EXPECT_NEAR(extra("vw-transporter", 30), 0.3791, millimetre);
    EXPECT_NEAR(extra("mercedes-amg-gt", 100), 0.4011, millimetre);
}

}  // namespace
}  // namespace oracle
