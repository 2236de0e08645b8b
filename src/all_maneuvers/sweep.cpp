// The inner loops of the lattice: one row of it, in vectors.
#include <cstddef>
#include <limits>
#include <vector>

#include "all_maneuvers/lattice.hpp"

#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "all_maneuvers/sweep.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace snug::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void measure_row_in_vectors(double* needed, const Limits& limits, std::size_t first, double x, std::size_t count) {
    const hn::CappedTag<double, 8> tag;
    const auto here = hn::Set(tag, x);
    const auto nowhere_free = hn::Set(tag, std::numeric_limits<double>::infinity());
    const std::size_t lanes = hn::Lanes(tag);
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto of = [&](const std::vector<double>& numbers) { return hn::LoadU(tag, numbers.data() + first + i); };
        auto lowest = of(limits.curb);
        const auto raise = [&](const Neighbour& neighbour, auto beyond) {
            if (hn::AllFalse(tag, beyond)) return;
            auto least = of(neighbour.level);
            for (const Neighbour::Lines& lines : neighbour.lines)
                least = hn::Min(least, hn::Add(of(lines.at_0), hn::Mul(of(lines.slope), here)));
            lowest = hn::IfThenElse(beyond, hn::Max(lowest, least), lowest);
        };
        raise(limits.front, hn::Gt(here, of(limits.front.wall)));
        raise(limits.rear, hn::Lt(here, of(limits.rear.wall)));
        const auto within = hn::And(hn::Ge(here, of(limits.from)), hn::Le(here, of(limits.to)));
        lowest = hn::IfThenElse(within, lowest, nowhere_free);
        if (i + lanes <= count) {
            hn::StoreU(lowest, tag, needed + i);
        } else {
            hn::BlendedStore(lowest, hn::FirstN(tag, count - i), tag, needed + i);
        }
    }
}

template <Above Rule>
void sweep_cells(double* row, const double* left, const double* right, const double* keep, const double* from_left,
                 const double* from_right, const double* needed, const double* ceiling, std::size_t count) {
    const hn::CappedTag<double, 8> tag;
    const auto nowhere = hn::Set(tag, Heights::nowhere);
    const std::size_t lanes = hn::Lanes(tag);
    for (std::size_t i = 0; i < count; i += lanes) {
        const auto stays = hn::Add(hn::LoadU(tag, row + i), hn::LoadU(tag, keep + i));
        const auto from_one = hn::Add(hn::LoadU(tag, left + i), hn::LoadU(tag, from_left + i));
        const auto from_other = hn::Add(hn::LoadU(tag, right + i), hn::LoadU(tag, from_right + i));
        auto highest = hn::Max(stays, hn::Max(from_one, from_other));
        if constexpr (Rule == Above::lowered) highest = hn::Min(highest, hn::LoadU(tag, ceiling + i));
        if constexpr (Rule == Above::dropped)
            highest = hn::IfThenElse(hn::Gt(highest, hn::LoadU(tag, ceiling + i)), nowhere, highest);
        highest = hn::IfThenElse(hn::Ge(highest, hn::LoadU(tag, needed + i)), highest, nowhere);
        if (i + lanes <= count) {
            hn::StoreU(highest, tag, row + i);
        } else {
            hn::BlendedStore(highest, hn::FirstN(tag, count - i), tag, row + i);
        }
    }
}

void sweep_row_in_vectors(double* row, const double* left, const double* right, const double* keep,
                          const double* from_left, const double* from_right, const double* needed, Above above,
                          const double* ceiling, std::size_t count) {
    switch (above) {
        case Above::allowed:
            return sweep_cells<Above::allowed>(row, left, right, keep, from_left, from_right, needed, ceiling, count);
        case Above::lowered:
            return sweep_cells<Above::lowered>(row, left, right, keep, from_left, from_right, needed, ceiling, count);
        case Above::dropped:
            return sweep_cells<Above::dropped>(row, left, right, keep, from_left, from_right, needed, ceiling, count);
    }
}

}  // namespace snug::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail {

HWY_EXPORT(measure_row_in_vectors);
HWY_EXPORT(sweep_row_in_vectors);

void measure_row(double* needed, const Limits& limits, std::size_t first, double x, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(measure_row_in_vectors)(needed, limits, first, x, count);
}

void sweep_row(double* row, const double* left, const double* right, const double* keep, const double* from_left,
               const double* from_right, const double* needed, Above above, const double* ceiling, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(sweep_row_in_vectors)
    (row, left, right, keep, from_left, from_right, needed, above, ceiling, count);
}

}  // namespace snug::detail
#endif
