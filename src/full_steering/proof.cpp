// Branch and bound over boxes of headings. The strategy is driven with all headings of a box at once, every quantity a
// Form (enclosure.hpp). At the end of a box one of three things is known: all its headings park in move n and in none
// before; none parks in the moves asked for; or something could not be told, and the box is cut there.
//
// Obstacles. A convex car overlaps a neighbour exactly when no axis separates them: its rightmost corner is past the
// neighbour's side, its lowest corner below the neighbour's top, and the neighbour's corner inside every edge of the
// chain between the two. So each obstacle is a set of conditions g > 0 that must hold at once, each a sinusoid of the
// heading; contact is the latest of their onsets, and the first obstacle the one whose contact has the greatest heading.
// Being parked is one more such set. Which corner is lowest, and so on, changes where an edge is parallel to an axis:
// between these headings, a quarter turn apart at most, lies a stage, and in a stage a condition holds during one spell,
// or during two when it holds at its beginning, ends and returns.
//
// How far round. A car may turn any way in one move, up to a full circle, and parks at the first moment at which its
// frame is inside; a circle without contact ends the run. But a car that comes to rest at a heading steeper than any at
// which it fits between entry side and curb (below parallel, short of half a turn) has turned away: headings only
// fall, so it could fit again only half a turn later, the other way round, and that counts no more.
#include "full_steering/proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "full_steering/enclosure.hpp"
#include "model/angles.hpp"

namespace snug::detail {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double quarter_turn = 1.57079632679489661923;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double narrowest = 1e-13;  ///< boxes are not cut further [rad]

/// One condition g > 0. Corners and edges are seen from the turning centre.
struct Condition {
    enum Kind : unsigned char {
        right_of,  ///< a corner of the car right of x = level
        left_of,   ///< left of x = level
        below,     ///< below y = level
        inside     ///< the point (kx, ky) inside an edge of the car with normal (x, y) at distance level
    };
    Kind kind = below;
    double x = 0.0, y = 0.0;
    double level = 0.0;
    double kx = 0.0, ky = 0.0;
    std::size_t edge = 0;  ///< which
    double error = 0.0;    ///< of g and of its slope, by rounding in the making and in the use of the above [m]
    double a = 0.0, b = 0.0, px = 0.0, py = 0.0, k = 0.0;  ///< of a corner: g = a c + b s + px X + py Y + k
    double radius = 0.0;                                   ///< and sqrt(a^2 + b^2)

    void set_linear() {
        switch (kind) {
            case right_of: a = x, b = -y, px = 1.0, k = -level; break;
            case left_of: a = -x, b = y, px = -1.0, k = level; break;
            case below: a = -y, b = -x, py = -1.0, k = level; break;
            case inside: break;
        }
        radius = std::sqrt(a * a + b * b);
    }
};

/// Between two neighbouring headings at which an edge is parallel to an axis; headings fall from (c, s) on.
struct Stage {
    double c = 1.0, s = 0.0, angle = 0.0;  ///< its beginning
    std::size_t first = 0, last = 0;       ///< its conditions
    int entry_condition = -1;  ///< of the front neighbour: this and the one before it are zero at the entry position
    bool possible = true;      ///< false: cannot be met here
    mutable int likely = 0;    ///< the condition that failed when last asked: it is asked first
};

struct Obstacle {
    std::vector<Stage> stages;  ///< falling; after the last comes the first, a turn later
    std::vector<Condition> conditions;
    bool one_condition = false;
    bool tilted = false;  ///< parked up to some heading only: a car that has gone round is not

    [[nodiscard]] std::size_t next(std::size_t stage) const { return stage + 1 == stages.size() ? 0 : stage + 1; }
};

enum Met : unsigned char { front, rear, curb, goal };

/// Everything about one steering: obstacles seen from its turning centre.
struct Steering {
    double across = 0.0;  ///< twice the radius, negative to the right: from this centre to the next one
    std::array<Obstacle, 4> of;
    double reach = 0.0;         ///< of all corners of the car the farthest from the centre, as |x| + |y|
    double corner_reach = 0.0;  ///< of the slot's corners, from its origin
    double error = 0.0;         ///< of no condition it is greater

    void note_reach() {
        for (const Obstacle& obstacle : of) {
            for (const Condition& condition : obstacle.conditions) {
                error = std::max({error, condition.error, 64.0 * unit * std::abs(condition.level)});
                if (condition.kind == Condition::inside) {
                    corner_reach = std::max(corner_reach, std::abs(condition.kx) + std::abs(condition.ky));
                } else {
                    reach = std::max(reach, std::abs(condition.x) + std::abs(condition.y));
                }
            }
        }
    }
};

/// The polygons' corners as they stand at a heading.
struct Extremes {
    std::size_t lowest = 0, rightmost = 0, leftmost = 0, highest = 0;
    Extremes(const std::vector<Point>& corners, double angle) {
        const auto [s, c] = angles::sine_cosine(angle);
        const auto x = [&, cosine = c, sine = s](std::size_t i) { return corners[i].x * cosine - corners[i].y * sine; };
        const auto y = [&, cosine = c, sine = s](std::size_t i) { return corners[i].x * sine + corners[i].y * cosine; };
        for (std::size_t i = 1; i < corners.size(); ++i) {
            if (y(i) < y(lowest)) lowest = i;
            if (y(i) > y(highest)) highest = i;
            if (x(i) > x(rightmost)) rightmost = i;
            if (x(i) < x(leftmost)) leftmost = i;
        }
    }
};

double size_of(const std::vector<Point>& corners) {
    double size = 0.0;
    for (const Point& corner : corners) size = std::max(size, std::abs(corner.x) + std::abs(corner.y));
    return size;
}

class Maker {
public:
    Maker(const ProofProblem& problem, double offset) : problem_(problem), offset_(offset) {}

    [[nodiscard]] Steering make() const {
        Steering steering;
        steering.across = 2.0 * offset_;
        steering.of[front] = neighbour(true);
        steering.of[rear] = neighbour(false);
        steering.of[curb] = ground();
        steering.of[goal] = inside();
        steering.note_reach();
        return steering;
    }

private:
    enum Axis { down, right, left, up };

