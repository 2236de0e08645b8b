// Points, poses, cars, slots, moves and maneuvers.
#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "arguments.hpp"
#include "module.hpp"
#include "snug/io.hpp"

namespace snug::python {

namespace {

void define_geometry(py::module_& module) {
    const Signature point("Point(x=0.0, y=0.0)");
    Value<Point>(module, "Point", point.docstring("A point in the plane. [m]"))
        .field(
            "x", [](const Point& p) { return p.x; }, "[m]")
        .field(
            "y", [](const Point& p) { return p.y; }, "[m]")
        .constructor(point,
                     [](const Arguments& given) {
                         Point made;
                         given.read("x", made.x);
                         given.read("y", made.y);
                         return made;
                     })
        .finish()
        .def("__iter__", [](const Point& p) { return py::iter(py::make_tuple(p.x, p.y)); });

    const Signature pose("Pose(x=0.0, y=0.0, heading=0.0)");
    Value<Pose>(module, "Pose",
                pose.docstring("Where a car stands: the middle of its rear axle [m] and its heading [rad],\n"
                               "counter-clockwise from the x axis."))
        .field(
            "x", [](const Pose& p) { return p.x; }, "[m]")
        .field(
            "y", [](const Pose& p) { return p.y; }, "[m]")
        .field(
            "heading", [](const Pose& p) { return p.heading; }, "Counter-clockwise from the x axis. [rad]")
        .constructor(pose,
                     [](const Arguments& given) {
                         Pose made;
                         given.read("x", made.x);
                         given.read("y", made.y);
                         given.read("heading", made.heading);
                         return made;
                     })
        .finish()
        .def("__iter__", [](const Pose& p) { return py::iter(py::make_tuple(p.x, p.y, p.heading)); });

    Value<Box>(module, "Box", "An axis-parallel rectangle. [m]")
        .field(
            "x_min", [](const Box& b) { return b.x_min; }, "[m]")
        .field(
            "x_max", [](const Box& b) { return b.x_max; }, "[m]")
        .field(
            "y_min", [](const Box& b) { return b.y_min; }, "[m]")
        .field(
            "y_max", [](const Box& b) { return b.y_max; }, "[m]")
        .finish();
}

/// What an outline says already may be said once more, as repr() does.
void check_extent(const char* name, const std::optional<double>& given, double of_outline) {
    if (given && *given != of_outline)
        throw Error(std::string(name) + " is " + std::string(py::repr(py::float_(*given))) + ", but the outline's is " +
                    std::string(py::repr(py::float_(of_outline))) + "; leave it out");
}

void define_car(py::module_& module) {
    const Signature car("Car(*, wheelbase, max_steer, width=None, front=None, rear=None, outline=None, name='')");
    Value<Car> type(
        module, "Car",
        car.docstring(
            "A car that can exist: the paper's dimensions D = (w, d_f, d_r, b, phi_max), or an outline.\n\n"
            "A rectangle has `width`, `front` and `rear`; any other car has an `outline` in their place: the corners "
            "of\n"
            "a convex polygon, x ahead and y to the left of the middle of the rear axle [m].\n"
            "Lengths lie between 1e-6 and 1e6 m, the steering angle between 0.1 and 89.9 degrees; the front may\n"
            "be shorter than the wheelbase. Raises Error when a dimension is impossible."));
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
                py::list corners;
                for (const Point& corner : c.outline().corners()) corners.append(py::make_tuple(corner.x, corner.y));
                return py::tuple(corners);
            },
            "Corners (x, y) about the middle of the rear axle, counter-clockwise [m]; None for a rectangle.")
        .property("length", &Car::length, "Bumper to bumper, d_f + d_r. [m]")
        .property("turning_radius", &Car::turning_radius,
                  "r = b / tan(phi_max): radius of the rear axle centre's tightest circle. [m]")
        .property("curb_to_curb", &Car::curb_to_curb,
                  "Diameter of the outer front wheel's tightest circle, as data sheets print it. [m]")
        .property("wall_to_wall", &Car::wall_to_wall, "Diameter of the tightest circle that the body needs. [m]")
        .constructor(car,
                     [](const Arguments& given) {
                         std::string name;
                         py::object outline = py::none();
                         given.read("name", name);
                         given.read("outline", outline);
                         const auto wheelbase = given.get<double>("wheelbase");
                         const auto max_steer = given.get<double>("max_steer");
                         std::optional<double> width, front, rear;
                         given.read("width", width);
                         given.read("front", front);
                         given.read("rear", rear);
                         if (outline.is_none()) {
                             for (const auto& [key, value] :
                                  {std::pair("width", width), std::pair("front", front), std::pair("rear", rear)})
                                 if (!value)
                                     throw py::type_error(std::string(key) + " is missing; give it, or an outline");
                             return Car({*width, *front, *rear, wheelbase, max_steer}, name);
                         }
                         std::vector<Point> corners;
                         for (const py::handle corner : outline) corners.push_back(as_point(corner, "outline"));
                         Car made(Outline(std::move(corners)), wheelbase, max_steer, name);
                         check_extent("width", width, made.width());
                         check_extent("front", front, made.front());
                         check_extent("rear", rear, made.rear());
                         return made;
                     })
        .finish();
    type.def_static(
        "from_dict",
        [](const py::dict& keys) {
            return car_from_json(std::string(py::str(py::module_::import("json").attr("dumps")(keys))), "car");
        },
        "from_dict(keys, /)\n--\n\n"
        "The car that a car file with these keys describes, as `snug cars --help` lists them: also overhangs,\n"
        "circles and corner_radius. Raises Error when it is no car somebody could mean.",
        py::arg("keys"), py::pos_only());
    define(module, "read_car(path)", "The car in a car file. Raises Error when it cannot be read or describes none.",
           [](const Arguments& given) {
               return read_car(py::str(py::module_::import("os").attr("fspath")(given.get<py::object>("path"))));
           });

