// The checker against the definitions, on small meshes, right and damaged. What follows from coordinates, corners and
// labels is computed here in exact arithmetic (definitions.hpp), as sets of triangles, edges and points, and must be
// those of the certificate, for each rule. In a mesh that is not conformal by definition, the checker must find a fault
// of its structure, and in no other. Rules about the domain are compared on meshes in which every vertex lies exactly
// on a segment or far from it, so that no tolerance decides.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/defects/defects.hpp"
#include "../fuzz_one.hpp"
#include "../mesh_case.hpp"
#include "damage.hpp"
#include "definitions.hpp"

namespace pardel::fuzz {
namespace {

using enum ViolationKind;
using generators::Random;
using ref::Edge;

constexpr std::size_t most_triangles = 120;

Triangles with_equal_corners(const Mesh& mesh) {
  Triangles found;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) found.insert(t);
  }
  return found;
}

bool is_finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

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
bool has_wrong_count(const Pslg& pslg, const Mesh& mesh) {
  const auto fits = [](std::size_t size, std::size_t n, bool may_be_empty) {
    return size == n || (may_be_empty && size == 0);
  };
  return !fits(mesh.origin.size(), mesh.points.size(), false) ||
         !fits(mesh.region.size(), mesh.triangles.size(), pslg.regions.empty()) ||
         !fits(mesh.point_markers.size(), mesh.points.size(), pslg.point_markers.empty()) ||
         mesh.attributes_per_point != pslg.attributes_per_point ||
         mesh.point_attributes.size() != mesh.points.size() * mesh.attributes_per_point;
}

std::string text(Index i) { return "number " + std::to_string(i); }
std::string text(const Edge& e) { return "edge " + std::to_string(e[0]) + " " + std::to_string(e[1]); }

/// The violations in a certificate.
class Findings {
 public:
  explicit Findings(const Certificate& certificate) : certificate_(certificate) {}

  [[nodiscard]] bool has_any(std::initializer_list<ViolationKind> kinds) const {
    return std::ranges::any_of(
        kinds, [&](ViolationKind kind) { return certificate_.violation_counts[static_cast<std::size_t>(kind)] > 0; });
  }

  /// The first number in each violation.
  [[nodiscard]] std::set<Index> first(ViolationKind kind) const {
    return collect<Index>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(v.ids.front());
    });
  }
  /// All numbers in the violations.
  [[nodiscard]] std::set<Index> all(ViolationKind kind) const {
    return collect<Index>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(v.ids.begin(), v.ids.end());
    });
  }
  /// The edges between the first two numbers in each violation.
  [[nodiscard]] Edges edges(ViolationKind kind) const {
    return collect<Edge>([=](const Violation& v, auto& to) {
      if (v.kind == kind) to.insert(ref::edge(v.ids[0], v.ids[1]));
    });
  }

  /// Fails if the checker's findings of this kind are not those of the definition.
  template <class Item>
  void require(ViolationKind kind, const std::set<Item>& checker, const std::set<Item>& definition) const {
    for (const Item& item : checker)
      if (!definition.contains(item)) differ(kind, "only the checker reports " + text(item));
    for (const Item& item : definition)
      if (!checker.contains(item)) differ(kind, "the checker does not report " + text(item));
  }
  void require(ViolationKind kind, bool definition) const {
    if (has_any({kind}) && !definition) differ(kind, "only the checker reports it");
    if (!has_any({kind}) && definition) differ(kind, "the checker does not report it");
  }

  template <class Item, class Take>
  [[nodiscard]] std::set<Item> collect(const Take& take) const {
    std::set<Item> items;
    for (const Violation& violation : certificate_.violations) take(violation, items);
    return items;
  }

 private:
  [[noreturn]] void differ(ViolationKind kind, const std::string& what) const {
    std::string all;
    for (std::size_t k = 0; k < violation_kinds; ++k)
      if (const auto n = certificate_.violation_counts[k]; n > 0)
        all += " " + std::to_string(n) + " " + name(static_cast<ViolationKind>(k));
    fail(std::string(name(kind)) + ": " + what + "; it reports:" + (all.empty() ? " nothing" : all));
  }

  const Certificate& certificate_;
};

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

