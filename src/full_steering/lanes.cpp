// The paper's strategy in the lanes of a vector: every lane drives its own case, and takes the next one when it is done.
//
// A step takes each lane through one quarter turn: to the contact and across to the next turning centre, or on into the
// next quarter. It is first_contact_in_quarter() and FullSteeringRun::drive() with the same operations in the same order,
// branches turned into masks, so every lane has the same bits. Cases that turn past -pi/2 are rare and driven alone.
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "full_steering/cases.hpp"

// Vectors of fixed width only, because others cannot be members.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "full_steering/lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace snug::detail::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Reals = hn::CappedTag<double, 8>;
using Whole = hn::RebindToSigned<Reals>;
using Real = hn::Vec<Reals>;
using Integer = hn::Vec<Whole>;
using Mask = hn::Mask<Reals>;

constexpr Reals reals;
constexpr Whole whole;
constexpr std::size_t lanes = hn::MaxLanes(reals);
/// Vectors stepped in turn, so that one can begin while another waits for its roots.
constexpr std::size_t vectors = 2;

/// The frame's numbers in one quarter turn (see QuarterFrame) for every way the lanes may be turning: the index is 1 for
/// forward, plus 2 in the second quarter.
struct Frames {
    enum Number {
        left,
        bottom,
        right,
        up,
        lowest_radius,
        lowest_per_square,
        leftmost_radius,
        leftmost_per_square,
        rightmost_radius,
        rightmost_per_square,
        top_x,
        top_y,
        numbers
    };
    alignas(64) std::array<std::array<double, 8>, numbers> table = {};

    explicit Frames(const FullSteering& steering) {
        for (std::size_t i = 0; i < 4; ++i) {
            const QuarterFrame& frame = (i % 2 == 1 ? steering.forward : steering.backward)[i / 2];
            const std::array<double, numbers> of = {frame.lowest.x,
                                                    frame.lowest.y,
                                                    frame.rightmost.x,
                                                    frame.leftmost.y,
                                                    frame.lowest.radius,
                                                    frame.lowest.per_square,
                                                    frame.leftmost.radius,
                                                    frame.leftmost.per_square,
                                                    frame.rightmost.radius,
                                                    frame.rightmost.per_square,
                                                    frame.top.x,
                                                    frame.top.y};
            for (std::size_t n = 0; n < numbers; ++n) table[n][i] = of[n];
        }
    }
};

/// Picks each lane's entry of a table.
class Pick {
public:
    HWY_INLINE Pick(const Frames& frames, Integer index) : frames_(frames), index_(index) {}

    HWY_INLINE Real operator()(Frames::Number number) const {
        const double* row = frames_.table[number].data();
        if constexpr (lanes >= 4) {
            return hn::TableLookupLanes(hn::Load(reals, row), hn::IndicesFromVec(reals, index_));
        } else {
            const Mask forward = hn::RebindMask(reals, hn::TestBit(index_, hn::Set(whole, 1)));
            const Mask second = hn::RebindMask(reals, hn::TestBit(index_, hn::Set(whole, 2)));
            return hn::IfThenElse(second, hn::IfThenElse(forward, hn::Set(reals, row[3]), hn::Set(reals, row[2])),
                                  hn::IfThenElse(forward, hn::Set(reals, row[1]), hn::Set(reals, row[0])));
        }
    }

private:
    const Frames& frames_;
    Integer index_;
};

/// A corner of the frame seen from the turning centre.
struct Corner {
    Real x, y, radius, per_square;
};

/// The first contact of a quarter turn as far as it is known; without one, the end of the quarter.
class First {
public:
    HWY_INLINE First(Real start_c, Real start_s)
        : start_c_(start_c),
          start_s_(start_s),
          start_order_(start_s - start_c),
          c(hn::Set(reals, 1.0)),
          s(hn::Zero(reals)),
          order(hn::Set(reals, -2.0)) {}

    /// `touching`: the car touches this obstacle at the start, closing in; `slips_off`: but bound to miss it.
    HWY_INLINE void consider(Real at_c, Real at_s, Mask exists, Mask touching, Mask slips_off) {
        const Real at_order = at_s - at_c;
        const Real later = start_order_ - at_order;
        const Mask touches = hn::And(touching, hn::Abs(later) < hn::Set(reals, near_start));
        const Mask ahead = hn::Min(hn::Min(at_s, at_c), later) >= hn::Zero(reals);
        const Mask here = hn::AndNot(slips_off, touches);
        const Mask met = hn::And(exists, hn::Or(here, hn::AndNot(touches, ahead)));
        const Real met_order = hn::IfThenElse(here, start_order_, at_order);
        const Mask earlier = hn::And(met, met_order > order);
        c = hn::IfThenElse(earlier, at_c, c);
        s = hn::IfThenElse(earlier, at_s, s);
        order = hn::IfThenElse(earlier, met_order, order);
    }