    define(module, "cars()", "The five cars of the paper's table 1, in its order.",
           [](const Arguments&) { return catalogue(); });
    define(module, "sheet_cars()",
           "Cars of public data sheets, sorted by name, each with the sheet's title, the turning circle printed there, "
           "from which\n"
           "max_steer is derived, and where both were read.",
           [](const Arguments&) {
               std::vector<std::tuple<Car, std::string, std::string, std::string>> list;
               for (const SheetCar& known : sheet_cars())
                   list.emplace_back(known.car, known.sheet, known.circle, known.source);
               return list;
           });
    define(module, "find_car(name)",
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
    define(module, "steer_for_turning_radius(wheelbase, radius)",
           "Steering angle [rad] whose rear axle centre turns with the given radius [m].", [](const Arguments& given) {
               return steer_for_turning_radius(given.get<double>("wheelbase"), given.get<double>("radius"));
           });
    define(module, "steer_for_curb_to_curb(wheelbase, width, diameter)",
           "Steering angle [rad] of a car with the given curb-to-curb diameter [m]; NaN when no steering reaches it.",
           [](const Arguments& given) {
               return steer_for_curb_to_curb(given.get<double>("wheelbase"), given.get<double>("width"),
                                             given.get<double>("diameter"));
           });
}

void define_slot(py::module_& module) {
    const Signature signature(
        "Slot(length, width, *, side='right', corner=(0.0, 0.0), heading=0.0, front_setback=0.0, rear_setback=0.0, "
        "curb='high')");
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
        .field(
            "side", [](const Slot& s) { return word(s.side()); }, "'right' or 'left' of the road")
        .field("corner", &Slot::corner, "p: the front corner on the entry side [m]")
        .field("heading", &Slot::heading, "Heading of a car parked parallel [rad]")
        .field("front_setback", &Slot::front_setback, "How much deeper the front neighbour begins [m]")
        .field("rear_setback", &Slot::rear_setback, "How much deeper the rear neighbour begins [m]")
        .field(
            "curb", [](const Slot& s) { return word(s.curb()); }, "'high', or 'low': it stops the wheels only")
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
    define_method(slot, "to_world(self, place)",
                  "A Pose or Point of the slot frame in the world. Headings are not wrapped.",
                  [is_point](const Slot& self, const Arguments& given) -> py::object {
                      if (is_point(given)) return py::cast(self.to_world(given.get<Point>("place")));
                      return py::cast(self.to_world(given.get<Pose>("place")));
                  });
    define_method(slot, "to_slot(self, place)",
                  "A Pose or Point of the world in the slot frame. Headings are not wrapped.",
                  [is_point](const Slot& self, const Arguments& given) -> py::object {
                      if (is_point(given)) return py::cast(self.to_slot(given.get<Point>("place")));
                      return py::cast(self.to_slot(given.get<Pose>("place")));
                  });
    define_method(
        slot, "mirrored(self, steering_angle)",
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
    const Signature contact("Contact(part, obstacle)");
    Value<Contact>(module, "Contact",
                   contact.docstring("Which part of the car meets what.\n\n"
                                     "`part`: 'front-left corner', 'rear-left corner', 'rear-right corner',\n"
                                     "'front-right corner', 'front edge', 'left edge', 'rear edge' or 'right edge';\n"
                                     "`obstacle`: 'front side', 'rear side', 'curb', 'front corner' or 'rear corner'."))
        .field(
            "part", [](const Contact& c) { return word(c.part); }, "Of the car, as 'rear-right corner'.")
        .field(
            "obstacle", [](const Contact& c) { return word(c.obstacle); }, "What it meets, as 'curb'.")
        .constructor(contact,
                     [](const Arguments& given) {
                         return Contact{given.get<CarPart>("part"), given.get<Obstacle>("obstacle")};
                     })
        .finish();

    const Signature move("Move(direction, steering_angle, length, start, end, contact=None)");
    Value<Move>(module, "Move", move.docstring("Driving one way, 'backward' or 'forward', with one steering angle."))
        .field(
            "direction", [](const Move& m) { return word(m.direction); }, "'backward' or 'forward'")
        .field(
            "steering_angle", [](const Move& m) { return m.steering_angle; }, "Positive to the left. [rad]")
        .field(
            "length", [](const Move& m) { return m.length; }, "Path of the rear axle centre, never negative. [m]")
        .field(
            "start", [](const Move& m) { return m.start; }, "Pose at the beginning.")
        .field(
            "end", [](const Move& m) { return m.end; }, "Pose at the end.")
        .field(
            "contact", [](const Move& m) { return m.contact; },
            "What ends the move; None when the driver stops by choice.")
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

    const Signature signature("Maneuver(car, moves)");
    Value<Maneuver> type(module, "Maneuver",
                         signature.docstring("A car and its moves, the end of each being the start of the next.\n\n"
                                             "Poses are in the world frame."));
    type.field(
            "car", [](const Maneuver& m) { return m.car; }, "The car that drives.")
        .field(
            "moves", [](const Maneuver& m) { return py::tuple(py::cast(m.moves)); }, "A tuple of Move.")
        .property("direction_changes", &Maneuver::direction_changes,
                  "How often the driving direction changes between one move and the next.")
        .property("length", &Maneuver::length, "Path of the rear axle centre. [m]")
        .property(
            "seconds", [](const Maneuver& m) { return snug::trajectory(m).seconds(); },
            "How long it takes at the usual limits of trajectory(). [s]")
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
                         Maneuver made{given.get<Car>("car"), {}};
                         const auto moves = given.get<py::object>("moves");
                         if (!py::isinstance<py::iterable>(moves)) complain("moves", "a sequence of snug.Move", moves);
                         for (const py::handle one : moves)
                             made.moves.push_back(as<Move>(one, "moves[" + std::to_string(made.moves.size()) + "]"));
                         return made;
                     })
        .finish(true)
        .def("__repr__", [](const Maneuver& m) {
            const auto number = [](double value) { return std::string(py::repr(py::float_(value))); };
            return "<Maneuver of " + (m.car.name().empty() ? "a car" : m.car.name()) + ": " +
                   std::to_string(m.moves.size()) + " moves, " + std::to_string(m.direction_changes()) +
                   " direction changes, " + number(m.length()) + " m>";
        });
    define_method(type, "poses(self, spacing)",
                  "Poses along the way, at most `spacing` [m] apart, with both ends of every move: an array of rows\n"
                  "(x, y, heading). Raises Error when the spacing is less than 1e-9 m or no number.",
                  [](const Maneuver& self, const Arguments& given) {
                      const auto spacing = given.get<double>("spacing");
                      return as_rows(self.poses(spacing));
                  });

