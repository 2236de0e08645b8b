// The answer in plain words: where to put the car, how exactly, and what to do move by move.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "cli/entry.hpp"
#include "cli/table.hpp"
#include "cli/words.hpp"
#include "sentences/check.hpp"
#include "snug/draw.hpp"

namespace snug::cli {
namespace {

constexpr std::size_t most_ranges = 20;

using Rows = std::vector<std::vector<std::string>>;

/// Enough decimals to tell the ends of a range of headings apart. [rad] in, decimals of degrees out
int decimals(double width) {
    return width > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(width / degree))), 3, 12) : 12;
}

std::string slot_words(const Slot& slot) {
    return "the " + fixed(slot.length(), 3) + " x " + metres(slot.width()) + " slot on the " +
           (slot.side() == Side::right ? "right" : "left");
}

/// Where the frame is, in the slot frame: how far it keeps from each side, negative when beyond it.
struct Around {
    double front;
    double rear;
    double curb;
    double road;  ///< how far it stands out into the road
};

Around around(const Car& car, const Slot& slot, const Pose& pose) {
    Around gaps = {1e300, 1e300, 1e300, -1e300};
    for (const Point& in_world : frame(car, pose)) {
        const Point corner = slot.to_slot(in_world);
        gaps.front = std::min(gaps.front, -corner.x);
        gaps.rear = std::min(gaps.rear, corner.x + slot.length());
        gaps.curb = std::min(gaps.curb, corner.y + slot.width());
        gaps.road = std::max(gaps.road, corner.y);
    }
    return gaps;
}

/// How far out in the road the car's corner is that enters along the slot's corner; trials may enter above it. [m]
double height_over_slot_corner(const EntryQuestion& question, const Pose& entry) {
    const bool backward = question.options.driving.enter == Enter::backward;
    const double clearance = question.options.driving.clearance;
    const Pose pose = question.slot.to_slot(entry);
    const double along = backward ? question.car.front() + clearance : -question.car.rear() - clearance;
    return pose.y + along * std::sin(pose.heading) - (question.car.width() / 2.0 + clearance) * std::cos(pose.heading);
}

/// Off parallel, in (-180, 180]. [deg]
double off_parallel(const Slot& slot, const Pose& pose) {
    return std::remainder(slot.to_slot(pose).heading, 2.0 * std::numbers::pi) / degree;
}

std::string refusal(const EntryQuestion& question) {
    const EntryOptions& options = question.options;
    const std::string lacking =
        words(shortfall(question.car, question.slot, options.driving), options.driving.clearance);
    std::string why;
    if (!lacking.empty()) {
        why = "the slot is " + lacking;
    } else if (options.min_range > 0.0) {
        why = "no range of entry headings at least " + fixed(options.min_range / degree, decimals(options.min_range)) +
              " deg (" + spelled(options.min_range) + " rad) wide\nparks with " +
              (options.max_changes == 0 ? "" : "up to ") + changes(options.max_changes.value_or(200));
    } else {
        const bool trials = question.baseline && !std::holds_alternative<Stepping>(*question.baseline);
        why = (trials ? "trials do not reach the goal with " : "no entry heading parks with ") +
              std::string(options.max_changes == 0 ? "" : "up to ") + changes(options.max_changes.value_or(200));
    }
    return name(question.car) + " cannot park in " + slot_words(question.slot) + ":\n" + why + ".\n";
}

/// How far the start may be off, rounded down to two digits or to millimetres.
std::string off_by(double distance) {
    int digits = 3;
    double units = 1e3;
    for (double least = 0.01; distance < least && digits < 9; least /= 10.0, units *= 10.0) ++digits;
    return fixed(std::floor(distance * units) / units, digits);
}

Rows start_rows(const StartTolerance& tolerance, bool backward) {
    const std::string along = backward ? " m back" : " m ahead";
    Rows rows = {{"off by", "as far as " + off_by(tolerance.along) + along + ", or " + off_by(tolerance.out) +
                                " m farther out, parks likewise"}};
    if (tolerance.both_along > 0.0)
        rows.push_back({"", "(both at once: " + off_by(tolerance.both_along) + along + " and " +
                                off_by(tolerance.both_out) + " m out)"});
    return rows;
}

