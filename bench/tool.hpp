// A tool of the comparison: something that meshes a Pslg, and what a run of it yields.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "../core/goal.hpp"
#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::bench {

/// Refinement under an area cap leaves about this many triangles for every cap's worth of domain.
inline constexpr double triangles_per_cap = 1.37;

/// What is to be done. The domain is made anew in every child process, from its name.
struct Task {
  std::string domain = "square";  ///< a name of properties/domains/domains.hpp
  std::uint64_t points = 0;       ///< for `points`: how many
  std::uint64_t seed = 1;
  Goal goal;                    ///< minimum angle and area cap
  bool delaunay_only = false;   ///< triangulate the points, insert nothing
  bool check = true;            ///< have every mesh judged by the checker
  std::uint64_t triangles = 0;  ///< wanted, roughly; for tools that know no area cap. 0: as the angle bound asks
};

[[nodiscard]] Pslg make_domain(const Task& task);
/// True where the domain is random points without segments: its convex hull, nearly the unit square.
[[nodiscard]] bool is_point_set(const Task& task);
/// The area of the task's domain: shoelace over its closed chains, holes subtracted.
[[nodiscard]] double domain_area(const Task& task);
/// The area cap that leads to about as many triangles as the task wants; infinity where it names no number.
[[nodiscard]] double area_cap(const Task& task);

/// One run. Trivially copyable: it comes out of a child process through a pipe.
struct Run {
  double seconds = 0;  ///< meshing alone, no files
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t peak_rss_bytes = 0;  ///< of the whole process, domain included, checker excluded
  std::array<char, 80> verdict{};    ///< the checker's, or why there is none

  void say(std::string_view text) {
    const std::size_t n = std::min(text.size(), verdict.size() - 1);
    std::memcpy(verdict.data(), text.data(), n);
    verdict[n] = '\0';
  }
};

/// "valid", or how many violations of which kinds the checker found. `foreign`: another program's mesh, of
/// which only points and triangles are known.
[[nodiscard]] std::string verdict(const Task& task, const Mesh& mesh, bool foreign);

struct Tool {
  std::string name;
  bool (*applies)(const Task&);
  /// Takes care of its own processes; `scratch` is a folder for its files.
  Run (*run)(const Task&, const std::filesystem::path& scratch);
};

[[nodiscard]] Tool pardel_tool();
[[nodiscard]] Tool cgal_mesh_tool();  ///< Mesh_2 with the area cap itself, by criteria of ours
[[nodiscard]] Tool cgal_size_tool();  ///< Mesh_2 with its own criteria: a size that makes about as many triangles
[[nodiscard]] Tool cgal_delaunay_tool();
[[nodiscard]] Tool gmsh_tool();
[[nodiscard]] Tool triangle_tool();

}  // namespace pardel::bench
