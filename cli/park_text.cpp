// The answer of park in plain words: what to do move by move from where the car stands, how it ends, what is proved.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "cli/park.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "snug/contact.hpp"

namespace snug::cli {
namespace {

constexpr double near = 3.0;  ///< what is farther away is not spoken of [m]

using Rows = std::vector<std::vector<std::string>>;

Slot slot_of(const Street& street) {
    return Slot({.length = street.length,
                 .width = street.width,
                 .side = street.side,
                 .corner = street.corner,
                 .heading = street.heading});
}

/// "in the 5.200 x 2.000 m slot on the right", or "in the scene"; without "in" when leaving
std::string into_what(const ParkQuestion& question) {
    const std::string in = question.leaving ? "" : "in ";
    if (!question.street) return in + "the scene";
    const Street& street = *question.street;
    const std::string side = street.side == Side::right ? "right" : "left";
    const std::string size = fixed(street.length, 3) + " x " + metres(street.width);
    if (street.angle == 0.0) return in + "the " + size + " slot on the " + side;
    return in + "the " + size + " bay at " + fixed(street.angle / degree, 1) + " deg on the " + side + ",\n" +
           (street.enter == Enter::backward ? "tail first" : "nose first");
}

std::string the(const Place& place, std::size_t obstacle) {
    return (place.obstacles()[obstacle].name.empty() ? "" : "the ") + place.name_of(obstacle);
}

double off(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi) / degree; }

double parked_heading(const Place& place) {
    const auto* inside = std::get_if<ParkedInside>(&place.parked());
    return inside != nullptr ? inside->heading : std::get<ParkedAt>(place.parked()).pose.heading;
}

/// How far the car is from what is near, nearest first.
Rows distances(const ParkQuestion& question, const Pose& pose) {
    const std::vector<PlaceGap> all = gaps(question.car, question.scene.place, pose, question.options.clearance);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].distance < near) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return all[a].distance != all[b].distance ? all[a].distance < all[b].distance : a < b;
    });
    constexpr std::size_t most = 6;
    if (order.size() > most) order.resize(most);
    Rows rows;
    for (const std::size_t i : order)
        rows.push_back({rows.empty() ? "gaps" : "",
                        metres(std::max(0.0, all[i].distance)) + " to " + the(question.scene.place, i)});
    return rows;
}

std::string where_it_stands(const ParkQuestion& question) {
    const Pose& start = question.scene.start;
    Rows rows;
    if (question.street) {
        const Pose at = slot_of(*question.street).to_slot(start);
        const std::string nose = at.heading > 0.0 ? "away from" : "towards";
        rows = {{"rear axle",
                 metres(std::abs(at.x)) + (at.x >= 0.0 ? " ahead of" : " behind") + " the slot's front corner,"},
                {"", metres(std::abs(at.y)) + (at.y >= 0.0 ? " out in the road" : " inside the entry side")},
                {"heading",
                 std::abs(off(at.heading)) < 5e-4
                     ? "along the street"
                     : fixed(std::abs(off(at.heading)), 3) + " deg off the street's, the nose " + nose + " the curb"}};
    } else {
        rows = {{"rear axle", "at x = " + metres(start.x) + ", y = " + metres(start.y)},
                {"heading", fixed(off(start.heading), 3) + " deg"}};
    }
    for (std::vector<std::string>& row : distances(question, start)) rows.push_back(std::move(row));
    return "\nWhere it stands\n" + table(rows, "ll");
}

