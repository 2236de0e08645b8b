// The inner loops of the sweeps of sets, in vectors of whole numbers.
#include "all_maneuvers/set_sweep.hpp"

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "all_maneuvers/set_sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace snug::detail::sets::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
        // Lowest and highest y: of what is given and of the two that are there.
        const auto up = hn::LoadU(tag, to.up + i);
        const auto down = hn::LoadU(tag, to.down + i);
        const auto top = hn::Add(z, up);
        const auto bottom = hn::Add(w, down);
        const auto misses =
            hn::Or(hn::Or(hn::Lt(top, low), hn::Gt(bottom, high)), hn::Lt(hn::Sub(z, w), hn::LoadU(tag, to.apart + i)));
        const auto one_z = hn::LoadU(tag, to.z + i);
        const auto one_w = hn::LoadU(tag, to.w + i);
        const auto two_z = hn::LoadU(tag, to.other_z + i);
        const auto two_w = hn::LoadU(tag, to.other_w + i);
        const auto gap = [&](auto with_z, auto with_w) {
            const auto between = hn::Max(hn::Sub(bottom, hn::Add(with_z, up)), hn::Sub(hn::Add(with_w, down), top));
            const auto empty = hn::Eq(with_z, hn::Set(tag, -nowhere));
            return hn::IfThenElse(
                empty, hn::Zero(tag),
                hn::Add(between, hn::IfThenElseZero(hn::Gt(between, hn::Zero(tag)), hn::Set(tag, 1))));
        };
        // Negative or 0 where they overlap; an empty one is as good as one that touches.
        const auto gap_one = gap(one_z, one_w);
        const auto gap_two = gap(two_z, two_w);
        const auto into_two = hn::Lt(hn::Max(gap_two, hn::Zero(tag)), hn::Max(gap_one, hn::Zero(tag)));
        const auto keep_one = hn::Or(misses, into_two);
        const auto new_one_z = hn::IfThenElse(keep_one, one_z, hn::Max(z, one_z));
        const auto new_one_w = hn::IfThenElse(keep_one, one_w, hn::Min(w, one_w));
        const auto keep_two = hn::Or(misses, hn::Not(into_two));
        const auto new_two_z = hn::IfThenElse(keep_two, two_z, hn::Max(z, two_z));
        const auto new_two_w = hn::IfThenElse(keep_two, two_w, hn::Min(w, two_w));
        const auto store = [&](auto numbers, Micro* where) {
            if (i + lanes <= count) {
                hn::StoreU(numbers, tag, where + i);
            } else {
                hn::BlendedStore(numbers, hn::FirstN(tag, count - i), tag, where + i);
            }
        };
        store(new_one_z, to.z);
        store(new_one_w, to.w);
        store(new_two_z, to.other_z);
        store(new_two_w, to.other_w);
    }
}

void take_in_vectors(const Taking& to, const Given& given, std::size_t count) {
    if (given.more_z && given.more_w) return take_in_cells<true, true>(to, given, count);
    if (given.more_z) return take_in_cells<true, false>(to, given, count);
    if (given.more_w) return take_in_cells<false, true>(to, given, count);
    take_in_cells<false, false>(to, given, count);
}

}  // namespace snug::detail::sets::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail::sets {

HWY_EXPORT(take_in_vectors);

void take_in(const Taking& taking, const Given& given, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(take_in_vectors)(taking, given, count);
}

}  // namespace snug::detail::sets
#endif
