#include "full_steering/proof/conditions.hpp"

#include <initializer_list>
#include <utility>

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

/// A polygon, and what is asked of it for every condition.
struct Shape {
    const std::vector<Point>& corners;
    std::vector<Point> normals;  ///< of the edge that begins at each corner
    double size;

    explicit Shape(const std::vector<Point>& of) : corners(of), size(size_of(of)) {
        normals.reserve(of.size());
        for (std::size_t i = 0; i < of.size(); ++i) {
            const Point& a = of[i];
            const Point& b = of[(i + 1) % of.size()];
            const double dx = b.x - a.x;
            const double dy = b.y - a.y;
            const double length = angles::hypot(dx, dy);
            normals.push_back({dy / length, -dx / length});
        }
    }
};

/// The same obstacle seen from both turning centres: its stages are the same, and so is what its conditions are about.
struct Seen {
    std::vector<Stage> stages;
    std::array<std::vector<Condition>, 2> conditions;

    [[nodiscard]] std::size_t count() const { return conditions[0].size(); }
};

class Maker {
public:
    explicit Maker(const ProofProblem& problem)
        : problem_(problem), body_(problem.body), at_curb_(problem.at_curb), frame_(problem.frame) {}

    [[nodiscard]] std::array<Steering, 2> make() const {
        std::array<Steering, 2> steering;
        for (const Met met : {front, rear, curb, goal}) {
            Seen seen = met == curb ? ground() : met == goal ? inside() : neighbour(met == front);
            for (std::size_t way = 0; way < 2; ++way) {
                Obstacle& obstacle = steering[way].of[met];
                obstacle.stages = way == 0 ? seen.stages : std::move(seen.stages);
                obstacle.conditions = std::move(seen.conditions[way]);
                obstacle.one_condition = met == curb;
            }
        }
        for (std::size_t way = 0; way < 2; ++way) {
            steering[way].across = 2.0 * offset(way);
            steering[way].note_reach();
        }
        return steering;
    }

private:
    enum Axis { down, right, left, up };

    /// Of the turning centre, to the left of the rear axle's middle.
    [[nodiscard]] double offset(std::size_t way) const { return way == 0 ? problem_.radius : -problem_.radius; }

