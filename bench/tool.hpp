// The program `peers` compares tools. A tool is a program or library that meshes a Pslg. This file defines tools, their
// tasks and their results.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
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

/// With an area cap, refinement makes about this number times (area of the domain / area cap) triangles.
inline constexpr double triangles_per_cap = 1.37;

/// Precondition: there are values.
template <class T>
T median(std::vector<T> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The input of a run. Every child process creates the domain from its name.
struct Task {
  std::string domain = "square";  ///< a name of properties/domains/domains.hpp
  std::uint64_t points = 0;       ///< number of points, for sets of points; decades of radii, for the domain `radial`
  std::uint64_t seed = 1;
  Goal goal;                   ///< minimum angle, and a bound on areas or sizes (set_size)
  bool delaunay_only = false;  ///< only triangulate the points
  bool check = true;           ///< check every mesh
  /// About how many triangles to make: set_size() computes the bound from it, tools without such a bound use it
  /// directly. 0: the number follows from the angle bound.
  std::uint64_t triangles = 0;
};

[[nodiscard]] Pslg make_domain(const Task& task);
/// True if the domain is the convex hull of points, without segments.
[[nodiscard]] bool is_point_set(const Task& task);
/// The area of the task's domain without its holes, by the shoelace formula.
[[nodiscard]] double domain_area(const Task& task);
/// True if the wanted edge length grows with the distance from the centre of the domain.
[[nodiscard]] bool is_graded(const Task& task);
/// The wanted edge length of a graded task that makes about task.triangles triangles: `ratio` times the distance from
/// the origin, but at least `ratio` times `inner`.
struct Grading {
  double ratio = 0, inner = 0;
  [[nodiscard]] double operator()(Point p) const { return ratio * std::max(inner, std::sqrt(p.x * p.x + p.y * p.y)); }
};
[[nodiscard]] Grading grading(const Task& task);
/// Sets the bound of the goal that gives about task.triangles triangles: on areas, or on edges if the task is graded.
void set_size(Task& task);

/// The shapes of the triangles of a mesh. The shape of a triangle is 4 √3 area / (sum of the squares of its sides): 1
/// if it is equilateral, 0 if it is flat.
struct Shapes {
  double mean = 0, least = 0;
  double good = 0;  ///< the share of triangles with a shape above 0.9
};
[[nodiscard]] Shapes shapes(const Mesh& mesh);

/// The result of one run. Trivially copyable, because a child process sends it through a pipe.
struct Run {
  double seconds = 0;  ///< time of meshing, without files
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t peak_rss_bytes = 0;  ///< until the end of meshing; with the domain, without the checker
  Shapes shapes;
  std::array<char, 80> verdict{};  ///< the checker's verdict, or the reason why there is none

  void set_verdict(std::string_view text) {
    const std::size_t n = std::min(text.size(), verdict.size() - 1);
    std::memcpy(verdict.data(), text.data(), n);
    verdict[n] = '\0';
  }
};

/// Describes the mesh in the result: its numbers, its shapes, and the verdict, which is "valid" or the kinds of
/// violations with their numbers. `foreign`: another program made the mesh, which has only points and triangles.
void judge(const Task& task, const Mesh& mesh, bool foreign, Run& run);

struct Tool {
  std::string name;
  bool (*applies)(const Task&);
  /// Runs the tool in child processes. `scratch`: a folder for temporary files.
  Run (*run)(const Task&, const std::filesystem::path& scratch);
};

[[nodiscard]] Tool pardel_tool();
/// pardel with interiors of equilateral triangles, for tasks with a bound on areas.
[[nodiscard]] Tool pardel_fill_tool();
[[nodiscard]] Tool cgal_mesh_tool();  ///< CGAL's Mesh_2 with a bound on angles and one on areas (cgal_mesh_2.hpp)
[[nodiscard]] Tool
cgal_size_tool();  ///< the same with CGAL's own criteria, and edges so long that about as many triangles result
[[nodiscard]] Tool cgal_delaunay_tool();
[[nodiscard]] Tool gmsh_tool();
[[nodiscard]] Tool triangle_tool();

}  // namespace pardel::bench