void compare_shapes(const ExactMesh& mesh, const Goal& goal, const CheckOptions& options, const Findings& found,
                    const Certificate& certificate) {
  for (const ViolationKind kind : faults_of_structure) found.require(kind, false);
  found.require(wrong_neighbour, edges_with_wrong_neighbours(mesh.given, found), with_wrong_neighbours(mesh));
  Triangles sharp = found.first(small_angle);
  for (const Justified& j : certificate.justified) sharp.insert(j.triangle);
  found.require(small_angle, sharp, with_small_angles(mesh, goal.min_angle_deg));
  found.require(large_area, found.first(large_area), larger_than(mesh, goal.max_area));
  found.require(long_edge, found.edges(long_edge), longer_than(mesh, goal.max_edge));
  // The lengths that follow from a limit on gradation have a definition and tests of their own (ref/wanted_length.hpp).
  if (std::isinf(goal.grading) && goal.feature_edges == 0)
    found.require(size_exceeded, found.first(size_exceeded), longer_than_sizes(mesh, goal.size));
  found.require(large_circumradius, found.first(large_circumradius),
                with_larger_circumradius_than(mesh, options.max_circumradius));
}

void compare_delaunay(const ExactMesh& mesh, const Goal& goal, const Findings& found) {
  Edges free, constrained;
  for (const Edge& e : not_locally_delaunay(mesh)) (mesh.plain.constraints.contains(e) ? constrained : free).insert(e);
  found.require(not_delaunay, found.edges(not_delaunay), free);
  if (goal.conforming) found.require(not_conforming, found.edges(not_conforming), constrained);
  // Delaunay's lemma: a triangulation of the whole domain is constrained Delaunay if all its edges are locally
  // Delaunay.
  if (found.has_any({uncovered_domain, covered_exterior, area_mismatch})) return;
  if (ref::is_constrained_delaunay(mesh.plain) != free.empty()) fail("Delaunay's lemma does not hold");
}

/// The segments without a chain. If there is a chain that was meant, the checker reports its vertices.
std::set<Index> broken_or_off(const Findings& found, const Pslg& pslg) {
  return found.collect<Index>([&](const Violation& v, std::set<Index>& segments) {
    if (v.kind == broken_segment && v.ids.size() == 1) segments.insert(v.ids[0]);
    if (v.kind == chain_off_segment && v.ids[1] < pslg.segments.size()) segments.insert(v.ids[1]);
  });
}

void compare_domain(const ExactMesh& mesh, const Pslg& pslg, const Goal& goal, bool has_labels, const Findings& found) {
  const InputFaces faces(pslg, goal.convex_hull);
  const std::set<Index> missing = missing_inputs(mesh, pslg, faces);
  found.require(missing_input_vertex, found.first(missing_input_vertex), missing);
  found.require(unused_vertex, found.first(unused_vertex), unused_points(mesh, pslg));
  if (!missing.empty() || !is_far_or_on_walls(mesh, pslg, faces)) return;

  const Walls walls = walls_of(mesh, pslg, faces);
  found.require(broken_segment, broken_or_off(found, pslg), walls.broken);
  if (found.has_any({broken_segment, chain_off_segment}) == walls.are_whole)
    fail("the checker and the definition disagree whether a side of the hull is broken");
  if (!walls.are_whole) return;
  const auto face = faces_of_triangles(mesh, faces);
  const bool covers = covers_domain(mesh, faces, face);
  if (found.has_any({uncovered_domain, covered_exterior, area_mismatch}) == covers)
    fail(covers ? "only the checker reports that the mesh does not cover the domain"
                : "the checker does not report that the mesh does not cover the domain");
  if (has_labels) {
    const ListFaults list = faults_of_list(mesh, walls);
    found.require(wrong_constrained_edge, found.first(wrong_constrained_edge), list.wrong);
    found.require(wrong_edge_marker, found.first(wrong_edge_marker), list.wrong_marker);
    found.require(missing_constrained_edge, found.edges(missing_constrained_edge), list.missing);
    found.require(wrong_origin, found.first(wrong_origin), with_wrong_origin(mesh, pslg, walls));
    found.require(wrong_vertex_marker, found.first(wrong_vertex_marker), with_wrong_marker(mesh, pslg, walls));
  }
  if (!covers) return;
  if (has_labels) found.require(wrong_region, found.first(wrong_region), with_wrong_region(mesh, pslg, faces, face));
  if (goal.region_caps) found.require(region_area, found.first(region_area), larger_than_caps(mesh, pslg, faces, face));
}

