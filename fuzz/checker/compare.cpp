#include "compare.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "causes.hpp"
#include "definitions.hpp"

namespace pardel::fuzz {
namespace {

using enum ViolationKind;
using ref::Edge;

Triangles with_equal_corners(const Mesh& mesh) {
  Triangles found;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) found.insert(t);
  }
  return found;
}

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }
bool is_zero_or_normal(Point p) {
  const auto fits = [](double x) { return x == 0 || std::isnormal(x); };
  return fits(p.x) && fits(p.y);
}

/// Does the mesh refer to something that does not exist?
bool has_wrong_index(const Pslg& pslg, const Mesh& mesh) {
  const auto is_point = [&](Index v) { return v < mesh.points.size(); };
  const auto is_or_none = [](Index i, std::size_t n) { return i == no_index || i < n; };
  return !std::ranges::all_of(mesh.triangles, [&](const Triangle& t) {
    return std::ranges::all_of(t.v, is_point) &&
           std::ranges::all_of(t.n, [&](Index n) { return is_or_none(n, mesh.triangles.size()); });
  }) || !std::ranges::all_of(mesh.constrained_edges, [&](const ConstrainedEdge& e) {
    return is_point(e.a) && is_point(e.b) && is_or_none(e.segment, pslg.segments.size());
  }) || !std::ranges::all_of(mesh.region, [&](Index r) { return is_or_none(r, mesh.region_attributes.size()); });
}

/// Does an array have the wrong length?
bool has_wrong_count(const Pslg& pslg, const Mesh& mesh, bool foreign) {
  const auto fits = [](std::size_t size, std::size_t n, bool may_be_empty) {
    return size == n || (may_be_empty && size == 0);
  };
  const bool may_lack_attributes = foreign && mesh.attributes_per_point == 0;
  return !fits(mesh.origin.size(), mesh.points.size(), foreign) ||
         !fits(mesh.region.size(), mesh.triangles.size(), foreign || pslg.regions.empty()) ||
         !fits(mesh.point_markers.size(), mesh.points.size(), foreign || pslg.point_markers.empty()) ||
         (mesh.attributes_per_point != pslg.attributes_per_point && !may_lack_attributes) ||
         mesh.point_attributes.size() != mesh.points.size() * mesh.attributes_per_point;
}

bool has_neighbours(const Mesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [](const Triangle& t) {
    return std::ranges::any_of(t.n, [](Index n) { return n != no_index; });
  });
}

/// The edges at which neighbours are wrong. A violation names places.
Edges edges_with_wrong_neighbours(const Mesh& mesh, const Findings& found) {
  std::map<std::pair<double, double>, Index> vertex_at;
  for (const Triangle& t : mesh.triangles)
    for (const Index v : t.v) vertex_at[{mesh.points[v].x, mesh.points[v].y}] = v;
  return found.collect<Edge>([&](const Violation& violation, Edges& edges) {
    if (violation.kind != wrong_neighbour) return;
    const auto vertex = [&](Point p) { return vertex_at.at({p.x, p.y}); };
    edges.insert(ref::edge(vertex(violation.where[0]), vertex(violation.where[1])));
  });
}

/// The rules of which a mesh of counter-clockwise triangles breaks one if and only if it is not conformal.
constexpr auto faults_of_structure = {duplicate_triangle, non_manifold_edge, non_manifold_vertex, euler_characteristic,
                                      overlap};

void compare_shapes(const Judged& judged) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  for (const ViolationKind kind : faults_of_structure) found.require(kind, false);
  // A file may have no neighbours.
  const bool may_lack_neighbours = options.foreign && !has_neighbours(mesh.given);
  found.require(wrong_neighbour, edges_with_wrong_neighbours(mesh.given, found),
                may_lack_neighbours ? Edges{} : with_wrong_neighbours(mesh));
  found.require(large_area, found.first(large_area), larger_than(mesh, goal.max_area));
  found.require(long_edge, found.edges(long_edge), longer_than(mesh, goal.max_edge));
  // The lengths that follow from a limit on gradation have a definition and tests of their own (ref/wanted_length.hpp).
  if (std::isinf(goal.grading) && goal.feature_edges == 0)
    found.require(size_exceeded, found.first(size_exceeded), longer_than_sizes(mesh, goal.size));
  found.require(large_circumradius, found.first(large_circumradius),
                with_larger_circumradius_than(mesh, options.max_circumradius));
}

