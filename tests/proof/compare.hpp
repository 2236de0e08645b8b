// What the prover says, held against code that shares nothing with it: the plain simulation of tests/oracle, driven at many
// headings, at every change of what is met, and at every place where the depth of some move is least.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "contact/entering.hpp"
#include "full_steering/proof.hpp"
#include "oracle/random_cases.hpp"
#include "oracle/simulation.hpp"

namespace oracle {

using snug::detail::ProvedRanges;

inline snug::detail::ProofProblem proof_problem_of(const Case& asked) {
    return snug::detail::proof_problem(snug::detail::entering_problem(
        snug::Car(asked.car, ""), snug::Slot({asked.slot.length, asked.slot.width}), asked.enter, asked.clearance));
}

/// Headings sampled by the plain simulation and compared with ranges.
class Compare {
public:
    Compare(const Case& asked, const ProvedRanges& proved, int limit)
        : asked_(asked),
          proved_(proved),
          limit_(limit),
          fast_(make_problem<double>(asked.car, asked.slot.length, asked.slot.width, asked.clearance, asked.enter)),
          fine_(make_problem<long double>(asked.car, asked.slot.length, asked.slot.width, asked.clearance, asked.enter)),
          steepest_(steepest(asked)) {}

    /// At `samples` headings, and between them wherever the itinerary changes and the depth dips.
    void sample(int samples, double offset) {
        Sample here = look(0.0), before = here;
        for (int i = 0; i < samples; ++i) {
            Sample after = look(std::numbers::pi / 2 * (i + offset) / samples);
            if (after.itinerary != here.itinerary) refine(here, after, 0);
            for (std::size_t move = 0; move < here.steps.size(); ++move) dip(before, here, after, move);
            before = std::move(here);
            here = std::move(after);
        }
        for (const auto& range : proved_.ranges) {
            const double width = range.max - range.min;
            for (const double part : {0.0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.0}) look(range.min + part * width);
            for (const double away : {1e-10, 1e-9, 1e-8, 1e-6}) look(range.min - away), look(range.max + away);
        }
    }
    /// One heading that some other search reports.
    void try_heading(double heading) { look(heading); }

    std::vector<std::string> failures;
    long looked = 0;
    long undecided = 0;

private:
    struct Sample {
        double heading = 0;
        int count = -1;
        std::vector<std::pair<std::uint64_t, double>> steps;
        std::uint64_t itinerary = 0;
    };

    /// The steepest heading at which the frame fits: a car at rest below it has turned away (proof.cpp).
    static double steepest(const Case& asked) {
        const double length = asked.car.front + asked.car.rear;
        if (length <= asked.slot.width) return std::numeric_limits<double>::infinity();
        const auto height = [&](double h) { return length * std::sin(h) + asked.car.width * std::cos(h); };
        double low = 0, high = std::atan2(length, asked.car.width);
        if (height(high) <= asked.slot.width) return std::numeric_limits<double>::infinity();
        for (int i = 0; i < 100; ++i) {
            const double middle = (low + high) / 2;
            (height(middle) <= asked.slot.width ? low : high) = middle;
        }
        return low + 1e-9;
    }

    template <class Real>
    int count(const Run<Real>& run) const {
        if (!run.parked()) return -1;
        const double sign = asked_.enter == snug::Enter::backward ? 1.0 : -1.0;
        for (std::size_t i = 0; i + 1 < run.legs.size(); ++i)
            if (sign * double(run.legs[i].path.at(run.legs[i].length).heading) < -steepest_) return -1;
        return run.changes;
    }

    int reported(double heading) const {
        for (const auto& range : proved_.ranges)
            if (range.min <= heading && heading <= range.max) return range.changes;
        return -1;
    }
    bool left_out(double heading) const {
        for (const auto& sliver : proved_.undecided)
            if (sliver.min - 1e-15 <= heading && heading <= sliver.max + 1e-15) return true;
        return false;
    }

    Sample look(double heading) {
        heading = std::clamp(heading, 0.0, std::numbers::pi / 2);
        ++looked;
        run(fast_, heading, limit_, run_);
        Sample sample;
        sample.heading = heading;
        sample.count = count(run_);
        std::uint64_t itinerary = 0;
        for (const auto& leg : run_.legs) {
            sample.steps.emplace_back(itinerary, leg.drive.least_top);
            itinerary = (itinerary ^ std::uint64_t(leg.drive.kind + 2)) * 0x9E3779B97F4A7C15ULL;
        }
        sample.itinerary = run_.itinerary * 8 + std::uint64_t(run_.outcome);
        if (sample.count == reported(heading) || left_out(heading)) return sample;
        const Run<long double> exact = run(fine_, (long double)(heading), limit_, true);
        const int right = count(exact);
        if (right == reported(heading)) return sample;
        bool brink = exact.graze < 1e-14L;
        for (const auto& leg : exact.legs) brink = brink || std::abs(leg.drive.least_top) < 1e-14L;
        if (brink) {
            ++undecided;
            return sample;
        }
        if (failures.size() < 5) {
            std::ostringstream out;
            out.precision(17);
            out << "heading " << heading << " needs " << right << " but is reported as " << reported(heading) << " (limit "
                << limit_ << ") graze " << double(exact.graze) << " in " << command_line(asked_);
            failures.push_back(out.str());
        }
        return sample;
    }

    void refine(const Sample& low, const Sample& high, int level) {
        if (high.heading - low.heading < 1e-13 || level > 40 || refined_ > 4000) return;
        ++refined_;
        const Sample middle = look((low.heading + high.heading) / 2);
        if (middle.itinerary != low.itinerary) refine(low, middle, level + 1);
        if (middle.itinerary != high.itinerary) refine(middle, high, level + 1);
        if (middle.itinerary == low.itinerary || middle.itinerary == high.itinerary)
            for (std::size_t move = 0; move < middle.steps.size(); ++move) dip(low, middle, high, move);
    }

    void dip(const Sample& low, const Sample& middle, const Sample& high, std::size_t move) {
        if (middle.count >= 0 || dips_ > 400) return;
        const auto [itinerary, depth] = middle.steps[move];
        if (depth > 0.02 || depth <= 0) return;
        const auto not_below = [&, same = itinerary, least = depth](const Sample& other) {
            return move >= other.steps.size() || other.steps[move].first != same || other.steps[move].second >= least;
        };
        if (!not_below(low) || !not_below(high)) return;
        ++dips_;
        double a = low.heading, b = high.heading, x = middle.heading, fx = depth;
        for (int i = 0; i < 60 && b - a > 1e-13; ++i) {
            const bool right = b - x > x - a;
            const double u = right ? x + 0.381966 * (b - x) : x - 0.381966 * (x - a);
            const Sample sample = look(u);
            const double fu = move < sample.steps.size() && sample.steps[move].first == itinerary
                                  ? sample.steps[move].second
                                  : 1e9;
            if (fu <= 0) return;
            if (fu < fx) {
                (right ? a : b) = x;
                x = u, fx = fu;
            } else {
                (right ? b : a) = u;
            }
        }
    }

    const Case& asked_;
    const ProvedRanges& proved_;
    int limit_;
    Problem<double> fast_;
    Problem<long double> fine_;
    double steepest_;
    Run<double> run_;
    long refined_ = 0;
    long dips_ = 0;
};

}  // namespace oracle
