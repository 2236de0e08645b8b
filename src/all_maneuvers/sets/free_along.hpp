// Where solids stop the car, and what they leave free, at many x: in vectors.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "all_maneuvers/sets/chart.hpp"
#include "all_maneuvers/sets/outer_sets.hpp"

namespace snug::detail::sets {

/// A band at many x in rising order. Its memory is used again.
class BandAlong {
public:
    void measure(const Band& band, std::span<const double> x);
    /// At the i-th of them; low > high where there is nothing.
    [[nodiscard]] Interval at(std::size_t i) const { return {low_[i], high_[i]}; }
    [[nodiscard]] const std::vector<double>& low() const { return low_; }
    [[nodiscard]] const std::vector<double>& high() const { return high_; }

private:
    std::vector<double> low_, high_;
};

/// What solids leave free of a region at many x. Its memory is used again.
class FreeAlong {
public:
    void measure(const Band& region, const std::vector<Band>& solids, std::span<const double> x);
    /// Of an interval at the i-th of them, in rising order.
    void at(std::size_t i, const Interval& within, std::vector<Interval>& gaps);

private:
    BandAlong region_;
    std::vector<BandAlong> solids_;  ///< the first `count` of them
    std::size_t count_ = 0;
    std::vector<double> low_, high_;  ///< where solids only reach into the region from below and above: what they leave
    std::vector<double> lies_within_;  ///< not 0 where any lies within
    std::vector<Interval> taken_;
};

}  // namespace snug::detail::sets