void compare_angles(const Judged& judged, const std::optional<Chains>& chains) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  Triangles excused;
  for (const Justified& j : certificate.justified) excused.insert(j.triangle);
  Triangles all = found.first(small_angle);
  all.insert(excused.begin(), excused.end());
  found.require(small_angle, all, with_small_angles(mesh, goal.min_angle_deg));
  if (!chains) return;
  const SmallAngles angles = small_angles(mesh, *chains, goal.min_angle_deg);
  found.require(small_angle, found.first(small_angle), angles.without_cause);
  for (const Justified& j : certificate.justified)
    if (const auto apexes = angles.apexes.find(j.triangle); apexes == angles.apexes.end())
      fail("triangle " + std::to_string(j.triangle) + " has no cause for a small angle, but the checker names one");
    else if (!apexes->second.contains(j.apex))
      fail("input point " + std::to_string(j.apex) +
           " is not the apex of the cause of the smallest angle of triangle " + std::to_string(j.triangle));
}

/// `constraints`: the edges on segments.
void compare_delaunay(const Judged& judged, const Edges& constraints) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  Edges free, constrained;
  for (const Edge& e : not_locally_delaunay(mesh)) (constraints.contains(e) ? constrained : free).insert(e);
  found.require(not_delaunay, found.edges(not_delaunay), free);
  if (goal.conforming) found.require(not_conforming, found.edges(not_conforming), constrained);
  // Delaunay's lemma: a triangulation of the whole domain is constrained Delaunay if all its edges are locally
  // Delaunay.
  if (found.has_any({uncovered_domain, covered_exterior, area_mismatch})) return;
  ref::PlainMesh plain = mesh.plain;
  plain.constraints = constraints;
  if (ref::is_constrained_delaunay(plain) != free.empty()) fail("Delaunay's lemma does not hold");
}

/// The constrained edges, if it is clear which they are: those of the chains, or those of the list where the checker
/// agrees with it.
std::optional<Edges> constrained_edges(const Judged& judged, const std::optional<Chains>& chains) {
  if (chains) {
    Edges edges;
    for (const auto& [e, wall] : WallsOfMesh(judged.mesh, *chains).of_edge) edges.insert(e);
    return edges;
  }
  const bool has_list = judged.has_labels && !judged.mesh.given.constrained_edges.empty();
  if (!has_list || judged.found.has_any({missing_input_vertex, broken_segment, chain_off_segment,
                                         wrong_constrained_edge, missing_constrained_edge}))
    return std::nullopt;
  return judged.mesh.plain.constraints;
}

void compare_with_definitions(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options,
                              const Certificate& certificate) {
  const Findings found(certificate);
  found.require(wrong_count, has_wrong_count(pslg, mesh, options.foreign));
  found.require(index_out_of_range, has_wrong_index(pslg, mesh));
  found.require(non_finite_coordinate, !std::ranges::all_of(mesh.points, is_finite));
  if (found.has_any({index_out_of_range, non_finite_coordinate})) return;
  // Where coordinates are subnormal, CGAL 5.5 finds intersections of triangles that have none.
  if (!std::ranges::all_of(mesh.points, is_zero_or_normal)) return;
  // With such a triangle the checker stops early: there is no geometry to check.
  if (const Triangles equal = with_equal_corners(mesh); !equal.empty())
    return found.require(degenerate_triangle, found.first(degenerate_triangle), equal);
  const ExactMesh exact(mesh);
  const Triangles flat = not_counter_clockwise(exact);
  found.require(degenerate_triangle, found.first(degenerate_triangle), flat);
  if (!flat.empty()) return;
  found.require(duplicate_triangle, found.all(duplicate_triangle), with_equal_twins(exact));
  found.require(non_manifold_edge, found.all(non_manifold_edge), at_edges_with_too_many(exact));
  if (!ref::is_conformal(exact.plain)) {
    if (!found.has_any(faults_of_structure)) fail("the checker accepts the structure of a mesh that is not conformal");
    return;
  }
  const InputFaces faces(pslg, goal.convex_hull);
  const Judged judged{exact, pslg, faces, goal, options, certificate, found, !found.has_any({wrong_count})};
  compare_shapes(judged);
  const std::optional<Chains> chains = compare_domain(judged);
  compare_angles(judged, chains);
  if (const auto constraints = constrained_edges(judged, chains)) compare_delaunay(judged, *constraints);
}

}  // namespace

Certificate judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options) {
  Certificate certificate = check(pslg, mesh, goal, options);
  if (certificate.valid != certificate.violations.empty()) fail("the verdict contradicts the list of violations");
  std::vector<std::uint64_t> listed(violation_kinds, 0);
  for (const Violation& violation : certificate.violations) ++listed[static_cast<std::size_t>(violation.kind)];
  if (listed != certificate.violation_counts) fail("the numbers of violations contradict the list");
  return certificate;
}

Certificate compare(const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options) {
  Certificate certificate = judge(pslg, mesh, goal, options);
  compare_with_definitions(pslg, mesh, goal, options, certificate);
  return certificate;
}

}  // namespace pardel::fuzz
