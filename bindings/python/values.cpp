// Points, poses, cars, slots, moves and maneuvers.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "io/car_file.hpp"
#include "module.hpp"
#include "snug/io.hpp"
#include "value.hpp"

namespace snug::python {

namespace {

/// What numpy makes of a point or a pose.
py::object as_array(const std::vector<double>& numbers, const py::object& dtype) {
    const Numbers array(static_cast<py::ssize_t>(numbers.size()), numbers.data());
    return dtype.is_none() ? py::object(array) : array.attr("astype")(dtype);
}

py::object element(const py::tuple& numbers, const py::object& index) { return numbers.attr("__getitem__")(index); }

void define_geometry(py::module_& module) {
    const Signature point("Point(x: float = 0.0, y: float = 0.0)");
    Value<Point>(module, "Point", point.docstring("A point in the plane. [m]"))
        .field("x", &Point::x, "[m]")
        .field("y", &Point::y, "[m]")
        .constructor(point,
                     [](const Arguments& given) {
                         Point made;
                         given.read("x", made.x);
                         given.read("y", made.y);
                         return made;
                     })
        .finish()
        .def("__iter__", [](const Point& p) { return py::iter(py::make_tuple(p.x, p.y)); })
        .def("__len__", [](const Point&) { return 2; })
        .def("__getitem__", [](const Point& p, const py::object& i) { return element(py::make_tuple(p.x, p.y), i); })
        .def(
            "__array__",
            [](const Point& p, const py::object& dtype, const py::object&) {
                return as_array({p.x, p.y}, dtype);
            },
            "The two numbers.", py::arg("dtype") = py::none(), py::arg("copy") = py::none());

    const Signature pose("Pose(x: float = 0.0, y: float = 0.0, heading: float = 0.0)");
    Value<Pose>(module, "Pose",
                pose.docstring("Where a car stands: the middle of its rear axle [m] and its heading [rad],\n"
                               "counter-clockwise from the x axis."))
        .field("x", &Pose::x, "[m]")
        .field("y", &Pose::y, "[m]")
        .field("heading", &Pose::heading, "Counter-clockwise from the x axis. [rad]")
        .constructor(pose,
                     [](const Arguments& given) {
                         Pose made;
                         given.read("x", made.x);
                         given.read("y", made.y);
                         given.read("heading", made.heading);
                         return made;
                     })
        .finish()
        .def("__iter__", [](const Pose& p) { return py::iter(py::make_tuple(p.x, p.y, p.heading)); })
        .def("__len__", [](const Pose&) { return 3; })
        .def("__getitem__",
             [](const Pose& p, const py::object& i) { return element(py::make_tuple(p.x, p.y, p.heading), i); })
        .def(
            "__array__",
            [](const Pose& p, const py::object& dtype, const py::object&) {
                return as_array({p.x, p.y, p.heading}, dtype);
            },
            "The three numbers.", py::arg("dtype") = py::none(), py::arg("copy") = py::none());

    Value<Box>(module, "Box", "An axis-parallel rectangle. [m]")
        .field("x_min", &Box::x_min, "[m]")
        .field("x_max", &Box::x_max, "[m]")
        .field("y_min", &Box::y_min, "[m]")
        .field("y_max", &Box::y_max, "[m]")
        .finish();
}

py::tuple corners_of(const Outline& outline) {
    py::list corners;
    for (const Point& corner : outline.corners()) corners.append(py::make_tuple(corner.x, corner.y));
    return py::tuple(corners);
}

/// What an outline says already may be said once more, as repr() does.
void check_extent(const char* name, const std::optional<double>& given, double of_outline) {
    if (given && *given != of_outline)
        throw Error(std::string(name) + " is " + std::string(py::repr(py::float_(*given))) + ", but the outline's is " +
                    std::string(py::repr(py::float_(of_outline))) + "; leave it out");
}

/// A path-like object, as the library takes it.
std::string path_of(const Arguments& given) {
    return py::str(py::module_::import("os").attr("fspath")(given.get<py::object>("path")));
}

/// Whatever is given in the keys of car files, and how they go together there.
CarDescription description(const Arguments& given) {
    CarDescription all;
    given.read("name", all.name);
    for (const std::vector<std::string>& keys : {car_lengths, steerings})
        for (const std::string& key : keys) {
            std::optional<double> value;
            given.read(key, value);
            if (value) all.numbers[key] = *value;
        }
    std::optional<std::vector<Point>> outline;
    given.read("outline", outline);
    all.outline = outline;
    py::object radius = py::none();
    given.read("corner_radius", radius);
    if (py::isinstance<py::tuple>(radius) || py::isinstance<py::list>(radius)) {
        const Point both = as_point(radius, "corner_radius");
        all.corner_radius = CornerRadius{both.x, both.y};
    } else if (!radius.is_none()) {
        const double both = as_number(radius, "corner_radius");
        all.corner_radius = CornerRadius{both, both};
    }
    return all;
}

/// A car as C++ makes it, with dimensions as odd as somebody wants; everything else is a description.
Car car_of(const Arguments& given) {
    const CarDescription all = description(given);
    const auto number = [&](const char* key) {
        return all.has(key) ? std::optional(all.numbers.at(key)) : std::nullopt;
    };
    for (const char* key : {"length", "front_overhang", "rear_overhang", "max_steer_deg", "turning_radius",
                            "curb_to_curb", "wall_to_wall"})
        if (all.has(key) || all.corner_radius) return described(all, as_complaint);
    if (!number("max_steer")) return described(all, as_complaint);
    const double wheelbase = *number("wheelbase");
    const double max_steer = *number("max_steer");
    if (all.outline) {
        Car made(Outline(*all.outline), wheelbase, max_steer, all.name);
        check_extent("width", number("width"), made.width());
        check_extent("front", number("front"), made.front());
        check_extent("rear", number("rear"), made.rear());
        return made;
    }
    if (!number("width") || !number("front") || !number("rear")) return described(all, as_complaint);
    return Car({*number("width"), *number("front"), *number("rear"), wheelbase, max_steer}, all.name);
}

void define_car(py::module_& module) {
    const Signature car(
        "Car(*, wheelbase: float, max_steer: float | None = None, width: float | None = None, front: float | None = "
        "None, rear: float | None = None, outline: Iterable[" +
        point_type +
        "] | None = None, name: str = '', length: float | None = None, front_overhang: float | None = None, "
        "rear_overhang: float | None = None, max_steer_deg: float | None = None, turning_radius: float | None = None, "
        "curb_to_curb: float | None = None, wall_to_wall: float | None = None, corner_radius: float | tuple[float, "
        "float] | None = None)");
    Value<Car> type(
        module, "Car",
        car.docstring(
            "A car that can exist: the paper's dimensions D = (w, d_f, d_r, b, phi_max), an outline, or what a data\n"
            "sheet says.\n\n"
            "A rectangle has `width`, `front` and `rear`; any other car has an `outline` in their place: the corners "
            "of\n"
            "a convex polygon, x ahead and y to the left of the middle of the rear axle [m].\n"
            "Lengths lie between 1e-6 and 1e6 m, the steering angle between 0.1 and 89.9 degrees; the front may\n"
            "be shorter than the wheelbase.\n\n"
            "Data sheets have `length`, `front_overhang` and `rear_overhang`, and in the place of `max_steer` [rad] "
            "one "
            "of\n"
            "`max_steer_deg`, `turning_radius` of the rear axle's middle [m] or the diameters `curb_to_curb` and\n"
            "`wall_to_wall` [m]. `corner_radius` rounds a rectangle's corners, in front and behind if there are two "
            "[m].\n"
            "With any of these a car has to be one somebody could mean, as in a car file, and values given twice have "
            "to\n"
            "agree. Raises Error when it is none, or a dimension is impossible."));
    type.field("name", &Car::name, "As in the catalogue, or your own.")
        .field("width", &Car::width, "w: width without mirrors [m]")
        .field("front", &Car::front, "d_f: from the rear axle centre to the front [m]")
        .field("rear", &Car::rear, "d_r: from the rear axle centre to the back [m]")
        .field("wheelbase", &Car::wheelbase, "b: between the axles [m]")
        .field("max_steer", &Car::max_steer, "phi_max: largest steering angle [rad]")
        .field(
            "outline",
            [](const Car& c) -> py::object {
                if (c.is_rectangle()) return py::none();
                return corners_of(c.outline());
            },
            "Corners (x, y) about the middle of the rear axle, counter-clockwise [m]; None for a rectangle.",
            "tuple[tuple[float, float], ...] | None")
        .property(
            "wheels", [](const Car& c) -> py::object { return corners_of(c.wheels()); },
            "Their outer faces (x, y), which a low curb stops: front left, rear left, rear right, front right [m].",
            "tuple[tuple[float, float], ...]")
        .property("length", &Car::length, "Bumper to bumper, d_f + d_r. [m]")
        .property("turning_radius", &Car::turning_radius,
                  "r = b / tan(phi_max): radius of the rear axle centre's tightest circle. [m]")
        .property("curb_to_curb", &Car::curb_to_curb,
                  "Diameter of the outer front wheel's tightest circle, as data sheets print it. [m]")
        .property("wall_to_wall", &Car::wall_to_wall, "Diameter of the tightest circle that the body needs. [m]")
        .constructor(car, car_of)
        .finish();
    define_static(
        type, "from_dict(keys: dict[str, Any], /) -> Car",
        "The car that a car file with these keys describes, as `snug cars --help` lists them, and what an answer's "
        "to_dict()\n"
        "has as its `car`. Raises Error when it is no car somebody could mean.",
        [](const Arguments& given) {
            return car_from_json(as_json_text(given.get<py::object>("keys"), "keys"), "car");
        });
    define(module, "read_car(path: " + path_type + ") -> Car",
           "The car in a car file (JSON). Raises Error when it cannot be read or describes none.",
           [](const Arguments& given) { return read_car(path_of(given)); });
    define(module, "read_cars(path: " + path_type + ") -> list[Car]",
           "The cars in a CSV file, a line for each, with the same keys as columns. Raises Error with line and column "
           "when\n"
           "it cannot be read or one is no car.",
           [](const Arguments& given) { return read_cars(path_of(given)); });

    define(module, "cars() -> list[Car]", "The five cars of the paper's table 1, in its order.",
           [](const Arguments&) { return catalogue(); });
    define(module, "sheet_cars() -> list[tuple[Car, str, str, str]]",
           "Cars of public data sheets, sorted by name, each with the sheet's title, the turning circle printed there, "
           "from which\n"
           "max_steer is derived, and where both were read.",
           [](const Arguments&) {
               std::vector<std::tuple<Car, std::string, std::string, std::string>> list;
               for (const SheetCar& known : sheet_cars())
                   list.emplace_back(known.car, known.sheet, known.circle, known.source);
               return list;
           });
    define(module, "find_car(name: str) -> Car",
           "The car of that name, of cars() or sheet_cars(). Raises Error when there is none, and says which was "
           "probably meant.",
           [](const Arguments& given) {
               const auto name = given.get<std::string>("name");
               if (const auto found = find_car(name)) return *found;
               std::string names;
               for (const Car& each : catalogue()) names.append(names.empty() ? "" : ", ").append(each.name());
               for (const SheetCar& each : sheet_cars()) names.append(", ").append(each.car.name());
               const auto meant = nearest_car_name(name);
               throw Error("name is " + std::string(py::repr(py::str(name))) + ", but must be " +
                           (meant ? "'" + *meant + "' or another" : "one") + " of " + names);
           });
    define(module, "steer_for_turning_radius(wheelbase: float, radius: float) -> float",
           "Steering angle [rad] whose rear axle centre turns with the given radius [m].", [](const Arguments& given) {
               return steer_for_turning_radius(given.get<double>("wheelbase"), given.get<double>("radius"));
           });
    define(module, "steer_for_curb_to_curb(wheelbase: float, width: float, diameter: float) -> float",
           "Steering angle [rad] of a car with the given curb-to-curb diameter [m]; NaN when no steering reaches it.",
           [](const Arguments& given) {
               return steer_for_curb_to_curb(given.get<double>("wheelbase"), given.get<double>("width"),
                                             given.get<double>("diameter"));
           });
}

void define_slot(py::module_& module) {
    const Signature signature("Slot(length: float, width: float, *, side: " + literal<Side>() + " = 'right', corner: " +
                              point_type + " = (0.0, 0.0), heading: float = 0.0, " + neighbour_parameters + ")");
    Value<Slot> slot(
        module, "Slot",
        signature.docstring(
            "The gap between two parked cars: the paper's slot P = (p, delta, W, L).\n\n"
            "`length` is along the road and `width` from the road to the curb [m]; `side` is 'right' or 'left', the "
            "side\n"
            "of the road seen in the driving direction; `corner` is p, the front corner on the entry side [m];\n"
            "`heading` is that of a car parked parallel [rad]; the setbacks are how much deeper than the entry side "
            "the\n"
            "neighbours begin [m]; `curb` is 'high', or 'low': it stops the wheels only. Raises Error when a "
            "dimension\n"
            "is impossible.\n\n"
            "The slot frame has its origin at the corner p, x along the parallel heading and y towards the road; "
            "there\n"
            "every slot is [-length, 0] x [-width, 0], one on the left mirrored."));
    slot.field("length", &Slot::length, "L: along the road [m]")
        .field("width", &Slot::width, "W: from the road to the curb [m]")
        .field("side", &Slot::side, "'right' or 'left' of the road")
        .field("corner", &Slot::corner, "p: the front corner on the entry side [m]")
        .field("heading", &Slot::heading, "Heading of a car parked parallel [rad]")
        .field("front_setback", &Slot::front_setback, "How much deeper the front neighbour begins [m]")
        .field("rear_setback", &Slot::rear_setback, "How much deeper the rear neighbour begins [m]")
        .field("curb", &Slot::curb, "'high', or 'low': it stops the wheels only")
        .constructor(signature,
                     [](const Arguments& given) {
                         SlotDimensions made;
                         given.read("length", made.length);
                         given.read("width", made.width);
                         given.read("side", made.side);
                         given.read("corner", made.corner);
                         given.read("heading", made.heading);
                         given.read("front_setback", made.front_setback);
                         given.read("rear_setback", made.rear_setback);
                         given.read("curb", made.curb);
                         return Slot(made);
                     })
        .finish();
    const auto is_point = [](const Arguments& given) {
        const auto place = given.get<py::object>("place");
        return py::isinstance<Point>(place) || (!py::isinstance<Pose>(place) && py::len_hint(place) == 2);
    };
    define_method(
        slot, "to_world(self, place: " + pose_type + ") -> Pose\nto_world(self, place: " + point_type + ") -> Point",
        "A Pose or Point of the slot frame in the world. Headings are not wrapped.",
        [is_point](const Slot& self, const Arguments& given) -> py::object {
            if (is_point(given)) return py::cast(self.to_world(given.get<Point>("place")));
            return py::cast(self.to_world(given.get<Pose>("place")));
        });
    define_method(slot,
                  "to_slot(self, place: " + pose_type + ") -> Pose\nto_slot(self, place: " + point_type + ") -> Point",
                  "A Pose or Point of the world in the slot frame. Headings are not wrapped.",
                  [is_point](const Slot& self, const Arguments& given) -> py::object {
                      if (is_point(given)) return py::cast(self.to_slot(given.get<Point>("place")));
                      return py::cast(self.to_slot(given.get<Pose>("place")));
                  });
    define_method(
        slot, "mirrored(self, steering_angle: float) -> float",
        "A steering angle (positive to the left) in the world for one in the slot frame, or the reverse. [rad]",
        [](const Slot& self, const Arguments& given) { return self.mirrored(given.get<double>("steering_angle")); });
}

py::array_t<double> as_rows(const std::vector<Pose>& poses) {
    py::array_t<double> rows({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}});
    double* at = rows.mutable_data();
    for (const Pose& pose : poses)
        for (const double value : {pose.x, pose.y, pose.heading}) *at++ = value;
    return rows;
}

void define_maneuver(py::module_& module) {
    const Signature contact("Contact(part: " + literal<CarPart>() + ", obstacle: " + literal<Obstacle>() +
                            ", index: int = 0)");
    Value<Contact>(
        module, "Contact",
        contact.docstring("Which part of the car meets what.\n\n"
                          "`part`: 'front-left corner', 'rear-left corner', 'rear-right corner',\n"
                          "'front-right corner', 'front edge', 'left edge', 'rear edge', 'right edge'\n"
                          "or a wheel, as 'front-left wheel'; `obstacle`: 'front side', 'rear side', 'curb', 'front "
                          "corner' or\n"
                          "'rear corner'; `index` which corner of the outline, an edge's that of the "
                          "corner it follows."))
        .field("part", &Contact::part, "Of the car, as 'rear-right corner'.")
        .field("obstacle", &Contact::obstacle, "What it meets, as 'curb'.")
        .field("index", &Contact::part_index, "Of the outline's corner, or of the one its edge follows.")
        .constructor(contact,
                     [](const Arguments& given) {
                         Contact made{given.get<CarPart>("part"), given.get<Obstacle>("obstacle")};
                         given.read("index", made.part_index);
                         return made;
                     })
        .finish();

    const Signature move("Move(direction: " + literal<Direction>() + ", steering_angle: float, length: float, start: " +
                         pose_type + ", end: " + pose_type + ", contact: Contact | None = None)");
    Value<Move>(module, "Move", move.docstring("Driving one way, 'backward' or 'forward', with one steering angle."))
        .field("direction", &Move::direction, "'backward' or 'forward'")
        .field("steering_angle", &Move::steering_angle, "Positive to the left. [rad]")
        .field("length", &Move::length, "Path of the rear axle centre, never negative. [m]")
        .field("start", &Move::start, "Pose at the beginning.")
        .field("end", &Move::end, "Pose at the end.")
        .field("contact", &Move::contact, "What ends the move; None when the driver stops by choice.")
        .constructor(move,
                     [](const Arguments& given) {
                         Move made;
                         given.read("direction", made.direction);
                         given.read("steering_angle", made.steering_angle);
                         given.read("length", made.length);
                         given.read("start", made.start);
                         given.read("end", made.end);
                         given.read("contact", made.contact);
                         return made;
                     })
        .finish();

    const Signature signature("Maneuver(car: Car, moves: Iterable[Move])");
    Value<Maneuver> type(module, "Maneuver",
                         signature.docstring("A car and its moves, the end of each being the start of the next.\n\n"
                                             "Poses are in the world frame."));
    type.field("car", &Maneuver::car, "The car that drives.")
        .field("moves", &Maneuver::moves, "A tuple of Move.")
        .property("direction_changes", &Maneuver::direction_changes,
                  "How often the driving direction changes between one move and the next.")
        .property("length", &Maneuver::length, "Path of the rear axle centre. [m]")
        .property(
            "seconds", [](const Maneuver& m) { return snug::trajectory(m).seconds(); },
            "How long it takes at the usual limits of trajectory(). [s]")
        .property(
            "standing_steers", [](const Maneuver& m) { return snug::trajectory(m).standing_steers; },
            "How often the car stands to turn its steering, at the start too.")
        .property(
            "entry",
            [](const Maneuver& m) -> std::optional<Pose> {
                if (m.moves.empty()) return std::nullopt;
                return m.entry();
            },
            "First pose; None without a move.")
        .property(
            "goal",
            [](const Maneuver& m) -> std::optional<Pose> {
                if (m.moves.empty()) return std::nullopt;
                return m.goal();
            },
            "Last pose; None without a move.")
        .constructor(signature,
                     [](const Arguments& given) {
                         return Maneuver{given.get<Car>("car"), given.get<std::vector<Move>>("moves")};
                     })
        .said([](const Maneuver& m) {
            return "Maneuver of " + (m.car.name().empty() ? "a car" : m.car.name()) + ": " +
                   counted(static_cast<int>(m.moves.size()), "move") + ", " +
                   counted(m.direction_changes(), "direction change") + ", " + few_digits(m.length()) + " m";
        })
        .picture([](const Maneuver& m) { return picture(m); })
        .finish();
    define_method(type, "poses(self, spacing: float) -> NDArray[np.float64]",
                  "Poses along the way, at most `spacing` [m] apart, with both ends of every move: an array of rows\n"
                  "(x, y, heading). Raises Error when the spacing is less than 1e-9 m or no number.",
                  [](const Maneuver& self, const Arguments& given) {
                      const auto spacing = given.get<double>("spacing");
                      return as_rows(self.poses(spacing));
                  });

    define(
        module,
        "drive(car: Car, start: " + pose_type + ", direction: " + literal<Direction>() +
            ", steering_angle: float, distance: float) -> Pose",
        "Pose after driving `distance` [m] (not negative) from `start` with the steering angle [rad], 'backward' or\n"
        "'forward': an exact arc or line.",
        [](const Arguments& given) {
            const auto distance = given.get<double>("distance");
            if (!(distance >= 0.0)) throw Error("distance must be a number of metres that is not negative");
            return drive(given.get<Car>("car"), given.get<Pose>("start"), given.get<Direction>("direction"),
                         given.get<double>("steering_angle"), distance);
        });
    define(module, "swept(maneuver: Maneuver, slot: Slot | None = None) -> Box",
           "The smallest Box around everything the car frame covers, exactly (all zero without a move): in the world\n"
           "frame, or in the frame of a slot, where y_max is how far the car swings out into the road.",
           [](const Arguments& given) {
               const auto maneuver = given.get<Maneuver>("maneuver");
               std::optional<Slot> slot;
               given.read("slot", slot);
               return slot ? swept(maneuver, *slot) : swept(maneuver);
           });
    define(
        module, "frame(car: Car, poses: Pose | ArrayLike) -> NDArray[np.float64]",
        "Corners of the car frame [m], counter-clockwise: front-left, rear-left, rear-right, front-right. For a Pose\n"
        "an array of four rows (x, y); for an array of poses (..., 3) one of corners (..., 4, 2).",
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const auto poses = given.get<Numbers>("poses");
            if (poses.ndim() < 1 || poses.shape(poses.ndim() - 1) != 3)
                throw Error("poses must have rows of three, (x, y, heading)");
            std::vector<py::ssize_t> shape(poses.shape(), poses.shape() + poses.ndim());
            shape.back() = 4;
            shape.push_back(2);
            Numbers corners(shape);
            double* at = corners.mutable_data();
            for (const double* pose = poses.data(); pose != poses.data() + poses.size(); pose += 3)
                for (const Point& corner : frame(car, {pose[0], pose[1], pose[2]})) {
                    *at++ = corner.x;
                    *at++ = corner.y;
                }
            return corners;
        });
}

}  // namespace

void define_values(py::module_& module) {
    define_geometry(module);
    define_car(module);
    define_slot(module);
    define_maneuver(module);
}

}  // namespace snug::python