    /// What is met at the start is met right there.
    HWY_INLINE void settle() {
        c = hn::IfThenElse(at_start(), start_c_, c);
        s = hn::IfThenElse(at_start(), start_s_, s);
    }

    [[nodiscard]] HWY_INLINE Mask found() const { return order > hn::Set(reals, -2.0); }
    [[nodiscard]] HWY_INLINE Mask at_start() const { return order == start_order_; }

private:
    Real start_c_, start_s_, start_order_;

public:
    Real c, s, order;
};

/// What does not change from step to step.
struct Constants {
    Frames frames;
    double touch;
    double radius;
    int max_changes;
};

/// As many cases as a vector has lanes, each at the start of a move or of the second quarter turn.
class LaneCases {
public:
    [[nodiscard]] bool busy() const { return busy_ != 0; }

    HWY_INLINE void fill(Cases& cases) {
        for (std::size_t lane = 0; lane < lanes; ++lane) begin_next(cases, lane);
    }

    /// Takes every lane one quarter turn further.
    HWY_INLINE void step(const Constants& constants) {
        const Real zero = hn::Zero(reals);
        const Real touch = hn::Set(reals, constants.touch);
        const Real x = hn::Load(reals, x_);
        const Real y = hn::Load(reals, y_);
        const Real start_c = hn::Load(reals, c_);
        const Real start_s = hn::Load(reals, s_);
        const Real length = hn::Load(reals, length_);
        const Real width = hn::Load(reals, width_);
        const Integer changes = hn::Load(whole, changes_);
        const Integer quarter = hn::Load(whole, quarter_);
        const Integer crossed = hn::Load(whole, crossed_);

        const Integer one = hn::Set(whole, 1);
        const Integer odd = hn::And(changes, one);
        const Pick pick(constants.frames, odd + quarter + quarter);
        const Corner lowest = {pick(Frames::left), pick(Frames::bottom), pick(Frames::lowest_radius),
                               pick(Frames::lowest_per_square)};
        const Corner leftmost = {lowest.x, pick(Frames::up), pick(Frames::leftmost_radius),
                                 pick(Frames::leftmost_per_square)};
        const Corner rightmost = {pick(Frames::right), lowest.y, pick(Frames::rightmost_radius),
                                  pick(Frames::rightmost_per_square)};

        First first(start_c, start_s);
        const auto turned_x = [&](const Corner& corner) HWY_ATTR { return corner.x * start_c - corner.y * start_s; };
        const auto turned_y = [&](const Corner& corner) HWY_ATTR { return corner.x * start_s + corner.y * start_c; };

        const auto corner_meets_side = [&](const Corner& corner, Real wall, auto on_the_left) HWY_ATTR {
            const Real along = wall - x;
            const Real root = hn::Sqrt((corner.radius - along) * (corner.radius + along));
            const Real across = on_the_left ? hn::Neg(root) : root;
            const Real s = (across * corner.x - along * corner.y) * corner.per_square;
            const Real c = (along * corner.x + across * corner.y) * corner.per_square;
            const Real height = y + corner.x * s + corner.y * c;
            const Real start_x = turned_x(corner);
            const Real start_y = turned_y(corner);
            const Mask closes_in =
                hn::And(hn::Abs(along - start_x) <= touch, on_the_left ? start_y < zero : start_y > zero);
            const Mask slips_off = hn::And(y + start_y >= zero - touch, start_x <= zero);
            const Mask lifted = hn::And(height <= touch, hn::AndNot(slips_off, closes_in));
            const Mask exists = hn::Or(height <= zero, lifted);  // false where there is no root
            first.consider(c, s, exists, closes_in, slips_off);
        };
        const Mask never = zero > zero;
        const auto corner_meets_ground = [&](Real ground, auto is_there) HWY_ATTR {
            const Real across = ground - y;
            const Real along = hn::Sqrt((lowest.radius - across) * (lowest.radius + across));
            const Real s = (across * lowest.x - along * lowest.y) * lowest.per_square;
            const Real c = (along * lowest.x + across * lowest.y) * lowest.per_square;
            const Mask closes_in = hn::And(hn::Abs(turned_y(lowest) - across) <= touch, turned_x(lowest) > zero);
            const Mask exists = is_there(along >= zero, c, s, closes_in);
            first.consider(c, s, exists, closes_in, never);
        };

        corner_meets_side(rightmost, zero, std::false_type());
        corner_meets_side(leftmost, zero - length, std::true_type());
        corner_meets_ground(zero - width, [](Mask exists, Real, Real, Mask) HWY_ATTR { return exists; });
        const Mask high = y + lowest.x * start_s + lowest.y * start_c > zero - touch;
        if (HWY_UNLIKELY(!hn::AllFalse(reals, high))) {
            const auto lands = [&](Mask exists, Real beyond_end, Mask moves_onto) HWY_ATTR {
                const Mask onto = hn::Or(beyond_end > touch, hn::And(beyond_end >= zero - touch, moves_onto));
                return hn::And(hn::And(high, exists), onto);
            };
            const auto where = [&](Real c, Real s) HWY_ATTR { return x + lowest.x * c - lowest.y * s; };
            corner_meets_ground(zero, [&](Mask exists, Real c, Real s, Mask closes_in) HWY_ATTR {
                return lands(exists, where(c, s), hn::And(closes_in, turned_y(lowest) > zero));
            });
            corner_meets_ground(zero, [&](Mask exists, Real c, Real s, Mask closes_in) HWY_ATTR {
                return lands(exists, zero - length - where(c, s), hn::And(closes_in, turned_y(lowest) < zero));
            });
        }
        {
            const Real gx = zero - x;
            const Real gy = zero - y;
            const Real along = hn::Sqrt(gx * gx + gy * gy - lowest.y * lowest.y);
            const Mask exists = hn::And(along <= rightmost.x + touch, along >= lowest.x - touch);
            const Real per_square = hn::Set(reals, 1.0) / (gx * gx + gy * gy);
            const Real start_x = gx * start_c + gy * start_s;
            const Real start_y = gy * start_c - gx * start_s;
            const Mask closes_in = hn::And(hn::Abs(start_y - lowest.y) <= touch, start_x > zero);
            const Mask slips_off = hn::Or(hn::And(start_x >= rightmost.x - touch, start_y <= zero),
                                          hn::And(start_x <= lowest.x + touch, start_y >= zero));
            first.consider((gx * along + gy * lowest.y) * per_square, (gy * along - gx * lowest.y) * per_square, exists,
                           closes_in, slips_off);
        }
        {
            const Real gx = zero - length - x;
            const Real gy = zero - y;
            const Real across = hn::Neg(hn::Sqrt(gx * gx + gy * gy - lowest.x * lowest.x));
            const Mask exists = hn::And(across <= leftmost.y + touch, across >= lowest.y - touch);
            const Real per_square = hn::Set(reals, 1.0) / (gx * gx + gy * gy);
            const Real start_x = gx * start_c + gy * start_s;
            const Real start_y = gy * start_c - gx * start_s;
            const Mask closes_in = hn::And(hn::Abs(start_x - lowest.x) <= touch, start_y < zero);
            const Mask slips_off = hn::Or(hn::And(start_y >= leftmost.y - touch, start_x >= zero),
                                          hn::And(start_y <= lowest.y + touch, start_x <= zero));
            first.consider((gx * lowest.x + gy * across) * per_square, (gy * lowest.x - gx * across) * per_square,
                           exists, closes_in, slips_off);
        }

        first.settle();

        const Real top_x = pick(Frames::top_x);
        const Real top_y = pick(Frames::top_y);
        const Mask found = first.found();
        const Mask move_starts = hn::RebindMask(reals, crossed == hn::Zero(whole));
        const Mask stuck = hn::And(move_starts, first.at_start());
        const Mask inside =
            hn::Or(y + top_x * start_s + top_y * start_c <= zero, y + top_x * first.s + top_y * first.c <= zero);
        const Mask second = hn::RebindMask(reals, quarter == one);
        const Mask gives_up = hn::And(found, hn::RebindMask(reals, changes == hn::Set(whole, constants.max_changes)));
        const Mask done = hn::Or(hn::Or(stuck, inside), hn::Or(gives_up, hn::AndNot(found, second)));

        const Real sine = hn::IfThenElse(second, hn::Neg(first.c), first.s);
        const Real cosine = hn::IfThenElse(second, first.s, first.c);
        const Real diameter = hn::Set(reals, 2.0 * constants.radius);
        const Real across = hn::IfThenElse(hn::RebindMask(reals, odd == one), zero - diameter, diameter);
        hn::Store(hn::IfThenElse(found, x + across * sine, x), reals, x_);
        hn::Store(hn::IfThenElse(found, y - across * cosine, y), reals, y_);
        hn::Store(hn::IfThenElse(found, first.c, zero), reals, c_);
        hn::Store(hn::IfThenElse(found, first.s, hn::Set(reals, 1.0)), reals, s_);
        const auto found_whole = hn::RebindMask(whole, found);
        hn::Store(hn::IfThenElse(found_whole, changes + one, changes), whole, changes_);
        hn::Store(hn::IfThenElse(found_whole, quarter, one), whole, quarter_);
        hn::Store(hn::IfThenElseZero(hn::RebindMask(whole, hn::Not(found)), one), whole, crossed_);

        // Answers: the changes where parked, -1 where not, and -2 past the second quarter.
        const Integer not_parked = hn::IfThenElse(hn::RebindMask(whole, hn::Or(stuck, gives_up)), hn::Set(whole, -1),
                                                  hn::Set(whole, past_second_quarter));
        hn::Store(hn::IfThenElse(hn::RebindMask(whole, hn::AndNot(stuck, inside)), changes, not_parked), whole,
                  answer_);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(reals, done, bits);
        done_ = bits[0];
    }

