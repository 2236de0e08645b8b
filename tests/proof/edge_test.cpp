// At and around minimum slots, where moves begin and end tangentially: what a single run parks with is what `entry` says of
// its heading, or the heading lies in a sliver.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>
#include <string>

#include "oracle/random_cases.hpp"
#include "sample.hpp"
#include "snug/entry.hpp"
#include "snug/error.hpp"
#include "snug/max_steer.hpp"
#include "snug/min_slot.hpp"

namespace oracle {
namespace {

struct Edge {
    snug::CarDimensions car;
    double length = 0.0;
    double width = 0.0;
};

std::string line(const Edge& at, double heading, int max_changes) {
    std::ostringstream text;
    text.precision(17);
    text << "heading " << heading << " in: snug entry --car-width " << at.car.width << " --front " << at.car.front
         << " --rear " << at.car.rear << " --wheelbase " << at.car.wheelbase << " --max-steer " << at.car.max_steer
         << " (rad) --length " << at.length << " --width " << at.width << " --max-changes " << max_changes;
    return text.str();
}

/// Ends of ranges are not told closer than this.
constexpr double at_an_end = 2e-11;

/// Is the heading one of which `entry` says nothing?
bool left_out(const snug::Answer& answer, double heading) {
    for (const snug::HeadingRange& range : answer.ranges)
        if (std::abs(heading - range.min) < at_an_end || std::abs(heading - range.max) < at_an_end) return true;
    for (const snug::Headings& part : answer.undecided)
        if (part.min - 1e-11 <= heading && heading <= part.max + 1e-11) return true;
    return false;
}

struct Runs {
    int slots = 0;
    long runs = 0, parked = 0;
};

/// One heading, driven: what comes out must be what was said of it.
void compare(const Edge& at, const snug::Answer& answer, double heading, int max_changes, Runs& tally) {
    if (heading < 0.0 || heading > std::numbers::pi / 2 || left_out(answer, heading)) return;
    const snug::MaxSteerRun run = max_steer(snug::Car(at.car), snug::Slot({.length = at.length, .width = at.width}),
                                            heading, {.max_changes = max_changes});
    const int none = -1;
    const int driven = run.outcome == snug::Outcome::parked ? run.maneuver.direction_changes() : none;
    int said = none;
    for (const snug::HeadingRange& range : answer.ranges)
        if (range.min <= heading && heading <= range.max) said = range.direction_changes;
    ++tally.runs;
    tally.parked += driven >= 0;
    // Of more changes than the fewest it says nothing for sure.
    const int claimed = answer.proved ? answer.direction_changes.value_or(max_changes) : none;
    const bool told = said >= 0 || driven <= claimed;
    if (driven == said || !told) return;
    ADD_FAILURE() << "parks with " << driven << ", said to with " << said << ": " << line(at, heading, max_changes);
}

void attack(Random& random, Runs& tally) {
    Edge at;
    at.car.wheelbase = random.between(0.9, 4.0);
    at.car.width = random.between(1.0, 2.5);
    at.car.front = at.car.wheelbase + random.between(0.05, 1.2);
    at.car.rear = random.between(0.05, 2.0);
    at.car.max_steer = random.between(0.3, 1.1);
    const double spare = random.unit();
    at.width = at.car.width * (1.0 + 0.9 * spare * spare);
    snug::MinSlotOptions smallest;
    smallest.max_changes = random.below(12);
    const std::optional<double> length = min_slot(snug::Car(at.car), at.width, smallest).length;
    if (!length) return;
    for (const double more : {0.0, 1e-9, 1e-7, 1e-5, -1e-9, -1e-6}) {
        at.length = *length + more;
        if (at.length < at.car.front + at.car.rear) continue;
        const int limit = smallest.max_changes + 3;
        snug::EntryOptions options;
        options.max_changes = limit;
        const snug::Answer answer =
            entry(snug::Car(at.car), snug::Slot({.length = at.length, .width = at.width}), options);
        ++tally.slots;
        if (more == 0.0) {
            EXPECT_LE(answer.direction_changes.value_or(limit), smallest.max_changes) << line(at, 0.0, limit);
        }
        for (int i = 0; i < 40; ++i) {
            double heading = std::numbers::pi / 2 * random.unit();
            if (!answer.ranges.empty() && random.chance(0.6)) {
                const auto& range = answer.ranges[std::size_t(random.below(int(answer.ranges.size())))];
                const double away = std::pow(10.0, random.between(-11.0, -3.0));
                heading = random.chance(0.5) ? range.min - away : range.max + away;
                if (random.chance(0.3)) heading = random.chance(0.5) ? range.min + away : range.max - away;
            }
            compare(at, answer, heading, limit, tally);
        }
    }
}

TEST(Edges, SingleRunsDoWhatIsSaid) {
    Runs tally;
    const int first = int(snug::test::number("SNUG_FIRST", 0));
    const int slots = int(snug::test::number("SNUG_CASES", std::uint64_t(snug::test::sample(200, 20'000))));
    for (int i = first; i < first + slots && !testing::Test::HasFailure(); ++i) {
        Random random(9400 + std::uint64_t(i) * 0x9E3779B97F4A7C15ULL);
        attack(random, tally);
    }
    std::printf("%d slots, %ld single runs, %ld parked\n", tally.slots, tally.runs, tally.parked);
    EXPECT_GT(tally.parked, tally.runs / 10);
}

/// Where the first headings that are possible at all are those at which a circle is tangent, rounding has every other
/// heading park, in stripes. They are no ranges.
TEST(Edges, StripesOfRoundingAreNoRanges) {
    const struct {
        snug::CarDimensions car;
        snug::SlotDimensions slot;
    } cases[] = {
        {{2.220997077982511, 1.8901495662422323, 0.0872146894671146, 1.0457292964236753, 0.8613816416567168},
         {.length = 2.3046973645015085, .width = 2.403038016007265, .rear_setback = 0.20922948488226975}},
        {{2.081978592425948, 1.8863136349442617, 0.1382991327494229, 1.7235026436946708, 0.7988406650442115},
         {.length = 2.1821458301339893,
          .width = 2.5151978673174042,
          .rear_setback = 0.315384733346005,
          .curb = snug::Curb::low}},
        {{2.4584811920999767, 2.250250511861643, 0.5091910800013556, 1.4037158351831045, 0.5308009363453532},
         {.length = 2.81882106169801, .width = 3.509591869958567, .rear_setback = 0.7168079455730831}},
    };
    Random random(9401);
    int places = 0;
    int wrong = 0;
    for (const auto& one : cases) {
        for (const double more : {-1e-9, -1e-10, 0.0, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6}) {
            snug::SlotDimensions dimensions = one.slot;
            dimensions.length += more;
            const snug::Car car(one.car);
            const snug::Slot slot(dimensions);
            snug::EntryOptions options;
            options.driving.enter = snug::Enter::forward;
            const snug::Answer answer = entry(car, slot, options);
            for (const snug::HeadingRange& range : answer.ranges) {
                for (int i = 0; i < 500; ++i) {
                    const double heading = random.between(range.min, range.max);
                    const snug::MaxSteerRun run = max_steer(
                        car, slot, heading, {.max_changes = range.direction_changes, .driving = options.driving});
                    ++places;
                    if (run.outcome == snug::Outcome::parked &&
                        run.maneuver.direction_changes() == range.direction_changes)
                        continue;
                    ++wrong;
                    if (wrong == 1) std::printf("first: %.17g, %g longer\n", heading, more);
                }
            }
        }
    }
    EXPECT_GT(places, 2'000);
    EXPECT_LE(wrong, places / 200);
}

/// A corner touches the rear side where the circle of the next move is tangent to it: before that the corner leaves the
/// wall, beyond it the car is stuck. The circle reaches the wall by less than rounding, so only its first way tells.
TEST(Edges, ATangentialStartIsStuckWhereItWouldMoveIn) {
    const struct {
        Edge at;
        double max;
    } cases[] = {
        {{{2.4218528028088473, 1.342606240246077, 0.8848640170910943, 1.1112642404200859, 0.9626035972470375},
          4.015315013504922,
          3.270485007997961},
         0.7647660402092942},
        {{{1.9279174832783637, 1.445152402181164, 0.20759302314659983, 1.3290076806527373, 1.0107751165170036},
          3.100951108819115,
          2.2304664242659293},
         0.3449377164279695},
        {{{1.8795354148867773, 1.7651898463423539, 1.102359870442016, 1.2201288024285795, 1.0666665032726859},
          3.8328488673641514,
          3.019875272471461},
         0.6540243561560427},
    };
    for (const auto& one : cases) {
        snug::EntryOptions options;
        options.max_changes = 1;
        const snug::Answer answer =
            entry(snug::Car(one.at.car), snug::Slot({.length = one.at.length, .width = one.at.width}), options);
        ASSERT_EQ(answer.ranges.size(), 1U);
        EXPECT_NEAR(answer.ranges[0].max, one.max, 2e-12);
        Runs tally;
        for (int i = -2000; i < 2000; ++i) compare(one.at, answer, one.max + i * 1e-10 / 3.0, 1, tally);
        EXPECT_GT(tally.parked, 100);
        EXPECT_LT(tally.parked, tally.runs * 2 / 3);
    }
}

/// The front neighbour's corner touches the front edge where it is farthest from the next move's centre: either way it would go
/// in, so the car is stuck. The search had taken rounding for a way out there, and claimed what was left over of its range.
TEST(Edges, ATangentialStartOfACornerOnAnEdgeIsStuck) {
    const Edge at = {
        {2.0656051081568485, 2.138844359110638, 0.6387797093945397, 1.0099549575648203, 0.7779552191592287},
        3.4838812703413926,
        3.738952148122163};
    const snug::Car car(at.car);
    const snug::Slot slot({.length = at.length, .width = at.width});
    for (const double about : {0.6003980913204158, 0.6003980911331, 0.6523632612307})
        for (int i = -1000; i <= 1000; ++i)
            EXPECT_NE(max_steer(car, slot, about + i * 1e-13, {.max_changes = 10}).outcome, snug::Outcome::parked)
                << line(at, about + i * 1e-13, 10);
    snug::EntryOptions options;
    options.max_changes = 10;
    const snug::Answer answer = entry(car, slot, options);
    EXPECT_EQ(answer.direction_changes, 7);
    Runs tally;
    for (const snug::HeadingRange& range : answer.ranges)
        for (int i = 0; i <= 20; ++i) compare(at, answer, range.min + (range.max - range.min) * i / 20.0, 10, tally);
    for (const snug::HeadingRange& range : answer.ranges) {
        const double middle = range.min + 0.5 * (range.max - range.min);
        const snug::MaxSteerRun run = max_steer(car, slot, middle, {.max_changes = 10});
        ASSERT_EQ(run.outcome, snug::Outcome::parked) << line(at, middle, 10);
        EXPECT_EQ(run.maneuver.direction_changes(), range.direction_changes) << line(at, middle, 10);
    }
}

}  // namespace
}  // namespace oracle
