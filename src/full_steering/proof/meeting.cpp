#include "full_steering/proof/meeting.hpp"

#include <cstdint>

namespace snug::detail::proof {

namespace {

/// Two ways of which one is right.
Meeting either(const Meeting& a, const Meeting& b) {
    if (a.what == Meeting::undecided) return a;
    if (b.what == Meeting::undecided) return b;
    if (a.what != b.what) return cannot_tell({});
    if (a.what != Meeting::contact) return a;
    Meeting both = a;
    both.at.off = hull(a.at.off, off_from(a.at, b.at));
    both.touched.exact = false;
    if (b.touched.count < 0) both.touched.count = -1;
    for (int i = 0; i < b.touched.count; ++i) {
        const Touched::At& at = b.touched.at[static_cast<std::size_t>(i)];
        both.touched.add(at.stage, at.condition);
    }
    return both;
}

class Sweep {
public:
    Sweep(const Asked& asked, Space& space)
        : obstacle_(asked.obstacle),
          met_(asked.met),
          state_(asked.state),
          until_(asked.until),
          until_contact_(asked.until_contact),
          space_(space),
          blunt_(asked.blunt),
          passes_(asked.passes),
          until_wide_(until_.off.size()),
          until_noise_(until_.off.noise()),
          until_least_(until_.angle + until_.off.mid - until_.off.span() * (1.0 + 1e-12) - 3.0 * angle_error) {}

    [[nodiscard]] bool doubtful() const { return doubtful_; }

    void meets(Meeting& met) const {
        met.what = Meeting::never;
        met.touched.count = 0;
        met.touched.exact = false;
        const HeadingForm& start = state_.start;
        const double within = start.off.size() + 2.0 * angle_error;
        std::size_t stage = 0;
        double turns = 0.0;
        locate(start.angle, stage, turns);
        const double begin = obstacle_.stages[stage].angle - turns;
        // An entry heading is at most a quarter turn.
        const bool steepest = state_.first && begin > quarter_turn - 1e-15;
        const bool before_too = start.angle + within >= begin && !steepest;
        const bool after_too = start.angle - within <= end_of(stage, turns);
        if (!before_too && !after_too && plainly(stage, turns, met)) return;
        met = from_stage(stage, turns);
        if (met.what == Meeting::undecided) return;
        if (before_too) {
            const bool wraps = stage == 0;
            const std::size_t before = wraps ? obstacle_.stages.size() - 1 : stage - 1;
            met = either(met, from_stage(before, wraps ? turns - 2.0 * pi : turns));
        }
        if (after_too && met.what != Meeting::undecided) {
            const bool wraps = obstacle_.next(stage) == 0;
            met = either(met, from_stage(obstacle_.next(stage), wraps ? turns + 2.0 * pi : turns));
        }
    }

private:
    void locate(double angle, std::size_t& stage, double& turns) const {
        const std::vector<Stage>& stages = obstacle_.stages;
        turns = 0.0;
        while (angle > stages[0].angle - turns) turns -= 2.0 * pi;
        while (angle <= stages[0].angle - turns - 2.0 * pi) turns += 2.0 * pi;
        stage = 0;
        while (stage + 1 < stages.size() && angle <= stages[stage + 1].angle - turns) ++stage;
    }

    [[nodiscard]] double end_of(std::size_t stage, double turns) const {
        const std::size_t next = obstacle_.next(stage);
        return obstacle_.stages[next].angle - turns - (next == 0 ? 2.0 * pi : 0.0);
    }

    /// As if the move began in that stage.
    [[nodiscard]] Meeting from_stage(std::size_t stage, double turns) const {
        if (met_ == goal) return drive(stage, turns, -1, false);
        const Touched& touched = state_.touched[met_];
        if (obstacle_.one_condition && !state_.first)
            return drive(stage, turns, 0, touched.exact && touched.count == 1 && touched.at[0].stage == stage);
        if (state_.first) {
            const int known = met_ == front ? obstacle_.stages[stage].entry_condition : -1;
            return drive(stage, turns, known, known >= 0);
        }
        Meeting met;
        bool any = false;
        for (int i = 0; i < touched.count; ++i) {
            const Touched::At& at = touched.at[static_cast<std::size_t>(i)];
            if (at.stage != stage) continue;
            const Meeting one =
                drive(stage, turns, static_cast<int>(at.condition), touched.exact && touched.count == 1);
            met = any ? either(met, one) : one;
            any = true;
        }
        return any ? met : drive(stage, turns, -1, false);
    }

