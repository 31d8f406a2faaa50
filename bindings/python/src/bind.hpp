// The parts of the module pardel._pardel. Python's side (pardel/*.py) checks arguments and documents everything.
#pragma once

#include <pybind11/pybind11.h>

namespace pardel::python {

void bind_domain(pybind11::module_& module);
void bind_goal(pybind11::module_& module);
void bind_mesh(pybind11::module_& module);
void bind_mesher(pybind11::module_& module);
void bind_checker(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_locate(pybind11::module_& module);
void bind_state(pybind11::module_& module);
void bind_parts(pybind11::module_& module);
void bind_voronoi(pybind11::module_& module);
void bind_shapes(pybind11::module_& module);
void bind_domains(pybind11::module_& module);
void bind_sizes(pybind11::module_& module);
/// Only if the headers of cairo are there.
void bind_pictures(pybind11::module_& module);

}  // namespace pardel::python