    /// Headings at which an edge of the polygon faces one of the axes, and all quarters (stages are no longer than that).
    static void add_stages(std::vector<Stage>& stages, const std::vector<Point>& corners,
                           const std::vector<Axis>& axes) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point n = normal(corners, i);
            for (const Axis axis : axes) {
                switch (axis) {
                    case down: add(stages, -n.y, -n.x); break;
                    case right: add(stages, n.x, -n.y); break;
                    case left: add(stages, -n.x, n.y); break;
                    case up: add(stages, n.y, n.x); break;
                }
            }
        }
    }

    static void add(std::vector<Stage>& stages, double c, double s) {
        Stage stage;
        stage.c = c;
        stage.s = s;
        stage.angle = angles::atan2(s, c);
        stages.push_back(stage);
    }

    static void finish(std::vector<Stage>& stages) {
        add(stages, 1.0, 0.0);
        add(stages, 0.0, 1.0);
        add(stages, -1.0, 0.0);
        add(stages, 0.0, -1.0);
        for (Stage& stage : stages) {
            if (stage.angle <= -pi + 1e-16) stage.angle = pi;
        }
        std::sort(stages.begin(), stages.end(), [](const Stage& a, const Stage& b) { return a.angle > b.angle; });
        std::vector<Stage> kept;
        for (const Stage& stage : stages) {
            if (kept.empty() || kept.back().angle - stage.angle > 4e-16) kept.push_back(stage);
        }
        stages = kept;
    }

    static double middle(const std::vector<Stage>& stages, std::size_t i) {
        const double end = i + 1 < stages.size() ? stages[i + 1].angle : stages[0].angle - 2.0 * pi;
        return 0.5 * (stages[i].angle + end);
    }

    static Point normal(const std::vector<Point>& corners, std::size_t i) {
        const Point& a = corners[i];
        const Point& b = corners[(i + 1) % corners.size()];
        const double dx = b.x - a.x;
        const double dy = b.y - a.y;
        const double length = angles::hypot(dx, dy);
        return {dy / length, -dx / length};
    }

    /// A corner, sixteen roundings of its place, eight of what a stage that begins a little too late may do to it.
    [[nodiscard]] Condition corner(Condition::Kind kind, const std::vector<Point>& corners, std::size_t i,
                                   double level) const {
        Condition condition;
        condition.kind = kind;
        condition.x = corners[i].x;
        condition.y = corners[i].y - offset_;
        condition.level = level;
        condition.error = unit * (16.0 * (std::abs(condition.x) + std::abs(condition.y) + std::abs(offset_)) +
                                  16.0 * size_of(corners) + 2.0 * std::abs(level));
        condition.set_linear();
        return condition;
    }

    [[nodiscard]] Condition edge(const std::vector<Point>& corners, std::size_t i, Point at) const {
        const Point n = normal(corners, i);
        Condition condition;
        condition.kind = Condition::inside;
        condition.x = n.x;
        condition.y = n.y;
        condition.level = corners[i].x * n.x + (corners[i].y - offset_) * n.y;
        condition.edge = i;
        condition.kx = at.x;
        condition.ky = at.y;
        condition.error = unit * 32.0 * (size_of(corners) + std::abs(offset_) + std::abs(at.x) + std::abs(at.y));
        return condition;
    }

    [[nodiscard]] Obstacle neighbour(bool ahead) const {
        const std::vector<Point>& body = problem_.body;
        const Point corner_at =
            ahead ? Point{0.0, -problem_.front_setback} : Point{-problem_.length, -problem_.rear_setback};
        Obstacle made;
        add_stages(made.stages, body, {down, ahead ? right : left});
        finish(made.stages);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const Extremes at(body, middle(made.stages, k));
            stage.first = made.conditions.size();
            const std::size_t from = ahead ? at.lowest : at.leftmost;
            const std::size_t to = ahead ? at.rightmost : at.lowest;
            if (ahead) made.conditions.push_back(corner(Condition::below, body, at.lowest, corner_at.y));
            if (!ahead) made.conditions.push_back(corner(Condition::left_of, body, at.leftmost, corner_at.x));
            for (std::size_t i = from;; i = (i + 1) % body.size()) {
                if (ahead && i == problem_.entry_corner)
                    stage.entry_condition = static_cast<int>(made.conditions.size() - stage.first);
                if (i == to) break;
                made.conditions.push_back(edge(body, i, corner_at));
            }
            if (ahead) made.conditions.push_back(corner(Condition::right_of, body, at.rightmost, corner_at.x));
            if (!ahead) made.conditions.push_back(corner(Condition::below, body, at.lowest, corner_at.y));
            stage.last = made.conditions.size();
        }
        return made;
    }

    [[nodiscard]] Obstacle ground() const {
        Obstacle made;
        made.one_condition = true;
        add_stages(made.stages, problem_.at_curb, {down});
        finish(made.stages);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const Extremes at(problem_.at_curb, middle(made.stages, k));
            stage.first = made.conditions.size();
            made.conditions.push_back(corner(Condition::below, problem_.at_curb, at.lowest, -problem_.width));
            stage.last = made.conditions.size();
        }
        return made;
    }

    /// The frame inside the slot. Below the entry side it cannot be beside the slot without being in a neighbour, unless
    /// that begins deeper.
    [[nodiscard]] Obstacle inside() const {
        const std::vector<Point>& frame = problem_.frame;
        Obstacle made;
        add_stages(made.stages, frame, {up});
        if (problem_.parked_curb < infinity) add_stages(made.stages, frame, {down});
        if (problem_.front_setback > 0.0) add_stages(made.stages, frame, {right});
        if (problem_.rear_setback > 0.0) add_stages(made.stages, frame, {left});
        const bool tilted = problem_.parked_heading < infinity;
        made.tilted = tilted;
        const double most = std::min(problem_.parked_heading, pi);
        if (tilted) {
            const auto [s, c] = angles::sine_cosine(most);
            add(made.stages, c, s);
            add(made.stages, c, -s);
        }
        finish(made.stages);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const double heading = middle(made.stages, k);
            stage.possible = !tilted || std::abs(heading) <= problem_.parked_heading;
            const Extremes at(frame, heading);
            stage.first = made.conditions.size();
            made.conditions.push_back(corner(Condition::below, frame, at.highest, 0.0));
            if (problem_.parked_curb < infinity)
                made.conditions.push_back(
                    corner(Condition::below, frame, at.lowest, problem_.parked_curb - problem_.width));
            if (problem_.front_setback > 0.0)
                made.conditions.push_back(corner(Condition::left_of, frame, at.rightmost, 0.0));
            if (problem_.rear_setback > 0.0)
                made.conditions.push_back(corner(Condition::right_of, frame, at.leftmost, -problem_.length));
            stage.last = made.conditions.size();
        }
        return made;
    }

    const ProofProblem& problem_;
    double offset_;  ///< of the centre, to the left of the rear axle's middle
};

