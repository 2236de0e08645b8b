// What a Python caller passed: read by name, so that every complaint says which argument is meant.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "answers.hpp"
#include "snug/snug.hpp"

namespace snug::python {

namespace py = pybind11;

/// Full steering, where a baseline could be named.
struct MaxSteer {};
/// None: the solver.
using MaybeBaseline = std::optional<Baseline>;

/// The words Python says for the values of an enumeration.
template <class Enumeration>
std::vector<std::pair<std::string_view, Enumeration>> words();
template <>
std::vector<std::pair<std::string_view, Side>> words();
template <>
std::vector<std::pair<std::string_view, Curb>> words();
template <>
std::vector<std::pair<std::string_view, Direction>> words();
template <>
std::vector<std::pair<std::string_view, Enter>> words();
template <>
std::vector<std::pair<std::string_view, StopRule>> words();
template <>
std::vector<std::pair<std::string_view, Strategy>> words();
template <>
std::vector<std::pair<std::string_view, Outcome>> words();
template <>
std::vector<std::pair<std::string_view, CarPart>> words();
template <>
std::vector<std::pair<std::string_view, Obstacle>> words();

template <>
std::vector<std::pair<std::string_view, MapBounds::Where>> words();
template <>
std::vector<std::pair<std::string_view, Sought>> words();
template <>
std::vector<std::pair<std::string_view, Steer>> words();
template <>
std::vector<std::pair<std::string_view, StreetSize>> words();

template <class Enumeration>
std::string_view word(Enumeration value) {
    for (const auto& [spelled, meant] : words<Enumeration>())
        if (meant == value) return spelled;
    throw std::logic_error("a value without a word");
}

/// The type of these words: "Literal['backward', 'forward']".
template <class Enumeration>
std::string literal() {
    std::string text;
    for (const auto& [spelled, meant] : words<Enumeration>())
        text.append(text.empty() ? "Literal['" : ", '").append(spelled).append("'");
    return text + "]";
}

/// Throws TypeError: "slot must be a snug.Slot, not str".
[[noreturn]] void complain(const std::string& name, const std::string& wanted, py::handle given);

double as_number(py::handle value, const std::string& name);
int as_count(py::handle value, const std::string& name);
std::string as_text(py::handle value, const std::string& name);
Point as_point(py::handle value, const std::string& name);
Pose as_pose(py::handle value, const std::string& name);
AnyPlace as_place(py::handle value, const std::string& name);
MaybeBaseline as_baseline(py::handle value, const std::string& name);

/// The JSON text of a dictionary.
std::string as_json_text(py::handle value, const std::string& name);
/// "18 direction changes"
std::string counted(int count, const std::string& what);
/// "4.5", as Python prints a number that is not longer than it need be.
std::string few_digits(double number);
/// What is wrong with a described car, about an argument.
Error as_complaint(const std::string& key, const std::string& what);

/// An array of numbers (or of whole numbers) from anything NumPy makes one of; the original is left alone.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Counts = py::array_t<int, py::array::c_style | py::array::forcecast>;
Numbers as_numbers(py::handle value, const std::string& name);
Counts as_counts(py::handle value, const std::string& name);

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};

/// In Python a tuple of its two numbers.
template <class T>
constexpr bool is_pair = std::is_same_v<T, Headings> || std::is_same_v<T, Sizes>;

