// A plain search over (x, y, heading), which knows nothing of dominance or lattices, never beats the claimed optimum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "oracle/random_cases.hpp"
#include "sample.hpp"
#include "snug/fewest.hpp"

namespace {

using oracle::Case;
using oracle::Path;
using oracle::Place;

constexpr int most_changes = 5;

/// Drives out of the slot, breadth first by direction changes; backward in time that is parking with as many. Each cell of
/// a grid keeps the first real position that reached it, so what is found is a maneuver that can be driven, and as cells
/// keep but one, it need not be the best.
class PlainSearch {
public:
    explicit PlainSearch(const Case& asked)
        : problem_(
              oracle::make_problem<double>(asked.car, asked.slot.length, asked.slot.width, asked.driving.clearance)),
          length_(asked.car_length()),
          cell_(0.01 * length_),
          turn_(0.7 * cell_ / problem_.radius),
          columns_(whole((asked.slot.length + length_) / cell_)),
          rows_(whole((asked.slot.width + length_) / cell_)),
          headings_(whole(2 * steepest / turn_)) {
        for (const double part : {0.0, 1.0, -1.0, 0.5, -0.5}) {
            radii_.push_back(part == 0 ? std::numeric_limits<double>::infinity()
                                       : asked.car.wheelbase / std::tan(part * asked.car.max_steer));
        }
        for (auto& seen : seen_) seen.resize(columns_ * rows_ * headings_);
    }

    /// The fewest direction changes it can demonstrate, the last move going forward.
    std::optional<int> changes() {
        std::vector<std::size_t> forward = park(), backward = forward;
        for (int changes = 0; changes <= most_changes; ++changes) {
            if (drive(forward, 1)) return changes;
            drive(backward, -1);
            std::swap(forward, backward);
        }
        return std::nullopt;
    }

    /// The way out, position by position.
    std::string way_out() const {
        std::ostringstream text;
        text.precision(17);
        for (std::size_t i = out_; i != none; i = reached_[i].from) {
            const auto& [place, from, radius, direction] = reached_[i];
            text << "  at " << place.x << ' ' << place.y << ' ' << place.heading << ", come "
                 << (direction > 0 ? "forward" : "backward") << " with radius " << radius << '\n';
        }
        return text.str();
    }

private:
    static constexpr double steepest = 1.3;
    static constexpr std::size_t none = ~std::size_t(0);

    struct Reached {
        Place<double> place;
        std::size_t from;
        double radius;
        int direction;
    };

    static std::size_t whole(double number) { return std::size_t(std::ceil(number)) + 1; }

    /// Positions inside the slot, from end to end of all there are.
    std::vector<std::size_t> park() {
        constexpr int steps = 12;
        const double tiny = 1e-3 * length_;
        std::vector<std::size_t> parked;
        for (double heading = -std::floor(steepest / turn_) * turn_; heading < steepest; heading += turn_) {
            double top = 0, low = 0, left = 0, right = 0;
            for (const auto& p : oracle::corners_at(problem_.car, {0, 0, heading})) top = std::max(top, p.y);
            for (const auto& p : oracle::corners_at(problem_.grown, {0, 0, heading})) {
                low = std::min(low, p.y);
                left = std::min(left, p.x), right = std::max(right, p.x);
            }
            const double x_min = -problem_.gap.length - left + tiny, x_max = -right - tiny;
            const double y_min = -problem_.gap.width - low + tiny, y_max = -top;
            if (x_min > x_max || y_min > y_max) continue;
            for (int i = 0; i <= steps; ++i) {
                for (int j = 0; j <= steps; ++j) {
                    parked.push_back(reached_.size());
                    const double x = x_min + (x_max - x_min) * i / steps, y = y_max + (y_min - y_max) * j / steps;
                    reached_.push_back({{x, y, heading}, none, 0, 0});
                }
            }
        }
        return parked;
    }

    /// Everything one move reaches from `places`, which it is added to. True: the car is out.
    bool drive(std::vector<std::size_t>& places, int direction) {
        std::vector<char>& seen = seen_[direction > 0];
        std::erase_if(places, [&](std::size_t i) { return !is_new(seen, reached_[i].place); });
        for (std::size_t next = 0; next < places.size(); ++next) {
            const std::size_t from = places[next];
            const Place<double> place = reached_[from].place;
            if (direction > 0 && gets_out(place)) {
                out_ = from;
                return true;
            }
            for (const double radius : radii_) {
                const Path<double> path{place, radius, direction};
                const Place<double> end = path.at(step());
                if (!is_free(path, 0, step(), gap_at(place), gap_at(end)) || !is_new(seen, end)) continue;
                places.push_back(reached_.size());
                reached_.push_back({end, from, radius, direction});
            }
        }
        return false;
    }