std::string moves(const ParkQuestion& question, const ParkAnswer& answer) {
    const Maneuver& maneuver = *answer.maneuver;
    const double clearance = question.options.clearance;
    Rows rows = {{"", "drive", "steering", "distance", "until"}};
    int number = 0;
    for (std::size_t i = 0; i < maneuver.moves.size(); ++i) {
        const Move& move = maneuver.moves[i];
        const bool begins = i == 0 || maneuver.moves[i - 1].direction != move.direction;
        const bool last = i + 1 == maneuver.moves.size();
        std::string until = "turn the wheel on the way";
        if (last || maneuver.moves[i + 1].direction != move.direction) {
            until = !last ? "stop here" : question.leaving ? "stop: out on the road" : "stop: parked";
            if (!last && i < answer.stops.size() && answer.stops[i].gap.distance < near) {
                const ParkStop& stop = answer.stops[i];
                const std::string what = the(question.scene.place, stop.obstacle);
                until = stop.is_contact() ? (clearance > 0.0 ? "stop: near " : "stop: at ") + what
                                          : "stop " + metres(stop.gap.distance) + " from " + what;
            }
        }
        rows.push_back({begins ? std::to_string(++number) : "", std::string(begins ? to_string(move.direction) : ""),
                        steering(question.car, move.steering_angle), metres(move.length), until});
    }
    const std::string full = fixed(question.car.max_steer() / degree, 1) + " deg";
    const std::string kept = clearance > 0.0 ? "; " + metres(clearance) + " kept from everything" : "";
    return "\nWhat to do (full steering: " + full + kept + ")\n" + table(rows, "rllrl");
}

/// A bay whose length and width were taken for one another is likely where the car ends across it.
std::string across(const ParkQuestion& question, const Pose& goal) {
    if (!question.street || question.leaving) return "";
    if (std::abs(off(goal.heading - parked_heading(question.scene.place))) < 45.0) return "";
    return "\nIt ends across the slot: --length is measured along the parked car, --width\n"
           "across it; --parked-heading DEG asks for a heading nearer to the parked one.\n";
}

std::string result(const ParkQuestion& question, const ParkAnswer& answer) {
    const bool stays = answer.maneuver->moves.empty();
    const Pose goal = stays ? question.scene.start : answer.maneuver->goal();
    if (stays)
        return "\nIt stands " + fixed(std::abs(off(goal.heading - parked_heading(question.scene.place))), 3) +
               (question.leaving ? " deg off the street's heading" : " deg off the parked heading") +
               ": nothing is left to do.\n";
    Rows rows = {{"driven", driven(*answer.maneuver)}};
    for (std::vector<std::string>& row : distances(question, goal)) rows.push_back(std::move(row));
    rows.push_back({"angle", fixed(std::abs(off(goal.heading - parked_heading(question.scene.place))), 3) +
                                 (question.leaving ? " deg off the street's heading" : " deg off the parked heading")});
    return "\nHow it ends\n" + table(rows, "ll") + across(question, goal);
}

/// How near the car comes to anything on the way.
double nearest(const ParkQuestion& question, const Maneuver& maneuver) {
    double least = near;
    for (const Pose& pose : maneuver.poses(0.02))
        for (const PlaceGap& gap : gaps(question.car, question.scene.place, pose, question.options.clearance))
            least = std::min(least, gap.distance);
    return std::max(0.0, least);
}

/// More changes that save a detour, keep more distance or end straighter; how to drive them is in the JSON.
std::string alternatives(const ParkQuestion& question, const ParkAnswer& answer) {
    if (answer.alternatives.empty()) return "";
    Rows rows = {{"changes", "driven", "nearest to anything", "off the heading"}};
    const auto add = [&](const Maneuver& maneuver) {
        const double aslant = std::abs(off(maneuver.goal().heading - parked_heading(question.scene.place)));
        rows.push_back({std::to_string(maneuver.direction_changes()), metres(maneuver.length()),
                        metres(nearest(question, maneuver)), fixed(aslant, 3) + " deg"});
    };
    if (!answer.maneuver->moves.empty()) add(*answer.maneuver);
    for (const Maneuver& other : answer.alternatives) add(other);
    std::string straighter;
    if (!answer.maneuver->moves.empty() && !question.leaving) {
        constexpr double more = 1.15;  // degrees
        const auto aslant = [&](const Maneuver& maneuver) {
            return std::abs(off(maneuver.goal().heading - parked_heading(question.scene.place)));
        };
        for (const Maneuver& other : answer.alternatives) {
            if (aslant(other) > aslant(*answer.maneuver) - more) continue;
            straighter = "\nEnding straight takes " + std::to_string(other.direction_changes()) + " changes: with " +
                         std::to_string(*answer.direction_changes) + " it ends " + fixed(aslant(*answer.maneuver), 1) +
                         " deg aslant.\n";
            break;
        }
    }
    return straighter + "\nOther ways (--format json has their moves)\n" + table(rows, "rrrr");
}

