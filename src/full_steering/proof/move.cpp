#include "full_steering/proof/move.hpp"

#include "model/angles.hpp"

namespace snug::detail::proof {

namespace {

/// Errors of the centre into two symbols: along the longest of the errors and square to it.
struct Column {
    double x = 0.0, y = 0.0;
};
static void gather(State& state, const std::array<Column, 2>& more) {
    const std::array<Column, 4> columns = {Column{state.x.first, state.y.first}, Column{state.x.second, state.y.second},
                                           more[0], more[1]};
    Column axis{1.0, 0.0};
    double longest = 0.0;
    for (const Column& column : columns) {
        const double square = column.x * column.x + column.y * column.y;
        if (square > longest) longest = square, axis = column;
    }
    if (longest > 1e-200) {
        const double length = std::sqrt(longest);
        axis = {axis.x / length, axis.y / length};
    } else {
        axis = {1.0, 0.0};
    }
    // Any vector w is axis * p + square * q, where p and q are its products with the two, but for the length of axis.
    double p = std::abs(axis.x) * state.x.rest + std::abs(axis.y) * state.y.rest;
    double q = std::abs(axis.y) * state.x.rest + std::abs(axis.x) * state.y.rest;
    double all = state.x.rest + state.y.rest;
    for (const Column& column : columns) {
        p += std::abs(axis.x * column.x + axis.y * column.y);
        q += std::abs(axis.x * column.y - axis.y * column.x);
        all += std::abs(column.x) + std::abs(column.y);
    }
    p = (p + 8.0 * unit * all) * (1.0 + 1e-14);
    q = (q + 8.0 * unit * all) * (1.0 + 1e-14);
    state.x.first = axis.x * p;
    state.y.first = axis.y * p;
    state.x.second = -axis.y * q;
    state.y.second = axis.x * q;
    state.x.rest = underflow;
    state.y.rest = underflow;
    state.x_noise = state.x.noise();
    state.y_noise = state.y.noise();
}

/// Over to the other side: the centre of the next move.
static void turn_over(State& state, const HeadingForm& at, double across) {
    const double far = at.off.size();
    const double square = 0.25 * far * far;
    Form off = at.off;
    off.rest = 0.0;
    const double shorter = 1.0 - square;  // cos, in the middle of its range
    state.x = state.x + ((across * at.c) * off + across * at.s * shorter);
    state.y = state.y + ((across * at.s) * off - across * at.c * shorter);
    // What (s, -c) and (c, s) are multiplied with is not known exactly: their length, cos and sin.
    const double along = std::abs(across) * (at.off.rest + far * far * far * (1.0 / 6.0) + 8.0 * unit) * (1.0 + 1e-12);
    const double beside = std::abs(across) * (square + 8.0 * unit) * (1.0 + 1e-12);
    gather(state, {Column{along * at.c, along * at.s}, Column{beside * at.s, -beside * at.c}});
    state.start = at;
    state.start.off = {at.off.mid, at.off.along, 0.0, 0.0, at.off.noise()};
    state.backward = !state.backward;
    state.first = false;
}

}  // namespace

Mover::Mover(const ProofProblem& problem, int max_changes)
    : problem_(problem),
      steerings_(steerings(problem)),
      steepest_(steepest_parked(problem)),
      sinking_(problem, steepest_),
      jam_(problem),
      likely_(static_cast<std::size_t>(max_changes) + 1, curb),
      space_(std::max({problem.body.size(), problem.at_curb.size(), problem.frame.size()}) + 4) {}

State Mover::enter(const Box& box) const {
    State state;
    const double middle = box.middle;
    const double half = box.half;
    const auto [s, c] = angles::sine_cosine(middle);
    state.start.c = c;
    state.start.s = s;
    state.start.angle = middle;
    // Sine and cosine are those of an angle within 4e-16 of the middle.
    state.start.off = {0.0, half, 0.0, 0.0, 4e-16};
    const Point& corner = problem_.body[problem_.entry_corner];
    const double x = corner.x;
    const double y = corner.y - problem_.radius;
    const double vx = x * c - y * s;
    const double vy = x * s + y * c;
    const double size = std::abs(x) + std::abs(y) + problem_.radius;
    const double far = state.start.off.size();
    const double square = 0.25 * far * far;
    const double error =
        16.0 * unit * (size + problem_.front_setback) + size * (1e-12 * square + far * far * far / 6.0);
    // The corner stays where it is: centre = (0, -front_setback) - (corner turned).
    state.x = (vy * state.start.off + (vx * square - vx)).with_rest(std::abs(vx) * square + error);
    state.y =
        (-vx * state.start.off + (vy * square - vy - problem_.front_setback)).with_rest(std::abs(vy) * square + error);
    gather(state, {});
    return state;
}

State Mover::enter(const Starts& starts) const {
    State state = enter(Box(starts.heading, starts.heading));
    const double along = 0.5 * (starts.along_min + starts.along_max);
    const double out = 0.5 * (starts.out_min + starts.out_max);
    const double along_half = std::max(starts.along_max - along, along - starts.along_min) * upward + underflow;
    const double out_half = std::max(starts.out_max - out, out - starts.out_min) * upward + underflow;
    state.x = state.x - along;
    state.y = state.y + out;
    // What reaches farther goes in the place of the heading, which is the same for all.
    const bool longer = along_half >= out_half;
    state.x.along = longer ? -along_half : 0.0;
    state.y.along = longer ? 0.0 : out_half;
    gather(state, {longer ? Column{0.0, out_half} : Column{along_half, 0.0}, Column{}});
    state.start.off = {0.0, 0.0, 0.0, 0.0, state.start.off.span()};
    state.first = false;
    // The point that would touch the corner is no farther ahead and no lower, so that condition does not hold.
    const std::vector<Stage>& stages = steerings_[0].of[front].stages;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const double end = i + 1 < stages.size() ? stages[i + 1].angle : stages[0].angle - 2.0 * pi;
        if (stages[i].entry_condition < 0 || starts.heading > stages[i].angle + 4.0 * angle_error ||
            starts.heading < end - 4.0 * angle_error)
            continue;
        state.touched[front].add(i, static_cast<std::size_t>(stages[i].entry_condition));
    }
    return state;
}