/// Conditions of an obstacle at least one of which does not hold at the start of a move, because the last one ended there.
struct Touched {
    struct At {
        std::uint32_t stage = 0;
        std::uint32_t condition = 0;  ///< within the stage
    };
    int count = 0;
    bool exact = false;  ///< the one condition is exactly zero
    std::array<At, 4> at;

    void add(std::size_t stage, std::size_t condition) {
        for (int i = 0; i < count; ++i) {
            if (at[static_cast<std::size_t>(i)].stage == stage &&
                at[static_cast<std::size_t>(i)].condition == condition)
                return;
        }
        if (count < 0 || count == 4) {
            count = -1;  // nothing is known
            return;
        }
        at[static_cast<std::size_t>(count++)] = {static_cast<std::uint32_t>(stage),
                                                 static_cast<std::uint32_t>(condition)};
    }
};

/// All cars of a box between two moves.
struct State {
    Form x, y;  ///< turning centre of the next move
    HeadingForm start;
    std::array<Touched, 3> touched;
    bool backward = true;
    bool first = true;
    double x_noise = 0.0, y_noise = 0.0;  ///< of the centre: how far it can be from a straight line in the heading
};

/// A stretch of headings, and what is known of it when its first moves are driven.
struct Box {
    double min = 0.0, max = 0.0;
    double middle = 0.0, half = 0.0;                  ///< its headings are middle + t * half with t in [-1, 1]
    bool doubtful = false;                            ///< it may be no entry position
    int away_from = std::numeric_limits<int>::max();  ///< the move after which it may have turned away
    int driven = 0;                                   ///< so many moves
    State state;                                      ///< after them

    Box(double least, double most)
        : min(least),
          max(most),
          middle(0.5 * (least + most)),
          half(std::max(max - middle, middle - min) * upward + 1e-300) {}
};

/// Why something could not be told, and so where to cut: at the root of a quantity, or (beside a graze) nearer to it.
struct Failure {
    enum Kind : unsigned char { halve, at_root, beside_graze } kind = halve;
    Form quantity;
    /// The lowest corner grazes the curb, in this stage: it meets it in `at`, or (unless `surely`) passes.
    bool grazes = false;
    bool surely = false;
    std::size_t stage = 0;
    HeadingForm at;
};

Gap gap_of(const Condition& of, const State& state, double c, double s) {
    Gap gap;
    if (of.kind == Condition::inside) {
        const double nx = of.x * c - of.y * s;
        const double ny = of.x * s + of.y * c;
        const Form x = state.x - of.kx;
        const Form y = state.y - of.ky;
        const Form bend = nx * x + ny * y;
        const Form slope = nx * y - ny * x;
        const double error = of.error + 32.0 * unit * (x.size() + y.size());
        gap.value = (bend + of.level).with_rest(error);
        gap.slope = slope.mid;
        gap.slope_error = slope.span() + error;
        gap.bend = bend.mid;
        gap.bend_error = bend.span() + error;
        return gap;
    }
    const double vx = of.x * c - of.y * s;
    const double vy = of.x * s + of.y * c;
    switch (of.kind) {
        case Condition::right_of:
            gap.value = (state.x + (vx - of.level)).with_rest(of.error);
            gap.slope = -vy;
            gap.bend = vx;
            break;
        case Condition::left_of:
            gap.value = (-state.x + (of.level - vx)).with_rest(of.error);
            gap.slope = vy;
            gap.bend = -vx;
            break;
        default:
            gap.value = (-state.y + (of.level - vy)).with_rest(of.error);
            gap.slope = -vx;
            gap.bend = -vy;
            break;
    }
    gap.slope_error = of.error;
    gap.bend_error = of.error;
    return gap;
}

/// g = a c + b s + constant for the headings in the middle of the box: what the crossing equation asks for.
struct Crossing {
    double a, b, constant;
    Crossing(const Condition& of, const State& state) {
        if (of.kind == Condition::inside) {
            const double x = state.x.mid - of.kx;
            const double y = state.y.mid - of.ky;
            a = x * of.x + y * of.y, b = y * of.x - x * of.y, constant = of.level;
        } else {
            a = of.a, b = of.b, constant = of.px * state.x.mid + of.py * state.y.mid + of.k;
        }
    }
    [[nodiscard]] double at(double c, double s) const { return a * c + b * s + constant; }
    /// The heading at which the condition begins to hold (or ends) for a car turning clockwise; false if there is none.
    [[nodiscard]] bool root(bool begins, double& c, double& s) const {
        const double square = a * a + b * b;
        const double d = -constant;
        const double radius = std::sqrt(square);
        const double inner = (radius - d) * (radius + d);
        if (!(inner > 0.0)) return false;
        const double across = begins ? std::sqrt(inner) : -std::sqrt(inner);
        c = (a * d - b * across) / square;
        s = (b * d + a * across) / square;
        return true;
    }
};

/// To a length of one but for four roundings; false if it is not near.
bool make_unit(double& c, double& s) {
    const double square = c * c + s * s;
    if (!(std::abs(square - 1.0) < 1e-8)) return false;
    const double factor = 1.5 - 0.5 * square;
    c *= factor;
    s *= factor;
    return true;
}

double near_angle(double c, double s, double reference) {
    const double angle = angles::atan2(s, c);
    return angle + 2.0 * pi * std::round((reference - angle) / (2.0 * pi));
}

/// What a condition is for all cars of a box, in few plain numbers: that of the car in the middle, and how far from it the
/// others' may be, all that is not a straight line in the heading as one error. Quicker than Forms, and enough for most.
struct Rough {
    double value, pace;  ///< g and d g / d heading
    double value_error, pace_error;

