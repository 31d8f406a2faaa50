// Random points for the schemes that triangulate given points: many cocircular and almost cocircular ones.
#pragma once

#include <algorithm>
#include <set>

#include "../../../ref/schemes/given_points.hpp"
#include "../../../ref/schemes/mesh/triangulation.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {

inline constexpr const char* point_families =
    "points of lattices, exact or scaled by 0.1 and rounded, so that four points are cocircular, almost "
    "cocircular or neither; points of lattice domains of every family";

/// Three to sixty distinct points of a lattice, not all on one line, in a random order.
inline std::vector<Point> some_lattice_points() {
  constexpr int full_size = 100;  // all sizes are equally likely from the first case on
  const auto width = *rc::gen::resize(full_size, rc::gen::inRange(2, 12));
  const auto n = *rc::gen::resize(full_size, rc::gen::inRange<std::size_t>(3, 60));
  const auto drawn = *rc::gen::container<std::vector<std::pair<int, int>>>(
      n, rc::gen::resize(full_size, rc::gen::pair(rc::gen::inRange(0, width), rc::gen::inRange(0, width))));
  const bool exact = *rc::gen::arbitrary<bool>();
  std::set<std::pair<int, int>> seen;
  std::vector<Point> points;
  for (const auto& [x, y] : drawn)
    if (seen.insert({x, y}).second) points.push_back(exact ? Point{1.0 * x, 1.0 * y} : Point{x * 0.1, y * 0.1});
  RC_PRE(points.size() >= 3);
  Pslg pslg;
  pslg.points = points;
  RC_PRE(schemes::triangulation_of(pslg).ok());
  classify(!exact, "coordinates are rounded", 25);
  return points;
}

/// Lattice points, or the points of a lattice domain.
inline std::vector<Point> some_points(Exhibit& exhibit) {
  Pslg pslg;
  if (*rc::gen::weightedElement<bool>({{3, true}, {1, false}}))
    pslg.points = some_lattice_points();
  else
    pslg.points = some_scheme_case(exhibit).pslg.points;
  exhibit.show(pslg);
  return pslg.points;
}

/// The undirected edges of a mesh.
inline std::set<std::array<Index, 2>> edges_of(const schemes::LinkedMesh& mesh) {
  std::set<std::array<Index, 2>> edges;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = schemes::ends(mesh, {t, i});
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  return edges;
}

}  // namespace pardel::properties
