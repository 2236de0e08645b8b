// The paper's strategy in the lanes of a vector: every lane drives its own case, and takes the next one when it is done.
//
// A step takes each lane through one quarter turn: to the contact and across to the next turning centre, on into the second
// quarter, or to where the car has turned away. Contacts are found by the source that the scalar uses (sector.inl), so every
// lane has the same bits. Rectangles only, which have a sector for each quarter turn.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "full_steering/cases.hpp"
#include "full_steering/follow.hpp"

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
constexpr std::size_t vectors = 3;

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
        top_radius,
        dip_order,
        graze_order,
        numbers
    };
    alignas(64) std::array<std::array<double, 8>, numbers> table;
    std::array<std::array<std::int16_t, 8>, 4> parts = {};  ///< of the outline, that meet something: by Meets

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
                                                    frame.top.y,
                                                    frame.top.radius,
                                                    frame.dip_order,
                                                    frame.graze_order};
            for (std::size_t n = 0; n < numbers; ++n) table[n][i] = of[n];
            const auto part = [&](Meets meets) -> std::int16_t& { return parts[i][static_cast<std::size_t>(meets)]; };
            part(Meets::front_side) = static_cast<std::int16_t>(frame.rightmost.index);
            part(Meets::front_corner) = part(Meets::curb) = static_cast<std::int16_t>(frame.lowest.index);
            part(Meets::front_top) = part(Meets::rear_top) = part(Meets::curb);
            part(Meets::rear_corner) = part(Meets::rear_side) = static_cast<std::int16_t>(frame.leftmost.index);
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
    static HWY_INLINE Mask never() { return hn::Zero(reals) > hn::Zero(reals); }
    static HWY_INLINE bool some(Mask mask) { return !hn::AllFalse(reals, mask); }
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

/// Nothing is kept of a contact.
struct NotFound {
    HWY_INLINE void lies_ahead(Mask, Meets) {}
    HWY_INLINE void is_first(Mask, Real, Meets, int) {}
};

/// See Found.
struct FoundInLanes {
    Real across;
    Integer meets, ahead;

    HWY_INLINE FoundInLanes() : across(hn::Set(reals, 1.0)), meets(hn::Zero(whole)), ahead(hn::Zero(whole)) {}
    HWY_INLINE void lies_ahead(Mask met, Meets what) {
        const Integer bit = hn::Set(whole, static_cast<std::int64_t>(bit_of(what)));
        ahead = hn::Or(ahead, hn::IfThenElseZero(hn::RebindMask(whole, met), bit));
    }
    HWY_INLINE void is_first(Mask earlier, Real of_across, Meets what, int) {
        across = hn::IfThenElse(earlier, of_across, across);
        meets = hn::IfThenElse(hn::RebindMask(whole, earlier), hn::Set(whole, static_cast<std::int64_t>(what)), meets);
    }
    [[nodiscard]] HWY_INLINE Mask is(Meets what) const {
        return hn::RebindMask(reals, meets == hn::Set(whole, static_cast<std::int64_t>(what)));
    }
};

/// What does not change from step to step.
struct Constants {
    Frames frames;
    double touch;
    double radius;
    double rounding = 0.0;  ///< a root's square closer to 0 is looked at carefully [m^2]

    explicit Constants(const FullSteering& steering)
        : frames(steering), touch(steering.problem.touch), radius(steering.problem.radius) {
        for (const Frames::Number number : {Frames::lowest_radius, Frames::leftmost_radius, Frames::rightmost_radius})
            for (std::size_t i = 0; i < 4; ++i) rounding = std::max(rounding, frames.table[number][i] * touch);
    }
};

HWY_INLINE unsigned bits_of(Mask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(reals, mask, bits);
    return bits[0];
}

/// The cases of a batch: how many changes each parks with.
class Batch {
public:
    static constexpr bool keeps_moves = false;
    using Found = NotFound;

    explicit Batch(Cases& cases) : cases_(cases) {}

    const Cases::Start* next() { return cases_.next(); }
    [[nodiscard]] std::int64_t limit() const { return cases_.max_changes(); }
    void parks(std::size_t index, std::int64_t changes) { cases_.answer(index, static_cast<int>(changes)); }
    void ends(std::size_t index) { cases_.answer(index, -1); }

private:
    Cases& cases_;
};

