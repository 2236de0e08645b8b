// From a plan to a drive: ways without steering at standstill, the Assistant, and a car that errs.
#include "driving.hpp"

#include <pybind11/stl.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "module.hpp"
#include "snug/draw.hpp"
#include "snug/io.hpp"
#include "value.hpp"

namespace snug::python {

template <>
std::vector<std::pair<std::string_view, Instruction::What>> words() {
    return {{"parked", Instruction::parked},
            {"move", Instruction::move},
            {"escape", Instruction::escape},
            {"overlap", Instruction::overlap},
            {"stuck", Instruction::stuck}};
}

Place place_of(const AnyPlace& place) {
    const auto* street = std::get_if<Street>(&place);
    return street ? street_place(*street) : std::get<Scene>(place).place;
}

Pose start_in(const AnyPlace& place, const Car& car) {
    const auto* street = std::get_if<Street>(&place);
    return street ? standard_start(*street, car) : std::get<Scene>(place).start;
}

double heading_in(const AnyPlace& place, const std::optional<double>& heading) {
    if (heading) return *heading;
    const auto* street = std::get_if<Street>(&place);
    return street ? street->heading : std::get<Scene>(place).start.heading;
}

namespace {

/// An assistant, and of what in Python's words.
struct AssistantOf {
    AnyPlace of;
    std::optional<double> heading;
    AssistantOptions options;
    Assistant assistant;
};

Scene scene_from(const AnyPlace& place, const Pose& start) {
    Scene scene = std::get<Scene>(place);
    scene.start = start;
    return scene;
}

std::string called(const std::optional<Car>& car) { return car->name().empty() ? "a car" : car->name(); }

std::string drawn(const Car& car, const AnyPlace& place, const Pose& start, const ParkAnswer& shown,
                  const PictureOptions& options) {
    if (const auto* street = std::get_if<Street>(&place))
        return draw_park(car, *street, start, shown, PictureFormat::svg, options);
    return draw_park(car, scene_from(place, start), shown, PictureFormat::svg, options);
}

}  // namespace

AskedRolling park_moving(const Car& car, const AnyPlace& place, const Pose& start, const ParkOptions& asked_of,
                         double steering_rate, Progress& progress) {
    RollingOptions options;
    options.clearance = asked_of.clearance;
    options.spacing = asked_of.resolution;
    options.max_changes = asked_of.max_changes;
    options.steering_rate = steering_rate;
    const auto begin = std::chrono::steady_clock::now();
    options.progress = [&] {
        ParkProgress state;
        state.part =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / asked_of.time_limit;
        return state.part <= 1.0 && progress.tell(state);
    };
    AskedRolling asked;
    static_cast<RollingAnswer&>(asked) =
        interruptible(progress, [&] { return park_rolling(car, place_of(place), start, options); });
    asked.car = car;
    asked.place = place;
    asked.start = start;
    asked.max_changes = asked_of.max_changes;
    asked.clearance = asked_of.clearance;
    return asked;
}

std::string json_text(const AskedRolling& answer) {
    ParkOptions options;
    options.max_changes = answer.max_changes;
    options.clearance = answer.clearance;
    if (const auto* street = std::get_if<Street>(&*answer.place))
        return write(park_as_json(*answer.car, *street, answer.start, options, answer));
    return write(park_as_json(*answer.car, scene_from(*answer.place, answer.start), options, answer));
}

std::string json_text(const AskedDrive& answer) {
    if (const auto* street = std::get_if<Street>(&*answer.place))
        return write(drive_as_json(*answer.car, *street, answer.start, answer.options, answer));
    return write(drive_as_json(*answer.car, scene_from(*answer.place, answer.start), answer.options, answer));
}

std::optional<std::string> picture(const AskedRolling& answer) {
    PictureOptions options;
    options.driving.clearance = answer.clearance;
    ParkAnswer shown;
    if (answer.maneuver) {
        shown.maneuver = answer.maneuver->in_arcs();
        shown.direction_changes = answer.maneuver->direction_changes();
    }
    shown.lower_bound = answer.lower_bound;
    return drawn(*answer.car, *answer.place, answer.start, shown, options);
}

std::optional<std::string> picture(const AskedDrive& answer) {
    PictureOptions options;
    options.driving.clearance = answer.margin;
    for (const DriveRun& run : answer.runs) options.tracks.push_back(run.track);
    return drawn(*answer.car, *answer.place, answer.start, answer.plan(), options);
}

namespace {

void define_rolling(py::module_& module) {
    const Signature one("RollingPiece(direction: " + literal<Direction>() +
                        ", curvature: float, sharpness: float, length: float, start: " + pose_type +
                        ", end: " + pose_type + ")");
    Value<RollingPiece> piece(
        module, "RollingPiece",
        one.docstring("Driving one way while the curvature changes evenly with the distance driven: a clothoid; an arc "
                      "or\na straight line where it does not change."));
    piece.field("direction", &RollingPiece::direction, "'backward' or 'forward'")
        .field("curvature", &RollingPiece::curvature, "Where it starts, of the steering, positive to the left. [1/m]")
        .field("sharpness", &RollingPiece::sharpness, "What the curvature gains in every metre driven. [1/m2]")
        .field("length", &RollingPiece::length, "Path of the rear axle centre, never negative. [m]")
        .field("start", &RollingPiece::start, "Pose at the beginning.")
        .field("end", &RollingPiece::end, "Pose at the end.")
        .constructor(one,
                     [](const Arguments& given) {
                         return RollingPiece{given.get<Direction>("direction"), given.get<double>("curvature"),
                                             given.get<double>("sharpness"),    given.get<double>("length"),
                                             given.get<Pose>("start"),          given.get<Pose>("end")};
                     })
        .finish();
    define_method(
        piece, "at(self, distance: float) -> Pose", "The Pose so far after its start [m].",
        [](const RollingPiece& self, const Arguments& given) { return self.at(given.get<double>("distance")); });

    Value<StandingSteer>(module, "StandingSteer", "Where a car stops and turns its steering before it rolls on.")
        .field("piece", &StandingSteer::piece, "The one that begins there.")
        .field("stop", &StandingSteer::stop, "How often the direction has changed when it stands there; 0: the start.")
        .field("curvature", &StandingSteer::curvature,
               "That the wheels have there; the piece begins with another. [1/m]")
        .finish();

    const Signature signature("RollingManeuver(car: Car, pieces: Iterable[RollingPiece])");
    Value<RollingManeuver> type(
        module, "RollingManeuver",
        signature.docstring(
            "A car and what it drives while its steering turns only when it rolls.\n\n"
            "Each piece starts where the one before ends, with the curvature that one ends with, at "
            "the stops\nin between too, or the steering turns there at standstill; the wheels stand straight "
            "at the start."));
    type.field("car", &RollingManeuver::car, "The car that drives.")
        .field("pieces", &RollingManeuver::pieces, "A tuple of RollingPiece.")
        .property("direction_changes", &RollingManeuver::direction_changes, "How often the driving direction changes.")
        .property("length", &RollingManeuver::length, "Path of the rear axle centre. [m]")
        .property(
            "standing_steers", [](const RollingManeuver& m) { return m.standing_steers(); },
            "Where the steering turns at standstill: a tuple of StandingSteer, empty when it never does.")
        .property(
            "seconds", [](const RollingManeuver& m) { return rolling_trajectory(m).seconds(); },
            "How long it takes at the usual limits of trajectory(). [s]")
        .constructor(signature,
                     [](const Arguments& given) {
                         return RollingManeuver{given.get<Car>("car"), given.get<std::vector<RollingPiece>>("pieces")};
                     })
        .said([](const RollingManeuver& m) {
            return "RollingManeuver of " + (m.car.name().empty() ? "a car" : m.car.name()) + ": " +
                   counted(static_cast<int>(m.pieces.size()), "piece") + ", " +
                   counted(m.direction_changes(), "direction change") + ", " + few_digits(m.length()) + " m";
        })
        .picture([](const RollingManeuver& m) { return picture(m.in_arcs(0.05)); })
        .finish();
    define_method(type, "in_arcs(self, most: float = 0.05) -> Maneuver",
                  "Nearly the same as a Maneuver, in arcs at most so long [m], for pictures and waypoints.",
                  [](const RollingManeuver& self, const Arguments& given) {
                      double most = 0.05;
                      given.read("most", most);
                      if (!(most >= 1e-3)) throw Error("most must be at least 0.001 m");
                      return self.in_arcs(most);
                  });

    Value<AskedRolling>(module, "RollingAnswer",
                        "What park() found with steer='moving'. That no maneuver was found proves nothing.")
        .property(
            "parkable", [](const AskedRolling& a) { return a.maneuver.has_value(); }, "Whether a maneuver was found.")
        .field("cancelled", &AskedRolling::cancelled, "A limit, or the progress callback, gave up.")
        .field("maneuver", &AskedRolling::maneuver, "A RollingManeuver, or None.")
        .field(
            "standing", &AskedRolling::standing,
            "Where none was found one that turns its steering at standstill, too, or None: its standing_steers() say "
            "where.")
        .field("work", &AskedRolling::work, "How many pieces were looked at.")
        .field("creep", &AskedRolling::creep, "The speed at which its steering turns at its rate. [m/s]")
        .field("standing_changes", &AskedRolling::standing_changes,
               "Direction changes of a maneuver that is known if it steers at standstill; None where none is.")
        .field("lower_bound", &AskedRolling::lower_bound, "No maneuver, however it steers, has fewer.")
        .field("car", &AskedRolling::car, "The car asked about.", "Car")
        .field("place", &AskedRolling::place, "Where it parks.", "Street | Scene")
        .field("start", &AskedRolling::start, "Where it began.")
        .field("max_changes", &AskedRolling::max_changes, "As asked.")
        .field("clearance", &AskedRolling::clearance, "As asked [m].")
        .said([](const AskedRolling& a) {
            return "RollingAnswer: " + called(a.car) + ", " +
                   (a.maneuver ? counted(a.maneuver->direction_changes(), "direction change") : "none found");
        })
        .picture([](const AskedRolling& a) { return picture(a); })
        .finish();
}

void define_assistant(py::module_& module) {
    Value<Instruction>(module, "Instruction", "What an Assistant says to do next.")
        .field("what", &Instruction::what,
               "'parked': nothing; 'move': drive the moves, then ask again; 'escape': the same, but something is "
               "nearer\nthan the margin, and they lead away from it; 'overlap': the pose overlaps something, and they "
               "lead out of it;\n'stuck': no way is known.")
        .field("moves", &Instruction::moves, "A tuple of Move, of one direction, from the pose measured.")
        .field("direction_changes", &Instruction::direction_changes,
               "Of all of the way to where the car is parked; 0 where an escape takes several arcs.")
        .finish();

    const Signature signature(
        "Assistant(car: Car, place: Street | Scene, *, margin: float = 0.05, steering_reserve: float = 0.0, spacing: "
        "float = 0.0, heading: float | None = None)");
    Value<AssistantOf> type(
        module, "Assistant",
        signature.docstring(
            "Says from wherever a car was measured what it does next, on a map that is swept once.\n\n"
            "The frame grows by the `margin` for planning, and the car is parked where it stands by half of it farther "
            "inside\n[m]; `steering_reserve` is kept for corrections on the way [rad]; `spacing` and `heading` are as "
            "in ParkMap."));
    type.field(
            "car", [](const AssistantOf& a) { return a.assistant.car(); }, "The car it is made for.")
        .field("place", &AssistantOf::of, "The Street or Scene.", "Street | Scene")
        .field(
            "margin", [](const AssistantOf& a) { return a.options.margin; }, "By which the car is grown [m]")
        .field(
            "steering_reserve", [](const AssistantOf& a) { return a.options.steering_reserve; },
            "Kept for corrections [rad]")
        .field(
            "spacing", [](const AssistantOf& a) { return a.options.spacing; }, "As given [m]")
        .field("heading", &AssistantOf::heading, "As given, or None. [rad]")
        .property(
            "fingerprint", [](const AssistantOf& a) { return a.assistant.map().fingerprint(); },
            "Tells the maps of cars, places and margins apart.")
        .property(
            "nbytes", [](const AssistantOf& a) { return a.assistant.map().bytes(); }, "Memory that its map takes.")
        .constructor(signature,
                     [](const Arguments& given) {
                         const auto car = given.get<Car>("car");
                         const AnyPlace place = given.get<AnyPlace>("place");
                         AssistantOptions options;
                         given.read("margin", options.margin);
                         given.read("steering_reserve", options.steering_reserve);
                         given.read("spacing", options.spacing);
                         std::optional<double> heading;
                         given.read("heading", heading);
                         options.heading = heading_in(place, heading);
                         Assistant made = released([&] { return Assistant(car, place_of(place), options); });
                         return AssistantOf{place, heading, options, std::move(made)};
                     })
        .finish();
    define_method(
        type, "next(self, pose: " + pose_type + ", driven: " + literal<Direction>() + " | None = None) -> Instruction",
        "From a measured Pose what to drive until the direction changes, as an Instruction. `driven` is the\n"
        "direction of the last move, for turning costs a change.",
        [](const AssistantOf& self, const Arguments& given) {
            std::optional<Direction> driven;
            given.read("driven", driven);
            return self.assistant.next(given.get<Pose>("pose"), driven);
        });
    define_method(
        type, "plan(self, pose: " + pose_type + ") -> Maneuver | None",
        "All of the way that the map knows from a Pose; None where it is parked or stuck.",
        [](const AssistantOf& self, const Arguments& given) { return self.assistant.plan(given.get<Pose>("pose")); });
}

void define_runs(py::module_& module) {
    Value<DriveRun>(module, "DriveRun", "One run of a simulated car that errs.")
        .field("parked", &DriveRun::parked, "Truly, and without contact.")
        .field("contact", &DriveRun::contact, "It touched something; the run ends there.")
        .field("direction_changes", &DriveRun::direction_changes, "Driven.")
        .field("standing_steers", &DriveRun::standing_steers, "How often the wheels turned while the car stood.")
        .field("seconds", &DriveRun::seconds, "Until it stood for good.")
        .field("smallest_distance", &DriveRun::smallest_distance, "To anything [m]")
        .field("track", &DriveRun::track, "True poses, every few centimetres.")
        .finish();
    Value<AskedDrive>(module, "DriveAnswer", "What drive_runs() found.")
        .field("plannable", &AskedDrive::plannable, "With a margin at all: else there are no runs.")
        .field("cancelled", &AskedDrive::cancelled, "The progress callback gave up.")
        .field("margin", &AskedDrive::margin, "By which the car was grown for planning [m]")
        .field("planned_changes", &AskedDrive::planned_changes, "Direction changes of the plan.")
        .field("lower_bound", &AskedDrive::lower_bound, "No plan with this margin has fewer.")
        .field("planned", &AskedDrive::planned, "The plan from the start, a Maneuver, or None.")
        .field("rolling", &AskedDrive::rolling,
               "With steer='moving' the plan as a RollingManeuver; `planned` has its arcs.")
        .field("standing_changes", &AskedDrive::standing_changes,
               "With steer='moving' the direction changes of a plan that steers at standstill.")
        .field("runs", &AskedDrive::runs, "A tuple of DriveRun.")
        .property(
            "parked", [](const AskedDrive& a) { return a.parked(); }, "How many runs park.")
        .property(
            "contacts", [](const AskedDrive& a) { return a.contacts(); }, "How many touch something.")
        .field("car", &AskedDrive::car, "The car asked about.", "Car")
        .field("place", &AskedDrive::place, "Where it parks.", "Street | Scene")
        .field("start", &AskedDrive::start, "Where it began.")
        .field(
            "sensing", [](auto& a) -> auto& { return a.options.errors.sensing; }, "As asked.")
        .field(
            "bias", [](auto& a) -> auto& { return a.options.errors.bias; }, "As asked.")
        .field("actuation", &AskedDrive::actuation, "As asked: (distance [m], steering [rad]).")
        .field(
            "lag", [](auto& a) -> auto& { return a.options.errors.lag; }, "As asked [s].")
        .field("slot_error", &AskedDrive::slot_error, "As asked: (place, size) [m].")
        .field(
            "rate", [](auto& a) -> auto& { return a.options.rate; }, "As asked.")
        .field(
            "seed", [](auto& a) -> auto& { return a.options.seed; }, "As asked.")
        .field(
            "steer", [](auto& a) -> auto& { return a.options.steer; }, "As asked.")
        .field(
            "speed", [](auto& a) -> auto& { return a.options.limits.speed; }, "As asked [m/s].")
        .field(
            "acceleration", [](auto& a) -> auto& { return a.options.limits.acceleration; }, "As asked [m/s2].")
        .field(
            "deceleration", [](auto& a) -> auto& { return a.options.limits.deceleration; }, "As asked [m/s2].")
        .field(
            "steering_rate", [](auto& a) -> auto& { return a.options.limits.steering_rate; }, "As asked [rad/s].")
        .said([](const AskedDrive& a) {
            if (!a.plannable) return "DriveAnswer: " + called(a.car) + ", no plan";
            return "DriveAnswer: " + called(a.car) + ", " + std::to_string(a.parked()) + " of " +
                   counted(static_cast<int>(a.runs.size()), "run") + " parked";
        })
        .picture([](const AskedDrive& a) { return picture(a); })
        .finish();
    define(
        module,
        "drive_runs(car: Car, place: Street | Scene, start: " + pose_type + " | None = None, *, sensing: " + pose_type +
            " = (0.02, 0.02, 0.008726646259971648), bias: " + pose_type + " = (0.0, 0.0, 0.0), actuation: " +
            point_type + " = (0.01, 0.017453292519943295), lag: float = 0.1, slot_error: " + point_type +
            " = (0.0, 0.0), margin: float | None = None, rate: float = 0.999, resolution: float = 0.0, runs: int = "
            "1000, seed: int = 1, blind: bool = False, steer: " +
            literal<Steer>() +
            " = 'standing', speed: float = 1.0, acceleration: float = 0.5, deceleration: "
            "float = 0.5, steering_rate: float = 0.5, threads: int = 0, " +
            progress_parameter + ") -> DriveAnswer",
        "A plan driven `runs` times by a simulated car that errs and looks again. Returns a DriveAnswer.\n\n"
        "`sensing` are standard deviations of every measured pose and `bias` is added to them [m, m, rad]; "
        "`actuation`\nis of where a move ends and of its steering [m, rad]; the wheels are `lag` behind [s]; "
        "`slot_error` is of the\nplace and of the size of a Street's slot as they seem from the start [m]. The car "
        "is grown by `margin` [m]; without,\nof those with which `rate` of the runs park by the one with the fewest "
        "changes. A `blind` car drives its "
        "first plan without looking again.\nWith steer='moving' it stands to steer only where no way is found without: "
        "standing_steers of each run.\n`progress` is told the part done of the runs with the margin now tried; "
        "returning False ends with those done.\n",
        [](const Arguments& given) {
            AskedDrive asked;
            asked.car = given.get<Car>("car");
            asked.place = given.get<AnyPlace>("place");
            std::optional<Pose> start;
            given.read("start", start);
            asked.start = start ? *start : start_in(*asked.place, *asked.car);
            DriveOptions& options = asked.options;
            given.read("sensing", options.errors.sensing);
            given.read("bias", options.errors.bias);
            asked.actuation = {options.errors.distance, options.errors.steering};
            given.read("actuation", asked.actuation);
            options.errors.distance = asked.actuation.x;
            options.errors.steering = asked.actuation.y;
            given.read("lag", options.errors.lag);
            given.read("slot_error", asked.slot_error);
            options.errors.slot_place = asked.slot_error.x;
            options.errors.slot_size = asked.slot_error.y;
            given.read("margin", options.margin);
            given.read("rate", options.rate);
            given.read("resolution", options.spacing);
            given.read("runs", options.runs);
            given.read("seed", options.seed);
            given.read("blind", options.blind);
            given.read("steer", options.steer);
            given.read("speed", options.limits.speed);
            given.read("acceleration", options.limits.acceleration);
            given.read("deceleration", options.limits.deceleration);
            given.read("steering_rate", options.limits.steering_rate);
            given.read("threads", options.threads);
            Progress progress(given.callback("progress"));
            SweepOptions sweep;
            static_cast<DriveAnswer&>(asked) = interruptible(progress, sweep, [&] {
                DriveOptions told = options;
                told.progress = [&](double, int done) {
                    return sweep.progress(static_cast<double>(done) / options.runs);
                };
                const auto* street = std::get_if<Street>(&*asked.place);
                return street ? drive_runs(*asked.car, *street, asked.start, told)
                              : drive_runs(*asked.car, place_of(*asked.place), asked.start, told);
            });
            return asked;
        });
}

}  // namespace

void define_driving(py::module_& module) {
    define_rolling(module);
    define_assistant(module);
    define_runs(module);
}

}  // namespace snug::python
