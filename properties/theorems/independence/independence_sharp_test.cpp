// T1-sharp: two points whose distance is at least twice the largest circumradius are independent. This is false for
// every smaller factor.
#include <algorithm>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>

#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"
#include "../framework/on_walls.hpp"
#include "../framework/property.hpp"
#include "../framework/scene_carving.hpp"
#include "../framework/shares.hpp"
#include "pairs.hpp"
#include "widest_pairs.hpp"

namespace pardel::properties {
namespace {

constexpr const char* two_to_four =
    "pairs at 2 to 4 r̄; all layouts; hulls, hulls with walls, carved domains with holes; degenerate positions; points "
    "on walls";

MeshedScene two_apart(const SceneSpec& otherwise) {
  SceneSpec spec = in_any_domain(otherwise);
  spec.least = 2;
  spec.on_walls = spec.mostly_on_walls = true;
  return *scenes(spec);
}

bool encroaches_on_its_cavity(const MeshedScene& scene) {
  return !satisfies(scene, {.walls = true, .on_walls = true, .encroaching = false});
}

PARDEL_PROPERTY(T1Sharp, at_two_circumradii_independent_insertion_is_insertion_in_either_order,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let |pq| >= 2 r̄. "
                              "Inserting p and q independently gives a conformal constrained Delaunay mesh, and both "
                              "sequential orders give the same mesh. The cavities have no triangle in common, but may "
                              "touch. The points may encroach upon constrained edges of their cavities.",
                 .source = "properties/THEORY.md, T1-sharp",
                 .families = two_to_four}) {
  const MeshedScene scene = two_apart({.most = 4});
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  classify_on_walls(scene.mesh, points, {.two = 6});
  RC_TAG(name(contact(scene.mesh, points[0], points[1])));
  classify(separation(scene) < 2.2, "less than 2.2 circumradii apart", 5);
  classify(encroaches_on_its_cavity(scene), "encroaching upon a wall of its cavity", 9);
  RC_ASSERT(contact(scene.mesh, points[0], points[1]) != Contact::triangle);
  RC_ASSERT(ref::are_independent(scene.mesh, points[0], points[1]));
  const Outcomes made = outcomes(scene.mesh, points);
  RC_ASSERT(is_conformal_and_delaunay(made.at_once));
  RC_ASSERT(made.are_one_mesh());
}

PARDEL_PROPERTY(T1Sharp, any_number_of_points_two_circumradii_apart_may_be_inserted_independently,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let points be pairwise "
                              "at least 2 r̄ apart. Inserting all of them independently gives a conformal constrained "
                              "Delaunay mesh. Sequential insertion gives the same mesh.",
                 .source = "properties/THEORY.md, T1-sharp",
                 .families = "three to six points, each closer than 4 r̄ to an earlier one; all layouts, walls, "
                             "positions"}) {
  const MeshedScene scene = two_apart({.insertions = 3, .more = 3, .most = 4});
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  classify_on_walls(scene.mesh, insertions_of(scene.scene), {.two = 6});
  RC_TAG(std::to_string(scene.scene.insertions.size()) + " insertions");
  const Outcomes made = outcomes(scene.mesh, insertions_of(scene.scene));
  RC_ASSERT(is_conformal_and_delaunay(made.at_once));
  RC_ASSERT(made.are_one_mesh());
}

PARDEL_PROPERTY(T1Sharp, an_insertion_does_not_change_the_cavity_of_a_point_two_circumradii_away,
                {.statement = "Let r̄ bound the circumradii of a constrained Delaunay mesh, and let |pq| >= 2 r̄. "
                              "Inserting p does not change the cavity of q.",
                 .source = "properties/THEORY.md, T1-iff and T1-sharp",
                 .families = two_to_four}) {
  const MeshedScene scene = two_apart({.most = 4});
  exhibit.show(scene.scene);
  const auto points = insertions_of(scene.scene);
  classify_on_walls(scene.mesh, points, {.two = 6});
  const auto cavity_of_q = [&](const ref::PlainMesh& mesh) {
    ref::PlainMesh only{mesh.points, {}, {}};
    for (const Index t : ref::cavity(mesh, points[1])) only.triangles.push_back(mesh.triangles[t]);
    return ref::triangles_as_points(only);
  };
  ref::PlainMesh after = scene.mesh;
  ref::insert(after, points[0]);
  RC_ASSERT(cavity_of_q(after) == cavity_of_q(scene.mesh));
}

