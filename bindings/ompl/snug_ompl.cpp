// What OMPL asks of the slot, of entry positions and of maneuvers.
#include "snug_ompl.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "snug/error.hpp"
#include "snug/max_steer.hpp"

namespace snug {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

double wrapped(double heading) { return std::remainder(heading, 2.0 * std::numbers::pi); }

/// Does the frame (in the slot frame) sink deeper than the tolerance into the neighbour that begins at x, y = 0 and goes on
/// down and to the side (1 for the one in front, -1 behind)? Both are convex, so if not, a line parts them, along a side of
/// one of the two.
bool sinks_into(const std::vector<Point>& frame, double x, double side, double tolerance) {
    const auto all = [&](auto is) { return std::all_of(frame.begin(), frame.end(), is); };
    if (all([&](const Point& p) { return side * (p.x - x) <= tolerance; })) return false;
    if (all([&](const Point& p) { return p.y >= -tolerance; })) return false;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const Point& from = frame[i];
        const Point& to = frame[(i + 1) % frame.size()];
        const Point out = {to.y - from.y, from.x - to.x};  // square to the edge, of its length
        if (side * out.x < 0.0 || out.y > 0.0) continue;   // the neighbour reaches around this edge
        const double beyond = out.x * (x - from.x) - out.y * from.y;
        if (beyond >= -tolerance * std::hypot(out.x, out.y)) return false;
    }
    return true;
}

/// Is the shortest curve between two states the one way there with this length?
bool is_joined(const ob::StateSpace& space, const ob::State* from, const ob::State* to, const Pose& middle,
               double length) {
    if (std::abs(space.distance(from, to) - length) > 1e-9 + 1e-7 * length) return false;
    ob::State* state = space.allocState();
    space.interpolate(from, to, 0.5, state);
    const Pose pose = pose_of(state);
    space.freeState(state);
    return std::hypot(pose.x - middle.x, pose.y - middle.y) < 1e-8 &&
           std::abs(wrapped(pose.heading - middle.heading)) < 1e-8;
}

/// Appends states of the move up to `to`; the one at `from` is there already.
void append(og::PathGeometric& path, const Car& car, const Move& move, double from, double to, double spacing) {
    const auto at = [&](double distance) {
        return drive(car, move.start, move.direction, move.steering_angle, distance);
    };
    const ob::StateSpace& space = *path.getSpaceInformation()->getStateSpace();
    ob::State* state = space.allocState();
    set_pose(state, to == move.length ? move.end : at(to));
    const double middle = (from + to) / 2.0;
    if (to - from <= spacing || is_joined(space, path.getStates().back(), state, at(middle), to - from)) {
        path.append(state);
    } else {
        append(path, car, move, from, middle, spacing);
        append(path, car, move, middle, to, spacing);
    }
    space.freeState(state);
}

}  // namespace

std::shared_ptr<ob::ReedsSheppStateSpace> pose_space(const Car& car, const Box& box) {
    auto space = std::make_shared<ob::ReedsSheppStateSpace>(car.turning_radius());
    ob::RealVectorBounds bounds(2);
    bounds.low = {box.x_min, box.y_min};
    bounds.high = {box.x_max, box.y_max};
    space->setBounds(bounds);
    return space;
}

void set_pose(ob::State* state, const Pose& pose) {
    auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    se2->setXY(pose.x, pose.y);
    se2->setYaw(wrapped(pose.heading));
}

Pose pose_of(const ob::State* state) {
    const auto* se2 = state->as<ob::SE2StateSpace::StateType>();
    return {se2->getX(), se2->getY(), se2->getYaw()};
}

FreeOfTheSlot::FreeOfTheSlot(const ob::SpaceInformationPtr& space, const Car& car, const Slot& slot, double tolerance)
    : StateValidityChecker(space), car_(car), slot_(slot), tolerance_(tolerance) {}