After Mover::move(const State& state, State& then, Outcome& outcome, const Failure* graze, bool meets_curb) {
    if (sinking_.too_high(state)) return After::ended;
    ++moves_;
    const Steering& steering = steerings_[state.backward ? 0 : 1];
    // What the box before met in this move is asked first.
    Met& likely = likely_[static_cast<std::size_t>(outcome.move)];
    const Met asked_first = likely;
    HeadingForm until = state.start;
    until.angle -= 2.0 * pi;
    bool contact = false;
    std::array<Touched, 3>& touched = then.touched;
    for (Touched& one : touched) one.count = 0, one.exact = false;
    // What cannot be told is asked again once it is known where the others stop the car: it may lie beyond.
    std::array<Met, 5> order = {asked_first, static_cast<Met>((asked_first + 1) % 3),
                                static_cast<Met>((asked_first + 2) % 3)};
    std::size_t asked = 3;
    Failure untold;          // of the first of them
    bool as_untold = false;  // and `until` is as it was then
    Meeting& meeting = meeting_;
    const BluntErrors errors(steering, state);
    BluntMove blunt = {errors, errors.at(state.start), errors.at(until)};
    for (std::size_t i = 0; i < asked; ++i) {
        const Met met = order[i];
        if (i == 3 && as_untold) {
            outcome.what = Outcome::undecided;
            outcome.failure = untold;
            return met == curb && untold.grazes ? After::grazed : After::ended;
        }
        if (graze != nullptr && meets_curb && met == curb) {
            meeting.what = Meeting::contact;
            meeting.at = graze->at;
            meeting.touched = {};
            meeting.touched.add(graze->stage, 0);
            meeting.touched.exact = true;
        } else {
            const Asked question = {steering.of[met], met, state, until, contact, blunt, met == curb ? graze : nullptr};
            if (!meets(question, space_, meeting)) doubtful_ = true;
        }
        if (meeting.what == Meeting::never) continue;
        if (meeting.what == Meeting::stuck) return After::ended;  // no entry, or stuck for good
        if (meeting.what == Meeting::undecided && i < 2) {
            if (asked == 3) untold = meeting.failure, as_untold = true;
            order[asked++] = met;
            continue;
        }
        if (meeting.what == Meeting::undecided) {
            outcome.what = Outcome::undecided;
            outcome.failure = meeting.failure;
            return met == curb && meeting.failure.grazes ? After::grazed : After::ended;
        }
        if (!contact) {
            contact = true;
            as_untold = false;
            until = meeting.at;
            blunt.until = errors.at(until);
            touched[met] = meeting.touched;
            likely = met;
            continue;
        }
        const Form other = off_from(until, meeting.at);
        const Form apart = until.off - other;
        if (apart.positive()) continue;
        as_untold = false;
        if (apart.negative()) {
            for (Touched& one : touched) one.count = 0, one.exact = false;
            touched[met] = meeting.touched;
            until = meeting.at;
            blunt.until = errors.at(until);
            likely = met;
        } else {
            until.off = larger(until.off, other);
            blunt.until = errors.at(until);
            for (Touched& one : touched) one.exact = false;
            touched[met] = meeting.touched;
            touched[met].exact = false;
        }
    }
    Meeting& parked = meeting;
    meets({steering.of[goal], goal, state, until, false, blunt}, space_, parked);
    if (parked.what == Meeting::undecided) {
        outcome.what = Outcome::undecided;
        outcome.failure = parked.failure;
        outcome.failure.parking = parked.failure.kind == Failure::at_root;
        return After::ended;
    }
    if (parked.what == Meeting::contact) {  // unless what stops the car comes first
        const Form before = difference(parked.at, until);
        if (before.positive()) {
            outcome.what = doubtful_ ? Outcome::undecided : Outcome::parks;
            return After::ended;
        }
        if (!before.negative()) {
            outcome.what = Outcome::undecided;
            outcome.failure = at_root_of(before);
            outcome.failure.parking = true;
            return After::ended;
        }
    }
    if (!contact) return After::ended;  // circles freely
    if (until.angle + until.off.mid + until.off.span() + angle_error < -steepest_) return After::ended;
    then.x = state.x;
    then.y = state.y;
    then.backward = state.backward;
    then.turned = {difference(state.start, until).mid, state.turned[0], state.turned[1]};
    turn_over(then, until, steering.across);
    return After::moved;
}

}  // namespace snug::detail::proof
