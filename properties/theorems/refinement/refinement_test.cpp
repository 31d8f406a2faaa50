// The guarantees of refinement for every domain and goal: it ends; its mesh is certified; a triangle may miss the angle
// bound only because of a small input angle; refining again changes nothing. `exhibit` and `facts` are parameters that
// the macros declare (framework/property.hpp).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../framework/shares.hpp"
#include "feature_size.hpp"
#include "meshing.hpp"
#include "thirty_degrees.hpp"

namespace pardel::properties {
namespace {

/// An estimate of the number of triangles: the integral over the mesh of 1 / (local feature size)², or of 1 / (area
/// bound) where that is larger.
double estimated_triangles(const Problem& problem, const Mesh& mesh) {
  const Mesh domain = value_of(triangulate(problem.pslg)).mesh;
  const std::vector<Feature> features = features_of(domain);
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t].v;
    const Point p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
    const double area = ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    const double size = local_feature_size(domain, features, {(p.x + q.x + r.x) / 3, (p.y + q.y + r.y) / 3});
    const double cap = problem.goal.region_caps && !mesh.region.empty() && mesh.region[t] != no_index
                           ? problem.pslg.regions[mesh.region[t]].max_area
                           : std::numeric_limits<double>::infinity();
    sum += area * std::max({1 / (size * size), 1 / problem.goal.max_area, 1 / cap});
  }
  return sum;
}

PARDEL_PROPERTY(
    Refinement, ends_and_the_feature_size_bounds_the_number_of_triangles,
    {.statement = "Refinement ends. If no triangle is exempt, the number of triangles is at most 16 times the "
                  "integral of max(1 / lfs^2, 1 / area bound) over the domain. lfs is the local feature "
                  "size. If triangles are exempt, it is at most 100 times the integral, which does not "
                  "account for small input angles. (The most in 10,000 cases: 11.3 and 52.4 times.)",
     .source = "Ruppert 1995, Theorem 2; the factors as measured",
     .families = "lattice domains of every family, random goals; meshes of 16 triangles or more"}) {
  const Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Meshed result = meshed(problem, exhibit, options);
  const auto triangles = static_cast<double>(result.mesh.triangles.size());
  RC_PRE(triangles >= 16);  // smaller meshes show nothing about a bound that is proportional to an integral
  const double estimate = estimated_triangles(problem, result.mesh);
  classify(triangles <= 8 * estimate, "at most 8 times the integral", 95);
  RC_ASSERT(triangles <= (result.report.exempt.empty() ? 16 : 100) * estimate);
}

PARDEL_PROPERTY(Refinement, gives_a_mesh_that_the_checker_certifies,
                {.statement = "The mesh of a valid domain conforms to it, is (constrained) Delaunay, and satisfies the "
                              "bounds on angles, areas and regions. Exception: an angle below the bound is allowed "
                              "if a small angle of the input causes it.",
                 .source = "properties/THEORY.md, refinement",
                 .families = every_family}) {
  const Problem problem = some_problem(exhibit);
  const Options options = some_options();
  const Meshed result = meshed(problem, exhibit, options);
  require_valid(check(problem.pslg, result.mesh, problem.goal));
}

PARDEL_PROPERTY(Refinement, exempts_exactly_the_triangles_that_the_checker_finds_justified,
                {.statement = "The engine reports as exempt exactly the triangles that the checker finds below the "
                              "angle bound and justified. The checker uses coordinates only.",
                 .source = "properties/THEORY.md, refinement",
                 .families = every_family}) {
  const Problem problem = some_problem(exhibit);
  const Meshed result = meshed(problem, exhibit);
  const Certificate certificate = check(problem.pslg, result.mesh, problem.goal);
  std::set<Index> reported, found;
  for (const Exemption& e : result.report.exempt) reported.insert(e.triangle);
  for (const Justified& j : certificate.justified) found.insert(j.triangle);
  classify(!found.empty(), "some triangles are exempt", 7);
  RC_ASSERT(result.report.goal_met());
  RC_ASSERT(reported == found);
}