    /// Hands in what is done, and begins new cases in its lanes.
    HWY_INLINE void renew(Cases& cases) {
        for (unsigned done = done_ & busy_; done != 0; done &= done - 1) {
            const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(done);
            if (answer_[lane] == past_second_quarter) {
                cases.answer_alone(index_[lane]);
            } else {
                cases.answer(index_[lane], static_cast<int>(answer_[lane]));
            }
            begin_next(cases, lane);
        }
    }

private:
    static constexpr std::int64_t past_second_quarter = -2;

    HWY_INLINE void begin_next(Cases& cases, std::size_t lane) {
        const Cases::Start* start = cases.next();
        if (start == nullptr) {
            busy_ &= ~(1U << lane);
            return;
        }
        busy_ |= 1U << lane;
        index_[lane] = start->index;
        x_[lane] = start->x;
        y_[lane] = start->y;
        c_[lane] = start->c;
        s_[lane] = start->s;
        length_[lane] = start->length;
        width_[lane] = start->width;
        changes_[lane] = 0;
        quarter_[lane] = 0;
        crossed_[lane] = 0;
    }

    // Turning centre, heading (see QuarterHeading) and slot of each lane; crossed: this quarter did not begin the move.
    alignas(64) double x_[lanes] = {};
    alignas(64) double y_[lanes] = {};
    alignas(64) double c_[lanes] = {};
    alignas(64) double s_[lanes] = {};
    alignas(64) double length_[lanes] = {};
    alignas(64) double width_[lanes] = {};
    alignas(64) std::int64_t changes_[lanes] = {};
    alignas(64) std::int64_t quarter_[lanes] = {};
    alignas(64) std::int64_t crossed_[lanes] = {};
    alignas(64) std::int64_t answer_[lanes] = {};
    std::size_t index_[lanes] = {};
    unsigned busy_ = 0;
    unsigned done_ = 0;
};

void drive_all_in_lanes(Cases& cases) {
    if constexpr (lanes == 1) {  // nothing to gain
        while (const Cases::Start* start = cases.next()) cases.answer_alone(start->index);
        return;
    }
    const FullSteering& steering = cases.steering();
    const Constants constants = {Frames(steering), steering.problem.touch, steering.problem.radius,
                                 cases.max_changes()};
    std::array<LaneCases, vectors> running;
    for (LaneCases& vector : running) vector.fill(cases);
    for (bool any = true; any;) {
        for (LaneCases& vector : running) {
            if (vector.busy()) vector.step(constants);
        }
        any = false;
        for (LaneCases& vector : running) {
            vector.renew(cases);
            any = any || vector.busy();
        }
    }
}

}  // namespace snug::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail {

HWY_EXPORT(drive_all_in_lanes);

void drive_all(Cases& cases) { HWY_DYNAMIC_DISPATCH(drive_all_in_lanes)(cases); }

}  // namespace snug::detail
#endif