template <class T>
T as(py::handle value, const std::string& name) {
    if constexpr (std::is_same_v<T, MaybeBaseline>) {
        return as_baseline(value, name);
    } else if constexpr (IsOptional<T>::value) {
        if (value.is_none()) return std::nullopt;
        return as<typename T::value_type>(value, name);
    } else if constexpr (IsVector<T>::value) {
        if (!py::isinstance<py::iterable>(value)) complain(name, "a sequence", value);
        T all;
        for (const py::handle one : value)
            all.push_back(as<typename T::value_type>(one, name + "[" + std::to_string(all.size()) + "]"));
        return all;
    } else if constexpr (is_pair<T>) {
        const Point ends = as_point(value, name);
        return {ends.x, ends.y};
    } else if constexpr (std::is_same_v<T, std::size_t>) {
        return static_cast<std::size_t>(as_count(value, name));
    } else if constexpr (std::is_same_v<T, bool>) {
        if (!PyBool_Check(value.ptr())) complain(name, "True or False", value);
        return value.ptr() == Py_True;
    } else if constexpr (std::is_same_v<T, double>) {
        return as_number(value, name);
    } else if constexpr (std::is_same_v<T, int>) {
        return as_count(value, name);
    } else if constexpr (std::is_same_v<T, std::string>) {
        return as_text(value, name);
    } else if constexpr (std::is_same_v<T, Point>) {
        return as_point(value, name);
    } else if constexpr (std::is_same_v<T, Pose>) {
        return as_pose(value, name);
    } else if constexpr (std::is_same_v<T, AnyPlace>) {
        return as_place(value, name);
    } else if constexpr (std::is_same_v<T, Numbers>) {
        return as_numbers(value, name);
    } else if constexpr (std::is_same_v<T, Counts>) {
        return as_counts(value, name);
    } else if constexpr (std::is_same_v<T, py::object>) {
        return py::reinterpret_borrow<py::object>(value);
    } else if constexpr (std::is_enum_v<T>) {
        std::string choice;
        const std::string text = as_text(value, name);
        for (const auto& [spelled, meant] : words<T>()) {
            if (text == spelled) return meant;
            choice.append(choice.empty() ? "'" : ", '").append(spelled).append("'");
        }
        throw Error(name + " is " + std::string(py::repr(value)) + ", but must be one of " + choice);
    } else {
        if (!py::isinstance<T>(value))
            complain(name, "a snug." + std::string(py::str(py::type::of<T>().attr("__name__"))), value);
        return value.cast<T>();
    }
}

/// The parameters of a function, read from what help() and type checkers are shown:
/// "entry(car: Car, slot: Slot, *, clearance: float = 0.0) -> Answer". There may be a line for each of several types.
class Signature {
public:
    explicit Signature(std::string text);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::string& function() const { return function_; }
    /// Every parameter with its value or null, in their order. Throws TypeError as Python does.
    [[nodiscard]] std::vector<py::handle> bind(const py::args& args, const py::kwargs& kwargs) const;
    [[nodiscard]] std::size_t index(std::string_view name) const;
    /// What the parameter is unless given, as it is written; empty where it has to be given.
    [[nodiscard]] std::string default_of(std::string_view name) const;
    /// Begins without types, so that inspect.signature() can read it, and goes on with them.
    [[nodiscard]] std::string docstring(const std::string& documentation) const;
    /// The same of a class's __init__.
    [[nodiscard]] std::string constructor_docstring() const;

private:
    struct Parameter {
        std::string name;
        std::string value;  // unless given; empty where it has to be
    };
    std::string text_;
    std::string function_;
    std::string untyped_;  // "(car, slot, *, clearance=0.0)"
    std::vector<Parameter> parameters_;
    std::size_t positional_ = 0;
};

/// The parameters that questions share, and where Arguments reads them.
inline const std::string clearance_parameters = "clearance: float = 0.0, curb_clearance: float | None = None";
inline const std::string driving_parameters = clearance_parameters + ", enter: " + literal<Enter>() + " = 'backward'";
inline const std::string parked_parameters = "parked_heading: float | None = None, parked_curb: float | None = None";
inline const std::string neighbour_parameters =
    "front_setback: float = 0.0, rear_setback: float = 0.0, curb: " + literal<Curb>() + " = 'high'";
/// What several parameters may be.
inline const std::string point_type = "Point | tuple[float, float]";
inline const std::string pose_type = "Pose | tuple[float, float, float]";
inline const std::string path_type = "str | PathLike[str]";
inline const std::string baseline_parameter =
    "strategy: MaxSteer | Stepping | ReversedTrials | ParallelTrials | None = None";
inline const std::string progress_parameter = "progress: Callable[[float], Any] | None = None";
inline const std::string search_progress_parameter = "progress: Callable[[FewestProgress], Any] | None = None";
inline const std::string conditions = driving_parameters + ", " + parked_parameters;
/// What they mean.
inline const std::string conditions_meaning =
    "`clearance` grows the frame for contacts and for the entry position [m], at the curb `curb_clearance` in its "
    "place;\n"
    "`enter` is 'backward', tail first, or 'forward'. Parked is the whole frame inside the slot and, where they are\n"
    "given, at most `parked_heading` off parallel [rad] and its nearest point at most `parked_curb` from the curb "
    "[m].\n";
inline const std::string neighbours_meaning =
    "The neighbours begin `front_setback` and `rear_setback` deeper than the road's edge [m]; a 'low' `curb` stops "
    "the\n"
    "wheels only, 'high' the whole car.\n";

