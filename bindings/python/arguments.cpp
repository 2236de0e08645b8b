#include "arguments.hpp"

#include <algorithm>
#include <initializer_list>
#include <limits>

namespace snug::python {

namespace {

/// Each with the word the library has for it.
template <class Enumeration>
std::vector<std::pair<std::string_view, Enumeration>> spelled(std::initializer_list<Enumeration> values) {
    std::vector<std::pair<std::string_view, Enumeration>> all;
    for (const Enumeration value : values) all.emplace_back(to_string(value), value);
    return all;
}

}  // namespace

template <>
std::vector<std::pair<std::string_view, Side>> words() {
    return spelled<Side>({Side::right, Side::left});
}
template <>
std::vector<std::pair<std::string_view, Curb>> words() {
    return spelled<Curb>({Curb::high, Curb::low});
}
template <>
std::vector<std::pair<std::string_view, Direction>> words() {
    return spelled<Direction>({Direction::backward, Direction::forward});
}
template <>
std::vector<std::pair<std::string_view, Enter>> words() {
    return spelled<Enter>({Enter::backward, Enter::forward});
}
template <>
std::vector<std::pair<std::string_view, StopRule>> words() {
    return spelled<StopRule>({StopRule::inside, StopRule::contact});
}
template <>
std::vector<std::pair<std::string_view, Steer>> words() {
    return {{"standing", Steer::standing}, {"moving", Steer::moving}};
}
template <>
std::vector<std::pair<std::string_view, Strategy>> words() {
    return spelled<Strategy>({Strategy::max_steer, Strategy::fewest});
}
template <>
std::vector<std::pair<std::string_view, Outcome>> words() {
    return {{"parked", Outcome::parked},
            {"no_entry", Outcome::no_entry},
            {"stuck", Outcome::stuck},
            {"never_touches", Outcome::never_touches},
            {"too_many_changes", Outcome::too_many_changes}};
}
template <>
std::vector<std::pair<std::string_view, CarPart>> words() {
    std::vector<std::pair<std::string_view, CarPart>> all;
    for (int i = 0; i <= static_cast<int>(CarPart::front_right_wheel); ++i)
        all.emplace_back(to_string(static_cast<CarPart>(i)), static_cast<CarPart>(i));
    return all;
}
template <>
std::vector<std::pair<std::string_view, Obstacle>> words() {
    std::vector<std::pair<std::string_view, Obstacle>> all;
    for (int i = 0; i <= static_cast<int>(Obstacle::rear_corner); ++i)
        all.emplace_back(to_string(static_cast<Obstacle>(i)), static_cast<Obstacle>(i));
    return all;
}

template <>
std::vector<std::pair<std::string_view, MapBounds::Where>> words() {
    return {{"free", MapBounds::free}, {"blocked", MapBounds::blocked}, {"outside", MapBounds::outside}};
}
template <>
std::vector<std::pair<std::string_view, Sought>> words() {
    return spelled<Sought>({Sought::length, Sought::width});
}
template <>
std::vector<std::pair<std::string_view, StreetSize>> words() {
    return spelled<StreetSize>({StreetSize::road, StreetSize::width, StreetSize::length});
}

void complain(const std::string& name, const std::string& wanted, py::handle given) {
    throw py::type_error(name + " must be " + wanted + ", not " + Py_TYPE(given.ptr())->tp_name);
}

double as_number(py::handle value, const std::string& name) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (number != -1.0 || PyErr_Occurred() == nullptr) return number;
    const bool too_large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
    PyErr_Clear();
    if (too_large) throw Error(name + " is too large for a number");
    complain(name, "a number", value);
}

int as_count(py::handle value, const std::string& name) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!whole) {
        PyErr_Clear();
        complain(name, "a whole number", value);
    }
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(whole.ptr(), &overflow);
    if (overflow != 0 || number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
        throw Error(name + " is too large for a count");
    return static_cast<int>(number);
}

std::string as_text(py::handle value, const std::string& name) {
    if (!PyUnicode_Check(value.ptr())) complain(name, "a str", value);
    return value.cast<std::string>();
}

namespace {

/// The numbers of a tuple, list or array of that many.
std::vector<double> as_few(py::handle value, std::size_t many, const std::string& name, const std::string& wanted) {
    if (PyUnicode_Check(value.ptr()) || !PySequence_Check(value.ptr())) complain(name, wanted, value);
    std::vector<double> numbers;
    for (const py::handle one : value)
        numbers.push_back(as_number(one, name + "[" + std::to_string(numbers.size()) + "]"));
    if (numbers.size() != many)
        throw py::type_error(name + " must be " + wanted + ", not " + std::to_string(numbers.size()) + " numbers");
    return numbers;
}

/// An array of a dtype of one of the kinds; empty ones of any kind are welcome.
py::array as_array(py::handle value, const std::string& name, std::string_view kinds, const std::string& wanted) {
    py::array array;
    try {
        array = py::module_::import("numpy").attr("asarray")(value);
    } catch (const py::error_already_set& error) {
        if (!error.matches(PyExc_ValueError) && !error.matches(PyExc_TypeError)) throw;
        throw py::type_error(name + " must be " + wanted + ": " + std::string(py::str(error.value())));
    }
    if (array.size() > 0 && kinds.find(array.dtype().kind()) == std::string_view::npos)
        throw py::type_error(name + " must be " + wanted + ", not of dtype " + std::string(py::str(array.dtype())));
    return array;
}

}  // namespace

Point as_point(py::handle value, const std::string& name) {
    if (py::isinstance<Point>(value)) return value.cast<Point>();
    const auto n = as_few(value, 2, name, "a snug.Point or (x, y)");
    return {n[0], n[1]};
}