    double step() const { return 1.5 * cell_; }

    bool is_new(std::vector<char>& seen, const Place<double>& place) const {
        const double column = (place.x + problem_.gap.length + 0.4 * length_) / cell_;
        const double row = (place.y + problem_.gap.width) / cell_;
        const double heading = (place.heading + steepest) / turn_;
        if (!(column >= 0 && column < double(columns_) && row >= 0 && row < double(rows_) && heading >= 0 &&
              heading < double(headings_)))
            return false;
        char& cell = seen[(std::size_t(heading) * rows_ + std::size_t(row)) * columns_ + std::size_t(column)];
        return std::exchange(cell, 1) == 0;
    }

    /// How far the frame is at least from everything; negative when it overlaps.
    double gap_at(const Place<double>& place) const { return -oracle::depth(problem_.grown, place, problem_.gap); }

    /// Nothing is met on the way when both ends are further away than any point of the frame travels; else halves are asked.
    bool is_free(const Path<double>& path, double from, double to, double gap_from, double gap_to) const {
        if (gap_from < 0 || gap_to < 0) return false;
        const double swing = path.straight() ? 1.0
                                             : std::hypot(std::max(problem_.grown.front, problem_.grown.rear),
                                                          std::abs(path.radius) + problem_.grown.side) /
                                                   std::abs(path.radius);
        if (gap_from + gap_to >= swing * (to - from)) return true;
        if (to - from < 2e-4 * length_) return false;
        const double middle = (from + to) / 2, gap_middle = gap_at(path.at(middle));
        return is_free(path, from, middle, gap_from, gap_middle) && is_free(path, middle, to, gap_middle, gap_to);
    }

    /// Nose up and straight on until it is wholly on the road, where nothing is in the way.
    bool gets_out(const Place<double>& place) const {
        if (place.heading < turn_ || oracle::corners_at(problem_.grown, place)[3].x < 0) return false;
        double low = 0;
        for (const auto& p : oracle::corners_at(problem_.grown, place)) low = std::min(low, p.y);
        const Path<double> path{place, std::numeric_limits<double>::infinity(), 1};
        const double distance = -low / std::sin(place.heading);
        return is_free(path, 0, distance, gap_at(place), gap_at(path.at(distance)));
    }

    oracle::Problem<double> problem_;
    double length_, cell_, turn_;
    std::size_t columns_, rows_, headings_;
    std::vector<double> radii_;
    std::vector<char> seen_[2];
    std::vector<Reached> reached_;
    std::size_t out_ = none;
};

/// Cars of all kinds, in slots most of which need few changes.
Case coarse_case(std::uint64_t index) {
    oracle::Random random(41 * 0x9E3779B97F4A7C15ULL + index * 0xBF58476D1CE4E5B9ULL);
    Case chosen;
    choose_car(random, chosen);
    if (random.chance(0.2)) chosen.driving.clearance = random.between(0.005, 0.1);
    chosen.slot.length = chosen.car_length() * random.between(1.06, 1.4) + 2 * chosen.driving.clearance;
    chosen.slot.width = chosen.car.width * random.between(1.03, 1.35) + chosen.driving.clearance;
    return chosen;
}

TEST(PlainSearch, NeverBeatsTheClaimedOptimumAndOftenComesWithinOneChange) {
    const int count = snug::test::sample(40, 1000);
    int easy = 0, close = 0;
    for (int i = 0; i < count; ++i) {
        const Case asked = coarse_case(std::uint64_t(i));
        SCOPED_TRACE("case " + std::to_string(i) + ": " + oracle::command_line(asked));
        snug::FewestOptions options;
        options.max_changes = most_changes;
        options.driving.clearance = asked.driving.clearance;
        options.resolution = 1e-3 * asked.car_length();
        options.roomiest = false;
        const snug::Answer claimed = fewest(snug::Car(asked.car), snug::Slot(asked.slot), options);
        PlainSearch search(asked);
        const std::optional<int> found = search.changes();
        // Where the optimum is proved, this bound is it; a bound above what is allowed says that the car cannot park.
        if (found) {
            EXPECT_GE(*found, claimed.lower_bound) << "the way out, backward in time:\n" << search.way_out();
        }
        if (claimed.proved && claimed.lower_bound <= 3) {
            ++easy;
            if (found && *found <= claimed.lower_bound + 1) ++close;
        }
    }
    // A search that finds nothing proves nothing. It is nine of ten; a small sample says little.
    if (easy >= 10) {
        EXPECT_GE(close, easy * 3 / 4) << "of " << easy;
    }
}

}  // namespace