std::string proof(const ParkAnswer& answer) {
    const std::string bound = std::to_string(answer.lower_bound);
    if (answer.proved)
        return "\nNo maneuver has fewer: proved" +
               std::string(answer.lower_bound == 0 ? "" : ", for all that stay in the region") + ".\n";
    if (answer.lower_bound == 0) return "\nWhether fewer would do is not known.\n";
    const bool more = *answer.direction_changes - answer.lower_bound > 1;
    return "\nNo maneuver in the region has fewer than " + bound + "; whether " + bound + (more ? " or more" : "") +
           " would do\nis not known.\n";
}

/// Length and width may have been taken for one another: a bay's length is its depth.
std::string exchanged(const ParkQuestion& question, const Driving& driving) {
    Street other = *question.street;
    std::swap(other.length, other.width);
    if (!words(shortfall(question.car, slot_of(other), driving), driving.clearance).empty()) return "";
    return "The other way round it fits: --length is measured along the parked car,\n--width across it.\n";
}

/// Why there is no maneuver, as far as that is known.
std::string refusal(const ParkQuestion& question, const ParkAnswer& answer) {
    const std::string begins = name(question.car) + (answer.proved ? " cannot " : " may ") +
                               (question.leaving ? "leave " : "park ") + into_what(question) + ":\n";
    if (question.street && !question.leaving) {
        Driving driving;
        driving.clearance = question.options.clearance;
        driving.curb_clearance = question.street->curb_clearance;
        const std::string lacking =
            words(shortfall(question.car, slot_of(*question.street), driving), driving.clearance);
        if (!lacking.empty()) return begins + "the slot is " + lacking + ".\n" + exchanged(question, driving);
    }
    if (answer.impossible)
        return begins +
               "no number of direction changes will do, which is proved for all maneuvers that\n"
               "stay in the region.\n";
    const int max_changes = question.options.max_changes;
    const std::string most = (max_changes == 0 ? "" : "up to ") + changes(max_changes);
    if (answer.proved)
        return begins + "no maneuver that stays in the region does with " + most + ",\nwhich is proved.\n";
    return begins + "no maneuver was found with " + most + ",\n" +
           (answer.lower_bound == 0
                ? "but none is proved impossible.\n"
                : "but only fewer than " + changes(answer.lower_bound) + " are proved impossible.\n");
}

/// The pieces of a way whose steering turns only while the car rolls.
std::string moves(const ParkQuestion& question, const RollingManeuver& maneuver) {
    if (maneuver.pieces.empty()) return "\nNothing is left to do.\n";
    Rows rows = {{"", "drive", "steering", "", "distance", "until"}};
    int number = 0;
    const std::vector<RollingPiece>& pieces = maneuver.pieces;
    const auto angle = [&](double curvature) {
        return steering(question.car, std::atan(question.car.wheelbase() * curvature));
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const RollingPiece& piece = pieces[i];
        const bool begins = i == 0 || pieces[i - 1].direction != piece.direction;
        const bool last = i + 1 == pieces.size();
        const bool stops = last || pieces[i + 1].direction != piece.direction;
        rows.push_back({begins ? std::to_string(++number) : "", std::string(begins ? to_string(piece.direction) : ""),
                        angle(piece.curvature),
                        piece.sharpness == 0.0 ? "" : "to " + angle(piece.curvature_at(piece.length)),
                        metres(piece.length),
                        !stops             ? ""
                        : !last            ? "stop here"
                        : question.leaving ? "stop: out on the road"
                                           : "stop: parked"});
    }
    return "\nWhat to do\n" + table(rows, "rlllrl");
}

