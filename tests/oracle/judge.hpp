// Judges one answer to Problems 1 and 2 with the oracle: every heading sampled, every range entered, every maneuver
// followed. Shares nothing with the solver but the types it answers with.
#pragma once

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "follower.hpp"

namespace oracle {

/// What was looked at and what was wrong.
struct Verdict {
    std::vector<std::string> failures;
    long samples = 0;          // strategies driven in double, to screen
    long decided = 0;          // and in long double, where the screening disagreed
    long edges = 0;            // edges of reported ranges
    long undecided_edges = 0;  // of them those within 1e-12 of another outcome and off by that
    long undecided = 0;        // other headings so
    long dips = 0;             // places where the depth was minimised
    bool parkable = false;
    double thinnest = 10;    // the thinnest reported subrange
    bool only_thin = false;  // no best subrange is wider than the paper's sampling of 1e-4 rad

    Verdict& operator+=(const Verdict& other) {
        failures.insert(failures.end(), other.failures.begin(), other.failures.end());
        samples += other.samples;
        decided += other.decided;
        edges += other.edges;
        undecided_edges += other.undecided_edges;
        undecided += other.undecided;
        dips += other.dips;
        return *this;
    }
};

struct JudgeOptions {
    bool prove = false;           // else the search alone is judged, and the proof in tests/proof
    double heading_step = 1e-5;   // [rad]
    int unparkable_changes = 40;  // changes tried at every sample of a slot the solver calls too small; 200 at some
};

namespace judging {

using Fine = long double;

constexpr double edge_error = 1e-12;  // headings this close to a reported edge may go either way [rad]

template <class... Words>
std::string sentence(const Words&... words) {
    std::ostringstream out;
    out.precision(17);
    (out << ... << words);
    return out.str();
}

/// One sampled heading: its count (-1 when it does not park in time), and for each move what was met up to it and how
/// far from parked the car was.
struct Sample {
    double heading = 0;
    int count = -1;
    struct Step {
        std::uint64_t itinerary;
        double height;
    };
    std::vector<Step> steps;
    std::uint64_t itinerary = 0;
};

class Judge {
public:
    Judge(const Case& asked, std::uint64_t seed, const JudgeOptions& options)
        : asked_(asked),
          options_(options),
          random_(seed),
          fast_(make_problem<double>(asked)),
          fine_(make_problem<Fine>(asked)) {}

    Verdict operator()() {
        const snug::Car car = asked_.made_car();
        const snug::Slot slot = asked_.made_slot();
        snug::EntryOptions problem1;
        problem1.prove = options_.prove;
        problem1.driving = asked_.driving;
        problem1.parked = asked_.parked;
        const snug::Answer best = snug::entry(car, slot, problem1);
        snug::EntryOptions problem2 = problem1;
        problem2.max_changes =
            best.direction_changes ? *best.direction_changes + asked_.more_changes : options_.unparkable_changes;
        const snug::Answer all = snug::entry(car, slot, problem2);

        verdict_.parkable = best.parkable();
        if (best.parkable() != best.direction_changes.has_value() || best.parkable() != best.maneuver.has_value() ||
            best.parkable() != !best.ranges.empty())
            fail("Problem 1 contradicts itself: parkable ", best.parkable(), " with ", best.ranges.size(), " ranges");
        if (best.parkable() != all.parkable() || best.direction_changes != all.direction_changes)
            fail("Problems 1 and 2 differ in the fewest changes");
        ranges_ = all.ranges;
        undecided_ = all.undecided;
        limit_ = *problem2.max_changes;
        check_form(best.ranges, best, best.direction_changes.value_or(0));
        check_form(all.ranges, all, limit_);
        check_same_best(best);
        sample_headings();
        for (const snug::HeadingRange& range : ranges_) enter(range);
        for (const snug::Answer* answer : {&best, &all})
            if (answer->maneuver && answer->direction_changes) check_maneuver(*answer);
        if (!best.parkable()) try_hard();
        if (best.parkable()) check_min_range(car, slot, problem2);
        return std::move(verdict_);
    }

private:
    template <class... Words>
    void fail(const Words&... words) {
        if (verdict_.failures.size() < 5) verdict_.failures.push_back(sentence(words...));
    }

