// From any pose, into any place: streets, scenes, park() and its map.
#include <pybind11/stl.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <variant>

#include "driving.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "snug/io.hpp"
#include "snug/scene.hpp"
#include "value.hpp"

namespace snug::python {

namespace {

void define_places(py::module_& module) {
    const Signature street(
        "Street(length: float, width: float, *, angle: float = 0.0, road: float | None = None, stretch: float = 10.0, "
        "enter: " +
        literal<Enter>() + " = 'backward', side: " + literal<Side>() + " = 'right', corner: " + point_type +
        " = (0.0, 0.0), heading: float = 0.0, " + neighbour_parameters + ", curb_clearance: float | None = None, " +
        parked_parameters + ")");
    Value<Street>(
        module, "Street",
        street.docstring(
            "A bay at a street: `length` along the parked car by `width` across it [m], at an `angle` from 0\n"
            "(parallel) to pi/2 to the street.\n\n"
            "`road` is a wall along the street so far beyond the entry side [m], None for none; `stretch` is "
            "how\n"
            "far ahead of the slot and behind it the rear axle may go [m]; `enter` is 'backward', tail first, "
            "or\n"
            "'forward'. The rest is as in Slot; what counts as parked may be narrowed to so much off the "
            "parked\n"
            "heading [rad] and so far from the curb [m]."))
        .field("length", &Street::length, "Along the parked car [m]")
        .field("width", &Street::width, "Across it [m]")
        .field("angle", &Street::angle, "Between the parked car and the street [rad]")
        .field("road", &Street::road, "From the entry side to a wall beyond [m], or None")
        .field("stretch", &Street::stretch, "How far beyond the slot the rear axle may go [m]")
        .field("enter", &Street::enter, "'backward' or 'forward'")
        .field("side", &Street::side, "'right' or 'left' of the road")
        .field("corner", &Street::corner, "The slot's corner nearest to the road, ahead [m]")
        .field("heading", &Street::heading, "Of the street [rad]")
        .field("front_setback", &Street::front_setback, "How much deeper the neighbour ahead begins [m]")
        .field("rear_setback", &Street::rear_setback, "How much deeper the neighbour behind begins [m]")
        .field("curb", &Street::curb, "'high', or 'low': it stops the wheels only")
        .field("curb_clearance", &Street::curb_clearance, "What the body keeps from the curb [m]; None: as everywhere")
        .field(
            "parked_heading",
            [](const Street& s) {
                return s.parked.heading == Parked{}.heading ? std::nullopt : std::optional(s.parked.heading);
            },
            "Largest angle off the parked heading [rad], or None")
        .field(
            "parked_curb",
            [](const Street& s) {
                return s.parked.curb == Parked{}.curb ? std::nullopt : std::optional(s.parked.curb);
            },
            "Largest distance from the curb when parked [m], or None")
        .constructor(street,
                     [](const Arguments& given) {
                         Street made;
                         given.read("length", made.length);
                         given.read("width", made.width);
                         given.read("angle", made.angle);
                         given.read("road", made.road);
                         given.read("stretch", made.stretch);
                         given.read("enter", made.enter);
                         given.read("side", made.side);
                         given.read("corner", made.corner);
                         given.read("heading", made.heading);
                         given.read_neighbours(made);
                         given.read("curb_clearance", made.curb_clearance);
                         std::optional<double> limit;
                         given.read("parked_heading", limit);
                         if (limit) made.parked.heading = *limit;
                         limit.reset();
                         given.read("parked_curb", limit);
                         if (limit) made.parked.curb = *limit;
                         static_cast<void>(street_place(made));  // is it possible?
                         return made;
                     })
        .finish();
    define(module, "standard_start(street: Street, car: Car) -> Pose",
           "Where a car begins unless told otherwise, a Pose: parallel to the street, 1 m beside the front neighbour; "
           "at\n"
           "an angle in the middle of the road, past the bay when it backs in and before it when it noses in.",
           [](const Arguments& given) { return standard_start(given.get<Street>("street"), given.get<Car>("car")); });

    const Signature scene("Scene(json: str)");
    Value<Scene> type(module, "Scene",
                      scene.docstring("A place of any shape, and where the car stands in it, as a scene file says "
                                      "(docs/formats.md):\n"
                                      "`json` is the text of one."));
    type.field(
            "json", [](const Scene& s) { return as_json(s).dump(); }, "As a scene file.")
        .property("start", &Scene::start, "Where the car stands, a Pose.")
        .constructor(scene,
                     [](const Arguments& given) { return scene_from_json(given.get<std::string>("json"), "json"); })
        .finish();
    define_static(type, "from_dict(keys: dict[str, Any], /) -> Scene",
                  "The scene that a file with these keys describes. Raises Error when it is none.",
                  [](const Arguments& given) {
                      return scene_from_json(as_json_text(given.get<py::object>("keys"), "keys"), "scene");
                  });
    define(module, "read_scene(path: " + path_type + ") -> Scene",
           "The scene in a JSON file, or in a .csv file of the TPCAP benchmark. Raises Error when it cannot be read.",
           [](const Arguments& given) {
               return read_scene(py::str(py::module_::import("os").attr("fspath")(given.get<py::object>("path"))));
           });
}

void define_min_street(py::module_& module) {
    Value<AskedMinStreet>(module, "MinStreet", "A street that is just large enough, as far as it is known.")
        .field("max_changes", &AskedMinStreet::max_changes, "Direction changes allowed.")
        .field("size", &AskedMinStreet::size,
               "The car parks there [m]; None where nothing within the limits is found to do.")
        .field("lower", &AskedMinStreet::lower, "In none smaller does it park: proved [m].")
        .field("cancelled", &AskedMinStreet::cancelled, "The progress callback gave up.")
        .field("car", &AskedMinStreet::car, "The car asked about.", "Car")
        .field("street", &AskedMinStreet::street, "The street asked about.", "Street")
        .field("sought", &AskedMinStreet::sought, "Which size was asked for.")
        .field("clearance", &AskedMinStreet::clearance, "As asked [m].")
        .said([](const AskedMinStreet& s) {
            return "MinStreet: " + (s.car->name().empty() ? "a car" : s.car->name()) + " with " +
                   counted(s.max_changes, "direction change") + ", " + std::string(to_string(s.sought)) + " " +
                   (s.size ? few_digits(*s.size) + " m" : "-");
        })
        .picture([](const AskedMinStreet& s) { return picture(s); })
        .finish();
    define(module,
           "min_street(car: Car, street: Street, *, sought: " + literal<StreetSize>() +
               " = 'road', max_changes: int = 0, clearance: float = 0.0, largest: float = 0.0, precision: float = "
               "0.01, resolution: float = 0.0, " +
               progress_parameter + ") -> MinStreet",
           "The narrowest road, or the narrowest or shortest bay, with which the car parks from standard_start() with "
           "at\n"
           "most `max_changes` direction changes, over all maneuvers: a MinStreet. The size of `street` that is sought "
           "is not\n"
           "looked at.\n\n"
           "Nothing larger than `largest` is looked at [m]; 0 is a road of 20 m, a bay 4 m wider or longer than the "
           "car.\n"
           "Both bounds are found to `precision` [m], as far as the `resolution` lets them: the spacing of the finest "
           "lattice\n"
           "[m], 0 a two-hundredth of the car's length. `progress` is told the part done; returning False ends with "
           "what is\n"
           "known so far.",
           [](const Arguments& given) {
               AskedMinStreet asked;
               asked.car = given.get<Car>("car");
               asked.street = given.get<Street>("street");
               MinStreetOptions options;
               given.read("sought", options.sought);
               given.read("max_changes", options.max_changes);
               given.read("clearance", options.clearance);
               given.read("largest", options.largest);
               given.read("precision", options.precision);
               given.read("resolution", options.resolution);
               Progress progress(given.callback("progress"));
               options.progress = [&](double part) { return progress.tell(part); };
               static_cast<MinStreet&>(asked) =
                   interruptible(progress, [&] { return min_street(*asked.car, *asked.street, options); });
               asked.sought = options.sought;
               asked.clearance = options.clearance;
               return asked;
           });
}

void define_park(py::module_& module) {
    Value<ParkStop>(module, "ParkStop", "What the car is nearest to where it stops.")
        .field("obstacle", &ParkStop::obstacle, "Of the place, from 0.")
        .field(
            "distance", [](auto& s) -> auto& { return s.gap.distance; }, "[m]")
        .field(
            "part", [](auto& s) -> auto& { return s.gap.part; }, "Of the car.")
        .field(
            "index", [](auto& s) -> auto& { return s.gap.part_index; }, "As in Contact.")
        .finish();
    Value<AskedPark>(module, "ParkAnswer", "What park() found, and what is proved.")
        .property(
            "parkable", [](const AskedPark& a) { return a.parkable(); }, "Whether a maneuver was found.")
        .field("cancelled", &AskedPark::cancelled, "A limit, or the progress callback, gave up.")
        .field("direction_changes", &AskedPark::direction_changes,
               "The fewest that a maneuver was found for; None where none was.")
        .field("lower_bound", &AskedPark::lower_bound,
               "No maneuver has fewer; more than max_changes: the car cannot park with as many.")
        .field("proved", &AskedPark::proved, "The two meet, or the lower bound exceeds what is allowed.")
        .field("impossible", &AskedPark::impossible, "No number of changes will do: proved.")
        .field("maneuver", &AskedPark::maneuver, "One with the fewest changes, or None.")
        .field("alternatives", &AskedPark::alternatives,
               "Maneuvers with more changes, each much shorter than those with fewer or ending straighter.")
        .field("spacing", &AskedPark::spacing, "Of the finest lattice that was needed [m]; 0 if none was.")
        .field("stops", &AskedPark::stops, "What the car is nearest to at the end of every move.")
        .field("car", &AskedPark::car, "The car asked about.", "Car")
        .field("place", &AskedPark::place, "Where it parks.", "Street | Scene")
        .field("start", &AskedPark::start, "Where it began.")
        .field("max_changes", &AskedPark::max_changes, "As asked.")
        .field("clearance", &AskedPark::clearance, "As asked [m].")
        .said([](const AskedPark& a) {
            std::string text = "ParkAnswer: " + (a.car->name().empty() ? "a car" : a.car->name()) + ", ";
            text += a.direction_changes ? counted(*a.direction_changes, "direction change")
                    : a.impossible      ? "impossible"
                    : a.proved          ? "cannot park"
                                        : "undecided";
            return text + (a.proved ? ", proved" : "");
        })
        .picture([](const AskedPark& a) { return picture(a); })
        .finish();
    define(
        module,
        "park(car: Car, place: Street | Scene, start: " + pose_type +
            " | None = None, *, max_changes: int = 200, clearance: float = 0.0, resolution: float = 0.0, time_limit: "
            "float | None = None, roomiest: bool = True, steer: " +
            literal<Steer>() + " = 'standing', steering_rate: float = 0.5, threads: int = 0, " +
            search_progress_parameter + ") -> ParkAnswer | RollingAnswer",
        "From `start`, a Pose in the world, into a Street or a Scene with the fewest direction changes, whatever way "
        "the\n"
        "car is steered, with proof. Returns a ParkAnswer.\n\n"
        "Without `start` it begins where the scene says, or at standard_start(). `clearance` grows the frame for "
        "contacts\n"
        "[m]; `resolution` is the spacing of the finest lattice [m], 0 an eight-hundredth of the car's length and "
        "finer\n"
        "where that takes seconds; `time_limit`\n"
        "[s] ends with the bounds found so far; `roomiest=False` takes any maneuver with that many changes. `progress` "
        "is\n"
        "told a FewestProgress; returning False ends with the bounds found so far. Runs on all cores, or on so many\n"
        "`threads`.\n\n"
        "With steer='moving' the steering turns, at its `steering_rate` [rad/s], only while the car rolls: a "
        "RollingAnswer.\n",
        [](const Arguments& given) -> py::object {
            const auto car = given.get<Car>("car");
            const AnyPlace place = given.get<AnyPlace>("place");
            std::optional<Pose> start;
            given.read("start", start);
            if (!start) start = start_in(place, car);
            ParkOptions options;
            given.read("max_changes", options.max_changes);
            given.read("clearance", options.clearance);
            given.read("resolution", options.resolution);
            std::optional<double> time_limit;
            given.read("time_limit", time_limit);
            if (time_limit) options.time_limit = *time_limit;
            given.read("roomiest", options.roomiest);
            options.threads = 0;
            given.read("threads", options.threads);
            Progress progress(given.callback("progress"));
            Steer steer = Steer::standing;
            double steering_rate = 0.5;
            given.read("steer", steer);
            given.read("steering_rate", steering_rate);
            if (steer == Steer::moving)
                return py::cast(park_moving(car, place, *start, options, steering_rate, progress));
            options.progress = [&](const ParkProgress& state) { return progress.tell(state); };
            AskedPark asked;
            static_cast<ParkAnswer&>(asked) =
                interruptible(progress, [&] { return park(car, place_of(place), *start, options); });
            asked.car = car;
            asked.place = place;
            asked.start = *start;
            asked.max_changes = options.max_changes;
            asked.clearance = options.clearance;
            return py::cast(asked);
        });
}

/// Counts as whole numbers: what is impossible or unknown is more than any.
constexpr int more_than_any = std::numeric_limits<int>::max();

void define_map(py::module_& module) {
    Value<MapBounds>(module, "MapBounds", "What a ParkMap knows of a pose.")
        .field("where", &MapBounds::where,
               "'free'; 'blocked': the car meets something there; 'outside' of the region or the headings covered.")
        .field("lower_bound", &MapBounds::lower_bound, "No maneuver has fewer changes.")
        .field("impossible", &MapBounds::impossible, "No number of changes will do: proved.")
        .field("direction_changes", &MapBounds::direction_changes, "A maneuver has so many; None where none is known.")
        .field("first", &MapBounds::first,
               "How that begins, 'backward' or 'forward'; None where the car is parked already.")
        .property(
            "proved", [](const MapBounds& b) { return b.proved(); }, "Both bounds meet.")
        .table()
        .finish();

    const Signature signature(
        "ParkMap(car: Car, place: Street | Scene, *, clearance: float = 0.0, spacing: float = 0.0, max_changes: int = "
        "50, heading: float | None = None)");
    Value<MapOf> type(
        module, "ParkMap",
        signature.docstring(
            "With how few direction changes the car parks from every pose of a Street or Scene, swept once.\n\n"
            "It covers headings within 80 degrees of the middle between the parked one and `heading`, by default the "
            "street's\n"
            "or that of the scene's start [rad]. `spacing` is that of the lattice [m], 0 for 8 cm or what a small "
            "turning\n"
            "circle needs; half of it takes four times as long. Counts go up to `max_changes`."));
    type.field(
            "car", [](const MapOf& m) { return m.map.car(); }, "The car it is made for.")
        .field("place", &MapOf::of, "The Street or Scene.", "Street | Scene")
        .field(
            "clearance", [](const MapOf& m) { return m.map.clearance(); }, "By which the frame is grown [m]")
        .field(
            "spacing", [](const MapOf& m) { return m.map.spacing(); }, "Of the lattice [m]")
        .field(
            "max_changes", [](const MapOf& m) { return m.map.max_changes(); }, "It counts up to so many.")
        .field("heading", &MapOf::heading, "As given, or None. [rad]")
        .property(
            "middle_heading", [](const MapOf& m) { return m.map.middle_heading(); },
            "80 degrees to either side of it are covered. [rad]")
        .property(
            "fingerprint", [](const MapOf& m) { return m.map.fingerprint(); },
            "Tells cars, places and clearances apart.")
        .property(
            "nbytes", [](const MapOf& m) { return m.map.bytes(); }, "Memory it takes.")
        .constructor(signature,
                     [](const Arguments& given) {
                         const auto car = given.get<Car>("car");
                         const AnyPlace place = given.get<AnyPlace>("place");
                         ParkMapOptions options;
                         given.read("clearance", options.clearance);
                         given.read("spacing", options.spacing);
                         given.read("max_changes", options.max_changes);
                         std::optional<double> heading;
                         given.read("heading", heading);
                         options.heading = heading_in(place, heading);
                         Progress progress(py::none{});
                         options.progress = [&] { return progress.tell(); };
                         try {
                             ParkMap map = released([&] { return ParkMap(car, place_of(place), options); });
                             return MapOf{place, heading, std::move(map)};
                         } catch (const Error&) {
                             progress.check();
                             throw;
                         }
                     })
        .picture([](const MapOf& m) { return picture(m); })
        .finish();
    define_method(type, "at(self, pose: " + pose_type + ") -> MapBounds", "What is known of one Pose, as MapBounds.",
                  [](const MapOf& self, const Arguments& given) { return self.map.at(given.get<Pose>("pose")); });
    define_method(
        type, "maneuver(self, pose: " + pose_type + ") -> Maneuver | None",
        "From a Pose until parked, with at most as many changes as at() says, checked by exact contact, as a\n"
        "Maneuver; None where none is known, or the car is parked already.",
        [](const MapOf& self, const Arguments& given) { return self.map.maneuver(given.get<Pose>("pose")); });
    define_method(
        type, "counts(self, poses: ArrayLike) -> tuple[NDArray[np.int32], NDArray[np.int32]]",
        "Bounds on the fewest direction changes from many poses: an array whose last axis holds (x, y, heading).\n"
        "Returns two arrays of whole numbers, lower bounds and demonstrated counts. Where no number of changes will "
        "do, or\n"
        "none is known, they hold 2147483647; both are -1 outside of what the map covers and -2 where the car meets\n"
        "something.",
        [](const MapOf& self, const Arguments& given) {
            const auto poses = given.get<Numbers>("poses");
            if (poses.ndim() == 0 || poses.shape(poses.ndim() - 1) != 3)
                throw Error("poses has the shape " + std::string(py::str(poses.attr("shape"))) +
                            ", but its last axis must hold (x, y, heading)");
            const std::vector<py::ssize_t> shape(poses.shape(), poses.shape() + poses.ndim() - 1);
            py::array_t<int> lower(shape), upper(shape);
            int *low = lower.mutable_data(), *up = upper.mutable_data();
            const double* at = poses.data();
            const py::ssize_t count = lower.size();
            released([&] {
                for (py::ssize_t i = 0; i < count; ++i, at += 3) {
                    const MapBounds bounds = self.map.at({at[0], at[1], at[2]});
                    low[i] = bounds.impossible ? more_than_any : bounds.lower_bound;
                    up[i] = bounds.direction_changes.value_or(more_than_any);
                    if (bounds.where != MapBounds::free) low[i] = up[i] = bounds.where == MapBounds::outside ? -1 : -2;
                }
            });
            return py::make_tuple(lower, upper);
        });
}

}  // namespace

void define_parking(py::module_& module) {
    define_places(module);
    define_park(module);
    define_min_street(module);
    define_map(module);
}

}  // namespace snug::python