/// The stops that need steering at standstill.
std::string where_it_steers(const ParkQuestion& question, const RollingManeuver& standing) {
    Rows rows = {{"where", "x", "y", "heading", "steering", ""}};
    const std::vector<StandingSteer> steers = standing.standing_steers();
    const auto angle = [&](double curvature) {
        return steering(question.car, std::atan(question.car.wheelbase() * curvature));
    };
    for (const StandingSteer& steer : steers) {
        const RollingPiece& piece = standing.pieces[steer.piece];
        const bool on_the_way = steer.piece > 0 && standing.pieces[steer.piece - 1].direction == piece.direction;
        rows.push_back({steer.piece == 0 ? "at the start"
                        : on_the_way     ? "on move " + std::to_string(steer.stop + 1)
                                         : "at change " + std::to_string(steer.stop),
                        metres(piece.start.x), metres(piece.start.y), fixed(off(piece.start.heading), 1) + " deg",
                        angle(steer.curvature), "to " + angle(piece.curvature)});
    }
    return "\nWhere the steering turns at standstill: " + std::to_string(steers.size()) +
           (steers.size() == 1 ? " time\n" : " times\n") + table(rows, "lrrrll");
}

}  // namespace

std::string park_text(const ParkQuestion& question, const RollingAnswer& answer) {
    if (!answer.maneuver) {
        const std::string begins = name(question.car) + " may " + (question.leaving ? "leave " : "park ") +
                                   into_what(question) + ",\nbut no way was found " +
                                   (answer.cancelled ? "in the time given " : "") +
                                   "that steers only while it rolls.\n";
        if (!answer.standing) return begins + "With steering at standstill none is known either.\n";
        return begins + "With steering at standstill " + changes(answer.standing->direction_changes()) +
               " will do; fewer may.\n" + where_it_steers(question, *answer.standing);
    }
    const RollingManeuver& maneuver = *answer.maneuver;
    const int more = maneuver.direction_changes() - answer.standing_changes.value_or(maneuver.direction_changes());
    const std::string standing = more > 0 ? "that is " + std::to_string(more) + " more than with steering at standstill"
                                          : std::string("steering at standstill would save none that is known");
    Rows rows = {
        {"driven", metres(maneuver.length()) + " in " + fixed(rolling_trajectory(maneuver).seconds(), 0) + " s"}};
    const Pose goal = maneuver.pieces.empty() ? question.scene.start : maneuver.pieces.back().end;
    for (std::vector<std::string>& row : distances(question, goal)) rows.push_back(std::move(row));
    return name(question.car) + (question.leaving ? " leaves " : " parks ") + into_what(question) + "\nwith " +
           changes(maneuver.direction_changes()) + ", and steers only while it rolls, at " + fixed(answer.creep, 2) +
           " m/s;\n" + standing + ".\n" + where_it_stands(question) + moves(question, maneuver) + "\nHow it ends\n" +
           table(rows, "ll");
}

std::string park_text(const ParkQuestion& question, const ParkAnswer& answer) {
    if (!answer.maneuver) return refusal(question, answer);
    if (answer.maneuver->moves.empty())
        return name(question.car) + (question.leaving ? " is out of " : " is parked already ") + into_what(question) +
               ".\n" + where_it_stands(question) + result(question, answer);
    return name(question.car) + (question.leaving ? " leaves " : " parks ") + into_what(question) + "\nwith " +
           changes(*answer.direction_changes) + ".\n" + where_it_stands(question) + moves(question, answer) +
           result(question, answer) + alternatives(question, answer) + proof(answer);
}

}  // namespace snug::cli
