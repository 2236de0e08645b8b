// When a condition holds between two headings, for all cars of a box.
#pragma once

#include <array>

#include "full_steering/proof/gaps.hpp"

namespace snug::detail::proof {

/// A time during which a condition holds.
struct Spell {
    bool from_start = false;   ///< it holds at the beginning of the stage
    bool to_end = false;       ///< it may hold beyond the end
    bool begins_late = false;  ///< it may begin beyond the end
    HeadingForm begin;
    HeadingForm end;
};

struct Spells {
    int count = 0;
    bool told = true;
    std::array<Spell, 2> spell;
    Failure failure;
    bool zero_and_begins = false;  ///< exactly zero at the beginning, and from then on positive
    bool holds_at_start = false;
};

enum class Sign : unsigned char { negative, unknown, positive };

inline Sign sign_of(const Form& x) {
    return x.positive() ? Sign::positive : x.negative() ? Sign::negative : Sign::unknown;
}

/// What a condition does at a heading: its sign and, as the heading falls, where it goes.
struct Doing {
    Sign sign = Sign::unknown;
    Sign going = Sign::unknown;
    Form value;
    Form pace;  ///< d g / d heading
    Doing() = default;
    Doing(const Condition& of, const State& state, const HeadingForm& at) {
        const Gap gap = gap_of(of, state, at.c, at.s);
        value = gap.at(at.off);
        sign = sign_of(value);
        pace = gap.pace(at.off);
        going = sign_of(-pace);
    }
};

/// Does the condition fail from one heading to another, for all cars? Conservative and quick.
inline bool fails_throughout(const Doing& from, const Doing& to, bool known_not_to_hold) {
    const bool falls = from.going == Sign::negative;
    if (from.sign != Sign::negative && !(known_not_to_hold && falls)) return false;
    if (falls && to.going == Sign::negative) return true;                       // all the way
    return to.sign == Sign::negative && (falls || to.going == Sign::positive);  // no greatest value in between
}

/// When a condition holds between two headings at most a quarter turn apart. `known`: it does not hold at the first one;
/// `exact`: it is exactly zero there.
void spells_of(Spells& all, const Condition& of, const State& state, const HeadingForm& from, const HeadingForm& to,
               const Doing& first, const Doing& last, bool known, bool exact);

}  // namespace snug::detail::proof