/// Of min_slot() and min_slots(), which read them alike.
inline const std::string min_slot_parameters =
    "min_range: float = 0.0, " + conditions + ", " + neighbour_parameters +
    ", longest: float = 4.0, widest: float = 4.0, precision: float = 0.001, resolution: float = 0.0, "
    "prove: bool = False, " +
    progress_parameter + ")";
inline const std::string min_slot_meaning =
    "With 'max-steer', full steering, the slot is the smallest for which headings over a range at least `min_range` "
    "wide\n"
    "[rad] park; with 'fewest', over all maneuvers, two sizes are proved, `precision` apart [m] as far as the "
    "`resolution`\n"
    "of the lattice lets them [m], 0 a two-thousandth of the car's length. `longest` and `widest` are how much more "
    "than\n"
    "what holds the car is looked at [m]. With `prove`, full steering shows that no smaller size parks, or says which "
    "it "
    "leaves open.\n";

/// One call's arguments.
class Arguments {
public:
    Arguments(const Signature& signature, const py::args& args, const py::kwargs& kwargs)
        : signature_(signature), values_(signature.bind(args, kwargs)) {}

    template <class T>
    [[nodiscard]] T get(const std::string& name) const {
        return as<T>(values_[signature_.index(name)], name);
    }
    /// Leaves `value`, the default of the C++ options, where nothing was passed.
    template <class T>
    void read(const std::string& name, T& value) const {
        const py::handle given = values_[signature_.index(name)];
        if (given) value = as<T>(given, name);
    }
    [[nodiscard]] bool has(const std::string& name) const { return static_cast<bool>(values_[signature_.index(name)]); }
    /// The conditions: how the car is driven, and what counts as parked.
    void read_driving(Driving& driving) const {
        read("clearance", driving.clearance);
        read("curb_clearance", driving.curb_clearance);
        read("enter", driving.enter);
    }
    template <class Options>
    void read_conditions(Options& options) const {
        read_driving(options.driving);
        std::optional<double> limit;
        read("parked_heading", limit);
        if (limit) options.parked.heading = *limit;
        limit.reset();
        read("parked_curb", limit);
        if (limit) options.parked.curb = *limit;
    }
    /// Of a SlotDimensions or a MinSlotOptions.
    template <class Beside>
    void read_neighbours(Beside& beside) const {
        read("front_setback", beside.front_setback);
        read("rear_setback", beside.rear_setback);
        read("curb", beside.curb);
    }
    /// `strategy`: what answers in the place of the solver.
    [[nodiscard]] MaybeBaseline baseline() const {
        const py::handle given = values_[signature_.index("strategy")];
        return given ? as_baseline(given, "strategy") : std::nullopt;
    }
    /// A callable or None.
    [[nodiscard]] py::object callback(const std::string& name) const;

private:
    const Signature& signature_;
    std::vector<py::handle> values_;
};

inline MinSlotOptions min_slot_options(const Arguments& given) {
    MinSlotOptions options;
    given.read("min_range", options.min_range);
    given.read("prove", options.prove);
    given.read_conditions(options);
    given.read_neighbours(options);
    given.read("longest", options.longest);
    given.read("widest", options.widest);
    given.read("precision", options.precision);
    given.read("resolution", options.resolution);
    return options;
}

/// A function of the module: `body` takes the arguments.
template <class Body>
void define(py::module_& module, const std::string& signature, const std::string& documentation, Body body) {
    const auto read = std::make_shared<const Signature>(signature);
    module.def(
        read->function().c_str(),
        [read, body](const py::args& args, const py::kwargs& kwargs) { return body(Arguments(*read, args, kwargs)); },
        read->docstring(documentation).c_str());
}

/// A static method.
template <class Class, class Body>
void define_static(Class& type, const std::string& signature, const std::string& documentation, Body body) {
    const auto read = std::make_shared<const Signature>(signature);
    type.def_static(
        read->function().c_str(),
        [read, body](const py::args& args, const py::kwargs& kwargs) { return body(Arguments(*read, args, kwargs)); },
        read->docstring(documentation).c_str());
}

/// A method: `body` takes the object and the arguments. The signature begins with "self".
template <class Class, class Body>
void define_method(Class& type, const std::string& signature, const std::string& documentation, Body body) {
    const auto read = std::make_shared<const Signature>(signature);
    type.def(
        read->function().c_str(),
        [read, body](const typename Class::type& self, const py::args& args, const py::kwargs& kwargs) {
            return body(self, Arguments(*read, args, kwargs));
        },
        read->docstring(documentation).c_str());
}

}  // namespace snug::python
