// The triangulation of a domain by definition, for tests that compare the engine or the checker with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "../../../core/pslg.hpp"
#include "../../../ref/constrained.hpp"
#include "../../../ref/faces.hpp"
#include "plain_coordinates.hpp"

namespace pardel::properties {

/// The constrained Delaunay triangulation of the domain in a larger box, without the faces of the exterior and of the
/// holes. The outline separates the domain from the corners of the box. Without segments, the Delaunay triangulation of
/// the points. Preconditions: the Pslg is valid and has plain coordinates.
[[nodiscard]] inline ref::PlainMesh triangulation_by_definition(const Pslg& pslg) {
  std::vector<ref::Edge> walls;
  for (const Segment& s : pslg.segments) walls.push_back(ref::edge(s.a, s.b));
  if (walls.empty()) return ref::constrained_delaunay(pslg.points, walls);
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  const double width = std::exp2(std::ceil(std::log2(std::max(right.x - left.x, high.y - low.y))));
  const double x = std::floor(left.x / width) * width, y = std::floor(low.y / width) * width;
  std::vector<Point> points = pslg.points;
  points.insert(
      points.end(),
      {{x - width, y - width}, {x + 3 * width, y - width}, {x + 3 * width, y + 3 * width}, {x - width, y + 3 * width}});
  ref::PlainMesh mesh = ref::constrained_delaunay(points, walls);
  ref::carve(mesh, ref::exact(points.back()), pslg.holes);
  return mesh;
}

/// The triangles, each with its corners in ascending order, for comparison. corners_of(t) are the corners of t.
template <class Triangles, class CornersOf>
[[nodiscard]] std::set<ref::Corners> sorted(const Triangles& triangles, const CornersOf& corners_of) {
  std::set<ref::Corners> result;
  for (const auto& t : triangles) {
    ref::Corners corners = corners_of(t);
    std::ranges::sort(corners);
    result.insert(corners);
  }
  return result;
}

}  // namespace pardel::properties