    /// A heading turned by t has the value  value + pace sin t - (a c + b s) (1 - cos t), and one of another centre that
    /// plus normal . (that centre - this one).
    Rough(const Condition& of, const Crossing& crossing, const State& state, const HeadingForm& at)
        : Rough(of, crossing, state, at, at.off.size(), at.off.noise()) {}
    Rough(const Condition& of, const Crossing& crossing, const State& state, const HeadingForm& at, double wide,
          double noise) {
        const double reach = std::abs(crossing.a) + std::abs(crossing.b);
        const double rounding = of.error + 64.0 * unit * (reach + std::abs(crossing.constant));
        double along = 0.0;
        double centre_error = 0.0;
        double centre_shift = 0.0;  // where the normal turns
        if (of.kind == Condition::inside) {
            along = (of.x * at.c - of.y * at.s) * state.x.along + (of.x * at.s + of.y * at.c) * state.y.along;
            centre_error = state.x_noise + state.y_noise;
            centre_shift = std::abs(state.x.along) + std::abs(state.y.along) + centre_error;
        } else {
            along = of.px * state.x.along + of.py * state.y.along;
            centre_error = std::abs(of.px) * state.x_noise + std::abs(of.py) * state.y_noise;
        }
        pace = crossing.b * at.c - crossing.a * at.s;
        value = crossing.at(at.c, at.s) + pace * at.off.mid;
        along += pace * at.off.along;
        const double curved =
            (centre_shift + (0.5 * reach + std::abs(pace) * wide) * wide) * wide;  // |sin t - t| < |t|^3
        value_error = (std::abs(along) + std::abs(pace) * noise + curved + centre_error + rounding) * (1.0 + 1e-12);
        pace_error = (reach * wide + centre_shift + rounding) * (1.0 + 1e-12);
    }
    [[nodiscard]] bool holds() const { return value > value_error; }
    [[nodiscard]] bool fails() const { return -value > value_error; }
    [[nodiscard]] bool falls() const { return pace > pace_error; }  ///< as the car turns on
    [[nodiscard]] bool rises() const { return -pace > pace_error; }
};

/// The same once more for all conditions at one heading: no value and no pace is off by more than this. Quicker still, and
/// enough for most.
struct Blunt {
    double c, s;
    double value_error, pace_error;
};

/// What is the same for all headings of a move.
struct Bluntly {
    double shift, reach, still;

    Bluntly(const Steering& steering, const State& state) {
        const double centre = std::abs(state.x.mid) + std::abs(state.y.mid);
        shift = std::abs(state.x.along) + std::abs(state.y.along) + state.x_noise + state.y_noise;
        reach = std::max(steering.reach, 1.5 * (centre + steering.corner_reach));
        still = (shift + (2.0 * steering.error + 64.0 * unit * (reach + centre))) * (1.0 + 1e-12);
    }
    [[nodiscard]] Blunt at(const HeadingForm& heading) const {
        const double wide = heading.off.size();
        return {heading.c, heading.s, (still + (shift + (1.0 + (0.5 + wide) * wide) * reach) * wide) * (1.0 + 1e-12),
                (still + reach * wide) * (1.0 + 1e-12)};
    }
    [[nodiscard]] Blunt at(const Stage& stage) const { return {stage.c, stage.s, still, still}; }
};

/// The heading at which the condition begins to hold (or ends), for all cars of the box; false unless they all have one
/// near each other. By Newton's way for intervals: where g changes its sign within `far` of the heading in the middle, and
/// its slope does not, there is exactly one root.
bool root_of(const Condition& of, const State& state, bool begins, double reference, HeadingForm& found) {
    const Crossing crossing(of, state);
    if (!crossing.root(begins, found.c, found.s) || !make_unit(found.c, found.s)) return false;
    const Gap gap = gap_of(of, state, found.c, found.s);
    if (begins != (gap.slope < 0.0)) return false;
    const double wide = gap.value.size();
    const double bend = std::abs(gap.bend) + gap.bend_error;
    const double steep = std::abs(gap.slope) - gap.slope_error;
    const double inner = steep * steep - 4.5 * bend * wide;
    if (!(steep > 0.0 && inner > 0.0)) return false;
    const double far = 2.001 * wide / (steep + std::sqrt(inner));
    if (!(far < 0.5)) return false;
    const double least = steep - bend * far - 0.5 * std::abs(gap.slope) * far * far;
    if (!(least * far > wide * (1.0 + 1e-12))) return false;
    // slope * sin a = bend (1 - cos a) - value
    const double per_slope = 1.0 / gap.slope;
    const double square = 0.25 * far * far;
    const Form right = -gap.value + gap.bend * square;
    const double error = gap.slope_error * far + (std::abs(gap.bend) + 2.0 * gap.bend_error) * square * (1.0 + 1e-12) +
                         std::abs(gap.slope) * far * far * far * (1.0 / 6.0) + 4.0 * unit * right.size();
    found.off = per_slope * right.with_rest(error * (1.0 + 1e-12));
    found.angle = near_angle(found.c, found.s, reference);
    return true;
}

/// The greatest value of g over a whole turn (or the least): sqrt(P^2 + Q^2) is between P and P + Q^2 / 2P.
Form extreme_of(const Condition& of, const State& state, bool greatest) {
    const Crossing crossing(of, state);
    const double radius = std::sqrt(crossing.a * crossing.a + crossing.b * crossing.b);
    double c = crossing.a / radius;
    double s = crossing.b / radius;
    if (!greatest) c = -c, s = -s;
    if (!(radius > 0.0) || !make_unit(c, s)) return {0.0, 0.0, 0.0, 0.0, infinity};
    const Gap gap = gap_of(of, state, c, s);
    const double slope = std::abs(gap.slope) + gap.slope_error;
    const double bend = std::abs(gap.bend) - gap.bend_error;
    if (!(bend > 0.0)) return {0.0, 0.0, 0.0, 0.0, infinity};
    const double beyond = slope * slope / (2.0 * bend) * (1.0 + 1e-12);
    return (gap.value + (greatest ? 0.5 : -0.5) * beyond).with_rest(0.5 * beyond * (1.0 + 1e-12));
}

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

Sign sign_of(const Form& x) { return x.positive() ? Sign::positive : x.negative() ? Sign::negative : Sign::unknown; }

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
bool fails_throughout(const Doing& from, const Doing& to, bool known_not_to_hold) {
    const bool falls = from.going == Sign::negative;
    if (from.sign != Sign::negative && !(known_not_to_hold && falls)) return false;
    if (falls && to.going == Sign::negative) return true;                       // all the way
    return to.sign == Sign::negative && (falls || to.going == Sign::positive);  // no greatest value in between
}

/// Where a condition that is exactly zero and falls is zero again: as far behind the heading at which it is least as the
/// start is before it.
bool comes_back(const Condition& of, const State& state, const HeadingForm& start, HeadingForm& found) {
    const Crossing crossing(of, state);
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
    failure.surely = sinks.positive();
    return true;
}

/// When a condition holds between two headings at most a quarter turn apart. `known`: it does not hold at the first one;
/// `exact`: it is exactly zero there.
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
        if (greatest && last.sign == Sign::negative) all.failure.grazes = grazing(of, extreme, reference, all.failure);
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
            // Both roots lie before the end only if the peak does; the signs at the ends leave both or neither.
            if (difference(spell.begin, from).positive() || difference(to, spell.begin).positive()) return;
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
                if (!ends(spell)) return graze(true);
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

