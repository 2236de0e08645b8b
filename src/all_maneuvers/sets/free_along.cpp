#include "all_maneuvers/sets/free_along.hpp"

#include <algorithm>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "all_maneuvers/sets/free_along.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Plain loops, which compilers turn into vectors, once for each set of instructions.
HWY_BEFORE_NAMESPACE();
namespace snug::detail::sets::HWY_NAMESPACE {

/// The highest of lines, and the lowest of others.
void bounds_of(const Band& band, const double* HWY_RESTRICT x, double* HWY_RESTRICT low, double* HWY_RESTRICT high,
               std::size_t count) {
    for (const Band::Line& line : band.lower) {
        const double at_0 = line.at_0, slope = line.slope;
        for (std::size_t i = 0; i < count; ++i) {
            const double at = at_0 + slope * x[i];
            low[i] = low[i] < at ? at : low[i];
        }
    }
    for (const Band::Line& line : band.upper) {
        const double at_0 = line.at_0, slope = line.slope;
        for (std::size_t i = 0; i < count; ++i) {
            const double at = at_0 + slope * x[i];
            high[i] = at < high[i] ? at : high[i];
        }
    }
}

/// A solid reaches into a region: what is left is cut, or it is told that it lies within.
void cut_off(const BandAlong& solid, const BandAlong& region, double* HWY_RESTRICT low, double* HWY_RESTRICT high,
             double* HWY_RESTRICT lies_within, std::size_t count) {
    const double *HWY_RESTRICT from = solid.low().data(), *HWY_RESTRICT to = solid.high().data();
    const double *HWY_RESTRICT bottom = region.low().data(), *HWY_RESTRICT top = region.high().data();
    for (std::size_t i = 0; i < count; ++i) {
        const bool touches = (from[i] < to[i]) & (to[i] > bottom[i]) & (from[i] < top[i]);
        const bool from_below = touches & (from[i] < bottom[i]);
        const bool from_above = touches & !from_below & (to[i] > top[i]);
        low[i] = (from_below & (low[i] < to[i])) ? to[i] : low[i];
        high[i] = (from_above & (from[i] < high[i])) ? from[i] : high[i];
        lies_within[i] = (touches & !from_below & !from_above) ? 1.0 : lies_within[i];
    }
}

}  // namespace snug::detail::sets::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail::sets {

HWY_EXPORT(bounds_of);
HWY_EXPORT(cut_off);

void BandAlong::measure(const Band& band, std::span<const double> x) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    const auto begin = std::lower_bound(x.begin(), x.end(), band.from) - x.begin();
    const auto end = std::max(begin, std::upper_bound(x.begin(), x.end(), band.to) - x.begin());
    low_.assign(x.size(), unbounded);
    high_.assign(x.size(), -unbounded);
    if (begin == end) return;
    std::fill(low_.begin() + begin, low_.begin() + end, -unbounded);
    std::fill(high_.begin() + begin, high_.begin() + end, unbounded);
    HWY_DYNAMIC_DISPATCH(bounds_of)
    (band, x.data() + begin, low_.data() + begin, high_.data() + begin, static_cast<std::size_t>(end - begin));
}

void FreeAlong::measure(const Band& region, const std::vector<Band>& solids, std::span<const double> x) {
    region_.measure(region, x);
    low_ = region_.low();
    high_ = region_.high();
    lies_within_.assign(x.size(), 0.0);
    solids_.resize(solids.size());
    count_ = 0;
    for (const Band& band : solids) {
        if (x.empty() || band.to < x.front() || band.from > x.back()) continue;
        BandAlong& solid = solids_[count_++];
        solid.measure(band, x);
        HWY_DYNAMIC_DISPATCH(cut_off)
        (solid, region_, low_.data(), high_.data(), lies_within_.data(), x.size());
    }
}

void FreeAlong::at(std::size_t i, const Interval& within, std::vector<Interval>& gaps) {
    gaps.clear();
    if (lies_within_[i] == 0.0) {
        const Interval gap = {std::max(low_[i], within.low), std::min(high_[i], within.high)};
        if (gap.low <= gap.high) gaps.push_back(gap);
        return;
    }
    const Interval region = region_.at(i);
    const double bottom = std::max(region.low, within.low), top = std::min(region.high, within.high);
    taken_.clear();
    for (std::size_t k = 0; k < count_; ++k) {
        const Interval solid = solids_[k].at(i);
        if (solid.low < solid.high && solid.high > bottom && solid.low < top) taken_.push_back(solid);
    }
    sort_rising(taken_);
    double begin = bottom;
    for (const Interval& solid : taken_) {
        if (solid.low >= begin) gaps.push_back({begin, solid.low});
        begin = std::max(begin, solid.high);
    }
    if (begin <= top) gaps.push_back({begin, top});
}

}  // namespace snug::detail::sets
#endif
