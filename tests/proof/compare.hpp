// What the prover says, held against code that shares nothing with it: the oracle, driven at many headings, at every
// change of what is met, and towards every place where a move comes nearest to parking.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "full_steering/proof/proof.hpp"
#include "oracle/random_cases.hpp"
#include "oracle/random_outlines.hpp"

namespace oracle {

using snug::detail::ProvedRanges;

inline snug::detail::ProofProblem proof_problem_of(const Case& asked) {
    return snug::detail::proof_problem(asked.made_car(), asked.made_slot(), asked.driving, asked.parked);
}

class Compare {
public:
    Compare(const Case& asked, const ProvedRanges& proved, int limit)
        : asked_(asked),
          proved_(proved),
          limit_(limit),
          fast_(make_problem<double>(asked)),
          fine_(make_problem<long double>(asked)) {}

    /// At `samples` headings, and between them wherever the itinerary changes.
    void sample(int samples, double offset) {
        Sample here = look(0.0);
        for (int i = 0; i < samples; ++i) {
            const Sample after = look(std::numbers::pi / 2 * (i + offset) / samples);
            if (after.itinerary != here.itinerary) refine(here, after, 0);
            here = after;
        }
        for (const auto& range : proved_.ranges) {
            for (const double part : {0.0, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999, 1.0})
                look(range.min + part * (range.max - range.min));
            for (const double away : {1e-10, 1e-9, 1e-8, 1e-6}) look(range.min - away), look(range.max + away);
        }
    }

    /// Golden section from each of `samples` headings towards where it comes nearest to parking.
    void dips(int samples) {
        double heading = 0.0;
        std::vector<std::pair<double, double>> all;
        for (int i = 0; i <= samples; ++i, heading = 1.2 * i / samples) all.emplace_back(heading, least(heading));
        for (std::size_t i = 1; i + 1 < all.size(); ++i) {
            if (!(all[i].second <= all[i - 1].second && all[i].second <= all[i + 1].second && all[i].second < 0.05))
                continue;
            double a = all[i - 1].first, b = all[i + 1].first, x = all[i].first, fx = all[i].second;
            for (int k = 0; k < 45 && b - a > 1e-13 && fx > 0; ++k) {
                const bool right = b - x > x - a;
                const double u = right ? x + 0.381966 * (b - x) : x - 0.381966 * (x - a);
                look(u);
                const double fu = least(u);
                if (fu < fx) {
                    (right ? a : b) = x;
                    x = u, fx = fu;
                } else {
                    (right ? b : a) = u;
                }
            }
        }
    }

    /// One heading that some other search reports.
    void try_heading(double heading) { look(heading); }

    std::vector<std::string> failures;
    long looked = 0;
    long undecided = 0;
    long turned_away = 0;

private:
    struct Sample {
        double heading = 0;
        std::uint64_t itinerary = 0;
    };

    /// A car that comes to be parked more than a quarter turn off parallel has turned away.
    template <class Real>
    int count(const Run<Real>& run) {
        if (!run.parked()) return -1;
        const double sign = asked_.driving.enter == snug::Enter::backward ? 1.0 : -1.0;
        const Leg<Real>& last = run.legs.back();
        if (sign * double(last.path.at(last.length).heading) < -std::numbers::pi / 2) {
            ++turned_away;
            return -1;
        }
        return run.changes;
    }

    int reported(double heading) const {
        for (const auto& range : proved_.ranges)
            if (range.min <= heading && heading <= range.max) return range.changes;
        return -1;
    }
    /// In a sliver, at the end of a range (the radius of the circle was rounded before the proof began), or where the first
    /// move begins so nearly across the neighbour's side that the oracle forgives it.
    bool left_out(double heading) const {
        for (const auto& range : proved_.ranges)
            if (std::abs(heading - range.min) < 1e-11 || std::abs(heading - range.max) < 1e-11) return true;
        const Vec<double> corner = touching_corner(fast_);
        const double x = std::abs(corner.x), y = corner.y - fast_.radius;
        const double inward = x * std::sin(heading) + y * std::cos(heading);
        if (inward * inward < 4e-12 * std::hypot(x, y)) return true;  // 2e-12 m deep
        for (const auto& sliver : proved_.undecided)
            if (sliver.min - 1e-15 <= heading && heading <= sliver.max + 1e-15) return true;
        return false;
    }

    double least(double heading) {
        run(fast_, heading, limit_, run_, Look::at_depths_too);
        return run_.parked() ? -1.0 : run_.least();
    }

    Sample look(double heading) {
        heading = std::clamp(heading, 0.0, std::numbers::pi / 2);
        ++looked;
        run(fast_, heading, limit_, run_);
        const Sample sample{heading, run_.itinerary * 8 + std::uint64_t(run_.outcome)};
        const int quick = count(run_);
        if (quick == reported(heading) || left_out(heading)) return sample;
        const int right = count(run(fine_, (long double)(heading), limit_));
        if (right == reported(heading)) return sample;
        // What the oracle forgives as rounding, the proof takes at its word: an inward start that only just touches.
        Problem<long double> forgiving = fine_;
        forgiving.forgiven = 1e-11L;
        Problem<long double> strict = fine_;
        strict.forgiven = 1e-17L;
        const bool brink = count(run(forgiving, (long double)(heading), limit_)) == reported(heading) ||
                           count(run(strict, (long double)(heading), limit_)) == reported(heading);
        if (brink || (reported(heading) < 0 && stuck_beside(fine_, (long double)(heading), limit_)) ||
            dips_unseen(heading) || !decide(fine_, heading, limit_, 1e-13L).certain) {
            ++undecided;
            return sample;
        }
        if (failures.size() < 5) {
            std::ostringstream out;
            out.precision(17);
            out << "heading " << heading << " needs " << right << " but is reported as " << reported(heading)
                << " (limit " << limit_ << ") in " << command_line(asked_);
            failures.push_back(out.str());
        }
        return sample;
    }

    /// The oracle goes in steps, and may step over a dip of some 1e-12 m: nested thirds find it.
    bool dips_unseen(double heading) {
        const int at = reported(heading);
        const Run<long double> fine = run(fine_, (long double)(heading), limit_);
        if (at < 0 || std::size_t(at) >= fine.legs.size()) return false;
        const Leg<long double>& leg = fine.legs[std::size_t(at)];
        const auto missing = [&](long double distance) { return short_of_parked(fine_, leg.path.at(distance)); };
        constexpr int steps = 2000;
        int least = 0;
        for (int i = 1; i <= steps; ++i)
            if (missing(leg.length * i / steps) < missing(leg.length * least / steps)) least = i;
        long double low = leg.length * std::max(least - 1, 0) / steps;
        long double high = leg.length * std::min(least + 1, steps) / steps;
        for (int i = 0; i < 100; ++i) {
            const long double third = (high - low) / 3;
            if (missing(low + third) < missing(high - third)) {
                high -= third;
            } else {
                low += third;
            }
        }
        return missing(low) <= 0;
    }

    void refine(const Sample& low, const Sample& high, int level) {
        if (high.heading - low.heading < 1e-13 || level > 40 || refined_ > 1500) return;
        ++refined_;
        const Sample middle = look((low.heading + high.heading) / 2);
        if (middle.itinerary != low.itinerary) refine(low, middle, level + 1);
        if (middle.itinerary != high.itinerary) refine(middle, high, level + 1);
    }

    const Case& asked_;
    const ProvedRanges& proved_;
    int limit_;
    Problem<double> fast_;
    Problem<long double> fine_;
    Run<double> run_;
    long refined_ = 0;
};

}  // namespace oracle
