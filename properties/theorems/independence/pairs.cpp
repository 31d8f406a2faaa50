#include "pairs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "../../../core/support/enum_names.hpp"
#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"

namespace pardel::properties {
namespace {

std::set<ref::Edge> edges_of(const ref::PlainMesh& mesh, const std::vector<Index>& triangles) {
  std::set<ref::Edge> edges;
  for (const Index t : triangles)
    for (int i = 0; i < 3; ++i) edges.insert(ref::edge_of(mesh.triangles[t], i));
  return edges;
}

/// Do two sorted ranges have a common element?
template <class Range>
bool have_common_element(const Range& a, const Range& b) {
  std::vector<typename Range::value_type> common;
  std::ranges::set_intersection(a, b, std::back_inserter(common));
  return !common.empty();
}

}  // namespace

std::vector<ref::ExactPoint> insertions_of(const Scene& scene) {
  std::vector<ref::ExactPoint> points;
  for (const Point& p : scene.insertions) points.push_back(ref::exact(p));
  return points;
}

Contact contact(const ref::PlainMesh& mesh, const ref::ExactPoint& p, const ref::ExactPoint& q) {
  const std::vector<Index> of_p = ref::cavity(mesh, p), of_q = ref::cavity(mesh, q);
  if (have_common_element(of_p, of_q)) return Contact::triangle;
  if (have_common_element(edges_of(mesh, of_p), edges_of(mesh, of_q))) return Contact::edge;
  return have_common_element(ref::closure(mesh, of_p), ref::closure(mesh, of_q)) ? Contact::vertex : Contact::none;
}

std::string name(Contact contact) {
  constexpr auto names = enum_names<Contact>({{Contact::none, "cavities: apart"},
                                              {Contact::vertex, "cavities: share a vertex only"},
                                              {Contact::edge, "cavities: share an edge"},
                                              {Contact::triangle, "cavities: share a triangle"}});
  return names[contact];
}

double separation(const MeshedScene& meshed) {
  const std::vector<Point>& at = meshed.scene.insertions;
  return std::hypot(at[0].x - at[1].x, at[0].y - at[1].y) / std::sqrt(CGAL::to_double(meshed.squared_bound));
}

bool is_conformal_and_delaunay(const ref::PlainMesh& mesh) {
  return ref::is_conformal(mesh) && ref::is_constrained_delaunay(mesh);
}

bool Outcomes::are_one_mesh() const {
  const auto triangles = ref::triangles_as_points(at_once);
  return triangles == ref::triangles_as_points(in_order) && triangles == ref::triangles_as_points(in_reverse);
}

Outcomes outcomes(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points) {
  Outcomes result{ref::insert_independently(mesh, points), mesh, mesh};
  for (const ref::ExactPoint& p : points) ref::insert(result.in_order, p);
  for (auto p = points.rbegin(); p != points.rend(); ++p) ref::insert(result.in_reverse, *p);
  return result;
}

bool are_pairwise_independent(const ref::PlainMesh& mesh, const std::vector<ref::ExactPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!ref::are_independent(mesh, points[i], points[j])) return false;
  return true;
}

}  // namespace pardel::properties
