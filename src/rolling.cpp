// A way without steering at standstill: a search over short pieces, guided by the map of the place.
#include "snug/rolling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "contact/rolling_contact.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"
#include "snug/park_map.hpp"

namespace snug {
namespace {

using detail::RollingContact;

constexpr double kept = 1e-4;           ///< from everything [m]
constexpr double shortest_step = 0.05;  ///< with the wheels held [m]
constexpr double longest_step = 0.1;
constexpr int nodes_per_count = 10000;
constexpr int followed_per_count = 300;
constexpr int way_of_the_map = 20;                  ///< what it costs to look one up, in pieces
constexpr double worth_a_change_of_steering = 0.1;  ///< of length [m]
constexpr double worth_standing = 5.0;              ///< of length, to turn the steering at standstill once [m]

/// Where the car can be, and how it came there.
struct Node {
    Pose pose;
    double level = 0.0;  ///< of curvature: a whole number but at the start
    Direction way = Direction::forward;
    int changes = 0;
    int stands = 0;  ///< how often the steering turned at standstill
    int parent = -1;
    double length = 0.0, sharpness = 0.0;  ///< of the piece from the parent; no length: the direction changed
    double cost = 0.0;                     ///< of length and steering so far [m]
    int guide = 0;
};

/// Along the way that the map knows for steering at standstill: how far a pose is from it and from its end.
class Guide {
public:
    Guide(const Maneuver& way, double reach) : reach_(reach) {
        double left = way.length();
        for (const Move& move : way.moves) {
            const int parts = 1 + static_cast<int>(move.length / 0.1);
            for (int i = 0; i <= parts; ++i) {
                const double s = move.length * i / parts;
                marks_.push_back(
                    {drive(way.car, move.start, move.direction, move.steering_angle, s), move.direction, left - s});
            }
            left -= move.length;
        }
    }
    struct Left {
        double along, aside;
    };
    [[nodiscard]] Left left(const Pose& pose, Direction way) const {
        Left least = {0.0, 0.0};
        double best = std::numeric_limits<double>::infinity();
        for (const Mark& mark : marks_) {
            double aside = std::abs(mark.pose.x - pose.x) + std::abs(mark.pose.y - pose.y);
            const double along = mark.left + (mark.way == way ? 0.0 : 0.5);
            if (along + 2.0 * aside >= best) continue;
            double turned = std::abs(mark.pose.heading - pose.heading);
            if (turned > limits::half_turn) turned = std::abs(std::remainder(turned, 2.0 * limits::half_turn));
            aside += reach_ * turned;
            if (along + 2.0 * aside < best) {
                best = along + 2.0 * aside;
                least = {along, aside};
            }
        }
        return least;
    }

private:
    struct Mark {
        Pose pose;
        Direction way;
        double left;
    };
    std::vector<Mark> marks_;
    double reach_;
};

class RollingSearch {
public:
    /// `bend`: the curvature that the wheels have at the start. `may_stand`: the steering may turn at stops, as seldom as may be.
    /// The steering is held at so many `levels` of curvature from straight to full.
    RollingSearch(const ParkMap& map, double clearance, const Maneuver& standing, double bend, double creep, int levels,
                  bool may_stand, const RollingOptions& options)
        : car_(map.car()),
          map_(map),
          options_(options),
          around_(car_, map.place(), clearance),
          levels_(levels),
          may_stand_(may_stand),
          fullest_(1.0 / car_.turning_radius()),
          sharpness_(options.steering_rate / (car_.wheelbase() * creep)),
          turn_(curvature(1.0) / sharpness_),
          hold_(std::clamp(turn_, shortest_step, longest_step)) {
        guides_.emplace_back(standing, car_.length() / 2.0);
        Node start;
        start.pose = standing.entry();
        start.level = bend == 0.0 ? 0.0 : bend / curvature(1.0);
        for (const Direction way : {Direction::forward, Direction::backward}) {
            start.way = way;
            add(start);
            stand(start);
        }
    }