    define(
        module, "drive(car, start, direction, steering_angle, distance)",
        "Pose after driving `distance` [m] (not negative) from `start` with the steering angle [rad], 'backward' or\n"
        "'forward': an exact arc or line.",
        [](const Arguments& given) {
            const auto distance = given.get<double>("distance");
            if (!(distance >= 0.0)) throw Error("distance must be a number of metres that is not negative");
            return drive(given.get<Car>("car"), given.get<Pose>("start"), given.get<Direction>("direction"),
                         given.get<double>("steering_angle"), distance);
        });
    define(module, "swept(maneuver, slot=None)",
           "The smallest Box around everything the car frame covers, exactly (all zero without a move): in the world\n"
           "frame, or in the frame of a slot, where y_max is how far the car swings out into the road.",
           [](const Arguments& given) {
               const auto maneuver = given.get<Maneuver>("maneuver");
               std::optional<Slot> slot;
               given.read("slot", slot);
               return slot ? swept(maneuver, *slot) : swept(maneuver);
           });
    define(
        module, "frame(car, poses)",
        "Corners of the car frame [m], counter-clockwise: front-left, rear-left, rear-right, front-right. For a Pose\n"
        "an array of four rows (x, y); for an array of poses (..., 3) one of corners (..., 4, 2).",
        [](const Arguments& given) {
            const auto car = given.get<Car>("car");
            const auto object = given.get<py::object>("poses");
            const bool one = py::isinstance<Pose>(object);
            const Numbers poses = as_numbers(
                one ? py::object(py::make_tuple(object.attr("x"), object.attr("y"), object.attr("heading"))) : object,
                "poses");
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
