// From any pose, into any place: streets, scenes, park() and its map.
#include <pybind11/stl.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <variant>

#include "arguments.hpp"
#include "module.hpp"
#include "progress.hpp"
#include "snug/io.hpp"
#include "snug/scene.hpp"

namespace snug::python {

namespace {

using AnyPlace = std::variant<Street, Scene>;

AnyPlace any_place(const py::object& value) {
    if (py::isinstance<Street>(value)) return value.cast<Street>();
    if (py::isinstance<Scene>(value)) return value.cast<Scene>();
    complain("place", "a snug.Street or a snug.Scene", value);
}

Place place_of(const AnyPlace& place) {
    const auto* street = std::get_if<Street>(&place);
    return street ? street_place(*street) : std::get<Scene>(place).place;
}

/// A map, and of what in Python's words.
struct MapOf {
    AnyPlace of;
    std::optional<double> heading;
    ParkMap map;
};

void define_places(py::module_& module) {
    const Signature street(
        "Street(length, width, *, angle=0.0, road=None, stretch=10.0, enter='backward', side='right', corner=(0.0, "
        "0.0), heading=0.0, front_setback=0.0, rear_setback=0.0, curb='high', curb_clearance=None, "
        "parked_heading=None, parked_curb=None)");
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
        .field(
            "length", [](const Street& s) { return s.length; }, "Along the parked car [m]")
        .field(
            "width", [](const Street& s) { return s.width; }, "Across it [m]")
        .field(
            "angle", [](const Street& s) { return s.angle; }, "Between the parked car and the street [rad]")
        .field(
            "road", [](const Street& s) { return s.road; }, "From the entry side to a wall beyond [m], or None")
        .field(
            "stretch", [](const Street& s) { return s.stretch; }, "How far beyond the slot the rear axle may go [m]")
        .field(
            "enter", [](const Street& s) { return word(s.enter); }, "'backward' or 'forward'")
        .field(
            "side", [](const Street& s) { return word(s.side); }, "'right' or 'left' of the road")
        .field(
            "corner", [](const Street& s) { return s.corner; }, "The slot's corner nearest to the road, ahead [m]")
        .field(
            "heading", [](const Street& s) { return s.heading; }, "Of the street [rad]")
        .field(
            "front_setback", [](const Street& s) { return s.front_setback; },
            "How much deeper the neighbour ahead begins [m]")
        .field(
            "rear_setback", [](const Street& s) { return s.rear_setback; },
            "How much deeper the neighbour behind begins [m]")
        .field(
            "curb", [](const Street& s) { return word(s.curb); }, "'high', or 'low': it stops the wheels only")
        .field(
            "curb_clearance", [](const Street& s) { return s.curb_clearance; },
            "What the body keeps from the curb [m]; None: as everywhere")
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
    define(module, "standard_start(street, car)",
           "Where a car begins unless told otherwise, a Pose: parallel to the street, 1 m beside the front neighbour; "
           "at\n"
           "an angle in the middle of the road, past the bay when it backs in and before it when it noses in.",
           [](const Arguments& given) { return standard_start(given.get<Street>("street"), given.get<Car>("car")); });

    const Signature scene("Scene(json)");
    Value<Scene> type(module, "Scene",
                      scene.docstring("A place of any shape, and where the car stands in it, as a scene file says "
                                      "(docs/formats.md):\n"
                                      "`json` is the text of one."));
    type.field(
            "json", [](const Scene& s) { return as_json(s).dump(); }, "As a scene file.")
        .property(
            "start", [](const Scene& s) { return s.start; }, "Where the car stands, a Pose.")
        .constructor(scene,
                     [](const Arguments& given) { return scene_from_json(given.get<std::string>("json"), "json"); })
        .finish();
    type.def_static(
        "from_dict",
        [](const py::dict& keys) {
            return scene_from_json(std::string(py::str(py::module_::import("json").attr("dumps")(keys))), "scene");
        },
        "from_dict(keys, /)\n--\n\n"
        "The scene that a file with these keys describes. Raises Error when it is none.",
        py::arg("keys"), py::pos_only());
    define(module, "read_scene(path)",
           "The scene in a JSON file, or in a .csv file of the TPCAP benchmark. Raises Error when it cannot be read.",
           [](const Arguments& given) {
               return read_scene(py::str(py::module_::import("os").attr("fspath")(given.get<py::object>("path"))));
           });
}

void define_park(py::module_& module) {
    Value<ParkAnswer>(module, "ParkAnswer", "What park() found, and what is proved.")
        .property(
            "parkable", [](const ParkAnswer& a) { return a.parkable(); }, "Whether a maneuver was found.")
        .field(
            "cancelled", [](const ParkAnswer& a) { return a.cancelled; }, "A limit, or the progress callback, gave up.")
        .field(
            "direction_changes", [](const ParkAnswer& a) { return a.direction_changes; },
            "The fewest that a maneuver was found for; None where none was.")
        .field(
            "lower_bound", [](const ParkAnswer& a) { return a.lower_bound; },
            "No maneuver has fewer; more than max_changes: the car cannot park with as many.")
        .field(
            "proved", [](const ParkAnswer& a) { return a.proved; },
            "The two meet, or the lower bound exceeds what is allowed.")
        .field(
            "impossible", [](const ParkAnswer& a) { return a.impossible; }, "No number of changes will do: proved.")
        .field(
            "maneuver", [](const ParkAnswer& a) { return a.maneuver; }, "One with the fewest changes, or None.")
        .field(
            "alternatives", [](const ParkAnswer& a) { return py::tuple(py::cast(a.alternatives)); },
            "Maneuvers with more changes, each much shorter than those with fewer or ending straighter.")
        .field(
            "spacing", [](const ParkAnswer& a) { return a.spacing; },
            "Of the finest lattice that was needed [m]; 0 if none was.")
        .finish();
    define(
        module,
        "park(car, place, start=None, *, max_changes=200, clearance=0.0, resolution=0.0, time_limit=None, "
        "roomiest=True, progress=None)",
        "From `start`, a Pose in the world, into a Street or a Scene with the fewest direction changes, whatever way "
        "the\n"
        "car is steered, with proof. Returns a ParkAnswer.\n\n"
        "Without `start` it begins where the scene says, or at standard_start(). `clearance` grows the frame for "
        "contacts\n"
        "[m]; `resolution` is the spacing of the finest lattice [m], 0 an eight-hundredth of the car's length; "
        "`time_limit`\n"
        "[s] ends with the bounds found so far; `roomiest=False` takes any maneuver with that many changes. `progress` "
        "is\n"
        "told a FewestProgress; returning False ends with the bounds found so far.\n",
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const AnyPlace place = any_place(given.get<py::object>("place"));
            std::optional<Pose> start;
            given.read("start", start);
            if (!start)
                start = std::holds_alternative<Street>(place) ? standard_start(std::get<Street>(place), car)
                                                              : std::get<Scene>(place).start;
            ParkOptions options;
            given.read("max_changes", options.max_changes);
            given.read("clearance", options.clearance);
            given.read("resolution", options.resolution);
            std::optional<double> time_limit;
            given.read("time_limit", time_limit);
            if (time_limit) options.time_limit = *time_limit;
            given.read("roomiest", options.roomiest);
            Progress progress(given.callback("progress"));
            options.progress = [&](const ParkProgress& state) { return progress.tell(state); };
            return interruptible(progress, [&] { return park(car, place_of(place), *start, options); });
        });
}

/// Counts as whole numbers: what is impossible or unknown is more than any.
constexpr int more_than_any = std::numeric_limits<int>::max();

void define_map(py::module_& module) {
    Value<MapBounds>(module, "MapBounds", "What a ParkMap knows of a pose.")
        .field(
            "where",
            [](const MapBounds& b) {
                return b.where == MapBounds::free ? "free" : b.where == MapBounds::blocked ? "blocked" : "outside";
            },
            "'free'; 'blocked': the car meets something there; 'outside' of the region or the headings covered.")
        .field(
            "lower_bound", [](const MapBounds& b) { return b.lower_bound; }, "No maneuver has fewer changes.")
        .field(
            "impossible", [](const MapBounds& b) { return b.impossible; }, "No number of changes will do: proved.")
        .field(
            "direction_changes", [](const MapBounds& b) { return b.direction_changes; },
            "A maneuver has so many; None where none is known.")
        .field(
            "first", [](const MapBounds& b) { return b.first ? std::optional(word(*b.first)) : std::nullopt; },
            "How that begins, 'backward' or 'forward'; None where the car is parked already.")
        .property(
            "proved", [](const MapBounds& b) { return b.proved(); }, "Both bounds meet.")
        .finish();

    const Signature signature("ParkMap(car, place, *, clearance=0.0, spacing=0.0, max_changes=50, heading=None)");
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
        .field(
            "place", [](const MapOf& m) { return m.of; }, "The Street or Scene.")
        .field(
            "clearance", [](const MapOf& m) { return m.map.clearance(); }, "By which the frame is grown [m]")
        .field(
            "spacing", [](const MapOf& m) { return m.map.spacing(); }, "Of the lattice [m]")
        .field(
            "max_changes", [](const MapOf& m) { return m.map.max_changes(); }, "It counts up to so many.")
        .field(
            "heading", [](const MapOf& m) { return m.heading; }, "As given, or None. [rad]")
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
                         const AnyPlace place = any_place(given.get<py::object>("place"));
                         ParkMapOptions options;
                         given.read("clearance", options.clearance);
                         given.read("spacing", options.spacing);
                         given.read("max_changes", options.max_changes);
                         std::optional<double> heading;
                         given.read("heading", heading);
                         options.heading = heading;
                         if (!heading)
                             options.heading = std::holds_alternative<Street>(place)
                                                   ? std::get<Street>(place).heading
                                                   : std::get<Scene>(place).start.heading;
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
        .finish();
    define_method(type, "at(self, pose)", "What is known of one Pose, as MapBounds.",
                  [](const MapOf& self, const Arguments& given) { return self.map.at(given.get<Pose>("pose")); });
    define_method(
        type, "maneuver(self, pose)",
        "From a Pose until parked, with at most as many changes as at() says, checked by exact contact, as a\n"
        "Maneuver; None where none is known, or the car is parked already.",
        [](const MapOf& self, const Arguments& given) { return self.map.maneuver(given.get<Pose>("pose")); });
    define_method(
        type, "counts(self, poses)",
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
    define_map(module);
}

}  // namespace snug::python
