// The module pardel._pardel: the library for the Python package, which no other code should import.
#include <pybind11/pybind11.h>

#include "bind.hpp"
#include "errors.hpp"

PYBIND11_MODULE(_pardel, module) {
  using namespace pardel::python;
  bind_errors();
  bind_domain(module);
  bind_shapes(module);
  bind_sizes(module);
  bind_goal(module);
  bind_mesh(module);
  bind_mesher(module);
  bind_checker(module);
  bind_files(module);
  bind_locate(module);
  bind_state(module);
  bind_parts(module);
  bind_voronoi(module);
  bind_domains(module);
#ifdef PARDEL_HAS_PICTURES
  bind_pictures(module);
#endif
  module.attr("version") = PARDEL_VERSION;
}