std::string entry_position(const EntryQuestion& question, const Answer& answer,
                           const std::optional<StartTolerance>& tolerance) {
    const EntryOptions& options = question.options;
    const bool backward = options.driving.enter == Enter::backward;
    const std::string side = question.slot.side() == Side::right ? "right" : "left";
    const std::string touching = backward ? "front" : "rear";
    const Pose pose = answer.maneuver->entry();
    const Pose in_slot = question.slot.to_slot(pose);
    const Around room = around(question.car, question.slot, pose);

    const double heading = std::abs(off_parallel(question.slot, pose));
    const HeadingRange* range = widest_range(answer.ranges, *answer.direction_changes);
    const double spare = range == nullptr ? 0.0 : (range->max - range->min) / 2.0;
    const int digits = range == nullptr ? 3 : decimals(spare);
    const double above = height_over_slot_corner(question, pose);
    const std::string corner = "put the car's " + touching + "-" + side + " corner ";
    const std::string off =
        options.driving.clearance > 0.0 ? metres(options.driving.clearance) + " off along and across the car" : "";
    const std::string begins = "where the " + touching + " neighbour begins";
    Rows rows;
    if (above > 1e-6) {
        rows = {{"corner", corner + metres(above) + " out in the road,"}, {"", "level with " + begins}};
        if (!off.empty()) rows.push_back({"", off});
    } else {
        rows = {{"corner", corner + "at the slot's " + touching + " corner,"}, {"", off.empty() ? begins : off}};
    }
    rows.push_back({"heading", fixed(heading, digits) + " deg off parallel, the " + (backward ? "nose" : "tail") +
                                   " away from the curb"});
    if (range != nullptr) {
        rows.push_back({"", "from " + fixed(range->min / degree, digits) + " to " + fixed(range->max / degree, digits) +
                                " deg, so at most " + fixed(spare / degree, digits) + " deg off either way"});
    }
    const double ahead = backward ? in_slot.x : in_slot.x + question.slot.length();
    rows.push_back({"rear axle", metres(std::abs(ahead)) + (ahead <= 0.0 ? " behind" : " ahead of") + " the slot's " +
                                     touching + " corner, " + metres(std::abs(in_slot.y)) +
                                     (in_slot.y < 0.0 ? " inside the slot" : " out in the road")});
    if (tolerance) {
        const Rows allowed = start_rows(*tolerance, backward);
        rows.insert(rows.end(), allowed.begin(), allowed.end());
    }
    rows.push_back({"room", metres(backward ? room.rear : room.front) + " to the " + (backward ? "rear" : "front") +
                                " neighbour, " + metres(room.curb) + " to the curb"});
    rows.push_back({"road", "the car stands " + metres(room.road) + " out in the road"});
    return "\nWhere to enter\n" + table(rows, "ll");
}

std::string moves(const EntryQuestion& question, const Maneuver& maneuver, const std::string& at_last) {
    const double clearance = question.options.driving.clearance;
    Rows rows = {{"", "drive", "steering", "distance", "until"}};
    for (const Move& move : maneuver.moves) {
        std::string until = "stop here";
        if (&move == &maneuver.moves.back()) {
            until = at_last;
        } else if (move.contact) {
            until = std::string(to_string(move.contact->part)) + (clearance > 0.0 ? " nears " : " meets ") +
                    std::string(called(move.contact->obstacle));
        }
        rows.push_back({std::to_string(rows.size()), std::string(to_string(move.direction)),
                        steering(question.car, move.steering_angle), metres(move.length), until});
    }
    const std::string full = fixed(question.car.max_steer() / degree, 1) + " deg";
    const std::string nearing = clearance > 0.0 ? "; nears: to within " + metres(clearance) : "";
    return "\nWhat to do (full steering: " + full + nearing + ")\n" + table(rows, "rllrl");
}

