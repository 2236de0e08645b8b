#include "full_steering/proof/spells.hpp"

namespace snug::detail::proof {

namespace {

/// Where a condition that is exactly zero and falls is zero again: as far behind the heading at which it is least as the
/// start is before it.
bool comes_back(const Condition& of, const State& state, const HeadingForm& start, HeadingForm& found) {
    const Crossing<double> crossing = crossing_of(of, state);
    const double radius = std::sqrt(crossing.a * crossing.a + crossing.b * crossing.b);
    double c = -crossing.a / radius;
    double s = -crossing.b / radius;
    if (!(radius > 0.0) || !make_unit(c, s)) return false;
    const Gap gap = gap_of(of, state, c, s);
    const double bend = std::abs(gap.bend) - gap.bend_error;
    const double error = (std::abs(gap.slope) + gap.slope_error) / bend * (1.0 + 1e-12);  // tan of its error
    if (!(bend > 0.0 && error < 0.1)) return false;
    const double twice_c = (c - s) * (c + s);
    const double twice_s = 2.0 * c * s;
    found.c = twice_c * start.c + twice_s * start.s;
    found.s = twice_s * start.c - twice_c * start.s;
    if (!make_unit(found.c, found.s)) return false;
    found.angle = near_angle(found.c, found.s, start.angle);
    if (!(std::abs(found.angle - start.angle) < quarter_turn)) return false;
    found.off = (-start.off).with_rest(2.0 * error + 32.0 * unit);
    return true;
}

/// Where a corner that only just sinks below the curb meets it: at most an angle a before it is lowest, where
/// radius (1 - cos a) is how far it sinks.
bool grazing(const Condition& of, const Form& sinks, double reference, Failure& failure) {
    const double radius = std::sqrt(of.x * of.x + of.y * of.y);
    const double part = (sinks.mid + sinks.span()) / (radius - of.error) * (1.0 + 1e-12);
    if (of.kind != Condition::below || !(part > 0.0 && part < 1e-3)) return false;
    HeadingForm& at = failure.at;
    at.c = -of.y / radius;
    at.s = -of.x / radius;
    if (!make_unit(at.c, at.s)) return false;
    at.angle = near_angle(at.c, at.s, reference);
    const double half = 0.5 * std::sqrt(2.0 * part) * (1.0 + part) * (1.0 + 1e-12);
    at.off = {half, 0.0, 0.0, 0.0, half + 1e-15 + of.error / radius};
    return true;
}

}  // namespace

void spells_of(Spells& all, const Condition& of, const State& state, const HeadingForm& from, const HeadingForm& to,
               const Doing& first, const Doing& last, bool known, bool exact) {
    all.count = 0;
    all.told = true;
    all.zero_and_begins = false;
    all.failure.grazes = false;
    const double reference = from.angle;
    const auto fail = [&](Failure::Kind kind, const Form& quantity) {
        all.told = false;
        all.failure.kind = kind;
        all.failure.quantity = quantity;
    };
    const auto begins = [&](Spell& spell) { return root_of(of, state, true, reference, spell.begin); };
    const auto ends = [&](Spell& spell) { return root_of(of, state, false, reference, spell.end); };
    const auto graze = [&](bool greatest) {
        const Form extreme = extreme_of(of, state, greatest);
        fail(sign_of(extreme) == Sign::unknown ? Failure::at_root : Failure::beside_graze,
             greatest ? extreme : -extreme);
        if (!greatest || first.sign != Sign::negative || last.sign != Sign::negative) return;
        all.failure.grazes = grazing(of, extreme, reference, all.failure);
        all.failure.surely = extreme.positive() && first.going == Sign::positive && last.going == Sign::negative;
    };
    Sign at_first = first.sign;
    if (known && first.going == Sign::negative) at_first = Sign::negative;
    if (exact && first.going == Sign::positive) {
        at_first = Sign::positive;
        all.zero_and_begins = true;
    }
    all.holds_at_start = at_first == Sign::positive;

    Spell spell;
    if (at_first == Sign::negative) {
        const bool touching = first.sign != Sign::negative;  // its end was just now: only the next beginning counts
        if (last.sign == Sign::negative) {
            if (first.going == Sign::negative || last.going == Sign::positive) return;
            const Form peak = extreme_of(of, state, true);
            if (peak.negative()) return;
            if (touching || !peak.positive()) return graze(true);
            if (!begins(spell) || !ends(spell)) return graze(true);
            // The signs at the ends leave both roots between them, or neither.
            const Form before_end = difference(spell.begin, to);
            if (difference(spell.begin, from).positive() || before_end.negative()) return;
            if (!before_end.positive()) return graze(true);
            all.count = 1;
            all.spell[0] = spell;
            return;
        }
        // What touches and parts slowly comes back soon.
        if (!begins(spell) && !(exact && touching && comes_back(of, state, from, spell.begin)))
            return touching ? fail(Failure::beside_graze, first.pace) : graze(true);
        spell.to_end = true;
        if (last.sign == Sign::unknown) {
            if (last.going == Sign::unknown) return graze(true);
            if (last.going == Sign::positive) {
                spell.begins_late = true;
            } else if (touching) {
                return graze(true);
            } else {
                spell.to_end = false;
                if (!difference(spell.begin, to).positive() || !ends(spell)) return graze(true);
            }
        }
        all.count = 1;
        all.spell[0] = spell;
        return;
    }
    if (at_first == Sign::positive) {
        spell.from_start = true;
        spell.to_end = true;
        Spell again;
        again.to_end = true;
        if (last.sign == Sign::positive) {
            const bool no_trough = first.going == Sign::positive || last.going == Sign::negative;
            if (!no_trough) {
                const Form trough = extreme_of(of, state, false);
                if (!trough.positive()) {
                    if (!trough.negative()) return graze(false);
                    spell.to_end = false;
                    if (!ends(spell) || !begins(again)) return graze(false);
                    if (!(difference(from, spell.end).positive() && difference(spell.end, again.begin).positive() &&
                          difference(again.begin, to).positive()))
                        return fail(Failure::halve, {});
                    all.spell[1] = again;
                    all.count = 2;
                    all.spell[0] = spell;
                    return;
                }
            }
            all.count = 1;
            all.spell[0] = spell;
            return;
        }
        if (last.sign == Sign::unknown && last.going == Sign::unknown) return graze(false);
        spell.to_end = false;
        if (!ends(spell)) return graze(false);
        all.count = 1;
        all.spell[0] = spell;
        if (last.sign == Sign::unknown && last.going == Sign::positive) {
            again.begins_late = true;
            if (!begins(again)) return graze(false);
            all.spell[1] = again;
            all.count = 2;
        }
        return;
    }
    // It cannot be told at the beginning.
    if (first.going == Sign::unknown) return fail(Failure::at_root, known ? first.pace : first.value);
    if (first.going == Sign::positive) {
        if (!begins(spell)) return fail(Failure::at_root, first.value);
        spell.to_end = true;
        if (last.sign != Sign::positive) {
            if (last.going == Sign::unknown) return graze(true);
            if (last.going == Sign::negative) {
                spell.to_end = false;
                if (!ends(spell)) return graze(true);
            } else if (last.sign == Sign::unknown) {
                spell.begins_late = true;
            } else {
                return fail(Failure::at_root, first.value);
            }
        }
        all.count = 1;
        all.spell[0] = spell;
        return;
    }
    spell.from_start = true;
    if (!ends(spell)) return fail(Failure::at_root, first.value);
    all.count = 1;
    all.spell[0] = spell;
    if (last.sign != Sign::negative) {
        Spell again;
        again.to_end = true;
        if (last.sign == Sign::unknown) {
            if (last.going == Sign::negative) return;  // the same end
            if (last.going == Sign::unknown) return graze(false);
            again.begins_late = true;
        }
        if (!begins(again)) return fail(Failure::at_root, first.value);
        all.spell[1] = again;
        all.count = 2;
    }
}

}  // namespace snug::detail::proof
