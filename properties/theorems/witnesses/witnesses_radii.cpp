// Witnesses of the theorems about circumradii (T2, T2-corner, T3-sharp) and about regions (T-region).
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../regions/point_regions.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {

testing::AssertionResult verdict(bool holds) {
  return holds ? testing::AssertionSuccess() : testing::AssertionFailure();
}

/// Does the one insertion raise the largest circumradius by a factor above `least`?
testing::AssertionResult grows(const MeshedScene& given, double least) {
  ref::PlainMesh mesh = given.mesh;
  ref::insert(mesh, ref::exact(given.scene.insertions.at(0)));
  const ref::Number growth = ref::squared_circumradius_bound(mesh) / given.squared_bound;
  return verdict(growth > least * least) << "grows by a factor of " << std::sqrt(CGAL::to_double(growth));
}

bool has_encroached_wall(const MeshedScene& given) {
  return std::ranges::any_of(given.mesh.constraints,
                             [&](const ref::Edge& e) { return ref::is_encroached(given.mesh, e); });
}

testing::AssertionResult grows_by_a_split(const Scene& scene, double least) {
  const MeshedScene given = meshed(scene);
  if (has_encroached_wall(given)) return testing::AssertionFailure() << "a wall is encroached beforehand";
  if (!ref::constraint_through(given.mesh, ref::exact(scene.insertions.at(0))))
    return testing::AssertionFailure() << "the insertion splits no wall";
  return grows(given, least);
}

testing::AssertionResult grows_at_a_corner(const Scene& scene) { return grows_by_a_split(scene, 1.32); }
testing::AssertionResult grows_in_a_channel(const Scene& scene) { return grows_by_a_split(scene, 4); }
testing::AssertionResult grows_at_a_wall(const Scene& scene) { return grows(meshed(scene), 3); }
testing::AssertionResult grows_at_the_hull(const Scene& scene) {
  return verdict(scene.walls.empty()) && grows(meshed(scene), 3) ? testing::AssertionSuccess()
                                                                 : testing::AssertionFailure();
}

/// r⁴ (4ρ² - 1) = 16 ρ⁸ A² for the only triangle, and ρ is close to sqrt 2. Hence r⁴ > 4 ρ⁶ A²: the reading
/// r <= sqrt(2) ρ^(3/2) sqrt(A) of T3 is false.
testing::AssertionResult attains_the_sharp_bound(const Scene& scene) {
  const MeshedScene given = meshed(scene);
  const ref::Corners& t = given.mesh.triangles.at(0);
  const ref::Number r = ref::squared_circumradius(given.mesh, t), area = ref::area(given.mesh, t);
  const ref::Number ratio = r / ref::squared_shortest_edge(given.mesh, t);
  const ref::Number cube = ratio * ratio * ratio;
  const bool attains = r * r * (4 * ratio - 1) == 16 * cube * ratio * area * area;
  const bool exceeds_the_reading = r * r > 4 * cube * area * area;
  return verdict(attains && exceeds_the_reading) << "ρ² = " << CGAL::to_double(ratio);
}

template <bool (*shows)(const MeshedScene&)>
testing::AssertionResult shown(const Scene& scene) {
  return verdict(shows(meshed(scene)));
}

}  // namespace

std::vector<Witness> radius_witnesses() {
  return {
      {"split_at_a_corner_raises_the_circumradius",
       "Two segments meet at just below 30 degrees and neither is encroached; the midpoint of one encroaches upon the "
       "other, and inserting it raises the largest circumradius by a factor above 1.32.",
       grows_at_a_corner},
      {"split_in_a_channel_raises_the_circumradius",
       "A channel 16 times as long as wide, no side encroached; splitting a long side at its midpoint raises the "
       "largest circumradius by a factor above 4, more than at any corner of 20 degrees.",
       grows_in_a_channel},
      {"encroaching_upon_a_wall_raises_the_circumradius",
       "A point that encroaches upon a wall of its cavity raises the largest circumradius by a factor above 3.",
       grows_at_a_wall},
      {"encroaching_upon_the_hull_raises_the_circumradius",
       "A point that encroaches upon an edge of the hull raises the largest circumradius by a factor above 3, though "
       "no edge is constrained.",
       grows_at_the_hull},
      {"isosceles_triangle_attains_the_sharp_bound",
       "This isosceles triangle, of a ratio close to sqrt 2, has exactly the circumradius that T3-sharp allows, which "
       "is more than sqrt(2) ρ^(3/2) sqrt(A).",
       attains_the_sharp_bound},
      {"regions_that_reach_a_common_triangle",
       "The cavities of the two points share a triangle; found before either is replaced, they do not give one mesh.",
       shown<fails_at_a_common_triangle>},
      {"regions_that_reach_a_common_edge",
       "The cavities of the two points share only an edge; found before either is replaced, they do not give one mesh.",
       shown<fails_at_a_common_edge>},
      {"regions_of_cocircular_points",
       "Inserted one after the other, the two points give two meshes, one for each order.",
       shown<depends_on_the_order>},
      {"regions_kept_apart_by_a_wall",
       "Whole disks on two sides of a wall reach a common triangle; in sight not even a vertex is common, and the two "
       "points give one mesh.",
       shown<is_kept_apart_by_a_wall>},
      {"regions_that_reach_a_common_vertex",
       "The cavities of the two points share a vertex but no edge, and the points give one mesh.",
       shown<holds_at_a_common_vertex>},
      {"region_that_grows_beyond_a_wall",
       "Whole disks that the two points reach share no vertex, but inserting the first makes a triangle on the wall "
       "whose disk holds the second, unseen.",
       shown<grows_beyond_a_wall>},
      {"tasks_that_own_one_box",
       "Two tasks that both own everything insert a point each; in turns they do not make what they make one after the "
       "other.",
       shown<fails_for_one_box>},
  };
}

}  // namespace pardel::properties
