#include "full_steering/proof/driver.hpp"

namespace snug::detail::proof {

Outcome Driver::look(Box& box, int limit) {
    limit_ = limit;
    ++boxes_;
    forks_ = 0;
    narrow_ = box.max - box.min < 1e-6;
    mover_.forget();
    trail_[static_cast<std::size_t>(box.driven)] = box.driven == 0 ? mover_.enter(box) : box.state;
    const Outcome outcome = follow(box.driven);
    box.doubtful = mover_.doubtful();
    return outcome;
}

Outcome Driver::look(const Starts& starts, int limit) {
    limit_ = limit;
    ++boxes_;
    forks_ = 0;
    narrow_ = true;
    mover_.forget();
    trail_.front() = mover_.enter(starts);
    return follow(0);
}

Outcome Driver::follow(int n) {
    const int start = n;
    for (; n <= limit_; ++n) {
        const std::size_t at = static_cast<std::size_t>(n);
        Outcome outcome;
        outcome.move = n;
        if ((n == start || n == 1 || n % 4 == 0) && n > 0 && jams(n, outcome)) return outcome;
        const After after = mover_.move(trail_[at], trail_[at + 1], outcome);
        if (after == After::moved) continue;
        const bool some_park = outcome.failure.parking && changes_sign(outcome.failure.quantity);
        if (outcome.what == Outcome::undecided && narrow_ && !some_park) {
            for (int k = start; k <= n; ++k)
                if (jams(k, outcome, true)) return outcome;
        }
        return after == After::grazed ? both_ways(outcome) : outcome;
    }
    return {Outcome::none, limit_, true, {}};
}

/// Do none of the cars park in the moves from n to the limit, because they jam?
bool Driver::jams(int n, Outcome& outcome, bool anyway) const {
    const Jammed jammed = mover_.jams(before(n), limit_ - n + 1, anyway);
    if (jammed == Jammed::no) return false;
    outcome = {Outcome::none, n - 1, jammed == Jammed::for_now, {}};
    return true;
}

/// Where it cannot be told whether the lowest corner grazes the curb: first as if it passed, then as if it met it. If
/// both come to the same, it does not matter.
Outcome Driver::both_ways(const Outcome& fork) {
    if (++forks_ > most_forks) return fork;
    Outcome common;
    const std::size_t at = static_cast<std::size_t>(fork.move);
    for (const bool meets : {false, true}) {
        if (!meets && fork.failure.surely) continue;
        Outcome outcome;
        outcome.move = fork.move;
        const After after = mover_.move(trail_[at], trail_[at + 1], outcome, &fork.failure, meets);
        if (after == After::grazed) return fork;
        if (after == After::moved) outcome = follow(fork.move + 1);
        if (outcome.what == Outcome::undecided) return fork;
        if (!meets || fork.failure.surely) {
            common = outcome;
        } else if (outcome.what != common.what || (outcome.what == Outcome::parks && outcome.move != common.move)) {
            return fork;
        }
        common.goes_on = common.goes_on || outcome.goes_on;
    }
    return common;
}

}  // namespace snug::detail::proof