    [[nodiscard]] bool possible(const Stage& stage, double turns) const {
        return stage.possible && !(passes_ && &stage == &obstacle_.stages[passes_->stage]) &&
               (met_ != goal || turns == 0.0);
    }

    /// Where the next stage begins.
    [[nodiscard]] HeadingForm end_heading(std::size_t stage, double turns) const {
        const Stage& next = obstacle_.stages[obstacle_.next(stage)];
        return {next.c, next.s, end_of(stage, turns), {}};
    }

    /// The same as drive() in plain numbers, as long as they are clear enough; else false.
    [[nodiscard]] bool plainly(std::size_t stage, double turns, Meeting& met) const {
        const HeadingForm* from = &state_.start;
        double from_wide = from->off.size();
        double from_noise = from->off.noise();
        HeadingForm end;
        Blunt blunt_from = blunt_.start;
        int known = -1;
        if (state_.first) {
            if (met_ == front) known = obstacle_.stages[stage].entry_condition;
        } else if (met_ != goal) {
            const Touched& touched = state_.touched[met_];
            if (obstacle_.one_condition) known = 0;
            if (touched.count == 1 && touched.at[0].stage == stage) known = static_cast<int>(touched.at[0].condition);
        }
        for (;;) {
            const Stage& here = obstacle_.stages[stage];
            const std::size_t next = obstacle_.next(stage);
            const double end_angle = end_of(stage, turns);
            const bool last = until_least_ > end_angle;
            HeadingForm next_end;
            const HeadingForm* to = &until_;
            double to_wide = until_wide_, to_noise = until_noise_;
            if (!last) {
                next_end.c = obstacle_.stages[next].c;
                next_end.s = obstacle_.stages[next].s;
                next_end.angle = end_angle;
                to = &next_end;
                to_wide = to_noise = 0.0;
            }
            int failing = -1;
            if (possible(here, turns)) {
                Told told;
                failing = blunt_fails(here, blunt_from, last ? blunt_.until : blunt_.errors.at(obstacle_.stages[next]),
                                      known, told);
                if (failing < 0)
                    failing = plainly_fails(here, *from, from_wide, from_noise, *to, to_wide, to_noise, known, told);
                if (failing < 0) {
                    failing = plainly_begins(here, stage, *from, *to, last, told, met);
                    if (failing < 0) return met.what != Meeting::never;
                }
            }
            if (last) return true;
            known = failing >= 0 ? same_in(here, obstacle_.stages[next], failing) : -1;
            end.c = next_end.c;
            end.s = next_end.s;
            end.angle = next_end.angle;
            from = &end;
            from_wide = from_noise = 0.0;
            blunt_from = blunt_.errors.at(obstacle_.stages[next]);
            if (next == 0) turns += 2.0 * pi;
            stage = next;
        }
    }

    [[nodiscard]] Meeting drive(std::size_t stage, double turns, int known, bool exact) const {
        HeadingForm from = state_.start;
        Meeting pending;  // a contact that may lie beyond its stage
        bool last = false;
        for (;;) {
            const Stage& here = obstacle_.stages[stage];
            const std::size_t next = obstacle_.next(stage);
            HeadingForm to = end_heading(stage, turns);
            if (difference(until_, to).positive()) {
                to = until_;
                last = true;
            }
            int failing = -1;
            if (possible(here, turns)) {
                failing = failing_in(here, from, to, known);
            }
            if (failing < 0 && possible(here, turns)) {
                const Meeting met =
                    in_stage(here, stage, from, to, known, exact, last && met_ != goal && !until_contact_);
                switch (met.what) {
                    case Meeting::undecided:
                    case Meeting::stuck: return met;
                    case Meeting::contact: {
                        const bool late = met.failure.kind == Failure::at_root;  // it may begin beyond the end
                        if (pending.what == Meeting::contact) {
                            pending = either(pending, met);
                        } else {
                            pending = met;
                        }
                        if (!late || (last && met_ != goal && until_contact_)) return pending;
                        if (last || met_ == goal) return cannot_tell(met.failure);
                        break;
                    }
                    default:
                        if (pending.what == Meeting::contact) return cannot_tell(pending.failure);
                        break;
                }
            } else if (pending.what == Meeting::contact) {
                return cannot_tell(pending.failure);
            }
            if (last) return pending.what == Meeting::contact ? cannot_tell(pending.failure) : Meeting();
            from = to;
            known = failing >= 0 ? same_in(here, obstacle_.stages[next], failing) : -1;
            exact = false;
            if (next == 0) turns += 2.0 * pi;
            stage = next;
        }
    }

