// The inner loops of the sweeps of sets, in vectors of whole numbers.
#include "all_maneuvers/sets/set_sweep.hpp"

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "all_maneuvers/sets/set_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace snug::detail::sets::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most so many numbers of each.
template <class Vector, class Tag>
HWY_INLINE void store(Vector one, Vector other, Tag tag, Micro* to_one, Micro* to_other, std::size_t count) {
    if (count >= hn::Lanes(tag)) {
        hn::StoreU(one, tag, to_one);
        hn::StoreU(other, tag, to_other);
    } else {
        hn::BlendedStore(one, hn::FirstN(tag, count), tag, to_one);
        hn::BlendedStore(other, hn::FirstN(tag, count), tag, to_other);
    }
}

template <bool GainsZ, bool GainsW>
void take_in_cells(const Taking& to, const Given& given, std::size_t count) {
    const hn::CappedTag<Micro, 16> tag;
    const std::size_t lanes = hn::Lanes(tag);
    for (std::size_t i = 0; i < count; i += lanes) {
        auto z = hn::LoadU(tag, given.z + i);
        auto w = hn::LoadU(tag, given.w + i);
        if constexpr (GainsZ) z = hn::Add(z, hn::LoadU(tag, given.more_z + i));
        if constexpr (GainsW) w = hn::Add(w, hn::LoadU(tag, given.more_w + i));
        const auto low = hn::LoadU(tag, to.low + i);
        const auto high = hn::LoadU(tag, to.high + i);
        z = hn::Min(z, hn::Add(high, hn::LoadU(tag, to.z_high + i)));
        w = hn::Max(w, hn::Sub(low, hn::LoadU(tag, to.w_low + i)));
        const auto below = hn::Lt(hn::Add(z, hn::LoadU(tag, to.up + i)), low);
        const auto above = hn::Gt(hn::Add(w, hn::LoadU(tag, to.down + i)), high);
        const auto none = hn::Lt(hn::Sub(z, w), hn::LoadU(tag, to.apart + i));
        const auto misses = hn::Or(hn::Or(below, above), none);
        const auto old_z = hn::LoadU(tag, to.z + i);
        const auto old_w = hn::LoadU(tag, to.w + i);
        z = hn::IfThenElse(misses, old_z, hn::Max(z, old_z));
        w = hn::IfThenElse(misses, old_w, hn::Min(w, old_w));
        store(z, w, tag, to.z + i, to.w + i, count - i);
    }
}

void take_in_vectors(const Taking& to, const Given& given, std::size_t count) {
    if (given.more_z && given.more_w) return take_in_cells<true, true>(to, given, count);
    if (given.more_z) return take_in_cells<true, false>(to, given, count);
    if (given.more_w) return take_in_cells<false, true>(to, given, count);
    take_in_cells<false, false>(to, given, count);
}

void cut_in_vectors(const Cutting& cells, std::size_t count) {
    const hn::CappedTag<Micro, 16> tag;
    const auto none_low = hn::Set(tag, nowhere), none_high = hn::Set(tag, -nowhere);
    const std::size_t lanes = hn::Lanes(tag);
    for (std::size_t i = 0; i < count; i += lanes) {
        auto low = hn::LoadU(tag, cells.limit_low + i);
        auto high = hn::LoadU(tag, cells.limit_high + i);
        if (cells.more_low) {
            low = hn::Add(low, hn::LoadU(tag, cells.more_low + i));
            high = hn::Add(high, hn::LoadU(tag, cells.more_high + i));
        }
        low = hn::Max(low, hn::LoadU(tag, cells.free_low + i));
        high = hn::Min(high, hn::LoadU(tag, cells.free_high + i));
        const auto none = hn::Gt(low, high);
        low = hn::Min(hn::IfThenElse(none, none_low, low), hn::LoadU(tag, cells.low + i));
        high = hn::Max(hn::IfThenElse(none, none_high, high), hn::LoadU(tag, cells.high + i));
        store(low, high, tag, cells.low + i, cells.high + i, count - i);
    }
}

Stretch reached_by_vectors(const Micro* z, std::size_t count) {
    const hn::CappedTag<Micro, 16> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto nothing = hn::Set(tag, -nowhere);
    Stretch part = {0, count};
    while (part.from + lanes <= part.to && hn::AllTrue(tag, hn::Eq(hn::LoadU(tag, z + part.from), nothing)))
        part.from += lanes;
    while (part.from < part.to && z[part.from] == -nowhere) ++part.from;
    while (part.from + lanes <= part.to && hn::AllTrue(tag, hn::Eq(hn::LoadU(tag, z + part.to - lanes), nothing)))
        part.to -= lanes;
    while (part.from < part.to && z[part.to - 1] == -nowhere) --part.to;
    return part;
}

}  // namespace snug::detail::sets::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail::sets {

HWY_EXPORT(take_in_vectors);
HWY_EXPORT(reached_by_vectors);
HWY_EXPORT(cut_in_vectors);

void take_in(const Taking& taking, const Given& given, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(take_in_vectors)(taking, given, count);
}

void cut(const Cutting& cutting, std::size_t count) { HWY_DYNAMIC_DISPATCH(cut_in_vectors)(cutting, count); }

Stretch reached(const Micro* z, std::size_t count) { return HWY_DYNAMIC_DISPATCH(reached_by_vectors)(z, count); }

}  // namespace snug::detail::sets
#endif
