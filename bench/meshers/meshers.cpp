#include "meshers.hpp"

#include "../../off_the_shelf/own_mesher.hpp"
#include "cgal_mesh_2.hpp"
#include "gmsh_library.hpp"
#include "triangle_library.hpp"

namespace pardel::bench {

const std::vector<NamedMesher>& meshers() {
  static const std::vector<NamedMesher> all{
      {"own", own_mesher},
      {"cgal", cgal_mesh_2},
      {"cgal-segments", cgal_mesh_2_with_segments},
#ifdef PARDEL_GMSH
      {"gmsh", gmsh_library},
#endif
#ifdef PARDEL_TRIANGLE
      {"triangle", triangle_library},
#endif
#ifdef PARDEL_TRIANGLE_HOOK
      {"triangle-hook", triangle_library_with_hook},
#endif
  };
  return all;
}

std::unique_ptr<SubdomainMesher> mesher_named(std::string_view name) {
  for (const NamedMesher& each : meshers())
    if (each.name == name) return each.make();
  return nullptr;
}

}  // namespace pardel::bench