    /// A condition in the next stage: at the end of this one it has the same value. (An edge leaves the chain where it
    /// lies flat on what takes its place.)
    [[nodiscard]] int same_in(const Stage& here, const Stage& next, int which) const {
        const Condition& of = obstacle_.conditions[here.first + static_cast<std::size_t>(which)];
        const auto found = [&](Condition::Kind kind) {
            for (std::size_t i = next.first; i < next.last; ++i) {
                const Condition& other = obstacle_.conditions[i];
                if (other.kind == kind && (kind != Condition::inside || other.edge == of.edge))
                    return static_cast<int>(i - next.first);
            }
            return -1;
        };
        if (met_ == goal) return -1;
        if (of.kind != Condition::inside || found(of.kind) >= 0) return found(of.kind);
        return found(met_ == front ? Condition::below : Condition::left_of);
    }

    /// What blunt numbers tell of the conditions of a stage, a bit for each; of those beyond 64 they tell nothing.
    struct Told {
        std::uint64_t fail_first = 0;  ///< where it begins
        std::uint64_t hold = 0;        ///< where it begins or ends
        static std::uint64_t bit(int index) { return index < 64 ? std::uint64_t{1} << index : 0; }
    };

    /// A condition of the stage that fails all the time, told in plain numbers; -1 if there is none.
    [[nodiscard]] int blunt_fails(const Stage& stage, const Blunt& from, const Blunt& to, int known, Told& told) const {
        const int count = static_cast<int>(stage.last - stage.first);
        const int likely = stage.likely;
        const Condition* const conditions = obstacle_.conditions.data() + stage.first;
        for (int k = -1; k < count; ++k) {
            if (k == likely) continue;
            const int index = k < 0 ? likely : k;
            const Condition& condition = conditions[index];
            const Crossing<double> crossing = crossing_of(condition, state_);
            if (condition.kind != Condition::inside &&
                crossing.d - condition.radius > blunt_.errors.still) {  // all around
                stage.likely = index;
                return index;
            }
            const double first = gap(crossing, from.c, from.s);
            if (first > from.value_error) {
                told.hold |= Told::bit(index);
                if (index != known) continue;
            }
            if (-first > from.value_error) told.fail_first |= Told::bit(index);
            const bool falls = crossing.b * from.c - crossing.a * from.s > from.pace_error;
            if (!(-first > from.value_error) && !(index == known && falls)) continue;
            const double pace = crossing.b * to.c - crossing.a * to.s;
            const double last = gap(crossing, to.c, to.s);
            if ((falls && pace > to.pace_error) || (-last > to.value_error && (falls || -pace > to.pace_error))) {
                stage.likely = index;
                return index;
            }
            if (last > to.value_error) told.hold |= Told::bit(index);
        }
        return -1;
    }

    [[nodiscard]] int plainly_fails(const Stage& stage, const HeadingForm& from, double from_wide, double from_noise,
                                    const HeadingForm& to, double to_wide, double to_noise, int known,
                                    const Told& told) const {
        const int count = static_cast<int>(stage.last - stage.first);
        const int likely = stage.likely;
        for (int k = -1; k < count; ++k) {
            if (k == likely) continue;
            const int index = k < 0 ? likely : k;
            if ((told.hold & Told::bit(index)) != 0 && index != known) continue;
            const Condition& condition = obstacle_.conditions[stage.first + static_cast<std::size_t>(index)];
            const Crossing<double> crossing = crossing_of(condition, state_);
            const Rough first(condition, crossing, state_, from, from_wide, from_noise);
            const bool falls = first.falls();
            if (!first.fails() && !(index == known && falls)) continue;
            const Rough last(condition, crossing, state_, to, to_wide, to_noise);
            // All the way, or with no greatest value in between.
            if ((falls && last.falls()) || (last.fails() && (falls || last.rises()))) {
                stage.likely = index;
                return index;
            }
        }
        return -1;
    }