    /// A way with at most so many direction changes, looking at what was put off before: to be asked with rising numbers. `work`
    /// counts the pieces looked at, up to `most_work`.
    std::optional<RollingManeuver> with(int allowed, int most_work, int& work, bool& cancelled) {
        work_ = &work;
        int followed = 0;
        for (int looked = 0; looked < nodes_per_count && work < most_work;) {
            // In turn by two orders: near to the way the map knows, and far along it.
            auto& queues = open_[allowed];
            auto& queue = queues[order_++ % 2];
            if (queue.empty()) {
                if (queues[order_ % 2].empty()) break;
                continue;
            }
            const int index = queue.top().second;
            queue.pop();
            if (!is_new(nodes_[static_cast<std::size_t>(index)])) continue;
            ++looked;
            if (options_.progress && looked % 256 == 0 && !options_.progress()) {
                cancelled = true;
                return std::nullopt;
            }
            if (const int end = expand(index); end >= 0) return way_to(end);
            if (nodes_[static_cast<std::size_t>(index)].length > 0.0 || followed++ >= followed_per_count) continue;
            if (const int end = follow(index); end >= 0) return way_to(end);
        }
        // What is left waits on with one change more.
        auto& rest = open_[allowed];
        auto& next = open_[allowed + 1];
        for (std::size_t k = 0; k < 2; ++k)
            for (; !rest[k].empty(); rest[k].pop()) next[k].push(rest[k].top());
        return std::nullopt;
    }

private:
    double curvature(double level) const { return fullest_ * level / levels_; }
    /// The next whole level to the left (1) or to the right (-1).
    static double next_level(double level, int by) {
        constexpr double rounding = 1e-9;
        return by > 0 ? std::floor(level + rounding) + 1.0 : std::ceil(level - rounding) - 1.0;
    }

    /// The same at a stop, with the steering turned there to any other level, where that may be.
    void stand(Node node) {
        if (!may_stand_) return;
        const double level = node.level;
        ++node.stands;
        node.cost += worth_standing;
        for (int other = -levels_; other <= levels_; ++other) {
            node.level = other;
            if (std::abs(level - other) > 1e-9) add(node);
        }
    }

    /// The node's place in the order of what is looked at, and whether it is parked; it may lead nowhere.
    int add(const Node& node) {
        const MapBounds bounds = map_.at(node.pose);
        if (bounds.where != MapBounds::free || !bounds.direction_changes) return -1;
        const bool parked = *bounds.direction_changes == 0 && !bounds.first;
        const int total =
            node.changes + *bounds.direction_changes + (bounds.first && *bounds.first != node.way ? 1 : 0);
        nodes_.push_back(node);
        const int index = static_cast<int>(nodes_.size()) - 1;
        const Guide::Left left = guides_[static_cast<std::size_t>(node.guide)].left(node.pose, node.way);
        auto& queues = open_[std::max(total, node.changes)];
        const Guide::Left first = node.guide == 0 ? left : guides_[0].left(node.pose, node.way);
        queues[0].push({-(node.cost + 1.5 * (first.along + 3.0 * first.aside)), index});
        queues[1].push({-(node.cost + 3.0 * (left.along + 1.2 * left.aside)), index});
        return parked && node.length > 0.0 ? index : -1;
    }

