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

template <class Enumeration>
std::string_view word(Enumeration value) {
    for (const auto& [spelled, meant] : words<Enumeration>())
        if (meant == value) return spelled;
    throw std::logic_error("a value without a word");
}

/// Throws TypeError: "slot must be a snug.Slot, not str".
[[noreturn]] void complain(const std::string& name, const std::string& wanted, py::handle given);

double as_number(py::handle value, const std::string& name);
int as_count(py::handle value, const std::string& name);
std::string as_text(py::handle value, const std::string& name);
Point as_point(py::handle value, const std::string& name);
Pose as_pose(py::handle value, const std::string& name);
MaybeBaseline as_baseline(py::handle value, const std::string& name);

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
T as(py::handle value, const std::string& name) {
    if constexpr (std::is_same_v<T, MaybeBaseline>) {
        return as_baseline(value, name);
    } else if constexpr (IsOptional<T>::value) {
        if (value.is_none()) return std::nullopt;
        return as<typename T::value_type>(value, name);
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

/// The parameters of a function, read from what help() shows: "entry(car, slot, *, clearance=0.0)".
class Signature {
public:
    explicit Signature(std::string text);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const std::string& function() const { return function_; }
    /// Every parameter with its value or null, in their order. Throws TypeError as Python does.
    [[nodiscard]] std::vector<py::handle> bind(const py::args& args, const py::kwargs& kwargs) const;
    [[nodiscard]] std::size_t index(std::string_view name) const;
    /// As the docstring begins, so that inspect.signature() can read it.
    [[nodiscard]] std::string docstring(const std::string& documentation) const;
    /// The same of a class's __init__.
    [[nodiscard]] std::string constructor_docstring() const;

private:
    struct Parameter {
        std::string name;
        bool required = true;
    };
    std::string text_;
    std::string function_;
    std::vector<Parameter> parameters_;
    std::size_t positional_ = 0;
};

/// The parameters that questions share, and where Arguments reads them.
inline const std::string driving_parameters = "clearance=0.0, curb_clearance=None, enter='backward'";
inline const std::string parked_parameters = "parked_heading=None, parked_curb=None";
inline const std::string neighbour_parameters = "front_setback=0.0, rear_setback=0.0, curb='high'";
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
    "min_range=0.0, " + conditions + ", " + neighbour_parameters +
    ", longest=4.0, widest=4.0, precision=0.001, resolution=0.0, prove=False, progress=None)";
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

/// A class of immutable values: equal, hashed and printed by their fields.
template <class T>
class Value : public py::class_<T> {
public:
    using type = T;
    Value(py::module_& module, const char* name, const std::string& documentation)
        : py::class_<T>(module, name, documentation.c_str(), py::is_final(),
                        py::metaclass(reinterpret_cast<PyObject*>(&PyType_Type))) {}

    template <class Get>
    Value& field(const char* name, Get get, const char* documentation) {
        fields_.append(name);
        return property(name, get, documentation);
    }
    /// Follows from the fields.
    template <class Get>
    Value& property(const char* name, Get get, const char* documentation) {
        this->def_property_readonly(name, get, documentation);
        return *this;
    }
    /// Once all fields are there.
    Value& finish(bool short_repr = false) {
        const py::tuple fields(fields_);
        const auto values = [fields](const py::object& self) {
            py::list all;
            for (const py::handle name : fields) all.append(self.attr(name));
            return py::tuple(all);
        };
        this->attr("__match_args__") = fields;
        this->def("__eq__", [values](const py::object& self, const py::object& other) -> py::object {
            if (!py::isinstance<T>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(values(self).equal(values(other)));
        });
        this->def("__hash__", [values](const py::object& self) { return py::hash(values(self)); });
        this->def("__copy__", [](const py::object& self) { return self; });
        this->def("__deepcopy__", [](const py::object& self, const py::dict&) { return self; });
        if (short_repr) return *this;
        this->def("__repr__", [fields](const py::object& self) {
            std::string text = py::str(py::type::of(self).attr("__name__"));
            const char* separator = "";
            text.append("(");
            for (const py::handle name : fields) {
                text.append(separator).append(py::str(name)).append("=").append(py::repr(self.attr(name)));
                separator = ", ";
            }
            return text + ")";
        });
        return *this;
    }
    /// With a constructor: `body` takes the arguments; the signature is the class's. Values can be copied and pickled.
    template <class Body>
    Value& constructor(const Signature& signature, Body body) {
        this->def(py::init([signature, body](const py::args& args, const py::kwargs& kwargs) {
                      return body(Arguments(signature, args, kwargs));
                  }),
                  signature.constructor_docstring().c_str());
        const py::tuple fields(fields_);
        this->def("__reduce__", [fields](const py::object& self) {
            py::dict named;
            for (const py::handle name : fields) named[name] = self.attr(name);
            const py::object partial = py::module_::import("functools").attr("partial");
            return py::make_tuple(partial(py::type::of(self), **named), py::tuple());
        });
        return *this;
    }

private:
    py::list fields_;
};

}  // namespace snug::python