/// The runs of a search, with every move.
class Search {
public:
    static constexpr bool keeps_moves = true;
    using Found = FoundInLanes;

    struct Start : Cases::Start {
        double x_slope, y_slope;
        std::int64_t last;
        bool past_parked;
    };

    Search(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest, std::vector<FullMove>& moves)
        : steering_(steering), runs_(runs), limit_(limit), fewest_(fewest), moves_(moves) {}

    const Start* next() {
        if (next_ == runs_.size()) return nullptr;
        const Run& run = runs_[next_];
        const FullSteeringRun car(steering_, run.heading);
        start_.index = next_++;
        start_.x = car.x();
        start_.y = car.y();
        start_.c = car.heading().c;
        start_.s = car.heading().s;
        start_.length = steering_.problem.length;
        start_.width = steering_.problem.width;
        start_.x_slope = car.x_slope();
        start_.y_slope = car.y_slope();
        start_.last = run.last;
        start_.past_parked = run.past_parked;
        return &start_;
    }
    [[nodiscard]] std::int64_t limit() const { return limit_; }
    void keep(std::size_t index, const FullMove* moves, std::size_t count) {
        runs_[index].first = moves_.size();
        runs_[index].count = count;
        moves_.insert(moves_.end(), moves, moves + count);
    }
    void parks(std::size_t index, std::int64_t changes) {
        runs_[index].changes = static_cast<int>(changes);
        if (fewest_) limit_ = std::min(limit_, runs_[index].changes);
    }
    void ends(std::size_t) {}

private:
    const FullSteering& steering_;
    std::vector<Run>& runs_;
    int limit_;
    bool fewest_;
    std::vector<FullMove>& moves_;
    std::size_t next_ = 0;
    Start start_;
};

/// Room for the moves of the cases under way, lane by lane.
class Room {
public:
    explicit Room(std::size_t rows) : rows_(rows) {}

    HWY_INLINE FullMove& at(std::size_t row, std::size_t move) {
        if (HWY_UNLIKELY(move >= each_)) grow();
        return moves_[row * each_ + move];
    }
    [[nodiscard]] const FullMove* row(std::size_t row) const { return moves_.get() + row * each_; }

private:
    void grow() {
        const std::size_t more = each_ == 0 ? 32 : 2 * each_;
        std::unique_ptr<FullMove[]> grown(new FullMove[rows_ * more]);
        for (std::size_t row = 0; row < rows_; ++row)
            std::copy_n(moves_.get() + row * each_, each_, &grown[row * more]);
        moves_ = std::move(grown);
        each_ = more;
    }

    std::size_t rows_;
    std::size_t each_ = 0;
    std::unique_ptr<FullMove[]> moves_;
};

/// As many cases as a vector has lanes, each at the start of a move or of the second quarter turn.
template <class Source>
class LaneCases {
    using Quick = First<Lanes, typename Source::Found, false>;
    using Careful = First<Lanes, typename Source::Found>;

public:
    [[nodiscard]] bool busy() const { return busy_ != 0; }

    HWY_INLINE void fill(Source& source) {
        for (std::size_t lane = 0; lane < lanes; ++lane) begin_next(source, lane);
    }

