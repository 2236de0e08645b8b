// A plain search over (x, y, heading), which knows nothing of charts or sets.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

#include "park/judge.hpp"
#include "park/random_places.hpp"

namespace park_test {

/// Breadth first by direction changes. Each cell of a grid keeps the first real pose that reached it, so what is found is a
/// maneuver that can be driven; as cells keep but one, it need not be the best.
class PlainSearch {
public:
    PlainSearch(const Case& asked) : asked_(asked) {}

    /// Changes with which it parks, up to `most`; -1 if it does not.
    int changes(int most) {
        std::vector<Pose> now[2] = {{asked_.start}, {asked_.start}};
        for (int changes = 0; changes <= most; ++changes) {
            std::vector<Pose> reached[2];
            for (const int way : {0, 1}) {
                if (drive(now[way], way, reached[way])) return changes;
            }
            now[0] = std::move(reached[1]);
            now[1] = std::move(reached[0]);
        }
        return -1;
    }

private:
    static constexpr double step = 0.15, cell = 0.1, turn = 0.04;

    [[nodiscard]] std::uint64_t key(const Pose& pose) const {
        const auto number = [](double value) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)) + (1 << 20));
        };
        return number(pose.x / cell) << 42 ^ number(pose.y / cell) << 21 ^ number(pose.heading / turn);
    }

    /// Fills `reached` with all poses of one move from those given. True: one of them is parked.
    bool drive(const std::vector<Pose>& from, int way, std::vector<Pose>& reached) {
        for (const Pose& pose : from)
            if (seen_[way].insert(key(pose)).second) reached.push_back(pose);
        const double most = std::tan(asked_.car.max_steer()) / asked_.car.wheelbase();
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const Pose at = reached[i];
            if (short_of_parked(asked_.car, asked_.place, at) <= 0) return true;
            for (const double part : {1.0, -1.0, 0.0, 0.5, -0.5}) {
                const double curvature = part * most;
                Pose next = at;
                bool free = true;
                // Close enough that nothing worth the name is missed; the judge's depth allows for the rest.
                for (int k = 0; k < 3 && free; ++k) {
                    const double on = (way ? 1.0 : -1.0) * step / 3, turned = on * curvature;
                    next = {next.x + on * std::cos(next.heading + turned / 2) * sinc(turned / 2),
                            next.y + on * std::sin(next.heading + turned / 2) * sinc(turned / 2),
                            next.heading + turned};
                    free = depth_in_place(asked_.car, asked_.place, next) < -1e-3 &&
                           outside_region(asked_.place, next) < 0;
                }
                if (!free || !seen_[way].insert(key(next)).second) continue;
                reached.push_back(next);
                if (reached.size() > 50000) return false;
            }
        }
        return false;
    }
    static double sinc(double x) { return std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x; }

    const Case& asked_;
    std::unordered_set<std::uint64_t> seen_[2];
};

}  // namespace park_test
