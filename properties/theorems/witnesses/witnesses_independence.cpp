// Witnesses of the theorems on independence: p is the first insertion, q the second.
#include <algorithm>

#include "../../../ref/independent.hpp"
#include "../../../ref/insertion.hpp"
#include "../independence/pairs.hpp"
#include "../independence/widest_pairs.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {

/// The scale of the searches: large enough for separations within 0.5 % of the limit, small enough for a
/// readable picture.
constexpr int search_scale = 128;

/// A scene with two insertions, and the quantities that the claims use.
struct TwoInsertions {
  MeshedScene scene;
  ref::ExactPoint p, q;

  explicit TwoInsertions(const Scene& given)
      : scene(meshed(given)), p(ref::exact(given.insertions.at(0))), q(ref::exact(given.insertions.at(1))) {}

  [[nodiscard]] ref::PlainMesh at_once() const { return ref::insert_independently(scene.mesh, {p, q}); }
  [[nodiscard]] Contact meet() const { return contact(scene.mesh, p, q); }
  [[nodiscard]] bool independent() const {
    const Outcomes made = outcomes(scene.mesh, {p, q});
    return is_conformal_and_delaunay(made.at_once) && made.are_one_mesh();
  }
  /// The position of p relative to the circle through q and the edge on both boundaries.
  [[nodiscard]] CGAL::Bounded_side side_of_common_circle() const {
    const auto of_q = ref::boundary(scene.mesh, ref::cavity(scene.mesh, q));
    for (const ref::Edge& e : ref::boundary(scene.mesh, ref::cavity(scene.mesh, p)))
      if (std::ranges::count(of_q, ref::Edge{e[1], e[0]}) != 0)
        return CGAL::side_of_bounded_circle(q, scene.mesh.points[e[0]], scene.mesh.points[e[1]], p);
    return CGAL::ON_UNBOUNDED_SIDE;
  }
};

testing::AssertionResult verdict(bool holds, const TwoInsertions& two) {
  return (holds ? testing::AssertionSuccess() : testing::AssertionFailure())
         << "separation " << separation(two.scene) << " r̄, " << name(two.meet());
}

bool is_between(double low, double value, double high) { return low < value && value < high; }

testing::AssertionResult is_non_conformal_below_two(const Scene& scene) {
  const TwoInsertions q(scene);
  return verdict(is_between(1.99, separation(q.scene), 2) && !ref::is_conformal(q.at_once()), q);
}

testing::AssertionResult is_not_delaunay_below_two(const Scene& scene) {
  const TwoInsertions q(scene);
  const ref::PlainMesh made = q.at_once();
  return verdict(is_between(1.99, separation(q.scene), 2) && ref::is_conformal(made) && !ref::is_delaunay(made), q);
}

template <Contact wanted>
testing::AssertionResult meets_below_four(const Scene& scene) {
  const TwoInsertions q(scene);
  return verdict(is_between(3.99, separation(q.scene), 4) && q.meet() == wanted && q.independent(), q);
}

template <Contact wanted>
testing::AssertionResult is_independent_and_meets(const Scene& scene) {
  const TwoInsertions q(scene);
  return verdict(q.meet() == wanted && q.independent() && q.side_of_common_circle() == CGAL::ON_UNBOUNDED_SIDE, q);
}

testing::AssertionResult is_independent_on_the_circle(const Scene& scene) {
  const TwoInsertions q(scene);
  return verdict(q.meet() == Contact::edge && q.independent() && q.side_of_common_circle() == CGAL::ON_BOUNDARY, q);
}

testing::AssertionResult is_independent_inside_the_circle(const Scene& scene) {
  const TwoInsertions q(scene);
  const bool without_walls = TwoInsertions({scene.points, {}, scene.insertions}).independent();
  return verdict(q.meet() == Contact::edge && q.independent() && !without_walls &&
                     q.side_of_common_circle() == CGAL::ON_BOUNDED_SIDE,
                 q);
}

testing::AssertionResult encroaches_at_two_and_is_independent(const Scene& scene) {
  const TwoInsertions q(scene);
  const auto after_p = [&] {
    ref::PlainMesh mesh = q.scene.mesh;
    ref::insert(mesh, q.p);
    return ref::squared_circumradius_bound(mesh);
  };
  return verdict(separation(q.scene) >= 2 && !ref::encroached_by(q.scene.mesh, q.p).empty() &&
                     after_p() > q.scene.squared_bound && q.independent(),
                 q);
}

}  // namespace

std::vector<Witness> independence_witnesses() {
  return {
      {"non_conformal_just_below_two_radii",
       "p and q are more than 1.99 r̄ apart. Their cavities share a triangle, and inserting them independently gives a "
       "mesh that is not conformal.",
       is_non_conformal_below_two, [] { return widest_non_conformal(search_scale).scene; }},
      {"not_delaunay_just_below_two_radii",
       "p and q are more than 1.99 r̄ apart. Inserting them independently gives a mesh that is conformal but not "
       "Delaunay.",
       is_not_delaunay_below_two, [] { return widest_not_delaunay(search_scale).scene; }},
      {"shared_edge_just_below_four_radii",
       "p and q are more than 3.99 r̄ apart. Their cavities share an edge; p and q are still independent.",
       meets_below_four<Contact::edge>, [] { return widest_shared_edge(2 * search_scale).scene; }},
      {"shared_vertex_just_below_four_radii",
       "p and q are more than 3.99 r̄ apart. Their cavities share only a vertex; p and q are still independent.",
       meets_below_four<Contact::vertex>, [] { return widest_shared_vertex(search_scale).scene; }},
      {"independent_though_cavities_share_an_edge",
       "p and q are independent although their cavities share an edge: disjoint closures are not necessary.",
       is_independent_and_meets<Contact::edge>},
      {"independent_though_cavities_share_a_vertex",
       "p and q are independent although their cavities share a vertex: disjoint closures are not necessary.",
       is_independent_and_meets<Contact::vertex>},
      {"independent_though_cocircular_with_a_shared_edge",
       "p, q and a common edge of their cavities are cocircular, and p and q are independent: the disk is open.",
       is_independent_on_the_circle},
      {"independent_across_a_wall_though_inside_the_circle",
       "p is inside the circle through q and a wall that their cavities share, and p and q are independent. Without "
       "the "
       "wall they are not: constrained edges need no test.",
       is_independent_inside_the_circle},
      {"independent_at_two_radii_though_encroaching",
       "p encroaches upon a wall of its cavity and raises the largest circumradius. p and q are at least 2 r̄ apart and "
       "independent: T1-sharp needs no hypothesis on encroachment.",
       encroaches_at_two_and_is_independent},
  };
}

}  // namespace pardel::properties