    /// Nearly the same pose, steering and direction is looked at once, with the fewest changes.
    bool is_new(const Node& node) {
        constexpr double apart = 0.025, turned = 0.01;
        const auto cell = [](double value, double size) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value / size)));
        };
        std::uint64_t key = cell(node.pose.x, apart);
        for (const std::uint64_t part : {cell(node.pose.y, apart), cell(node.pose.heading, turned),
                                         static_cast<std::uint64_t>(std::lround(node.level) + levels_),
                                         static_cast<std::uint64_t>(node.way == Direction::forward)})
            key = (key ^ (key >> 29)) * 0xBF58476D1CE4E5B9ULL + part;
        const int worth = node.changes + 4 * node.stands;
        const auto [known, added] = seen_.try_emplace(key, worth);
        if (added) return true;
        if (worth >= known->second) return false;
        known->second = worth;
        return true;
    }

    /// So far on, the steering held (0) or turned by a level to the left (1) or right (-1); nothing if that is in the way.
    [[nodiscard]] RollingPiece piece(const Node& from, int by, double step) const {
        return {from.way, curvature(from.level), by * sharpness_, step, from.pose, {}};
    }
    [[nodiscard]] static Node after(const Node& from, const RollingPiece& piece, int by) {
        Node next = from;
        next.pose = piece.at(piece.length);
        if (by != 0) next.level = next_level(from.level, by);
        next.length = piece.length;
        next.sharpness = piece.sharpness;
        next.cost += piece.length + (by == 0 ? 0.0 : worth_a_change_of_steering);
        return next;
    }
    /// How far a step leads.
    [[nodiscard]] double step_of(const Node& from, int by) const {
        return by == 0 ? hold_ : turn_ * std::abs(next_level(from.level, by) - from.level);
    }
    /// Holding the steering as far as the step or a part of it leads; turning it, all of the step or nothing.
    [[nodiscard]] std::optional<Node> driven(int from, int by) {
        const Node& node = nodes_[static_cast<std::size_t>(from)];
        if (std::abs(by == 0 ? node.level : next_level(node.level, by)) > levels_) return std::nullopt;
        constexpr int halvings = 4;
        double step = step_of(node, by);
        for (int i = 0; i < (by == 0 ? halvings : 1); ++i, step /= 2.0) {
            ++*work_;
            const RollingPiece on = piece(node, by, step);
            if (!around_.keeps(on, kept)) continue;
            Node next = after(node, on, by);
            next.parent = from;
            return next;
        }
        return std::nullopt;
    }

    /// Every way on from a node; the node where the car is parked, if one of them is.
    int expand(int index) {
        for (const int by : {0, -1, 1})
            if (const std::optional<Node> next = driven(index, by))
                if (const int end = add(*next); end >= 0) return end;
        const Node& node = nodes_[static_cast<std::size_t>(index)];
        if (node.length == 0.0) return -1;
        Node turned = node;
        turned.way = node.way == Direction::forward ? Direction::backward : Direction::forward;
        ++turned.changes;
        turned.parent = index;
        turned.length = 0.0;
        add(turned);
        stand(turned);
        return -1;
    }

    /// Follows what the map would do from there with steering at standstill, until it changes direction and somewhat farther;
    /// what is passed is looked at later. The node where the car is parked, if it comes by one.
    int follow(int index) {
        constexpr double beyond = 0.5;  // [m]
        constexpr int steps_ahead = 3;
        const Node& from = nodes_[static_cast<std::size_t>(index)];
        *work_ += way_of_the_map;
        const std::optional<Maneuver> way = map_.maneuver(from.pose);
        if (!way || way->moves.front().direction != from.way) return -1;
        guides_.emplace_back(*way, car_.length() / 2.0);
        std::vector<Move> moves;
        double length = 0.0;
        for (const Move& move : way->moves) {
            if (move.direction != from.way) break;
            moves.push_back(move);
            length += move.length;
        }
        struct Off {
            double along;  ///< ahead of what is meant
            double aside;  ///< with what the heading is off, as a length
        };
        const double sign = static_cast<double>(static_cast<int>(from.way));
        const auto off = [&](const Pose& pose, double s) {
            std::size_t i = 0;
            for (; i + 1 < moves.size() && s > moves[i].length; ++i) s -= moves[i].length;
            const Pose meant =
                drive(car_, moves[i].start, moves[i].direction, moves[i].steering_angle, std::max(0.0, s));
            const auto [sine, cosine] = angles::sine_cosine(meant.heading);
            const double dx = pose.x - meant.x, dy = pose.y - meant.y;
            return Off{
                sign * (cosine * dx + sine * dy),
                std::abs(cosine * dy - sine * dx) + car_.length() / 4.0 * std::abs(pose.heading - meant.heading)};
        };
        const auto towards = [](int target, double level) { return (target > level) - (target < level); };
        double progress = 0.0;
        for (int last = index; progress < length + beyond;) {
            Node node = nodes_[static_cast<std::size_t>(last)];
            int best = 0;
            double least = std::numeric_limits<double>::infinity();
            for (int target = -levels_; target <= levels_; ++target) {
                Node ahead = node;
                double s = progress, error = 0.001 * std::abs(target - node.level);
                for (int k = 1; k <= steps_ahead; ++k) {
                    const int by = towards(target, ahead.level);
                    ahead = after(ahead, piece(ahead, by, step_of(ahead, by)), by);
                    s += ahead.length;
                    const Off here = off(ahead.pose, s);
                    s += here.along;
                    error += k * here.aside;
                }
                if (error >= least) continue;
                least = error;
                best = towards(target, node.level);
            }
            std::optional<Node> next = driven(last, best);
            if (!next && best != 0) next = driven(last, 0);
            if (!next) return -1;
            next->guide = static_cast<int>(guides_.size()) - 1;
            progress += next->length;
            progress += off(next->pose, progress).along;
            last = static_cast<int>(nodes_.size());
            if (const int end = add(*next); end >= 0) return end;
            if (last == static_cast<int>(nodes_.size())) return -1;
        }
        return -1;
    }

    RollingManeuver way_to(int end) const {
        std::vector<const Node*> nodes;
        for (int i = end; i >= 0; i = nodes_[static_cast<std::size_t>(i)].parent)
            nodes.push_back(&nodes_[static_cast<std::size_t>(i)]);
        std::reverse(nodes.begin(), nodes.end());
        RollingManeuver way{car_, {}};
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const Node& node = *nodes[i];
            if (node.length == 0.0) continue;
            if (!way.pieces.empty() && way.pieces.back().direction == node.way &&
                way.pieces.back().sharpness == node.sharpness) {
                RollingPiece& last = way.pieces.back();
                last.length += node.length;
                last.end = last.at(last.length);
                continue;
            }
            const Pose from = way.pieces.empty() ? nodes[0]->pose : way.pieces.back().end;
            RollingPiece piece = {node.way, curvature(nodes[i - 1]->level), node.sharpness, node.length, from, {}};
            piece.end = piece.at(piece.length);
            way.pieces.push_back(piece);
        }
        return way;
    }

    const Car car_;
    const ParkMap& map_;
    std::vector<Guide> guides_;
    const RollingOptions& options_;
    RollingContact around_;
    int levels_;
    bool may_stand_;
    int* work_ = nullptr;
    double fullest_, sharpness_;
    double turn_, hold_;  ///< lengths of a piece with the steering turned by a level, and held [m]
    std::vector<Node> nodes_;
    std::unordered_map<int, std::array<std::priority_queue<std::pair<double, int>>, 2>> open_;
    std::size_t order_ = 0;
    std::unordered_map<std::uint64_t, int> seen_;
};