Pose as_pose(py::handle value, const std::string& name) {
    if (py::isinstance<Pose>(value)) return value.cast<Pose>();
    const auto n = as_few(value, 3, name, "a snug.Pose or (x, y, heading)");
    return {n[0], n[1], n[2]};
}

AnyPlace as_place(py::handle value, const std::string& name) {
    if (py::isinstance<Street>(value)) return value.cast<Street>();
    if (py::isinstance<Scene>(value)) return value.cast<Scene>();
    complain(name, "a snug.Street or a snug.Scene", value);
}

MaybeBaseline as_baseline(py::handle value, const std::string& name) {
    if (value.is_none() || py::isinstance<MaxSteer>(value)) return std::nullopt;
    if (py::isinstance<Stepping>(value)) return value.cast<Stepping>();
    if (py::isinstance<ReversedTrials>(value)) return value.cast<ReversedTrials>();
    if (py::isinstance<ParallelTrials>(value)) return value.cast<ParallelTrials>();
    complain(name, "a snug.MaxSteer, Stepping, ReversedTrials or ParallelTrials", value);
}

std::string as_json_text(py::handle value, const std::string& name) {
    if (!py::isinstance<py::dict>(value)) complain(name, "a dict", value);
    return py::str(py::module_::import("json").attr("dumps")(value));
}

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string few_digits(double number) { return py::str(py::float_(std::round(number * 1e5) / 1e5)); }

Error as_complaint(const std::string& key, const std::string& what) {
    return Error(key.empty() ? "car " + what : key + " " + what);
}

Numbers as_numbers(py::handle value, const std::string& name) {
    return Numbers(as_array(value, name, "fiu", "an array of numbers"));
}

Counts as_counts(py::handle value, const std::string& name) {
    const py::array array = as_array(value, name, "iu", "an array of whole numbers");
    if (array.size() == 0) return Counts(array);
    const auto limits = py::make_tuple(array.attr("min")(), array.attr("max")());
    for (const py::handle limit : limits) as_count(limit, "the largest of " + name);
    return Counts(array);
}

Signature::Signature(std::string text) : text_(std::move(text)) {
    const std::size_t open = text_.find('(');
    function_ = text_.substr(0, open);
    bool keyword_only = false;
    std::size_t from = open + 1;
    int depth = 0;
    const auto trimmed = [](std::string_view part) {
        while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
        while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
        return std::string(part);
    };
    for (std::size_t i = from; depth >= 0 && i < text_.size(); ++i) {
        const char at = text_[i];
        if (at == '(' || at == '[') ++depth;
        if (at == ')' || at == ']') --depth;
        if (depth >= 0 && !(depth == 0 && at == ',')) continue;
        const std::string one = trimmed(std::string_view(text_).substr(from, i - from));
        from = i + 1;
        if (one.empty()) continue;
        const std::size_t equals = one.find('=');
        const std::string name = trimmed(one.substr(0, std::min(one.find(':'), equals)));
        const std::string value = equals == std::string::npos ? "" : trimmed(one.substr(equals + 1));
        untyped_ += untyped_.empty() ? "(" : ", ";
        untyped_.append(name).append(value.empty() ? "" : "=").append(value);
        if (name == "*") keyword_only = true;
        if (name == "*" || name == "/" || name == "self") continue;
        parameters_.push_back({name, value});
        if (!keyword_only) ++positional_;
    }
    untyped_ += untyped_.empty() ? "()" : ")";
}

std::string Signature::default_of(std::string_view name) const { return parameters_[index(name)].value; }

std::size_t Signature::index(std::string_view name) const {
    const auto at = std::find_if(parameters_.begin(), parameters_.end(),
                                 [name](const Parameter& parameter) { return parameter.name == name; });
    if (at == parameters_.end()) throw std::logic_error(text_ + " has no " + std::string(name));
    return static_cast<std::size_t>(at - parameters_.begin());
}

std::vector<py::handle> Signature::bind(const py::args& args, const py::kwargs& kwargs) const {
    std::vector<py::handle> values(parameters_.size());
    if (args.size() > positional_)
        throw py::type_error(function_ + "() takes " + std::to_string(positional_) + " positional arguments, but " +
                             std::to_string(args.size()) + " were given");
    for (std::size_t i = 0; i < args.size(); ++i) values[i] = args[i];
    for (const auto& [key, value] : kwargs) {
        const std::string name = py::str(key);
        std::size_t i = 0;
        while (i < parameters_.size() && parameters_[i].name != name) ++i;
        if (i == parameters_.size())
            throw py::type_error(function_ + "() has no argument '" + name + "': " + function_ + untyped_);
        if (values[i]) throw py::type_error(function_ + "() got '" + name + "' twice");
        values[i] = value;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (parameters_[i].value.empty() && !values[i])
            throw py::type_error(function_ + "() lacks the argument '" + parameters_[i].name + "': " + function_ +
                                 untyped_);
    return values;
}

std::string Signature::docstring(const std::string& documentation) const {
    return function_ + untyped_ + "\n--\n\n" + text_ + "\n\n" + documentation;
}

std::string Signature::constructor_docstring() const {
    const auto with_self = [](const std::string& parameters) {
        return "__init__(self" + std::string(parameters == "()" ? "" : ", ") + parameters.substr(1);
    };
    return with_self(untyped_) + "\n--\n\n" + with_self(text_.substr(function_.size())) +
           " -> None\n\nSee help(type(self)).";
}

py::object Arguments::callback(const std::string& name) const {
    const py::handle given = values_[signature_.index(name)];
    if (!given || given.is_none()) return py::none();
    if (PyCallable_Check(given.ptr()) == 0) complain(name, "a callable", given);
    return py::reinterpret_borrow<py::object>(given);
}

}  // namespace snug::python
