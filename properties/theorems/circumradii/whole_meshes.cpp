#include "whole_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "../../../core/support/enum_names.hpp"
#include "../../../ref/faces.hpp"
#include "../../../ref/insertion.hpp"
#include "../../../ref/ruppert.hpp"
#include "../framework/scenes.hpp"

namespace pardel::properties {
namespace {
using generators::Random;
using ref::ExactPoint;
using ref::Kernel;
using ref::Number;

/// A rectangle with isolated points, in integers.
Pslg some_rectangle(Random& random) {
  const int width = random.between(2, 6), height = random.between(2, 6);
  Pslg pslg;
  pslg.points = {{0, 0}, {8.0 * width, 0}, {8.0 * width, 8.0 * height}, {0, 8.0 * height}};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  for (int k = random.between(0, 2); k > 0; --k) {
    const Point p{8.0 * random.between(1, width - 1), 8.0 * random.between(1, height - 1)};
    if (std::ranges::count(pslg.points, p) == 0) pslg.points.push_back(p);
  }
  return pslg;
}

ref::PlainMesh refined_rectangle(Random& random) {
  const Pslg pslg = some_rectangle(random);
  Goal goal;
  goal.max_area = pslg.points[2].x * pslg.points[2].y / random.between(2, 16);
  return ref::to_plain_mesh(ref::ruppert(pslg, goal).value());
}

/// The longest edge of the border, directed with the mesh on its left.
ref::Edge longest_border_edge(const ref::PlainMesh& mesh) {
  const auto squared_length = [&](const ref::Edge& e) -> Number {
    return CGAL::squared_distance(mesh.points[e[0]], mesh.points[e[1]]);
  };
  const std::vector<ref::Edge> border = border_of(mesh);
  return *std::ranges::max_element(border, {}, squared_length);
}

/// Attaches an isosceles triangle with two angles arctan(tangent) to the border edge mn. mn is one of its two shorter
/// sides. Returns its longest side, directed with the mesh on its left.
ref::Edge attach_extremal_triangle(ref::PlainMesh& mesh, const ref::Edge& mn, const Number& tangent) {
  const ExactPoint m = mesh.points[mn[0]], n = mesh.points[mn[1]];
  const Number squares = 1 + tangent * tangent;
  const Number cosine = (1 - tangent * tangent) / squares, sine = 2 * tangent / squares;  // of twice the angle
  const Kernel::Vector_2 u = n - m;
  const auto q = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(n + Kernel::Vector_2(cosine * u.x() + sine * u.y(), cosine * u.y() - sine * u.x()));
  mesh.triangles.push_back({mn[0], q, mn[1]});
  return {mn[0], q};
}

/// Attaches up to three triangles of the extremal shape of T3-sharp, each larger than the one before it.
ref::PlainMesh with_thin_corners(Random& random, ref::PlainMesh mesh) {
  const Number tangent = Number(random.chance(3) ? random.between(16, 23) : 24) / 64;  // of 20.6 degrees or less
  ref::Edge at = longest_border_edge(mesh);
  for (int k = random.between(1, 3); k > 0; --k) at = attach_extremal_triangle(mesh, at, tangent);
  return mesh;
}

/// A parallelogram of nearly equilateral triangles. All are congruent.
ref::PlainMesh nearly_equilateral(Random& random) {
  const int half = random.between(1, 200), columns = random.between(1, 4), rows = random.between(1, 4);
  const int height = static_cast<int>(std::lround(std::sqrt(3.0) * half));
  ref::PlainMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.points.emplace_back(2 * half * i + half * j, height * j);
  const auto at = [&](int i, int j) { return static_cast<Index>(j * (columns + 1) + i); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

}  // namespace

const char* name(MeshKind kind) {
  constexpr auto names = enum_names<MeshKind>({{MeshKind::delaunay, "Delaunay triangulation"},
                                               {MeshKind::refined, "refined rectangle"},
                                               {MeshKind::with_thin_corners, "with thin corners attached"},
                                               {MeshKind::equilateral, "nearly equilateral triangles"}});
  return names[kind];
}

std::ostream& operator<<(std::ostream& out, const WholeMesh& whole) {
  out << name(whole.kind) << ':';
  for (const ref::Corners& t : whole.mesh.triangles) {
    out << " [";
    for (const Index v : t) out << " (" << whole.mesh.points[v] << ')';
    out << " ]";
  }
  return out;
}

WholeMesh random_whole_mesh(Random& random, int /*size*/) {
  switch (random.below(5)) {
    case 0:
      return {MeshKind::delaunay, random_scene(random, {.insertions = 0}).mesh};
    case 1:
      return {MeshKind::refined, refined_rectangle(random)};
    case 2:
      return {MeshKind::equilateral, nearly_equilateral(random)};
    default:
      return {MeshKind::with_thin_corners, with_thin_corners(random, refined_rectangle(random))};
  }
}

}  // namespace pardel::properties