    /// One condition fails where the stage begins and begins to hold in it, and then all others hold: that is the contact,
    /// and there is none before. Or it begins only beyond the end: then it fails all the time, and comes back; else -1.
    [[nodiscard]] int plainly_begins(const Stage& stage, std::size_t index, const HeadingForm& from,
                                     const HeadingForm& to, bool last, const Told& told, Meeting& met) const {
        std::size_t begins = stage.last;
        double best_s = 0.0, best_c = 0.0;
        for (std::size_t i = stage.first; i < stage.last; ++i) {
            const Condition& condition = obstacle_.conditions[i];
            const std::uint64_t bit = Told::bit(static_cast<int>(i - stage.first));
            const Crossing<double> crossing = crossing_of(condition, state_);
            if ((told.fail_first & bit) == 0 && !Rough(condition, crossing, state_, from).fails()) continue;
            double c = 0.0, s = 0.0;
            if (!heading_of(condition, crossing, true, c, s)) return -1;
            if (begins != stage.last && best_s * c - best_c * s < 0.0) continue;  // another one begins later
            begins = i, best_c = c, best_s = s;
        }
        if (begins == stage.last) return -1;
        met.at.c = best_c, met.at.s = best_s;
        if (!root_at(obstacle_.conditions[begins], state_, true, from.angle, met.at)) return -1;
        if (!difference(from, met.at).positive()) return -1;
        // Beyond the end of the move another obstacle stops the car all the same.
        bool late = false;
        if (!(last && until_contact_)) {
            const Form before = difference(met.at, to);
            if (before.negative()) return static_cast<int>(begins - stage.first);
            late = !before.positive();
            if (late && met_ != goal) return -1;
        }
        const Blunt there = blunt_.errors.at(met.at);
        for (std::size_t i = stage.first; i < stage.last; ++i) {
            const Condition& condition = obstacle_.conditions[i];
            if (i == begins) continue;
            const Crossing<double> crossing = crossing_of(condition, state_);
            if (gap(crossing, there.c, there.s) > there.value_error) continue;
            if (!Rough(condition, crossing, state_, met.at).holds()) return -1;
        }
        if (late) {  // perhaps
            const Doing at_end(obstacle_.conditions[begins], state_, to);
            if (at_end.sign != Sign::unknown) return -1;
            met.what = Meeting::undecided;
            met.failure = at_root_of(at_end.value);
            return -1;
        }
        met.what = Meeting::contact;
        met.touched.add(index, begins - stage.first);
        met.touched.exact = true;
        return -1;
    }

    /// A condition of the stage that fails all the time, -1 if there is none. What all of them do at the beginning,
    /// and those at the end that were asked for, stay in the space. `known` may become known.
    [[nodiscard]] int failing_in(const Stage& stage, const HeadingForm& from, const HeadingForm& to, int& known) const {
        const std::size_t count = stage.last - stage.first;
        Doing* const first = space_.first.data();
        Doing* const last = space_.last.data();
        std::size_t unknown = 0;
        std::size_t holding = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Condition& condition = obstacle_.conditions[stage.first + i];
            first[i] = Doing(condition, state_, from);
            if (first[i].sign == Sign::positive) ++holding;
            if (first[i].sign == Sign::unknown) unknown = i;
            if (first[i].sign == Sign::negative || static_cast<int>(i) == known) {
                last[i] = Doing(condition, state_, to);
                if (fails_throughout(first[i], last[i], static_cast<int>(i) == known)) return static_cast<int>(i);
            }
        }
        // Nothing overlaps when a move begins: where all others hold, the one that cannot be told does not.
        const bool at_start = from.angle == state_.start.angle;
        if (known < 0 && met_ != goal && at_start && holding + 1 == count && first[unknown].sign == Sign::unknown) {
            known = static_cast<int>(unknown);
            doubtful_ = state_.first;
            last[unknown] = Doing(obstacle_.conditions[stage.first + unknown], state_, to);
            if (fails_throughout(first[unknown], last[unknown], true)) return known;
        }
        return -1;
    }

    /// Is a condition of the stage exactly zero where the move begins?
    [[nodiscard]] bool zero_at_start(const Stage& stage, std::size_t index, std::size_t i) const {
        if (state_.first) {
            const int entry = stage.entry_condition;
            return entry >= 0 && (static_cast<int>(i) == entry || static_cast<int>(i) + 1 == entry);
        }
        const Touched& touched = state_.touched[met_];
        return touched.exact && touched.count == 1 && touched.at[0].stage == index && touched.at[0].condition == i;
    }

