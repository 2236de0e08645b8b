// The parts of the module, in the order they are defined.
#pragma once

#include <pybind11/pybind11.h>

namespace snug::python {

void define_values(pybind11::module_& module);
void define_questions(pybind11::module_& module);
void define_arrays(pybind11::module_& module);
void define_parking(pybind11::module_& module);
void define_driving(pybind11::module_& module);
void define_atlas(pybind11::module_& module);

}  // namespace snug::python
