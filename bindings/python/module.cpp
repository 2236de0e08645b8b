// The Python module snug._snug: the names and concepts of the C++ library.
#include "module.hpp"

#include "snug/error.hpp"
#include "snug/version.hpp"

PYBIND11_MODULE(_snug, module) {
    namespace py = pybind11;
    py::options options;
    options.disable_function_signatures();  // docstrings begin with their own
    module.doc() = "The compiled part of snug.";
    module.attr("__version__") = SNUG_VERSION;
    py::register_exception<snug::Error>(module, "Error", PyExc_ValueError).doc() =
        "An impossible car, slot or option; the message says what would be right.";
    snug::python::define_values(module);
    snug::python::define_questions(module);
    snug::python::define_arrays(module);
    snug::python::define_parking(module);
    snug::python::define_driving(module);
    snug::python::define_atlas(module);
}
