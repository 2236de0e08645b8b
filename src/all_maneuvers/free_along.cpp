#include "all_maneuvers/free_along.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "all_maneuvers/free_along.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace snug::detail::sets::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<double, 8> tag;

/// The highest of lines, or the lowest, at places `begin` to `end`. Whole vectors are written.
template <bool Highest>
void bound_of(const std::vector<Band::Line>& lines, double first_x, double step, double* bound, std::size_t begin,
              std::size_t end) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; i += hn::Lanes(tag)) {
        const auto steps = hn::Iota(tag, static_cast<double>(i));
        const auto x = hn::Add(hn::Set(tag, first_x), hn::Mul(hn::Set(tag, step), steps));
        auto value = hn::Set(tag, Highest ? -unbounded : unbounded);
        for (const Band::Line& line : lines) {
            const auto at = hn::Add(hn::Set(tag, line.at_0), hn::Mul(hn::Set(tag, line.slope), x));
            value = Highest ? hn::Max(value, at) : hn::Min(value, at);
        }
        hn::StoreU(value, tag, bound + i);
    }
}

void bounds_of(const Band& band, double first_x, double step, double* low, double* high, std::size_t begin,
               std::size_t end) {
    bound_of<true>(band.lower, first_x, step, low, begin, end);
    bound_of<false>(band.upper, first_x, step, high, begin, end);
}

/// A solid reaches into a region: what is left is cut, or it is told that it lies within.
void cut_off(const BandAlong& solid, const BandAlong& region, double* low, double* high, double* lies_within,
             std::size_t count) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
        const auto from = hn::LoadU(tag, solid.lows() + i), to = hn::LoadU(tag, solid.highs() + i);
        const auto bottom = hn::LoadU(tag, region.lows() + i), top = hn::LoadU(tag, region.highs() + i);
        const auto touches = hn::And(hn::Lt(from, to), hn::And(hn::Gt(to, bottom), hn::Lt(from, top)));
        const auto from_below = hn::And(touches, hn::Lt(from, bottom));
        const auto from_above = hn::AndNot(from_below, hn::And(touches, hn::Gt(to, top)));
        const auto within = hn::AndNot(hn::Or(from_below, from_above), touches);
        const auto old_low = hn::LoadU(tag, low + i), old_high = hn::LoadU(tag, high + i);
        hn::StoreU(hn::IfThenElse(from_below, hn::Max(old_low, to), old_low), tag, low + i);
        hn::StoreU(hn::IfThenElse(from_above, hn::Min(old_high, from), old_high), tag, high + i);
        hn::StoreU(hn::IfThenElse(within, hn::Set(tag, 1.0), hn::LoadU(tag, lies_within + i)), tag, lies_within + i);
    }
}

}  // namespace snug::detail::sets::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail::sets {

HWY_EXPORT(bounds_of);
HWY_EXPORT(cut_off);

namespace {

constexpr std::size_t lanes_at_most = 8;

}  // namespace

void BandAlong::measure(const Band& band, double first_x, double step, std::size_t count) {
    constexpr double unbounded = std::numeric_limits<double>::infinity();
    low_.resize(count + lanes_at_most);
    high_.resize(count + lanes_at_most);
    const auto x = [&](std::size_t i) { return first_x + step * static_cast<double>(i); };
    const auto index = [&](double at) {
        return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count)));
    };
    std::size_t begin = index(std::floor((band.from - first_x) / step));
    std::size_t end = std::max(begin, index(std::ceil((band.to - first_x) / step) + 1.0));
    while (begin < end && x(begin) < band.from) ++begin;
    while (begin < end && x(end - 1) > band.to) --end;
    double *low = low_.data(), *high = high_.data();
    HWY_DYNAMIC_DISPATCH(bounds_of)(band, first_x, step, low, high, begin, end);
    std::fill(low, low + begin, unbounded);
    std::fill(high, high + begin, -unbounded);
    std::fill(low + end, low + count, unbounded);
    std::fill(high + end, high + count, -unbounded);
}

void FreeAlong::measure(const Band& region, const std::vector<Band>& solids, double first_x, double step,
                        std::size_t count) {
    region_.measure(region, first_x, step, count);
    low_.assign(region_.lows(), region_.lows() + count + lanes_at_most);
    high_.assign(region_.highs(), region_.highs() + count + lanes_at_most);
    lies_within_.assign(count + lanes_at_most, 0.0);
    solids_.resize(solids.size());
    for (std::size_t k = 0; k < solids.size(); ++k) {
        solids_[k].measure(solids[k], first_x, step, count);
        HWY_DYNAMIC_DISPATCH(cut_off)
        (solids_[k], region_, low_.data(), high_.data(), lies_within_.data(), count);
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
    for (const BandAlong& along : solids_) {
        const Interval solid = along.at(i);
        if (solid.low < solid.high && solid.high > bottom && solid.low < top) taken_.push_back(solid);
    }
    std::sort(taken_.begin(), taken_.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
    double begin = bottom;
    for (const Interval& solid : taken_) {
        if (solid.low >= begin) gaps.push_back({begin, solid.low});
        begin = std::max(begin, solid.high);
    }
    if (begin <= top) gaps.push_back({begin, top});
}

}  // namespace snug::detail::sets
#endif
