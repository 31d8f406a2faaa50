// T1: two points whose distance is at least four times the largest circumradius are independent. T1-closures: two
// points whose cavities have disjoint closures are independent, too.
#include <algorithm>

#include "../../../ref/independent.hpp"
#include "../framework/on_walls.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "pairs.hpp"

namespace pardel::properties {
namespace {

constexpr const char* all_families =
    "all layouts of points; hulls, hulls with walls, carved domains with holes; degenerate positions; points on "
    "walls";

/// A scene in any domain. Insertions may encroach upon walls, and every second one lies on a wall, if there is one.
MeshedScene with_points_on_walls(SceneSpec spec) {
  spec = in_any_domain(spec);
  spec.on_walls = spec.mostly_on_walls = true;
  return *scenes(spec);
}

/// The same, with insertions that are pairwise at least 4 r̄ apart; in half of the scenes each is hardly farther away
/// from an earlier one.
MeshedScene four_apart(int insertions, int more) {
  SceneSpec spec{.insertions = insertions, .more = more, .least = 4};
  if (*rc::gen::arbitrary<bool>().as("hardly more than four circumradii")) spec.most = 4.5;
  return with_points_on_walls(spec);
}

/// The point of a circumdisk of the largest radius that is nearly opposite to a corner of its triangle.
ref::ExactPoint opposite_to_a_corner(const ref::PlainMesh& mesh) {
  const auto squared_radius = [&](const ref::Corners& t) { return squared_circumradius(mesh, t); };
  const ref::Corners t = *std::ranges::max_element(mesh.triangles, {}, squared_radius);
  const ref::ExactPoint centre = circumcentre(mesh, t), corner = mesh.points[t[*rc::gen::inRange(0, 3).as("corner")]];
  return centre + (centre - corner) * ref::Number(*rc::gen::inRange(900, 1000).as("thousandths")) / 1000;
}

PARDEL_PROPERTY(T1, every_vertex_of_a_cavity_is_closer_than_two_circumradii,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh. Every vertex of the cavity "
                              "of a point p is closer than 2 r̄ to p.",
                 .source = "[CC] Theorem 1, its lemma",
                 .families = all_families}) {
  const MeshedScene scene = with_points_on_walls({.insertions = 1});
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  classify_on_walls(scene.mesh, insertions_of(scene.scene), {});
  bool is_near = false;
  for (const ref::ExactPoint& p : {ref::exact(scene.scene.insertions[0]), opposite_to_a_corner(scene.mesh)}) {
    if (!lies_in(scene.mesh, p)) continue;
    const std::vector<Index> cavity = ref::cavity(scene.mesh, p);
    RC_ASSERT(!cavity.empty());
    for (const Index v : ref::closure(scene.mesh, cavity)) {
      const ref::Number squared = CGAL::squared_distance(scene.mesh.points[v], p);
      RC_ASSERT(squared < 4 * scene.squared_bound);
      is_near |= squared > ref::Number(3.61) * scene.squared_bound;
    }
  }
  classify(is_near, "a vertex of the cavity is farther than 1.9 circumradii", 25);
}

PARDEL_PROPERTY(T1, at_four_circumradii_the_closures_of_the_cavities_are_disjoint,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let |pq| >= 4 r̄. Then "
                              "the cavities of p and q have no vertex in common.",
                 .source = "[CC] Theorem 1",
                 .families = all_families}) {
  const MeshedScene scene = four_apart(2, 0);
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  classify_on_walls(scene.mesh, points, {.two = 6});
  classify(separation(scene) < 4.2, "less than 4.2 circumradii apart", 15);
  RC_ASSERT(ref::closures_are_disjoint(scene.mesh, points[0], points[1]));
  RC_ASSERT(contact(scene.mesh, points[0], points[1]) == Contact::none);
}

PARDEL_PROPERTY(T1, at_four_circumradii_independent_insertion_is_insertion_in_either_order,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let |pq| >= 4 r̄. "
                              "Inserting p and q independently gives a conformal constrained Delaunay mesh. Both "
                              "sequential orders give the same mesh.",
                 .source = "[CC] Theorem 1",
                 .families = all_families}) {
  const MeshedScene scene = four_apart(2, 0);
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  classify_on_walls(scene.mesh, insertions_of(scene.scene), {.two = 6});
  classify(separation(scene) < 4.2, "less than 4.2 circumradii apart", 15);
  const Outcomes made = outcomes(scene.mesh, insertions_of(scene.scene));
  RC_ASSERT(is_conformal_and_delaunay(made.at_once));
  RC_ASSERT(made.are_one_mesh());
}

PARDEL_PROPERTY(T1, any_number_of_points_four_circumradii_apart_may_be_inserted_independently,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let points be pairwise "
                              "at least 4 r̄ apart. Inserting all of them independently gives a conformal constrained "
                              "Delaunay mesh. Sequential insertion gives the same mesh.",
                 .source = "[CC] Theorem 1, for the sets of points that one phase inserts",
                 .families = all_families}) {
  const MeshedScene scene = four_apart(3, 3);
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  RC_TAG(std::to_string(scene.scene.insertions.size()) + " insertions");
  classify_on_walls(scene.mesh, insertions_of(scene.scene), {.two = 6});
  const Outcomes made = outcomes(scene.mesh, insertions_of(scene.scene));
  RC_ASSERT(is_conformal_and_delaunay(made.at_once));
  RC_ASSERT(made.are_one_mesh());
}

PARDEL_PROPERTY(
    EdelsbrunnerGuoy, disjoint_closures_of_the_cavities_suffice_for_independence,
    {.statement = "If the closures of the cavities of p and q in a constrained Delaunay mesh are disjoint, p and q "
                  "are independent, at any distance: inserting them independently gives a conformal constrained "
                  "Delaunay mesh, and both sequential orders give the same mesh.",
     .source = "[EG]; properties/THEORY.md, T1-closures",
     .families = "pairs at 0 to 4 r̄, with disjoint closures or not; all layouts, walls, carved domains, positions; "
                 "points on walls"}) {
  const MeshedScene scene = with_points_on_walls({.least = 0, .most = 4});
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  classify_on_walls(scene.mesh, points, {.two = 6});
  const bool disjoint = ref::closures_are_disjoint(scene.mesh, points[0], points[1]);
  classify(disjoint, "disjoint closures", 20);
  RC_ASSERT(disjoint == (contact(scene.mesh, points[0], points[1]) == Contact::none));
  if (!disjoint) return;
  const Outcomes made = outcomes(scene.mesh, points);
  RC_ASSERT(ref::are_independent(scene.mesh, points[0], points[1]));
  RC_ASSERT(is_conformal_and_delaunay(made.at_once));
  RC_ASSERT(made.are_one_mesh());
}

}  // namespace
}  // namespace pardel::properties