void check(const RollingOptions& options) {
    check_between("creeping speed", options.creep, 0.01, 10.0, " m/s");
    check_between("steering rate", options.steering_rate, 1e-3, 1e3, " rad/s");
    check_between("direction changes more", options.most_more, 0.0, limits::most_changes_fewest, "");
    check_between("pieces looked at", options.most_work, 0.0, 1e9, "");
}

/// What steers at standstill, as pieces whose curvature jumps.
RollingManeuver in_pieces(const Maneuver& standing) {
    RollingManeuver way{standing.car, {}};
    for (const Move& move : standing.moves)
        way.pieces.push_back({move.direction, angles::tan(move.steering_angle) / standing.car.wheelbase(), 0.0,
                              move.length, move.start, move.end});
    return way;
}

RollingAnswer on_map(const ParkMap& map, double clearance, const Pose& start, double bend,
                     const RollingOptions& options) {
    RollingAnswer answer;
    const MapBounds bounds = map.at(start);
    answer.lower_bound = bounds.lower_bound;
    if (bounds.where == MapBounds::outside)
        throw Error(
            "the car starts outside the region, or turned farther from the parked heading than the map covers; move "
            "it");
    if (bounds.where == MapBounds::blocked)
        throw Error("the car starts in contact, or less than 0.1 mm from it; move it away");
    if (bounds.direction_changes == 0 && !bounds.first) {
        answer.standing_changes = 0;
        answer.maneuver = RollingManeuver{map.car(), {}};
        return answer;
    }
    const std::optional<Maneuver> standing = map.maneuver(start);
    if (!standing) return answer;
    const int fewest = std::min(*bounds.direction_changes, standing->direction_changes());
    answer.standing_changes = fewest;
    const auto search = [&](double times, int levels, bool may_stand) {
        const double creep = times * options.creep;
        return std::pair(creep, RollingSearch(map, clearance, *standing, bend, creep, levels, may_stand, options));
    };
    const auto with = [&](int most, int most_work, auto& searches, std::optional<RollingManeuver>& found) {
        int work = 0;
        for (int allowed = fewest; allowed <= most && work < most_work; ++allowed) {
            for (auto& [creep, one] : searches) {
                found = one.with(allowed, most_work, work, answer.cancelled);
                answer.creep = creep;
                if (found || answer.cancelled) break;
            }
            if (found || answer.cancelled) break;
        }
        answer.work += work;
    };
    std::vector<std::pair<double, RollingSearch>> searches;
    for (const double times : {4.0, 2.0, 1.0}) searches.push_back(search(times, 2, false));
    searches.push_back(search(1.0, 4, false));
    const int most = std::min(fewest + options.most_more, options.max_changes);
    with(most, options.most_work, searches, answer.maneuver);
    if (answer.maneuver) return answer;
    if (answer.cancelled) {
        answer.standing = in_pieces(*standing);
        return answer;
    }
    searches.clear();
    searches.push_back(search(1.0, 2, true));
    with(most, options.most_work / 4, searches, answer.standing);
    if (answer.standing && answer.standing->standing_steers(bend).empty()) {  // it needs none after all
        answer.maneuver = std::move(answer.standing);
        answer.standing.reset();
        return answer;
    }
    if (!answer.standing) answer.standing = in_pieces(*standing);
    return answer;
}

}  // namespace

RollingAnswer park_rolling(const Car& car, const Place& place, const Pose& start, const RollingOptions& options) {
    check(options);
    ParkMapOptions how;
    how.spacing = options.spacing;
    how.clearance = options.clearance + kept;
    how.heading = start.heading;
    bool given_up = false;
    how.progress = [&] { return !(given_up = options.progress && !options.progress()); };
    std::optional<ParkMap> map;
    try {
        map.emplace(car, place, how);
    } catch (const Error&) {
        if (!given_up) throw;
        RollingAnswer nothing;
        nothing.cancelled = true;
        return nothing;
    }
    return on_map(*map, options.clearance, start, 0.0, options);
}

RollingAnswer park_rolling(const ParkMap& map, const Pose& start, double steering_angle,
                           const RollingOptions& options) {
    check(options);
    check_between("steering angle at the start", steering_angle, -limits::most_steer, limits::most_steer, " rad");
    return on_map(map, map.clearance(), start, angles::tan(steering_angle) / map.car().wheelbase(), options);
}

}  // namespace snug