    /// Headings at which an edge of the polygon faces one of the axes, and all quarters (stages are no longer than that).
    static void add_stages(std::vector<Stage>& stages, const Shape& shape, std::initializer_list<Axis> axes) {
        stages.reserve(stages.size() + shape.normals.size() * axes.size() + 8);
        for (const Point& n : shape.normals) {
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

    /// `conditions`: of a stage, at most or so.
    static void finish(Seen& seen, std::size_t conditions) {
        std::vector<Stage>& stages = seen.stages;
        add(stages, 1.0, 0.0);
        add(stages, 0.0, 1.0);
        add(stages, -1.0, 0.0);
        add(stages, 0.0, -1.0);
        for (Stage& stage : stages) {
            if (stage.angle <= -pi + 1e-16) stage.angle = pi;
        }
        std::sort(stages.begin(), stages.end(), [](const Stage& a, const Stage& b) { return a.angle > b.angle; });
        std::size_t kept = 0;
        for (const Stage& stage : stages) {
            if (kept == 0 || stages[kept - 1].angle - stage.angle > 4e-16) stages[kept++] = stage;
        }
        stages.resize(kept);
        for (std::vector<Condition>& all : seen.conditions) all.reserve(kept * conditions);
    }

    static double middle(const std::vector<Stage>& stages, std::size_t i) {
        const double end = i + 1 < stages.size() ? stages[i + 1].angle : stages[0].angle - 2.0 * pi;
        return 0.5 * (stages[i].angle + end);
    }

    /// A corner, sixteen roundings of its place, eight of what a stage that begins a little too late may do to it.
    void add_corner(Seen& seen, Condition::Kind kind, const Shape& shape, std::size_t i, double level,
                    double level_error = 0.0) const {
        for (std::size_t way = 0; way < 2; ++way) {
            Condition& condition = seen.conditions[way].emplace_back();
            condition.kind = kind;
            condition.x = shape.corners[i].x;
            condition.y = shape.corners[i].y - offset(way);
            condition.level = level;
            condition.error = unit * (16.0 * (std::abs(condition.x) + std::abs(condition.y) + std::abs(offset(way))) +
                                      16.0 * shape.size + 2.0 * std::abs(level)) +
                              level_error;
            condition.make_linear();
        }
    }

    void add_edge(Seen& seen, const Shape& shape, std::size_t i, Point at, double at_error) const {
        const Point& n = shape.normals[i];
        for (std::size_t way = 0; way < 2; ++way) {
            Condition& condition = seen.conditions[way].emplace_back();
            condition.kind = Condition::inside;
            condition.x = n.x;
            condition.y = n.y;
            condition.level = shape.corners[i].x * n.x + (shape.corners[i].y - offset(way)) * n.y;
            condition.edge = i;
            condition.kx = at.x;
            condition.ky = at.y;
            condition.error =
                unit * 32.0 * (shape.size + std::abs(offset(way)) + std::abs(at.x) + std::abs(at.y)) + at_error;
        }
    }

    [[nodiscard]] Seen neighbour(bool ahead) const {
        const Point corner_at =
            ahead ? Point{0.0, -problem_.front_setback} : Point{-problem_.length, -problem_.rear_setback};
        const double error = ahead ? 0.0 : problem_.length_error;
        Seen made;
        add_stages(made.stages, body_, {down, ahead ? right : left});
        finish(made, 3);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const Extremes at(body_.corners, middle(made.stages, k));
            stage.first = made.count();
            const std::size_t from = ahead ? at.lowest : at.leftmost;
            const std::size_t to = ahead ? at.rightmost : at.lowest;
            if (ahead) add_corner(made, Condition::below, body_, at.lowest, corner_at.y);
            if (!ahead) add_corner(made, Condition::left_of, body_, at.leftmost, corner_at.x, error);
            for (std::size_t i = from;; i = (i + 1) % body_.corners.size()) {
                if (ahead && i == problem_.entry_corner)
                    stage.entry_condition = static_cast<int>(made.count() - stage.first);
                if (i == to) break;
                add_edge(made, body_, i, corner_at, error);
            }
            if (ahead) add_corner(made, Condition::right_of, body_, at.rightmost, corner_at.x);
            if (!ahead) add_corner(made, Condition::below, body_, at.lowest, corner_at.y);
            stage.last = made.count();
        }
        return made;
    }

    [[nodiscard]] Seen ground() const {
        Seen made;
        add_stages(made.stages, at_curb_, {down});
        finish(made, 1);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const Extremes at(at_curb_.corners, middle(made.stages, k));
            stage.first = made.count();
            add_corner(made, Condition::below, at_curb_, at.lowest, -problem_.width, problem_.width_error);
            stage.last = made.count();
        }
        return made;
    }

    /// The frame inside the slot. Below the entry side it cannot be beside the slot without being in a neighbour, unless
    /// that begins deeper.
    [[nodiscard]] Seen inside() const {
        Seen made;
        add_stages(made.stages, frame_, {up});
        if (problem_.parked_curb < infinity) add_stages(made.stages, frame_, {down});
        if (problem_.front_setback > 0.0) add_stages(made.stages, frame_, {right});
        if (problem_.rear_setback > 0.0) add_stages(made.stages, frame_, {left});
        const auto [s, c] = angles::sine_cosine(problem_.parked_heading);
        add(made.stages, c, s);
        add(made.stages, c, -s);
        finish(made, 1);
        for (std::size_t k = 0; k < made.stages.size(); ++k) {
            Stage& stage = made.stages[k];
            const double heading = middle(made.stages, k);
            stage.possible = std::abs(heading) <= problem_.parked_heading;
            const Extremes at(frame_.corners, heading);
            stage.first = made.count();
            add_corner(made, Condition::below, frame_, at.highest, 0.0);
            if (problem_.parked_curb < infinity)
                add_corner(made, Condition::below, frame_, at.lowest, problem_.parked_curb - problem_.width,
                           problem_.width_error);
            if (problem_.front_setback > 0.0) add_corner(made, Condition::left_of, frame_, at.rightmost, 0.0);
            if (problem_.rear_setback > 0.0)
                add_corner(made, Condition::right_of, frame_, at.leftmost, -problem_.length, problem_.length_error);
            stage.last = made.count();
        }
        return made;
    }

    const ProofProblem& problem_;
    Shape body_;
    Shape at_curb_;
    Shape frame_;
};

}  // namespace

std::array<Steering, 2> steerings(const ProofProblem& problem) { return Maker(problem).make(); }

}  // namespace snug::detail::proof