std::string result(const EntryQuestion& question, const Maneuver& maneuver) {
    constexpr double parallel = 1e-6;  // [deg]
    constexpr double centred = 1e-3;   // [m]
    const Around left = around(question.car, question.slot, maneuver.goal());
    const double angle = std::abs(off_parallel(question.slot, maneuver.goal()));
    Rows rows = {{"driven", driven(maneuver)},
                 {"swing-out", metres(swept(maneuver, question.slot).y_max) + " into the road at most"},
                 {"gaps", metres(left.front) + " to the front neighbour, " + metres(left.rear) + " to the rear one,"},
                 {"", metres(left.curb) + " to the curb, " + metres(-left.road) + " to the road"},
                 {"angle", fixed(angle, 3) + " deg off parallel"}};
    // Straight driving keeps a parallel car where it is between road and curb.
    const double ahead = (left.front - left.rear) / 2.0;
    if (angle < parallel && std::abs(ahead) > centred) {
        const bool goes_on = (maneuver.moves.back().direction == Direction::forward) == (ahead > 0.0);
        rows.push_back({"centred", "after " + metres(std::abs(ahead)) + " straight " +
                                       (ahead > 0.0 ? "ahead" : "back") +
                                       (goes_on ? ", no further change" : ", one change more")});
    }
    return "\nHow it ends\n" + table(rows, "ll");
}

/// All ranges, when there is more to tell than the best one.
std::string ranges(const Answer& answer) {
    if (answer.ranges.size() < 2) {
        return "";
    }
    const std::size_t shown = std::min(answer.ranges.size(), most_ranges);
    const std::vector<HeadingRange> first(answer.ranges.begin(),
                                          answer.ranges.begin() + static_cast<std::ptrdiff_t>(shown));
    int digits = 0;
    for (const HeadingRange& range : first) {
        digits = std::max(digits, decimals(range.max - range.min));
    }
    Rows rows = {{"from [deg]", "to [deg]", "direction changes"}};
    for (const HeadingRange& range : first) {
        rows.push_back({fixed(range.min / degree, digits), fixed(range.max / degree, digits),
                        std::to_string(range.direction_changes)});
    }
    const std::size_t rest = answer.ranges.size() - shown;
    return "\nEntry headings that park\n" + table(rows, "rrr") +
           (rest == 0 ? "" : "  and " + std::to_string(rest) + " more; --format csv lists all\n");
}

/// "12 slivers of headings, 3e-9 deg wide in all": what the proof leaves open; empty if nothing.
std::string slivers(const Answer& answer) {
    if (answer.undecided.empty()) return "";
    double width = 0.0;
    for (const Headings& part : answer.undecided) width += part.max - part.min;
    std::ostringstream text;
    text << answer.undecided.size() << (answer.undecided.size() == 1 ? " sliver" : " slivers") << " of headings, "
         << std::setprecision(2) << width / degree << " deg wide in all";
    return text.str();
}

/// What is proved about entry headings; nothing where no proof was asked for, or where the car has no room to begin with.
std::string proof(const EntryQuestion& question, const Answer& answer) {
    if (!question.options.prove) return "";
    const Shortfall lacks = shortfall(question.car, question.slot, question.options.driving);
    if (lacks != Shortfall{} && !answer.parkable() && answer.proved && answer.undecided.empty()) return "";
    const std::string open = slivers(answer);
    const std::string but_for = open.empty() ? "" : ", but for " + open + "\n(--format json lists them)";
    if (answer.proved) {
        const bool fewest = answer.parkable() && !question.options.max_changes;
        return std::string("Proved: no ") +
               (fewest ? "entry heading needs fewer direction changes" : "entry heading that parks is missed") +
               but_for + ".\n";
    }
    // Sure up to some count, open from the next one on.
    const int first_open = answer.lower_bound;
    const int last_open = answer.parkable() && !question.options.max_changes
                              ? *answer.direction_changes - 1
                              : question.options.max_changes.value_or(200);
    std::string text =
        "Not proved: whether " + std::string(answer.parkable() ? "another" : "an") + " entry heading parks with ";
    text += first_open < last_open ? std::to_string(first_open) + " to " + changes(last_open) : changes(last_open);
    text += " is not known.\n";
    if (first_open > 0)
        text +=
            "Proved: none parks with " + std::string(first_open == 1 ? "" : "up to ") + changes(first_open - 1) + ".\n";
    if (!open.empty()) text += "Nothing is claimed of " + open + "\n(--format json lists them).\n";
    return text;
}

}  // namespace

