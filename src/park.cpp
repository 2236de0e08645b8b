// From any pose into any place: the question in a chart, the bounds, and the way as a maneuver in the world.
#include "snug/park.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "all_maneuvers/sets/outer_sets.hpp"
#include "all_maneuvers/sets/park_search.hpp"
#include "all_maneuvers/workers.hpp"
#include "contact/place_contact.hpp"
#include "in_world.hpp"
#include "model/angles.hpp"
#include "sentences/check.hpp"
#include "snug/limits.hpp"

namespace snug {

namespace {

using namespace detail::sets;
using detail::GivenUp;
using detail::Watch;
using detail::Workers;

using limits::half_turn;
constexpr double usual_part = 1.0 / 800;    ///< of the car's length: the usual resolution
constexpr int finer_where_cheap = 2;        ///< times half of that
constexpr double coarsest_part = 1.0 / 50;  ///< and no lattice is coarser
constexpr double most_cells = 2e7;          ///< of the coarsest lattice
using limits::touching;

void check(const ParkOptions& options) {
    check_between("maximum of direction changes", options.max_changes, 0.0, limits::most_changes_fewest, "");
    check_between("clearance", options.clearance, 0.0, limits::longest, " m");
    check_between("resolution", options.resolution, 0.0, limits::longest, " m");
    check_between("threads", options.threads, 0.0, limits::most_threads, "");
    check_between("time limit", options.time_limit, 0.0, std::numeric_limits<double>::infinity(), " s");
}

std::string with_article(const Place& place, std::size_t obstacle) {
    return (place.obstacles()[obstacle].name.empty() ? "" : "the ") + place.name_of(obstacle);
}

ParkStop nearest_at(const Car& car, const Place& place, const Pose& pose, double clearance) {
    const std::vector<PlaceGap> all = gaps(car, place, pose, clearance);
    const auto nearest = std::min_element(all.begin(), all.end(), [](const PlaceGap& one, const PlaceGap& other) {
        return one.distance < other.distance;
    });
    return {static_cast<std::size_t>(nearest - all.begin()), *nearest};
}

/// What a car is nearest to at the end of each move.
std::vector<ParkStop> stops_of(const Maneuver& maneuver, const Place& place, double clearance) {
    std::vector<ParkStop> stops;
    if (place.obstacles().empty()) return stops;
    for (const Move& move : maneuver.moves) stops.push_back(nearest_at(maneuver.car, place, move.end, clearance));
    return stops;
}

void check_start(const Place& place, const ChartPlace& here) {
    for (const HalfPlane& edge : here.region) {
        const double out = edge.normal.x * here.start.x + edge.normal.y * here.start.y - edge.offset;
        if (out > touching)
            throw Error("the car starts outside the region, by " + spelled(out) +
                        " m; move it, or make the region larger");
    }
    for (std::size_t i = 0; i < here.solids.size(); ++i) {
        const ChartPlace::Solid& solid = here.solids[i];
        const double deep = detail::overlap(detail::placed(here.shapes[solid.stops], here.start), solid.corners);
        if (!(deep > touching)) continue;
        throw Error("the car starts in contact with " + with_article(place, place.pieces()[i].obstacle) + ", " +
                    spelled(deep) + " m deep; move it away");
    }
}

bool holds_nothing(const detail::sets::Limits& limits) {
    for (const Layer& layer : limits)
        for (std::size_t i = 0; i < layer.spans.cells; ++i)
            if (layer.low[i] <= layer.high[i]) return false;
    return true;
}

/// Throws Error when the car would have room to park if it were not for the obstacles: then nobody meant the goal to be there.
/// (A clearance that leaves no room is another matter, be it to one obstacle alone.)
void check_goal(const Car& car, const Place& asked, const Pose& start, double h) {
    PlaceDescription bare{asked.obstacles(), asked.parked(), asked.region()};
    for (PlaceObstacle& obstacle : bare.obstacles) obstacle.clearance.reset();
    const Place place(std::move(bare));
    Chart chart;
    ChartPlace here = chart_place(car, place, start, 0.0, chart);
    const auto room = [&] { return !holds_nothing(OuterLattice(here, h, h, nullptr, [] {}).parked()); };
    if (room()) return;
    here.solids.clear();
    if (!room()) return;
    Pose goal;
    if (const auto* inside = std::get_if<ParkedInside>(&place.parked())) {
        const auto count = static_cast<double>(inside->corners.size());
        const double ahead = (car.rear() - car.front()) / 2.0;
        goal = {ahead * angles::cos(inside->heading), ahead * angles::sin(inside->heading), inside->heading};
        for (const Point& corner : inside->corners) {
            goal.x += corner.x / count;
            goal.y += corner.y / count;
        }
    } else {
        goal = std::get<ParkedAt>(place.parked()).pose;
    }
    const auto [covers, gap] = nearest_at(car, place, goal, 0.0);
    throw Error("the goal is covered by " + with_article(place, covers) +
                (gap.distance < 0.0 ? ", " + spelled(-gap.distance) + " m deep" : "") + "; move one of them");
}

}  // namespace

ParkAnswer park(const Car& car, const Place& place, const Pose& start, const ParkOptions& options) {
    check(options);
    check_between("start x", start.x, -limits::farthest, limits::farthest, " m");
    check_between("start y", start.y, -limits::farthest, limits::farthest, " m");
    check_between("start heading", start.heading, -limits::farthest, limits::farthest, " rad");
    Chart chart;
    ParkQuestion question;
    question.place = chart_place(car, place, start, options.clearance, chart);
    question.slot = slot_in(car, place, start, options.clearance, chart);
    question.max_changes = options.max_changes;
    question.roomiest = options.roomiest;
    if (std::abs(question.place.start.heading) > half_turn * 75.0 / 180.0)
        throw Error("the car's heading and the parked one are " +
                    spelled(std::round(std::abs(question.place.start.heading) * 3600.0 / half_turn) / 10.0) +
                    " degrees apart, but at most 150 are supported; turn the car first");
    check_start(place, question.place);
    const double reach = std::max(std::abs(question.place.y_min), std::abs(question.place.y_max));
    if (reach > farthest_y || question.place.radius > 40.0)
        throw Error("the region reaches " + spelled(std::round(reach)) + " m to either side, but at most " +
                    spelled(farthest_y) + " are supported; name a smaller one");

    const double length = car.length();
    question.finest = options.resolution > 0.0 ? options.resolution : usual_part * length;
    question.finer = options.resolution > 0.0 ? 0 : finer_where_cheap;
    const double sensible = std::min(coarsest_part * length, question.place.radius / 32.0);
    question.finest = std::min(question.finest, sensible);
    question.coarsest = question.finest;
    while (2.0 * question.coarsest <= sensible) question.coarsest *= 2.0;
    const double cells = (question.place.x_max - question.place.x_min) * 4.0 * question.place.radius /
                         (question.coarsest * question.coarsest);
    if (cells > most_cells)
        throw Error("the region is " + spelled(std::round(question.place.x_max - question.place.x_min)) +
                    " m long: at the resolution of " + spelled(question.coarsest) + " m that would take " +
                    spelled(std::round(cells / 1e6)) + " million cells, but at most " + spelled(most_cells / 1e6) +
                    " million are supported; name a smaller region, or a coarser resolution");

    ParkBounds bounds;
    bool stopped = false;
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    const auto look = [&] {
        const double part = std::chrono::duration<double>(Clock::now() - begin).count() / options.time_limit;
        if (part > 1.0) throw GivenUp{};
        if (options.progress && !options.progress({bounds.lower, bounds.upper, bounds.spacing, part})) throw GivenUp{};
    };
    const std::unique_ptr<Workers> workers = detail::workers_for(options.threads);
    const Watch watch(look, workers.get());
    try {
        narrow(question, bounds, watch);
    } catch (const GivenUp&) {
        stopped = true;  // as far as it got
    }

    if (bounds.impossible) check_goal(car, place, start, question.coarsest);
    ParkAnswer answer;
    answer.cancelled = stopped;
    answer.direction_changes = bounds.upper;
    answer.lower_bound = bounds.lower;
    answer.impossible = bounds.impossible;
    answer.proved = bounds.meet() || bounds.lower > options.max_changes;
    answer.spacing = bounds.spacing;
    if (!bounds.upper) return answer;
    Maneuver maneuver = detail::in_world(car, start, bounds.way);
    answer.stops = stops_of(maneuver, place, options.clearance);
    answer.maneuver = std::move(maneuver);
    for (const std::vector<detail::Path>& way : bounds.others)
        answer.alternatives.push_back(detail::in_world(car, start, way));
    return answer;
}

}  // namespace snug