    /// Takes every lane one quarter turn further. Moves are kept in the rows from `first_row`.
    HWY_INLINE void step(const Constants& constants, std::int64_t limit, Room& room, std::size_t first_row) {
        const Real zero = hn::Zero(reals);
        const Real x = hn::Load(reals, x_);
        const Real y = hn::Load(reals, y_);
        const Real start_c = hn::Load(reals, c_);
        const Real start_s = hn::Load(reals, s_);
        const Real width = hn::Load(reals, width_);
        const Integer changes = hn::Load(whole, changes_);
        const Integer quarter = hn::Load(whole, quarter_);
        const Integer crossed = hn::Load(whole, crossed_);

        const Integer one = hn::Set(whole, 1);
        const Integer odd = hn::And(changes, one);
        const Pick pick(constants.frames, odd + quarter + quarter);
        Quick first = contacts<Quick>(constants, pick);
        if (HWY_UNLIKELY(!hn::AllFalse(reals, first.closest <= hn::Set(reals, constants.rounding))))
            first = look_again(constants);
        first.settle();

        const Real top_x = pick(Frames::top_x);
        const Real top_y = pick(Frames::top_y);
        const Mask found = first.order > hn::Set(reals, -2.0);
        const Mask move_starts = hn::RebindMask(reals, crossed == hn::Zero(whole));
        const Mask second = hn::RebindMask(reals, quarter == one);
        const Mask stuck = hn::And(move_starts, first.at_the_start());
        const Real sine = hn::IfThenElse(second, hn::Neg(first.c), first.s);
        const Real cosine = hn::IfThenElse(second, first.s, first.c);
        const Real diameter = hn::Set(reals, 2.0 * constants.radius);
        const Real across = hn::IfThenElse(hn::RebindMask(reals, odd == one), zero - diameter, diameter);
        const Real start_height = y + top_x * start_s + top_y * start_c;
        const Real end_height = y + top_x * first.s + top_y * first.c;
        const Mask turned_away = hn::AndNot(found, second);
        const Mask driven = hn::Or(found, second);  // to the move's end

        Mask parks;
        Mask ends;
        if constexpr (!Source::keeps_moves) {
            parks = hn::AndNot(stuck, hn::Or(start_height <= zero, end_height <= zero));
            const Mask last = hn::RebindMask(reals, changes == hn::Set(whole, limit));
            ends = hn::Or(hn::Or(stuck, turned_away), hn::And(found, last));
        } else {
            const Real x_slope = hn::Load(reals, x_slope_);
            const Real y_slope = hn::Load(reals, y_slope_);
            const Real heading_slope = hn::Load(reals, heading_slope_);
            const Real not_there = hn::Set(reals, std::numeric_limits<double>::quiet_NaN());

            // Of the heading at the end: the centre's speed into what is met, by how squarely it is met.
            const auto& met = first.found;
            Real towards = hn::Neg(y_slope);
            towards = hn::IfThenElse(met.is(Meets::front_side), x_slope, towards);
            towards = hn::IfThenElse(met.is(Meets::rear_side), hn::Neg(x_slope), towards);
            towards =
                hn::IfThenElse(met.is(Meets::front_corner), first.s * x_slope + hn::Neg(first.c) * y_slope, towards);
            towards = hn::IfThenElse(met.is(Meets::rear_corner),
                                     hn::Neg(first.c) * x_slope + hn::Neg(first.s) * y_slope, towards);
            const Real end_slope = hn::IfThenElse(stuck, heading_slope, slope_of_root(towards, met.across));

            const auto not_past = [&](Real order) HWY_ATTR {
                return hn::And(order <= first.start_order, hn::Not(hn::And(found, first.order > order)));
            };
            Real depth = hn::IfThenElse(move_starts, start_height, hn::Load(reals, depth_));
            Real depth_slope =
                hn::IfThenElse(move_starts, y_slope + (top_x * start_c - top_y * start_s) * heading_slope,
                               hn::Load(reals, depth_slope_));
            const Real dip = y - pick(Frames::top_radius);
            const Mask dips = hn::And(not_past(pick(Frames::dip_order)), dip < depth);
            depth = hn::IfThenElse(dips, dip, depth);
            depth_slope = hn::IfThenElse(dips, y_slope, depth_slope);
            const Mask lower = end_height < depth;
            const Real falls = hn::IfThenElseZero(found, (top_x * first.c - top_y * first.s) * end_slope);
            depth = hn::IfThenElse(lower, end_height, depth);
            depth_slope = hn::IfThenElse(lower, y_slope + falls, depth_slope);

            const Real graze_order = pick(Frames::graze_order);
            const Mask sweeps =
                hn::And(graze_order <= first.start_order, hn::Or(met.is(Meets::curb), not_past(graze_order)));
            const Real graze = hn::IfThenElse(sweeps, y + width - pick(Frames::lowest_radius), not_there);
            const Real first_graze =
                hn::IfThenElse(second, hn::IfThenElse(move_starts, not_there, hn::Load(reals, first_graze_)), graze);

            hn::Store(depth, reals, depth_);
            hn::Store(depth_slope, reals, depth_slope_);
            hn::Store(first_graze, reals, first_graze_);
            hn::Store(hn::IfThenElse(second, graze, not_there), reals, second_graze_);
            hn::Store(met.meets, whole, meets_);
            hn::Store(met.ahead, whole, ahead_);
            const unsigned are_stuck = bits_of(stuck);
            for (unsigned to_keep = bits_of(driven) & busy_; to_keep != 0; to_keep &= to_keep - 1) {
                const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(to_keep);
                keep(room.at(first_row + lane, static_cast<std::size_t>(changes_[lane])), lane,
                     (are_stuck >> lane & 1U) != 0, constants);
            }

            parks = hn::And(depth <= zero, hn::RebindMask(reals, hn::Load(whole, past_parked_) == hn::Zero(whole)));
            const Integer last = hn::Load(whole, last_);
            const Mask goes_on = hn::RebindMask(reals, hn::And(changes < last, changes < hn::Set(whole, limit)));
            const Mask stuck_before = hn::RebindMask(reals, hn::Load(whole, stuck_) != hn::Zero(whole));
            ends = hn::Or(hn::Or(hn::And(stuck, stuck_before), turned_away), hn::AndNot(goes_on, found));
            hn::Store(hn::IfThenElseZero(hn::RebindMask(whole, stuck), one), whole, stuck_);

            hn::Store(hn::IfThenElse(found, x_slope + across * cosine * end_slope, x_slope), reals, x_slope_);
            hn::Store(hn::IfThenElse(found, y_slope + across * sine * end_slope, y_slope), reals, y_slope_);
            hn::Store(hn::IfThenElse(found, end_slope, heading_slope), reals, heading_slope_);
            parks = hn::And(parks, driven);
        }

        hn::Store(hn::IfThenElse(found, x + across * sine, x), reals, x_);
        hn::Store(hn::IfThenElse(found, y - across * cosine, y), reals, y_);
        hn::Store(hn::IfThenElse(found, first.c, zero), reals, c_);
        hn::Store(hn::IfThenElse(found, first.s, hn::Set(reals, 1.0)), reals, s_);
        const auto found_whole = hn::RebindMask(whole, found);
        hn::Store(hn::IfThenElse(found_whole, changes + one, changes), whole, changes_);
        hn::Store(hn::IfThenElse(found_whole, quarter, one), whole, quarter_);
        hn::Store(hn::IfThenElseZero(hn::RebindMask(whole, hn::Not(found)), one), whole, crossed_);
        hn::Store(changes, whole, moves_);
        parks_ = bits_of(parks);
        ends_ = bits_of(ends) & ~parks_;
    }