std::string entry_text(const EntryQuestion& question, const Answer& answer,
                       const std::optional<StartTolerance>& tolerance) {
    if (answer.cancelled) {
        return "Given up before there was an answer.\n";
    }
    if (!answer.parkable()) {
        return refusal(question) + proof(question, answer);
    }
    std::string text = name(question.car) + " parks in " + slot_words(question.slot) + "\nwith " +
                       changes(answer.direction_changes.value_or(0)) + ".\n";
    if (answer.maneuver) {
        text += entry_position(question, answer, tolerance) + moves(question, *answer.maneuver, "stop: parked") +
                result(question, *answer.maneuver);
    }
    const std::string proved = proof(question, answer);
    return text + ranges(answer) + (proved.empty() ? "" : "\n" + proved);
}

namespace {

std::string proof(const Answer& answer) {
    if (!answer.direction_changes) return "";
    const std::string fewer = "No maneuver has fewer";
    if (answer.proved) return "\n" + fewer + ": proved.\n";
    if (answer.lower_bound == 0) return "\nWhether fewer would do is not known.\n";
    return "\n" + fewer + " than " + std::to_string(answer.lower_bound) + "; whether " +
           std::to_string(answer.lower_bound) + (*answer.direction_changes - answer.lower_bound > 1 ? " or more" : "") +
           " would do is not known.\n";
}

std::string no_way(const EntryQuestion& question, const char* what, int max_changes, const Answer& answer) {
    const std::string car_and_slot =
        name(question.car) + (answer.proved ? " cannot " : " may ") + what + " " + slot_words(question.slot) + ":\n";
    const Driving& driving = question.options.driving;
    const std::string lacking = words(shortfall(question.car, question.slot, driving), driving.clearance);
    if (!lacking.empty()) return car_and_slot + "the slot is " + lacking + ".\n";
    const std::string most = (max_changes == 0 ? "" : "up to ") + changes(max_changes);
    if (answer.proved) return car_and_slot + "no maneuver whatsoever does with " + most + ", which is proved.\n";
    const std::string found = car_and_slot + "no maneuver was found with " + most;
    if (answer.lower_bound == 0) return found + " within the limits given,\nand nothing is proved.\n";
    return found + ", but only fewer than " + changes(answer.lower_bound) + "\nare proved impossible.\n";
}

}  // namespace

std::string fewest_text(const EntryQuestion& question, int max_changes, const Answer& answer) {
    if (!answer.maneuver) return no_way(question, "park in", max_changes, answer);
    Answer as_entry;
    as_entry.direction_changes = answer.direction_changes;
    as_entry.maneuver = answer.maneuver;
    return entry_text(question, as_entry) + proof(answer);
}

std::string leave_text(const EntryQuestion& question, const FewestOptions& options, const Answer& answer) {
    if (!answer.maneuver) return no_way(question, "leave", options.max_changes, answer);
    // Where time ran out the way may still have more pieces than it needs.
    const bool chosen = answer.proved || options.time_limit == std::numeric_limits<double>::infinity();
    return name(question.car) + " leaves " + slot_words(question.slot) + "\nwith " +
           changes(*answer.direction_changes) + ".\n" + moves(question, *answer.maneuver, "the way is free") +
           (chosen ? "\nOf the ways out with as few changes one that keeps its distance, with few\n"
                     "pieces, and with full or straight steering where that costs nothing.\n"
                   : "\nFound before the time was up; there may be simpler ways.\n") +
           proof(answer);
}

}  // namespace snug::cli