    // Rising, each within [0, pi/2], as wide as can be, subranges numbered by touching.
    void check_form(const std::vector<snug::HeadingRange>& ranges, const snug::Answer& answer, int limit) {
        int least = limit + 1;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            const snug::HeadingRange& r = ranges[i];
            least = std::min(least, r.direction_changes);
            if (!(r.min >= 0 && r.min <= r.max && r.max <= std::numbers::pi / 2))
                fail("range ", r.min, " to ", r.max, " is out of order");
            if (r.direction_changes < 0 || r.direction_changes > limit) fail("a range with ", r.direction_changes);
            if (i == 0) continue;
            const snug::HeadingRange& before = ranges[i - 1];
            const double gap = r.min - before.max;
            if (!(gap >= 0)) fail("ranges overlap at ", r.min);
            if ((gap <= 1e-11) != (r.subrange == before.subrange))
                fail("ranges with a gap of ", gap, " have subranges ", before.subrange, " and ", r.subrange);
            if (gap <= 1e-11 && r.direction_changes == before.direction_changes)
                fail("two ranges with ", r.direction_changes, " changes meet at ", r.min);
        }
        if (!ranges.empty() && answer.direction_changes != least)
            fail("the fewest of the ranges is ", least, " but the answer says ", answer.direction_changes.value_or(-1));
    }

    void check_same_best(const snug::Answer& best) {
        std::vector<snug::HeadingRange> again;
        double widest = 0;
        for (const snug::HeadingRange& r : ranges_)
            if (best.direction_changes == r.direction_changes) again.push_back(r);
        bool same = again.size() == best.ranges.size();
        for (std::size_t i = 0; same && i < again.size(); ++i) {
            same = std::abs(again[i].min - best.ranges[i].min) <= 1e-12 &&
                   std::abs(again[i].max - best.ranges[i].max) <= 1e-12;
            widest = std::max(widest, again[i].max - again[i].min);
            verdict_.thinnest = std::min(verdict_.thinnest, again[i].max - again[i].min);
        }
        verdict_.only_thin = best.parkable() && widest < 1e-4;
        if (!same) fail("Problem 1 has ", best.ranges.size(), " best ranges, Problem 2 ", again.size(), " or others");
    }

