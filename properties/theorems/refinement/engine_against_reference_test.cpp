// Compares the engine with the executable specification. If only one mesh is correct, both make this mesh. If the
// result depends on the order of insertions, both meshes have the same guarantees and similar sizes.
#include <algorithm>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../ref/constrained.hpp"
#include "../../../ref/faces.hpp"
#include "../../../ref/ruppert.hpp"
#include "../framework/shares.hpp"
#include "by_definition.hpp"
#include "cocircular_neighbours.hpp"
#include "mixed_scales.hpp"
#include "wide_corners.hpp"

namespace pardel::properties {
namespace {

using generators::LatticeDomain;
using generators::Random;

/// A domain of a third of the size in other suites, because the reference takes cubic time. The lattice has the unit 1.
LatticeDomain small_domain(Exhibit& exhibit) {
  const auto make = [](Random& random, int size) {
    LatticeDomain domain = generators::any_domain(random, size / 3);
    domain.exponent = 0;
    return domain;
  };
  const auto simpler = [](const LatticeDomain& domain) { return generators::shrinks(domain); };
  const LatticeDomain domain = *generators::generator(make, simpler);
  RC_TAG(std::string(generators::name(domain.family)));
  exhibit.show(to_pslg(domain));
  return domain;
}

/// A wide rectangle with a free segment from left to right and isolated points on both sides of it. The segment crosses
/// many edges of the Delaunay triangulation of the points. Making it an edge leaves thin triangles along it, so that
/// many flips follow, and flips make further flips necessary.
Pslg crossed_domain(Random& random, int size) {
  constexpr int width = 128, height = 24;
  Pslg pslg;
  pslg.points = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  pslg.points.push_back({double(random.between(1, 4)), double(random.between(9, 15))});
  pslg.points.push_back({double(width - random.between(1, 4)), double(random.between(9, 15))});
  pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}, {4, 5, 0}};
  const Point left = pslg.points[4], right = pslg.points[5];
  for (int i = 8 + size / 8; i > 0; --i) {
    const Point p{double(random.between(5, width - 5)), double(random.between(1, height - 1))};
    const bool on_segment = (right.x - left.x) * (p.y - left.y) == (right.y - left.y) * (p.x - left.x);
    if (!on_segment && std::ranges::count(pslg.points, p) == 0) pslg.points.push_back(p);
  }
  return pslg;
}

PARDEL_PROPERTY(EngineAgainstReference, triangulations_are_the_same_where_only_one_is_delaunay,
                {.statement = "The engine and the reference make the same constrained Delaunay triangulation of a "
                              "domain. If cocircular triangles allow several, both have the same number of triangles.",
                 .source = "ref/constrained.hpp",
                 .families = "small lattice domains of every family; a segment that crosses many edges of the Delaunay "
                             "triangulation of the points"}) {
  const bool is_crossed = *rc::gen::weightedElement<bool>({{3, false}, {1, true}});
  const Pslg pslg =
      is_crossed ? *generators::generator(crossed_domain, with_fewer_points) : to_pslg(small_domain(exhibit));
  exhibit.show(pslg);
  classify(is_crossed, "a segment crosses many edges", 15);
  const Mesh found = value_of(triangulate(pslg)).mesh;
  const ref::PlainMesh expected = triangulation_by_definition(pslg);
  RC_ASSERT(found.triangles.size() == expected.triangles.size());
  const bool ambiguous = has_cocircular_neighbours(expected);
  classify(!ambiguous, "only one Delaunay triangulation", 35);
  if (ambiguous) return;
  RC_ASSERT(sorted(found.triangles, [](const Triangle& t) { return t.v; }) ==
            sorted(expected.triangles, [](const ref::Corners& t) { return t; }));
}

PARDEL_PROPERTY(EngineAgainstReference, triangulations_are_constrained_delaunay_by_definition,
                {.statement = "The engine's triangulation is conformal, and the open circumdisk of each triangle "
                              "contains no vertex that sees the triangle.",
                 .source = "[CC], the empty circumdisk property; ref/definitions.hpp",
                 .families = "small lattice domains of every family"}) {
  const Pslg pslg = to_pslg(small_domain(exhibit));
  const Mesh found = value_of(triangulate(pslg)).mesh;
  exhibit.show(pslg, found);
  RC_ASSERT(ref::is_conformal(ref::to_plain_mesh(found)));
  RC_ASSERT(ref::is_constrained_delaunay(ref::to_plain_mesh(found)));
}