/// The largest squared circumradius in the cavity of p.
ref::Number squared_radius_of_cavity(const ref::PlainMesh& mesh, const ref::ExactPoint& p) {
  ref::PlainMesh cavity{mesh.points, {}, {}};
  for (const Index t : ref::cavity(mesh, p)) cavity.triangles.push_back(mesh.triangles[t]);
  return ref::squared_circumradius_bound(cavity);
}

PARDEL_PROPERTY(
    T1Sharp, only_the_circumradii_of_the_two_cavities_matter,
    {.statement = "Let R be the largest circumradius in the cavities of p and q in a constrained Delaunay "
                  "mesh. If |pq| >= 2 R, p and q are independent. Other circumradii of the mesh do not "
                  "matter.",
     .source = "properties/THEORY.md, T1-sharp",
     .families = "pairs below 2 r̄; all layouts; hulls, hulls with walls, carved domains with holes; degenerate "
                 "positions"}) {
  const MeshedScene scene = *scenes(in_any_domain({.most = 2, .on_walls = true, .mostly_on_walls = true}));
  exhibit.show(scene.scene);
  tag_families(scene);
  classify_outline(scene, scene.scene.insertions, 1);
  const auto points = insertions_of(scene.scene);
  const ref::Number bound =
      std::max(squared_radius_of_cavity(scene.mesh, points[0]), squared_radius_of_cavity(scene.mesh, points[1]));
  const bool far_enough = CGAL::squared_distance(points[0], points[1]) >= 4 * bound;
  const auto splits = [&](const ref::ExactPoint& p) { return split_edge_at(scene.mesh, p).is_wall; };
  classify(far_enough, "at least 2 R apart", 9);
  classify(far_enough && splits(points[0]) && splits(points[1]), "at least 2 R apart, and both split walls", 1);
  classify(far_enough && contact(scene.mesh, points[0], points[1]) == Contact::edge,
           "at least 2 R apart, with a common edge", 0.5);
  if (far_enough) RC_ASSERT(ref::are_independent(scene.mesh, points[0], points[1]));
}

/// The number of vertices that the closures of the two cavities have in common. Precondition: there are two insertions.
std::size_t common_vertices(const MeshedScene& scene) {
  const auto points = insertions_of(scene.scene);
  const std::set<Index> at_p = ref::closure(scene.mesh, ref::cavity(scene.mesh, points[0]));
  const std::set<Index> at_q = ref::closure(scene.mesh, ref::cavity(scene.mesh, points[1]));
  return static_cast<std::size_t>(std::ranges::count_if(at_p, [&](Index v) { return at_q.contains(v); }));
}

bool have_common_triangle(const MeshedScene& scene) {
  const auto points = insertions_of(scene.scene);
  const std::vector<Index> at_p = ref::cavity(scene.mesh, points[0]), at_q = ref::cavity(scene.mesh, points[1]);
  return std::ranges::any_of(at_p, [&](Index t) { return std::ranges::count(at_q, t) != 0; });
}

ref::PlainMesh inserted_at_once(const MeshedScene& scene) {
  return ref::insert_independently(scene.mesh, insertions_of(scene.scene));
}

/// A kind of pair, and a search for pairs of this kind (widest_pairs.hpp).
struct Search {
  const char* kind;
  MeshedScene (*widest)(int);
  bool (*finds)(const MeshedScene&);  ///< is the pair of this kind, by definition?
  double limit;                       ///< of the separations
  /// At scale k, the separation is less than gap / k below the limit. The searches come as near as 0.040, 0.020, 2.28
  /// and 0.40, in the order below. A pair whose distance is one unit of the lattice less lies too far below the limit.
  double gap;
};