/// `valid`: a valid Pslg. The other one may be damaged.
void compare(const Pslg& valid, const Pslg& pslg, const Mesh& mesh, const Goal& goal, const CheckOptions& options) {
  const Certificate certificate = check(pslg, mesh, goal, options);
  const Findings found(certificate);
  if (certificate.valid != certificate.violations.empty()) fail("the verdict contradicts the list of violations");
  if (pslg != valid) return;  // the definitions are for valid domains
  found.require(wrong_count, has_wrong_count(pslg, mesh));
  found.require(index_out_of_range, has_wrong_index(pslg, mesh));
  found.require(non_finite_coordinate, !std::ranges::all_of(mesh.points, is_finite));
  if (found.has_any({index_out_of_range, non_finite_coordinate})) return;
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
  const bool has_labels = !found.has_any({wrong_count});
  compare_shapes(exact, goal, options, found, certificate);
  if (has_labels) found.require(wrong_attribute, found.first(wrong_attribute), with_wrong_attributes(exact, pslg));
  compare_domain(exact, pslg, goal, has_labels, found);
  // Which edges are constrained is the checker's own finding. It may be compared where it agrees with the mesh's list.
  if (has_labels && !found.has_any({missing_input_vertex, broken_segment, chain_off_segment, wrong_constrained_edge,
                                    missing_constrained_edge}))
    compare_delaunay(exact, goal, found);
}

/// Other bounds than the mesh had to meet.
void change_goal(Goal& goal, CheckOptions& options, Random& random) {
  if (random.chance(2)) goal.min_angle_deg = random.between(5, 33);
  if (random.chance(4)) goal.max_edge = std::ldexp(1.0, random.between(-2, 4));
  if (random.chance(4)) options.max_circumradius = std::ldexp(1.0, random.between(-2, 4));
  if (!random.chance(4)) return;
  const double at_zero = random.between(-1, 8), slope = random.between(-2, 2) * 0.125;
  goal.size = [=](Point p) { return at_zero + slope * p.x; };
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  MeshCase drawn = decode_small_case(bytes);
  Random random(drawn.seed);
  if (random.chance(2)) drawn.goal = Goal{.min_angle_deg = 0, .convex_hull = drawn.goal.convex_hull};
  drawn.goal.size = nullptr;
  drawn.goal.grading = Goal{}.grading;
  drawn.goal.feature_edges = 0;
  Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  Pslg& valid = prepared.pslg;
  if (random.chance(2) && valid.attributes_per_point == 0) {
    valid.attributes_per_point = 1;
    for (const Point p : valid.points) valid.point_attributes.push_back(p.x + p.y);
  }
  if (random.chance(2) && valid.point_markers.empty())
    for (std::size_t i = 0; i < valid.points.size(); ++i) valid.point_markers.push_back(random.between(0, 2));
  drawn.options.max_vertices = valid.points.size() + 30;
  Result<Meshed> meshed = mesh(valid, drawn.goal, drawn.options);
  if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
  Mesh& made = meshed->mesh;
  if (made.triangles.size() > most_triangles) return -1;

  Pslg pslg = valid;
  Goal goal = drawn.goal;
  CheckOptions options{.max_violations = 100'000};
  // A defect needs a valid mesh. This one may miss the goal, because of the limit on vertices.
  const bool is_valid = check(pslg, made, goal).valid;
  const std::size_t kind = random.below(4);
  if (kind == 1 && is_valid) {
    const auto all = defects::all();
    all[random.below(all.size())].inject(pslg, made, goal, random.next());
  } else if (kind >= 2) {
    // At most two changes: of several wrong neighbours the checker may report only some.
    for (std::size_t n = 1 + random.below(2); n > 0; --n) damage(made, random);
  }
  change_goal(goal, options, random);
  compare(valid, pslg, made, goal, options);
  return 0;
}

}  // namespace pardel::fuzz