PARDEL_PROPERTY(EngineAgainstReference, triangulations_of_mixed_scales_are_those_of_the_definition,
                {.statement = "Where scales are mixed, the engine's triangulation is conformal and constrained "
                              "Delaunay by definition. Where all coordinates are multiples of 2^-97 of the largest "
                              "one, it has as many triangles as the reference, and the same ones if only one "
                              "triangulation is Delaunay.",
                 .source = "ref/definitions.hpp; ref/constrained.hpp",
                 .families = mixed_families}) {
  const Pslg pslg = some_mixed_problem(exhibit, generators::all_mixtures(), 6).problem.pslg;
  const Mesh found = value_of(triangulate(pslg)).mesh;
  exhibit.show(pslg, found);
  RC_ASSERT(ref::is_conformal(ref::to_plain_mesh(found)));
  RC_ASSERT(ref::is_constrained_delaunay(ref::to_plain_mesh(found)));
  const Pslg scaled = as_large_as_plain_coordinates(pslg);
  const bool is_plain = has_plain_coordinates(scaled);
  classify(is_plain, "compared with the reference", 25);
  if (!is_plain) return;
  const ref::PlainMesh expected = triangulation_by_definition(scaled);
  RC_ASSERT(found.triangles.size() == expected.triangles.size());
  const bool ambiguous = has_cocircular_neighbours(expected);
  classify(!ambiguous, "only one Delaunay triangulation", 8);
  if (ambiguous) return;
  RC_ASSERT(sorted(found.triangles, [](const Triangle& t) { return t.v; }) ==
            sorted(expected.triangles, [](const ref::Corners& t) { return t; }));
}

PARDEL_PROPERTY(EngineAgainstReference, a_conforming_mesh_of_a_hull_without_bounds_is_delaunay_by_definition,
                {.statement = "If the domain is the convex hull of its points, a conforming goal without bounds gives "
                              "a Delaunay triangulation: the open circumdisk of each triangle contains no vertex.",
                 .source = "[CC], the empty circumdisk property; ref/definitions.hpp",
                 .families = "small lattice domains of every family, without holes"}) {
  Pslg pslg = to_pslg(small_domain(exhibit));
  pslg.holes.clear();
  const Mesh found =
      value_of(mesh(pslg, {.min_angle_deg = 0, .region_caps = false, .conforming = true, .convex_hull = true})).mesh;
  exhibit.show(pslg, found);
  classify(found.points.size() > pslg.points.size(), "some segment was split", 10);
  RC_ASSERT(ref::is_delaunay(ref::to_plain_mesh(found)));
}

/// A domain that the reference can refine, with so many points that most meshes have 24 triangles.
Pslg refinable_domain(Random& random, int size) {
  return random_wide_corners(random, {.least_radius = 12, .most_radius = 20, .points = 6 + size / 8});
}

PARDEL_PROPERTY(
    EngineAgainstReference, both_refiners_reach_the_goal_with_meshes_of_similar_size,
    {.statement =
         "If no two segments meet at less than 60 degrees and the angle bound is at most 20.7 degrees, the "
         "engine and Ruppert's algorithm both reach the goal without exempt triangles. The engine makes at "
         "most 1.4 times as many triangles as Ruppert's algorithm. Ruppert's algorithm makes at most 2.75 "
         "times as many as the engine if the goal is conforming, and else, where the engine uses lenses in "
         "place of circles, at most 4 times as many. (The most in 10,000 cases: below 1.3, 2.4 and 2.5 times.)",
     .source = "Ruppert 1995; ref/ruppert.hpp",
     .families = "polygons of four to eight sides in any direction, with holes, islands, walls that meet, free "
                 "segments and isolated points; meshes of 24 triangles or more"}) {
  const Pslg pslg = *generators::generator(refinable_domain, with_fewer_points);
  const Goal goal{.min_angle_deg = *rc::gen::element(10.0, 20.7), .conforming = *rc::gen::arbitrary<bool>()};
  exhibit.show(pslg);
  const Result<Mesh> reference = ref::ruppert(pslg, goal);
  RC_ASSERT(reference.ok());
  // Only a mistake reaches this limit, on the way to the floor.
  const Meshed engine = value_of(mesh(pslg, goal, {.max_vertices = 10 * reference->points.size()}));
  exhibit.show(pslg, engine.mesh);
  const Certificate certificate = check(pslg, engine.mesh, goal);
  require_valid(certificate);
  require_valid(check(pslg, *reference, goal));
  RC_ASSERT(certificate.justified.empty() && engine.report.exempt.empty());
  const std::size_t ours = engine.mesh.triangles.size(), theirs = reference->triangles.size();
  RC_PRE(theirs >= 24U);
  const Corners60 kind = kind_of(pslg);
  classify(kind.is_slanted, "some segment is parallel to no axis", 50);
  classify(kind.is_sharp, "a corner below 65 degrees", 10);
  classify(kind.has_hole, "a hole", 15);
  classify(kind.is_no_quadrangle, "an outline or a hole of more than four sides", 30);
  classify(theirs <= 2 * ours, "Ruppert's algorithm makes at most twice as many", 95);
  RC_ASSERT(10 * ours <= 14 * theirs);
  RC_ASSERT(4 * theirs <= (goal.conforming ? 11 : 16) * ours);
}

}  // namespace
}  // namespace pardel::properties