    /// Hands in what is done, and begins new cases in its lanes.
    HWY_INLINE void renew(Source& source, const Room& room, std::size_t first_row) {
        for (unsigned done = (parks_ | ends_) & busy_; done != 0; done &= done - 1) {
            const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(done);
            const std::size_t index = index_[lane];
            if constexpr (Source::keeps_moves)
                source.keep(index, room.row(first_row + lane), static_cast<std::size_t>(moves_[lane]) + 1);
            if ((parks_ >> lane & 1U) != 0) {
                source.parks(index, moves_[lane]);
            } else {
                source.ends(index);
            }
            begin_next(source, lane);
        }
    }

private:
    template <class Contacts>
    [[nodiscard]] HWY_INLINE Contacts contacts(const Constants& constants, const Pick& pick) const {
        const Corner lowest = {pick(Frames::left), pick(Frames::bottom), pick(Frames::lowest_radius),
                               pick(Frames::lowest_per_square)};
        const Corner leftmost = {lowest.x, pick(Frames::up), pick(Frames::leftmost_radius),
                                 pick(Frames::leftmost_per_square)};
        const Corner rightmost = {pick(Frames::right), lowest.y, pick(Frames::rightmost_radius),
                                  pick(Frames::rightmost_per_square)};
        const Real y = hn::Load(reals, y_);
        const Real above_curb = y + hn::Load(reals, width_);
        Contacts first(hn::Load(reals, c_), hn::Load(reals, s_), hn::Set(reals, -2.0));
        first.rectangle_meets(
            lowest, leftmost, rightmost, lowest,
            {hn::Load(reals, x_), y, hn::Load(reals, length_), above_curb, y, y, hn::Set(reals, constants.touch)});
        return first;
    }

    /// Some circle may only just reach a line: all over again, and carefully.
    HWY_NOINLINE Careful look_again(const Constants& constants) const {
        const Integer odd = hn::And(hn::Load(whole, changes_), hn::Set(whole, 1));
        const Integer quarter = hn::Load(whole, quarter_);
        return contacts<Careful>(constants, Pick(constants.frames, odd + quarter + quarter));
    }

