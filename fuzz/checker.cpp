// The checker against the definitions, on small meshes, right and damaged. The findings that follow from coordinates
// and corners alone are computed here in exact arithmetic (ref/), as sets of triangles and edges, and must be those of
// the certificate: triangles that are not counter-clockwise, edges that are not Delaunay, small angles, large areas,
// long edges. A mesh that is not conformal by definition must have a violation, and one that is must not overlap.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "../parallel/mesher.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/tolerances.hpp"
#include "../properties/defects/defects.hpp"
#include "../properties/defects/edit.hpp"
#include "../properties/domains/generators/random.hpp"
#include "../ref/faces.hpp"
#include "fuzz_one.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;
using ref::Corners;
using ref::Edge;
using ref::Number;
using ref::PlainMesh;

constexpr std::size_t most_triangles = 120;

/// A change that no list of defects foresees: a vertex is moved, an edge is flipped, a triangle is removed, doubled or
/// gets another corner.
void damage(Mesh& mesh, Random& random) {
  namespace edit = defects::edit;
  const auto any_triangle = [&] { return static_cast<Index>(random.below(mesh.triangles.size())); };
  const auto any_vertex = [&] { return static_cast<Index>(random.below(mesh.points.size())); };
  switch (random.below(5)) {
    case 0: {
      const Index v = any_vertex(), to = any_vertex();
      mesh.points[v] = edit::between(mesh.points[v], mesh.points[to], random.chance(2) ? 0.5 : 1.0);
      break;
    }
    case 1:
      edit::flip(mesh, {any_triangle(), random.between(0, 2)});
      break;
    case 2:
      if (mesh.triangles.size() > 1) edit::erase_triangles(mesh, {any_triangle()});
      break;
    case 3:
      edit::append_triangle(mesh, {any_vertex(), any_vertex(), any_vertex()}, edit::region_of(mesh, 0));
      edit::relink(mesh);
      break;
    default: {
      const Index t = any_triangle();
      mesh.triangles[t].v[random.below(3)] = any_vertex();
      edit::relink(mesh);
    }
  }
}

bool has_equal_corners(const Triangle& t) { return t.v[0] == t.v[1] || t.v[1] == t.v[2] || t.v[2] == t.v[0]; }

/// Can the mesh be read as a PlainMesh at all?
bool is_readable(const Pslg& pslg, const Mesh& mesh) {
  const auto is_finite = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  const auto in_range = [&](Index v) { return v < mesh.points.size(); };
  return std::ranges::all_of(mesh.points, is_finite) && std::ranges::all_of(pslg.points, is_finite) &&
         std::ranges::all_of(mesh.triangles, [&](const Triangle& t) { return std::ranges::all_of(t.v, in_range); }) &&
         std::ranges::all_of(mesh.constrained_edges, [&](const auto& e) { return in_range(e.a) && in_range(e.b); });
}

Number squared_length(const PlainMesh& mesh, const Edge& e) {
  return CGAL::squared_distance(mesh.points[e[0]], mesh.points[e[1]]);
}

/// Is the cosine of the angle at corner i greater than the bound, a number between 0 and 1?
bool is_sharper(const PlainMesh& mesh, const Corners& t, int i, double cosine) {
  const auto &p = mesh.points[t[i]], &q = mesh.points[t[(i + 1) % 3]], &r = mesh.points[t[(i + 2) % 3]];
  const Number dot = (q - p) * (r - p);
  return dot > 0 && dot * dot > Number(cosine) * cosine * squared_length(mesh, ref::edge(t[i], t[(i + 1) % 3])) *
                                    squared_length(mesh, ref::edge(t[i], t[(i + 2) % 3]));
}

/// What the definitions find. Triangles are given by their index, edges by their ends.
struct Found {
  std::set<Index> flat, sharp, large;
  std::set<Edge> long_edges, not_delaunay, not_conforming;
};

Found by_definition(const PlainMesh& mesh, const Goal& goal) {
  Found found;
  std::map<Edge, std::vector<Index>> triangles_at;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    if (CGAL::orientation(mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]]) != CGAL::LEFT_TURN)
      found.flat.insert(t);
    for (int i = 0; i < 3; ++i) triangles_at[ref::edge_of(c, i)].push_back(t);
  }
  if (!found.flat.empty()) return found;
  const double cosine = angle_cosine_bound(goal.min_angle_deg);
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& c = mesh.triangles[t];
    if (std::isfinite(goal.max_area) && ref::area(mesh, c) > goal.max_area) found.large.insert(t);
    for (int i = 0; i < 3; ++i) {
      if (goal.min_angle_deg > 0 && is_sharper(mesh, c, i, cosine)) found.sharp.insert(t);
      const Edge e = ref::edge_of(c, i);
      if (std::isfinite(goal.max_edge) && squared_length(mesh, e) > Number(goal.max_edge) * goal.max_edge)
        found.long_edges.insert(e);
    }
  }
  for (const auto& [e, at] : triangles_at) {
    if (at.size() != 2) continue;
    const Corners& other = mesh.triangles[at[1]];
    const Index apex = *std::ranges::find_if(other, [&ends = e](Index v) { return v != ends[0] && v != ends[1]; });
    if (!ref::circumdisk_contains(mesh, mesh.triangles[at[0]], mesh.points[apex])) continue;
    (mesh.constraints.contains(e) ? found.not_conforming : found.not_delaunay).insert(e);
  }
  return found;
}