/// Searches on finer and finer lattices. The separations that are found must grow towards the limit.
void approach(Facts& facts, const Search& search) {
  double last = 0;
  for (const int scale : {4, 16, 64, 256, 1024}) {
    SCOPED_TRACE("scale " + std::to_string(scale));
    const MeshedScene scene = search.widest(scale);
    EXPECT_TRUE(ref::is_conformal(scene.mesh) && ref::is_delaunay(scene.mesh));
    EXPECT_TRUE(search.finds(scene));
    const double found = separation(scene);
    EXPECT_GT(found, last);
    EXPECT_LT(found, search.limit);
    EXPECT_GT(found, search.limit - search.gap / scale);
    last = found;
    ++facts.cases;
  }
  std::ostringstream note;
  note << search.kind << ": found up to a separation of " << std::setprecision(7) << last << " r̄";
  facts.notes.push_back(note.str());
}

PARDEL_FACT(T1Sharp, just_below_two_circumradii_independent_insertion_may_be_non_conformal,
            {.statement = "For every s < 2 there are a Delaunay mesh and points p and q at least s r̄ apart whose "
                          "cavities share a triangle, and inserting them independently gives a mesh that is not "
                          "conformal.",
             .source = "properties/THEORY.md, T1-sharp, tightness; [CC] Figure 1a",
             .families = "a square grid, points near antipodes of the circle of one square"}) {
  const auto finds = [](const MeshedScene& scene) {
    return have_common_triangle(scene) && !ref::is_conformal(inserted_at_once(scene));
  };
  approach(facts, {"non-conformal", widest_non_conformal, finds, 2, 0.05});
}

PARDEL_FACT(T1Sharp, just_below_two_circumradii_independent_insertion_may_be_conformal_but_not_delaunay,
            {.statement = "For every s < 2 there are a Delaunay mesh and points p and q at least s r̄ apart whose "
                          "cavities share no triangle, and inserting them independently gives a mesh that is "
                          "conformal but not Delaunay.",
             .source = "properties/THEORY.md, T1-sharp, tightness; [CC] Figure 1b",
             .families = "a square grid, points near antipodes of the circle of one square"}) {
  const auto finds = [](const MeshedScene& scene) {
    const ref::PlainMesh made = inserted_at_once(scene);
    return !have_common_triangle(scene) && ref::is_conformal(made) && !ref::is_delaunay(made);
  };
  approach(facts, {"conformal but not Delaunay", widest_not_delaunay, finds, 2, 0.025});
}

PARDEL_FACT(T1Sharp, just_below_four_circumradii_two_cavities_may_share_an_edge,
            {.statement = "For every s < 4 there are a Delaunay mesh and points p and q at least s r̄ apart whose "
                          "cavities share an edge and no triangle.",
             .source = "properties/THEORY.md, T1-sharp, tightness",
             .families = "two octagons with a short common side, points near the opposite sides"}) {
  const auto finds = [](const MeshedScene& scene) {
    return !have_common_triangle(scene) && common_vertices(scene) == 2;
  };
  approach(facts, {"cavities that share an edge", widest_shared_edge, finds, 4, 2.5});
}

PARDEL_FACT(T1Sharp, just_below_four_circumradii_two_cavities_may_share_a_vertex,
            {.statement = "For every s < 4 there are a Delaunay mesh and points p and q at least s r̄ apart whose "
                          "cavities share a vertex and no edge.",
             .source = "properties/THEORY.md, T1-sharp, tightness",
             .families = "two dodecagons with a common corner, points near the opposite corners"}) {
  const auto finds = [](const MeshedScene& scene) { return common_vertices(scene) == 1; };
  approach(facts, {"cavities that share a vertex only", widest_shared_vertex, finds, 4, 0.45});
}

}  // namespace
}  // namespace pardel::properties