    HWY_INLINE void keep(FullMove& move, std::size_t lane, bool is_stuck, const Constants& constants) const {
        const auto frame = static_cast<std::size_t>((changes_[lane] & 1) + 2 * quarter_[lane]);
        move.meets = static_cast<Meets>(meets_[lane]);
        move.backward = (frame & 1) == 0;
        move.stuck = is_stuck;
        move.ahead = static_cast<std::uint8_t>(ahead_[lane]);
        move.quarter = static_cast<int>(quarter_[lane]);
        move.part = constants.frames.parts[frame][static_cast<std::size_t>(meets_[lane])];
        move.sector = 0;
        move.depth = depth_[lane];
        move.depth_slope = depth_slope_[lane];
        move.x = x_[lane];
        move.y = y_[lane];
        move.x_slope = x_slope_[lane];
        move.y_slope = y_slope_[lane];
        move.graze = {first_graze_[lane], second_graze_[lane]};
    }

    HWY_INLINE void begin_next(Source& source, std::size_t lane) {
        const auto* start = source.next();
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
        if constexpr (Source::keeps_moves) {
            x_slope_[lane] = start->x_slope;
            y_slope_[lane] = start->y_slope;
            heading_slope_[lane] = 1.0;
            stuck_[lane] = 0;
            last_[lane] = start->last;
            past_parked_[lane] = start->past_parked ? 1 : 0;
        }
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
    alignas(64) std::int64_t moves_[lanes] = {};  ///< the changes before the step
    std::size_t index_[lanes] = {};
    unsigned busy_ = 0;
    unsigned parks_ = 0;
    unsigned ends_ = 0;

    // Where moves are kept: what goes on from move to move, and what becomes of this one.
    static constexpr std::size_t kept = Source::keeps_moves ? lanes : 1;
    alignas(64) double x_slope_[kept] = {};
    alignas(64) double y_slope_[kept] = {};
    alignas(64) double heading_slope_[kept] = {};
    alignas(64) std::int64_t stuck_[kept] = {};
    alignas(64) std::int64_t last_[kept] = {};
    alignas(64) std::int64_t past_parked_[kept] = {};
    alignas(64) double depth_[kept] = {};
    alignas(64) double depth_slope_[kept] = {};
    alignas(64) double first_graze_[kept] = {};
    alignas(64) double second_graze_[kept] = {};
    alignas(64) std::int64_t meets_[kept] = {};
    alignas(64) std::int64_t ahead_[kept] = {};
};

template <class Source>
HWY_INLINE void drive_in_lanes(const FullSteering& steering, Source source) {
    const Constants constants(steering);
    std::array<LaneCases<Source>, vectors> running;
    Room room(vectors * lanes);
    for (LaneCases<Source>& vector : running) vector.fill(source);
    for (bool any = true; any;) {
        for (std::size_t i = 0; i < vectors; ++i)
            if (running[i].busy()) running[i].step(constants, source.limit(), room, i * lanes);
        any = false;
        for (std::size_t i = 0; i < vectors; ++i) {
            if (running[i].busy()) running[i].renew(source, room, i * lanes);
            any = any || running[i].busy();
        }
    }
}

void drive_all_in_lanes(Cases& cases) {
    if constexpr (lanes == 1) {  // nothing to gain
        while (const Cases::Start* start = cases.next()) cases.answer_alone(start->index);
    } else {
        drive_in_lanes(cases.steering(), Batch(cases));
    }
}

void follow_all_in_lanes(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest,
                         std::vector<FullMove>& moves) {
    if constexpr (lanes == 1) {
        follow_one_by_one(steering, runs, limit, fewest, moves);
    } else {
        drive_in_lanes(steering, Search(steering, runs, limit, fewest, moves));
    }
}

}  // namespace snug::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace snug::detail {

HWY_EXPORT(drive_all_in_lanes);
HWY_EXPORT(follow_all_in_lanes);

void drive_all(Cases& cases) { HWY_DYNAMIC_DISPATCH(drive_all_in_lanes)(cases); }

void follow_in_lanes(const FullSteering& steering, std::vector<Run>& runs, int limit, bool fewest,
                     std::vector<FullMove>& moves) {
    HWY_DYNAMIC_DISPATCH(follow_all_in_lanes)(steering, runs, limit, fewest, moves);
}

}  // namespace snug::detail
#endif
