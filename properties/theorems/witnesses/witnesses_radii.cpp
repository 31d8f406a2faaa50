// Witnesses of the theorems on circumradii: T2, T2-corner, T3-sharp.
#include <cmath>

#include "../../../ref/insertion.hpp"
#include "../framework/scenes.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {

testing::AssertionResult verdict(bool holds) {
  return holds ? testing::AssertionSuccess() : testing::AssertionFailure();
}

/// The scene has one insertion. Does it raise the largest circumradius by a factor above `least`?
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

/// The only triangle has r⁴ (4ρ² - 1) = 16 ρ⁸ A², with ρ close to sqrt 2. Hence r⁴ > 4 ρ⁶ A²: reading T3 as
/// r <= sqrt(2) ρ^(3/2) sqrt(A) is false.
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

}  // namespace

std::vector<Witness> radius_witnesses() {
  return {
      {"split_at_a_corner_raises_the_circumradius",
       "Two segments meet at just below 30 degrees and neither is encroached. The midpoint of one encroaches upon the "
       "other, and inserting it raises the largest circumradius by a factor above 1.32.",
       grows_at_a_corner},
      {"split_in_a_channel_raises_the_circumradius",
       "A channel is 16 times as long as wide, and no side is encroached. Splitting a long side at its midpoint raises "
       "the largest circumradius by a factor above 4, more than at any corner of 20 degrees.",
       grows_in_a_channel},
      {"encroaching_upon_a_wall_raises_the_circumradius",
       "A point that encroaches upon a wall of its cavity raises the largest circumradius by a factor above 3.",
       grows_at_a_wall},
      {"encroaching_upon_the_hull_raises_the_circumradius",
       "A point that encroaches upon an edge of the hull raises the largest circumradius by a factor above 3, although "
       "no edge is constrained.",
       grows_at_the_hull},
      {"isosceles_triangle_attains_the_sharp_bound",
       "This isosceles triangle has a ratio ρ close to sqrt 2. Its circumradius equals the bound of T3-sharp, which is "
       "more than sqrt(2) ρ^(3/2) sqrt(A).",
       attains_the_sharp_bound},
  };
}

}  // namespace pardel::properties
