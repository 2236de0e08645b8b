// The paper's strategy in the lanes of a vector: every lane drives its own case, and takes the next one when it is done.
//
// A step takes each lane through one quarter turn: to the contact and across to the next turning centre, or on into the
// next quarter. Contacts are found by the source that the scalar uses (sector.inl), so every lane has the same bits.
// Rectangles only, which have a sector for each quarter turn. Cases that turn past -pi/2 are rare and driven alone.
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

/// The frame's numbers in one quarter turn (see Sector) for every way the lanes may be turning: the index is 1 for
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
            const Sector& frame = (i % 2 == 1 ? steering.forward : steering.backward).sectors[i / 2];
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

/// What the equations need to know of the lanes: see Plain in crossing.hpp.
struct Lanes {
    using Real = hn::Vec<Reals>;
    using Mask = hn::Mask<Reals>;
    static constexpr bool alone = false;

    static HWY_INLINE Real set(double value) { return hn::Set(reals, value); }
    static HWY_INLINE Real sqrt(Real value) { return hn::Sqrt(value); }
    static HWY_INLINE Real minus(Real value) { return hn::Neg(value); }
    static HWY_INLINE Real abs(Real value) { return hn::Abs(value); }
    static HWY_INLINE Real least(Real a, Real b) { return hn::Min(a, b); }
    static HWY_INLINE Real select(Mask mask, Real yes, Real no) { return hn::IfThenElse(mask, yes, no); }
    static HWY_INLINE Mask both(Mask a, Mask b) { return hn::And(a, b); }
    static HWY_INLINE Mask either(Mask a, Mask b) { return hn::Or(a, b); }
    static HWY_INLINE Mask opposite(Mask a) { return hn::Not(a); }
    static HWY_INLINE bool none(Mask) { return false; }  // some lane nearly always has something left
    static HWY_INLINE bool rarely(Mask mask) { return HWY_UNLIKELY(!hn::AllFalse(reals, mask)); }
};

#define SNUG_INLINE HWY_INLINE
#define SNUG_LAMBDA HWY_ATTR
#include "contact/crossing.inl"
#include "contact/sector.inl"
#undef SNUG_INLINE
#undef SNUG_LAMBDA

using Corner = SeenCorner<Real>;

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

        First<Lanes> first(start_c, start_s, hn::Set(reals, -2.0));
        first.corners_meet(lowest, leftmost, rightmost, lowest, {x, y, length, y + width, y, y, touch});
        const Real minus_one = hn::Set(reals, -1.0);
        const SeenEdge<Lanes> front = {hn::Neg(lowest.y), lowest.x, rightmost.x, lowest.y >= zero, lowest.y <= zero};
        first.edge_meets_corner(front, zero, minus_one, zero - x, zero - y, touch, Meets::front_corner);
        const SeenEdge<Lanes> rear = {hn::Neg(lowest.x), hn::Neg(leftmost.y), hn::Neg(lowest.y), lowest.x >= zero,
                                      lowest.x <= zero};
        first.edge_meets_corner(rear, minus_one, zero, zero - x - length, zero - y, touch, Meets::rear_corner);
        first.settle();

        const Real top_x = pick(Frames::top_x);
        const Real top_y = pick(Frames::top_y);
        const Mask found = first.order > hn::Set(reals, -2.0);
        const Mask move_starts = hn::RebindMask(reals, crossed == hn::Zero(whole));
        const Mask stuck = hn::And(move_starts, first.at_the_start());
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
