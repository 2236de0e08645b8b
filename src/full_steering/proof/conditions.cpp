#include "full_steering/proof/conditions.hpp"

#include "model/angles.hpp"

namespace snug::detail::proof {

namespace {

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
        condition.make_linear();
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
        const auto [s, c] = angles::sine_cosine(problem_.parked_heading);
        add(made.stages, c, s);
        add(made.stages, c, -s);
        finish(made.stages);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const double heading = middle(made.stages, k);
            stage.possible = std::abs(heading) <= problem_.parked_heading;
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

}  // namespace

Steering steering_about(const ProofProblem& problem, double offset) { return Maker(problem, offset).make(); }

}  // namespace snug::detail::proof
