#include "meshers.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "../../off_the_shelf/in_processes.hpp"
#include "../../off_the_shelf/own_mesher.hpp"
#include "../../off_the_shelf/program_mesher.hpp"
#include "cgal_mesh_2.hpp"
#include "gmsh_library.hpp"
#include "triangle_library.hpp"

namespace pardel::bench {
namespace {

constexpr std::string_view program = "program ";

}  // namespace

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

std::optional<Scheme> scheme_named(std::string_view text) {
  for (const Scheme scheme : {Scheme::frozen, Scheme::cells, Scheme::decoupled})
    if (text == name(scheme)) return scheme;
  return {};
}

std::vector<std::string> names_of_meshers() {
  std::vector<std::string> names;
  for (const NamedMesher& mesher : meshers()) names.emplace_back(mesher.name);
  for (const std::string& name : named_programs()) names.push_back(std::string(program) + name);
  return names;
}

std::unique_ptr<SubdomainMesher> mesher_for(const std::string& name, int threads, const Goal& goal) {
  if (name.starts_with(program)) {
    const std::optional<MesherProgram> known = named_program(name.substr(program.size()));
    if (!known) return nullptr;
    Result<std::unique_ptr<SubdomainMesher>> made = program_mesher(*known);
    return made ? std::move(*made) : nullptr;
  }
  std::unique_ptr<SubdomainMesher> mesher = mesher_named(name);
  const bool depends_on_place = goal.size || goal.grading < INFINITY || goal.feature_edges > 0;
  const bool is_alone = threads == 1 && !depends_on_place;
  if (mesher == nullptr || mesher->abilities().is_thread_safe || is_alone) return mesher;
  Result<std::unique_ptr<SubdomainMesher>> wrapped = in_processes(std::move(mesher), threads);
  return wrapped ? std::move(*wrapped) : nullptr;
}

}  // namespace pardel::bench
