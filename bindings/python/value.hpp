// The classes of the module: immutable values, each told once by its fields.
#pragma once

#include <functional>

#include "answers.hpp"
#include "arguments.hpp"

namespace snug::python {

/// What Python sees of a field: words for enumerations, tuples for lists.
template <class T>
py::object shown(const T& value) {
    if constexpr (IsOptional<T>::value) {
        return value ? shown(*value) : py::none();
    } else if constexpr (IsVector<T>::value) {
        py::list all;
        for (const auto& one : value) all.append(shown(one));
        return py::tuple(all);
    } else if constexpr (is_pair<T>) {
        return py::make_tuple(value.first, value.second);
    } else if constexpr (std::is_enum_v<T>) {
        return py::str(std::string(word(value)));
    } else if constexpr (std::is_base_of_v<py::handle, T>) {
        return value;
    } else if constexpr (std::is_same_v<T, AnyPlace>) {
        return std::visit([](const auto& place) { return py::object(py::cast(place)); }, value);
    } else if constexpr (std::is_same_v<T, std::string_view>) {
        return py::str(std::string(value));
    } else {
        return py::cast(value);
    }
}

/// Its type, as help() and type checkers read it.
template <class T>
std::string type_name() {
    if constexpr (IsOptional<T>::value) {
        return type_name<typename T::value_type>() + " | None";
    } else if constexpr (IsVector<T>::value) {
        return "tuple[" + type_name<typename T::value_type>() + ", ...]";
    } else if constexpr (is_pair<T>) {
        return "tuple[float, float]";
    } else if constexpr (std::is_enum_v<T>) {
        return literal<T>();
    } else if constexpr (std::is_same_v<T, AnyPlace>) {
        return "Street | Scene";
    } else if constexpr (std::is_same_v<T, bool>) {
        return "bool";
    } else if constexpr (std::is_integral_v<T>) {
        return "int";
    } else if constexpr (std::is_floating_point_v<T>) {
        return "float";
    } else if constexpr (std::is_convertible_v<T, std::string_view>) {
        return "str";
    } else if constexpr (std::is_base_of_v<py::handle, T>) {
        return "Any";
    } else {
        return py::str(py::type::of<T>().attr("__name__"));
    }
}

/// "Slot(length=4.5, width=2.0)", without what is as usual.
std::string spelled_value(const py::object& self, const py::tuple& fields, const Signature* constructor);
/// An object with a key for every field.
std::string json_of_fields(const py::object& self, const py::tuple& fields);
/// A row for every field, as HTML.
std::string table_of_fields(const py::object& self, const py::tuple& fields);
py::object read_json(const std::string& text);

/// A class of immutable values: equal, hashed, printed, converted and pickled by their fields.
template <class T>
class Value : public py::class_<T> {
public:
    using type = T;
    Value(py::module_& module, const char* name, const std::string& documentation)
        : py::class_<T>(module, name, documentation.c_str(), py::is_final(),
                        py::metaclass(reinterpret_cast<PyObject*>(&PyType_Type))) {}

    /// `get` is a member, or takes the value. Where it leads to the value's own (a reference that is not const), the field can
    /// be set when a pickle is read. The type need not be said where C++ knows it.
    template <class Get>
    Value& field(const char* name, Get get, const std::string& documentation, const std::string& of_type = "") {
        fields_.append(name);
        using Got = std::invoke_result_t<Get, T&>;
        if constexpr (std::is_lvalue_reference_v<Got> && !std::is_const_v<std::remove_reference_t<Got>>)
            setters_.push_back([get, name](T& made, py::handle value) {
                std::invoke(get, made) = as<std::remove_cvref_t<Got>>(value, name);
            });
        return property(name, get, documentation, of_type);
    }
    /// Follows from the fields.
    template <class Get>
    Value& property(const char* name, Get get, const std::string& documentation, const std::string& of_type = "") {
        using Got = std::remove_cvref_t<std::invoke_result_t<Get, const T&>>;
        const std::string of = of_type.empty() ? type_name<Got>() : of_type;
        this->def_property_readonly(
            name, [get](const T& self) { return shown<Got>(std::invoke(get, self)); },
            (of + ": " + documentation).c_str());
        return *this;
    }
    /// With a constructor: `body` takes the arguments; the signature is the class's.
    template <class Body>
    Value& constructor(const Signature& signature, Body body) {
        constructor_ = std::make_shared<const Signature>(signature);
        this->def(py::init([signature, body](const py::args& args, const py::kwargs& kwargs) {
                      return body(Arguments(signature, args, kwargs));
                  }),
                  signature.constructor_docstring().c_str());
        return *this;
    }
    /// How a notebook shows it: an SVG, or nothing.
    template <class Draw>
    Value& picture(Draw draw) {
        this->def("_repr_svg_", draw, "How a notebook shows it.");
        return *this;
    }
    /// The same for what has nothing to draw: its fields as a table.
    Value& table() {
        this->def(
            "_repr_html_",
            [fields = py::tuple(fields_)](const py::object& self) { return table_of_fields(self, fields); },
            "How a notebook shows it.");
        return *this;
    }
    /// In a few words, where the fields say too much.
    template <class Say>
    Value& said(Say say) {
        has_repr_ = true;
        this->def("__repr__", [say](const T& self) { return "<" + std::string(say(self)) + ">"; });
        return *this;
    }
    /// Once all fields are there.
    Value& finish() {
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
        if (!has_repr_)
            this->def("__repr__", [fields, constructor = constructor_](const py::object& self) {
                return spelled_value(self, fields, constructor.get());
            });
        convert(fields);
        pickle(fields, values);
        return *this;
    }

private:
    void convert(const py::tuple& fields) {
        const auto text = [fields](const py::object& self) {
            if constexpr (requires(const T& value) { json_text(value); }) {
                return json_text(self.cast<const T&>());
            } else {
                return json_of_fields(self, fields);
            }
        };
        this->def("to_json", text,
                  Signature("to_json(self) -> str").docstring("As JSON text, as the command writes it.").c_str());
        this->def(
            "to_dict", [text](const py::object& self) { return read_json(text(self)); },
            Signature("to_dict(self) -> dict[str, Any]").docstring("What to_json() says, as a dictionary.").c_str());
    }
    template <class Values>
    void pickle(const py::tuple& fields, const Values& values) {
        if (constructor_) {
            this->def("__reduce__", [fields](const py::object& self) {
                py::dict named;
                for (const py::handle name : fields) named[name] = self.attr(name);
                const py::object partial = py::module_::import("functools").attr("partial");
                return py::make_tuple(partial(py::type::of(self), **named), py::tuple());
            });
        } else if constexpr (std::is_default_constructible_v<T>) {
            if (setters_.size() != fields.size()) throw std::logic_error("a field that cannot be set");
            this->def(py::pickle(values, [setters = setters_](const py::tuple& state) {
                T made;
                for (std::size_t i = 0; i < setters.size(); ++i) setters[i](made, state[i]);
                return made;
            }));
        }
    }

    py::list fields_;
    std::vector<std::function<void(T&, py::handle)>> setters_;
    std::shared_ptr<const Signature> constructor_;
    bool has_repr_ = false;
};

}  // namespace snug::python