std::set<Index> triangles_of(const Certificate& certificate, ViolationKind kind) {
  std::set<Index> ids;
  for (const Violation& violation : certificate.violations)
    if (violation.kind == kind) ids.insert(violation.ids.front());
  return ids;
}
std::set<Edge> edges_of(const Certificate& certificate, ViolationKind kind) {
  std::set<Edge> edges;
  for (const Violation& violation : certificate.violations)
    if (violation.kind == kind) edges.insert(ref::edge(violation.ids[0], violation.ids[1]));
  return edges;
}

std::string text(Index t) { return "triangle " + std::to_string(t); }
std::string text(const Edge& e) { return "edge " + std::to_string(e[0]) + " " + std::to_string(e[1]); }

template <class Item>
void require_same(const std::set<Item>& checker, const std::set<Item>& definition, ViolationKind kind) {
  for (const Item& item : checker)
    if (!definition.contains(item)) fail(std::string(name(kind)) + ": only the checker reports " + text(item));
  for (const Item& item : definition)
    if (!checker.contains(item)) fail(std::string(name(kind)) + ": the checker does not report " + text(item));
}

/// True if a kind of this list was reported.
bool has_any(const Certificate& certificate, std::initializer_list<ViolationKind> kinds) {
  return std::ranges::any_of(
      kinds, [&](ViolationKind kind) { return certificate.violation_counts[static_cast<std::size_t>(kind)] > 0; });
}

void compare(const Pslg& pslg, const Mesh& mesh, const Goal& goal) {
  using enum ViolationKind;
  const Certificate certificate = check(pslg, mesh, goal, {.max_violations = 100'000});
  if (certificate.valid != certificate.violations.empty()) fail("the verdict contradicts the list of violations");
  if (!is_readable(pslg, mesh)) {
    if (certificate.valid) fail("the checker accepts a mesh that refers to nothing");
    return;
  }
  // With such a triangle the checker stops early: there is no geometry to check.
  if (std::ranges::any_of(mesh.triangles, has_equal_corners)) {
    if (certificate.valid) fail("the checker accepts a triangle with two equal corners");
    return;
  }
  PlainMesh plain;
  for (const Point p : mesh.points) plain.points.push_back(ref::exact(p));
  for (const Triangle& t : mesh.triangles) plain.triangles.push_back(t.v);
  for (const ConstrainedEdge& e : mesh.constrained_edges) plain.constraints.insert(ref::edge(e.a, e.b));

  const Found found = by_definition(plain, goal);
  require_same(triangles_of(certificate, degenerate_triangle), found.flat, degenerate_triangle);
  const bool is_conformal = ref::is_conformal(plain);
  if (!is_conformal && certificate.valid) fail("the checker accepts a mesh that is not conformal");
  if (!is_conformal) return;
  if (has_any(certificate, {degenerate_triangle, duplicate_triangle, non_manifold_edge, overlap}))
    fail("the checker reports an overlap in a conformal mesh: " + certificate.violations.front().message());
  std::set<Index> sharp = triangles_of(certificate, small_angle);
  for (const Justified& j : certificate.justified) sharp.insert(j.triangle);
  require_same(sharp, found.sharp, small_angle);
  require_same(triangles_of(certificate, large_area), found.large, large_area);
  require_same(edges_of(certificate, long_edge), found.long_edges, long_edge);
  // Which edges are constrained is the checker's own finding. It may be compared where it agrees with the mesh's list.
  if (has_any(certificate, {index_out_of_range, wrong_count, missing_input_vertex, broken_segment, chain_off_segment,
                            wrong_constrained_edge, missing_constrained_edge}))
    return;
  require_same(edges_of(certificate, ViolationKind::not_delaunay), found.not_delaunay, ViolationKind::not_delaunay);
  if (goal.conforming)
    require_same(edges_of(certificate, ViolationKind::not_conforming), found.not_conforming,
                 ViolationKind::not_conforming);
  // Delaunay's lemma: a triangulation of the whole domain is constrained Delaunay if all its edges are locally
  // Delaunay.
  if (has_any(certificate, {uncovered_domain, covered_exterior, area_mismatch, non_manifold_vertex})) return;
  if (ref::is_constrained_delaunay(plain) != found.not_delaunay.empty()) fail("Delaunay's lemma does not hold");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  MeshCase drawn = decode_small_case(bytes);
  Random random(drawn.seed);
  if (random.chance(2)) drawn.goal = Goal{.min_angle_deg = 0};  // then nothing is inserted
  drawn.goal.size = nullptr;
  drawn.goal.grading = Goal{}.grading;
  drawn.goal.feature_edges = 0;
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  Pslg pslg = prepared.pslg;
  drawn.options.max_vertices = pslg.points.size() + 30;
  Result<Meshed> meshed = mesh(pslg, drawn.goal, drawn.options);
  if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
  Mesh& made = meshed->mesh;
  if (made.triangles.size() > most_triangles) return -1;

  Goal goal = drawn.goal;
  // A defect needs a valid mesh. This one may miss the goal, because of the limit on vertices.
  const bool is_valid = check(pslg, made, goal).valid;
  const std::size_t kind = random.below(4);
  if (kind == 1 && is_valid) {
    const auto all = defects::all();
    all[random.below(all.size())].inject(pslg, made, goal, random.next());
  } else if (kind >= 2) {
    for (std::size_t n = 1 + random.below(2); n > 0; --n) damage(made, random);
  }
  // The bounds that the mesh did not have to meet are the most interesting ones.
  if (random.chance(2)) goal.min_angle_deg = random.between(5, 33);
  if (random.chance(4)) goal.max_edge = std::ldexp(1.0, random.between(-2, 4));
  compare(pslg, made, goal);
  return 0;
}

}  // namespace pardel::fuzz