    /// The count the solver reports for a heading, -1 for none.
    int reported(double heading) const {
        const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), heading,
                                            [](double h, const snug::HeadingRange& r) { return h < r.min; });
        if (after == ranges_.begin()) return -1;
        const snug::HeadingRange& range = *(after - 1);
        return heading <= range.max ? range.direction_changes : -1;
    }

    /// Where the answer claims nothing.
    bool unclaimed(double heading) const {
        for (const snug::Headings& r : undecided_)
            if (heading >= r.min - edge_error && heading <= r.max + edge_error) return true;
        for (const snug::HeadingRange& r : ranges_)
            if (std::abs(heading - r.min) <= edge_error || std::abs(heading - r.max) <= edge_error) return true;
        return false;
    }

    Sample look(double heading, int limit) {
        run(fast_, heading, limit, fast_run_, Look::at_depths_too);
        ++verdict_.samples;
        Sample sample;
        sample.heading = heading;
        sample.count = fast_run_.parked() ? fast_run_.changes : -1;
        sample.steps.reserve(fast_run_.legs.size());
        std::uint64_t itinerary = 0;
        for (const Leg<double>& leg : fast_run_.legs) {
            sample.steps.push_back({itinerary, leg.least});
            itinerary = (itinerary ^ std::uint64_t(leg.met + 2)) * 0x9E3779B97F4A7C15ULL;
        }
        sample.itinerary = fast_run_.itinerary * 8 + std::uint64_t(fast_run_.outcome);
        return sample;
    }

    /// Compares the sampled count with what the solver reports there, in long double where they differ.
    void check(const Sample& sample, const char* found_by) {
        const int expected = reported(sample.heading);
        if (sample.count == expected || unclaimed(sample.heading)) return;
        ++verdict_.decided;
        const Decided exact = decide(fine_, Fine(sample.heading), limit_);
        if (exact.count == expected) return;
        if (!exact.certain || (expected < 0 && stuck_beside(fine_, Fine(sample.heading), limit_))) {
            ++verdict_.undecided;
            return;
        }
        fail("heading ", sample.heading, " (", found_by, ") needs ", exact.count, " changes but is reported as ",
             expected, ", -1 being none up to ", limit_);
    }

    Sample look_and_check(double heading, const char* found_by) {
        Sample sample = look(heading, limit_);
        check(sample, found_by);
        return sample;
    }

    void sample_headings() {
        const double end = std::numbers::pi / 2;
        const double offset = random_.unit();
        Sample before = look_and_check(0, "sampled"), here = before;
        for (double k = 0; (k + offset) * options_.heading_step < end; ++k) {
            Sample after = look_and_check((k + offset) * options_.heading_step, "sampled");
            if (after.itinerary != here.itinerary) refine(here, after, 0);
            for (std::size_t move = 0; move < here.steps.size(); ++move) dip(before, here, after, move);
            before = std::move(here);
            here = std::move(after);
        }
        look_and_check(end, "sampled");
        for (const snug::HeadingRange& r : ranges_)
            for (const double edge : {r.min, r.max})
                for (const double away : {1.5e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6})
                    for (const double heading : {edge - away, edge + away})
                        if (heading >= 0 && heading <= end) look_and_check(heading, "beside an edge");
    }

    /// Between two headings with different itineraries: halves down to where they part, which shows whatever lies
    /// between, and follows the depth from the nearest samples towards the break.
    void refine(const Sample& low, const Sample& high, int level) {
        if (high.heading - low.heading < 1e-12 || level > 40 || refined_ > 30000) return;
        ++refined_;
        const Sample middle = look_and_check((low.heading + high.heading) / 2, "where the itinerary changes");
        if (middle.itinerary != low.itinerary) refine(low, middle, level + 1);
        if (middle.itinerary != high.itinerary) refine(middle, high, level + 1);
        if (middle.itinerary == low.itinerary || middle.itinerary == high.itinerary)
            for (std::size_t move = 0; move < middle.steps.size(); ++move) dip(low, middle, high, move);
    }

    /// Where the height of some move is lowest at the middle of three samples of equal itinerary up to that move:
    /// golden section, to see whether it dips below zero between them.
    void dip(const Sample& low, const Sample& middle, const Sample& high, std::size_t move) {
        if (middle.count >= 0 || verdict_.dips > 3000) return;
        const Sample::Step& here = middle.steps[move];
        if (here.height > 0.02 || here.height <= 0) return;
        const auto not_below = [&](const Sample& other) {
            return move >= other.steps.size() || other.steps[move].itinerary != here.itinerary ||
                   other.steps[move].height >= here.height;
        };
        if (!not_below(low) || !not_below(high)) return;
        ++verdict_.dips;
        const auto height = [&](double heading) {
            const Sample sample = look_and_check(heading, "where the depth dips");
            if (move >= sample.steps.size() || sample.steps[move].itinerary != here.itinerary) return 1e9;
            return sample.steps[move].height;
        };
        constexpr double golden = 0.3819660112501051;
        double a = low.heading, b = high.heading, x = middle.heading, fx = here.height;
        for (int i = 0; i < 40 && b - a > 1e-12; ++i) {
            const bool right = b - x > x - a;
            const double u = right ? x + golden * (b - x) : x - golden * (x - a);
            const double fu = height(u);
            if (fu <= 0) return;  // parked: already compared with the report
            if (fu < fx) {
                (right ? a : b) = x;
                x = u, fx = fu;
            } else {
                (right ? b : a) = u;
            }
        }
    }

    /// Every reported range holds at its edges, in its middle and anywhere else.
    void enter(const snug::HeadingRange& range) {
        const auto count_at = [&](double heading, bool edge) {
            const Decided exact = decide(fine_, Fine(heading), range.direction_changes);
            ++verdict_.decided;
            verdict_.edges += edge;
            if (exact.count == range.direction_changes) return;
            // What lies this close to an edge is a sliver that rounding may decide; both sides round.
            const double inward = heading + (heading == range.min ? edge_error : -edge_error);
            const auto parks_inward = [&] {
                const Run<Fine> other = run(fine_, Fine(inward), range.direction_changes);
                return range.max - range.min < 2 * edge_error ||
                       (other.parked() && other.changes == range.direction_changes);
            };
            if (!exact.certain || (edge && parks_inward())) {
                ++(edge ? verdict_.undecided_edges : verdict_.undecided);
                return;
            }
            fail(edge ? "the edge " : "inside a range, ", heading, " of [", range.min, ", ", range.max, "] needs ",
                 exact.count, " changes, reported ", range.direction_changes);
        };
        count_at(range.min, true);
        count_at(range.max, true);
        count_at(range.min + (range.max - range.min) / 2, false);
        for (int i = 0; i < 5; ++i) count_at(random_.between(range.min, range.max), false);
    }

    void check_maneuver(const snug::Answer& answer) {
        const snug::Maneuver& maneuver = *answer.maneuver;
        for (const std::string& fault : faults(asked_, maneuver, *answer.direction_changes)) fail(fault);
        if (maneuver.moves.empty()) return;
        const double sign = asked_.driving.enter == snug::Enter::backward ? 1.0 : -1.0;
        const double heading = sign * into_slot(asked_.slot, maneuver.moves.front().start).heading;
        double widest = 0;
        for (const snug::HeadingRange& r : answer.ranges)
            if (r.direction_changes == *answer.direction_changes) widest = std::max(widest, r.max - r.min);
        bool in_the_middle = false;
        for (const snug::HeadingRange& r : answer.ranges)
            in_the_middle =
                in_the_middle || (r.direction_changes == *answer.direction_changes && r.max - r.min >= widest - 1e-12 &&
                                  std::abs(heading - (r.min + r.max) / 2) <= 1e-12);
        if (!in_the_middle) fail("the maneuver enters at ", heading, ", not in the middle of a widest best range");

        const Run<Fine> exact = run(fine_, Fine(heading), *answer.direction_changes);
        if (!exact.parked()) return;  // the range itself is judged elsewhere
        const Leg<Fine>& last = exact.legs.back();
        const Fine most = 2 * std::numbers::pi_v<Fine> * fine_.radius;
        const Path<Fine> inside{last.path.at(last.length), last.path.radius, last.path.direction};
        const Fine from = Fine(sign) * inside.start.heading;
        const Fine to =
            Fine(sign) * inside.at(last_parked(fine_, inside, std::min(last.contact, most) - last.length)).heading;
        const Fine parallel = from <= 0 ? from : std::max(to, Fine(0));
        const double goal = sign * into_slot(asked_.slot, maneuver.moves.back().end).heading;
        if (std::abs(Fine(goal) - parallel) > 1e-7L)
            fail("the maneuver ends at heading ", goal, " but could at ", double(parallel));
    }

    /// A slot the solver calls too small is tried with all the 200 changes the answer speaks of, more sparsely.
    void try_hard() {
        for (double heading = 1e-4 * random_.unit(); heading < std::numbers::pi / 2; heading += 2e-4) {
            const Sample sample = look(heading, 200);
            if (sample.count < 0) continue;
            const Decided exact = decide(fine_, Fine(heading), 200);
            if (exact.certain && exact.count >= 0)
                fail("called too small, but heading ", heading, " parks with ", exact.count, " changes");
        }
    }

    /// The fewest changes whose headings hold a stretch of a given width, from the ranges already judged.
    void check_min_range(const snug::Car& car, const snug::Slot& slot, snug::EntryOptions options) {
        options.min_range = std::pow(10.0, random_.between(-6.0, -1.5));
        std::optional<int> expected;
        bool close = false;
        for (int count = 0; count <= limit_ && !expected; ++count) {
            double start = -1, end = -1;
            for (const snug::HeadingRange& r : ranges_) {
                if (r.direction_changes > count) continue;
                if (start < 0 || r.min - end > 1e-11) start = r.min;
                end = r.max;
                close = close || std::abs(end - start - options.min_range) < 1e-10;
                if (end - start >= options.min_range) expected = count;
            }
        }
        if (close) return;
        const snug::Answer answer = snug::entry(car, slot, options);
        if (answer.direction_changes != expected)
            fail("with --min-range ", options.min_range, " --max-changes ", limit_, " the fewest is ",
                 answer.direction_changes.value_or(-1), ", expected ", expected.value_or(-1));
    }

    const Case& asked_;
    JudgeOptions options_;
    Random random_;
    Problem<double> fast_;
    Problem<Fine> fine_;
    Run<double> fast_run_;
    std::vector<snug::HeadingRange> ranges_;  // Problem 2
    std::vector<snug::Headings> undecided_;   // what the answer claims nothing of
    int limit_ = 0;
    long refined_ = 0;
    Verdict verdict_;
};

}  // namespace judging

/// Asks the solver about the case and judges what it says.
inline Verdict judge(const Case& asked, std::uint64_t seed, const JudgeOptions& options = {}) {
    return judging::Judge(asked, seed, options)();
}

}  // namespace oracle