bool FreeOfTheSlot::isValid(const ob::State* state) const {
    // A frame is its own mirror image: its corners come round the same way in a slot on the left.
    const std::vector<Point> corners = frame(car_, slot_.to_slot(pose_of(state)));
    for (const Point& corner : corners) {
        if (corner.y < -slot_.width() - tolerance_) return false;
    }
    return !sinks_into(corners, 0.0, 1.0, tolerance_) && !sinks_into(corners, -slot_.length(), -1.0, tolerance_);
}

EntryPositions::EntryPositions(const ob::SpaceInformationPtr& space, const Car& car, const Slot& slot,
                               std::vector<HeadingRange> ranges, const MaxSteerOptions& options)
    : GoalSampleableRegion(space), car_(car), slot_(slot), ranges_(std::move(ranges)), options_(options) {
    if (ranges_.empty()) throw Error("entry positions are none without ranges of headings; ask entry() for some");
    setThreshold(1e-6);  // the length of a curve to a pose next to it is no more exact
}

void EntryPositions::sampleGoal(ob::State* state) const {
    double all = 0.0;
    for (const HeadingRange& range : ranges_) all += range.max - range.min;
    double left = random_.uniform01() * all;
    const HeadingRange* chosen = &ranges_.front();
    for (const HeadingRange& range : ranges_) {
        chosen = &range;
        if (left <= range.max - range.min) break;
        left -= range.max - range.min;
    }
    const double heading = std::clamp(chosen->min + left, chosen->min, chosen->max);
    set_pose(state, max_steer(car_, slot_, heading, options_).maneuver.entry());
}

unsigned int EntryPositions::maxSampleCount() const { return std::numeric_limits<unsigned int>::max(); }

double EntryPositions::nearest_heading(const Pose& pose) const {
    const double turned = wrapped(slot_.to_slot(pose).heading);
    const double heading = options_.driving.enter == Enter::backward ? turned : -turned;
    double nearest = ranges_.front().min;
    for (const HeadingRange& range : ranges_) {
        const double inside = std::clamp(heading, range.min, range.max);
        if (std::abs(inside - heading) < std::abs(nearest - heading)) nearest = inside;
    }
    return nearest;
}

double EntryPositions::distanceGoal(const ob::State* state) const {
    ob::State* entry = si_->allocState();
    set_pose(entry, maneuver(state).entry());
    const double distance = si_->distance(state, entry);
    si_->freeState(entry);
    return distance;
}

Maneuver EntryPositions::maneuver(const ob::State* entry) const {
    return max_steer(car_, slot_, nearest_heading(pose_of(entry)), options_).maneuver;
}

og::PathGeometric as_path(const Maneuver& maneuver, const ob::SpaceInformationPtr& space, double spacing) {
    if (!(spacing > 1e-9)) throw Error("spacing of a path must be more than 1e-9 m");
    og::PathGeometric path(space);
    for (const Move& move : maneuver.moves) {
        if (path.getStateCount() == 0) {
            ob::State* state = space->allocState();
            set_pose(state, move.start);
            path.append(state);
            space->freeState(state);
        }
        append(path, maneuver.car, move, 0.0, move.length, spacing);
    }
    return path;
}

int direction_changes(const og::PathGeometric& path) {
    const auto& space = *path.getSpaceInformation()->getStateSpace()->as<ob::ReedsSheppStateSpace>();
    constexpr double nothing = 1e-6;  // in turning radii: shorter pieces are rounding
    int changes = 0;
    double last = 0.0;
    for (std::size_t i = 1; i < path.getStateCount(); ++i) {
        const auto curve = space.reedsShepp(path.getState(static_cast<unsigned int>(i) - 1),
                                            path.getState(static_cast<unsigned int>(i)));
        for (std::size_t k = 0; k < 5 && curve.type_[k] != ob::ReedsSheppStateSpace::RS_NOP; ++k) {
            const double length = curve.length_[k];
            if (std::abs(length) <= nothing) continue;
            changes += last * length < 0.0 ? 1 : 0;
            last = length;
        }
    }
    return changes;
}

}  // namespace snug
