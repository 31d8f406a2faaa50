// The mesh and the rules that all schemes share.
#include <algorithm>
#include <set>

#include "../../../ref/faces.hpp"
#include "../../../ref/insertion.hpp"
#include "../../../ref/schemes/workers/territory.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::Insertion;
using schemes::LinkedMesh;

/// The mesh after some insertions of Ruppert's algorithm.
LinkedMesh some_refined_mesh(const SchemeCase& c, const schemes::Start& start) {
  LinkedMesh mesh = start.mesh;
  const auto more = *rc::gen::inRange<std::size_t>(0, 40);
  schemes::refine_sequentially(mesh, start.bounds, c.pslg.points.size() + more);
  schemes::compact(mesh);
  return mesh;
}

std::set<ref::Corners> turned(const LinkedMesh& mesh, const std::vector<Index>& triangles) {
  std::set<ref::Corners> found;
  for (const Index t : triangles) {
    ref::Corners v = mesh.faces[t].v;
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    found.insert(v);
  }
  return found;
}

PARDEL_PROPERTY(SchemeRules, one_worker_reaches_the_goal,
                {.statement = "Ruppert's rules, applied to one triangle after the other, end with a mesh that the "
                              "checker certifies.",
                 .source = "Ruppert 1995; Miller, Pav, Walkington 2003",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  schemes::Start start = some_start(c);
  classify(schemes::refine_sequentially(start.mesh, start.bounds, 1'000'000) > 0, "something is inserted", 50);
  schemes::compact(start.mesh);
  certify(start.mesh, c, exhibit);
}

PARDEL_PROPERTY(SchemeRules, the_triangulation_is_constrained_delaunay,
                {.statement = "The triangulation with which all schemes begin is a valid mesh of the domain.",
                 .source = "properties/THEORY.md, Conventions",
                 .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  c.goal = {.min_angle_deg = 0};
  certify(some_start(c).mesh, c, exhibit);
}

PARDEL_PROPERTY(SchemeRules, cavities_are_those_of_the_definition,
                {.statement = "The cavity that a triangle's neighbours are searched for is C(p): the triangles whose "
                              "open circumdisk contains p and that p sees.",
                 .source = "[CC], cavity; ref/definitions.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Start start = some_start(c);
  const LinkedMesh mesh = some_refined_mesh(c, start);
  const ref::PlainMesh plain = ref::to_plain_mesh(schemes::to_mesh(mesh, c.pslg));
  bool large = false, beside_a_segment = false;
  for (Index t = 0; t < mesh.faces.size() && t < 8; ++t) {
    const Point centre = schemes::circumcentre(mesh, t);
    const ref::ExactPoint p = ref::exact(centre);
    // A centre on a segment belongs to both sides of it.
    if (!schemes::circumdisk_contains(mesh, t, centre) || ref::constraint_through(plain, p)) continue;
    if (!ref::sees(plain, p, mesh.faces[t].v)) continue;
    const schemes::Cavity cavity = schemes::cavity_of(mesh, centre, {t});
    RC_ASSERT(turned(mesh, cavity.triangles) == turned(mesh, ref::cavity(plain, p)));
    large = large || cavity.triangles.size() > 2;
    beside_a_segment = beside_a_segment || std::ranges::any_of(cavity.boundary, [&](schemes::Side side) {
                         const Index beyond = mesh.faces[side.triangle].n[side.i];
                         return schemes::is_constrained(mesh, side) && beyond != no_index &&
                                schemes::circumdisk_contains(mesh, beyond, centre);
                       });
  }
  classify(large, "a cavity of more than two triangles", 40);
  classify(beside_a_segment, "a segment keeps a triangle out of a cavity", 2);
}

PARDEL_PROPERTY(SchemeRules, every_insertion_keeps_the_mesh_constrained_delaunay,
                {.statement = "After any insertion, every triangle is positively oriented, neighbours name each other, "
                              "and every unconstrained side is locally Delaunay.",
                 .source = "Bowyer 1981; Watson 1981",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const schemes::Start start = some_start(c);
  SchemeCase without_goal = c;
  without_goal.goal = {.min_angle_deg = 0};
  certify(some_refined_mesh(c, start), without_goal, exhibit);
}

PARDEL_PROPERTY(SchemeRules, encroached_sides_are_seen_from_their_own_triangles,
                {.statement = "In a constrained Delaunay mesh, if a vertex encroaches upon a subsegment and sees "
                              "the triangle on its side of it, so does the corner of this triangle.",
                 .source = "Shewchuk 2002; ref/definitions.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  const LinkedMesh mesh = some_start(c).mesh;
  const ref::PlainMesh plain = ref::to_plain_mesh(schemes::to_mesh(mesh, c.pslg));
  bool found = false;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (!schemes::is_constrained(mesh, {t, i})) continue;
      const std::array<Index, 2> e = schemes::ends(mesh, {t, i});
      const ref::ExactPoint& a = plain.points[e[0]];
      const ref::ExactPoint& b = plain.points[e[1]];
      const auto encroaches = [&](const ref::ExactPoint& p) {
        return CGAL::orientation(a, b, p) == CGAL::LEFT_TURN && ref::encroaches(p, a, b) &&
               ref::sees(plain, p, mesh.faces[t].v);
      };
      const bool is_encroached = std::ranges::any_of(plain.points, encroaches);
      found = found || is_encroached;
      if (is_encroached) RC_ASSERT(schemes::encroached_side(mesh, t).has_value());
    }
  classify(found, "a subsegment is encroached", 30);
}

PARDEL_FACT(
    SchemeRules, territories_have_equal_shares,
    {.statement = "Every place has one owner, and no worker expects more than 1.5 times the mean of the work in "
                  "a square with a bound on areas.",
     .source = "Berger, Bokhari 1987",
     .families = "the unit square, 1 to 64 workers"}) {
  Pslg pslg;
  pslg.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  Goal goal;
  goal.max_area = 1e-5;
  for (int workers = 1; workers <= 64; ++workers, ++facts.cases) {
    const Result<schemes::Start> start = schemes::start_of({pslg, goal, workers});
    ASSERT_TRUE(start);
    const schemes::Territory territory(start->mesh, start->bounds, workers);
    std::vector<int> owned(static_cast<std::size_t>(workers), 0);
    constexpr int side = 100;
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        ++owned.at(static_cast<std::size_t>(territory.owner(Point{(i + 0.5) / side, (j + 0.5) / side})));
    EXPECT_LE(*std::ranges::max_element(owned), 1.5 * side * side / workers) << workers;
  }
}

}  // namespace
}  // namespace pardel::properties