    /// A contact comes back with failure.kind at_root where it may lie beyond `to`.
    [[nodiscard]] Meeting in_stage(const Stage& stage, std::size_t index, const HeadingForm& from,
                                   const HeadingForm& to, int known, bool exact, bool closes) const {
        const std::size_t count = stage.last - stage.first;
        Doing* const first = space_.first.data();
        Doing* const last = space_.last.data();
        Spells* const spells = space_.spells.data();
        int* const at = space_.at.data();
        bool all_hold = true;
        bool stuck = false;
        for (std::size_t i = 0; i < count; ++i) {
            const Condition& condition = obstacle_.conditions[stage.first + i];
            const bool is_known = static_cast<int>(i) == known;
            const bool is_exact = exact && (is_known || (state_.first && static_cast<int>(i) + 1 == known));
            if (first[i].sign != Sign::negative && !is_known) last[i] = Doing(condition, state_, to);
            if (closes && last[i].sign == Sign::unknown && zero_at_start(stage, index, i)) {
                // Once around: exactly zero again.
                if (last[i].going == Sign::positive) last[i].sign = Sign::negative;
                if (last[i].going == Sign::negative) last[i].sign = Sign::positive;
            }
            spells_of(spells[i], condition, state_, from, to, first[i], last[i], is_known, is_exact);
            at[i] = 0;
            stuck = stuck || spells[i].zero_and_begins;
            all_hold = all_hold && spells[i].holds_at_start;
        }
        if (all_hold) {
            Meeting met;
            if (met_ == goal) {  // parked where it starts
                met.what = Meeting::contact;
                met.at = from;
                return met;
            }
            if (stuck || (state_.first && known < 0)) {
                met.what = Meeting::stuck;
                return met;
            }
            return cannot_tell({});
        }
        for (std::size_t i = 0; i < count; ++i) {
            if (!spells[i].told) {
                // Another condition may still say never.
                for (std::size_t k = 0; k < count; ++k) {
                    if (spells[k].told && spells[k].count == 0) return {};
                }
                Meeting met = cannot_tell(spells[i].failure);
                met.failure.stage = index;
                met.failure.grazes = met.failure.grazes && obstacle_.one_condition;
                return met;
            }
        }
        for (;;) {
            Meeting met;
            met.what = Meeting::contact;
            bool begun = false;
            bool late = false;
            Form late_by;
            for (std::size_t i = 0; i < count; ++i) {
                if (at[i] >= spells[i].count) return {};
                const Spell& spell = spells[i].spell[static_cast<std::size_t>(at[i])];
                if (spell.from_start) continue;
                if (spell.begins_late) late = true, late_by = last[i].value;
                if (!begun) {
                    met.at = spell.begin;
                    met.touched.add(index, i);
                    begun = true;
                    continue;
                }
                const Form later = off_from(met.at, spell.begin);
                const Form apart = met.at.off - later;
                if (apart.positive()) {  // this one begins after the others
                    met.at = spell.begin;
                    met.touched = {};
                    met.touched.add(index, i);
                } else if (!apart.negative()) {
                    met.at.off = -larger(-met.at.off, -later);
                    met.touched.add(index, i);
                }
            }
            bool at_once = !begun;
            if (!begun) {
                met.at = from;  // all hold at the start, for as long as that lasts
                for (std::size_t i = 0; i < count; ++i) {
                    const Spell& spell = spells[i].spell[static_cast<std::size_t>(at[i])];
                    if (!spell.to_end && !spells[i].holds_at_start) return cannot_tell(at_root_of(first[i].value));
                }
            }
            if (begun) {
                const Form before = off_from(met.at, from);
                const Form apart = before - met.at.off;
                at_once = !apart.positive();
                if (apart.negative()) {
                    met.at = from;
                } else if (at_once) {
                    met.at.off = -larger(-met.at.off, -before);
                }
            }
            bool advanced = false;
            for (std::size_t i = 0; i < count && !advanced; ++i) {
                const Spell& spell = spells[i].spell[static_cast<std::size_t>(at[i])];
                if (spell.to_end) continue;
                const Form left = difference(met.at, spell.end);
                if (left.positive()) continue;
                if (!left.negative()) return cannot_tell(at_root_of(left));
                ++at[i];
                advanced = true;
            }
            if (advanced) continue;
            met.touched.exact = met.touched.count == 1;
            if (at_once) {  // perhaps where the move begins: nothing overlaps there, so one of those that are not sure to hold
                met.touched = {};
                for (std::size_t i = 0; i < count; ++i) {
                    if (first[i].sign != Sign::positive) met.touched.add(index, i);
                }
            }
            if (late) met.failure.kind = Failure::at_root, met.failure.quantity = late_by;
            return met;
        }
    }

    const Obstacle& obstacle_;
    Met met_;
    const State& state_;
    const HeadingForm& until_;
    bool until_contact_;
    Space& space_;
    const BluntMove& blunt_;
    const Failure* passes_;  ///< a graze that is taken to pass
    double until_wide_, until_noise_;
    double until_least_;             ///< the heading of all of them is greater
    mutable bool doubtful_ = false;  ///< nothing overlaps at the entry position, if that is one
};

}  // namespace

bool meets(const Asked& asked, Space& space, Meeting& met) {
    const Sweep sweep(asked, space);
    sweep.meets(met);
    return !sweep.doubtful();
}

}  // namespace snug::detail::proof