/// What comes of an obstacle in a move.
struct Meeting {
    enum What : unsigned char { never, contact, stuck, undecided } what = never;
    HeadingForm at;
    Touched touched;
    Failure failure;
};

Meeting cannot_tell(const Failure& failure) {
    Meeting meeting;
    meeting.what = Meeting::undecided;
    meeting.failure = failure;
    return meeting;
}

Failure at_root_of(const Form& quantity) {
    Failure failure;
    failure.kind = Failure::at_root;
    failure.quantity = quantity;
    return failure;
}

/// In the frame of x: y as x's heading turned by some Form.
Form off_from(const HeadingForm& x, const HeadingForm& y) {
    return (y.off + (y.angle - x.angle)).with_rest(2.0 * angle_error);
}

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

/// Room for the conditions of one stage.
struct Space {
    std::vector<Doing> first, last;
    std::vector<Spells> spells;
    std::vector<int> at;
    explicit Space(std::size_t most) : first(most), last(most), spells(most), at(most) {}
};

struct MoveBounds {
    Bluntly all;
    Blunt start, until;
    double within;
};

class Sweep {
public:
    Sweep(const Obstacle& obstacle, Met met, const State& state, const HeadingForm& until, bool until_contact,
          Space& space, const MoveBounds& bluntly, const Failure* passes = nullptr)
        : obstacle_(obstacle),
          met_(met),
          state_(state),
          until_(until),
          until_contact_(until_contact),
          space_(space),
          bluntly_(bluntly),
          passes_(passes),
          until_wide_(until.off.size()),
          until_noise_(until.off.noise()),
          until_least_(until.angle + until.off.mid - until.off.span() * (1.0 + 1e-12) - 3.0 * angle_error) {}

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
               (met_ != goal || turns == 0.0 || !obstacle_.tilted);
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
        Blunt blunt_from = bluntly_.start;
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
                failing = bluntly_fails(here, blunt_from,
                                        last ? bluntly_.until : bluntly_.all.at(obstacle_.stages[next]), known);
                if (failing < 0)
                    failing = plainly_fails(here, *from, from_wide, from_noise, *to, to_wide, to_noise, known);
                if (failing < 0) return plainly_begins(here, stage, *from, *to, met);
            }
            if (last) return true;
            known = failing >= 0 ? same_in(here, obstacle_.stages[next], failing) : -1;
            end.c = next_end.c;
            end.s = next_end.s;
            end.angle = next_end.angle;
            from = &end;
            from_wide = from_noise = 0.0;
            blunt_from = bluntly_.all.at(obstacle_.stages[next]);
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

    /// A condition of the stage that fails all the time, told in plain numbers; -1 if there is none.
    [[nodiscard]] int bluntly_fails(const Stage& stage, const Blunt& from, const Blunt& to, int known) const {
        const int count = static_cast<int>(stage.last - stage.first);
        const int likely = stage.likely;
        const Condition* const conditions = obstacle_.conditions.data() + stage.first;
        for (int k = -1; k < count; ++k) {
            if (k == likely) continue;
            const int index = k < 0 ? likely : k;
            const Condition& condition = conditions[index];
            const Crossing crossing(condition, state_);
            if (condition.kind != Condition::inside &&
                -(condition.radius + crossing.constant) > bluntly_.all.still) {  // all around
                stage.likely = index;
                return index;
            }
            const bool falls = crossing.b * from.c - crossing.a * from.s > from.pace_error;
            if (!(-crossing.at(from.c, from.s) > from.value_error) && !(index == known && falls)) continue;
            const double pace = crossing.b * to.c - crossing.a * to.s;
            if ((falls && pace > to.pace_error) ||
                (-crossing.at(to.c, to.s) > to.value_error && (falls || -pace > to.pace_error))) {
                stage.likely = index;
                return index;
            }
        }
        return -1;
    }

    [[nodiscard]] int plainly_fails(const Stage& stage, const HeadingForm& from, double from_wide, double from_noise,
                                    const HeadingForm& to, double to_wide, double to_noise, int known) const {
        const int count = static_cast<int>(stage.last - stage.first);
        const int likely = stage.likely;
        for (int k = -1; k < count; ++k) {
            if (k == likely) continue;
            const int index = k < 0 ? likely : k;
            const Condition& condition = obstacle_.conditions[stage.first + static_cast<std::size_t>(index)];
            const Crossing crossing(condition, state_);
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
    /// and there is none before.
    [[nodiscard]] bool plainly_begins(const Stage& stage, std::size_t index, const HeadingForm& from,
                                      const HeadingForm& to, Meeting& met) const {
        std::size_t begins = stage.last;
        double best_s = 0.0, best_c = 0.0;
        for (std::size_t i = stage.first; i < stage.last; ++i) {
            const Condition& condition = obstacle_.conditions[i];
            const Crossing crossing(condition, state_);
            if (!Rough(condition, crossing, state_, from).fails()) continue;
            double c = 0.0, s = 0.0;
            if (!crossing.root(true, c, s)) return false;
            if (begins != stage.last && best_s * c - best_c * s < 0.0) continue;  // another one begins later
            begins = i, best_c = c, best_s = s;
        }
        if (begins == stage.last) return false;
        if (!root_of(obstacle_.conditions[begins], state_, true, from.angle, met.at)) return false;
        if (!difference(from, met.at).positive() || !difference(met.at, to).positive()) return false;
        for (std::size_t i = stage.first; i < stage.last; ++i) {
            const Condition& condition = obstacle_.conditions[i];
            if (i == begins) continue;
            if (!Rough(condition, Crossing(condition, state_), state_, met.at).holds()) return false;
        }
        met.what = Meeting::contact;
        met.touched.add(index, begins - stage.first);
        met.touched.exact = true;
        return true;
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
    const MoveBounds& bluntly_;
    const Failure* passes_;  ///< a graze that is taken to pass
    double until_wide_, until_noise_;
    double until_least_;             ///< the heading of all of them is greater
    mutable bool doubtful_ = false;  ///< nothing overlaps at the entry position, if that is one
};

/// What came of a box.
struct Outcome {
    enum What : unsigned char { none, parks, undecided } what = none;
    int move = 0;
    bool goes_on = false;  ///< none in the moves asked for, and more could follow
    Failure failure;
};

class Prover {
public:
    Prover(const ProofProblem& problem, int max_changes, Find find, const ProofHints& hints, const Progress& progress,
           std::size_t most_moves)
        : problem_(problem),
          backward_(Maker(problem, problem.radius).make()),
          forward_(Maker(problem, -problem.radius).make()),
          steepest_(steepest_fit(problem)),
          asked_(max_changes),
          limit_(max_changes),
          find_(find),
          hints_(hints),
          progress_(progress),
          most_moves_(most_moves),
          likely_(static_cast<std::size_t>(max_changes) + 1, curb),
          trail_(static_cast<std::size_t>(max_changes) + 2),
          space_(std::max({problem.body.size(), problem.at_curb.size(), problem.frame.size()}) + 4) {}

    ProvedRanges run() {
        divide();
        if (find_ == Find::all) {
            limit_ = asked_;
            search();
        } else {
            // Few moves first: no box is driven far for nothing. Then only what could still park goes on.
            int allowed = hints_.changes >= 0 ? std::min(hints_.changes, asked_) : std::min(2, asked_);
            for (bool first = true;; first = false) {
                const int before = limit_;
                const std::vector<Sliver> left = found_.undecided;
                limit_ = allowed;
                if (!first) {
                    boxes_.swap(later_);
                    std::reverse(boxes_.begin(), boxes_.end());
                    later_.clear();
                }
                search();
                const bool complete = found_.moves <= most_moves_;
                if (!complete && !first && found_.ranges.empty()) {  // what was proved before stays
                    limit_ = before;
                    found_.undecided = left;
                }
                if (!complete || !found_.ranges.empty() || allowed == asked_ || found_.cancelled) break;
                allowed = std::min(asked_, 2 * allowed + 2);
            }
            put_in_order(found_.undecided);
            std::erase_if(found_.ranges, [this](const CountedHeadings& range) { return range.changes > limit_; });
        }
        std::erase_if(found_.undecided, [this](const Sliver& sliver) { return sliver.from_changes > limit_; });
        found_.proved_changes = limit_;
        return std::move(found_);
    }

private:
    /// The steepest heading (downwards) at which the frame is below the entry side and what meets the curb above it;
    /// none below a quarter turn.
    static double steepest_fit(const ProofProblem& problem) {
        const auto height = [&](double heading) {
            const auto [s, c] = angles::sine_cosine(heading);
            double low = infinity, high = -infinity;
            for (const Point& corner : problem.at_curb) low = std::min(low, corner.x * s + corner.y * c);
            for (const Point& corner : problem.frame) high = std::max(high, corner.x * s + corner.y * c);
            return high - low;
        };
        const double size = size_of(problem.frame) + size_of(problem.at_curb);
        const double slack = 1e-12 * size;
        double steepest = std::min(problem.parked_heading, quarter_turn);
        if (height(-steepest) <= problem.width + slack) return steepest < quarter_turn ? steepest : infinity;
        // The height changes by less than the sizes per radian: steps that cannot miss a fit.
        const double speed = 2.0 * size;
        while (steepest > 0.0) {
            const double over = height(-steepest) - problem.width;
            if (over <= slack) break;
            steepest -= std::max(over / speed, 1e-12);
        }
        return std::max(steepest, 0.0) + 1e-9;
    }

    /// All headings there are, in a first few boxes.
    void divide() {
        const double end = quarter_turn;
        std::vector<double> cuts = {0.0};
        for (const double cut : hints_.headings) {
            if (cut > cuts.back() && cut < end) cuts.push_back(cut);
        }
        constexpr int first_boxes = 16;
        if (cuts.size() == 1) {
            for (int i = 1; i < first_boxes; ++i) cuts.push_back(end * i / first_boxes);
        }
        cuts.push_back(std::nextafter(end, 2.0));
        for (std::size_t i = cuts.size() - 1; i-- > 0;) boxes_.emplace_back(cuts[i], cuts[i + 1]);
    }

    void search() {
        std::vector<Box>& boxes = boxes_;
        std::size_t next_report = 100'000;
        while (!boxes.empty()) {
            Box box = boxes.back();
            boxes.pop_back();
            if (progress_ && found_.moves >= next_report) {
                next_report = found_.moves + 100'000;
                if (!progress_(box.min / quarter_turn)) found_.cancelled = true;
            }
            if (found_.cancelled || found_.moves > most_moves_) {
                note_undecided(box, 0);
                continue;
            }
            const Outcome outcome = look(box);
            switch (outcome.what) {
                case Outcome::none:
                    if (outcome.goes_on && limit_ < asked_ && find_ != Find::all) keep(box);
                    break;
                case Outcome::parks:
                    if (find_ != Find::all) limit_ = std::min(limit_, outcome.move);
                    note_range(box, outcome.move);
                    break;
                case Outcome::undecided:
                    if (box.max - box.min <= narrowest || hopeless(box, outcome.failure.quantity)) {
                        note_undecided(box, outcome.move);
                    } else {
                        cut(boxes, box, outcome);
                    }
                    break;
            }
        }
    }

    /// For when more moves are allowed.
    void keep(const Box& box) {
        Box& kept = later_.emplace_back(box);
        if (kept.doubtful || kept.away_from < std::numeric_limits<int>::max()) {
            kept.driven = 0;
        } else if (forks_ == 0) {
            kept.driven = limit_ + 1;
            kept.state = trail_[static_cast<std::size_t>(kept.driven)];
        }
    }

    /// In rising order, those that touch as one.
    static void put_in_order(std::vector<Sliver>& slivers) {
        std::sort(slivers.begin(), slivers.end(), [](const Sliver& a, const Sliver& b) { return a.min < b.min; });
        std::vector<Sliver> whole;
        for (const Sliver& sliver : slivers) {
            if (!whole.empty() && whole.back().max == sliver.min) {
                whole.back().max = sliver.max;
                whole.back().from_changes = std::min(whole.back().from_changes, sliver.from_changes);
            } else {
                whole.push_back(sliver);
            }
        }
        slivers = whole;
    }

    /// Narrow, and what could not be told depends on rounding more than on the heading: no cut would help.
    static bool hopeless(const Box& box, const Form& quantity) {
        const double noise = quantity.noise();
        return (box.max - box.min < 4e-12 && std::abs(quantity.along) < 2.0 * noise) ||
               (std::abs(quantity.along) < 0.1 * noise && std::abs(quantity.mid) < noise && noise < 1e-12);
    }

    void note_range(const Box& box, int changes) {
        std::vector<CountedHeadings>& ranges = found_.ranges;
        if (!ranges.empty() && ranges.back().changes == changes && ranges.back().max == box.min) {
            ranges.back().max = box.max;
        } else {
            ranges.push_back({box.min, box.max, changes});
        }
    }

    void note_undecided(const Box& box, int from_changes) {
        std::vector<Sliver>& slivers = found_.undecided;
        if (!slivers.empty() && slivers.back().max == box.min) {
            slivers.back().max = box.max;
            slivers.back().from_changes = std::min(slivers.back().from_changes, from_changes);
        } else {
            slivers.push_back({box.min, box.max, from_changes});
        }
    }

    void cut(std::vector<Box>& boxes, const Box& box, const Outcome& outcome) const {
        const Failure& failure = outcome.failure;
        const double half = box.half;
        const double middle = box.middle;
        const Form& q = failure.quantity;
        if (failure.kind == Failure::at_root && q.along != 0.0 && q.noise() < infinity) {
            const double root = -q.mid / q.along;
            const double wide = 1.01 * q.noise() / std::abs(q.along) + 0.3 * narrowest / half;
            if (wide < 0.3 && std::abs(root) < 1.0 + wide) {
                const double at = std::clamp(root, -1.0, 1.0);
                const double a = middle + half * (at - wide);
                const double b = middle + half * (at + wide);
                if (b < box.max) add(boxes, box, b, box.max, outcome.move);
                add(boxes, box, std::max(a, box.min), std::min(b, box.max), outcome.move);
                if (a > box.min) add(boxes, box, box.min, a, outcome.move);
                return;
            }
        }
        double at = 0.5 * (box.min + box.max);
        if (failure.kind == Failure::beside_graze) {
            const double left = q.mid - q.along;
            const double right = q.mid + q.along;
            if (left * right > 0.0 && (left / right > 3.0 || right / left > 3.0)) {
                const double between = std::copysign(std::sqrt(left * right), left);
                at = middle + half * (between - q.mid) / q.along;
            }
        }
        if (!(at > box.min && at < box.max)) at = 0.5 * (box.min + box.max);
        add(boxes, box, at, box.max, outcome.move);
        add(boxes, box, box.min, at, outcome.move);
    }

    /// A part of a box. It need not be driven again up to where the whole was hardly more than straight lines, even for
    /// this part.
    void add(std::vector<Box>& boxes, const Box& whole, double min, double max, int failed) const {
        Box& part = boxes.emplace_back(min, max);
        if (whole.doubtful) return;
        const double ratio = part.half / whole.half;
        for (int n = std::min(failed, whole.away_from); n > 0 && n >= whole.driven; --n) {
            const State& state = trail_[static_cast<std::size_t>(n)];
            if (!straight(state, ratio)) continue;
            part.driven = n;
            part.state = state;
            const double shift = (part.middle - whole.middle) / whole.half;
            part.state.x = restricted(state.x, shift, ratio);
            part.state.y = restricted(state.y, shift, ratio);
            part.state.start.off = restricted(state.start.off, shift, ratio);
            part.state.x_noise = part.state.x.noise();
            part.state.y_noise = part.state.y.noise();
            return;
        }
    }

    [[nodiscard]] bool straight(const State& state, double ratio) const {
        const double noise = state.x_noise + state.y_noise + problem_.radius * state.start.off.noise();
        const double along =
            std::abs(state.x.along) + std::abs(state.y.along) + problem_.radius * std::abs(state.start.off.along);
        return noise < 0.02 * ratio * along;
    }

    /// Over the t that are shift + ratio * (another), both known but for three roundings.
    static Form restricted(const Form& whole, double shift, double ratio) {
        Form part = whole;
        part.mid += whole.along * shift;
        part.along *= ratio;
        return part.with_rest(unit * (std::abs(part.mid) + 8.0 * std::abs(whole.along) * (std::abs(shift) + ratio)) +
                              underflow);
    }

    /// Centre and heading at the entry position of all headings in the box.
    [[nodiscard]] State enter(const Box& box) const {
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
        state.y = (-vx * state.start.off + (vy * square - vy - problem_.front_setback))
                      .with_rest(std::abs(vy) * square + error);
        gather(state, {});
        return state;
    }

    /// Errors of the centre into two symbols: along the longest of the errors and square to it.
    struct Column {
        double x = 0.0, y = 0.0;
    };
    static void gather(State& state, const std::array<Column, 2>& more) {
        const std::array<Column, 4> columns = {Column{state.x.first, state.y.first},
                                               Column{state.x.second, state.y.second}, more[0], more[1]};
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
        const double along =
            std::abs(across) * (at.off.rest + far * far * far * (1.0 / 6.0) + 8.0 * unit) * (1.0 + 1e-12);
        const double beside = std::abs(across) * (square + 8.0 * unit) * (1.0 + 1e-12);
        gather(state, {Column{along * at.c, along * at.s}, Column{beside * at.s, -beside * at.c}});
        state.start = at;
        state.start.off = {at.off.mid, at.off.along, 0.0, 0.0, at.off.noise()};
        state.backward = !state.backward;
        state.first = false;
    }

    Outcome look(Box& box) {
        ++found_.boxes;
        forks_ = 0;
        doubtful_ = false;
        away_from_ = std::numeric_limits<int>::max();
        trail_[static_cast<std::size_t>(box.driven)] = box.driven == 0 ? enter(box) : box.state;
        const Outcome outcome = follow(box.driven);
        box.doubtful = doubtful_;
        box.away_from = away_from_;
        return outcome;
    }

    Outcome follow(int n) {
        for (; n <= limit_; ++n) {
            const std::size_t at = static_cast<std::size_t>(n);
            Outcome outcome;
            outcome.move = n;
            switch (drive(trail_[at], trail_[at + 1], outcome, nullptr, false)) {
                case moved: break;
                case ended: return outcome;
                case grazed: return both_ways(outcome);
            }
        }
        return {Outcome::none, limit_, true, {}};
    }

    /// Where it cannot be told whether the lowest corner grazes the curb: first as if it passed, then as if it met it. If
    /// both come to the same, it does not matter.
    Outcome both_ways(const Outcome& fork) {
        if (++forks_ > most_forks) return fork;
        Outcome common;
        const std::size_t at = static_cast<std::size_t>(fork.move);
        for (const bool meets : {false, true}) {
            if (!meets && fork.failure.surely) continue;
            Outcome outcome;
            outcome.move = fork.move;
            const After after = drive(trail_[at], trail_[at + 1], outcome, &fork.failure, meets);
            if (after == grazed) return fork;
            if (after == moved) outcome = follow(fork.move + 1);
            if (outcome.what == Outcome::undecided) return fork;
            if (!meets || fork.failure.surely) {
                common = outcome;
            } else if (outcome.what != common.what || (outcome.what == Outcome::parks && outcome.move != common.move)) {
                return fork;
            }
        }
        return common;
    }

    enum After { moved, ended, grazed };

    /// One move. `graze`: one that is taken to meet the curb, or to pass.
    After drive(const State& state, State& then, Outcome& outcome, const Failure* graze, bool meets) {
        ++found_.moves;
        const Steering& steering = state.backward ? backward_ : forward_;
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
        Meeting& meeting = meeting_;
        const Bluntly all(steering, state);
        MoveBounds bounds = {all, all.at(state.start), all.at(until), 0.0};
        for (std::size_t i = 0; i < asked; ++i) {
            const Met met = order[i];
            if (graze != nullptr && meets && met == curb) {
                meeting.what = Meeting::contact;
                meeting.at = graze->at;
                meeting.touched = {};
                meeting.touched.add(graze->stage, 0);
                meeting.touched.exact = true;
            } else {
                const Sweep sweep(steering.of[met], met, state, until, contact, space_, bounds,
                                  met == curb ? graze : nullptr);
                sweep.meets(meeting);
                doubtful_ = doubtful_ || sweep.doubtful();
            }
            if (meeting.what == Meeting::never) continue;
            if (meeting.what == Meeting::stuck) return ended;  // no entry, or stuck for good
            if (meeting.what == Meeting::undecided && i < 2) {
                order[asked++] = met;
                continue;
            }
            if (meeting.what == Meeting::undecided) {
                outcome.what = Outcome::undecided;
                outcome.failure = meeting.failure;
                return met == curb && meeting.failure.grazes ? grazed : ended;
            }
            if (!contact) {
                contact = true;
                until = meeting.at;
                bounds.until = all.at(until);
                touched[met] = meeting.touched;
                likely = met;
                continue;
            }
            const Form other = off_from(until, meeting.at);
            const Form apart = until.off - other;
            if (apart.positive()) continue;
            if (apart.negative()) {
                for (Touched& one : touched) one.count = 0, one.exact = false;
                touched[met] = meeting.touched;
                until = meeting.at;
                bounds.until = all.at(until);
                likely = met;
            } else {
                until.off = larger(until.off, other);
                bounds.until = all.at(until);
                for (Touched& one : touched) one.exact = false;
                touched[met] = meeting.touched;
                touched[met].exact = false;
            }
        }
        Meeting& parked = meeting;
        Sweep(steering.of[goal], goal, state, until, false, space_, bounds).meets(parked);
        if (parked.what == Meeting::undecided) {
            outcome.what = Outcome::undecided;
            outcome.failure = parked.failure;
            return ended;
        }
        if (parked.what == Meeting::contact) {  // unless what stops the car comes first
            const Form before = difference(parked.at, until);
            if (before.positive()) {
                outcome.what = doubtful_ ? Outcome::undecided : Outcome::parks;
                if (away_from_ < outcome.move) {
                    outcome.what = Outcome::undecided;
                    outcome.failure = at_root_of(short_of_away_);
                }
                return ended;
            }
            if (!before.negative()) {
                outcome.what = Outcome::undecided;
                outcome.failure = {};
                outcome.failure.kind = Failure::at_root;
                outcome.failure.quantity = before;
                return ended;
            }
        }
        if (!contact) return ended;  // circles freely
        const Form short_of_away = (until.off + (until.angle + steepest_)).with_rest(angle_error);
        if (short_of_away.negative()) return ended;
        if (!short_of_away.positive() && steepest_ < infinity && away_from_ > outcome.move) {
            away_from_ = outcome.move;
            short_of_away_ = short_of_away;
        }
        then.x = state.x;
        then.y = state.y;
        then.backward = state.backward;
        turn_over(then, until, steering.across);
        return moved;
    }

    const ProofProblem& problem_;
    Steering backward_;
    Steering forward_;
    double steepest_;
    int asked_;
    int limit_;
    Find find_;
    const ProofHints& hints_;
    const Progress& progress_;
    std::size_t most_moves_;
    static constexpr int most_forks = 8;  ///< in a box
    int forks_ = 0;
    std::vector<Met> likely_;   ///< what the last box met in each move
    bool doubtful_ = false;     ///< the box may be no entry position
    std::vector<Box> boxes_;    ///< to be looked at, the lowest headings last
    std::vector<Box> later_;    ///< none of their headings parks yet
    std::vector<State> trail_;  ///< the box before each move
    int away_from_ = 0;         ///< the first move after which some of the box, not all, has turned away,
    Form short_of_away_;        ///< and by how much it has not
    Space space_;
    Meeting meeting_;
    ProvedRanges found_;
};

}  // namespace

ProvedRanges prove_ranges(const ProofProblem& problem, int max_changes, Find find, const ProofHints& hints,
                          const Progress& progress, std::size_t most_moves) {
    return Prover(problem, max_changes, find, hints, progress, most_moves).run();
}

ProofProblem proof_problem(const Car& car, const Slot& slot, const Driving& driving, const Parked& parked) {
    const bool nose_first = driving.enter == Enter::forward;
    const auto entering = [&](const Outline& outline) {
        const Outline on_the_right = slot.side() == Side::left ? outline.mirrored() : outline;
        return nose_first ? on_the_right.turned_about() : on_the_right;
    };
    const SlotDimensions& dimensions = slot.dimensions();
    ProofProblem made;
    made.frame = entering(car.outline()).corners();
    made.body = entering(car.outline()).grown(driving.clearance).corners();
    const Outline& meets_curb = dimensions.curb == Curb::low ? car.wheels() : car.outline();
    made.at_curb = entering(meets_curb).grown(driving.at_curb()).corners();
    made.radius = car.turning_radius();
    made.length = dimensions.length;
    made.width = dimensions.width;
    made.front_setback = nose_first ? dimensions.rear_setback : dimensions.front_setback;
    made.rear_setback = nose_first ? dimensions.front_setback : dimensions.rear_setback;
    made.parked_heading = parked.heading;
    made.parked_curb = parked.curb;
    // Of the corners ahead of the rear axle the one farthest from the first move's centre.
    double farthest = 0.0;
    for (std::size_t i = 0; i < made.body.size(); ++i) {
        const Point& corner = made.body[i];
        const double distance = angles::hypot(corner.x, corner.y - made.radius);
        if (corner.x > 0.0 && distance > farthest) farthest = distance, made.entry_corner = i;
    }
    return made;
}

}  // namespace snug::detail