PARDEL_PROPERTY(Refinement, refining_twice_changes_nothing,
                {.statement = "Refining the mesh again with the same goal changes nothing.",
                 .source = "properties/THEORY.md, refinement",
                 .families = every_family}) {
  Problem problem = some_problem(exhibit);
  problem.goal.region_caps = false;  // a Mesh does not store area caps
  const Options options = some_options();
  const Mesh once = meshed(problem, exhibit, options).mesh;
  const Meshed twice = value_of(refine(once, {}, problem.goal, options));
  RC_ASSERT(twice.report.inserted + twice.report.segment_splits == 0U);
  RC_ASSERT(digest(twice.mesh) == digest(once));
}

PARDEL_PROPERTY(Refinement, does_not_depend_on_threads,
                {.statement = "One, two and three threads give the same mesh with the same numbering.",
                 .source = "properties/THEORY.md, refinement",
                 .families = every_family}) {
  const Problem problem = some_problem(exhibit);
  Options options = some_options();
  const Mesh one = meshed(problem, exhibit, options).mesh;
  options.threads = *rc::gen::element(2, 3);
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == one);
}

/// Is an angle opposite to a segment 138 degrees or more? Then its corner lies in the diametral lens of the segment
/// (the points that see it at more than a given angle), even in the narrowest lens that the engine uses.
bool has_a_vertex_in_a_lens(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> segments;
  for (const ConstrainedEdge& e : mesh.constrained_edges) segments.insert(std::minmax(e.a, e.b));
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index from = t.v[(i + 1) % 3], to = t.v[(i + 2) % 3];
      if (!segments.contains(std::minmax(from, to))) continue;
      const Point p = mesh.points[t.v[i]], a = mesh.points[from], b = mesh.points[to];
      const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
      if (std::atan2(ax * by - ay * bx, ax * bx + ay * by) >= 138 * std::numbers::pi / 180) return true;
    }
    return false;
  });
}

PARDEL_PROPERTY(Refinement, without_bounds_gives_the_triangulation,
                {.statement = "A goal without bounds gives the constrained Delaunay triangulation, without any "
                              "inserted point.",
                 .source = "properties/THEORY.md, refinement without bounds",
                 .families = every_family}) {
  const Pslg pslg = to_pslg(some_case(exhibit).domain);
  const Mesh expected = value_of(triangulate(pslg)).mesh;
  classify(has_a_vertex_in_a_lens(expected), "some segment is encroached upon", 30);
  const Meshed found = value_of(mesh(pslg, {.min_angle_deg = 0, .region_caps = false}));
  RC_ASSERT(found.mesh == expected);
  RC_ASSERT(found.report.exempt.empty());
}

PARDEL_PROPERTY(Refinement, without_bounds_splits_only_segments_that_a_conforming_goal_forbids,
                {.statement = "A conforming goal without bounds gives a mesh in which every edge is locally Delaunay. "
                              "Points are inserted on segments only, and only if some segment of the constrained "
                              "Delaunay triangulation is not locally Delaunay.",
                 .source = "properties/THEORY.md, refinement without bounds",
                 .families = every_family}) {
  const Pslg pslg = to_pslg(some_case(exhibit).domain);
  const Goal goal{.min_angle_deg = 0, .region_caps = false, .conforming = true};
  const Mesh before = value_of(triangulate(pslg)).mesh;
  const bool is_delaunay = check(pslg, before, goal).valid;
  classify(!is_delaunay, "some segment is not Delaunay", 9);
  classify(is_delaunay && has_a_vertex_in_a_lens(before), "Delaunay, but some segment is encroached upon", 20);
  const Meshed found = value_of(mesh(pslg, goal));
  exhibit.show(pslg, found.mesh);
  require_valid(check(pslg, found.mesh, goal));
  RC_ASSERT(found.report.inserted == 0U && found.report.exempt.empty());
  RC_ASSERT((found.report.segment_splits == 0U) == is_delaunay);
}

PARDEL_FACT(Refinement, at_thirty_degrees_may_continue_until_edges_have_the_smallest_length,
            {.statement = "There is a domain without small angles in which refinement with a bound of 30 degrees ends "
                          "only because edges may not be shorter than a smallest length (Options::min_edge). The "
                          "report lists the triangles that miss the bound.",
             .source = "properties/THEORY.md, refinement"}) {
  const Result<Pslg> domain = read_pslg(PARDEL_WITNESSES "/halved_down_to_the_floor_at_thirty_degrees.poly");
  ASSERT_TRUE(domain);
  EXPECT_TRUE(is_halved_down_to_the_floor(*domain));
  facts.cases = 3;
}

}  // namespace
}  // namespace pardel::properties
