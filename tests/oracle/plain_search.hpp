// A plain search over (x, y, heading) for the fewest direction changes, which knows nothing of dominance or lattices.
#pragma once

#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "random_cases.hpp"

namespace oracle {

/// Drives out of the slot, breadth first by direction changes; backward in time that is parking with as many. Each cell of
/// a grid keeps the first real position that reached it, so what is found is a maneuver that can be driven, and as cells
/// keep but one, it need not be the best.
class PlainSearch {
public:
    PlainSearch(const Case& asked, int most_changes)
        : problem_(make_problem<double>(asked)),
          most_changes_(most_changes),
          length_(asked.car_length()),
          cell_(0.01 * length_),
          turn_(0.7 * cell_ / problem_.radius),
          columns_(whole((asked.slot.length + length_) / cell_)),
          rows_(whole((asked.slot.width + length_) / cell_)),
          headings_(whole(2 * steepest / turn_)) {
        for (const double part : {0.0, 1.0, -1.0, 0.5, -0.5}) {
            const double radius = part == 0 ? std::numeric_limits<double>::infinity()
                                            : asked.car.wheelbase / std::tan(part * asked.car.max_steer);
            double swing = 1.0;
            if (part != 0)
                for (const Polygon<double>* polygon : {&problem_.body, &problem_.at_curb})
                    for (const Vec<double>& p : polygon->corners)
                        swing = std::max(swing, length(p - Vec<double>{0, radius}) / std::abs(radius));
            ways_.push_back({radius, swing});
        }
        for (auto& seen : seen_) seen.resize(columns_ * rows_ * headings_);
    }

    /// The fewest direction changes it can demonstrate, the last move going forward.
    std::optional<int> changes() {
        std::vector<std::size_t> forward = park(), backward = forward;
        for (int changes = 0; changes <= most_changes_; ++changes) {
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

    /// A turning radius, and how many metres the point that moves most moves per metre.
    struct Way {
        double radius, swing;
    };

    static std::size_t whole(double number) { return std::size_t(std::ceil(number)) + 1; }

    /// Parked positions, from end to end of all there are.
    std::vector<std::size_t> park() {
        constexpr int steps = 12;
        const double tiny = 1e-3 * length_, steep = std::min(steepest, problem_.parked_heading);
        std::vector<std::size_t> parked;
        for (double heading = -std::floor(steep / turn_) * turn_; heading <= steep; heading += turn_) {
            const Reach car = reach(problem_.car, heading), body = reach(problem_.body, heading);
            const Reach at_curb = reach(problem_.at_curb, heading);
            // Where a neighbour begins deeper the body may stand over its corner; whether it does is asked of each place.
            const double x_min = -problem_.length - (problem_.rear_setback > 0 ? car : body).left + tiny;
            const double x_max = -(problem_.front_setback > 0 ? car : body).right - tiny;
            const double y_min = -problem_.width - at_curb.low + tiny;
            const double y_max = std::min(-car.top, problem_.parked_curb - problem_.width - car.low);
            if (x_min > x_max || y_min > y_max) continue;
            for (int i = 0; i <= steps; ++i) {
                for (int j = 0; j <= steps; ++j) {
                    const double x = x_min + (x_max - x_min) * i / steps, y = y_max + (y_min - y_max) * j / steps;
                    if (gap_at({x, y, heading}) < 0) continue;
                    parked.push_back(reached_.size());
                    reached_.push_back({{x, y, heading}, none, 0, 0});
                }
            }
        }
        return parked;
    }

    struct Reach {
        double top, low, left, right;
    };
    static Reach reach(const Polygon<double>& polygon, double heading) {
        Reach r{-1e300, 1e300, 1e300, -1e300};
        for (const Vec<double>& p : at(polygon, {0, 0, heading})) {
            r.top = std::max(r.top, p.y), r.low = std::min(r.low, p.y);
            r.left = std::min(r.left, p.x), r.right = std::max(r.right, p.x);
        }
        return r;
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
            for (const auto& [radius, swing] : ways_) {
                const Path<double> path{place, radius, direction};
                const Place<double> end = path.at(step());
                if (!is_free(path, swing, 0, step(), gap_at(place), gap_at(end)) || !is_new(seen, end)) continue;
                places.push_back(reached_.size());
                reached_.push_back({end, from, radius, direction});
            }
        }
        return false;
    }

    double step() const { return 1.5 * cell_; }

    bool is_new(std::vector<char>& seen, const Place<double>& place) const {
        const double column = (place.x + problem_.length + 0.4 * length_) / cell_;
        const double row = (place.y + problem_.width) / cell_;
        const double heading = (place.heading + steepest) / turn_;
        if (!(column >= 0 && column < double(columns_) && row >= 0 && row < double(rows_) && heading >= 0 &&
              heading < double(headings_)))
            return false;
        char& cell = seen[(std::size_t(heading) * rows_ + std::size_t(row)) * columns_ + std::size_t(column)];
        return std::exchange(cell, 1) == 0;
    }

    /// How far the frame is at least from everything; negative when it overlaps.
    double gap_at(const Place<double>& place) const { return -depth(problem_, place); }

    /// Nothing is met on the way when both ends are further away than any point of the frame travels; else halves are asked.
    bool is_free(const Path<double>& path, double swing, double from, double to, double gap_from, double gap_to) const {
        if (gap_from < 0 || gap_to < 0) return false;
        if (gap_from + gap_to >= swing * (to - from)) return true;
        if (to - from < 2e-4 * length_) return false;
        const double middle = (from + to) / 2, gap_middle = gap_at(path.at(middle));
        return is_free(path, swing, from, middle, gap_from, gap_middle) &&
               is_free(path, swing, middle, to, gap_middle, gap_to);
    }

    /// Nose up and straight on until it is wholly on the road, where nothing is in the way.
    bool gets_out(const Place<double>& place) const {
        const Reach body = reach(problem_.body, place.heading), at_curb = reach(problem_.at_curb, place.heading);
        if (place.heading < turn_ || place.x + body.right < 0) return false;
        const double low = place.y + std::min(body.low, at_curb.low);
        const Path<double> path{place, std::numeric_limits<double>::infinity(), 1};
        const double distance = std::max(0.0, -low / std::sin(place.heading));
        return is_free(path, 1.0, 0, distance, gap_at(place), gap_at(path.at(distance)));
    }

    Problem<double> problem_;
    int most_changes_;
    double length_, cell_, turn_;
    std::size_t columns_, rows_, headings_;
    std::vector<Way> ways_;
    std::vector<char> seen_[2];
    std::vector<Reached> reached_;
    std::size_t out_ = none;
};

}  // namespace oracle
